#include "app/models/hanging/placement.hpp"

#include "app/base/words.hpp"
#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/garments/fitting/following.hpp"
#include "app/models/hanging/garment_measures.hpp"
#include "app/models/hanging/hanging.hpp"
#include "app/models/hanging/tuning.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace hanging;

namespace {

/// Fraction of files without a unit that are in each of the units.
constexpr std::array<double, units.size()> unit_shares = {0.40, 0.30, 0.12, 0.07, 0.08, 0.03};

/// Lengths of garments of grown-ups.
struct UsualLength {
  double median_m;
  double spread;  ///< standard deviation of the length's logarithm
};
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

const GarmentPart& largest_part(const std::vector<GarmentPart>& parts) {
  return *std::ranges::max_element(parts, {}, &GarmentPart::area_m2);
}

/// Returns the opening of a bag, such as a hat, a sock or a glove: the only one, in a plane at an end. Else nullptr.
/// `axis` becomes the axis across that plane.
const Opening* bag_opening(const GarmentPart& part, int& axis) {
  const std::vector<const Opening*> openings = large_openings(part);
  if (openings.size() != 1) return nullptr;
  const sim::Vec3 size = part.range.size();
  const sim::Vec3 share = openings[0]->range.size() / glm::max(size, sim::Vec3(std::numeric_limits<double>::min()));
  axis = share.x < std::min(share.y, share.z) ? 0 : share.y <= share.z ? 1 : 2;
  return share[axis] < max_level_steepness && size[axis] > 0.0 ? openings[0] : nullptr;
}

/// Returns the length of a tape around an opening, whose border may be jagged.
double girth(const Opening& opening) { return 2.0 * glm::length(opening.range.size()); }

/// Returns the area of a bag as a multiple of the square of its opening's length.
double bag_area(const GarmentPart& bag, const Opening& opening) {
  return bag.area_m2 / (girth(opening) * girth(opening));
}

GarmentPart find_largest_part(const sim::Mesh& mesh) {
  return largest_part(find_garment_parts(mesh, sim::make_adjacency(mesh)));
}

/// Returns the outer wall of cloth that is modelled with two, at whose openings the walls meet. Returns the mesh if it
/// has openings, or if its wall comes apart.
sim::Mesh outer_wall(const sim::Mesh& mesh) {
  const GarmentPart part = find_largest_part(mesh);
  if (!part.openings.empty()) return mesh;
  sim::Mesh scaled = mesh;
  for (sim::Vec3& position : scaled.positions) position /= part.size_m();
  sim::Mesh wall = find_wall(scaled).sheets.mesh;
  for (sim::Vec3& position : wall.positions) position *= part.size_m();
  return find_largest_part(wall).area_m2 < min_telling_area * part.area_m2 ? mesh : wall;
}

/// Measures of a model in its file's unit, compared with a person's garments.
class PersonalSize {
 public:
  PersonalSize(const sim::Mesh& soup, double size) : sizes_{size, size} {
    const sim::Mesh mesh = outer_wall(sim::weld_and_validate(soup).mesh);
    const std::vector<GarmentPart> parts = find_garment_parts(mesh, sim::make_adjacency(mesh));
    const GarmentPart& part = largest_part(parts);
    double area = 0.0;
    for (const GarmentPart& other : parts) area += other.area_m2;
    part_size = sizes_[1] = part.size_m();
    if (part.area_m2 < min_telling_area * area) return;
    const std::vector<const Opening*> openings = large_openings(part);
    int axis = 0;
    if (bag_opening(part, axis) != nullptr) {
      sizes_.fill(std::sqrt(part.area_m2));
      usual_ = UsualLength{median_bag_m, bag_spread};
    } else if (openings.size() >= 2) {
      std::vector<double> girths = collect<double>(openings, [](const Opening* opening) { return girth(*opening); });
      std::ranges::sort(girths);
      // Cuffs are two, and a single narrower opening is a slit.
      waist_or_cuff_ = girths[girths.size() == 2 ? 0 : 1];
      usual_waist_or_cuff_ =
          girths.size() == 2 ? UsualLength{median_waist_m, waist_spread} : UsualLength{median_cuff_m, cuff_spread};
    }
  }

  /// Returns the logarithm of the likelihood of the unit, up to a constant.
  double likelihood(std::size_t unit) const {
    const auto of = [&](double length, const UsualLength& usual) {
      const double away = std::log(length * units[unit].metres / usual.median_m) / usual.spread;
      return -0.5 * away * away;
    };
    return std::log(unit_shares[unit]) + (waist_or_cuff_ > 0.0 ? of(waist_or_cuff_, usual_waist_or_cuff_) : 0.0) +
           std::max(of(sizes_[0], usual_), std::log(side_by_side_fraction) + of(sizes_[1], usual_));
  }

  double part_size = 0.0;  ///< size of the part with the largest area

 private:
  std::array<double, 2> sizes_;  ///< size of the model, and of that part
  UsualLength usual_ = UsualLength{median_size_m, size_spread};
  double waist_or_cuff_ = 0.0;  ///< girth in the file's unit; 0 if it tells nothing
  UsualLength usual_waist_or_cuff_ = UsualLength{median_cuff_m, cuff_spread};
};

/// Chooses the unit for a model of this size. Returns the size of its largest part, in the file's unit.
double choose_scale(const sim::Mesh& mesh, double size, const PlacementHints& hints, Placement& placement) {
  if (hints.asked_scale) {
    placement.scale = *hints.asked_scale;
    placement.unit_text = unit_name(placement.scale) + ", as asked for";
    return size;
  }
  const PersonalSize personal(mesh, size);
  std::string why = "guessed from its size";
  if (hints.metres_per_unit) {
    const double size_m = size * *hints.metres_per_unit;
    if (is_between(size_m, min_believed_m, max_believed_m)) {
      placement.scale = *hints.metres_per_unit;
      placement.unit_text = unit_name(placement.scale) + ", as the file says";
      return personal.part_size;
    }
    why = fmt::format("guessed, since the file's own, {}, would make it {:.3g} m large",
                      unit_name(*hints.metres_per_unit), size_m);
  }
  std::vector<std::size_t> order;  // of units that give a garment's size, the likeliest first
  for (std::size_t u = 0; u < units.size(); ++u) {
    const auto is_usual = [&](double length) {
      return is_between(length * units[u].metres, min_garment_m, max_garment_m);
    };
    if (is_usual(size) || is_usual(personal.part_size)) order.push_back(u);
  }
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t u) { return personal.likelihood(u); });
  if (!order.empty()) {
    const Unit& unit = units[order[0]];
    placement.scale = unit.metres;
    placement.guessed = unit.metres != 1.0;
    placement.unit_text = std::string(unit.name) + ", " + why;
    if (order.size() > 1 &&
        personal.likelihood(order[1]) > personal.likelihood(order[0]) + std::log(min_second_likelihood)) {
      placement.guessed = true;
      placement.unit_text += fmt::format(" of {:.2g} m; the {} would make it {:.2g} m", size * unit.metres,
                                         units[order[1]].name, size * units[order[1]].metres);
    }
    return personal.part_size;
  }
  placement.scale = 1.0 / size;
  placement.guessed = true;
  placement.unit_text = fmt::format("{:.4g} m, so that it is 1 m large; {} ({:.4g} units)", placement.scale, why, size);
  return personal.part_size;
}

void choose_axis(const sim::Vec3& size, const PlacementHints& hints, Placement& placement) {
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
  } else if (!hints.up_by_openings && !hints.up_by_hanging && size.z > min_z_ratio * size.y) {
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
  constexpr int directions = 64;
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
  return std::ranges::count(is_met, false) <= max_slit_directions;
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
    if (are_apart && over > max_leg_overlap * range.size()[across]) return false;
    for (const auto& ends : curve) {
      const double at = are_apart ? range.middle()[across] : ends[0][across];
      halves[at > middle ? 1 : 0].push_back(ends);
    }
  }
  return goes_around(halves[0]) && goes_around(halves[1]);
}

/// Returns whether the model lies like a flat garment, whose outline says nothing of the levels that go around.
bool is_lying(const sim::Vec3& size) { return size.y <= max_lying_height * std::max(size.x, size.z); }

/// Returns the fraction of the levels in the middle half of the height that the cloth goes all around. It shows how a
/// thick garment with closed borders stands, and an open one too.
double share_around(const sim::Mesh& mesh) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  int around = 0;
  for (int k = 0; k < section_levels && !is_lying(box.size()); ++k) {
    const std::vector<LevelCut> curves = curves_at(mesh, 0.25 + 0.5 * (k + 0.5) / section_levels);
    around += goes_around(joined_up(curves)) || goes_around_halves(curves, false);
  }
  return static_cast<double>(around) / section_levels;
}

/// Returns the number of levels with two legs in the lower half, minus their number in the upper half.
int legs_below(const sim::Mesh& mesh) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  const sim::Vec3 size = box.size();
  int below = 0;
  for (int k = 0; k < section_levels && size.y >= min_leg_height * std::max(size.x, size.z); ++k) {
    const int side = 2 * k + 1 < section_levels ? 1 : 2 * k + 1 > section_levels ? -1 : 0;
    below += goes_around_halves(curves_at(mesh, (k + 0.5) / section_levels), true) ? side : 0;
  }
  return below;
}

/// Returns how much deeper one sees into the model from below than from above, in the middle of its width and depth, as
/// a fraction of its height. Shoulders and waists are at the top, hems below.
double openness_below(const sim::Mesh& mesh) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  sim::Vec3 seen = seen_width * box.size();
  seen[box.size().z > box.size().x ? 0 : 2] *= seen_depth;
  const sim::Vec3 step = seen / static_cast<double>(views_across);
  const SurfaceTree tree(mesh.positions, mesh.triangles);
  double sum = 0.0;
  for (int k = 0; k < views_across * views_across; ++k) {
    const sim::Vec3 at =
        box.middle() - 0.5 * seen + step * sim::Vec3(k / views_across + 0.5, 0.0, k % views_across + 0.5);
    for (const double up : {1.0, -1.0}) {
      const sim::Vec3 from(at.x, up > 0.0 ? box.lower.y : box.upper.y, at.z);
      const auto hit = tree.first_hit(from, {0.0, up, 0.0}, -box.size().y, 2.0 * box.size().y, accept_all);
      sum += up * (hit ? hit->distance_m : box.size().y);
    }
  }
  return sum / (views_across * views_across * std::max(box.size().y, std::numeric_limits<double>::min()));
}

bool has_legs(const sim::Mesh& mesh) { return std::abs(legs_below(mesh)) >= min_leg_levels; }

/// Returns the axis that is up for a hat, which is open below, or a sock, which is open above and bent.
std::optional<ModelAxis> up_of_bag(const GarmentPart& part) {
  int axis = 0;
  const Opening* opening = bag_opening(part, axis);
  if (opening == nullptr) return std::nullopt;
  const double area = bag_area(part, *opening);
  sim::Vec3 aside = part.centre_m - opening->range.middle();
  aside[axis] = 0.0;
  const sim::Vec3 size = opening->range.size();
  const auto [narrow, wide] = std::minmax(size[(axis + 1) % 3], size[(axis + 2) % 3]);
  // The opening of a tote bag is long and narrow.
  const bool is_hat = area < max_hat_area && narrow > min_hat_roundness * wide;
  const bool is_sock = area > min_sock_area && glm::length(aside) > min_sock_bend * part.size_m();
  if (!is_hat && !is_sock) return std::nullopt;
  const bool is_positive = (opening->range.middle()[axis] > part.range.middle()[axis]) == is_sock;
  return static_cast<ModelAxis>(2 * axis + (is_positive ? 0 : 1));
}

/// Returns 1 if the openings show that the part stands upright, -1 if they show that it stands on its head. Of two in
/// the middle the longer one is a hem, and below; a single one is a waist, and above the level openings of legs.
int upright_by_openings(const GarmentPart& part) {
  const int across = part.across();
  std::vector<const Opening*> middle;
  double legs_m = 0.0;
  std::size_t legs = 0;
  const std::vector<const Opening*> openings = large_openings(part);
  for (const Opening* opening : openings) {
    const bool is_level = opening->range.size().y <= max_level_steepness * opening->range.size()[across];
    const double out_m = std::abs(opening->range.middle()[across] - part.range.middle()[across]);
    if (out_m < max_middle_offset * part.width_m()) {
      if (!is_level) return 0;
      middle.push_back(opening);
    } else if (is_level) {
      ++legs;
      legs_m += opening->mean_height_m;
    }
  }
  double above_m = 0.0;
  if (middle.size() == 2) {
    std::ranges::sort(middle, {}, [](const Opening* opening) { return girth(*opening); });
    if (girth(*middle[1]) < min_hem_ratio * girth(*middle[0])) return 0;
    above_m = middle[0]->mean_height_m - middle[1]->mean_height_m;
  } else if (middle.size() == 1 && legs == 2) {
    above_m = middle[0]->mean_height_m - legs_m / 2.0;
  }
  return std::abs(above_m) < min_opening_distance * part.range.size().y ? 0 : above_m > 0.0 ? 1 : -1;
}

/// Returns the length of a tight tape around the cloth at a fraction of the height.
double tape_at(const sim::Mesh& mesh, double share) {
  const sim::Extent box = sim::compute_extent(mesh.positions);
  std::vector<sim::Vec2> points;
  for (const SectionCurve& curve :
       cut_section({mesh.positions, mesh.triangles}, {{0.0, box.lower.y + share * box.size().y, 0.0}})) {
    points.insert(points.end(), curve.points_m.begin(), curve.points_m.end());
  }
  return tight_tape_m(std::move(points));
}

/// Returns 1 if the cloth is clearly narrower at its upper end, and not wider farther below; -1 if it is so at its
/// lower end. A hem that ends in points is narrow at its end alone.
int narrower_end(const sim::Mesh& mesh) {
  const auto is_narrower = [&](double end, double inner) {
    return tape_at(mesh, end) < max_taper * tape_at(mesh, 1.0 - end) &&
           tape_at(mesh, inner) < tape_at(mesh, 1.0 - inner);
  };
  return is_narrower(0.98, 0.75) ? 1 : is_narrower(0.02, 0.25) ? -1 : 0;
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
  return {collect<sim::Vec3>(mesh.positions, [&](const sim::Vec3& p) { return turn_up(p, up); }), mesh.triangles, {}};
}

ModelAxis better_way_up(const sim::Mesh& mesh, const sim::Adjacency& adjacency, ModelAxis up) {
  const auto down = static_cast<ModelAxis>(static_cast<int>(up) ^ 1);
  const sim::Mesh stood = upright(mesh, up);
  const std::vector<GarmentPart> parts = find_garment_parts(stood, adjacency);
  const GarmentPart& part = largest_part(parts);
  int axis = 0;
  if (bag_opening(part, axis) != nullptr) return up;
  int side = upright_by_openings(part);
  if (side == 0 && has_legs(stood)) side = legs_below(stood);
  const double openness = side == 0 ? openness_below(stood) : 0.0;
  if (std::abs(openness) > (up == ModelAxis::y ? min_view_difference_of_y : min_view_difference))
    side = openness > 0.0 ? 1 : -1;
  if (side == 0) side = narrower_end(stood);
  return side < 0 ? down : up;
}

std::optional<ModelAxis> up_by_openings(const sim::Mesh& model) {
  const sim::Mesh mesh = outer_wall(model);
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  if (const auto up = up_of_bag(largest_part(find_garment_parts(mesh, adjacency)))) return up;
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

Placement choose_unit(const sim::Mesh& mesh, const PlacementHints& hints) {
  const sim::Vec3 size = extent_of_triangles(mesh).size();
  Placement placement;
  placement.extent = std::max({size.x, size.y, size.z});
  const double part = choose_scale(mesh, placement.extent, hints, placement);
  placement.is_vast = part * placement.scale > max_garment_m;
  return placement;
}

void choose_up(const sim::Mesh& mesh, const PlacementHints& hints, Placement& placement) {
  const sim::Extent box = extent_of_triangles(mesh);
  choose_axis(box.size(), hints, placement);
  const sim::Vec3 middle = box.lower + 0.5 * box.size();
  if (glm::length(middle / placement.extent) > max_origin_distance_ratio) {
    placement.moved_m = -turn_up(middle * placement.scale, placement.up);
  }
}

Placement place_model(const sim::Mesh& mesh, const PlacementHints& hints) {
  Placement placement = choose_unit(mesh, hints);
  choose_up(mesh, hints, placement);
  return placement;
}

}  // namespace taut::app
