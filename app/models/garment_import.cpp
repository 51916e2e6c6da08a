#include "app/models/garment_import.hpp"

#include <minizip/unzip.h>

#include <fstream>
#include <pugixml.hpp>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "sim/mesh/polygons.hpp"

namespace taut::app {
namespace {

void count_faces(const ModelArrays& arrays, ImportedModel& model) {
  for (const std::uint32_t corners : arrays.corner_counts) {
    ++(corners == 3 ? model.file_triangles : corners == 4 ? model.file_quads : model.file_polygons);
  }
}

bool is_counting_up(const std::vector<sim::Index>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] != i) return false;
  }
  return true;
}

void require_size(const ModelArrays& arrays) {
  if (arrays.corner_counts.empty()) throw std::invalid_argument("it has no faces");
  const std::size_t triangles = arrays.corners.size() - 2 * arrays.corner_counts.size();
  if (triangles > most_triangles) {
    throw std::invalid_argument(
        fmt::format("it has {} triangles, more than the {} that can be simulated", triangles, most_triangles));
  }
}

/// The faces with the file's numbers of vertices.
FileFaces faces_in_file(ModelArrays& arrays) {
  if (!arrays.position_of_vertex.empty()) {
    std::vector<sim::Index> number(arrays.positions.size(), 0);
    for (auto v = static_cast<sim::Index>(arrays.position_of_vertex.size()); v-- > 0;) {
      number[arrays.position_of_vertex[v]] = v;
    }
    for (sim::Index& corner : arrays.corners) corner = number[corner];
  }
  return {
      std::move(arrays.corner_counts), std::move(arrays.corners), {}, std::move(arrays.sections), arrays.has_normals};
}

/// Other readable formats: for those who chose another kind of file. To others it would say nothing.
std::string expectation(const std::string& reason) {
  const bool is_no_model =
      reason.find("no reader knows") != std::string::npos || reason.find("has no faces") != std::string::npos;
  return is_no_model ? "; expected a 3D model with faces, such as OBJ, PLY, STL, glTF, FBX or Collada" : "";
}

// The first bytes of a file: a format shows at its beginning, and a glTF's text is seldom longer.
constexpr std::size_t head_of_model_bytes = std::size_t{1} << 22;

std::string head_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(head_of_model_bytes, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// The texts that stand behind "key": in JSON, in their order. Enough to tell what a glTF file needs, and it
/// takes one that is damaged.
std::vector<std::string> texts_behind(std::string_view json, std::string_view key) {
  std::vector<std::string> texts;
  const std::string quoted = '"' + std::string(key) + '"';
  for (std::size_t at = json.find(quoted); at != std::string_view::npos; at = json.find(quoted, at + 1)) {
    const std::size_t colon = json.find_first_not_of(" \t\r\n", at + quoted.size());
    if (colon == std::string_view::npos || json[colon] != ':') continue;
    const std::size_t begin = json.find_first_not_of(" \t\r\n", colon + 1);
    if (begin != std::string_view::npos && json[begin] == '"') {
      texts.emplace_back(json.substr(begin + 1, json.find('"', begin + 1) - begin - 1));
    }
  }
  return texts;
}

std::string why_not_gltf(const std::filesystem::path& path, const std::string& head) {
  const bool is_binary = head.starts_with("glTF") && head.size() > 4;
  const std::vector<std::string> versions = texts_behind(head, "version");
  const bool is_first =
      is_binary ? head[4] == 1
                : std::ranges::any_of(versions, [](const std::string& version) { return version.starts_with("1."); });
  if (is_first) return "it is glTF 1.0, which is not read; save it as glTF 2.0";
  if (contains(head, "KHR_draco_mesh_compression")) {
    return "its meshes are compressed with Draco in a way that is not read; save it without compression";
  }
  for (const std::string& uri : texts_behind(head, "uri")) {
    std::error_code error;
    if (uri.ends_with(".bin") && !std::filesystem::exists(path.parent_path() / uri, error)) {
      return fmt::format("it needs the file '{}' beside it, which is not there", uri);
    }
  }
  return "";
}

// Bytes that are searched for the start tag. It lies within them even behind a long comment.
constexpr std::size_t head_bytes = std::size_t{1} << 16;

struct CloseArchive {
  void operator()(void* archive) const { ::unzClose(archive); }
};

/// Goes to the part that holds the model; files name it so though they need not.
bool find_model_part(unzFile archive) {
  constexpr int any_case = 2;
  if (::unzLocateFile(archive, "3D/3dmodel.model", any_case) == UNZ_OK) return true;
  std::array<char, 1024> name{};
  for (int result = ::unzGoToFirstFile(archive); result == UNZ_OK; result = ::unzGoToNextFile(archive)) {
    if (::unzGetCurrentFileInfo64(archive, nullptr, name.data(), name.size() - 1, nullptr, 0, nullptr, 0) == UNZ_OK &&
        std::string_view(name.data()).ends_with(".model")) {
      return true;
    }
  }
  return false;
}

/// Returns the beginning of the XML in which a 3MF file describes its model. Empty if it holds none.
std::string head_of_3mf(const std::filesystem::path& path) {
  const std::unique_ptr<void, CloseArchive> archive(::unzOpen64(path.c_str()));
  if (!archive || !find_model_part(archive.get()) || ::unzOpenCurrentFile(archive.get()) != UNZ_OK) return "";
  std::string head(head_bytes, '\0');
  std::size_t count = 0;
  while (count < head.size()) {
    const int read =
        ::unzReadCurrentFile(archive.get(), head.data() + count, static_cast<unsigned>(head.size() - count));
    if (read <= 0) break;
    count += static_cast<std::size_t>(read);
  }
  return head.substr(0, count);
}

std::string why_not_3mf(const std::filesystem::path& path) {
  const std::string model = head_of_3mf(path);
  return contains(model, "p:path=") || contains(model, "requiredextensions=\"p\"")
             ? "its objects lie in files of their own within it (3MF production extension), which are not "
               "read; save it as plain 3MF, STL or OBJ"
             : "";
}

struct NamedUnit {
  std::string_view name;
  double metres;
};
constexpr std::array named_units = {NamedUnit{"micron", 1e-6},     NamedUnit{"millimeter", 0.001},
                                    NamedUnit{"centimeter", 0.01}, NamedUnit{"inch", 0.0254},
                                    NamedUnit{"foot", 0.3048},     NamedUnit{"meter", 1.0}};

}  // namespace

ImportedModel model_of(ModelArrays arrays) {
  ImportedModel model;
  count_faces(arrays, model);
  model.triangles = sim::cut_into_triangles({arrays.positions, arrays.corner_counts, arrays.corners});
  std::vector<glm::vec2> corner_uv = arrays.colours.corner_uv;
  model.colours = cut_colours(std::move(arrays.colours), arrays.corner_counts, arrays.corners, model.triangles);
  model.shares_vertices = arrays.corner_counts.size() == 1 || !is_counting_up(arrays.corners);
  model.faces = faces_in_file(arrays);
  model.faces.corner_uv = std::move(corner_uv);
  model.positions = std::move(arrays.positions);
  model.position_of_vertex = std::move(arrays.position_of_vertex);
  model.format = std::move(arrays.format);
  model.meshes = arrays.meshes;
  model.ignored_lines = arrays.ignored_lines;
  model.ignored_points = arrays.ignored_points;
  model.metres_per_unit = arrays.metres_per_unit;
  model.up = arrays.up;
  model.rig = std::move(arrays.rig);
  return model;
}

ImportedModel model_of(std::vector<sim::Vec3> positions_m, std::vector<std::uint32_t> corner_counts,
                       std::vector<sim::Index> corners) {
  ModelArrays arrays;
  arrays.positions = std::move(positions_m);
  arrays.corner_counts = std::move(corner_counts);
  arrays.corners = std::move(corners);
  arrays.metres_per_unit = 1.0;
  arrays.up = ModelAxis::y;
  number_by_first_use(arrays);
  return model_of(std::move(arrays));
}

ImportedModel import_garment(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts) {
  require_file(path);
  try {
    ModelArrays arrays = read_model_in_process(path, limits, parts);
    require_size(arrays);
    return model_of(std::move(arrays));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    const std::string cause = why_unreadable(path);
    throw InputError("cannot read a model from '" + path.string() +
                     "': " + (cause.empty() ? error.what() + expectation(error.what()) : cause));
  }
}

std::string why_unreadable(const std::filesystem::path& path) {
  const std::string head = head_of(path);
  const std::string extension = lower_case(path.extension().string());
  constexpr std::array usd = {".usd", ".usda", ".usdc", ".usdz"};
  if (std::ranges::find(usd, extension) != usd.end() || head.starts_with("#usda") || head.starts_with("PXR-USDC")) {
    return "it is USD, which is not read; save it as glTF, FBX or OBJ";
  }
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) {
    return "it is text in UTF-16; save it as UTF-8";
  }
  if (extension == ".gltf" || extension == ".glb") return why_not_gltf(path, head);
  return extension == ".3mf" ? why_not_3mf(path) : "";
}

std::optional<double> unit_of_model_part(std::string_view xml) {
  pugi::xml_document document;
  // A file that is cut off at its end is an error, and read up to there all the same.
  document.load_buffer(xml.data(), xml.size());
  const pugi::xml_node root = document.document_element();
  const std::string_view element = root.name();
  if (element != "model" && !element.ends_with(":model")) return std::nullopt;
  const std::string_view unit = root.attribute("unit").as_string("millimeter");
  for (const NamedUnit& named : named_units) {
    if (named.name == unit) return named.metres;
  }
  return std::nullopt;
}

std::optional<double> unit_of_3mf(const std::filesystem::path& path) { return unit_of_model_part(head_of_3mf(path)); }

}  // namespace taut::app
