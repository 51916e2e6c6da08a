#pragma once

#include "renderer/gl/gl_objects.hpp"
#include "renderer/page/canvas.hpp"

namespace taut::renderer {

/// Rectangle of a square map, in texels.
struct MapArea {
  glm::ivec2 lower{0};
  glm::ivec2 upper{0};  ///< excluded
};

/// Square shadow map (Williams 1978), rasterised on the CPU. Garment triangles cover only a few texels, so their setup
/// in a general rasteriser would cost several times as much.
class ShadowMap {
 public:
  /// Sets the side in texels. A new size clears the map.
  void resize(int side_px);
  /// Sets every texel to depth 1, the farthest.
  void clear();
  /// Rasterises triangles and keeps the smallest depth at every texel centre. `world_to_map` maps metres to 0..1 in all
  /// three axes and clips the rest. `triangles`: three indices into positions each.
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

/// Base colour maps of a frame as layers of one array texture, in premultiplied linear light. Smaller maps are enlarged
/// to the size of the largest. It is uploaded if the set of maps changes.
class BaseColourMapTexture {
 public:
  /// The context must be current and outlive this object.
  explicit BaseColourMapTexture(const GladGLContext& context) : gl_(&context) {}

  /// Begins a frame.
  void clear() { maps_.clear(); }
  /// Returns the layer of a map, counted from 0. Calls no OpenGL.
  int add_layer(const BaseColourMap& map);
  /// Uploads the maps requested since clear(), unless they are unchanged.
  void upload();
  /// Returns the texture of the last upload(), which must have been called.
  const Texture& texture() const { return *made_; }

 private:
  const GladGLContext* gl_;
  std::vector<BaseColourMap> maps_;
  std::vector<BaseColourMap> uploaded_;
  std::optional<Texture> made_;
};

/// Texture with one colour map per row, made at the first call of texture().
class ColourMapTexture {
 public:
  /// The context must be current and outlive this object.
  explicit ColourMapTexture(const GladGLContext& context) : gl_(&context) {}
  /// Returns the row of a map, counted from 0.
  static int row_index(ColourMap map) { return static_cast<int>(map); }
  /// Returns the texture. The first call binds it to the active texture unit.
  const Texture& texture();

 private:
  const GladGLContext* gl_;
  std::optional<Texture> made_;
};

/// Replaces the ambient light of a refined surface's coarse mesh, one pair per vertex, by light on the surface. A
/// vertex that faces away from its parents gets the light of their other side.
void spread(const SurfaceView& surface, std::vector<glm::vec2>& light);

/// All surfaces of one frame in buffer textures, in the layout of shaders/surface_buffers.glsl.
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
  /// Adds a surface with the ambient light of its vertices: x outside, y inside. `colour_map_row`: row of its colour
  /// map in ColourMapTexture; ignored without scalars. `maps` provides the layers of its base colour maps.
  void add(const SurfaceView& surface, const std::vector<glm::vec2>& light, int colour_map_row,
           BaseColourMapTexture& maps);
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
  /// Returns one element per triangle: xyz its vertices, w see shaders/surface_buffers.glsl.
  std::span<const glm::uvec4> all_triangles() const { return triangles_; }

 private:
  // Trim of one triangle.
  struct Trim {
    std::array<glm::vec4, 3> corners;
    glm::vec4 band;
  };
  struct MaterialTexels {
    glm::vec4 outside;
    glm::vec4 inside;
    glm::vec4 properties;
    glm::vec4 threads;
    glm::vec4 stitches;
  };
  // Buffer and the texture through which shaders read it.
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
  std::vector<MaterialTexels> materials_;
  std::vector<glm::vec2> corners_;  // three per triangle, up to the last triangle with a map
  std::vector<Trim> trims_;
  std::size_t max_texels_ = 0;
};

/// Span of scanline rasterisation: the pixels of one row whose centres lie in a triangle.
struct TriangleSpan {
  int row = 0;
  int first = 0;            ///< first column
  int last = 0;             ///< last column, included
  float depth = 0.0F;       ///< depth at the centre of column 0
  float depth_step = 0.0F;  ///< change of depth per column
};

namespace detail {

// Intersection of an edge with rows: column = offset + slope * row. Rows beyond the edge are not bounded by it.
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

/// Calls `fill` with every span of a triangle on a square of side_px. Corners: x and y in pixels, z the depth. The
/// winding does not matter. Neighbours may share pixels on their edge but never leave a gap. Spans are clipped to the
/// square, also for corners that are not finite.
template <typename Fill>
void rasterise_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int side_px, Fill&& fill) {
  // Safety margin on every side, px.
  constexpr float margin_px = 1e-3F;
  const auto first_centre = [side_px](float edge) { return whole_within(edge + 0.5F - margin_px, 0, side_px); };
  const auto last_centre = [side_px](float edge) { return whole_within(edge + 0.5F + margin_px, 0, side_px) - 1; };
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
