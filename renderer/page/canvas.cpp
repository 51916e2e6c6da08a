#include "renderer/page/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo.h>

namespace taut::renderer {
namespace {

using SurfaceHandle = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

std::uint32_t premultiply_pixel(const std::uint8_t* pixel, bool has_alpha) {
  const unsigned alpha = has_alpha ? pixel[3] : 255U;
  const auto part = [alpha](unsigned value) { return (value * alpha + 127U) / 255U; };
  return (alpha << 24U) | (part(pixel[0]) << 16U) | (part(pixel[1]) << 8U) | part(pixel[2]);
}

SurfaceHandle check_surface(cairo_surface_t* canvas_surface) {
  SurfaceHandle handle(canvas_surface, cairo_surface_destroy);
  const cairo_status_t status = cairo_surface_status(canvas_surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("cannot make a canvas: ") + cairo_status_to_string(status));
  }
  return handle;
}

// Cairo stores pixels as native 32-bit words, alpha highest.
SurfaceHandle to_cairo(const Image& image) {
  const bool has_alpha = image.channels == 4;
  SurfaceHandle surface = check_surface(cairo_image_surface_create(has_alpha ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
                                                                   image.width_px, image.height_px));
  cairo_surface_flush(surface.get());
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      const std::uint32_t word = premultiply_pixel(image.at(x, y), has_alpha);
      std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, &word, 4);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

Image from_cairo(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  const bool has_alpha = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_ARGB32;
  Image image =
      make_image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), has_alpha ? 4 : 3);
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      std::uint32_t word = 0;
      std::memcpy(&word, data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, 4);
      std::uint8_t* pixel = image.at(x, y);
      const unsigned alpha = has_alpha ? word >> 24U : 255U;
      for (unsigned i = 0; i < 3; ++i) {
        const unsigned part = (word >> (16U - 8U * i)) & 255U;
        pixel[i] = static_cast<std::uint8_t>((part * 255U + alpha / 2U) / std::max(alpha, 1U));
      }
      if (has_alpha) pixel[3] = static_cast<std::uint8_t>(alpha);
    }
  }
  return image;
}

using PenHandle = std::unique_ptr<cairo_t, void (*)(cairo_t*)>;

cairo_status_t append_bytes(void* target, const unsigned char* bytes, unsigned count) {
  auto& out = *static_cast<std::vector<std::uint8_t>*>(target);
  out.insert(out.end(), bytes, bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

// Fixes the glyphs on every machine, whatever its font settings for screens.
void set_font_options(cairo_t* pen) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(pen, options);
  cairo_font_options_destroy(options);
}

void select_font(cairo_t* pen, const TextStyle& style) {
  cairo_select_font_face(pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(pen, style.size_px);
}

void set_colour(cairo_t* pen, Colour colour, float opacity = 1.0F) {
  cairo_set_source_rgba(pen, colour.r, colour.g, colour.b, opacity);
}

float horizontal_shift(HorizontalAlign align, const TextSize& size) {
  return -0.5F * static_cast<float>(align) * size.width_px;
}

float vertical_shift(VerticalAlign align, const TextSize& size) {
  // The eye takes the middle of lower-case letters with ascenders for the middle of a line.
  if (align == VerticalAlign::middle) return 0.36F * (size.ascent_px + size.descent_px) * 0.86F;
  return align == VerticalAlign::top ? size.ascent_px : align == VerticalAlign::bottom ? -size.descent_px : 0.0F;
}

void draw_bar(Canvas& canvas, const Legend& legend, const LegendPlace& place) {
  const int rows = static_cast<int>(std::ceil(place.bar_height_px));
  // Rows may lie between whole pixels, so each extends below the next, and the bar under its frame: no seam shows.
  constexpr float under_border = 0.5F;
  for (int row = 0; row < rows; ++row) {
    const float y = static_cast<float>(row);
    const float t = 1.0F - (y + 0.5F) / place.bar_height_px;
    const float top = row == 0 ? -under_border : y;
    canvas.fill_rectangle(place.x_px - under_border, place.y_px + top, place.bar_width_px + 2.0F * under_border,
                          place.bar_height_px - top + under_border, colour_at(legend.map, t));
  }
  canvas.rectangle(place.x_px - 0.5F, place.y_px - 0.5F, place.bar_width_px + 1.0F, place.bar_height_px + 1.0F,
                   place.text.colour);
}

// Draws a small triangle on the bar: larger values exist and take the last colour.
void draw_arrow(Canvas& canvas, const Legend& legend, const LegendPlace& place) {
  const float height = 0.6F * place.bar_width_px;
  for (float y = 0.0F; y < height; y += 1.0F) {
    const float half = 0.5F * place.bar_width_px * (1.0F - (y + 0.5F) / height);
    // Rows overlap the wider row below, so that no seam shows.
    const float depth = y > 0.0F ? 2.0F : 1.0F;
    canvas.fill_rectangle(place.x_px + 0.5F * place.bar_width_px - half, place.y_px - 2.0F - y, 2.0F * half, depth,
                          colour_at(legend.map, 1.0F));
  }
}

struct Scale {
  const Legend& legend;
  const LegendPlace& place;
  float bar_y_px(float value) const {
    const float t = (value - legend.minimum) / (legend.maximum - legend.minimum);
    return place.y_px + (1.0F - t) * place.bar_height_px;
  }
};

void draw_ticks(Canvas& canvas, const Legend& legend, const Scale& scale, const TextStyle& text) {
  const LegendPlace& place = scale.place;
  const float right = place.x_px + place.bar_width_px + 1.0F;
  const float low = legend.minimum * legend.factor;
  const float high = legend.maximum * legend.factor;
  const float step = round_step(high - low);
  for (const float shown : multiples_within(low, high, step)) {
    const float value = shown / legend.factor;
    const float y = std::floor(scale.bar_y_px(value)) + 0.5F;
    const bool hidden = legend.bound && std::abs(scale.bar_y_px(*legend.bound) - y) < 1.1F * text.size_px;
    canvas.line(right, y, right + 4.0F, y, text.colour);
    if (!hidden) canvas.text(right + 8.0F, y, tick_text(shown, step) + legend.suffix, text);
  }
}

void draw_bound(Canvas& canvas, const Legend& legend, const Scale& scale, TextStyle text) {
  const LegendPlace& place = scale.place;
  const float y = std::round(scale.bar_y_px(*legend.bound));
  const float right = place.x_px + place.bar_width_px;
  // White under black is visible on every colour of the map.
  canvas.line(place.x_px - 4.0F, y, right + 6.0F, y, Colour{1.0F}, 4.0F);
  canvas.line(place.x_px - 4.0F, y, right + 6.0F, y, text.colour, 2.0F);
  const float range = (legend.maximum - legend.minimum) * legend.factor;
  const float shown = *legend.bound * legend.factor;
  // A bound between ticks gets one digit more than they have.
  const float step = round_step(range);
  const bool on_tick = std::abs(shown / step - std::round(shown / step)) < 0.01F;
  text.bold = true;
  canvas.text(right + 9.0F, y, tick_text(shown, on_tick ? step : 0.1F * step) + legend.suffix + " bound", text);
}

}  // namespace

struct Canvas::Surface {
  // Declared first: it has to outlive the surface that streams into it.
  std::vector<std::uint8_t> pdf_bytes;
  bool is_pdf = false;
  int width_px = 0;
  int height_px = 0;
  float min_text_px = INFINITY;
  float scale = 1.0F;  // pixels of the image, or points of the page, per coordinate
  SurfaceHandle surface{nullptr, cairo_surface_destroy};
  PenHandle pen{nullptr, cairo_destroy};

  void start() {
    pen = PenHandle(cairo_create(surface.get()), cairo_destroy);
    set_font_options(pen.get());
    cairo_scale(pen.get(), scale, scale);
  }
  // Returns the pixels per coordinate; for a PDF 1, as it has no pixels.
  float pixels_in_one() const { return is_pdf ? 1.0F : scale; }
  // Returns y rounded to whole pixels: a baseline between two rows blurs every letter's foot.
  float on_whole_pixel(float y_px) const { return std::round(y_px * pixels_in_one()) / pixels_in_one(); }
  bool has_as_many_pixels(float length_px, int pixels) const {
    return std::abs(length_px * pixels_in_one() - static_cast<float>(pixels)) < 1.0F;
  }
};

Canvas::Canvas(std::unique_ptr<Surface> canvas_surface) : surface_(std::move(canvas_surface)) {}
Canvas::~Canvas() = default;

Canvas::Canvas(int width_px, int height_px, float scale) : surface_(std::make_unique<Surface>()) {
  surface_->width_px = width_px;
  surface_->height_px = height_px;
  surface_->scale = scale;
  const auto pixels = [scale](int length) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * scale)));
  };
  surface_->surface =
      check_surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width_px), pixels(height_px)));
  surface_->start();
  set_colour(surface_->pen.get(), Colour{1.0F});
  cairo_paint(surface_->pen.get());
}

Canvas::Canvas(const Image& image) : surface_(std::make_unique<Surface>()) {
  surface_->width_px = image.width_px;
  surface_->height_px = image.height_px;
  surface_->surface = to_cairo(image);
  surface_->start();
}

Canvas Canvas::pdf(int width_px, int height_px, float pixels_per_inch, const std::string& title) {
  auto canvas_surface = std::make_unique<Surface>();
  canvas_surface->is_pdf = true;
  canvas_surface->width_px = width_px;
  canvas_surface->height_px = height_px;
  const double points_per_px = 72.0 / static_cast<double>(pixels_per_inch);
  canvas_surface->scale = static_cast<float>(points_per_px);
  canvas_surface->surface = check_surface(cairo_pdf_surface_create_for_stream(
      append_bytes, &canvas_surface->pdf_bytes, width_px * points_per_px, height_px * points_per_px));
  cairo_pdf_surface_set_metadata(canvas_surface->surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  // A fixed date: without it no two files would be alike.
  cairo_pdf_surface_set_metadata(canvas_surface->surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  canvas_surface->start();
  return Canvas(std::move(canvas_surface));
}

int Canvas::width_px() const { return surface_->width_px; }
int Canvas::height_px() const { return surface_->height_px; }
float Canvas::min_text_px() const { return surface_->min_text_px; }

TextSize Canvas::measure(std::string_view text, const TextStyle& style) const {
  cairo_t* pen = surface_->pen.get();
  select_font(pen, style);
  cairo_text_extents_t extents;
  cairo_text_extents(pen, std::string(text).c_str(), &extents);
  cairo_font_extents_t font;
  cairo_font_extents(pen, &font);
  return {static_cast<float>(extents.x_advance), static_cast<float>(font.ascent), static_cast<float>(font.descent)};
}

void Canvas::text(float x_px, float y_px, std::string_view text, const TextStyle& style) {
  if (!text.empty()) surface_->min_text_px = std::min(surface_->min_text_px, style.size_px);
  const TextSize size = measure(text, style);
  cairo_t* pen = surface_->pen.get();
  set_colour(pen, style.colour);
  const float baseline = surface_->on_whole_pixel(y_px + vertical_shift(style.vertical, size));
  cairo_move_to(pen, x_px + horizontal_shift(style.horizontal, size), baseline);
  cairo_show_text(pen, std::string(text).c_str());
  // A new path: an arc would be joined to the end of the text, which some PDF viewers show as a hairline.
  cairo_new_path(pen);
}

void Canvas::line(float x0_px, float y0_px, float x1_px, float y1_px, Colour colour, float thickness_px) {
  polyline(std::array{glm::vec2(x0_px, y0_px), glm::vec2(x1_px, y1_px)}, colour, thickness_px);
}

void Canvas::polyline(std::span<const glm::vec2> points, Colour colour, float thickness_px,
                      std::span<const double> dashes_px) {
  constexpr float max_coordinate_px = 1e5F;  // Cairo's fixed point numbers hold 8e6
  cairo_t* pen = surface_->pen.get();
  cairo_save(pen);
  set_colour(pen, colour);
  cairo_set_line_width(pen, thickness_px);
  // Cairo fills a level or upright line exactly as long as it has no other joins.
  if (points.size() > 2) cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(pen, dashes_px.data(), static_cast<int>(dashes_px.size()), 0.0);
  for (const glm::vec2& point : points) {
    const glm::vec2 at = glm::clamp(point, -max_coordinate_px, max_coordinate_px);
    cairo_line_to(pen, at.x, at.y);
  }
  cairo_stroke(pen);
  cairo_restore(pen);
}

void Canvas::within(float x_px, float y_px, float width_px, float height_px, const std::function<void()>& draw) {
  cairo_t* pen = surface_->pen.get();
  cairo_save(pen);
  cairo_rectangle(pen, x_px, y_px, width_px, height_px);
  cairo_clip(pen);
  draw();
  cairo_restore(pen);
}

void Canvas::rectangle(float x_px, float y_px, float width_px, float height_px, Colour colour, float thickness_px) {
  cairo_t* pen = surface_->pen.get();
  set_colour(pen, colour);
  cairo_set_line_width(pen, thickness_px);
  cairo_rectangle(pen, x_px, y_px, width_px, height_px);
  cairo_stroke(pen);
}

void Canvas::fill_rectangle(float x_px, float y_px, float width_px, float height_px, Colour colour, float opacity) {
  cairo_t* pen = surface_->pen.get();
  set_colour(pen, colour, opacity);
  cairo_rectangle(pen, x_px, y_px, width_px, height_px);
  cairo_fill(pen);
}

void Canvas::circle(float x_px, float y_px, float radius_px, Colour colour, float opacity) {
  cairo_t* pen = surface_->pen.get();
  set_colour(pen, colour, opacity);
  cairo_arc(pen, x_px, y_px, radius_px, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(pen);
}

void Canvas::image(float x_px, float y_px, const Image& image) {
  this->image(x_px, y_px, static_cast<float>(image.width_px), static_cast<float>(image.height_px), image);
}

void Canvas::image(float x_px, float y_px, float width_px, float height_px, const Image& image) {
  const SurfaceHandle source = to_cairo(image);
  cairo_t* pen = surface_->pen.get();
  cairo_save(pen);
  cairo_translate(pen, x_px, y_px);
  const bool as_is = surface_->has_as_many_pixels(width_px, image.width_px) &&
                     surface_->has_as_many_pixels(height_px, image.height_px);
  cairo_scale(pen, static_cast<double>(width_px) / image.width_px, static_cast<double>(height_px) / image.height_px);
  cairo_set_source_surface(pen, source.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(pen), as_is ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_BEST);
  cairo_rectangle(pen, 0.0, 0.0, image.width_px, image.height_px);
  cairo_fill(pen);
  cairo_restore(pen);
}

Image Canvas::to_image() const {
  if (surface_->is_pdf) throw std::logic_error("a PDF has no pixels");
  return from_cairo(surface_->surface.get());
}

std::vector<std::uint8_t> Canvas::finish_pdf() {
  if (!surface_->is_pdf) throw std::logic_error("an image is no PDF");
  cairo_surface_finish(surface_->surface.get());
  const cairo_status_t status = cairo_surface_status(surface_->surface.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("cannot make a PDF: ") + cairo_status_to_string(status));
  }
  return std::move(surface_->pdf_bytes);
}

void draw_legend(Canvas& canvas, const Legend& legend, const LegendPlace& place) {
  if (!(legend.maximum > legend.minimum)) return;
  const Scale scale{legend, place};
  const TextStyle text = place.text.with_alignment(HorizontalAlign::left, VerticalAlign::middle);
  draw_bar(canvas, legend, place);
  if (legend.more_above) draw_arrow(canvas, legend, place);
  draw_ticks(canvas, legend, scale, text);
  if (legend.bound && *legend.bound >= legend.minimum && *legend.bound <= legend.maximum) {
    draw_bound(canvas, legend, scale, text);
  }
  const float lift = legend.more_above ? 0.6F * place.bar_width_px + 8.0F : 8.0F;
  canvas.text(place.x_px, place.y_px - lift, legend.title,
              place.text.with_alignment(HorizontalAlign::left, VerticalAlign::bottom));
}

}  // namespace taut::renderer
