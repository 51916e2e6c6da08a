#include "app/bodies/fit.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/bodies/dressing.hpp"
#include "app/bodies/wearing.hpp"
#include "app/models/garment_measures.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

/// A girth so little above a garment is that of its edge.
constexpr double edge_m = 0.02;

/// How much higher the body is when the run begins than it was stored, in m.
double lift_of(const sim::Body& body, const Wearer& wearer) {
  for (const char* joint : {"neck", "hips"}) {
    if (wearer.joints.contains(joint)) {
      return sim::pose_at(body.motion, 0.0)(wearer.joints.at(joint)).y - wearer.stored_joints.at(joint).y;
    }
  }
  return 0.0;
}

}  // namespace

const char* fit_word(const FitRow& row) {
  const double ease_m = row.ease_m();
  return ease_m < too_small_below_m ? "too small"
         : ease_m < tight_below_m   ? "tight"
         : ease_m < fitted_below_m  ? "fitted"
                                    : "loose";
}

std::string fit_thresholds() {
  return fmt::format("below {:g} cm: tight; below {:g} cm: fitted; else loose", 100.0 * tight_below_m,
                     100.0 * fitted_below_m);
}

std::vector<FitRow> fit_of(const Scene& scene, const sim::Garment& garment,
                           std::span<const sim::Vec3> start_m) {
  const Dressed dressed = dressed_body(scene);
  const Surface start = {start_m, garment.mesh.triangles};
  const std::optional<GarmentTube> tube = tube_of(start);
  std::vector<FitRow> rows;
  if (dressed.wearer == nullptr || !tube) {
    return rows;
  }
  const sim::Body& body = scene.surroundings.bodies[dressed.body];
  const double lift_m = lift_of(body, *dressed.wearer);
  const double top_m = sim::extent_of(start_m).upper.y;
  for (const char* name : {"upper chest", "chest", "waist", "seat"}) {
    const Girth* const girth = girth_of(dressed.wearer->measures, name);
    const double height_m = girth == nullptr ? tube->lowest_m - 1.0 : girth->height_m + lift_m;
    // What is above the tube lies about the armholes, or is the edge of a waist.
    const bool is_covered = height_m >= tube->lowest_m && height_m <= top_m + edge_m;
    const double measured_m = std::min(height_m, tube->highest_m);
    const std::optional<double> garment_m = is_covered ? girth_at(start, measured_m) : std::nullopt;
    if (garment_m) {
      rows.push_back({name, girth->girth_m, *garment_m, measured_m});
    }
  }
  const GarmentMarks marks = marks_of(garment, start_m, {});
  const auto& mesh = *std::get<sim::BodyMesh>(body.shape).data;
  const std::optional<LevelTape> at_hem =
      marks.hem_height_m ? level_tape({mesh.positions_m, mesh.triangles}, *marks.hem_height_m - lift_m)
                         : std::nullopt;
  if (at_hem) {
    rows.push_back({"hem", at_hem->girth_m, marks.hem_m});
  }
  return rows;
}

void measure_worn(const sim::Garment& garment, std::span<const sim::Vec3> worn_m, std::span<FitRow> rows) {
  for (FitRow& row : rows) {
    if (row.height_m) {
      row.worn_m = girth_at({worn_m, garment.mesh.triangles}, *row.height_m);
    }
  }
}

std::string describe_worn(std::span<const FitRow> rows) {
  std::string text;
  for (const FitRow& row : rows) {
    if (row.worn_m) {
      text += fmt::format("{}{} {:.1f} cm ({:+.1f} %)", text.empty() ? "worn, it measures: " : ", ", row.name,
                          100.0 * *row.worn_m, 100.0 * (*row.worn_m / row.garment_m - 1.0));
    }
  }
  return text.empty() ? text : text + '\n';
}

std::string describe_misfit(std::span<const FitRow> rows) {
  std::string text;
  for (const FitRow& row : rows) {
    if (row.ease_m() < too_small_below_m) {
      text +=
          fmt::format("{}{} {:.1f} cm in a garment of {:.1f} cm", text.empty() ? "; it does not fit: " : ", ",
                      row.name, 100.0 * row.body_m, 100.0 * row.garment_m);
    }
  }
  return text;
}

std::string describe(std::span<const FitRow> rows) {
  std::string text = fmt::format("{:12}{:>12}{:>12}{:>12}\n", "", "body", "garment", "ease");
  for (const FitRow& row : rows) {
    text += fmt::format("{:12}{:>9.1f} cm{:>9.1f} cm{:>+9.1f} cm  {}\n", row.name, 100.0 * row.body_m,
                        100.0 * row.garment_m, 100.0 * row.ease_m(), fit_word(row));
  }
  return text;
}

}  // namespace taut::app
