#include "app/figures/pictures.hpp"

#include "app/figures/figures.hpp"
#include "app/runs/csv.hpp"
#include "app/scene/fabric.hpp"

namespace taut::app {
namespace {

// Fraction of the picture's width and height that stays free around the content.
constexpr float print_margin_fraction = 0.045F;
// Smallest number of passes of small pictures, which have fewer than the usual in proportion to their pixels. Fewer
// show noise in shadows, more take longer.
constexpr float min_print_passes = 8.0F;

DrawnScene scene_for_print(const PrintedMoment& moment, const glm::ivec2& size) {
  DrawnScene scene = moment.recording->scene;
  renderer::PictureSettings& settings = scene.picture.settings;
  settings.width_px = size.x;
  settings.height_px = size.y;
  scene.picture.show_wind = true;
  scene.picture.quality = DrawingQuality::final;
  scene.picture.background = {BackgroundKind::colour, renderer::rgb(0xFFFFFF)};
  if (!moment.has_floor) scene.picture.ground.kind = GroundKind::none;
  if (moment.shows_stretch) {
    scene.picture.surface = SurfaceLook::stretch;
    scene.picture.stretch_of = StretchOf::springs;  // as in the paper
    scene.picture.stretch_range = std::array{-max_printed_stretch, max_printed_stretch};
    scene.picture.stretch_colours = printed_stretch_colours;
    scene.picture.legend = false;
  }
  return scene;
}

// Returns a camera that sees every vertex and every arrow of the moments. Shadows may fade at the border.
renderer::Camera camera_for(std::span<const PrintedMoment> moments, const glm::ivec2& size) {
  DrawnScene scene = scene_for_print(moments.front(), size);
  scene.camera.framing.margin = print_margin_fraction;
  const renderer::Box reach =
      expected_reach(scene, *moments.front().recording->garment, named_bodies(scene), moments.front().recording->pins);
  const float aspect = scene.picture.settings.aspect();
  const renderer::Camera near = scene_camera(scene, reach, aspect);
  std::vector<glm::vec3> points;
  for (const PrintedMoment& moment : moments) {
    const std::vector<glm::vec3> seen = to_float(moment.moment->positions);
    const std::vector<glm::vec3> arrows =
        wind_arrows(moment.recording->scene.surroundings.forces.wind, moment.recording->garment->mesh.positions, near);
    points.insert(points.end(), seen.begin(), seen.end());
    points.insert(points.end(), arrows.begin(), arrows.end());
  }
  return renderer::fit_camera_to_points(points, choose_framing(scene, reach), aspect);
}

void draw_scale_bar(renderer::Canvas& canvas, const ScaleBar& bar, const glm::vec2& at, float text_px) {
  const float end_px = at.x + bar.length_px;
  canvas.line(at.x, at.y, end_px, at.y, palette::ink, 4.0F);
  for (const float x_px : {at.x, end_px}) canvas.line(x_px, at.y - 9.0F, x_px, at.y + 9.0F, palette::ink, 4.0F);
  const renderer::TextStyle text = text_style(text_px).with_alignment(renderer::HorizontalAlign::centre);
  canvas.text(0.5F * (at.x + end_px), at.y - 0.5F * text_px, bar.label, text);
}

// Calls `visit` for the panels of all recordings; their letters continue from one recording to the next.
template <class Visit> void for_each_panel(std::span<const Recording* const> recordings, const Visit& visit) {
  char letter = 'a';
  for (const Recording* recording : recordings) {
    for (const Moment& moment : recording->moments) visit(std::string(1, letter++), *recording, moment);
  }
}

// Makes panels with letters from a. Moves the pictures out of the prints.
template <class CaptionOf>
std::vector<Panel> make_panels(Prints& prints, std::span<const PrintedMoment> moments, CaptionOf caption_of) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    panels.push_back(
        {std::move(prints.pictures[i]), caption_of(moments[i], static_cast<char>('a' + static_cast<int>(i)))});
  }
  return panels;
}

constexpr glm::ivec2 pinned_size = {1180, 1120};

Caption pinned_caption(const PrintedMoment& moment, char letter) {
  if (moment.shows_stretch) {
    return {letter, "the same, coloured by the stretch of its springs",
            fmt::format("99 of 100 springs up to {:.3g} %, triangles up to {:.3g} %",
                        100.0 * moment.moment->record.stretch.p99, 100.0 * moment.moment->record.surface_stretch.p99)};
  }
  return {letter, largest_stretch_text(moment),
          fmt::format("{} sweeps of the constraint in a step; red: at rest length",
                      moment.recording->scene.simulation.solver.strong.iterations)};
}

renderer::Colour stretch_colour(double stretch) {
  return renderer::colour_at(printed_stretch_colours, static_cast<float>(0.5 + 0.5 * stretch / max_printed_stretch));
}

// Returns the shaded colour of the unstretched cloth in a picture: the lightest pixel near the middle, which lies
// between the lines of the springs.
renderer::Colour mean_shade(const renderer::Image& unstretched) {
  renderer::Colour lightest{0.0F};
  const int width_px = unstretched.width_px / 8, height_px = unstretched.height_px / 8;
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      const std::uint8_t* pixel =
          unstretched.at((unstretched.width_px - width_px) / 2 + x, (unstretched.height_px - height_px) / 2 + y);
      const renderer::Colour colour = renderer::Colour(pixel[0], pixel[1], pixel[2]) / 255.0F;
      lightest = colour.g > lightest.g ? colour : lightest;
    }
  }
  return lightest / stretch_colour(0.0);
}

// Returns the colours of stretch as they look on the cloth, the lowest at the bottom. Rows of rectangles would show
// seams on a scaled page, a picture does not.
renderer::Image colour_bar(double lowest, double highest, const renderer::Colour& shade) {
  renderer::Image bar = renderer::make_image(1, 256);
  for (int y = 0; y < bar.height_px; ++y) {
    const double up = (bar.height_px - 0.5 - y) / bar.height_px;
    const double stretch = lowest + up * (highest - lowest);
    const renderer::Colour colour = shade * stretch_colour(stretch);
    for (int channel = 0; channel < 3; ++channel) {
      bar.at(0, y)[channel] = static_cast<std::uint8_t>(std::lround(255.0F * std::min(colour[channel], 1.0F)));
    }
  }
  return bar;
}

/// Returns the upper left corner of the panel with this index, in pixels of the figure.
glm::vec2 panel_corner(const SheetStyle& style, const glm::ivec2& picture, std::size_t panel) {
  const glm::vec2 place(panel % style.columns, panel / style.columns);
  return style.border_px + place * (glm::vec2(picture) + glm::vec2(0.0F, style.caption.height_px()) + style.gap_px);
}

void draw_stretch_legend(renderer::Canvas& canvas, const SheetStyle& style, const renderer::Colour& shade) {
  constexpr double lowest = 0.0, highest = max_printed_stretch;
  constexpr float width_px = 44.0F, tick_px = 10.0F;
  const glm::vec2 corner = panel_corner(style, pinned_size, 3);
  const float x_px = corner.x + static_cast<float>(pinned_size.x) + 34.0F;
  const float y_px = corner.y + 0.12F * static_cast<float>(pinned_size.y);
  const float height_px = 0.76F * static_cast<float>(pinned_size.y);
  canvas.image(x_px, y_px, width_px, height_px, colour_bar(lowest, highest, shade));
  canvas.rectangle(x_px, y_px, width_px, height_px, palette::ink, 2.0F);
  renderer::TextStyle text = text_style(style.caption.measured_px)
                                 .with_alignment(renderer::HorizontalAlign::left, renderer::VerticalAlign::middle);
  for (const int percent : {0, 5, 10, 15, 20}) {
    const auto up = static_cast<float>((0.01 * percent - lowest) / (highest - lowest));
    const float tick_y_px = y_px + (1.0F - up) * height_px;
    text.bold = percent == 5;  // marks the bound
    canvas.line(x_px + width_px, tick_y_px, x_px + width_px + tick_px, tick_y_px, palette::ink, 2.0F);
    canvas.text(x_px + width_px + 1.5F * tick_px, tick_y_px, fmt::format("{} %", percent), text);
  }
  canvas.text(x_px, y_px - 1.2F * style.caption.measured_px, "stretch", text_style(style.caption.measured_px));
}

/// Draws the moments with one camera, in the view direction of the first moment's scene and as near as all cloths and
/// their shadows allow. Throws renderer::ContextError.
Prints print_moments(LazyOffscreenRenderer& lazy, std::span<const PrintedMoment> moments, const glm::ivec2& size) {
  OffscreenRenderer& offscreen = lazy.open();
  const float scale = lazy.scale();
  const auto scaled = [&](int length_px) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(length_px) * scale)));
  };
  const renderer::Camera camera = camera_for(moments, size);
  Prints prints;
  prints.size_px = size;
  for (const PrintedMoment& moment : moments) {
    DrawnScene scene = scene_for_print(moment, {scaled(size.x), scaled(size.y)});
    const auto usual_passes = static_cast<float>(scene.picture.passes);
    scene.picture.passes =
        static_cast<int>(std::min(std::max(scale * scale * usual_passes, min_print_passes), usual_passes));
    scene.camera.eye = camera.eye;
    scene.camera.target = camera.target;
    GarmentPainter painter(offscreen.renderer(), scene, *moment.recording->garment, named_bodies(scene),
                           moment.recording->pins);
    prints.pictures.push_back(painter.draw(moment.moment->positions, moment.moment->record.time_s));
  }
  const float seen_m = 2.0F * glm::distance(camera.eye, camera.target) * std::tan(0.5F * camera.vertical_fov_rad);
  prints.metre_px = static_cast<float>(size.y) / seen_m;
  return prints;
}

}  // namespace

std::string largest_stretch_text(const PrintedMoment& moment) {
  return fmt::format("largest stretch: springs {:.3g} %, surface {:.3g} %", 100.0 * moment.moment->record.stretch.max,
                     100.0 * moment.moment->record.surface_stretch.max);
}

Drawing make_sheet(std::vector<Panel> panels, const glm::ivec2& size, const SheetStyle& style, const ScaleBar& bar) {
  const std::size_t columns = std::min(style.columns, panels.size());
  const glm::vec2 last_in_row = panel_corner(style, size, columns - 1);
  const glm::vec2 last = panel_corner(style, size, panels.size() - 1);
  Drawing drawing;
  drawing.width_px = size.x + static_cast<int>(last_in_row.x + style.right_px + style.border_px);
  drawing.height_px = size.y + static_cast<int>(last.y + style.caption.height_px() + 0.5F * style.border_px);
  const auto shared = std::make_shared<const std::vector<Panel>>(std::move(panels));
  drawing.draw = [shared, style, size, bar](renderer::Canvas& canvas) {
    for (std::size_t i = 0; i < shared->size(); ++i) {
      const Panel& panel = (*shared)[i];
      const glm::vec2 corner = panel_corner(style, size, i);
      canvas.image(corner.x, corner.y, static_cast<float>(size.x), static_cast<float>(size.y), panel.picture);
      draw_caption(canvas, panel.caption, corner.x + 0.5F * static_cast<float>(size.x),
                   corner.y + static_cast<float>(size.y), style.caption);
    }
    if (bar.length_px > 0.0F) {
      const float inset_px = 0.045F * static_cast<float>(size.x);
      const glm::vec2 corner = panel_corner(style, size, 0);
      draw_scale_bar(canvas, bar, {corner.x + inset_px, corner.y + static_cast<float>(size.y) - inset_px},
                     style.caption.measured_px);
    }
  };
  return drawing;
}

std::string moments_csv(std::span<const Recording* const> recordings) {
  CsvTable table(moment_columns);
  for_each_panel(recordings, [&](const std::string& panel, const Recording& recording, const Moment& moment) {
    const FrameRecord& record = moment.record;
    const sim::SurfaceStretch& surface = moment.record.surface_stretch;
    table.add(panel, recording.scene.name, record.frame, record.time_s, record.asleep, record.stretch.max,
              record.stretch.p99, surface.max, surface.p99, record.stretch.mean);
  });
  return table.text();
}

std::string shapes_csv(std::span<const Recording* const> recordings) {
  CsvTable table(shape_columns);
  for_each_panel(recordings, [&](const std::string& panel, const Recording&, const Moment& moment) {
    for (std::size_t v = 0; v < moment.positions.size(); ++v) {
      const sim::Vec3& p = moment.positions[v];
      table.add(panel, v, p.x, p.y, p.z);
    }
  });
  return table.text();
}

// Figure 2: simulation of cloth falling under the effect of gravity.
Drawing draw_figure2(const Results& results, LazyOffscreenRenderer& offscreen) {
  const Recording& fall = results.fall->frames;
  std::vector<PrintedMoment> moments;
  for (const Moment& moment : fall.moments) moments.push_back({&fall, &moment, false});
  Prints prints = print_moments(offscreen, moments, {720, 620});
  const auto caption_of = [](const PrintedMoment& moment, char letter) -> Caption {
    const FrameRecord& record = moment.moment->record;
    return {letter, fmt::format("{:.2f} s{}", record.time_s, record.asleep ? ", at rest" : ""),
            fmt::format("largest stretch {:.3f} %", 100.0 * record.stretch.max)};
  };
  return make_sheet(make_panels(prints, moments, caption_of), prints.size_px,
                    {.columns = 4, .caption = {.text_px = 48.0F, .measured_px = 42.0F}},
                    {0.5F * prints.metre_px, "0.5 m"});
}

// Figure 4: over-stretching of the same cloth, pinned at its upper corners, with two stretch limits. The lower row
// shows the stretch.
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
  Prints prints = print_moments(offscreen, moments, pinned_size);
  const renderer::Colour shade = mean_shade(prints.pictures.back());
  moments.pop_back();
  const SheetStyle style = {.columns = 2, .caption = {.text_px = 42.0F, .measured_px = 37.0F}, .right_px = 190.0F};
  Drawing drawing = make_sheet(make_panels(prints, moments, pinned_caption), prints.size_px, style,
                               {0.25F * prints.metre_px, "25 cm"});
  drawing.draw = [panels_drawing = drawing.draw, style, shade](renderer::Canvas& canvas) {
    panels_drawing(canvas);
    draw_stretch_legend(canvas, style, shade);
  };
  return drawing;
}

// Figure 5: the T-shirt without wind and in two winds.
Drawing draw_figure5(const Results& results, LazyOffscreenRenderer& offscreen) {
  std::vector<PrintedMoment> moments;
  for (const auto& recording : results.shirts) moments.push_back({&*recording, &recording->last(), false});
  Prints prints = print_moments(offscreen, moments, {980, 860});
  const auto caption_of = [](const PrintedMoment& moment, char letter) -> Caption {
    const FrameRecord& record = moment.moment->record;
    const double speed_m_per_s = moment.recording->scene.surroundings.forces.wind.speed_m_per_s;
    const std::string wind = speed_m_per_s == 0.0 ? "gravity alone" : fmt::format("wind {:.1f} m/s", speed_m_per_s);
    return {letter, fmt::format("{}, after {:.1f} s", wind, record.time_s),
            fmt::format("stretch: springs {:.3f} %, surface {:.3f} %", 100.0 * record.stretch.max,
                        100.0 * record.surface_stretch.max)};
  };
  return make_sheet(make_panels(prints, moments, caption_of), prints.size_px,
                    {.columns = 3, .caption = {.text_px = 50.0F, .measured_px = 43.0F}},
                    {0.2F * prints.metre_px, "20 cm"});
}

Drawing sheet_of_last(std::span<const Recording> recordings, std::span<const Caption> captions, const glm::ivec2& size,
                      const SheetStyle& style, bool has_floor, LazyOffscreenRenderer& offscreen) {
  std::vector<PrintedMoment> moments;
  for (const Recording& recording : recordings) moments.push_back({&recording, &recording.last(), false, has_floor});
  Prints prints = print_moments(offscreen, moments, size);
  const auto caption_of = [&](const PrintedMoment&, char letter) {
    return captions[static_cast<std::size_t>(letter - 'a')];
  };
  return make_sheet(make_panels(prints, moments, caption_of), prints.size_px, style, {0.1F * prints.metre_px, "10 cm"});
}

DrawnScene set_fabric(DrawnScene scene, const std::string& fabric) {
  apply_overrides(std::vector<Override>{{"cloth.fabric", fabric, "--fabric " + fabric}}, scene);
  scene.title = find_fabric(fabric).name;
  return scene;
}

}  // namespace taut::app
