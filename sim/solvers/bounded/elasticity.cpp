#include "sim/solvers/bounded/elasticity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/solvers/bounded/projection.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

/// With fewer time steps, in 1/s, light cloth does not come to rest.
constexpr double least_steps_per_s = 2.0 * tuning::least_steps_per_s;
/// How often rest shapes follow tension, in 1/s. Less often heavily loaded cloth trembles; more costs more.
constexpr double follows_per_s = tuning::least_steps_per_s / tuning::settled_steps;

struct Law {
  float give_warp, give_weft, half_give_shear;  ///< m/N
  float warp_limit, weft_limit, most;
};

Law law_of(const Material& m, double most) {
  return {static_cast<float>(1.0 / m.tensile_warp_n_per_m), static_cast<float>(1.0 / m.tensile_weft_n_per_m),
          static_cast<float>(0.5 / m.shear_n_per_m),        static_cast<float>(m.warp_limit),
          static_cast<float>(m.weft_limit),                 static_cast<float>(most)};
}

/// A symmetric matrix in the plane of a triangle.
struct InPlane {
  float first, second, mixed;
};

/// In axes turned by the angle with this cosine and sine.
inline InPlane turned(const InPlane& m, float c, float s) {
  const float cc = c * c;
  const float ss = s * s;
  const float cs = c * s;
  return {cc * m.first + 2.0F * cs * m.mixed + ss * m.second,
          ss * m.first - 2.0F * cs * m.mixed + cc * m.second,
          cs * (m.second - m.first) + (cc - ss) * m.mixed};
}

/// The same with its eigenvalues within [0, most].
inline InPlane limited(const InPlane& m, float most) {
  const float mean = 0.5F * (m.first + m.second);
  const float half = 0.5F * (m.first - m.second);
  const float radius = std::max(1e-12F, std::sqrt(half * half + m.mixed * m.mixed));
  const float largest = std::clamp(mean + radius, 0.0F, most);
  const float smallest = std::clamp(mean - radius, 0.0F, most);
  const float middle = 0.5F * (largest + smallest);
  const float turn = 0.5F * (largest - smallest) / radius;
  return {middle + turn * half, middle - turn * half, turn * m.mixed};
}

/// Sets the rest shape that has these strains, laid flat again with its first edge on the first axis.
inline void stretch(const SurfaceBlock& rest, std::size_t k, const InPlane& strain, SurfaceBlock& stretched) {
  const float first = 1.0F + strain.first;
  const float second = 1.0F + strain.second;
  const float mixed = strain.mixed;
  const float determinant = first * second - mixed * mixed;
  const float length = std::sqrt(first * first + mixed * mixed);
  stretched.along_per_m[k] = rest.along_per_m[k] / length;
  stretched.across_per_m[k] = rest.across_per_m[k] * length / determinant;
  stretched.skew_per_m[k] =
      (length * rest.skew_per_m[k] + rest.along_per_m[k] * mixed * (first + second) / length) / determinant;
}

Vec2 warp_of(const Garment& garment, Index triangle) {
  return garment.warps.empty()
             ? upright_in(corners_of(garment.mesh.triangles[triangle], garment.mesh.positions))
             : garment.warps[triangle];
}

}  // namespace

int follows_in(double frame_time_s) {
  return std::max(1, static_cast<int>(std::lround(follows_per_s * frame_time_s)));
}

Elasticity::Elasticity(const Garment& garment, const Layout& layout) : material_(garment.material), relaxation_(relaxation_of(layout)) {
  if (!sim::has_law(material_) || layout.surface.block_count() == 0) {
    return;
  }
  lanes_ = layout.surface;
  all_blocks_.resize(lanes_.block_count());
  std::iota(all_blocks_.begin(), all_blocks_.end(), 0U);
  sums_.resize(lanes_.block_count());
  warps_.resize(lanes_.block_count());
  areas_m2_.resize(lanes_.lane_count());
  areas_at_rows_m2_.resize(layout.row_count());
  before_.resize(layout.row_count());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const SurfaceBlock& block = lanes_.blocks[lane / block_size];
    const std::size_t k = lane % block_size;
    if (lanes_.triangle[lane] == SurfaceLanes::no_triangle) {
      continue;
    }
    areas_m2_[lane] = 0.5F / (block.along_per_m[k] * block.across_per_m[k]);
    const Vec2 warp = warp_of(garment, lanes_.triangle[lane]);
    warps_[lane / block_size].cosine[k] = static_cast<float>(warp.x);
    warps_[lane / block_size].sine[k] = static_cast<float>(warp.y);
    for (const auto& at : block.at) {
      areas_at_rows_m2_[at[k] / 4].x += areas_m2_[lane];
    }
  }
}

void Elasticity::begin_attempt(const Layout& layout, const StartRows& start, const ElasticMemory& memory,
                               double most, ParallelKernels& kernels) {
  std::fill(sums_.begin(), sums_.end(), SurfaceSums{});
  steps_ = 0;
  memory_ = memory;
  most_ = most;
  stretch_rest_shapes(layout, start, kernels);
}

void Elasticity::stretch_rest_shapes(const Layout& layout, const StartRows& start, ParallelKernels& kernels) {
  const Law law = law_of(material_, most_);
  for (std::size_t b = 0; b < lanes_.block_count(); ++b) {
    const SurfaceSums& tension = memory_.tension_n_per_m[b];
    const Warps& warps = warps_[b];
    for (std::size_t k = 0; k < block_size; ++k) {
      const InPlane strain = {std::min(law.warp_limit, law.give_warp * tension.along[k]),
                              std::min(law.weft_limit, law.give_weft * tension.across[k]),
                              law.half_give_shear * tension.mixed[k]};
      stretch(layout.surface.blocks[b], k,
              turned(limited(strain, law.most), warps.cosine[k], -warps.sine[k]), lanes_.blocks[b]);
    }
  }
  kernels.start(start, lanes_);
}

// Between settlings cloth sags with a velocity that it does not have over all: air does not slow that part.
void Elasticity::settle(double interval_s, double dragged, ParallelKernels& kernels, Motion& motion) {
  const auto interval = static_cast<float>(interval_s);
  const auto kept = static_cast<float>(std::max(0.0, 1.0 - 0.5 * tuning::faded_per_s * interval_s)) * interval;
  const auto moved_share = static_cast<float>(1.0 + dragged);
  Float4Array& drift_m_per_s = memory_.drift_m_per_s;
  before_ = motion.current;
  for (std::size_t row = 0; row < before_.size(); ++row) {
    motion.current[row] = scaled_sum(before_[row], drift_m_per_s[row], kept);
  }
  constexpr int sweeps = tuning::settled_steps - 1;
  for (int sweep = 1; sweep <= sweeps; ++sweep) {
    for (const BlockRange& range : lanes_.sweep) {
      kernels.shorten(lanes_, std::span(all_blocks_).subspan(range.begin, range.end - range.begin), 1.0F,
                      sweep < sweeps ? relaxation_ : 1.0F, motion.current.data());
    }
  }
  for (std::size_t row = 0; row < before_.size(); ++row) {
    const Float4 moved = scaled_sum(motion.current[row], before_[row], -1.0F);
    motion.previous[row] = scaled_sum(motion.previous[row], moved, moved_share);
    drift_m_per_s[row] = scaled_sum(Float4{}, moved, 1.0F / interval);
  }
}

void Elasticity::take_out_sagging(double time_step_s, Float4Array& previous) const {
  for (std::size_t row = 0; row < memory_.drift_m_per_s.size(); ++row) {
    previous[row] = scaled_sum(previous[row], memory_.drift_m_per_s[row], static_cast<float>(-time_step_s));
  }
}

// Sums by triangle are one of many that carry the same load; neighbours share it. By row, over the area at it.
Float4Array Elasticity::smoothed(double time_step_s, double frame_time_s) const {
  const auto times = static_cast<float>(0.5 / (time_step_s * frame_time_s));
  std::vector<InPlane> tension(lanes_.lane_count());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    if (areas_m2_[lane] > 0.0F) {
      const SurfaceBlock& block = lanes_.blocks[b];
      const float stretched_m2 = 0.5F / (block.along_per_m[k] * block.across_per_m[k]);
      const float factor = times / lanes_.mobility_per_kg[lane] * areas_m2_[lane] / stretched_m2;
      const SurfaceSums& sums = sums_[b];
      tension[lane] = turned({factor * sums.along[k], factor * sums.across[k], factor * sums.mixed[k]},
                             warps_[b].cosine[k], warps_[b].sine[k]);
    }
  }
  Float4Array rows;
  for (int pass = 0; pass < tuning::settled_steps; ++pass) {
    rows.assign(areas_at_rows_m2_.size(), Float4{});
    for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
      const InPlane& t = tension[lane];
      const float area = areas_m2_[lane];
      for (const auto& at : lanes_.blocks[lane / block_size].at) {
        Float4& row = rows[at[lane % block_size] / 4];
        row = {row.x + area * t.first, row.y + area * t.second, row.z + area * t.mixed, 0.0F};
      }
    }
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const float area = areas_at_rows_m2_[row].x;
      const float per_area = area > 0.0F ? 1.0F / (3.0F * area) : 0.0F;
      rows[row] = scaled_sum(Float4{}, rows[row], per_area);
    }
    if (pass + 1 < tuning::settled_steps) {
      for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
        const auto& at = lanes_.blocks[lane / block_size].at;
        const std::size_t k = lane % block_size;
        const Float4 sum = scaled_sum(scaled_sum(rows[at[0][k] / 4], rows[at[1][k] / 4], 1.0F),
                                      rows[at[2][k] / 4], 1.0F);
        tension[lane] = {sum.x, sum.y, sum.z};
      }
    }
  }
  return rows;
}

// What sweeps of one step have to correct is strain = 2 mobility tension dt^2.
double Elasticity::steps_needed_per_s() const {
  double load = 0.0;
  double strain_per_s2 = 0.0;
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const SurfaceSums& t = memory_.tension_n_per_m[lane / block_size];
    const std::size_t k = lane % block_size;
    const double tension = std::max({0.0F, t.along[k], t.across[k]});
    load += areas_m2_[lane] * tension;
    strain_per_s2 += areas_m2_[lane] * tension * 2.0 * lanes_.mobility_per_kg[lane] * tension;
  }
  return load > 0.0
             ? std::max(least_steps_per_s, std::sqrt(strain_per_s2 / load / tuning::largest_strain_per_step))
             : least_steps_per_s;
}

void Elasticity::follow(const Layout& layout, const StartRows& start, double time_step_s,
                        ParallelKernels& kernels) {
  const double time_s = time_step_s * steps_;
  const auto taken = static_cast<float>(time_s / (time_s + tuning::remembered_s));
  const Float4Array rows = smoothed(time_step_s, time_s);
  for (std::size_t b = 0; b < lanes_.block_count(); ++b) {
    SurfaceSums& tension = memory_.tension_n_per_m[b];
    const auto& at = lanes_.blocks[b].at;
    for (std::size_t k = 0; k < block_size; ++k) {
      const Float4 sum = scaled_sum(scaled_sum(rows[at[0][k] / 4], rows[at[1][k] / 4], 1.0F),
                                    rows[at[2][k] / 4], 1.0F);
      tension.along[k] += taken * (sum.x - tension.along[k]);
      tension.across[k] += taken * (sum.y - tension.across[k]);
      tension.mixed[k] += taken * (sum.z - tension.mixed[k]);
    }
  }
  std::fill(sums_.begin(), sums_.end(), SurfaceSums{});
  steps_ = 0;
  stretch_rest_shapes(layout, start, kernels);
}

}  // namespace taut::sim::bounded
