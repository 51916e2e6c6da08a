#include "sim/local_wind.hpp"

#include "sim/mesh/preconditions.hpp"

namespace taut::sim {
namespace {

/// Axes of the cells, right-handed: `upwards` and `sideways` across the wind, and `along` it.
struct WindAxes {
  explicit WindAxes(const Vec3& direction) : along(glm::normalize(direction)) {
    make_perpendicular(along, sideways, upwards);
  }
  Vec3 in_axes(const Vec3& v) const { return {glm::dot(v, upwards), glm::dot(v, sideways), glm::dot(v, along)}; }

  Vec3 along, sideways = Vec3(0.0), upwards = Vec3(0.0);
};

/// Cells in rows along the wind, with the blocked fraction of their cross-section. Places are counted in cells: across,
/// across, along. The cloth is inside, with a cell around it and the way to a lee before it.
class ShelterCells {
 public:
  ShelterCells(const Vec3& lowest_m, const Vec3& highest_m) {
    Vec3 counts = count_cells(lowest_m, highest_m);
    while (counts.x * counts.y * counts.z > max_shelter_cells) {
      cell_m_ *= 2.0;
      counts = count_cells(lowest_m, highest_m);
    }
    for (int axis = 0; axis < 3; ++axis) counts_[axis] = static_cast<std::size_t>(counts[axis]);
    blocked_.resize(counts_[0] * counts_[1] * counts_[2]);
  }

  double cell_m() const { return cell_m_; }
  Vec3 place(const Vec3& in_axes_m) const { return in_axes_m / cell_m_ - origin_; }

  /// Blocks an area at a place in the cells.
  void block(const Vec3& place, double area_m2) {
    const NearCells near = near_cells(place);
    const auto fraction = static_cast<float>(area_m2 / (cell_m_ * cell_m_));
    for (std::size_t row = 0; row < 4; ++row) {
      float* cell = &blocked_[near.first[row]];
      cell[0] += fraction * near.weight[row] * (1.0F - near.along);
      cell[1] += fraction * near.weight[row] * near.along;
    }
  }

  /// Blocks an area of a body. Upwind of the cells it counts in the first ones; beside or downwind of them, nowhere.
  void block_from_outside(const Vec3& place, double area_m2) {
    const Vec3 inside = {place.x, place.y, std::max(place.z, 0.0)};
    for (int axis = 0; axis < 3; ++axis) {
      if (!(inside[axis] >= 0.0 && inside[axis] < static_cast<double>(counts_[axis]) - 1.0)) return;
    }
    block(inside, area_m2);
  }

  /// Sums all that is blocked up to each cell.
  void accumulate() {
    for (std::size_t first = 0; first < blocked_.size(); first += counts_[2]) {
      float sum = 0.0F;
      for (std::size_t k = first; k < first + counts_[2]; ++k) {
        sum = std::min(1.0F, sum + blocked_[k]);
        blocked_[k] = sum;
      }
    }
  }

  /// Returns the blocked fraction, from 0 to 1, at a place in the cells.
  float blocked(const Vec3& place) const {
    const NearCells near = near_cells(place);
    float sum = 0.0F;
    for (std::size_t row = 0; row < 4; ++row) {
      const float* cell = &blocked_[near.first[row]];
      sum += near.weight[row] * (cell[0] + near.along * (cell[1] - cell[0]));
    }
    return sum;
  }

  /// Calls `visitor(x, y)` for all rows within `radius` of the rectangle from `a` to `b`.
  template <typename Visitor> void for_rows(const Vec3& a, const Vec3& b, double radius, const Visitor& visitor) const {
    const auto range = [&](int axis) {
      const double last = static_cast<double>(counts_[axis]) - 1.0;
      return std::pair(std::ceil(std::max(std::min(a[axis], b[axis]) - radius, 0.0)),
                       std::floor(std::min(std::max(a[axis], b[axis]) + radius, last)));
    };
    const auto [first_x, last_x] = range(0);
    const auto [first_y, last_y] = range(1);
    for (double x = first_x; x <= last_x; x += 1.0) {
      for (double y = first_y; y <= last_y; y += 1.0) visitor(x, y);
    }
  }

 private:
  /// The eight cells around a place, two in each of four rows, with weights of linear interpolation.
  struct NearCells {
    std::array<std::size_t, 4> first;
    std::array<float, 4> weight;
    float along;  ///< weight of the second cell of each row
  };

  Vec3 count_cells(const Vec3& lowest_m, const Vec3& highest_m) {
    origin_ = glm::floor(lowest_m / cell_m_) - Vec3(1.0, 1.0, std::ceil(lee_begins_cells) + 1.0);
    return glm::floor(highest_m / cell_m_) - origin_ + 2.0;
  }

  NearCells near_cells(const Vec3& place) const {
    const auto x = static_cast<std::size_t>(place.x), y = static_cast<std::size_t>(place.y);
    const auto z = static_cast<std::size_t>(place.z);
    assert(x + 1 < counts_[0] && y + 1 < counts_[1] && z + 1 < counts_[2]);
    const auto right = static_cast<float>(place.x - static_cast<double>(x));
    const auto up = static_cast<float>(place.y - static_cast<double>(y));
    const std::size_t first = (x * counts_[1] + y) * counts_[2] + z;
    const std::size_t next_x = counts_[1] * counts_[2];
    return {{first, first + counts_[2], first + next_x, first + next_x + counts_[2]},
            {(1.0F - right) * (1.0F - up), (1.0F - right) * up, right * (1.0F - up), right * up},
            static_cast<float>(place.z - static_cast<double>(z))};
  }

  double cell_m_ = shelter_cell_m;
  Vec3 origin_ = Vec3(0.0);
  std::array<std::size_t, 3> counts_ = {};
  std::vector<float> blocked_;
};

/// Returns the fraction by which a face with this cosine to the wind blocks it.
double blocked_fraction(double cosine) {
  return std::clamp((cosine - min_blocking_cosine) / (max_blocking_cosine - min_blocking_cosine), 0.0, 1.0) * cosine;
}

/// Calls `block(place, area_m2)` at points of a triangle, at least one for the area of a cell, with what they take from
/// the wind. `corners` are places. A body's triangle blocks from its outside.
template <typename Block>
void block_triangle(const ShelterCells& cells, const std::array<Vec3, 3>& corners, bool is_body, const Block& block) {
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
  const Vec3 doubled = glm::cross(a, b);
  const double size = glm::length(doubled);
  if (!(size > 0.0)) return;
  const double blocked = blocked_fraction((is_body ? -doubled.z : std::abs(doubled.z)) / size);
  if (!(blocked > 0.0)) return;
  const double area_m2 = 0.5 * size * blocked * cells.cell_m() * cells.cell_m();
  if (0.5 * size <= 1.0) {
    block(corners[0] + (a + b) * (1.0 / 3.0), area_m2);
    return;
  }
  const int parts = static_cast<int>(std::min(std::ceil(std::sqrt(0.5 * size)), max_parts_of_edge));
  const double each_m2 = area_m2 / (parts * parts);
  const Vec3 right = a / static_cast<double>(parts), up = b / static_cast<double>(parts);
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; i + j < parts; ++j) {
      const Vec3 first = corners[0] + static_cast<double>(i) * right + static_cast<double>(j) * up;
      block(first + (right + up) / 3.0, each_m2);
      if (i + j + 1 < parts) block(first + (right + up) * (2.0 / 3.0), each_m2);
    }
  }
}

/// Blocks a capsule, or a sphere as one without length, in the middle of its body.
void block_capsule(ShelterCells& cells, const Vec3& start, const Vec3& end, double start_radius, double end_radius) {
  const double cell_m2 = cells.cell_m() * cells.cell_m();
  const Vec3 axis = end - start;
  const double across = axis.x * axis.x + axis.y * axis.y;
  cells.for_rows(start, end, std::max(start_radius, end_radius) + 0.5, [&](double x, double y) {
    const double along = (x - start.x) * axis.x + (y - start.y) * axis.y;
    const double t = across > 0.0 ? std::clamp(along / across, 0.0, 1.0) : 0.0;
    const Vec3 nearest = start + t * axis;
    const double radius = start_radius + t * (end_radius - start_radius);
    const double inside = radius - glm::length(glm::dvec2(x - nearest.x, y - nearest.y));
    const double blocked = std::clamp(inside + 0.5, 0.0, 1.0);
    if (blocked > 0.0) cells.block_from_outside({x, y, nearest.z}, blocked * cell_m2);
  });
}

void block_mesh(ShelterCells& cells, const WindAxes& axes, const Body& body, double time_s) {
  const BodyMeshData& mesh = *std::get<BodyMesh>(body.shape).data;
  std::vector<Vec3> places(mesh.positions_m.size());
  positions_at(body, time_s, places);
  for (Vec3& place : places) place = cells.place(axes.in_axes(place));
  for (const Triangle& t : mesh.triangles) {
    block_triangle(cells, corner_positions(t, places), true,
                   [&](const Vec3& place, double area_m2) { cells.block_from_outside(place, area_m2); });
  }
}

void block_body(ShelterCells& cells, const WindAxes& axes, const Body& body, double time_s) {
  const auto place = [&](const Vec3& point_m) { return cells.place(axes.in_axes(point_m)); };
  const Shape shape = shape_at(body, time_s);
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    const double radius = sphere->radius_m / cells.cell_m();
    block_capsule(cells, place(sphere->centre_m), place(sphere->centre_m), radius, radius);
  } else if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    block_capsule(cells, place(capsule->start_m), place(capsule->end_m), capsule->start_radius_m / cells.cell_m(),
                  capsule->end_radius_m / cells.cell_m());
  } else if (std::holds_alternative<BodyMesh>(shape)) {
    block_mesh(cells, axes, body, time_s);
  }
}

}  // namespace

std::vector<float> find_wind_fractions(const Garment& garment, std::span<const Vec3> positions_m,
                                       const Surroundings& surroundings, double time_s) {
  assert(positions_m.size() == garment.mesh.positions.size());
  assert(std::isfinite(time_s));
  const Wind& wind = surroundings.forces.wind;
  if (!blows(wind) || positions_m.empty()) return {};
  const WindAxes axes(wind.direction);
  std::vector<Vec3> places(positions_m.size());
  std::transform(positions_m.begin(), positions_m.end(), places.begin(),
                 [&](const Vec3& p) { return axes.in_axes(p); });
  Vec3 lowest_m = places.front(), highest_m = places.front();
  for (const Vec3& place : places) lowest_m = glm::min(lowest_m, place), highest_m = glm::max(highest_m, place);
  ShelterCells cells(lowest_m, highest_m);
  for (Vec3& place : places) place = cells.place(place);
  for (const Triangle& t : garment.mesh.triangles) {
    block_triangle(cells, corner_positions(t, places), false,
                   [&](const Vec3& place, double area_m2) { cells.block(place, area_m2); });
  }
  for (const Body& body : surroundings.bodies) block_body(cells, axes, body, time_s);
  cells.accumulate();
  GustField gusts(wind, time_s);
  std::vector<float> fractions;
  fractions.reserve(garment.mesh.triangles.size());
  for (const Triangle& t : garment.mesh.triangles) {
    const Vec3 middle = (places[t[0]] + places[t[1]] + places[t[2]]) / 3.0;
    const float lee = cells.blocked(middle - Vec3(0.0, 0.0, lee_begins_cells));
    const Vec3 middle_m = (positions_m[t[0]] + positions_m[t[1]] + positions_m[t[2]]) / 3.0;
    fractions.push_back(static_cast<float>(gusts.strength(middle_m)) *
                        (1.0F - static_cast<float>(1.0 - lee_velocity_fraction) * lee));
  }
  return fractions;
}

WindLoad measure_wind(const Garment& garment, const State& state, const Wind& wind, std::span<const float> fractions) {
  if (!blows(wind)) return {};
  // An implicit step of almost no time gives the force now.
  constexpr double no_time_s = 1e-12;
  std::vector<Vec3> forces_n(state.current.size(), Vec3(0.0));
  add_wind_forces(garment, state, wind, fractions, no_time_s, forces_n);
  WindLoad load;
  for (std::size_t v = 0; v < forces_n.size(); ++v) {
    load.force_n += forces_n[v];
    load.power_w += glm::dot(forces_n[v], velocity(state, static_cast<Index>(v)));
  }
  return load;
}

}  // namespace taut::sim
