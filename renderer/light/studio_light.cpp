#include "renderer/light/studio_light.hpp"

#include <future>

namespace taut::renderer {
namespace {

// Side of one map. Higher values keep finer folds dark but cost time.
constexpr int map_px = 128;
constexpr std::size_t map_texels = static_cast<std::size_t>(map_px) * map_px;
// Ratio of the brightness of the studio's floor to its ceiling, as seen by undersides.
constexpr float floor_brightness = 0.5F;
// Distance from a surface at which its occlusion is tested, in texels of the map along the box's diagonal. Lower values
// let a surface occlude itself, higher ones lose narrow folds.
constexpr float lift_texels = 1.5F;
// Blur of the floor's shadow, in cones of a direction: above 1, so that neighbouring directions overlap. Lower values
// show single shadows, higher ones lose the contact.
constexpr float floor_blur = 1.5F;
// Narrowest blur, in texels of the map, and widest, as a fraction of the map's side.
constexpr float min_blur_texels = 1.5F;
constexpr float max_blur_fraction = 0.45F;
// Start of the fade of the floor's light towards the edge of its texture, as a fraction of half its side.
constexpr float fade_start = 0.75F;
// Width of the window that a vertex samples, in texels. Its edges count in part, so that nothing jumps.
constexpr int window = 5;

// Returns a direction of the upper hemisphere; all have equal areas along a spiral (Fibonacci lattice).
glm::vec3 upper_direction(int i, int count) {
  const float y = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
  const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / std::numbers::phi_v<float>;
  const float flat = std::sqrt(1.0F - y * y);
  return {flat * std::cos(turn), y, flat * std::sin(turn)};
}

// Returns the tangent of the half angle of one direction's cone, which has its share of the whole sphere.
float cone_tangent(int directions) {
  const float cosine = std::max(1.0F - 2.0F / static_cast<float>(directions), 0.3F);
  return std::sqrt(1.0F - cosine * cosine) / cosine;
}

// Returns the unoccluded light of the studio on a side, by the same integral.
float open_sky(float upwards) { return 0.75F + 0.25F * upwards; }

// Weights of a window's texels along one axis.
struct WindowAxis {
  int first;
  std::array<float, 8> weights;
};

WindowAxis window_axis(float middle_px) {
  const float start = std::clamp(middle_px - 0.5F * window, 0.0F, static_cast<float>(map_px - 8));
  const int first = whole_within(start, 0, map_px - 8);
  const float part = start - static_cast<float>(first);
  return {first, {1.0F - part, 1.0F, 1.0F, 1.0F, 1.0F, part, 0.0F, 0.0F}};
}

// Vectors of four: compilers do not vectorise a comparison and a sum of single numbers; GCC and Clang map these types
// to one register.
using FourNumbers = float __attribute__((vector_size(16)));
using FourMasks = std::int32_t __attribute__((vector_size(16)));

FourNumbers four_at(const float* values) {
  FourNumbers four;
  std::memcpy(&four, values, sizeof four);
  return four;
}

FourNumbers mask_weight(float weight, const FourMasks& mask) {
  const FourNumbers weights{weight, weight, weight, weight};
  return std::bit_cast<FourNumbers>(std::bit_cast<FourMasks>(weights) & mask);
}

// Returns the fraction of the window whose map depth is at least (`beyond`) or at most (otherwise) the depth of the
// place.
template <bool beyond> float open_share(const std::vector<float>& map, const glm::vec3& place) {
  const WindowAxis across = window_axis(place.x * static_cast<float>(map_px));
  const WindowAxis up = window_axis(place.y * static_cast<float>(map_px));
  const FourNumbers place_depths{place.z, place.z, place.z, place.z};
  FourNumbers left{};
  FourNumbers right{};
  const float* row = map.data() + up.first * map_px + across.first;
  for (std::size_t y = 0; y <= window; ++y, row += map_px) {
    const FourNumbers a = four_at(row);
    const FourNumbers b = four_at(row + 4);
    left += mask_weight(up.weights[y], beyond ? a >= place_depths : a <= place_depths);
    right += mask_weight(up.weights[y], beyond ? b >= place_depths : b <= place_depths);
  }
  const FourNumbers weighed = left * four_at(across.weights.data()) + right * four_at(&across.weights[4]);
  return (weighed[0] + weighed[1] + weighed[2] + weighed[3]) / static_cast<float>(window * window);
}

std::optional<Box> box_around(std::span<const SurfaceView* const> casters) {
  std::optional<Box> box;
  for (const SurfaceView* caster : casters) {
    const Box place_depths = bounding_box(caster->positions);
    box = box ? unite(*box, place_depths) : place_depths;
  }
  return box;
}

std::vector<const SurfaceView*> casters_among(std::span<const SurfaceView> surfaces) {
  std::vector<const SurfaceView*> casters;
  for (const SurfaceView& surface : surfaces) {
    if (surface.casts_shadow && !surface.triangles.empty()) casters.push_back(&surface);
  }
  return casters;
}

// Returns the mean of the casters' colours by their triangles, in linear light.
glm::vec3 mean_colour(std::span<const SurfaceView* const> casters) {
  glm::vec3 sum{0.0F};
  float triangles = 0.0F;
  for (const SurfaceView* caster : casters) {
    const auto own = static_cast<float>(caster->triangles.size());
    sum += own * linear_light(caster->style.outside_colour);
    triangles += own;
  }
  return sum / std::max(triangles, 1.0F);
}

MapArea unite_areas(const MapArea& a, const MapArea& b) {
  if (a.lower == a.upper) return b;
  if (b.lower == b.upper) return a;
  return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)};
}

}  // namespace

void SkyLight::draw_maps(std::span<const SurfaceView* const> casters, const std::optional<Box>& box, int directions) {
  pairs_.resize(box ? static_cast<std::size_t>((directions + 1) / 2) : 0);
  if (pairs_.empty()) return;
  const auto count = static_cast<int>(pairs_.size());
  lift_m_ = lift_texels * glm::length(box->upper - box->lower) / static_cast<float>(map_px);
  cone_tangent_ = cone_tangent(2 * count);
  for (int i = 0; i < count; ++i) {
    DirectionPair& pair = pairs_[static_cast<std::size_t>(i)];
    pair.towards = upper_direction(i, count);
    pair.world_to_map = world_to_unit_cube(*box, pair.towards);
    draw(pair, casters);
  }
}

void SkyLight::draw(DirectionPair& pair, std::span<const SurfaceView* const> casters) {
  pair.min_depths.assign(map_texels, 1.0F);
  pair.max_depths.assign(map_texels, 0.0F);
  for (const SurfaceView* caster : casters) {
    project_to_map(pair.world_to_map, map_px, caster->positions, projected_);
    for (std::size_t i = 0; i + 2 < caster->triangles.size(); i += 3) {
      const glm::vec3& a = projected_[caster->triangles[i]];
      const glm::vec3& b = projected_[caster->triangles[i + 1]];
      const glm::vec3& c = projected_[caster->triangles[i + 2]];
      const float least = std::min({a.z, b.z, c.z});
      const float greatest = std::max({a.z, b.z, c.z});
      rasterise_triangle(a, b, c, map_px, [&](const TriangleSpan& span) {
        const int row = span.row * map_px;
        for (int column = span.first; column <= span.last; ++column) {
          const float depth = std::clamp(span.depth + span.depth_step * static_cast<float>(column), least, greatest);
          const auto texel = static_cast<std::size_t>(row + column);
          pair.min_depths[texel] = std::min(pair.min_depths[texel], depth);
          pair.max_depths[texel] = std::max(pair.max_depths[texel], depth);
        }
      });
    }
  }
}

void SkyLight::gather(const SurfaceView& surface, std::vector<glm::vec2>& light) {
  light.assign(surface.positions.size(), glm::vec2{0.0F});
  if (pairs_.empty()) {
    std::ranges::transform(surface.normals, light.begin(), [](const glm::vec3& normal) {
      return glm::vec2{open_sky(normal.y), open_sky(-normal.y)};
    });
    return;
  }
  for (const DirectionPair& pair : pairs_) gather_pair(pair, surface, light);
  for (glm::vec2& share : light) share *= 2.0F / static_cast<float>(pairs_.size());
}

// Adds the light of one pair of directions. Each lights one side, from which its test starts.
void SkyLight::gather_pair(const DirectionPair& pair, const SurfaceView& surface, std::vector<glm::vec2>& light) const {
  const glm::mat4 to_map = pair.world_to_map;
  for (std::size_t i = 0; i < light.size(); ++i) {
    const glm::vec3& normal = surface.normals[i];
    const float cosine = glm::dot(normal, pair.towards);
    const glm::vec3 lift = std::copysign(lift_m_, cosine) * normal;
    const glm::vec3 upper{to_map * glm::vec4{surface.positions[i] + lift, 1.0F}};
    const glm::vec3 lower{to_map * glm::vec4{surface.positions[i] - lift, 1.0F}};
    const float from_above = open_share<true>(pair.min_depths, upper);
    const float from_below = open_share<false>(pair.max_depths, lower);
    const glm::vec2 shares = std::abs(cosine) * glm::vec2{from_above, floor_brightness * from_below};
    light[i] += cosine > 0.0F ? shares : glm::vec2{shares.y, shares.x};
  }
}

// Sums up the blockers between a direction and the floor, over rectangles from the map's corner (Crow 1984).
void SkyLight::sum_up(const DirectionPair& pair, float height_m) {
  constexpr std::size_t row_length = map_px + 1;
  sums_.assign(row_length * row_length, 0.0F);
  const glm::mat4 map_to_world = glm::inverse(pair.world_to_map);
  const float texel = 1.0F / static_cast<float>(map_px);
  for (std::size_t y = 0; y < map_px; ++y) {
    float row_sum = 0.0F;
    for (std::size_t x = 0; x < map_px; ++x) {
      const glm::vec2 place = (glm::vec2{x, y} + 0.5F) * texel;
      const float start_m = map_to_world[3].y + map_to_world[0].y * place.x + map_to_world[1].y * place.y;
      const float floor_depth = (height_m - start_m) / map_to_world[2].y;
      const float depth = pair.min_depths[y * map_px + x];
      row_sum += depth < 1.0F && depth < floor_depth ? 1.0F : 0.0F;
      sums_[(y + 1) * row_length + x + 1] = sums_[y * row_length + x + 1] + row_sum;
    }
  }
}

float SkyLight::floor_blocked(const glm::vec2& middle_px, float radius_px) const {
  const auto highest = static_cast<float>(map_px);
  const glm::vec2 lower = glm::clamp(middle_px - radius_px, 0.0F, highest);
  const glm::vec2 upper = glm::clamp(middle_px + radius_px, 0.0F, highest);
  const auto sum_to = [&](float x, float y) {
    const int column = whole_within(x, 0, map_px - 1);
    const int row = whole_within(y, 0, map_px - 1);
    const float* corner = sums_.data() + row * (map_px + 1) + column;
    const glm::vec2 part{x - static_cast<float>(column), y - static_cast<float>(row)};
    const float near = glm::mix(corner[0], corner[1], part.x);
    const float far = glm::mix(corner[map_px + 1], corner[map_px + 2], part.x);
    return glm::mix(near, far, part.y);
  };
  const float sum =
      sum_to(upper.x, upper.y) - sum_to(lower.x, upper.y) - sum_to(upper.x, lower.y) + sum_to(lower.x, lower.y);
  return sum / (4.0F * radius_px * radius_px);
}

// A direction stands for a cone of sky, so its shadow softens with the distance to the casters. That distance assumes
// all casters in the middle of the map: searching for them would give every spot another softness, which shows as
// clouds.
void SkyLight::gather_floor(const glm::vec4& area, float height_m, std::vector<float>& light) {
  constexpr std::size_t count = static_cast<std::size_t>(floor_px) * floor_px;
  light.assign(count, pairs_.empty() ? 1.0F : 0.0F);
  float all = 0.0F;
  for (const DirectionPair& pair : pairs_) {
    sum_up(pair, height_m);
    const float weight = pair.towards.y;
    all += weight;
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec2 place = (glm::vec2{i % floor_px, i / floor_px} + 0.5F) / static_cast<float>(floor_px);
      const glm::vec2 spot = glm::vec2{area} + place / glm::vec2{area.z, area.w};
      const glm::vec3 seen{pair.world_to_map * glm::vec4{spot.x, height_m + 0.5F * lift_m_, spot.y, 1.0F}};
      const float texel = 1.0F / static_cast<float>(map_px);
      const float radius =
          std::clamp(floor_blur * cone_tangent_ * (seen.z - 0.5F), min_blur_texels * texel, max_blur_fraction);
      const float blocked = floor_blocked(glm::vec2{seen} / texel, radius / texel);
      light[i] += weight * (1.0F - blocked);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    // Fading out hides the end of the texture.
    const glm::vec2 place = (glm::vec2{i % floor_px, i / floor_px} + 0.5F) / static_cast<float>(floor_px);
    const glm::vec2 edge = glm::abs(2.0F * place - 1.0F);
    const float fade = glm::smoothstep(fade_start, 1.0F, std::max(edge.x, edge.y));
    if (all > 0.0F) light[i] = glm::mix(light[i] / all, 1.0F, fade);
  }
}

StudioLight::StudioLight(const GladGLContext& context)
    : gl_(&context), shadow_texture_(context), floor_texture_(context), compare_(context), plain_(context) {
  set_comparing(*gl_, compare_, GL_LINEAR);
  gl_->SamplerParameteri(plain_.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->SamplerParameteri(plain_.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_->SamplerParameteri(plain_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_->SamplerParameteri(plain_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_->BindTexture(GL_TEXTURE_2D, floor_texture_.name());
  set_sampling(*gl_, GL_TEXTURE_2D, GL_LINEAR);
}

void StudioLight::begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
                        const PictureSettings& settings) {
  casters_ = casters_among(surfaces);
  casters_box_ = box_around(casters_);
  // A map of extremely distant casters would resolve nothing near.
  if (casters_box_ && !is_near(*casters_box_)) {
    casters_.clear();
    casters_box_.reset();
  }
  block = make_frame_block(frame, settings, casters_box_);
  if (!settings.shadows) casters_.clear();
  set_shadow_bounds(block, casters_);
  shadow_side_px_ = shadow_map_side(settings);
  sky_directions_ = settings.sky_directions;
  has_floor_ = frame.ground_height_m && !frame.backdrop.plain;
}

void StudioLight::turn(FrameBlock& block, const PassSample& sample) const {
  block.sky_floor = {0.0F, mean_colour(casters_)};
  for (std::size_t i = 0; i < sky_pair_count; ++i) {
    block.towards_sky[i] = {sample.towards_sky[i], 0.0F};
    block.world_to_sky[i] =
        casters_.empty() ? glm::mat4{1.0F} : world_to_unit_cube(*casters_box_, sample.towards_sky[i]);
  }
  if (casters_.empty()) return;
  const glm::vec3 middle{block.towards_key};
  const glm::vec3 other = std::abs(middle.y) < 0.9F ? glm::vec3{0.0F, 1.0F, 0.0F} : glm::vec3{1.0F, 0.0F, 0.0F};
  const glm::vec3 across = glm::normalize(glm::cross(other, middle));
  const glm::vec2 point = block.shadow.w * sample.lamp_point;
  const glm::vec3 towards = glm::normalize(middle + point.x * across + point.y * glm::cross(middle, across));
  block.towards_key = {towards, block.towards_key.w};
  block.world_to_shadow = world_to_unit_cube(*casters_box_, towards);
}

void StudioLight::draw_maps(const FrameBlock& block) {
  // The two tasks read the same casters and share nothing else.
  std::future<void> shadows = std::async(std::launch::async, [&] {
    shadow_map_.resize(shadow_side_px_);
    shadow_map_.clear();
    for (const SurfaceView* caster : casters_) {
      shadow_map_.draw(block.world_to_shadow, caster->positions, caster->triangles);
    }
  });
  sky_light_.draw_maps(casters_, casters_.empty() ? std::nullopt : casters_box_, sky_directions_);
  if (has_floor_) sky_light_.gather_floor(block.ground_light_area, block.ground.y, floor_light_);
  shadows.get();
}

void StudioLight::gather(const SurfaceView& surface, std::vector<glm::vec2>& light) {
  sky_light_.gather(surface, light);
}

void StudioLight::upload_shadow_map() {
  const int side_px = shadow_map_.side_px();
  bind_texture(*gl_, shadow_depth_unit, GL_TEXTURE_2D, shadow_texture_);
  if (allocated_px_ != side_px) {
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, side_px, side_px, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                    nullptr);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    allocated_px_ = side_px;
    uploaded_ = {glm::ivec2{0}, glm::ivec2{side_px}};
  }
  const MapArea changed = unite_areas(uploaded_, shadow_map_.drawn());
  const glm::ivec2 size_px = changed.upper - changed.lower;
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, side_px);
  gl_->TexSubImage2D(GL_TEXTURE_2D, 0, changed.lower.x, changed.lower.y, size_px.x, size_px.y, GL_DEPTH_COMPONENT,
                     GL_FLOAT, shadow_map_.depths().data() + changed.lower.y * side_px + changed.lower.x);
  gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  uploaded_ = shadow_map_.drawn();
}

void StudioLight::upload() {
  upload_shadow_map();
  if (!has_floor_) return;
  bind_texture(*gl_, ground_light_unit, GL_TEXTURE_2D, floor_texture_);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, SkyLight::floor_px, SkyLight::floor_px, 0, GL_RED, GL_FLOAT,
                  floor_light_.data());
}

void StudioLight::bind() const {
  bind_texture(*gl_, shadow_compare_unit, GL_TEXTURE_2D, shadow_texture_);
  bind_texture(*gl_, shadow_depth_unit, GL_TEXTURE_2D, shadow_texture_);
  bind_texture(*gl_, ground_light_unit, GL_TEXTURE_2D, floor_texture_);
  gl_->BindSampler(shadow_compare_unit, compare_.name());
  gl_->BindSampler(shadow_depth_unit, plain_.name());
}

void StudioLight::unbind() const {
  for (unsigned unit = 0; unit < unit_count; ++unit) {
    gl_->BindSampler(unit, 0);
    gl_->ActiveTexture(GL_TEXTURE0 + unit);
    gl_->BindTexture(GL_TEXTURE_2D, 0);
    gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    gl_->BindTexture(GL_TEXTURE_BUFFER, 0);
  }
  gl_->ActiveTexture(GL_TEXTURE0);
}

}  // namespace taut::renderer
