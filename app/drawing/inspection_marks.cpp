#include "app/drawing/inspection_marks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "app/drawing/drawing.hpp"
#include "app/drawing/spring_colours.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

const renderer::Colour border_colour = renderer::rgb(0x1C1C1C);
const renderer::Colour non_manifold_colour = renderer::rgb(0xD00000);
const renderer::Colour misoriented_colour = renderer::rgb(0x7B2CBF);
const renderer::Colour hanger_colour = renderer::rgb(0xB8860B);
const renderer::Colour joined_colour = renderer::rgb(0xFFD000);

// Fraction of vertices. If more were welded, they are not marked: in a model without shared vertices all
// would be.
constexpr double most_joined = 0.3;

void add_line(const LoadedGarment& loaded, const sim::Edge& ends, InspectionMarks& marks) {
  for (const sim::Index end : ends) {
    marks.points.emplace_back(loaded.garment->mesh.positions[end]);
  }
}

InspectionMarks springs_of(const LoadedGarment& loaded, sim::SpringKind kind, float width_px) {
  const sim::Springs& springs = loaded.garment->springs;
  InspectionMarks marks{.meaning = fmt::format("{} springs: {}", sim::name_of(kind), springs.count(kind)),
                        .colour = spring_colour(kind),
                        .width_px = width_px};
  for (std::size_t s = springs.begin_of(kind); s < springs.end_of(kind); ++s) {
    add_line(loaded, springs.ends[s], marks);
  }
  return marks;
}

bool is_misoriented(const sim::Garment& garment, std::size_t edge) {
  const auto triangles = garment.adjacency.edge_triangles[edge];
  return triangles.size() == 2 &&
         sim::runs_along(garment.mesh.triangles[triangles[0]], garment.adjacency.edges[edge]) ==
             sim::runs_along(garment.mesh.triangles[triangles[1]], garment.adjacency.edges[edge]);
}

template <class Chosen>
InspectionMarks edges_where(const LoadedGarment& loaded, InspectionMarks marks, const Chosen& chosen) {
  const sim::Adjacency& adjacency = loaded.garment->adjacency;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (chosen(e)) {
      add_line(loaded, adjacency.edges[e], marks);
    }
  }
  marks.meaning = fmt::format("{}: {}", marks.meaning, marks.points.size() / 2);
  return marks;
}

// Positions that several vertices of the file have: the two sides of its seams, or equal layers.
InspectionMarks joined_vertices(const LoadedGarment& loaded, float diameter_px) {
  InspectionMarks marks{
      .meaning = "", .colour = joined_colour, .width_px = diameter_px, .dots = true, .seen_through = false};
  if (!loaded.model || !loaded.placement) {
    return marks;
  }
  std::vector<sim::Vec3> places = loaded.model->positions;
  const auto before = [](const sim::Vec3& a, const sim::Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(places.begin(), places.end(), before);
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] == places[i - 1] && (i == 1 || places[i] != places[i - 2])) {
      marks.points.emplace_back((*loaded.placement)(places[i]));
    }
  }
  if (static_cast<double>(marks.points.size()) >
      most_joined * static_cast<double>(loaded.garment->mesh.positions.size())) {
    marks.points.clear();
  }
  marks.meaning = fmt::format("several vertices in the file: {}", marks.points.size());
  return marks;
}

InspectionMarks crossing_triangles(const LoadedGarment& loaded, std::span<const CrossingPair> crossings) {
  InspectionMarks marks{.meaning = fmt::format("pairs of triangles that cross: {}", crossings.size()),
                        .colour = crossing_colour,
                        .width_px = 5.0F,
                        .seen_through = true};
  for (const CrossingPair& pair : crossings) {
    for (const sim::Index triangle : {pair.first, pair.second}) {
      const sim::Triangle& t = loaded.garment->mesh.triangles[triangle];
      add_line(loaded, {t[0], t[1]}, marks);
      add_line(loaded, {t[1], t[2]}, marks);
      add_line(loaded, {t[2], t[0]}, marks);
    }
  }
  return marks;
}

InspectionMarks hanger_of(const LoadedGarment& loaded) {
  InspectionMarks marks{
      .meaning = "hanger", .colour = hanger_colour, .width_px = 10.0F, .opacity = 0.8F, .seen_through = true};
  for (const sim::Body& bar : loaded.hanger) {
    const auto& capsule = std::get<sim::Capsule>(bar.shape);
    marks.points.insert(marks.points.end(), {glm::vec3(capsule.start_m), glm::vec3(capsule.end_m)});
  }
  return marks;
}

}  // namespace

void add_marks(const std::vector<InspectionMarks>& all, renderer::FrameView& frame) {
  for (const InspectionMarks& marks : all) {
    if (marks.dots) {
      // Outlined, they stand out from springs of any colour.
      frame.points.push_back({.centres = marks.points,
                              .colours = std::span(&palette::ink, 1),
                              .diameter_px = marks.width_px + 2.0F * mark_outline_px,
                              .hidden_by_surfaces = !marks.seen_through});
      frame.points.push_back({.centres = marks.points,
                              .colours = std::span(&marks.colour, 1),
                              .diameter_px = marks.width_px,
                              .hidden_by_surfaces = !marks.seen_through});
    } else {
      frame.lines.push_back({.points = marks.points,
                             .colours = std::span(&marks.colour, 1),
                             .width_px = marks.width_px,
                             .opacity = marks.opacity,
                             .hidden_by_surfaces = !marks.seen_through});
    }
  }
}

std::vector<InspectionMarks> inspection_marks(const LoadedGarment& loaded,
                                              std::span<const CrossingPair> crossings,
                                              const MarkWidths& widths) {
  const float spring_width_px = widths.spring_px;
  const sim::Adjacency& adjacency = loaded.garment->adjacency;
  std::vector<InspectionMarks> all;
  // Flexural springs lie under the structural ones they skip along: wider, they show on both sides, and pale,
  // they leave those to be seen.
  all.push_back(springs_of(loaded, sim::SpringKind::flexural, 2.4F * spring_width_px));
  all.back().opacity = 0.45F;
  all.push_back(springs_of(loaded, sim::SpringKind::shear, spring_width_px));
  all.push_back(springs_of(loaded, sim::SpringKind::structural, spring_width_px));
  all.push_back(edges_where(
      loaded, {.meaning = "edges of a border", .colour = border_colour, .width_px = 3.0F + spring_width_px},
      [&](std::size_t e) { return adjacency.edge_triangles[e].size() == 1; }));
  all.push_back(edges_where(loaded,
                            {.meaning = "edges whose sides disagree about the outside",
                             .colour = misoriented_colour,
                             .width_px = 5.0F,
                             .seen_through = true},
                            [&](std::size_t e) { return is_misoriented(*loaded.garment, e); }));
  all.push_back(edges_where(loaded,
                            {.meaning = "edges with more than two triangles",
                             .colour = non_manifold_colour,
                             .width_px = 6.0F,
                             .seen_through = true},
                            [&](std::size_t e) { return adjacency.edge_triangles[e].size() > 2; }));
  all.push_back(crossing_triangles(loaded, crossings));
  all.push_back(joined_vertices(loaded, widths.dot_px));
  all.push_back(hanger_of(loaded));
  std::erase_if(all, [](const InspectionMarks& marks) { return marks.points.empty(); });
  return all;
}

}  // namespace taut::app
