#include "sim/solvers/bounded/elasticity.hpp"

namespace taut::sim::bounded {
namespace {

/// Rate of rest shape updates, in 1/s. Higher rates cost more without any effect.
const double follows_per_s = tuning::min_updates_per_s / 3.0;
/// Time constant of the shortening of rest shapes, in s. If it is faster than the damping by air and sweeps, light
/// cloth swings for ever.
const double shortening_time_s = 2.0 * tuning::tension_averaging_s;
/// Largest shortening of a rest shape. Sweeps use mobilities at rest and would correct twice the error of shapes that
/// are a third shorter.
constexpr float max_shortening = 0.25F;

/// Smallest initial strain that starts with tension; less relaxes within a few time steps.
constexpr float min_initial_strain = 0.01F;

struct Law {
  float give_warp, give_weft, half_give_shear;  ///< m/N
  float warp_limit, weft_limit, max_strain;
};

std::vector<Law> make_laws(const std::vector<Material>& materials, double most) {
  std::vector<Law> laws;
  for (const Material& m : materials) {
    laws.push_back({static_cast<float>(1.0 / m.tensile_warp_n_per_m), static_cast<float>(1.0 / m.tensile_weft_n_per_m),
                    static_cast<float>(0.5 / m.shear_n_per_m), static_cast<float>(m.warp_limit),
                    static_cast<float>(m.weft_limit), static_cast<float>(most)});
  }
  return laws;
}

/// Returns the matrix in axes turned by the angle with this cosine and sine.
inline InPlane rotate_axes(const InPlane& m, float c, float s) {
  const float cc = c * c;
  const float ss = s * s;
  const float cs = c * s;
  return {cc * m.first + 2.0F * cs * m.mixed + ss * m.second, ss * m.first - 2.0F * cs * m.mixed + cc * m.second,
          cs * (m.second - m.first) + (cc - ss) * m.mixed};
}

/// Returns the matrix with its eigenvalues clamped to [0, most].
inline InPlane clamp_eigenvalues(const InPlane& m, float most) {
  const float mean = 0.5F * (m.first + m.second);
  const float half = 0.5F * (m.first - m.second);
  const float radius = std::max(1e-12F, std::sqrt(half * half + m.mixed * m.mixed));
  const float max_eigenvalue = std::clamp(mean + radius, 0.0F, most);
  const float min_eigenvalue = std::clamp(mean - radius, 0.0F, most);
  const float middle = 0.5F * (max_eigenvalue + min_eigenvalue);
  const float turn = 0.5F * (max_eigenvalue - min_eigenvalue) / radius;
  return {middle + turn * half, middle - turn * half, turn * m.mixed};
}

InPlane in_plane(const SurfaceSums& sums, std::size_t k) { return {sums.along[k], sums.across[k], sums.mixed[k]}; }

void set(SurfaceSums& sums, std::size_t k, const InPlane& value) {
  sums.along[k] = value.first;
  sums.across[k] = value.second;
  sums.mixed[k] = value.mixed;
}

/// Returns a + factor b.
InPlane sum(const InPlane& a, const InPlane& b, float factor) {
  return {a.first + factor * b.first, a.second + factor * b.second, a.mixed + factor * b.mixed};
}

/// Returns U - 1 from the polar decomposition F = R U; `moved` are the corners' displacements since the frame began.
InPlane triangle_strain(const SurfaceBlock& rest, std::size_t k, const Float4Array& moved) {
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

/// Returns cosine and sine of the angle to the axis of the larger eigenvalue.
std::pair<float, float> principal_axes(const InPlane& m) {
  const float half = 0.5F * (m.first - m.second);
  const float radius = std::sqrt(half * half + m.mixed * m.mixed);
  if (radius < 1e-12F) return {1.0F, 0.0F};
  const float doubled = std::clamp(half / radius, -1.0F, 1.0F);
  const float sine = std::sqrt(0.5F * (1.0F - doubled));
  return {std::sqrt(0.5F * (1.0F + doubled)), m.mixed < 0.0F ? -sine : sine};
}

/// Returns the strain for a tension along warp and weft and in shear.
inline InPlane law_strain(const Law& law, const InPlane& tension) {
  return clamp_eigenvalues(
      {std::min(law.warp_limit, law.give_warp * tension.first),
       std::min(law.weft_limit, law.give_weft * tension.second), law.half_give_shear * tension.mixed},
      law.max_strain);
}

/// Sets the rest shape stretched by these strains, laid flat again with its first edge on the first axis.
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

Vec2 triangle_warp(const Garment& garment, Index triangle) {
  return garment.warps.empty()
             ? upright_direction(corner_positions(garment.mesh.triangles[triangle], garment.mesh.positions))
             : garment.warps[triangle];
}

}  // namespace

int tension_updates_per_frame(double frame_time_s) {
  return std::max(1, static_cast<int>(std::lround(follows_per_s * frame_time_s)));
}

Elasticity::Elasticity(const Garment& garment, const Layout& layout) : materials_({garment.material}) {
  assert(garment.mesh.positions.size() == layout.vertex_count());
  materials_.insert(materials_.end(), garment.other_materials.begin(), garment.other_materials.end());
  if (!sim::has_law(garment.material) || layout.surface.block_count() == 0) return;
  lanes_ = layout.surface;
  lanes_.relaxation = 1.0F;  // tension is measured from unrelaxed corrections
  sums_.resize(lanes_.block_count());
  warps_.resize(lanes_.block_count());
  areas_m2_.resize(lanes_.lane_count());
  material_indices_.resize(lanes_.lane_count());
  areas_at_rows_m2_.resize(layout.row_count());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const SurfaceBlock& block = lanes_.blocks[lane / block_size];
    const std::size_t k = lane % block_size;
    if (lanes_.triangle[lane] == SurfaceLanes::no_triangle) continue;
    areas_m2_[lane] = 0.5F / (block.along_per_m[k] * block.across_per_m[k]);
    const Index corner = garment.mesh.triangles[lanes_.triangle[lane]][0];
    material_indices_[lane] = garment.material_indices.empty() ? 0 : garment.material_indices[corner];
    const Vec2 warp = triangle_warp(garment, lanes_.triangle[lane]);
    warps_[lane / block_size].cosine[k] = static_cast<float>(warp.x);
    warps_[lane / block_size].sine[k] = static_cast<float>(warp.y);
    for (const auto& at : block.at) areas_at_rows_m2_[at[k] / 4].x += areas_m2_[lane];
  }
}

ElasticMemory Elasticity::at_start(const Layout& layout, double most) const {
  ElasticMemory memory{std::vector<SurfaceSums>(lanes_.block_count()), std::vector<SurfaceSums>(lanes_.block_count())};
  const std::vector<Law> laws = make_laws(materials_, most);
  const Float4Array unmoved(areas_at_rows_m2_.size());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    if (areas_m2_[lane] == 0.0F) continue;
    const Law& law = laws[material_indices_[lane]];
    const InPlane in_triangle = triangle_strain(layout.surface.blocks[b], k, unmoved);
    const InPlane strain =
        clamp_eigenvalues(rotate_axes(in_triangle, warps_[b].cosine[k], warps_[b].sine[k]), law.max_strain);
    if (std::max(strain.first, strain.second) < min_initial_strain) continue;
    set(memory.tension_n_per_m[b], k,
        {strain.first / law.give_warp, strain.second / law.give_weft, strain.mixed / law.half_give_shear});
  }
  return memory;
}

void Elasticity::begin_attempt(const Layout& layout, const StartRows& start, const ElasticMemory& memory, double most,
                               double time_step_s, ParallelKernels& kernels) {
  assert(time_step_s > 0.0);
  std::fill(sums_.begin(), sums_.end(), SurfaceSums{});
  steps_ = 0;
  memory_ = memory;
  max_strain_ = most;
  squared_step_s2_ = static_cast<float>(time_step_s * time_step_s);
  stretch_rest_shapes(layout, start, kernels);
}

void Elasticity::stretch_rest_shapes(const Layout& layout, const StartRows& start, ParallelKernels& kernels) {
  const std::vector<Law> laws = make_laws(materials_, max_strain_);
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    const InPlane due = law_strain(laws[material_indices_[lane]], in_plane(memory_.tension_n_per_m[b], k));
    const InPlane rest = sum(due, in_plane(memory_.shortening_n_per_m[b], k), -sag_m_per_n(lane));
    stretch(layout.surface.blocks[b], k, rotate_axes(rest, warps_[b].cosine[k], -warps_[b].sine[k]), lanes_.blocks[b]);
  }
  kernels.start(start, lanes_);
}

// Updates a multiplier for each principal tension, as in an augmented Lagrangian: it grows while the cloth is longer
// than tension over stiffness, and is at least 0. With axes of its own, it would allow fully loaded and slack triangles
// side by side.
void Elasticity::update_shortening(const Layout& layout, const Float4Array& moved, double time_s) {
  assert(time_s >= 0.0);
  const std::vector<Law> laws = make_laws(materials_, max_strain_);
  const auto new_fraction = static_cast<float>(time_s / shortening_time_s);
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    if (areas_m2_[lane] == 0.0F) continue;
    const InPlane tension = in_plane(memory_.tension_n_per_m[b], k);
    const InPlane strain =
        rotate_axes(triangle_strain(layout.surface.blocks[b], k, moved), warps_[b].cosine[k], warps_[b].sine[k]);
    const auto [cosine, sine] = principal_axes(tension);
    const InPlane error =
        rotate_axes(sum(strain, law_strain(laws[material_indices_[lane]], tension), -1.0F), cosine, sine);
    const InPlane held = rotate_axes(in_plane(memory_.shortening_n_per_m[b], k), cosine, sine);
    const float sag = sag_m_per_n(lane);
    const auto next = [&](float before, float too_long) {
      return std::clamp(before + new_fraction * too_long / sag, 0.0F, max_shortening / sag);
    };
    set(memory_.shortening_n_per_m[b], k,
        rotate_axes({next(held.first, error.first), next(held.second, error.second), 0.0F}, cosine, -sine));
  }
}

// Returns tensions by lane, in the frame of warp and weft.
std::vector<InPlane> Elasticity::mean_tension(double time_step_s, double time_s) const {
  assert(time_step_s > 0.0);
  const auto times = static_cast<float>(0.5 / (time_step_s * time_s));
  std::vector<InPlane> tension(lanes_.lane_count());
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const std::size_t b = lane / block_size;
    const std::size_t k = lane % block_size;
    if (areas_m2_[lane] > 0.0F) {
      const SurfaceBlock& block = lanes_.blocks[b];
      const float stretched_m2 = 0.5F / (block.along_per_m[k] * block.across_per_m[k]);
      const float factor = times / lanes_.mobility_per_kg[lane] * areas_m2_[lane] / stretched_m2;
      tension[lane] = rotate_axes(sum({}, in_plane(sums_[b], k), factor), warps_[b].cosine[k], warps_[b].sine[k]);
    }
  }
  return tension;
}

// Many triangles carry the same load, so neighbours share it.
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
    rows[row] = multiply(rows[row], area > 0.0F ? 1.0F / (3.0F * area) : 0.0F);
  }
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    Float4 value;
    for (const auto& at : lanes_.blocks[lane / block_size].at) {
      add_scaled(value, rows[at[lane % block_size] / 4], 1.0F);
    }
    values[lane] = {value.x, value.y, value.z};
  }
}

// A sweep leaves a strain error of at most tension times sag.
double Elasticity::steps_needed_per_s() const {
  double load = 0.0;
  double strain_per_s2 = 0.0;
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    const InPlane t = in_plane(memory_.tension_n_per_m[lane / block_size], lane % block_size);
    const double tension = std::max({0.0F, t.first, t.second});
    load += areas_m2_[lane] * tension;
    strain_per_s2 += areas_m2_[lane] * tension * 2.0 * lanes_.mobility_per_kg[lane] * tension;
  }
  return load > 0.0 ? std::sqrt(strain_per_s2 / load / tuning::max_strain_per_step) : 0.0;
}

void Elasticity::follow(const Layout& layout, const Motion& motion, double time_step_s, ParallelKernels& kernels) {
  assert(time_step_s > 0.0);
  const double time_s = time_step_s * steps_;
  const auto new_fraction = static_cast<float>(time_s / (time_s + tuning::tension_averaging_s));
  std::vector<InPlane> mean_tensions = mean_tension(time_step_s, time_s);
  for (int time = 0; time < tuning::tension_sharing_rounds; ++time) share_with_neighbours(mean_tensions);
  for (std::size_t lane = 0; lane < lanes_.lane_count(); ++lane) {
    SurfaceSums& tension = memory_.tension_n_per_m[lane / block_size];
    const InPlane before = in_plane(tension, lane % block_size);
    set(tension, lane % block_size, sum(before, sum(mean_tensions[lane], before, -1.0F), new_fraction));
  }
  std::fill(sums_.begin(), sums_.end(), SurfaceSums{});
  steps_ = 0;
  update_shortening(layout, motion.current, time_s);
  stretch_rest_shapes(layout, motion.start, kernels);
}

}  // namespace taut::sim::bounded
