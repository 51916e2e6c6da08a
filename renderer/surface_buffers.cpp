#include "renderer/surface_buffers.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::renderer {

namespace {

// Triangles whose vertices agree, after all the others.
void sort_decided_last(std::span<const std::uint32_t> triangles, std::span<const float> decided,
                       std::vector<std::uint32_t>& open, std::vector<std::uint32_t>& agreed) {
  open.clear();
  agreed.clear();
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const float first = decided[triangles[i]];
    const bool agree =
        first != 0.5F && decided[triangles[i + 1]] == first && decided[triangles[i + 2]] == first;
    std::vector<std::uint32_t>& list = agree ? agreed : open;
    list.insert(list.end(), triangles.begin() + static_cast<std::ptrdiff_t>(i),
                triangles.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
}

}  // namespace

SurfaceBuffers::SurfaceBuffers(const GladGLContext& context)
    : gl(&context),
      arrays(context),
      positions(context),
      normals(context),
      scalars(context),
      key_light(context),
      sky_light(context),
      materials(context),
      indices(context) {
  gl->BindVertexArray(arrays.name());
  set_attribute(*gl, 0, positions, 3, 3, 0);
  set_attribute(*gl, 1, normals, 3, 3, 0);
  set_attribute(*gl, 2, scalars, 1, 1, 0);
  set_attribute(*gl, 3, key_light, 1, 1, 0);
  set_attribute(*gl, 4, materials, 3, 3, 0);
  set_attribute(*gl, 5, sky_light, 2, 2, 0);
  gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
  gl->BindVertexArray(0);
}

void SurfaceBuffers::fill(const SurfaceView& surface, const VertexLight& light) {
  gl->BindVertexArray(arrays.name());
  upload(*gl, GL_ARRAY_BUFFER, positions, surface.positions);
  upload(*gl, GL_ARRAY_BUFFER, normals, surface.normals);
  shown.assign(surface.positions.size(), 0.0F);
  if (surface.scalars) {
    const ScalarColours& scalar = *surface.scalars;
    const float range = scalar.maximum - scalar.minimum;
    std::transform(scalar.values.begin(), scalar.values.end(), shown.begin(), [&](float value) {
      return std::isnan(value) ? -1.0F : std::clamp((value - scalar.minimum) / range, 0.0F, 1.0F);
    });
  }
  upload(*gl, GL_ARRAY_BUFFER, scalars, std::span<const float>(shown));
  upload(*gl, GL_ARRAY_BUFFER, key_light, std::span<const float>(light.key));
  upload(*gl, GL_ARRAY_BUFFER, sky_light, std::span<const glm::vec2>(light.sky));
  // Any coordinates do where there is no weave, but an array without contents must not be read.
  const bool woven = !surface.material_coordinates.empty();
  upload(*gl, GL_ARRAY_BUFFER, materials, woven ? surface.material_coordinates : surface.positions);
  sort_decided_last(surface.triangles, light.key, open, agreed);
  open_count = static_cast<GLsizei>(open.size());
  open.insert(open.end(), agreed.begin(), agreed.end());
  upload(*gl, GL_ELEMENT_ARRAY_BUFFER, indices, std::span<const std::uint32_t>(open));
  index_count = static_cast<GLsizei>(open.size());
  gl->BindVertexArray(0);
}

void SurfaceBuffers::draw_open() const {
  draw_range(0, open_count);
}

void SurfaceBuffers::draw_decided() const {
  draw_range(open_count, index_count - open_count);
}

void SurfaceBuffers::draw_range(GLsizei first, GLsizei count) const {
  if (count == 0) return;
  gl->BindVertexArray(arrays.name());
  const auto offset = static_cast<std::uintptr_t>(first) * sizeof(std::uint32_t);
  gl->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

}  // namespace taut::renderer
