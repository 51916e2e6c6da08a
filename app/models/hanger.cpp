#include "app/models/hanger.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "app/base/errors.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/hood.hpp"
#include "app/verify/solid_bodies.hpp"

namespace taut::app {
namespace {

// A hanger for grown-ups. Of a garment that is narrower it is smaller.
constexpr double half_length_m = 0.2;
constexpr double widest = 0.45;      ///< half its length, of the width of the garment
constexpr double radius = 0.04;      ///< of its bars, of half its length
constexpr double clearance = 0.02;   ///< between bars and cloth at the start, of half its length
constexpr double steepest = 0.5;     ///< by how much shoulders fall, by how far they reach
constexpr double neck_reach = 0.4;   ///< of half its length; there may be a neckline and no shoulder
constexpr double shortening = 0.93;  ///< by which it is shortened until it fits
constexpr double shortest = 0.5;     ///< by the longest
constexpr double lowest = 0.5;       ///< below the shoulders, of half its length; there is no room above it
constexpr double lowering = 0.02;    ///< by which it is moved down until it is clear, of half its length
constexpr double friction = 0.5;     ///< of wood

constexpr const char* left_bar = "hanger, left";
constexpr const char* right_bar = "hanger, right";

/// Where the garment is highest at a distance from its middle.
struct RidgePoint {
  double height_m = -std::numeric_limits<double>::infinity();
  double depth_m = 0.0;
};

/// The garment as seen by a hanger.
struct Wearer {
  const sim::Mesh& mesh;
  const GarmentPart& part;
  double half_m;     ///< half the hanger's length
  double ceiling_m;  ///< what is higher is a hood and no shoulder

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
          if (p.y > ridge.height_m && p.y <= ceiling_m) {
            ridge = {p.y, p[2 - axis]};
          }
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
    const double reach_m = bar.start_radius_m + clearance * half_m;
    const Limb limb{bar.start_m, bar.end_m, reach_m, reach_m};
    return std::none_of(part.triangles.begin(), part.triangles.end(), [&](sim::Index triangle) {
      const sim::Triangle& t = mesh.triangles[triangle];
      return enters_limb({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, limb);
    });
  }
};

/// The line that the hanger's bars follow on both sides, touching the shoulders.
struct ShoulderLine {
  double top_m = 0.0;                           ///< height in the middle
  double fall = 0.0;                            ///< by how far it reaches
  std::array<double, 2> depths_m = {0.0, 0.0};  ///< of its ends
};

/// Empty if the garment has no shoulders at this reach, or steeper ones than any hanger.
std::optional<ShoulderLine> shoulder_line(const Wearer& wearer) {
  constexpr std::array places = {neck_reach, 0.5 * (neck_reach + 1.0), 1.0};
  ShoulderLine line{std::numeric_limits<double>::infinity(), 0.0, {}};
  for (std::size_t side = 0; side < 2; ++side) {
    const double sign = side == 0 ? -1.0 : 1.0;
    const RidgePoint end = wearer.ridge_at(sign * wearer.half_m);
    line.depths_m[side] = end.depth_m;
    for (const double place : places) {
      const double rise_m = wearer.ridge_at(sign * place * wearer.half_m).height_m - end.height_m;
      // Shoulders rise towards the neck; what is lower there is a neckline.
      if (place < 1.0 && rise_m > 0.0) {
        line.fall = std::max(line.fall, rise_m / ((1.0 - place) * wearer.half_m));
      }
    }
    line.top_m = std::min(line.top_m, end.height_m);
  }
  line.top_m += line.fall * wearer.half_m;
  return std::isfinite(line.top_m) && line.fall <= steepest ? std::optional(line) : std::nullopt;
}

std::array<sim::Capsule, 2> bars_along(const ShoulderLine& line, const Wearer& wearer, double below_m) {
  std::array<sim::Capsule, 2> bars;
  const double top_m = line.top_m - below_m, end_m = top_m - line.fall * wearer.half_m;
  const sim::Vec3 middle = wearer.place(0.0, top_m, 0.5 * (line.depths_m[0] + line.depths_m[1]));
  for (std::size_t side = 0; side < 2; ++side) {
    const double beside_m = side == 0 ? -wearer.half_m : wearer.half_m;
    bars[side] = {middle, wearer.place(beside_m, end_m, line.depths_m[side]), radius * wearer.half_m,
                  radius * wearer.half_m};
  }
  return bars;
}

/// The bars as high as they are clear of the cloth; empty if there is no such place below the shoulders.
std::optional<std::array<sim::Capsule, 2>> clear_bars(const Wearer& wearer) {
  const std::optional<ShoulderLine> line = shoulder_line(wearer);
  for (double below_m = 0.0; line && below_m <= lowest * wearer.half_m; below_m += lowering * wearer.half_m) {
    const std::array<sim::Capsule, 2> bars = bars_along(*line, wearer, below_m);
    if (wearer.is_clear(bars[0]) && wearer.is_clear(bars[1])) {
      return bars;
    }
  }
  return std::nullopt;
}

double ceiling_m(const sim::Mesh& mesh, const GarmentPart& part) {
  double highest_m = -std::numeric_limits<double>::infinity();
  for (const sim::Index v : neck_below_hood(mesh, part, part.across())) {
    highest_m = std::max(highest_m, mesh.positions[v].y);
  }
  return std::isfinite(highest_m) ? highest_m : part.range.upper.y;
}

}  // namespace

std::vector<sim::Body> hanger_for(const sim::Mesh& mesh, const GarmentPart& part) {
  const double highest_m = ceiling_m(mesh, part);
  const double longest_m = std::min(half_length_m, widest * part.width_m());
  for (double half_m = longest_m; half_m >= shortest * longest_m; half_m *= shortening) {
    if (const auto bars = clear_bars({mesh, part, half_m, highest_m})) {
      return {{.name = left_bar, .shape = (*bars)[0], .friction = friction},
              {.name = right_bar, .shape = (*bars)[1], .friction = friction}};
    }
  }
  return {};
}

std::vector<sim::Body> make_hanger(const sim::Mesh& mesh) {
  const std::vector<GarmentPart> parts = parts_of(mesh, sim::make_adjacency(mesh));
  const auto smaller = [](const GarmentPart& a, const GarmentPart& b) { return a.area_m2 < b.area_m2; };
  std::vector<sim::Body> hanger = hanger_for(mesh, *std::max_element(parts.begin(), parts.end(), smaller));
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
  const auto* name =
      scene.pins && scene.pins->size() == 1 ? std::get_if<std::string>(&scene.pins->front()) : nullptr;
  return name != nullptr && *name == "hanger";
}

void put_on_hanger(const LoadedGarment& loaded, Scene& scene) {
  if (loaded.hanger.empty()) {
    return;
  }
  scene.pins.emplace();
  for (const sim::Index pin : loaded.hanging ? loaded.hanging->pins : std::vector<sim::Index>{}) {
    if (const auto number = loaded.file_vertices.number_of(pin)) {
      scene.pins->emplace_back(static_cast<sim::Index>(*number));
    }
  }
  std::vector<sim::Body>& bodies = scene.surroundings.bodies;
  bodies.insert(bodies.end(), loaded.hanger.begin(), loaded.hanger.end());
  scene.body_sources.resize(bodies.size());
}

void take_off_hanger(Scene& scene) {
  std::vector<sim::Body>& bodies = scene.surroundings.bodies;
  scene.body_sources.resize(bodies.size());
  for (std::size_t k = bodies.size(); k-- > 0;) {
    if (bodies[k].name == left_bar || bodies[k].name == right_bar) {
      bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(k));
      scene.body_sources.erase(scene.body_sources.begin() + static_cast<std::ptrdiff_t>(k));
      scene.pins.reset();
    }
  }
}

}  // namespace taut::app
