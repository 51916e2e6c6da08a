#include <assimp/DefaultIOSystem.h>
#include <assimp/GltfMaterial.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cctype>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/models/reading/garment_import.hpp"

namespace taut::app {
namespace {

void append_face(const aiFace& face, const aiMesh& mesh, bool mirrored, ModelArrays& model) {
  model.ignored_points += face.mNumIndices == 1;
  model.ignored_lines += face.mNumIndices == 2;
  if (face.mNumIndices < 3) return;
  model.faces.corner_counts.push_back(face.mNumIndices);
  model.colours.material_of_face.push_back(mesh.mMaterialIndex);
  const auto first = static_cast<sim::Index>(model.positions.size()) - mesh.mNumVertices;
  for (unsigned k = 0; k < face.mNumIndices; ++k) {
    // A mirrored node would turn the garment inside out.
    const unsigned v = face.mIndices[mirrored && k > 0 ? face.mNumIndices - k : k];
    model.faces.corners.push_back(first + v);
    model.colours.corner_uv.push_back(mesh.HasTextureCoords(0)
                                          ? glm::vec2(mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y)
                                          : glm::vec2(0.0F));
  }
}

/// Begins a section of faces with the line that an OBJ would have.
void begin_section(const char* kind, std::string name, ModelArrays& model) {
  std::erase_if(name, [](char letter) { return std::iscntrl(static_cast<unsigned char>(letter)) != 0; });
  if (!name.empty()) {
    model.faces.sections.push_back({static_cast<std::uint32_t>(model.faces.corner_counts.size()), kind + name});
  }
}

void append_mesh(const aiMesh& mesh, const aiMatrix4x4& to_world, ModelArrays& model) {
  if (mesh.mNumVertices > 0 && mesh.mVertices == nullptr) {
    throw InputError("one of its meshes has no positions");
  }
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D p = to_world * mesh.mVertices[v];
    model.positions.emplace_back(p.x, p.y, p.z);
  }
  const bool mirrored = to_world.Determinant() < 0.0F;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= mesh.mNumVertices) {
        throw InputError("a face uses vertex " + std::to_string(face.mIndices[k]) + " of a mesh that has " +
                         std::to_string(mesh.mNumVertices));
      }
    }
    append_face(face, mesh, mirrored, model);
  }
}

void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, ModelArrays& model) {
  const aiMatrix4x4 to_world = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    begin_section("o ", mesh.mName.C_Str(), model);
    if (mesh.mMaterialIndex < scene.mNumMaterials) {
      begin_section("usemtl ", scene.mMaterials[mesh.mMaterialIndex]->GetName().C_Str(), model);
    }
    model.faces.has_normals = model.faces.has_normals || mesh.HasNormals();
    append_mesh(mesh, to_world, model);
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) append_node(scene, *node.mChildren[c], to_world, model);
}

std::string format_name(const Assimp::Importer& importer) {
  const int index = importer.GetPropertyInteger("importerIndex", -1);
  const aiImporterDesc* description = index < 0 ? nullptr : importer.GetImporterInfo(static_cast<std::size_t>(index));
  return description != nullptr ? description->mName : "unknown";
}

// FBX counts in centimetres times this factor and names its axes by number.
void read_fbx_settings(const aiMetadata& settings, ModelArrays& model) {
  double factor = 0.0;
  float single = 0.0F;
  if (settings.Get("UnitScaleFactor", factor) && factor > 0.0) {
    model.metres_per_unit = 0.01 * factor;
  } else if (settings.Get("UnitScaleFactor", single) && single > 0.0F) {
    model.metres_per_unit = 0.01 * static_cast<double>(single);
  }
  std::int32_t axis = -1, sign = 1;
  if (settings.Get("UpAxis", axis) && axis >= 0 && axis <= 2) {
    settings.Get("UpAxisSign", sign);
    model.up = static_cast<ModelAxis>(2 * axis + (sign < 0 ? 1 : 0));
  }
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

void read_units(const aiScene& scene, ModelArrays& model) {
  if (contains(model.format, "FBX") && scene.mMetaData != nullptr) {
    read_fbx_settings(*scene.mMetaData, model);
  } else if (contains(model.format, "glTF") || contains(model.format, "Collada")) {
    // glTF is in metres with y up by its specification. Assimp applies the unit and axes of Collada files.
    model.metres_per_unit = 1.0;
    model.up = ModelAxis::y;
  } else if (contains(model.format, "3mf") || contains(model.format, "3MF")) {
    model.up = ModelAxis::z;
  }
}

/// Returns the library's reason without the file's name, which the whole message has.
std::string shorten_reason(std::string reason, const std::string& file) {
  if (contains(reason, "No suitable reader found")) return "no reader knows this kind of file";
  for (const std::string& name : {" \"" + file + '"', ' ' + file, file}) {
    for (std::size_t at = reason.find(name); at != std::string::npos; at = reason.find(name)) {
      reason.erase(at, name.size());
    }
  }
  return reason;
}

/// Returns the bytes of an image within the scene. Assimp keeps compressed images as one row of bytes.
std::optional<std::string_view> embedded_image(const aiScene& scene, const std::string& name) {
  const aiTexture* texture = scene.GetEmbeddedTexture(name.c_str());
  if (texture == nullptr || texture->mHeight != 0) return std::nullopt;
  return std::string_view(reinterpret_cast<const char*>(texture->pcData), texture->mWidth);
}

/// Returns the file name behind a map's options. An option is a word that begins with a minus, then numbers, switches
/// and channels.
std::string map_name(std::istringstream& line) {
  std::string name, word;
  bool is_option = false;
  while (line >> word) {
    const bool is_value = word.find_first_not_of("+-.0123456789eE") == std::string::npos || word == "on" ||
                          word == "off" || word.size() == 1;
    if (name.empty() && (word.starts_with('-') || (is_option && is_value))) {
      is_option = true;
      continue;
    }
    name += (name.empty() ? "" : " ") + word;
  }
  return name;
}

/// Converts a material. Colours of glTF are linear, and multiply their images. Colours of other formats are taken as
/// programs show them, and images replace them.
SurfaceMaterial to_surface_material(const aiMaterial& from, bool is_gltf) {
  SurfaceMaterial material{.name = from.GetName().C_Str()};
  aiColor4D colour(1.0F, 1.0F, 1.0F, 1.0F);
  if (from.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) from.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  material.base_colour = glm::clamp(glm::vec3(colour.r, colour.g, colour.b), 0.0F, 1.0F);
  if (is_gltf) {
    for (int k = 0; k < 3; ++k) material.base_colour[k] = linear_to_srgb(material.base_colour[k]);
    material.map_tint = material.base_colour;
    aiString mode;
    material.map_is_opaque = from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS || mode == aiString("OPAQUE");
  }
  for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
    aiString file;
    if (from.GetTexture(type, 0, &file) == aiReturn_SUCCESS) material.map_file = file.C_Str();
  }
  return material;
}

void read_colours(const aiScene& scene, const std::filesystem::path& folder, ModelArrays& model) {
  SurfaceColours& colours = model.colours;
  if (std::none_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                   [](const aiMesh* mesh) { return mesh->HasTextureCoords(0); })) {
    colours.corner_uv.clear();
  }
  for (const aiMaterial* material : std::span(scene.mMaterials, scene.mNumMaterials)) {
    colours.materials.push_back(to_surface_material(*material, contains(model.format, "glTF")));
  }
  const auto is_unknown = [&](sim::Index material) { return material >= colours.materials.size(); };
  if (std::ranges::any_of(colours.material_of_face, is_unknown)) colours.material_of_face.clear();
  read_maps(
      folder, [&](const std::string& name) { return embedded_image(scene, name); }, colours);
}

void read_colours_of_obj(const std::filesystem::path& folder, SurfaceColours& colours) {
  for (const std::string& library : colours.libraries) {
    try {
      read_mtl(read_text_file(folder / library), colours);
      colours.files.push_back((folder / library).string());
    } catch (const InputError& error) {
      colours.remarks.push_back("its materials are not read: " + std::string(error.what()));
    }
  }
  read_maps(
      folder, [](const std::string&) { return std::nullopt; }, colours);
}

void require_announced(std::size_t found, std::size_t announced, const char* what) {
  if (found < announced) {
    throw InputError("found {} of the {} {} that its header announces; it may be cut off", found, announced, what);
  }
}

/// Returns the number of faces, the second number of the first line of numbers.
std::size_t announced_faces(std::istream& off) {
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(off, line);) {
    if (std::istringstream(line) >> vertices >> faces) return faces;
  }
  return 0;
}

/// Requires a whole header, and a line behind it for every element of a PLY in ASCII. Assimp reads on for ever without
/// one.
void require_whole_ply(std::istream& ply) {
  std::size_t announced = 0, lines = 0;
  std::string line, word, element, format;
  while (std::getline(ply, line) && !line.starts_with("end_header")) {
    std::size_t count = 0;
    if (std::istringstream(line) >> word >> element >> count && word == "element") announced += count;
    if (word == "format") format = element;
  }
  if (!ply) throw InputError("found no line 'end_header' of a PLY; it may be cut off");
  if (format != "ascii") return;
  while (std::getline(ply, line)) lines += line.find_first_not_of(" \t\r") != std::string::npos ? 1 : 0;
  require_announced(lines, announced, "elements");
}

/// Throws InputError if a text file ends before the end that its header announces. Assimp accepts such files.
void require_whole(const std::filesystem::path& path, std::string_view format, std::size_t faces) {
  const bool is_off = format.starts_with("OFF");
  if (!is_off && !format.starts_with("Stereo")) return;
  const std::string bytes = read_text_file(path, max_model_bytes);
  std::istringstream text(bytes);
  if (is_off) require_announced(faces, announced_faces(text), "faces");
  const bool is_stl_of_text = bytes.starts_with("solid") && bytes.find('\0') == std::string::npos;
  if (is_stl_of_text && bytes.find("endsolid") == std::string::npos) {
    throw InputError("found no line 'endsolid', which ends it; it may be cut off");
  }
}

/// Files of this machine, with a record of the names of opened files.
class NotedFiles final : public Assimp::DefaultIOSystem {
 public:
  explicit NotedFiles(std::vector<std::string>& names) : names_(names) {}

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    names_.emplace_back(file);
    return DefaultIOSystem::Open(file, mode);
  }

 private:
  std::vector<std::string>& names_;
};

ModelArrays read_with_assimp(const std::filesystem::path& path, ReadParts parts) {
  if (lower_case(path.extension().string()) == ".ply") {
    std::istringstream ply(read_text_file(path, max_model_bytes));
    require_whole_ply(ply);
  }
  // The importer is never destroyed: it reads some files (3MF with textures) completely and crashes when it is
  // destroyed.
  Assimp::Importer& importer = *new Assimp::Importer;
  std::vector<std::string>& opened = *new std::vector<std::string>;
  importer.SetIOHandler(new NotedFiles(opened));
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (scene == nullptr) throw InputError(shorten_reason(importer.GetErrorString(), path.string()));
  if (scene->mRootNode == nullptr) throw InputError("it has no scene");
  ModelArrays model;
  model.files = opened;
  model.format = format_name(importer);
  model.meshes = scene->mNumMeshes;
  read_units(*scene, model);
  append_node(*scene, *scene->mRootNode, aiMatrix4x4(), model);
  require_whole(path, model.format, model.faces.corner_counts.size());
  model.rig = read_rig(*scene, lower_case(path.extension().string()) != ".fbx");
  if (parts == ReadParts::model) read_colours(*scene, path.parent_path(), model);
  return model;
}

}  // namespace

ModelArrays read_model(const std::filesystem::path& path, ReadParts parts) {
  if (parts == ReadParts::image) {
    ModelArrays image;
    image.colours.maps.push_back(fitted_to(decode_image(read_text_file(path, max_model_bytes)), max_print_side_px));
    return image;
  }
  std::optional<ModelArrays> model;
  if (lower_case(path.extension().string()) == ".obj") {
    model = read_obj(read_text_file(path, max_model_bytes));
    if (model && parts == ReadParts::model) read_colours_of_obj(path.parent_path(), model->colours);
  }
  if (!model) model = read_with_assimp(path, parts);
  for (std::size_t v = 0; v < model->positions.size(); ++v) {
    const sim::Vec3& p = model->positions[v];
    if (!std::isfinite(p.x + p.y + p.z)) {
      throw InputError("vertex {} has a coordinate that is not finite: found [{:g}, {:g}, {:g}], expected numbers", v,
                       p.x, p.y, p.z);
    }
  }
  model->files.insert(model->files.end(), model->colours.files.begin(), model->colours.files.end());
  if (parts == ReadParts::shape) model->colours = {};
  return std::move(*model);
}

void read_mtl(std::string_view text, SurfaceColours& colours) {
  std::istringstream lines{std::string(text)};
  auto material = colours.materials.end();
  for (std::string whole; std::getline(lines, whole);) {
    std::istringstream line(whole);
    std::string kind;
    line >> kind;
    if (kind == "newmtl") {
      std::string name;
      std::getline(line >> std::ws, name);
      name.erase(name.find_last_not_of(" \t\r") + 1);
      material = std::ranges::find(colours.materials, name, &SurfaceMaterial::name);
    } else if (kind == "Kd" && material != colours.materials.end()) {
      glm::vec3 colour(1.0F);
      if (line >> colour.x >> colour.y >> colour.z) material->base_colour = glm::clamp(colour, 0.0F, 1.0F);
    } else if (kind == "map_Kd" && material != colours.materials.end()) {
      material->map_file = map_name(line);
    }
  }
}

}  // namespace taut::app
