#include "app/models/hanging/hanger.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/hanging/tuning.hpp"
#include "sim/contact/contact_measure.hpp"

namespace taut::app {

using namespace hanging;

namespace {

constexpr const char* right_bar = "hanger, right";

/// Highest point of the garment at a distance from its middle.
struct RidgePoint {
  double height_m = -std::numeric_limits<double>::infinity();
  double depth_m = 0.0;
};

/// A garment and the size of the hanger in it.
struct HangerSpace {
  const sim::Mesh& mesh;
  const GarmentPart& part;
  double half_m;     ///< half the hanger's length
  double ceiling_m;  ///< height above which the garment is a hood and no shoulder
  double max_neckline;

  RidgePoint ridge_at(double beside_m) const {
    const int axis = part.across();
    const double at_m = part.centre_m[axis] + beside_m;
    RidgePoint ridge;
    for (const sim::Index triangle : part.triangles) {
      const sim::Triangle& t = mesh.triangles[triangle];
      for (int k = 0; k < 3; ++k) {
        const sim::Vec3 &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]];
        if ((a[axis] < at_m) != (b[axis] < at_m)) {
          const sim::Vec3 p = a + (at_m - a[axis]) / (b[axis] - a[axis]) * (b - a);
          if (p.y > ridge.height_m && p.y <= ceiling_m) ridge = {p.y, p[2 - axis]};
        }
      }
    }
    return ridge;
  }

  sim::Vec3 place(double beside_m, double height_m, double depth_m) const {
    sim::Vec3 place(0.0, height_m, 0.0);
    place[part.across()] = part.centre_m[part.across()] + beside_m;
    place[2 - part.across()] = depth_m;
    return place;
  }

  bool is_clear(const sim::Capsule& bar) const {
    const double reach_m = bar.start_radius_m + bar_clearance_ratio * half_m;
    const sim::Capsule limb{bar.start_m, bar.end_m, reach_m, reach_m};
    return std::ranges::none_of(part.triangles, [&](sim::Index triangle) {
      return sim::enters(sim::corner_positions(mesh.triangles[triangle], mesh.positions), limb);
    });
  }
};

/// Line of the hanger's bars on both sides, touching the shoulders.
struct ShoulderLine {
  double top_m = 0.0;                           ///< height in the middle
  double fall = 0.0;                            ///< height lost for each metre to the side
  std::array<double, 2> depths_m = {0.0, 0.0};  ///< depths of its ends
};

/// Returns nothing if the garment has no shoulders at this reach, steeper ones than any hanger, or too wide a neckline.
std::optional<ShoulderLine> shoulder_line(const HangerSpace& wearer) {
  const std::array places = {min_shoulder_offset, 0.5 * (min_shoulder_offset + 1.0), 1.0};
  ShoulderLine line{std::numeric_limits<double>::infinity(), 0.0, {}};
  for (std::size_t side = 0; side < 2; ++side) {
    const double sign = side == 0 ? -1.0 : 1.0;
    const RidgePoint end = wearer.ridge_at(sign * wearer.half_m);
    line.depths_m[side] = end.depth_m;
    const auto rise_at = [&](double place) {
      return wearer.ridge_at(sign * place * wearer.half_m).height_m - end.height_m;
    };
    // A wider neckline slides over the ends.
    if (rise_at(wearer.max_neckline) < -max_neckline_depth * wearer.half_m) return std::nullopt;
    for (const double place : places) {
      const double rise_m = rise_at(place);
      // Shoulders rise towards the neck. Points that are lower there belong to a neckline.
      if (place < 1.0 && rise_m > 0.0) {
        line.fall = std::max(line.fall, rise_m / ((1.0 - place) * wearer.half_m));
      }
    }
    line.top_m = std::min(line.top_m, end.height_m);
  }
  line.top_m += line.fall * wearer.half_m;
  return std::isfinite(line.top_m) && line.fall <= max_shoulder_slope ? std::optional(line) : std::nullopt;
}

std::array<sim::Capsule, 2> bars_along(const ShoulderLine& line, const HangerSpace& wearer, double below_m) {
  std::array<sim::Capsule, 2> bars;
  const double top_m = line.top_m - below_m, end_m = top_m - line.fall * wearer.half_m;
  const sim::Vec3 middle = wearer.place(0.0, top_m, 0.5 * (line.depths_m[0] + line.depths_m[1]));
  for (std::size_t side = 0; side < 2; ++side) {
    const double beside_m = side == 0 ? -wearer.half_m : wearer.half_m;
    bars[side] = {middle, wearer.place(beside_m, end_m, line.depths_m[side]), bar_radius_ratio * wearer.half_m,
                  bar_radius_ratio * wearer.half_m};
  }
  return bars;
}

/// Returns the bars in the highest position clear of the cloth; nothing if there is none below the shoulders.
std::optional<std::array<sim::Capsule, 2>> clear_bars(const HangerSpace& wearer) {
  const std::optional<ShoulderLine> line = shoulder_line(wearer);
  for (double below_m = 0.0; line && below_m <= max_bar_lowering * wearer.half_m;
       below_m += bar_lowering_step * wearer.half_m) {
    const std::array<sim::Capsule, 2> bars = bars_along(*line, wearer, below_m);
    if (wearer.is_clear(bars[0]) && wearer.is_clear(bars[1])) return bars;
  }
  return std::nullopt;
}

/// Returns the size along an axis; 0 without points.
double size_along(const sim::Extent& extent, int axis) { return std::max(0.0, extent.size()[axis]); }

/// Returns the width of the part at each level, from its top down.
std::vector<double> find_widths_m(const sim::Mesh& mesh, const GarmentPart& part, int across) {
  const double step_m = part.range.size().y / hood_levels;
  if (!(step_m > 0.0)) return std::vector<double>(hood_levels, 0.0);  // a level part
  std::vector<sim::Extent> spans(hood_levels);
  const auto add_edge = [&](const sim::Vec3& high, const sim::Vec3& low) {
    const auto first = static_cast<int>(std::ceil((part.range.upper.y - high.y) / step_m - 0.5));
    for (int k = std::max(0, first); k < hood_levels; ++k) {
      const double level_m = part.range.upper.y - (k + 0.5) * step_m;
      if (level_m < low.y || high.y <= low.y) break;
      spans[k].add(low + (high - low) * (level_m - low.y) / (high.y - low.y));
    }
  };
  for (const sim::Index triangle : part.triangles) {
    const sim::Triangle& t = mesh.triangles[triangle];
    for (int k = 0; k < 3; ++k) {
      const sim::Vec3 &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]];
      a.y > b.y ? add_edge(a, b) : add_edge(b, a);
    }
  }
  return collect<double>(spans, [&](const sim::Extent& span) { return size_along(span, across); });
}

bool widens_below(const std::vector<double>& widths_m, int level) {
  return level + shoulder_levels < hood_levels && widths_m[level] > 0.0 &&
         widths_m[level + shoulder_levels] >= min_widening_ratio * widths_m[level];
}

/// Returns the last level, from the top, above which the part widens as at shoulders; `levels` if there is none.
int neck_level(const std::vector<double>& widths_m) {
  auto level = static_cast<int>(std::ceil(min_hood_height * hood_levels));
  while (level < hood_levels && !widens_below(widths_m, level)) ++level;
  while (widens_below(widths_m, level + 1)) ++level;
  return level;
}

/// Returns whether the opening is on one side at this height, like a face, and not around the part, like the top of a
/// bodice with straps.
bool is_on_one_side(const sim::Mesh& mesh, const GarmentPart& part, const Opening& opening, double height_m,
                    double band_m) {
  const auto depth_m = [&](const std::vector<sim::Index>& vertices) {
    sim::Extent span;
    for (const sim::Index v : vertices) {
      if (std::abs(mesh.positions[v].y - height_m) <= band_m) span.add(mesh.positions[v]);
    }
    return size_along(span, 2 - part.across());
  };
  return depth_m(opening.vertices) <= max_face_depth_ratio * depth_m(part.vertices);
}

/// Returns whether the only wide opening above the neck is a face's.
bool has_face(const sim::Mesh& mesh, const GarmentPart& part, double neck_m) {
  const double hood_m = part.range.upper.y - neck_m;
  const Opening* face = nullptr;
  for (const Opening& opening : part.openings) {
    if (opening.mean_height_m > neck_m && opening.length_m >= hood_m) {
      if (face != nullptr) return false;
      face = &opening;
    }
  }
  const double above_m = face == nullptr ? 0.0 : face->range.upper.y - std::max(neck_m, face->range.lower.y);
  return above_m >= min_face_height * hood_m && is_on_one_side(mesh, part, *face, neck_m + 0.5 * hood_m, 0.2 * hood_m);
}

}  // namespace

std::vector<sim::Body> hanger_for(const sim::Mesh& mesh, const GarmentPart& part, double min_length_ratio,
                                  double max_neckline) {
  const std::vector<sim::Index> neck = neck_below_hood(mesh, part, part.across());
  const double max_height_m = neck.empty() ? part.range.upper.y : sim::compute_extent(mesh.positions, neck).upper.y;
  const double max_length_m = std::min(max_bar_length_m, max_bar_width_ratio * part.width_m());
  for (double half_m = max_length_m; half_m >= min_length_ratio * max_length_m; half_m *= bar_shortening) {
    if (const auto bars = clear_bars({mesh, part, half_m, max_height_m, max_neckline})) {
      return {{.name = hanger_left, .shape = (*bars)[0], .friction = bar_friction},
              {.name = right_bar, .shape = (*bars)[1], .friction = bar_friction}};
    }
  }
  return {};
}

std::vector<sim::Body> make_hanger(const sim::Mesh& mesh) {
  const std::vector<GarmentPart> parts = find_garment_parts(mesh, sim::make_adjacency(mesh));
  std::vector<sim::Body> hanger =
      hanger_for(mesh, *std::ranges::max_element(parts, {}, &GarmentPart::area_m2), min_asked_bar_ratio, 1.0);
  if (hanger.empty()) {
    throw InputError(
        "pins.at: found no room for a hanger below the garment's shoulders; expected a garment that is "
        "modelled as it is worn");
  }
  return hanger;
}

std::string describe(const std::vector<sim::Body>& hanger) {
  const sim::Vec3 left_m = std::get<sim::Capsule>(hanger.front().shape).end_m;
  const sim::Vec3 right_m = std::get<sim::Capsule>(hanger.back().shape).end_m;
  return fmt::format("it hangs on a hanger that is {:.2g} cm wide", 100.0 * glm::distance(left_m, right_m));
}

bool asks_for_hanger(const Scene& scene) {
  const auto* name = scene.pins && scene.pins->size() == 1 ? std::get_if<std::string>(&scene.pins->front()) : nullptr;
  return name != nullptr && *name == "hanger";
}

void put_on_hanger(const LoadedGarment& loaded, Scene& scene, std::vector<sim::Body>& bodies) {
  if (loaded.hanger.empty()) return;
  scene.pins.emplace();
  for (const sim::Index pin : loaded.hanging ? loaded.hanging->pins : std::vector<sim::Index>{}) {
    if (const auto number = loaded.file_vertices.number_of(pin)) {
      scene.pins->emplace_back(static_cast<sim::Index>(*number));
    }
  }
  for (const sim::Body& bar : loaded.hanger) scene.bodies.push_back({bar});
  bodies.insert(bodies.end(), loaded.hanger.begin(), loaded.hanger.end());
}

void take_off_hanger(Scene& scene, std::vector<sim::Body>& bodies) {
  const auto is_bar = [](const sim::Body& body) { return body.name == hanger_left || body.name == right_bar; };
  std::erase_if(bodies, is_bar);
  if (std::erase_if(scene.bodies, [&](const BodyInScene& entry) { return is_bar(entry.body); }) > 0) scene.pins.reset();
}

std::vector<sim::Index> neck_below_hood(const sim::Mesh& mesh, const GarmentPart& part, int across) {
  const int level = neck_level(find_widths_m(mesh, part, across));
  const double height_m = part.range.size().y;
  const double neck_m = part.range.upper.y - (level + 0.5) * height_m / hood_levels;
  std::vector<sim::Index> neck;
  if (level > max_hood_height * hood_levels || !has_face(mesh, part, neck_m)) return neck;
  for (const sim::Index v : part.vertices) {
    const double above_m = mesh.positions[v].y - neck_m;
    if (above_m >= 0.0 && above_m <= pinned_band_fraction * height_m) neck.push_back(v);
  }
  return carries(part, sim::compute_extent(mesh.positions, neck)) ? neck : std::vector<sim::Index>();
}

}  // namespace taut::app
