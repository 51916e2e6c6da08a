#include "sim/solvers/bounded/elasticity.hpp"

namespace taut::sim::bounded {
namespace {

/// How often rest shapes follow tension, in 1/s. More costs more and gives the same.
constexpr double follows_per_s = tuning::least_updates_per_s / 3.0;
/// How long it takes to hold back what sweeps leave, in s. Less than the drag of the air and of sweeps damps in
/// lets light cloth swing for ever.
constexpr double held_s = 2.0 * tuning::remembered_s;
/// Rest shapes are shorter by no more than this: sweeps move corners by what they are worth at rest, and would
/// correct twice the error of shapes that are a third shorter.
constexpr float most_held = 0.25F;

/// Cloth that is stretched by less than this when it begins goes back within a few time steps.
constexpr float least_begun_with = 0.01F;

struct Law {
  float give_warp, give_weft, half_give_shear;  ///< m/N
  float warp_limit, weft_limit, most;
};

std::vector<Law> laws_of(const std::vector<Material>& materials, double most) {
  std::vector<Law> laws;
  for (const Material& m : materials) {
    laws.push_back({static_cast<float>(1.0 / m.tensile_warp_n_per_m), static_cast<float>(1.0 / m.tensile_weft_n_per_m),
                    static_cast<float>(0.5 / m.shear_n_per_m), static_cast<float>(m.warp_limit),
                    static_cast<float>(m.weft_limit), static_cast<float>(most)});
  }
  return laws;
}

/// In axes turned by the angle with this cosine and sine.
inline InPlane turned(const InPlane& m, float c, float s) {
  const float cc = c * c;
  const float ss = s * s;
  const float cs = c * s;
  return {cc * m.first + 2.0F * cs * m.mixed + ss * m.second, ss * m.first - 2.0F * cs * m.mixed + cc * m.second,
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

InPlane in_plane(const SurfaceSums& sums, std::size_t k) { return {sums.along[k], sums.across[k], sums.mixed[k]}; }

void set(SurfaceSums& sums, std::size_t k, const InPlane& value) {
  sums.along[k] = value.first;
  sums.across[k] = value.second;
  sums.mixed[k] = value.mixed;
}

/// a + factor b.
InPlane sum(const InPlane& a, const InPlane& b, float factor) {
  return {a.first + factor * b.first, a.second + factor * b.second, a.mixed + factor * b.mixed};
}

/// U - 1, where F = R U is of corners that moved since the frame began.
InPlane strain_of(const SurfaceBlock& rest, std::size_t k, const Float4Array& moved) {
  const Float4& corner = moved[rest.at[0][k] / 4];
  const Float4 e1 = scaled_sum(moved[rest.at[1][k] / 4], corner, -1.0F);
  const Float4 e2 = scaled_sum(moved[rest.at[2][k] / 4], corner, -1.0F);
  Float4 along = {rest.start_along[0][k], rest.start_along[1][k], rest.start_along[2][k]};
  Float4 across = {rest.start_across[0][k], rest.start_across[1][k], rest.start_across[2][k]};
  add_scaled(along, e1, rest.along_per_m[k]);
  add_scaled(across, e2, rest.across_per_m[k]);
  add_scaled(across, e1, -rest.skew_per_m[k]);
  const float a = dot(along, along);
  const float b = dot(along, across);
  const float c = dot(across, across);
  const float area = std::sqrt(std::max(0.0F, a * c - b * b));
  const float per_trace = 1.0F / std::sqrt(std::max(1e-12F, a + c + 2.0F * area));
  return {(a + area) * per_trace - 1.0F, (c + area) * per_trace - 1.0F, b * per_trace};
}

/// Cosine and sine of the angle to the axis of the larger eigenvalue.
std::pair<float, float> principal_axes(const InPlane& m) {
  const float half = 0.5F * (m.first - m.second);
  const float radius = std::sqrt(half * half + m.mixed * m.mixed);
  if (radius < 1e-12F) return {1.0F, 0.0F};
  const float doubled = std::clamp(half / radius, -1.0F, 1.0F);
  const float sine = std::sqrt(0.5F * (1.0F - doubled));
  return {std::sqrt(0.5F * (1.0F + doubled)), m.mixed < 0.0F ? -sine : sine};
}

/// By tension along warp and weft and in shear.
inline InPlane strain_by(const Law& law, const InPlane& tension) {
  return limited({std::min(law.warp_limit, law.give_warp * tension.first),
                  std::min(law.weft_limit, law.give_weft * tension.second), law.half_give_shear * tension.mixed},
                 law.most);
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
  return garment.warps.empty() ? upright_in(corners_of(garment.mesh.triangles[triangle], garment.mesh.positions))
                               : garment.warps[triangle];
}

}  // namespace

int follows_in(double frame_time_s) { return std::max(1, static_cast<int>(std::lround(follows_per_s * frame_time_s))); }

Elasticity::Elasticity(const Garment& garment, const Layout& layout) : materials_({garment.material}) {
  materials_.insert(materials_.end(), garment.others.begin(), garment.others.end());
  if (!sim::has_law(garment.material) || layout.surface.block_count() == 0) return;
  lanes_ = layout.surface;
  lanes_.relaxation = 1.0F;  // tension is measured by whole corrections
  sums_.resize(lanes_.block_count());
  warps_.resize(lanes_.block_count());
  areas_m2_.resize(lanes_.lane_count());
  material_of_.resize(lanes_.lane_count());
  areas_at_rows_m2_.resize(layout.row_count());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const SurfaceBlock& block = lanes_.blocks[lane / block_size];
    const std::size_t k = lane % block_size;
    if (lanes_.triangle[lane] == SurfaceLanes::no_triangle) continue;
    areas_m2_[lane] = 0.5F / (block.along_per_m[k] * block.across_per_m[k]);
    const Index corner = garment.mesh.triangles[lanes_.triangle[lane]][0];
    material_of_[lane] = garment.material_of.empty() ? 0 : garment.material_of[corner];
    const Vec2 warp = warp_of(garment, lanes_.triangle[lane]);
    warps_[lane / block_size].cosine[k] = static_cast<float>(warp.x);
    warps_[lane / block_size].sine[k] = static_cast<float>(warp.y);
    for (const auto& at : block.at) areas_at_rows_m2_[at[k] / 4].x += areas_m2_[lane];
  }
}

ElasticMemory Elasticity::at_start(const Layout& layout, double most) const {
  ElasticMemory memory{std::vector<SurfaceSums>(lanes_.block_count()), std::vector<SurfaceSums>(lanes_.block_count())};
  const std::vector<Law> laws = laws_of(materials_, most);
  const Float4Array unmoved(areas_at_rows_m2_.size());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    if (areas_m2_[lane] == 0.0F) continue;
    const Law& law = laws[material_of_[lane]];
    const InPlane in_triangle = strain_of(layout.surface.blocks[b], k, unmoved);
    const InPlane strain = limited(turned(in_triangle, warps_[b].cosine[k], warps_[b].sine[k]), law.most);
    if (std::max(strain.first, strain.second) < least_begun_with) continue;
    set(memory.tension_n_per_m[b], k,
        {strain.first / law.give_warp, strain.second / law.give_weft, strain.mixed / law.half_give_shear});
  }
  return memory;
}

void Elasticity::begin_attempt(const Layout& layout, const StartRows& start, const ElasticMemory& memory, double most,
                               double time_step_s, ParallelKernels& kernels) {
  std::fill(sums_.begin(), sums_.end(), SurfaceSums{});
  steps_ = 0;
  memory_ = memory;
  most_ = most;
  squared_step_s2_ = static_cast<float>(time_step_s * time_step_s);
  stretch_rest_shapes(layout, start, kernels);
}

void Elasticity::stretch_rest_shapes(const Layout& layout, const StartRows& start, ParallelKernels& kernels) {
  const std::vector<Law> laws = laws_of(materials_, most_);
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    const InPlane due = strain_by(laws[material_of_[lane]], in_plane(memory_.tension_n_per_m[b], k));
    const InPlane rest = sum(due, in_plane(memory_.held_n_per_m[b], k), -sag_m_per_n(lane));
    stretch(layout.surface.blocks[b], k, turned(rest, warps_[b].cosine[k], -warps_[b].sine[k]), lanes_.blocks[b]);
  }
  kernels.start(start, lanes_);
}

// A multiplier of each principal tension, as that of an augmented Lagrangian: it grows while the cloth is longer
// than tension over stiffness, and is not below 0. Along axes of its own it would let triangles that carry all
// and slack ones lie side by side.
void Elasticity::hold_back(const Layout& layout, const Float4Array& moved, double time_s) {
  const std::vector<Law> laws = laws_of(materials_, most_);
  const auto taken = static_cast<float>(time_s / held_s);
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    if (areas_m2_[lane] == 0.0F) continue;
    const InPlane tension = in_plane(memory_.tension_n_per_m[b], k);
    const InPlane strain =
        turned(strain_of(layout.surface.blocks[b], k, moved), warps_[b].cosine[k], warps_[b].sine[k]);
    const auto [cosine, sine] = principal_axes(tension);
    const InPlane error = turned(sum(strain, strain_by(laws[material_of_[lane]], tension), -1.0F), cosine, sine);
    const InPlane held = turned(in_plane(memory_.held_n_per_m[b], k), cosine, sine);
    const float sag = sag_m_per_n(lane);
    const auto next = [&](float before, float too_long) {
      return std::clamp(before + taken * too_long / sag, 0.0F, most_held / sag);
    };
    set(memory_.held_n_per_m[b], k,
        turned({next(held.first, error.first), next(held.second, error.second), 0.0F}, cosine, -sine));
  }
}

// By lane, in the frame of warp and weft.
std::vector<InPlane> Elasticity::mean_tension(double time_step_s, double time_s) const {
  const auto times = static_cast<float>(0.5 / (time_step_s * time_s));
  std::vector<InPlane> tension(lanes_.lane_count());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    if (areas_m2_[lane] > 0.0F) {
      const SurfaceBlock& block = lanes_.blocks[b];
      const float stretched_m2 = 0.5F / (block.along_per_m[k] * block.across_per_m[k]);
      const float factor = times / lanes_.mobility_per_kg[lane] * areas_m2_[lane] / stretched_m2;
      tension[lane] = turned(sum({}, in_plane(sums_[b], k), factor), warps_[b].cosine[k], warps_[b].sine[k]);
    }
  }
  return tension;
}

// Triangles are one of many that carry the same load; neighbours share it.
void Elasticity::share_with_neighbours(std::vector<InPlane>& values) const {
  Float4Array rows(areas_at_rows_m2_.size());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const Float4 value = {values[lane].first, values[lane].second, values[lane].mixed};
    for (const auto& at : lanes_.blocks[lane / block_size].at) {
      add_scaled(rows[at[lane % block_size] / 4], value, areas_m2_[lane]);
    }
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const float area = areas_at_rows_m2_[row].x;
    rows[row] = times(rows[row], area > 0.0F ? 1.0F / (3.0F * area) : 0.0F);
  }
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    Float4 value;
    for (const auto& at : lanes_.blocks[lane / block_size].at) {
      add_scaled(value, rows[at[lane % block_size] / 4], 1.0F);
    }
    values[lane] = {value.x, value.y, value.z};
  }
}

// A sweep leaves at most the strain tension times sag.
double Elasticity::steps_needed_per_s() const {
  double load = 0.0;
  double strain_per_s2 = 0.0;
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const InPlane t = in_plane(memory_.tension_n_per_m[lane / block_size], lane % block_size);
    const double tension = std::max({0.0F, t.first, t.second});
    load += areas_m2_[lane] * tension;
    strain_per_s2 += areas_m2_[lane] * tension * 2.0 * lanes_.mobility_per_kg[lane] * tension;
  }
  return load > 0.0 ? std::sqrt(strain_per_s2 / load / tuning::largest_strain_per_step) : 0.0;
}

void Elasticity::follow(const Layout& layout, const Motion& motion, double time_step_s, ParallelKernels& kernels) {
  const double time_s = time_step_s * steps_;
  const auto taken = static_cast<float>(time_s / (time_s + tuning::remembered_s));
  std::vector<InPlane> found = mean_tension(time_step_s, time_s);
  for (int time = 0; time < tuning::shared_times; ++time) share_with_neighbours(found);
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    SurfaceSums& tension = memory_.tension_n_per_m[lane / block_size];
    const InPlane before = in_plane(tension, lane % block_size);
    set(tension, lane % block_size, sum(before, sum(found[lane], before, -1.0F), taken));
  }
  std::fill(sums_.begin(), sums_.end(), SurfaceSums{});
  steps_ = 0;
  hold_back(layout, motion.current, time_s);
  stretch_rest_shapes(layout, motion.start, kernels);
}

}  // namespace taut::sim::bounded
