#include "app/models/model_reading.hpp"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cctype>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/models/obj_reading.hpp"
#include "app/models/rig_reading.hpp"
#include "app/models/unit_of_3mf.hpp"

namespace taut::app {
namespace {

void append_face(const aiFace& face, sim::Index first, bool mirrored, ModelArrays& model) {
  switch (face.mNumIndices) {
    case 0:
      return;
    case 1:
      ++model.ignored_points;
      return;
    case 2:
      ++model.ignored_lines;
      return;
    default:
      break;
  }
  model.corner_counts.push_back(face.mNumIndices);
  model.corners.push_back(first + face.mIndices[0]);
  for (unsigned k = 1; k < face.mNumIndices; ++k) {
    // A mirrored node would turn the garment inside out.
    model.corners.push_back(first + face.mIndices[mirrored ? face.mNumIndices - k : k]);
  }
}

void append_mesh(const aiMesh& mesh, const aiMatrix4x4& to_world, ModelArrays& model) {
  const auto first = static_cast<sim::Index>(model.positions.size());
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
    append_face(face, first, mirrored, model);
  }
}

void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, ModelArrays& model) {
  const aiMatrix4x4 to_world = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    append_mesh(*scene.mMeshes[node.mMeshes[m]], to_world, model);
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) {
    append_node(scene, *node.mChildren[c], to_world, model);
  }
}

std::string format_of(const Assimp::Importer& importer) {
  const int index = importer.GetPropertyInteger("importerIndex", -1);
  const aiImporterDesc* description =
      index < 0 ? nullptr : importer.GetImporterInfo(static_cast<std::size_t>(index));
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

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

void read_units(const aiScene& scene, const std::filesystem::path& path, ModelArrays& model) {
  if (contains(model.format, "FBX") && scene.mMetaData != nullptr) {
    read_fbx_settings(*scene.mMetaData, model);
  } else if (contains(model.format, "glTF") || contains(model.format, "Collada")) {
    // glTF is in metres with y up by its specification; of Collada files assimp applies unit and axes.
    model.metres_per_unit = 1.0;
    model.up = ModelAxis::y;
  } else if (contains(model.format, "3mf") || contains(model.format, "3MF")) {
    model.up = ModelAxis::z;
    model.metres_per_unit = unit_of_3mf(path);
  }
}

/// The library's reason without the file's name, which the whole message has.
std::string reason_of(std::string reason, const std::string& file) {
  if (contains(reason, "No suitable reader found")) {
    return "no reader knows this kind of file";
  }
  for (const std::string& name : {" \"" + file + '"', ' ' + file, file}) {
    for (std::size_t at = reason.find(name); at != std::string::npos; at = reason.find(name)) {
      reason.erase(at, name.size());
    }
  }
  return reason;
}

std::string in_lower_case(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return text;
}

ModelArrays read_with_assimp(const std::filesystem::path& path) {
  // Never destroyed: of some files (3MF with textures) it reads all there is and crashes while clearing away.
  Assimp::Importer& importer = *new Assimp::Importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  if (scene == nullptr) {
    throw InputError(reason_of(importer.GetErrorString(), path.string()));
  }
  if (scene->mRootNode == nullptr) {
    throw InputError("it has no scene");
  }
  ModelArrays model;
  model.format = format_of(importer);
  model.meshes = scene->mNumMeshes;
  read_units(*scene, path, model);
  append_node(*scene, *scene->mRootNode, aiMatrix4x4(), model);
  model.rig = read_rig(*scene, in_lower_case(path.extension().string()) != ".fbx");
  return model;
}

}  // namespace

ModelArrays read_model(const std::filesystem::path& path) {
  if (in_lower_case(path.extension().string()) == ".obj") {
    if (std::optional<ModelArrays> model = read_obj(read_text_file(path))) {
      return std::move(*model);
    }
  }
  return read_with_assimp(path);
}

}  // namespace taut::app
