#include "app/drawing/blocked_picture.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "app/drawing/drawing.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/drawing/inspection_marks.hpp"

namespace taut::app {
namespace {

constexpr float dot_px = 13.0F;
/// From near by, so many mean edges can be seen to each side of the place.
constexpr double edges_around = 3.0;

DrawnScene from_near(const DrawnScene& asked, const sim::Simulation& simulation, const sim::Vec3& place_m) {
  DrawnScene scene = asked;
  const glm::vec3 centre(place_m);
  const glm::vec3 around(static_cast<float>(edges_around * sim::mean_edge_m(simulation.garment().springs)));
  scene.camera.eye.reset();
  scene.camera.target.reset();
  scene.camera.box = renderer::Box{centre - around, centre + around};
  return scene;
}

std::vector<InspectionMarks> marks_of(const sim::Simulation& simulation, const sim::BlockedContact& blocked) {
  InspectionMarks outlines{.meaning = "", .colour = crossing_colour, .width_px = 5.0F, .seen_through = true};
  InspectionMarks dots{
      .meaning = "", .colour = crossing_colour, .width_px = dot_px, .dots = true, .seen_through = true};
  dots.points.emplace_back(blocked.place_m);
  for (const sim::ContactSide& side : blocked.sides) {
    const std::vector<sim::Index>& v = side.vertices;
    for (std::size_t k = 0; k < v.size() && v.size() > 1; ++k) {
      outlines.points.emplace_back(simulation.state().current[v[k]]);
      outlines.points.emplace_back(simulation.state().current[v[(k + 1) % v.size()]]);
    }
  }
  return {outlines, dots};
}

std::vector<std::string> wrapped(const renderer::Canvas& canvas, const std::string& text,
                                 const renderer::TextStyle& style, float most_px) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back() + (lines.back().empty() ? "" : " ") + word;
    if (canvas.measure(longer, style).width_px > most_px && !lines.back().empty()) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

renderer::Image draw_marked(renderer::SceneRenderer& renderer, DrawnScene scene,
                            const sim::Simulation& simulation, const std::vector<InspectionMarks>& marks) {
  scene.picture.smooth = false;
  GarmentPainter painter(renderer, scene, simulation.garment(), simulation.pins().vertices);
  renderer::FrameView frame = painter.view(simulation.state().current, simulation.state().time_s);
  add_marks(marks, frame);
  return renderer.draw(frame, scene.picture.settings);
}

}  // namespace

renderer::Image draw_blocked(renderer::SceneRenderer& renderer, const DrawnScene& scene,
                             const sim::Simulation& simulation, const sim::BlockedContact& blocked,
                             const std::string& text) {
  const std::vector<InspectionMarks> marks = marks_of(simulation, blocked);
  const auto width_px = static_cast<float>(scene.picture.settings.width_px);
  const renderer::TextStyle style = text_style(0.02F * width_px);
  const float border_px = style.size_px;
  const float row_px = 1.5F * style.size_px;
  const std::vector<std::string> lines =
      wrapped(renderer::Canvas(1, 1), text, style, 2.0F * (width_px - border_px));
  const float header_px = static_cast<float>(lines.size()) * row_px + border_px;
  renderer::Canvas canvas(2 * scene.picture.settings.width_px,
                          static_cast<int>(header_px) + scene.picture.settings.height_px);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    canvas.text(border_px, row_px * static_cast<float>(k + 1), lines[k], style);
  }
  canvas.image(0.0F, header_px, draw_marked(renderer, scene, simulation, marks));
  canvas.image(width_px, header_px,
               draw_marked(renderer, from_near(scene, simulation, blocked.place_m), simulation, marks));
  return canvas.to_image();
}

}  // namespace taut::app
