#include "app/garments/dressing/fit.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/dressing/tuning.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/fitting/sheets.hpp"

namespace taut::app {
namespace {

using namespace dressing;

constexpr const char* shoulder_width = "shoulder width";

/// Returns whether cloth at this height belongs to the tube or is so little above it that it lies about the armholes or
/// is the edge of a waist. Folds of worn cloth may end the tube further down.
bool is_about_armholes(double height_m, const GarmentTube& tube) {
  return height_m <= tube.max_height_m + armhole_distance_m;
}

/// A garment on the body that is dressed.
struct Fitting {
  const Wearer& wearer;
  sim::Pose pose;        ///< pose of the body
  double lift_m;         ///< height of the body above its stored pose
  sim::Surface garment;  ///< surface of the garment at its start
  GarmentMarks marks;

  double body_m(const char* name) const {
    const Girth* const girth = find_girth(wearer.measures, name);
    return girth == nullptr ? 0.0 : girth->girth_m;
  }

  void add(const char* name, double garment_m, std::vector<FitRow>& rows) const {
    if (body_m(name) > 0.0 && garment_m > 0.0) rows.push_back({name, body_m(name), garment_m});
  }

  void add_trunk(std::vector<FitRow>& rows) const {
    const std::optional<GarmentTube> tube = find_tube(garment);
    const double top_m = sim::compute_extent(garment.positions_m).upper.y;
    for (const char* name : {"upper chest", "chest", "waist", "seat"}) {
      const Girth* const girth = find_girth(wearer.measures, name);
      if (!tube || girth == nullptr) continue;
      const double height_m = girth->height_m + lift_m;
      const double measured_m = std::min(height_m, tube->max_height_m);
      const bool is_covered = height_m <= top_m + near_edge_m && is_about_armholes(height_m, *tube);
      const std::optional<double> garment_m = is_covered ? girth_at(garment, measured_m) : std::nullopt;
      if (garment_m) {
        const auto& levels = wearer.measures.levels;
        const double held_m = levels.empty() ? 0.0 : wearer.measures.level_at(measured_m - lift_m).girth_m;
        rows.push_back({name, girth->girth_m, *garment_m, measured_m, {}, held_m});
      }
    }
  }

  /// Measures sleeves as if the arms were in them, and the shoulder width between two armholes.
  void add_arms(std::vector<FitRow>& rows) const {
    std::vector<sim::Vec3> armholes_m;
    double armhole_around_m = 0.0, sleeve_m = 0.0;
    for (ArmJoints arm : marks.cuffs.empty() ? std::vector<ArmJoints>{} : find_arms(wearer.joints)) {
      const double length_m = glm::distance(arm.shoulder_m, arm.elbow_m);
      arm.shoulder_m = pose(arm.shoulder_m);
      arm.outwards = pose.rotation * arm.outwards;
      const LimbOpening& cuff = find_nearest_opening(marks.cuffs, arm.shoulder_m);
      const sim::Vec3 way_m = cuff.middle_m - arm.shoulder_m;
      if (glm::length(way_m) < armhole_distance_m) {
        armholes_m.push_back(cuff.middle_m);
        armhole_around_m = cuff.length_m;
        continue;
      }
      const sim::Vec3 along = glm::normalize(way_m);
      const double to_middle_m = std::min(0.5 * length_m, glm::length(way_m) - near_edge_m);
      arm.elbow_m = arm.shoulder_m + length_m * along;
      const auto sleeve = find_ring(garment, {arm.shoulder_m + to_middle_m * along, along});
      // The hem is taken around the arm where short sleeves leave no ring: a plane across the arm cuts the trunk of a
      // wide shirt.
      sleeve_m = sleeve ? sleeve->length_m : cuff.length_m;
      const auto hole = find_armhole(garment, arm, sleeve ? sleeve->tape_m : cuff.length_m);
      armhole_around_m = hole ? hole->length_m : armhole_around_m;
    }
    // The seams of sleeves are not known, so that only a garment without sleeves has a shoulder width.
    add(shoulder_width, armholes_m.size() == 2 ? glm::distance(armholes_m[0], armholes_m[1]) : 0.0, rows);
    add("armhole", armhole_around_m, rows);
    add("upper arm", sleeve_m, rows);
  }

  void add_ends(std::vector<FitRow>& rows) const {
    const BodyMeasures& measures = wearer.measures;
    if (measures.levels.empty()) return;
    // Girths of the body are those of both legs, but a leg warmer goes around one.
    if (marks.top && marks.top_height_m - lift_m < measures.levels[measures.fork].height_m) return;
    // The top of trousers and skirts may be below the body's waist.
    if (marks.is_worn_at_waist && marks.top_m > 0.0) {
      rows.push_back({"waistband", measures.level_at(marks.top_height_m - lift_m).girth_m, marks.top_m});
    }
    const Girth* const thigh = find_girth(measures, "thigh");
    const std::optional<double> leg_m =
        !marks.legs.empty() && thigh != nullptr ? leg_at(garment, thigh->height_m + lift_m) : std::nullopt;
    add("thigh", leg_m.value_or(0.0), rows);
    if (!marks.legs.empty()) {
      const LevelTape& at_end = measures.level_at(marks.legs[0].middle_m.y - lift_m);
      rows.push_back({"leg hem", at_end.largest_curve_m, marks.legs[0].length_m});
    }
    if (marks.hem_height_m) {
      rows.push_back({"hem", measures.level_at(*marks.hem_height_m - lift_m).girth_m, marks.hem_m});
    }
  }
};

/// Returns the side of the wearer on which a place is, seen from the middle.
const char* side_name(const sim::Vec3& from_middle, const sim::Vec3& front) {
  const double forwards = glm::dot(from_middle, front);
  const double left = glm::dot(from_middle, glm::cross(sim::Vec3(0.0, 1.0, 0.0), front));
  if (std::abs(forwards) > std::abs(left)) return forwards > 0.0 ? "in front" : "behind";
  return left > 0.0 ? "on the left" : "on the right";
}

}  // namespace

bool is_too_small(const FitRow& row) { return row.ease_m() < (row.name == shoulder_width ? narrow_below_m : 0.0); }

const char* fit_word(const FitRow& row) {
  const double ease_m = row.ease_m();
  if (row.name == shoulder_width) return is_too_small(row) ? "narrow" : ease_m < wide_from_m ? "fitted" : "wide";
  return is_too_small(row)         ? "too small"
         : ease_m < tight_below_m  ? "tight"
         : ease_m < fitted_below_m ? "fitted"
                                   : "loose";
}

std::string fit_thresholds() {
  return fmt::format("below {:g} cm: tight; below {:g} cm: fitted; else loose", 100.0 * tight_below_m,
                     100.0 * fitted_below_m);
}

std::vector<FitRow> compute_fit(const LoadedBodies& bodies, const sim::Garment& garment,
                                std::span<const sim::Vec3> start_m) {
  const Dressed dressed = dressed_body(bodies);
  std::vector<FitRow> rows;
  if (dressed.wearer == nullptr) return rows;
  const sim::Body& body = bodies.all[dressed.body];
  Fitting fitting = {*dressed.wearer, sim::pose_at(body.motion, 0.0), compute_lift(body, *dressed.wearer),
                     sim::Surface{start_m, garment.mesh.triangles}, find_garment_marks(garment, start_m, {})};
  fitting.marks.is_worn_at_waist = is_worn_at_waist(fitting.marks, dressed.wearer->measures, fitting.lift_m);
  if (!fitting.marks.is_worn_at_waist) fitting.add("neck", fitting.marks.top_m, rows);
  fitting.add_arms(rows);
  if (!fitting.marks.is_open_in_front) fitting.add_trunk(rows);
  fitting.add_ends(rows);
  return rows;
}

void require_wearable(const Scene& scene, std::span<const FitRow> rows) {
  const SolverChoice& solver = scene.simulation.solver;
  if (solver.kind != sim::SolverKind::bounded || solver.bounded.allow_exceeding) return;
  const double max_ratio = 1.0 + solver.bounded.max_stretch;
  std::vector<std::string> tight_rows;
  for (const FitRow& row : rows) {
    if (row.body_at_height_m > 0.0 && row.garment_m * max_ratio < min_girth_ratio * row.body_at_height_m) {
      tight_rows.push_back(fmt::format("{} {:.1f} cm in a garment of {:.1f} cm, which stretches to {:.1f} cm", row.name,
                                       100.0 * row.body_at_height_m, 100.0 * row.garment_m,
                                       100.0 * max_ratio * row.garment_m));
    }
  }
  if (!tight_rows.empty()) {
    throw InputError(
        "the garment cannot be put on: found {}; expected one that goes around the body, stretched by at "
        "most solver.max_stretch = {:g}",
        join(tight_rows), solver.bounded.max_stretch);
  }
}

std::string describe_tightness(const LoadedBodies& bodies, const sim::Garment& garment,
                               std::span<const sim::Vec3> worn_m, std::span<const FitRow> rows) {
  const std::vector<double> stretch = sim::triangle_surface_stretch(garment, worn_m);
  const sim::Vec3 front = front_of_dressed(bodies);
  std::vector<std::pair<double, std::string>> places;
  const auto look = [&](const std::string& name, double from_m, double to_m) {
    std::vector<std::pair<double, sim::Vec3>> near;
    sim::Extent level;
    for (std::size_t t = 0; t < stretch.size(); ++t) {
      const sim::Vec3 middle_m = triangle_middle(worn_m, garment.mesh.triangles[t]);
      if (middle_m.y > from_m && middle_m.y < to_m) {
        near.emplace_back(stretch[t], middle_m);
        level.add(middle_m);
      }
    }
    std::ranges::stable_sort(near, std::greater(), &std::pair<double, sim::Vec3>::first);
    near.resize(static_cast<std::size_t>(tight_triangle_fraction * static_cast<double>(near.size())));
    double mean_stretch = 0.0;
    sim::Vec3 place_m(0.0);
    for (const auto& [tightness, middle_m] : near) {
      mean_stretch += tightness / static_cast<double>(near.size());
      place_m += middle_m / static_cast<double>(near.size());
    }
    if (mean_stretch > min_named_stretch) {
      places.emplace_back(mean_stretch, fmt::format("at the {} {} {:.1f} %", name,
                                                    side_name(place_m - level.middle(), front), 100.0 * mean_stretch));
    }
  };
  sim::Extent measured;
  for (const FitRow& row : rows) {
    if (row.height_m) {
      look(row.name, *row.height_m - girth_band_m, *row.height_m + girth_band_m);
      measured.add({0.0, *row.height_m, 0.0});
    }
  }
  const bool is_of_chest = std::ranges::any_of(
      rows, [](const FitRow& row) { return row.name == "neck" || row.name == "upper chest" || row.name == "chest"; });
  look(is_of_chest ? "shoulders" : "upper end", measured.upper.y + girth_band_m,
       std::numeric_limits<double>::infinity());
  look("lower end", -std::numeric_limits<double>::infinity(), measured.lower.y - girth_band_m);
  std::ranges::stable_sort(places, std::greater(), &std::pair<double, std::string>::first);
  places.resize(std::min(places.size(), max_tight_places));
  const std::vector<std::string> tightest = collect<std::string>(places, &std::pair<double, std::string>::second);
  return tightest.empty() ? "" : "stretched most: " + join(tightest);
}

// Sleeves begin lower than at the start where arms are raised.
void measure_worn(const sim::Garment& garment, std::span<const sim::Vec3> worn_m, std::span<FitRow> rows) {
  const sim::Surface worn_surface = {worn_m, garment.mesh.triangles};
  const std::optional<GarmentTube> tube = find_tube(worn_surface);
  for (FitRow& row : rows) {
    if (!row.height_m || !tube || !is_about_armholes(*row.height_m, *tube)) continue;
    row.worn_m = girth_at(worn_surface, std::min(*row.height_m, tube->max_height_m));
  }
}

std::string describe_worn(std::span<const FitRow> rows) {
  std::vector<std::string> descriptions;
  for (const FitRow& row : rows) {
    if (!row.worn_m) continue;
    descriptions.push_back(fmt::format("{} {:.1f} cm ({:+.1f} %)", row.name, 100.0 * *row.worn_m,
                                       100.0 * (*row.worn_m / row.garment_m - 1.0)));
  }
  return descriptions.empty() ? "" : "worn, it measures: " + join(descriptions) + '\n';
}

std::string describe_misfit(std::span<const FitRow> rows) {
  std::vector<std::string> descriptions;
  for (const FitRow& row : rows) {
    if (!is_too_small(row)) continue;
    descriptions.push_back(
        fmt::format("{} {:.1f} cm in a garment of {:.1f} cm", row.name, 100.0 * row.body_m, 100.0 * row.garment_m));
  }
  return descriptions.empty() ? "" : "; it does not fit: " + join(descriptions);
}

std::string describe(std::span<const FitRow> rows) {
  std::string text = fmt::format("{:14}{:>10}{:>12}{:>12}\n", "", "body", "garment", "ease");
  for (const FitRow& row : rows) {
    text += fmt::format("{:14}{:>7.1f} cm{:>9.1f} cm{:>+9.1f} cm  {}\n", row.name, 100.0 * row.body_m,
                        100.0 * row.garment_m, 100.0 * row.ease_m(), fit_word(row));
  }
  return text;
}

}  // namespace taut::app
