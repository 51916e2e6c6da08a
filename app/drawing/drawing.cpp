#include "app/drawing/drawing.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {

renderer::Image to_image(const Drawing& drawing, float scale) {
  renderer::Canvas canvas = renderer::Canvas::scaled(drawing.width_px, drawing.height_px, scale);
  drawing.draw(canvas);
  return canvas.to_image();
}

void write_pdf(const std::filesystem::path& path, const Drawing& drawing, const std::string& title) {
  renderer::Canvas canvas = renderer::Canvas::pdf(
      drawing.width_px, drawing.height_px, static_cast<float>(drawing.width_px) / page_width_inches, title);
  drawing.draw(canvas);
  write_file(path, canvas.finish_pdf());
}

renderer::TextStyle text_style(float size_px, const renderer::Colour& colour, bool bold) {
  renderer::TextStyle style;
  style.size_px = size_px;
  style.colour = colour;
  style.bold = bold;
  return style;
}

void draw_caption(renderer::Canvas& canvas, const Caption& caption, float centre_px, float top_px,
                  const CaptionStyle& style) {
  const std::string label = caption.letter == '\0' ? "" : std::string("(") + caption.letter + ") ";
  const renderer::TextStyle bold = text_style(style.text_px, palette::ink, true);
  const renderer::TextStyle plain = text_style(style.text_px);
  const float label_px = canvas.measure(label, bold).width_px;
  const float left_px = centre_px - 0.5F * (label_px + canvas.measure(caption.text, plain).width_px);
  const float baseline_px = top_px + 1.3F * style.text_px;
  canvas.text(left_px, baseline_px, label, bold);
  canvas.text(left_px + label_px, baseline_px, caption.text, plain);
  if (!caption.measured.empty()) {
    renderer::TextStyle grey = text_style(style.measured_px, palette::quiet_ink);
    grey.horizontal = renderer::HorizontalAlign::centre;
    canvas.text(centre_px, baseline_px + 1.45F * style.measured_px, caption.measured, grey);
  }
}

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
    throw InputError("picture.texture: '" + style.texture.string() +
                     "' cannot be drawn, as the garment has no texture coordinates; expected a model that "
                     "has, such as an OBJ file with vt lines");
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
