#include "app/models/placement.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

#include "app/models/hanging.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

// Sizes that a guessed unit may give.
constexpr double smallest_garment_m = 0.2;
constexpr double largest_garment_m = 2.5;
// Sizes, from a glove to a tent, with which the file's own unit is believed.
constexpr double smallest_believed_m = 0.02;
constexpr double largest_believed_m = 20.0;
// A model must be this many times longer along z than along y for z to be up. Skirts can be wide, so 1 is too
// little.
constexpr double clearly_longer = 2.0;
// Fractions. The share of the area that has to be carried by openings at the top for an axis to be up.
constexpr double most_of_area = 0.5;
// Height of a model that lies on its back, of its size.
constexpr double lying_height = 0.1;
// Distance from the origin, as a multiple of the model's size. Farther away, single precision is worse than
// 0.1 mm on a garment, and the model is moved.
constexpr double far_away = 1000.0;

sim::Extent extent_of_triangles(const sim::Mesh& mesh) {
  sim::Extent extent;
  for (const sim::Triangle& t : mesh.triangles) {
    for (const sim::Index v : t) {
      extent.add(mesh.positions[v]);
    }
  }
  return extent;
}

bool is_between(double value, double lowest, double highest) {
  return value >= lowest && value <= highest;
}

std::string unit_name(double metres) {
  for (const Unit& unit : units) {
    // Files give their factor in single precision.
    if (std::abs(unit.metres - metres) < 1e-6 * metres) {
      return unit.name;
    }
  }
  return fmt::format("{:.6g} m", metres);
}

void choose_unit(double size, const PlacementHints& hints, Placement& placement) {
  if (hints.asked_scale) {
    placement.scale = *hints.asked_scale;
    placement.unit_text = unit_name(placement.scale) + ", as asked for";
    return;
  }
  std::string why = "guessed from its size";
  if (hints.metres_per_unit) {
    const double size_m = size * *hints.metres_per_unit;
    if (is_between(size_m, smallest_believed_m, largest_believed_m)) {
      placement.scale = *hints.metres_per_unit;
      placement.unit_text = unit_name(placement.scale) + ", as the file says";
      return;
    }
    why = fmt::format("guessed, since the file's own, {}, would make it {:.3g} m large",
                      unit_name(*hints.metres_per_unit), size_m);
  }
  for (const Unit& unit : std::span(units).first(4)) {
    if (is_between(size * unit.metres, smallest_garment_m, largest_garment_m)) {
      placement.scale = unit.metres;
      placement.guessed = unit.metres != 1.0;
      placement.unit_text = unit_name(unit.metres) + ", " + why;
      return;
    }
  }
  placement.scale = 1.0 / size;
  placement.guessed = true;
  placement.unit_text =
      fmt::format("{:.4g} m, so that it is 1 m large; {} ({:.4g} units)", placement.scale, why, size);
}

void choose_up(const sim::Vec3& size, const PlacementHints& hints, Placement& placement) {
  const auto name = [](ModelAxis axis) { return std::string(axis_names[static_cast<std::size_t>(axis)]); };
  if (hints.asked_up || hints.up) {
    placement.up = hints.asked_up ? *hints.asked_up : *hints.up;
    placement.up_text = name(placement.up) + (hints.asked_up ? ", as asked for" : ", as the file says");
    return;
  }
  if (hints.up_by_openings && *hints.up_by_openings != ModelAxis::y) {
    placement.up = *hints.up_by_openings;
    placement.guessed = true;
    placement.up_text = name(placement.up) + ", guessed from where its openings are";
    return;
  }
  if (!hints.up_by_openings && size.z > clearly_longer * size.y) {
    placement.up = ModelAxis::z;
    placement.guessed = true;
    placement.up_text = fmt::format("z, guessed: it measures {:.3g} along z, {:.3g} along y",
                                    size.z * placement.scale, size.y * placement.scale);
    return;
  }
  placement.up_text = "y, as in most files";
}

sim::Vec3 turned(const sim::Vec3& p, ModelAxis up) {
  switch (up) {
    case ModelAxis::x:
      return {-p.y, p.x, p.z};
    case ModelAxis::minus_x:
      return {p.y, -p.x, p.z};
    case ModelAxis::y:
      return p;
    case ModelAxis::minus_y:
      return {p.x, -p.y, -p.z};
    case ModelAxis::z:
      return {p.x, p.z, -p.y};
    case ModelAxis::minus_z:
      return {p.x, -p.z, p.y};
  }
  return p;
}

/// The openings at the top of a model, if this axis is up.
struct TopOpenings {
  double share = 0.0;  ///< of the area, that they carry
  double width = 0.0;  ///< of the one that carries most
};

TopOpenings top_openings(const sim::Mesh& mesh, const sim::Adjacency& adjacency, ModelAxis up) {
  sim::Mesh upright{{}, mesh.triangles, {}};
  for (const sim::Vec3& position : mesh.positions) {
    upright.positions.push_back(turned(position, up));
  }
  TopOpenings found;
  double area = 0.0, largest = 0.0;
  for (const HungPart& part : hang(upright, adjacency).parts) {
    area += part.area_m2;
    if (part.by == HungBy::top_opening || part.by == HungBy::neck) {
      found.share += part.area_m2;
      if (part.area_m2 > largest) {
        largest = part.area_m2;
        found.width = part.opening_m;
      }
    }
  }
  found.share /= area;
  return found;
}

}  // namespace

std::optional<ModelAxis> up_by_openings(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  const TopOpenings y = top_openings(mesh, adjacency, ModelAxis::y);
  const TopOpenings z = top_openings(mesh, adjacency, ModelAxis::z);
  const sim::Vec3 size = sim::extent_of(mesh.positions).size();
  if (size.y <= lying_height * std::max(size.x, size.z) && !(y.share >= most_of_area)) {
    const TopOpenings minus_z = top_openings(mesh, adjacency, ModelAxis::minus_z);
    if (minus_z.share >= most_of_area && (z.share < most_of_area || minus_z.width < z.width)) {
      return ModelAxis::minus_z;
    }
  }
  if ((y.share >= most_of_area) == (z.share >= most_of_area)) {
    return std::nullopt;
  }
  return y.share >= most_of_area ? ModelAxis::y : ModelAxis::z;
}

sim::Vec3 Placement::operator()(const sim::Vec3& in_file) const {
  return turned(in_file * scale, up) + moved_m;
}

Placement place_model(const sim::Mesh& mesh, const PlacementHints& hints) {
  const sim::Extent box = extent_of_triangles(mesh);
  const sim::Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  Placement placement;
  placement.extent = largest;
  choose_unit(largest, hints, placement);
  choose_up(size, hints, placement);
  placement.is_vast = largest * placement.scale > largest_garment_m;
  const sim::Vec3 middle = box.lower + 0.5 * size;
  if (glm::length(middle / largest) > far_away) {
    placement.moved_m = -turned(middle * placement.scale, placement.up);
  }
  return placement;
}

}  // namespace taut::app
