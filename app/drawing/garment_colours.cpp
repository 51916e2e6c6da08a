#include "app/drawing/garment_colours.hpp"

#include "app/base/errors.hpp"
#include "app/models/hanging/landmarks.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {
namespace {

// Inside of cloth that is printed or dyed on its outside.
constexpr renderer::Colour undyed_colour = renderer::rgb(0xE6E2DC);

renderer::Colour inner_colour(const renderer::SurfaceStyle& cloth) {
  return cloth.inside_colour.value_or(renderer::reverse_colour(cloth.outside_colour));
}

renderer::BaseColourMap to_base_colour_map(const TextureImage& image) {
  return {static_cast<int>(image.width_px), static_cast<int>(image.height_px), image.rgba};
}

DrawnColours print(const PictureStyle& style, const SurfaceColours& colours) {
  if (colours.corner_uv.empty()) {
    throw InputError("picture.texture: '" + style.texture.string() +
                     "' cannot be drawn, as the garment has no texture coordinates; expected a model that "
                     "has, such as an OBJ file with vt lines");
  }
  return {colours.corner_uv,
          {{style.cloth.outside_colour, inner_colour(style.cloth), to_base_colour_map(read_image(style.texture))}},
          {}};
}

renderer::BaseColour to_base_colour(const SurfaceMaterial& material, const SurfaceColours& colours,
                                    const renderer::Colour& inside_colour) {
  if (material.map == no_map || colours.corner_uv.empty()) return {material.base_colour, material.base_colour, {}};
  return {material.base_colour, inside_colour, to_base_colour_map(colours.maps[material.map])};
}

DrawnColours model_colours(const PictureStyle& style, const SurfaceColours& colours) {
  DrawnColours drawn{colours.corner_uv, {}, colours.material_of_face, colours.remarks};
  for (const SurfaceMaterial& material : colours.materials) {
    drawn.base_colours.push_back(to_base_colour(material, colours, style.cloth.inside_colour.value_or(undyed_colour)));
  }
  return drawn;
}

// Programs write white or a grey where nobody chose a colour.
constexpr float max_grey_difference = 0.02F;

bool are_chosen(const SurfaceColours& colours) {
  return std::ranges::any_of(colours.materials, [](const SurfaceMaterial& material) {
    const glm::vec3& rgb = material.base_colour;
    const float difference = std::max({rgb.x, rgb.y, rgb.z}) - std::min({rgb.x, rgb.y, rgb.z});
    return !material.map_file.empty() || difference > max_grey_difference;
  });
}

PictureStyle fabric_style(const std::string& fabric) {
  DrawnScene scene;
  apply_overrides(drawn_scene_format(), std::vector<Override>{{"cloth.fabric", fabric, "fabrics"}}, scene);
  return scene.picture;
}

/// Returns the colours of a garment whose layers have fabrics of their own.
DrawnColours layer_colours(const DrawnScene& scene, const GarmentInScene& loaded) {
  DrawnColours drawn{
      loaded.colours.corner_uv, {{scene.picture.cloth.outside_colour, inner_colour(scene.picture.cloth), {}}}, {}};
  for (const auto& [group, fabric] : read_garment_facts(scene.garment.model()).fabrics) {
    const renderer::SurfaceStyle cloth = fabric_style(fabric).cloth;
    drawn.base_colours.push_back({cloth.outside_colour, inner_colour(cloth), {}});
  }
  for (const sim::Triangle& t : loaded.garment->mesh.triangles) {
    drawn.base_colour_of_triangle.push_back(loaded.garment->material_indices[t[0]]);
  }
  return drawn;
}

DrawnColours choose_colours(const DrawnScene& scene, const GarmentInScene& loaded) {
  const PictureStyle& style = scene.picture;
  if (names_image(style.texture)) return print(style, loaded.colours);
  if (style.texture != no_texture && !loaded.garment->material_indices.empty()) return layer_colours(scene, loaded);
  const bool is_coloured = style.cloth.outside_colour != renderer::SurfaceStyle().outside_colour;
  if (style.texture == no_texture || is_coloured || !are_chosen(loaded.colours)) {
    return {loaded.colours.corner_uv, {}, {}};
  }
  return model_colours(style, loaded.colours);
}

}  // namespace

DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded) {
  DrawnColours colours = choose_colours(scene, loaded);
  colours.following = loaded.following;
  return colours;
}

}  // namespace taut::app
