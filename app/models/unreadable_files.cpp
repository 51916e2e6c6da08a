#include <minizip/unzip.h>

#include <fstream>
#include <pugixml.hpp>

#include "app/base/words.hpp"
#include "app/models/garment_import.hpp"

namespace taut::app {
namespace {

// The first bytes of a file: a format shows at its beginning, and a glTF's text is seldom longer.
constexpr std::size_t head_of_model_bytes = std::size_t{1} << 22;

std::string head_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(head_of_model_bytes, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool has_text(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

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
  if (has_text(head, "KHR_draco_mesh_compression")) {
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
  return has_text(model, "p:path=") || has_text(model, "requiredextensions=\"p\"")
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
