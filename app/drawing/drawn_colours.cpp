#include "app/drawing/drawn_colours.hpp"

#include "app/base/errors.hpp"
#include "app/models/import_process.hpp"

namespace taut::app {
namespace {

// Of cloth that is printed or dyed on its outside.
constexpr renderer::Colour undyed_colour = renderer::rgb(0xE6E2DC);

renderer::Colour inside_of(const renderer::SurfaceStyle& cloth) {
  return cloth.inside_colour.value_or(renderer::reverse_of(cloth.outside_colour));
}

renderer::BaseColourMap map_of(const TextureImage& image) {
  return {static_cast<int>(image.width_px), static_cast<int>(image.height_px), image.rgba};
}

DrawnColours print(const PictureStyle& style, const SurfaceColours& colours) {
  if (colours.corner_uv.empty()) {
    throw InputError(
        "picture.texture: '" + style.texture.string() +
        "' cannot be drawn, as the garment has no texture coordinates; expected a model that has, "
        "such as an OBJ file with vt lines");
  }
  return {colours.corner_uv,
          {{style.cloth.outside_colour, inside_of(style.cloth), map_of(read_image(style.texture))}},
          {}};
}

renderer::BaseColour colour_of(const SurfaceMaterial& material, const SurfaceColours& colours,
                               const renderer::Colour& inside_colour) {
  if (material.map == no_map || colours.corner_uv.empty()) {
    return {material.base_colour, material.base_colour, {}};
  }
  return {material.base_colour, inside_colour, map_of(colours.maps[material.map])};
}

DrawnColours own(const PictureStyle& style, const SurfaceColours& colours) {
  DrawnColours drawn{colours.corner_uv, {}, colours.material_of_face, colours.remarks};
  for (const SurfaceMaterial& material : colours.materials) {
    drawn.base_colours.push_back(
        colour_of(material, colours, style.cloth.inside_colour.value_or(undyed_colour)));
  }
  return drawn;
}

bool has_own(const SurfaceColours& colours) {
  return std::ranges::any_of(colours.materials,
                             [](const SurfaceMaterial& material) { return !material.map_file.empty(); });
}

DrawnColours colours_of(const PictureStyle& style, const GarmentInScene& loaded) {
  if (names_image(style.texture)) return print(style, loaded.colours);
  const bool is_coloured = style.cloth.outside_colour != renderer::SurfaceStyle().outside_colour;
  if (style.texture == no_texture || is_coloured || !has_own(loaded.colours)) {
    return {loaded.colours.corner_uv, {}, {}};
  }
  return own(style, loaded.colours);
}

}  // namespace

DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded) {
  DrawnColours colours = colours_of(scene.picture, loaded);
  colours.following = loaded.following;
  return colours;
}

}  // namespace taut::app
