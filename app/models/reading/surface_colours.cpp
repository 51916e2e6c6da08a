#include "app/models/reading/surface_colours.hpp"

#include <stb_image.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

/// Sources of new triangles in old ones: a face per triangle, a corner per corner; `none` for a new triangle.
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

bool is_plain(const SurfaceColours& colours) { return colours.corner_uv.empty() && colours.material_of_face.empty(); }

namespace fs = std::filesystem;

/// Returns the image at half its width and height, without a last odd row or column. Colours are weighted by their
/// alpha.
TextureImage halve_image(const TextureImage& image) {
  TextureImage half{std::max(image.width_px / 2, 1U), std::max(image.height_px / 2, 1U), nullptr};
  std::vector<std::uint8_t> rgba(std::size_t{4} * half.width_px * half.height_px);
  for (std::uint32_t y = 0; y < half.height_px; ++y) {
    for (std::uint32_t x = 0; x < half.width_px; ++x) {
      std::array<unsigned, 3> sums{};
      unsigned alphas = 0, pixels = 0;
      for (const std::uint32_t row : {2 * y, std::min(2 * y + 1, image.height_px - 1)}) {
        for (const std::uint32_t column : {2 * x, std::min(2 * x + 1, image.width_px - 1)}) {
          const std::uint8_t* pixel = image.rgba->data() + 4 * (std::size_t{row} * image.width_px + column);
          for (std::size_t k = 0; k < 3; ++k) sums[k] += unsigned{pixel[k]} * pixel[3];
          alphas += pixel[3];
          ++pixels;
        }
      }
      std::uint8_t* to = rgba.data() + 4 * (std::size_t{y} * half.width_px + x);
      for (std::size_t k = 0; k < 3; ++k) {
        to[k] = static_cast<std::uint8_t>((sums[k] + alphas / 2) / std::max(alphas, 1U));
      }
      to[3] = static_cast<std::uint8_t>((alphas + pixels / 2) / pixels);
    }
  }
  half.rgba = std::make_shared<const std::vector<std::uint8_t>>(std::move(rgba));
  return half;
}

/// Returns the largest side that this many square images may have.
std::uint32_t max_side_px(std::size_t images) {
  std::uint32_t side_px = 4096;
  while (side_px > 64 && images * 4 * side_px * side_px > max_map_bytes) side_px /= 2;
  return side_px;
}

/// Returns the image times a colour, in linear light.
TextureImage tint_image(const TextureImage& image, const glm::vec3& tint, bool is_opaque) {
  std::array<std::array<std::uint8_t, 256>, 3> channels{};
  for (int k = 0; k < 3; ++k) {
    for (std::size_t value = 0; value < 256; ++value) {
      const float light = srgb_to_linear(static_cast<float>(value) / 255.0F) * srgb_to_linear(tint[k]);
      channels[static_cast<std::size_t>(k)][value] = static_cast<std::uint8_t>(255.0F * linear_to_srgb(light) + 0.5F);
    }
  }
  std::vector<std::uint8_t> rgba = *image.rgba;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    for (std::size_t k = 0; k < 3; ++k) rgba[i + k] = channels[k][rgba[i + k]];
    rgba[i + 3] = is_opaque ? 255 : rgba[i + 3];
  }
  return {image.width_px, image.height_px, std::make_shared<const std::vector<std::uint8_t>>(std::move(rgba))};
}

/// Returns the paths where an image may be: its name, or else the last part of its name beside the model. Models often
/// name paths of the machine that they were made on.
std::vector<fs::path> candidate_paths(const std::string& name, const fs::path& folder) {
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const fs::path last = fs::path(slashed).filename();
  return {folder / slashed, folder / last, folder / "textures" / last};
}

/// Reads no file outside of the model's folder, because a model could name any file of the machine.
std::string read_named_file(const std::string& name, const fs::path& folder, std::vector<std::string>& files) {
  const std::vector<fs::path> places = candidate_paths(name, folder);
  bool is_outside = false;
  for (const fs::path& place : places) {
    std::error_code error;
    if (fs::is_regular_file(place, error) && is_inside(place, folder)) {
      files.push_back(place.string());
      return read_text_file(place, max_model_bytes);
    }
    is_outside |= fs::exists(place, error);
  }
  throw InputError("it is neither '{}' nor '{}' nor '{}'{}", places[0].lexically_normal().string(),
                   places[1].lexically_normal().string(), places[2].lexically_normal().string(),
                   is_outside ? ", of which nothing outside of the model's folder is read" : "");
}

TextureImage read_map(const SurfaceMaterial& material, const fs::path& folder, const EmbeddedImage& embedded,
                      std::uint32_t max_px, std::vector<std::string>& files) {
  const std::optional<std::string_view> inside = embedded(material.map_file);
  const TextureImage image = fitted_to(
      decode_image(inside ? std::string(*inside) : read_named_file(material.map_file, folder, files)), max_px);
  const bool is_tinted = material.map_tint != glm::vec3(1.0F);
  return is_tinted || material.map_is_opaque ? tint_image(image, material.map_tint, material.map_is_opaque) : image;
}

}  // namespace

bool is_inside(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path way = fs::canonical(file, error).lexically_relative(fs::canonical(folder, error));
  return !way.empty() && *way.begin() != "..";
}

SurfaceColours cut_colours(SurfaceColours colours, std::span<const std::uint32_t> corner_counts,
                           std::span<const sim::Index> corners, std::span<const sim::Triangle> triangles) {
  if (is_plain(colours)) return colours;
  Sources sources;
  std::size_t first = 0, triangle = 0;
  for (sim::Index face = 0; face < corner_counts.size(); ++face) {
    const auto own = corners.subspan(first, corner_counts[face]);
    const auto corner_at = [&](sim::Index vertex) {
      return static_cast<sim::Index>(first + (std::ranges::find(own, vertex) - own.begin()));
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
    std::ranges::sort(t);
    return t;
  };
  // The first of several triangles with the same vertices was kept.
  std::vector<std::pair<sim::Triangle, sim::Index>> known;
  known.reserve(before.size());
  for (sim::Index t = 0; t < before.size(); ++t) {
    known.emplace_back(sorted({kept[before[t][0]], kept[before[t][1]], kept[before[t][2]]}), t);
  }
  std::ranges::sort(known);
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

TextureImage fitted_to(TextureImage image, std::uint32_t max_px) {
  while (std::max(image.width_px, image.height_px) > max_px) image = halve_image(image);
  return image;
}

TextureImage decode_image(std::string_view bytes) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(std::min<std::size_t>(bytes.size(), 1U << 30U));
  int width_px = 0, height_px = 0, channels = 0;
  if (stbi_info_from_memory(data, size, &width_px, &height_px, &channels) == 0) {
    throw InputError("it is no image that can be read, such as PNG or JPEG ({})", stbi_failure_reason());
  }
  if (std::size_t(width_px) * std::size_t(height_px) > max_pixels) {
    throw InputError("it has {} x {} pixels, more than the {} that are read", width_px, height_px, max_pixels);
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, size, &width_px, &height_px, &channels, 4), stbi_image_free);
  if (pixels == nullptr) throw InputError("it is damaged ({})", stbi_failure_reason());
  const std::size_t count = std::size_t{4} * std::size_t(width_px) * std::size_t(height_px);
  return {static_cast<std::uint32_t>(width_px), static_cast<std::uint32_t>(height_px),
          std::make_shared<const std::vector<std::uint8_t>>(pixels.get(), pixels.get() + count)};
}

void read_maps(const fs::path& folder, const EmbeddedImage& embedded, SurfaceColours& colours) {
  // Images that look the same are read once. Their look is the name, the tint and whether alpha counts.
  using Look = std::tuple<std::string, float, float, float, bool>;
  std::map<Look, sim::Index> known;
  const auto look_of = [](const SurfaceMaterial& material) {
    const glm::vec3& tint = material.map_tint;
    return Look(material.map_file, tint.x, tint.y, tint.z, material.map_is_opaque);
  };
  for (const SurfaceMaterial& material : colours.materials) known.emplace(look_of(material), no_map);
  const std::uint32_t max_px = max_side_px(known.size());
  for (SurfaceMaterial& material : colours.materials) {
    if (material.map_file.empty()) continue;
    sim::Index& map = known[look_of(material)];
    try {
      if (map == no_map) {
        colours.maps.push_back(read_map(material, folder, embedded, max_px, colours.files));
        map = static_cast<sim::Index>(colours.maps.size() - 1);
      }
      material.map = map;
    } catch (const InputError& error) {
      colours.remarks.push_back(fmt::format("the image '{}' of its material '{}' is not drawn, its base colour is: {}",
                                            material.map_file, material.name, error.what()));
    }
  }
}

}  // namespace taut::app
