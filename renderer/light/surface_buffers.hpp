#pragma once

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/canvas.hpp"

namespace taut::renderer {

/// A rectangle of a square map, in texels.
struct MapArea {
  glm::ivec2 lower{0};
  glm::ivec2 upper{0};  ///< excluded
};

/// A square shadow map (Williams 1978), rasterised on the CPU. Garment triangles cover only a few texels, so
/// that their setup in a general rasteriser would cost several times as much.
class ShadowMap {
 public:
  /// Sets the side in texels. A new size clears the map.
  void resize(int side_px);
  /// Sets every texel to depth 1, the farthest.
  void clear();
  /// Rasterises triangles and keeps the least depth at every texel centre. `world_to_map` leads from metres
  /// to 0..1 in all three axes; what falls outside is clipped. `triangles`: three indices into positions
  /// each.
  void draw(const glm::mat4& world_to_map, std::span<const glm::vec3> positions,
            std::span<const std::uint32_t> triangles);

  /// Returns the side in texels.
  int side_px() const { return side_; }
  /// Returns the depth of the texel at `place`, texture coordinates 0..1; 1 outside the map.
  float depth_at(const glm::vec2& place) const;
  /// Returns the bounds of all texels drawn since the last clear().
  const MapArea& drawn() const { return drawn_; }
  /// Returns side_px * side_px depths, lowest row first, as OpenGL takes textures.
  std::span<const float> depths() const { return texels_; }

 private:
  void include(const std::vector<glm::vec3>& points);

  int side_ = 0;
  MapArea drawn_;
  std::vector<float> texels_;
  std::vector<glm::vec3> projected_;  // scratch: x and y in pixels, z the depth
};

/// Fills `projected` with one point per position: x and y in texels of a map of side_px, z the depth, 0..1.
void project_to_map(const glm::mat4& world_to_map, int side_px, std::span<const glm::vec3> positions,
                    std::vector<glm::vec3>& projected);

/// Whether the key light reaches a triangle. The values are those of shaders/surface_buffers.glsl.
enum class KeyVisibility : std::uint8_t {
  shadowed = 0,
  lit = 1,
  partial = 2,  ///< partly shadowed: every pixel looks into the shadow map
};

/// Classifies triangles as lit, shadowed or partly shadowed. Only pixels of the last look into the shadow
/// map, which would otherwise take most of a picture's time. Each triangle is compared with the shadow map at
/// the texels it covers. Where light and shadow meet, the penumbra is spread over the mesh from vertex to
/// vertex.
class ShadowClassifier {
 public:
  /// Sets the shadow map and its place in the world (block.world_to_shadow and the shadow members). The map
  /// must live while classify() is called.
  void set_shadow_map(const ShadowMap& map, const FrameBlock& block);
  /// Fills `visibility` with one value per triangle of the surface. Requires set_shadow_map() before.
  void classify(const SurfaceView& surface, std::vector<KeyVisibility>& visibility);

 private:
  // How many texels of a triangle the light sees.
  struct Sight {
    int lit = 0;
    int dark = 0;
    float widest_gap = 0.0F;  // from the triangle to its blocker; share of the map's depth
  };
  using Corners = std::span<const std::uint32_t, 3>;

  Sight sight_of(Corners corners) const;
  void compare(const SurfaceView& surface, std::vector<KeyVisibility>& visibility);
  void find_shadow_edges(std::span<const std::uint32_t> triangles, const std::vector<KeyVisibility>& visibility);
  void spread(const SurfaceView& surface);
  float penumbra_m(float gap) const;

  const ShadowMap* map_ = nullptr;
  glm::mat4 world_to_map_{1.0F};
  float side_m_ = 0.0F;      // 0: nothing casts a shadow
  float softness_m_ = 0.0F;  // widest blur
  float sharpest_m_ = 0.0F;  // narrowest blur
  float tangent_ = 0.0F;     // of the light's angular radius
  // Scratch.
  std::vector<glm::vec3> projected_;   // x and y in samples, z the depth
  std::vector<float> penumbrae_m_;     // of each triangle with shadow on it
  std::vector<std::uint8_t> touched_;  // by light (1) and shadow (2), for each vertex
  std::vector<float> reaches_m_;       // how far a penumbra still goes from each vertex
};

/// The base colour maps of a frame as layers of one array texture, in premultiplied linear light. Smaller
/// maps are enlarged to the size of the largest. It is uploaded when other maps are asked for than before.
class BaseColourMapTexture {
 public:
  /// The context must be current and outlive this object.
  explicit BaseColourMapTexture(const GladGLContext& context) : gl_(&context) {}

  /// Begins a frame.
  void clear() { maps_.clear(); }
  /// Returns the layer of a map, counted from 0. Calls no OpenGL.
  int layer_of(const BaseColourMap& map);
  /// Uploads what was asked for since clear(), unless it is there.
  void upload();
  /// Returns the texture of the last upload(), which must have been called.
  const Texture& texture() const { return *made_; }

 private:
  const GladGLContext* gl_;
  std::vector<BaseColourMap> maps_;
  std::vector<BaseColourMap> uploaded_;
  std::optional<Texture> made_;
};

/// A texture with one colour map per row, made at the first call of texture().
class ColourMapTexture {
 public:
  /// The context must be current and outlive this object.
  explicit ColourMapTexture(const GladGLContext& context) : gl_(&context) {}
  /// Returns the row of a map, counted from 0.
  static int row_of(ColourMap map) { return static_cast<int>(map); }
  /// Returns the texture. The first call binds it to the active texture unit.
  const Texture& texture();

 private:
  const GladGLContext* gl_;
  std::optional<Texture> made_;
};

/// The light that arrives at a surface.
struct SurfaceLight {
  std::vector<KeyVisibility> key;  ///< one per triangle
  std::vector<glm::vec2> sky;      ///< ambient, one per vertex; x outside, y inside
};

/// Replaces the light at the coarse mesh of a refined surface by that at the surface. A vertex that faces
/// away from those it is between has their other side's.
void spread(const SurfaceView& surface, SurfaceLight& light);

/// All surfaces of one frame in buffer textures, laid out as shaders/surface_buffers.glsl says.
class SurfaceBuffers {
 public:
  /// Three texels of the vertex buffer.
  struct Vertex {
    glm::vec4 place;     ///< position, metres
    glm::vec4 facing;    ///< normal; w: ambient light outside
    glm::vec4 material;  ///< material coordinate, metres, or x: scalar; w: ambient light inside
  };

  /// The context must be current and outlive this object.
  explicit SurfaceBuffers(const GladGLContext& context);

  /// Removes all surfaces.
  void clear();
  /// Adds a surface with its light. `colour_map_row`: row of its colour map in ColourMapTexture; ignored
  /// without scalars. `maps` is asked for the layers of its base colour maps.
  void add(const SurfaceView& surface, const SurfaceLight& light, int colour_map_row, BaseColourMapTexture& maps);
  /// Uploads all surfaces. Throws ContextError when they exceed the context's largest buffer texture.
  void upload();

  /// Binds the buffer textures to their units.
  void bind() const;
  /// Returns whether a surface has a base colour map.
  bool has_maps() const { return !corners_.empty(); }
  /// Returns whether there are no triangles.
  bool empty() const { return triangles_.empty(); }

  /// Returns the vertices of all surfaces.
  std::span<const Vertex> all_vertices() const { return vertices_; }
  /// Returns one element per triangle: xyz its vertices, w as shaders/surface_buffers.glsl says.
  std::span<const glm::uvec4> all_triangles() const { return triangles_; }
  /// Returns whether a triangle's KeyVisibility is partial.
  static bool is_partial(const glm::uvec4& triangle) {
    return (triangle.w & 3U) == static_cast<std::uint32_t>(KeyVisibility::partial);
  }

 private:
  // For a triangle that is trimmed.
  struct Trim {
    std::array<glm::vec4, 3> corners;
    glm::vec4 band;
  };
  struct Material {
    glm::vec4 outside;
    glm::vec4 inside;
    glm::vec4 rest;
    glm::vec4 threads;
    glm::vec4 stitches;
  };
  // A buffer and the texture through which shaders read it.
  struct BufferTexture {
    explicit BufferTexture(const GladGLContext& context) : buffer(context), texture(context) {}
    Buffer buffer;
    Texture texture;
  };
  void add_materials(const SurfaceView& surface, float row, BaseColourMapTexture& maps);
  void add_corners(const SurfaceView& surface);
  template <typename Row>
  void upload_rows(BufferTexture& target, GLenum format, const std::vector<Row>& rows, unsigned unit) const;

  const GladGLContext* gl_;
  BufferTexture vertex_data_;
  BufferTexture triangle_data_;
  BufferTexture material_data_;
  BufferTexture corner_data_;
  BufferTexture trim_data_;
  std::vector<Vertex> vertices_;
  std::vector<glm::uvec4> triangles_;
  std::vector<Material> materials_;
  std::vector<glm::vec2> corners_;  // three per triangle up to the last that has a map
  std::vector<Trim> trims_;
  std::size_t most_texels_ = 0;
};

/// A span of scanline rasterisation: the pixels of one row whose centres lie in a triangle.
struct TriangleSpan {
  int row = 0;
  int first = 0;            ///< first column
  int last = 0;             ///< last column, included
  float depth = 0.0F;       ///< at the centre of column 0
  float depth_step = 0.0F;  ///< from column to column
};

namespace detail {

// Where an edge cuts the rows: column = offset + slope * row. Rows the edge does not reach bound nothing.
struct RowCut {
  float slope = 0.0F;
  float offset = 0.0F;
  bool is_left = false;
};

inline RowCut row_cut(const glm::vec3& from, const glm::vec3& to, bool counter_clockwise) {
  const float slope = (to.x - from.x) / (to.y - from.y);
  return {slope, from.x - slope * from.y, (to.y < from.y) == counter_clockwise};
}

}  // namespace detail

/// Calls `fill` with every span of a triangle on a square of side_px. Corners: x and y in pixels, z the
/// depth. The winding does not matter. Neighbours may share pixels on their edge, but never leave a gap.
/// Spans are clipped to the square, also for corners that are not finite.
template <typename Fill>
void rasterise_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int side_px, Fill&& fill) {
  // A hair to spare on every side, px.
  constexpr float spare = 1e-3F;
  const auto first_centre = [side_px](float edge) { return whole_within(edge + 0.5F - spare, 0, side_px); };
  const auto last_centre = [side_px](float edge) { return whole_within(edge + 0.5F + spare, 0, side_px) - 1; };
  const int first_row = first_centre(std::min({a.y, b.y, c.y}));
  const int last_row = last_centre(std::max({a.y, b.y, c.y}));
  const float leftmost = std::min({a.x, b.x, c.x});
  const float rightmost = std::max({a.x, b.x, c.x});
  const int first_column = first_centre(leftmost);
  const int last_column = last_centre(rightmost);
  if (first_row > last_row || first_column > last_column) return;
  const glm::vec3 ab = b - a;
  const glm::vec3 ac = c - a;
  const float twice_area = ab.x * ac.y - ac.x * ab.y;
  if (!(std::abs(twice_area) > 0.0F && std::isfinite(twice_area))) return;
  const glm::vec2 slope = glm::vec2{ab.z * ac.y - ac.z * ab.y, ab.x * ac.z - ac.x * ab.z} / twice_area;
  const bool turn = twice_area > 0.0F;
  std::array<detail::RowCut, 3> cuts;
  std::size_t count = 0;
  if (a.y != b.y) cuts[count++] = detail::row_cut(a, b, turn);
  if (b.y != c.y) cuts[count++] = detail::row_cut(b, c, turn);
  if (c.y != a.y) cuts[count++] = detail::row_cut(c, a, turn);
  for (int row = first_row; row <= last_row; ++row) {
    const float y = static_cast<float>(row) + 0.5F;
    float left = leftmost;
    float right = rightmost;
    for (std::size_t i = 0; i < count; ++i) {
      const float x = cuts[i].offset + cuts[i].slope * y;
      left = cuts[i].is_left ? std::max(left, x) : left;
      right = cuts[i].is_left ? right : std::min(right, x);
    }
    const int first = std::max(first_centre(left), first_column);
    const int last = std::min(last_centre(right), last_column);
    if (first > last) continue;
    const float depth = a.z + (y - a.y) * slope.y + (0.5F - a.x) * slope.x;
    fill(TriangleSpan{row, first, last, depth, slope.x});
  }
}

}  // namespace taut::renderer
