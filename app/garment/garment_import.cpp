#include "app/garment/garment_import.hpp"

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "app/errors.hpp"
#include "app/output/files.hpp"

namespace taut::app {
namespace {

void count_faces(const aiMesh& mesh, ImportedModel& model) {
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    switch (mesh.mFaces[f].mNumIndices) {
      case 1:
        ++model.ignored_points;
        break;
      case 2:
        ++model.ignored_lines;
        break;
      case 3:
        ++model.file_triangles;
        break;
      case 4:
        ++model.file_quads;
        break;
      default:
        ++model.file_polygons;
    }
  }
}

void append_mesh(const aiMesh& mesh, const aiMatrix4x4& to_world, ImportedModel& model) {
  const auto first = static_cast<sim::Index>(model.positions.size());
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D p = to_world * mesh.mVertices[v];
    model.positions.emplace_back(p.x, p.y, p.z);
  }
  // A mirrored node would turn the garment inside out.
  const bool mirrored = to_world.Determinant() < 0.0F;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices == 3) {
      const unsigned* corner = face.mIndices;
      model.triangles.push_back(
          {first + corner[0], first + corner[mirrored ? 2 : 1], first + corner[mirrored ? 1 : 2]});
    }
  }
}

void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, ImportedModel& model) {
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

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
  throw InputError("cannot read a garment from '" + path.string() + "': " + reason +
                   "; expected a 3D model with faces, such as OBJ, PLY, STL, glTF, FBX or Collada");
}

}  // namespace

ImportedModel import_garment(const std::filesystem::path& path) {
  require_file(path);
  Assimp::Importer importer;
  if (importer.ReadFile(path.string(), 0) == nullptr) {
    refuse(path, importer.GetErrorString());
  }
  ImportedModel model;
  model.format = format_of(importer);
  model.meshes = importer.GetScene()->mNumMeshes;
  for (unsigned m = 0; m < importer.GetScene()->mNumMeshes; ++m) {
    count_faces(*importer.GetScene()->mMeshes[m], model);
  }
  if (model.file_triangles + model.file_quads + model.file_polygons == 0) {
    refuse(path, "it has no faces");
  }
  const aiScene* scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    refuse(path, "its polygons cannot be cut into triangles");
  }
  append_node(*scene, *scene->mRootNode, aiMatrix4x4(), model);
  if (model.triangles.empty()) {
    refuse(path, "no face is placed in its scene");
  }
  return model;
}

}  // namespace taut::app
