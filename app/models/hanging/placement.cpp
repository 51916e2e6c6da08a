#include "app/models/hanging/placement.hpp"

#include <fmt/core.h>

#include "app/garments/fitting/following.hpp"
#include "app/models/hanging/garment_measures.hpp"
#include "app/models/hanging/hanging.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

// Range of sizes that a guessed unit may give.
constexpr double min_garment_m = 0.2;
constexpr double max_garment_m = 2.5;
// Range of sizes of most garments of grown-ups.
constexpr double min_personal_m = 0.45;
constexpr double max_personal_m = 1.7;
// Smallest size of the largest part of one garment. Otherwise there are several garments side by side.
constexpr double min_part_m = 0.1;
// Range of sizes, from a glove to a tent, with which the file's own unit is accepted.
constexpr double min_believed_m = 0.02;
constexpr double max_believed_m = 20.0;
// Smallest ratio of the lengths along z and along y for z to be up. Skirts can be wide, so that 1 is too small.
constexpr double clearly_longer = 2.0;
// Fractions. Smallest fraction of the area that openings at the top have to carry for an axis to be up.
constexpr double min_carried_area_fraction = 0.5;
// Smallest fraction of the area that has large openings for the rest to be a stand or a body.
constexpr double min_open_area_fraction = 0.4;
// Smallest excess, over another axis, of the fraction of levels that the cloth goes all around.
constexpr double min_around_excess = 0.3;
// Smallest difference of the depths of view from above and from below for a model to stand on its head, as a fraction
// of its height; then the same although y is up, as in most files.
constexpr double head_below = 0.01;
constexpr double upside_down = 0.03;
// Largest height of a model that lies on its back, as a fraction of its size.
constexpr double lying_height = 0.1;
// Smallest length of a section that goes around, in longer sides of its box. Cloth that only goes along it is shorter.
constexpr double min_around_length_ratio = 1.5;
// Smallest excess of levels with two legs in the lower half over the upper half, of 11 levels.
constexpr int clearly_legs = 3;
constexpr int level_count = 11;
// Largest reach of a leg over the middle between both, as a fraction of its width.
constexpr double max_share_over_middle = 0.25;
// Smallest height of trousers, as a fraction of their larger size across.
constexpr double min_leg_share = 0.7;
// Largest height of a bag's opening, as a fraction of the bag's.
constexpr double level_opening = 0.4;
// Distance from the origin beyond which the model is moved, as a multiple of its size. There single precision is worse
// than 0.1 mm on a garment.
constexpr double max_origin_distance_ratio = 1000.0;

sim::Extent extent_of_triangles(const sim::Mesh& mesh) {
  sim::Extent extent;
  for (const sim::Triangle& t : mesh.triangles) {
    for (const sim::Index v : t) extent.add(mesh.positions[v]);
  }
  return extent;
}

bool is_between(double value, double lowest, double highest) { return value >= lowest && value <= highest; }

std::string unit_name(double metres) {
  for (const Unit& unit : units) {
    // Files give their factor in single precision.
    if (std::abs(unit.metres - metres) < 1e-6 * metres) return unit.name;
  }
  return fmt::format("{:.6g} m", metres);
}

/// Returns the size of the largest part whose triangles share positions.
double size_of_largest_part(const sim::Mesh& mesh) {
  sim::Groups parts = sim::find_pieces(mesh);
  std::map<sim::Index, sim::Extent> boxes;
  for (const sim::Triangle& t : mesh.triangles) {
    for (const sim::Index v : t) boxes[parts.find(v)].add(mesh.positions[v]);
  }
  double max_size = 0.0;
  for (const auto& [first, box] : boxes) {
    const sim::Vec3 size = box.size();
    max_size = std::max({max_size, size.x, size.y, size.z});
  }
  return max_size;
}

bool is_personal(double size_m) { return is_between(size_m, min_personal_m, max_personal_m); }

/// Returns the inch or the foot if it gives the garment a person's size.
const Unit* imperial_unit(double size) {
  const auto found =
      std::ranges::find_if(std::span(units).subspan(4), [&](const Unit& u) { return is_personal(size * u.metres); });
  return found == std::span(units).subspan(4).end() ? nullptr : &*found;
}

/// Returns the first unit that gives a usual size to the garment, whose largest part has `part_size`. Otherwise returns
/// one that gives it to the part, for garments side by side, or to the whole, for a model in shreds.
const Unit* unit_by_size(double size, double part_size) {
  const auto is_usual = [](double size_m) { return is_between(size_m, min_garment_m, max_garment_m); };
  const std::span<const Unit> usual_units = std::span(units).first(4);
  const auto find = [&](const auto& fits) {
    const auto found = std::ranges::find_if(usual_units, fits);
    return found == usual_units.end() ? nullptr : &*found;
  };
  const Unit* unit =
      find([&](const Unit& u) { return is_usual(size * u.metres) && part_size * u.metres >= min_part_m; });
  unit = unit != nullptr ? unit : find([&](const Unit& u) { return is_usual(part_size * u.metres); });
  unit = unit != nullptr ? unit : find([&](const Unit& u) { return is_usual(size * u.metres); });
  return unit != nullptr ? unit
                         : find([&](const Unit& u) { return is_between(size * u.metres, min_part_m, max_garment_m); });
}

void choose_unit(double size, double part_size, const PlacementHints& hints, Placement& placement) {
  if (hints.asked_scale) {
    placement.scale = *hints.asked_scale;
    placement.unit_text = unit_name(placement.scale) + ", as asked for";
    return;
  }
  std::string why = "guessed from its size";
  if (hints.metres_per_unit) {
    const double size_m = size * *hints.metres_per_unit;
    if (is_between(size_m, min_believed_m, max_believed_m)) {
      placement.scale = *hints.metres_per_unit;
      placement.unit_text = unit_name(placement.scale) + ", as the file says";
      return;
    }
    why = fmt::format("guessed, since the file's own, {}, would make it {:.3g} m large",
                      unit_name(*hints.metres_per_unit), size_m);
  }
  const Unit* unit = unit_by_size(size, part_size);
  const Unit* other = unit != nullptr && unit->metres == 1.0 ? nullptr : imperial_unit(size);
  // Few files are in inches, so that they have to give the likelier size.
  if (other != nullptr && (unit == nullptr || !is_personal(size * unit->metres))) std::swap(unit, other);
  if (unit != nullptr) {
    placement.scale = unit->metres;
    placement.guessed = unit->metres != 1.0;
    placement.unit_text = unit_name(unit->metres) + ", " + why;
    if (other != nullptr) {
      placement.unit_text += fmt::format(" of {:.2g} m; the {} would make it {:.2g} m", size * unit->metres,
                                         other->name, size * other->metres);
    }
    return;
  }
  placement.scale = 1.0 / size;
  placement.guessed = true;
  placement.unit_text = fmt::format("{:.4g} m, so that it is 1 m large; {} ({:.4g} units)", placement.scale, why, size);
}

void choose_up(const sim::Vec3& size, const PlacementHints& hints, Placement& placement) {
  const auto name = [](ModelAxis axis) { return std::string(axis_names[static_cast<std::size_t>(axis)]); };
  if (hints.asked_up || hints.up) {
    placement.up = hints.asked_up ? *hints.asked_up : *hints.up;
    placement.up_text = name(placement.up) + (hints.asked_up ? ", as asked for" : ", as the file says");
    return;
  }
  placement.up_text = "y, as in most files";
  const auto guess = [&](ModelAxis up, const std::string& why) {
    placement.up = up;
    placement.guessed = true;
    placement.up_text = name(up) + ", guessed" + why;
  };
  if (hints.up_by_openings && *hints.up_by_openings != ModelAxis::y) {
    guess(*hints.up_by_openings, " from where its openings are");
  } else if (hints.up_by_hanging && *hints.up_by_hanging != ModelAxis::y) {
    guess(*hints.up_by_hanging, ": hung that way it is higher and its cloth moves less");
  } else if (!hints.up_by_openings && !hints.up_by_hanging && size.z > clearly_longer * size.y) {
    guess(ModelAxis::z, fmt::format(": it measures {:.3g} along z, {:.3g} along y", size.z * placement.scale,
                                    size.y * placement.scale));
  }
}

sim::Vec3 turn_up(const sim::Vec3& p, ModelAxis up) {
  struct AxisTurn {
    std::array<int, 3> axis;  ///< axis of the model, for each axis of the scene
    sim::Vec3 sign;
  };
  static constexpr std::array<AxisTurn, 6> turns = {{{{1, 0, 2}, {-1, 1, 1}},
                                                     {{1, 0, 2}, {1, -1, 1}},
                                                     {{0, 1, 2}, {1, 1, 1}},
                                                     {{0, 1, 2}, {1, -1, -1}},
                                                     {{0, 2, 1}, {1, 1, -1}},
                                                     {{0, 2, 1}, {1, -1, 1}}}};  // by ModelAxis
  const auto& [axis, sign] = turns[static_cast<std::size_t>(up)];
  return sign * sim::Vec3(p[axis[0]], p[axis[1]], p[axis[2]]);
}

using LevelCut = std::vector<std::array<sim::Vec3, 2>>;

/// Returns the curves at a fraction of the height.
std::vector<LevelCut> curves_at(const sim::Mesh& mesh, double share) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  const CuttingPlane plane = {{0.0, box.lower.y + share * box.size().y, 0.0}};
  std::vector<LevelCut> curves;
  for (const SectionCurve& curve : cut_section({mesh.positions, mesh.triangles}, plane)) {
    const std::size_t count = curve.points_m.size();
    LevelCut& segments = curves.emplace_back();
    for (std::size_t k = 0; k + (curve.is_closed ? 0 : 1) < count; ++k) {
      segments.push_back({place_in(plane, curve.points_m[k]), place_in(plane, curve.points_m[(k + 1) % count])});
    }
  }
  return curves;
}

LevelCut joined_up(const std::vector<LevelCut>& curves) {
  LevelCut all;
  for (const LevelCut& curve : curves) all.insert(all.end(), curve.begin(), curve.end());
  return all;
}

sim::Extent section_range(const LevelCut& section) {
  sim::Extent box;
  for (const auto& [a, b] : section) {
    box.add(a);
    box.add(b);
  }
  return box;
}

/// Returns whether the section goes all around its middle. It is scaled to equal width and depth, so that a section
/// that is pressed flat counts too.
bool goes_around(const LevelCut& section) {
  constexpr int directions = 64, max_slit_width = 6;
  std::array<bool, directions> is_met{};
  const sim::Extent box = section_range(section);
  const sim::Vec3 middle = box.middle(), size = box.size();
  double length = 0.0;
  for (const auto& [a, b] : section) length += glm::distance(a, b);
  if (!(size.x > 0.0 && size.z > 0.0 && length >= min_around_length_ratio * std::max(size.x, size.z))) return false;
  const auto direction_of = [&](const sim::Vec3& p) {
    const double angle = std::atan2((p.z - middle.z) / size.z, (p.x - middle.x) / size.x);
    return angle / (2.0 * std::numbers::pi) * directions;
  };
  for (const auto& [a, b] : section) {
    const double from = direction_of(a);
    const double turn = std::remainder(direction_of(b) - from, static_cast<double>(directions));
    for (int k = 0; k <= static_cast<int>(std::ceil(std::abs(turn))); ++k) {
      const double at = from + std::copysign(std::min<double>(k, std::abs(turn)), turn);
      is_met[static_cast<std::size_t>(std::floor(at) + directions) % directions] = true;
    }
  }
  return std::ranges::count(is_met, false) <= max_slit_width;
}

/// Returns whether the curves go around both halves, as around legs. Halves are apart if no curve belongs to both.
bool goes_around_halves(const std::vector<LevelCut>& curves, bool are_apart) {
  const sim::Extent box = section_range(joined_up(curves));
  const int across = box.size().z > box.size().x ? 2 : 0;
  const double middle = box.middle()[across];
  std::array<LevelCut, 2> halves;
  for (const LevelCut& curve : curves) {
    const sim::Extent range = section_range(curve);
    const double over = std::min(middle - range.lower[across], range.upper[across] - middle);
    if (are_apart && over > max_share_over_middle * range.size()[across]) return false;
    for (const auto& ends : curve) {
      const double at = are_apart ? range.middle()[across] : ends[0][across];
      halves[at > middle ? 1 : 0].push_back(ends);
    }
  }
  return goes_around(halves[0]) && goes_around(halves[1]);
}

/// Returns whether the model lies like a flat garment, whose outline says nothing of the levels that go around.
bool is_lying(const sim::Vec3& size) { return size.y <= lying_height * std::max(size.x, size.z); }

/// Returns the fraction of the levels in the middle half of the height that the cloth goes all around. It shows how a
/// thick garment with closed borders stands, and an open one too.
double share_around(const sim::Mesh& mesh) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  int around = 0;
  for (int k = 0; k < level_count && !is_lying(box.size()); ++k) {
    const std::vector<LevelCut> curves = curves_at(mesh, 0.25 + 0.5 * (k + 0.5) / level_count);
    around += goes_around(joined_up(curves)) || goes_around_halves(curves, false);
  }
  return static_cast<double>(around) / level_count;
}

/// Returns the number of levels with two legs in the lower half, minus their number in the upper half.
int legs_below(const sim::Mesh& mesh) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  const sim::Vec3 size = box.size();
  int below = 0;
  for (int k = 0; k < level_count && size.y >= min_leg_share * std::max(size.x, size.z); ++k) {
    const int side = 2 * k + 1 < level_count ? 1 : 2 * k + 1 > level_count ? -1 : 0;
    below += goes_around_halves(curves_at(mesh, (k + 0.5) / level_count), true) ? side : 0;
  }
  return below;
}

/// Returns how much deeper one sees into the model from below than from above, in the middle of its width and depth, as
/// a fraction of its height. Shoulders and waists are at the top, hems below.
double openness_below(const sim::Mesh& mesh) {
  constexpr int across = 24;
  const sim::Extent box = sim::compute_extent(mesh.positions);
  sim::Vec3 seen = 0.5 * box.size();
  seen[box.size().z > box.size().x ? 0 : 2] *= 0.4;
  const sim::Vec3 step = seen / static_cast<double>(across);
  const SurfaceTree tree(mesh.positions, mesh.triangles);
  double sum = 0.0;
  for (int k = 0; k < across * across; ++k) {
    const sim::Vec3 at = box.middle() - 0.5 * seen + step * sim::Vec3(k / across + 0.5, 0.0, k % across + 0.5);
    for (const double up : {1.0, -1.0}) {
      const sim::Vec3 from(at.x, up > 0.0 ? box.lower.y : box.upper.y, at.z);
      const auto hit = tree.first_hit(from, {0.0, up, 0.0}, -box.size().y, 2.0 * box.size().y, accept_all);
      sum += up * (hit ? hit->distance_m : box.size().y);
    }
  }
  return sum / (across * across * std::max(box.size().y, std::numeric_limits<double>::min()));
}

bool has_legs(const sim::Mesh& mesh) { return std::abs(legs_below(mesh)) >= clearly_legs; }

/// Returns whether the largest part has one opening, at an end. A sock is not worn like a skirt, nor a hat like a sock.
bool is_bag(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  const std::vector<GarmentPart> parts = find_garment_parts(mesh, adjacency);
  const auto largest = std::ranges::max_element(parts, {}, &GarmentPart::area_m2);
  const std::vector<const Opening*> openings = large_openings(*largest);
  return openings.size() == 1 && openings[0]->range.size().y < level_opening * largest->range.size().y;
}

/// Returns the parts with large openings, without stands and bodies. Empty if there are no other parts, or if the open
/// ones are too little of the model.
std::optional<sim::Mesh> open_parts(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Mesh open;
  double open_area = 0.0, area = 0.0;
  for (const GarmentPart& part : find_garment_parts(mesh, adjacency)) {
    area += part.area_m2;
    if (large_openings(part).empty()) continue;
    open_area += part.area_m2;
    for (const sim::Index t : part.triangles) open.triangles.push_back(mesh.triangles[t]);
  }
  if (open.triangles.size() == mesh.triangles.size() || open_area < min_open_area_fraction * area) return std::nullopt;
  std::map<sim::Index, sim::Index> new_index;
  for (sim::Triangle& t : open.triangles) {
    for (sim::Index& v : t) {
      const auto [place, is_new] = new_index.try_emplace(v, open.positions.size());
      if (is_new) open.positions.push_back(mesh.positions[v]);
      v = place->second;
    }
  }
  return open;
}

/// Returns the fraction of the model's area that openings at its top can carry.
double share_carried(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  double area = 0.0, carried = 0.0;
  for (const HungPart& part : hang(mesh, adjacency).parts) {
    area += part.area_m2;
    const bool is_carried = part.by == HungBy::top_opening || part.by == HungBy::neck || part.by == HungBy::straps;
    carried += is_carried ? part.area_m2 : 0.0;
  }
  return carried / area;
}

}  // namespace

sim::Mesh upright(const sim::Mesh& mesh, ModelAxis up) {
  sim::Mesh turned_mesh{{}, mesh.triangles, {}};
  for (const sim::Vec3& position : mesh.positions) turned_mesh.positions.push_back(turn_up(position, up));
  return turned_mesh;
}

ModelAxis better_way_up(const sim::Mesh& mesh, const sim::Adjacency& adjacency, ModelAxis up) {
  const auto down = static_cast<ModelAxis>(static_cast<int>(up) ^ 1);
  const sim::Mesh stood = upright(mesh, up);
  if (has_legs(stood)) return legs_below(stood) > 0 ? up : down;
  const double clearly = up == ModelAxis::y ? upside_down : head_below;
  return !is_bag(stood, adjacency) && openness_below(stood) < -clearly ? down : up;
}

std::optional<ModelAxis> up_by_openings(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  if (const auto cloth = open_parts(mesh, adjacency)) return up_by_openings(*cloth, sim::make_adjacency(*cloth));
  const auto can_hang = [&](ModelAxis up) {
    return share_carried(upright(mesh, up), adjacency) >= min_carried_area_fraction;
  };
  bool is_y = can_hang(ModelAxis::y);
  const bool may_lie = !is_y && is_lying(sim::compute_extent(mesh.positions).size());
  bool is_z = can_hang(ModelAxis::z) || (may_lie && can_hang(ModelAxis::minus_z));
  if (is_y == is_z) {
    const double y = share_around(mesh), z = share_around(upright(mesh, ModelAxis::z));
    const double x = share_around(upright(mesh, ModelAxis::x));
    if (!is_y && x >= y + min_around_excess && x >= z + min_around_excess) {
      return better_way_up(mesh, adjacency, ModelAxis::x);
    }
    is_y = y >= z + min_around_excess;
    is_z = z >= y + min_around_excess;
  }
  if (is_y == is_z) {
    is_y = has_legs(mesh);
    is_z = has_legs(upright(mesh, ModelAxis::z));
  }
  if (is_y == is_z) return std::nullopt;
  return better_way_up(mesh, adjacency, is_z ? ModelAxis::z : ModelAxis::y);
}

sim::Vec3 Placement::operator()(const sim::Vec3& in_file) const { return turn_up(in_file * scale, up) + moved_m; }

Placement place_model(const sim::Mesh& mesh, const PlacementHints& hints) {
  const sim::Extent box = extent_of_triangles(mesh);
  const sim::Vec3 size = box.size();
  const double max_size = std::max({size.x, size.y, size.z});
  Placement placement;
  placement.extent = max_size;
  const double part = size_of_largest_part(mesh);
  choose_unit(max_size, part, hints, placement);
  choose_up(size, hints, placement);
  placement.is_vast = part * placement.scale > max_garment_m;
  const sim::Vec3 middle = box.lower + 0.5 * size;
  if (glm::length(middle / max_size) > max_origin_distance_ratio) {
    placement.moved_m = -turn_up(middle * placement.scale, placement.up);
  }
  return placement;
}

}  // namespace taut::app
