#include "app/models/material_reading.hpp"

#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>

#include <algorithm>
#include <glm/common.hpp>
#include <sstream>
#include <string>

#include "app/models/srgb.hpp"

namespace taut::app {
namespace {

/// The file name behind a map's options, each of which is a word that begins with a minus and what follows of
/// numbers, switches and channels.
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

SurfaceMaterial material_of(const aiMaterial& from, bool is_gltf) {
  SurfaceMaterial material{.name = from.GetName().C_Str()};
  aiColor4D colour(1.0F, 1.0F, 1.0F, 1.0F);
  if (from.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) {
    from.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  }
  material.base_colour = glm::clamp(glm::vec3(colour.r, colour.g, colour.b), 0.0F, 1.0F);
  if (is_gltf) {
    for (int k = 0; k < 3; ++k) {
      material.base_colour[k] = linear_to_srgb(material.base_colour[k]);
    }
    material.map_tint = material.base_colour;
    aiString mode;
    material.map_is_opaque =
        from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS || mode == aiString("OPAQUE");
  }
  for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
    aiString file;
    if (from.GetTexture(type, 0, &file) == aiReturn_SUCCESS) {
      material.map_file = file.C_Str();
    }
  }
  return material;
}

}  // namespace

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
      material = std::find_if(colours.materials.begin(), colours.materials.end(),
                              [&](const SurfaceMaterial& known) { return known.name == name; });
    } else if (kind == "Kd" && material != colours.materials.end()) {
      glm::vec3 colour(1.0F);
      if (line >> colour.x >> colour.y >> colour.z) {
        material->base_colour = glm::clamp(colour, 0.0F, 1.0F);
      }
    } else if (kind == "map_Kd" && material != colours.materials.end()) {
      material->map_file = map_name(line);
    }
  }
}

std::vector<SurfaceMaterial> materials_of(const aiScene& scene, bool is_gltf) {
  std::vector<SurfaceMaterial> materials;
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    materials.push_back(material_of(*scene.mMaterials[m], is_gltf));
  }
  return materials;
}

}  // namespace taut::app
