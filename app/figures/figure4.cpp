#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/figures/figures.hpp"
#include "app/figures/moment_tables.hpp"
#include "app/figures/print.hpp"

namespace taut::app {
namespace {

constexpr PictureSize picture_size = {1180, 1120};

Caption caption_of(const PrintedMoment& moment, char letter) {
  if (moment.shows_stretch) {
    return {letter, "the same, coloured by the stretch of its springs",
            fmt::format("99 of 100 springs up to {:.4g} %, triangles up to {:.4g} %",
                        100.0 * moment.moment->record.stretch.p99,
                        100.0 * moment.moment->record.surface_stretch.p99)};
  }
  return {letter, largest_stretch_text(moment),
          fmt::format("{} sweeps of the constraint in a step; red: at rest length",
                      moment.recording->scene.simulation.solver.strong.iterations)};
}

renderer::Colour colour_of(double stretch) {
  return renderer::colour_at(printed_stretch_colours,
                             static_cast<float>(0.5 + 0.5 * stretch / printed_stretch));
}

// What the light makes of a colour, from a picture of the cloth unstretched: by the lightest pixel near the
// middle, which lies between the lines of the springs.
renderer::Colour shade_of(const renderer::Image& unstretched) {
  renderer::Colour lightest{0.0F};
  const int width_px = unstretched.width_px / 8, height_px = unstretched.height_px / 8;
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      const std::uint8_t* pixel = unstretched.at((unstretched.width_px - width_px) / 2 + x,
                                                 (unstretched.height_px - height_px) / 2 + y);
      const renderer::Colour colour = renderer::Colour(pixel[0], pixel[1], pixel[2]) / 255.0F;
      lightest = colour.g > lightest.g ? colour : lightest;
    }
  }
  return lightest / colour_of(0.0);
}

// The colours of the stretch as they look on the cloth, lowest last. A picture rather than rows of
// rectangles, between which a page that is scaled shows seams.
renderer::Image colour_bar(double lowest, double highest, const renderer::Colour& shade) {
  renderer::Image bar = renderer::make_image(1, 256);
  for (int y = 0; y < bar.height_px; ++y) {
    const double up = (bar.height_px - 0.5 - y) / bar.height_px;
    const double stretch = lowest + up * (highest - lowest);
    const renderer::Colour colour = shade * colour_of(stretch);
    for (int channel = 0; channel < 3; ++channel) {
      bar.at(0, y)[channel] =
          static_cast<std::uint8_t>(std::lround(255.0F * std::min(colour[channel], 1.0F)));
    }
  }
  return bar;
}

void draw_stretch_legend(renderer::Canvas& canvas, const SheetStyle& style, const renderer::Colour& shade) {
  constexpr double lowest = 0.0, highest = printed_stretch;
  constexpr float width_px = 44.0F, tick_px = 10.0F;
  const glm::vec2 corner = panel_corner(style, picture_size, 3);
  const float x_px = corner.x + static_cast<float>(picture_size.width_px) + 34.0F;
  const float y_px = corner.y + 0.12F * static_cast<float>(picture_size.height_px);
  const float height_px = 0.76F * static_cast<float>(picture_size.height_px);
  canvas.image(x_px, y_px, width_px, height_px, colour_bar(lowest, highest, shade));
  canvas.rectangle(x_px, y_px, width_px, height_px, palette::ink, 2.0F);
  renderer::TextStyle text = text_style(style.caption.measured_px);
  text.vertical = renderer::VerticalAlign::middle;
  for (const int percent : {0, 5, 10, 15, 20}) {
    const auto up = static_cast<float>((0.01 * percent - lowest) / (highest - lowest));
    const float tick_y_px = y_px + (1.0F - up) * height_px;
    text.bold = percent == 5;  // the bound
    canvas.line(x_px + width_px, tick_y_px, x_px + width_px + tick_px, tick_y_px, palette::ink, 2.0F);
    canvas.text(x_px + width_px + 1.5F * tick_px, tick_y_px, fmt::format("{} %", percent), text);
  }
  canvas.text(x_px, y_px - 1.2F * style.caption.measured_px, "stretch",
              text_style(style.caption.measured_px));
}

std::array<const Recording*, 2> recordings_of(const Results& results) {
  return {&*results.pinned[0], &*results.pinned[1]};
}

}  // namespace

std::string figure4_csv(const Results& results) {
  return moments_csv(recordings_of(results));
}

std::string figure4_shapes_csv(const Results& results) {
  return shapes_csv(recordings_of(results));
}

void read_figure4(const std::filesystem::path& folder, Results& results) {
  for (std::size_t i = 0; i < results.pinned.size(); ++i) {
    results.pinned[i] = read_recording(folder, "fig4", pinned_scenes[i]);
  }
}

// Over-stretching: the same cloth, held by its upper corners, with two limits of stretch; below, where.
Drawing draw_figure4(const Results& results, LazyOffscreenRenderer& offscreen) {
  std::vector<PrintedMoment> moments;
  for (const bool shows_stretch : {false, true}) {
    for (const auto& recording : results.pinned) {
      moments.push_back({&*recording, &recording->last(), shows_stretch, false});
    }
  }
  Moment unstretched;
  unstretched.positions = results.pinned[0]->garment->mesh.positions;
  moments.push_back({&*results.pinned[0], &unstretched, true, false});
  Prints prints = print_moments(offscreen, moments, picture_size);
  const renderer::Colour shade = shade_of(prints.pictures.back());
  moments.pop_back();
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    panels.push_back({std::move(prints.pictures[i]),
                      caption_of(moments[i], static_cast<char>('a' + static_cast<int>(i)))});
  }
  const SheetStyle style = {
      .columns = 2, .caption = {.text_px = 42.0F, .measured_px = 37.0F}, .right_px = 190.0F};
  Drawing drawing = sheet_of(std::move(panels), prints.size, style, {0.25F * prints.metre_px, "25 cm"});
  drawing.draw = [panels_drawing = drawing.draw, style, shade](renderer::Canvas& canvas) {
    panels_drawing(canvas);
    draw_stretch_legend(canvas, style, shade);
  };
  return drawing;
}

}  // namespace taut::app
