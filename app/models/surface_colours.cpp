#include "app/models/surface_colours.hpp"

#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

void require_colours(bool is_so) {
  if (!is_so) throw std::runtime_error("the colours of a model are not as expected");
}

TextureImage take_image(ArrayReader& in) {
  TextureImage image;
  image.width_px = in.take<std::uint32_t>();
  image.height_px = in.take<std::uint32_t>();
  image.rgba = std::make_shared<const std::vector<std::uint8_t>>(in.take_list<std::vector<std::uint8_t>>());
  require_colours(image.width_px > 0 && image.height_px > 0 &&
          image.rgba->size() == std::uint64_t{4} * image.width_px * image.height_px);
  return image;
}

SurfaceMaterial take_material(ArrayReader& in) {
  SurfaceMaterial material;
  material.name = in.take_list<std::string>();
  material.base_colour = in.take<glm::vec3>();
  material.map = in.take<sim::Index>();
  material.map_file = in.take_list<std::string>();
  return material;
}

bool are_below(const std::vector<sim::Index>& indices, std::size_t count) {
  return std::all_of(indices.begin(), indices.end(), [&](sim::Index index) { return index < count; });
}

/// Sources of new triangles in old ones: per triangle the face, per corner the corner; none of it where a
/// triangle is new.
struct Sources {
  std::vector<sim::Index> face_of_triangle;
  std::vector<sim::Index> corner_of_corner;

  void add(sim::Index face, const std::array<sim::Index, 3>& corners) {
    face_of_triangle.push_back(face);
    corner_of_corner.insert(corner_of_corner.end(), corners.begin(), corners.end());
  }
};

constexpr sim::Index none = sim::no_vertex;

SurfaceColours taken_from(SurfaceColours colours, const Sources& sources) {
  if (!colours.corner_uv.empty()) {
    std::vector<glm::vec2> corner_uv;
    corner_uv.reserve(sources.corner_of_corner.size());
    for (const sim::Index corner : sources.corner_of_corner) {
      corner_uv.push_back(corner == none ? glm::vec2(0.0F) : colours.corner_uv[corner]);
    }
    colours.corner_uv = std::move(corner_uv);
  }
  if (!colours.material_of_face.empty()) {
    std::vector<sim::Index> material_of_face;
    material_of_face.reserve(sources.face_of_triangle.size());
    for (const sim::Index face : sources.face_of_triangle) {
      material_of_face.push_back(face == none ? 0 : colours.material_of_face[face]);
    }
    colours.material_of_face = std::move(material_of_face);
  }
  return colours;
}

bool is_plain(const SurfaceColours& colours) {
  return colours.corner_uv.empty() && colours.material_of_face.empty();
}

}  // namespace

void encode(const SurfaceColours& colours, ArrayWriter& out) {
  out.put_list(colours.corner_uv);
  out.put_list(colours.material_of_face);
  put_all(colours.materials, out, [&](const SurfaceMaterial& material) {
    out.put_list(material.name);
    out.put(material.base_colour);
    out.put(material.map);
    out.put_list(material.map_file);
  });
  put_all(colours.maps, out, [&](const TextureImage& image) {
    out.put(image.width_px);
    out.put(image.height_px);
    out.put_list(*image.rgba);
  });
  put_all(colours.remarks, out, [&](const std::string& remark) { out.put_list(remark); });
}

SurfaceColours decode_colours(ArrayReader& in, std::size_t corners, std::size_t faces) {
  SurfaceColours colours;
  colours.corner_uv = in.take_list<std::vector<glm::vec2>>();
  colours.material_of_face = in.take_list<std::vector<sim::Index>>();
  take_all(colours.materials, in, [&](SurfaceMaterial& material) { material = take_material(in); });
  take_all(colours.maps, in, [&](TextureImage& image) { image = take_image(in); });
  take_all(colours.remarks, in, [&](std::string& remark) { remark = in.take_list<std::string>(); });
  require_colours(colours.corner_uv.empty() || colours.corner_uv.size() == corners);
  require_colours(colours.material_of_face.empty() || colours.material_of_face.size() == faces);
  require_colours(are_below(colours.material_of_face, colours.materials.size()));
  for (const SurfaceMaterial& material : colours.materials) {
    require_colours(material.map == no_map || material.map < colours.maps.size());
  }
  for (glm::vec2& uv : colours.corner_uv) {
    uv = std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : glm::vec2(0.0F);
  }
  return colours;
}

SurfaceColours cut_colours(SurfaceColours colours, std::span<const std::uint32_t> corner_counts,
                           std::span<const sim::Index> corners, std::span<const sim::Triangle> triangles) {
  if (is_plain(colours)) return colours;
  Sources sources;
  std::size_t first = 0, triangle = 0;
  for (sim::Index face = 0; face < corner_counts.size(); ++face) {
    const auto own = corners.subspan(first, corner_counts[face]);
    const auto corner_at = [&](sim::Index vertex) {
      return static_cast<sim::Index>(first + (std::find(own.begin(), own.end(), vertex) - own.begin()));
    };
    for (std::size_t k = 2; k < own.size(); ++k) {
      const auto& [a, b, c] = triangles[triangle++];
      sources.add(face, {corner_at(a), corner_at(b), corner_at(c)});
    }
    first += own.size();
  }
  return taken_from(std::move(colours), sources);
}

SurfaceColours kept_colours(SurfaceColours colours, std::span<const sim::Triangle> before,
                            std::span<const sim::Index> kept, std::span<const sim::Triangle> after) {
  if (is_plain(colours)) return colours;
  const auto sorted = [](sim::Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  // Of triangles with the same vertices the first was kept.
  std::vector<std::pair<sim::Triangle, sim::Index>> known;
  known.reserve(before.size());
  for (sim::Index t = 0; t < before.size(); ++t) {
    known.emplace_back(sorted({kept[before[t][0]], kept[before[t][1]], kept[before[t][2]]}), t);
  }
  std::sort(known.begin(), known.end());
  Sources sources;
  for (const sim::Triangle& t : after) {
    const auto source = std::lower_bound(known.begin(), known.end(), std::pair(sorted(t), sim::Index{0}));
    const sim::Index face = source == known.end() || source->first != sorted(t) ? none : source->second;
    std::array<sim::Index, 3> corners = {none, none, none};
    for (std::size_t k = 0; k < 3 && face != none; ++k) {
      for (sim::Index old = 0; old < 3; ++old) {
        corners[k] = kept[before[face][old]] == t[k] ? 3 * face + old : corners[k];
      }
    }
    sources.add(face, corners);
  }
  return taken_from(std::move(colours), sources);
}

SurfaceColours subdivided_colours(SurfaceColours colours) {
  std::vector<glm::vec2> corner_uv;
  for (std::size_t c = 0; c < colours.corner_uv.size(); c += 3) {
    const glm::vec2 &a = colours.corner_uv[c], &b = colours.corner_uv[c + 1], &d = colours.corner_uv[c + 2];
    const glm::vec2 ab = 0.5F * (a + b), bd = 0.5F * (b + d), da = 0.5F * (d + a);
    corner_uv.insert(corner_uv.end(), {a, ab, da, ab, b, bd, da, bd, d, ab, bd, da});
  }
  colours.corner_uv = std::move(corner_uv);
  std::vector<sim::Index> material_of_face;
  for (const sim::Index material : colours.material_of_face) {
    material_of_face.insert(material_of_face.end(), 4, material);
  }
  colours.material_of_face = std::move(material_of_face);
  return colours;
}

double metres_per_uv(const sim::Mesh& mesh, std::span<const glm::vec2> corner_uv) {
  std::vector<double> scales;
  for (std::size_t t = 0; 3 * t + 2 < corner_uv.size(); ++t) {
    const glm::dvec2 a(corner_uv[3 * t]);
    const glm::dvec2 ab = glm::dvec2(corner_uv[3 * t + 1]) - a, ac = glm::dvec2(corner_uv[3 * t + 2]) - a;
    const double in_uv = std::abs(ab.x * ac.y - ab.y * ac.x);
    const double in_m = glm::length(sim::doubled_area_vector(mesh.positions, mesh.triangles[t]));
    if (in_uv > 0.0 && in_m > 0.0) scales.push_back(std::sqrt(in_m / in_uv));
  }
  const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
  std::nth_element(scales.begin(), middle, scales.end());
  return scales.empty() ? 0.0 : *middle;
}

}  // namespace taut::app
