#include "renderer/surface_buffers.hpp"

#include <algorithm>
#include <cmath>

namespace taut::renderer {

SurfaceBuffers::SurfaceBuffers(const GladGLContext& context)
    : gl(&context),
      arrays(context),
      positions(context),
      normals(context),
      scalars(context),
      indices(context) {
  gl->BindVertexArray(arrays.name());
  set_attribute(*gl, 0, positions, 3, 3, 0);
  set_attribute(*gl, 1, normals, 3, 3, 0);
  set_attribute(*gl, 2, scalars, 1, 1, 0);
  gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
  gl->BindVertexArray(0);
}

void SurfaceBuffers::fill(const SurfaceView& surface) {
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
  upload(*gl, GL_ELEMENT_ARRAY_BUFFER, indices, surface.triangles);
  index_count = static_cast<GLsizei>(surface.triangles.size());
  gl->BindVertexArray(0);
}

void SurfaceBuffers::draw() const {
  if (index_count == 0) return;
  gl->BindVertexArray(arrays.name());
  gl->DrawElements(GL_TRIANGLES, index_count, GL_UNSIGNED_INT, nullptr);
}

}  // namespace taut::renderer
