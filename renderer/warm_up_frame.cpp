#include "renderer/warm_up_frame.hpp"

#include <algorithm>

namespace taut::renderer {

FrameView WarmUpFrame::view(bool scalars) const {
  FrameView frame;
  SurfaceView surface;
  surface.positions = positions_;
  surface.normals = normals_;
  surface.triangles = triangles_;
  surface.material_coordinates = positions_;
  if (scalars) surface.scalars = ScalarColours{scalars_};
  frame.surfaces.push_back(surface);
  frame.ground_height_m = -0.5F;
  frame.camera.eye = {0.0F, 3.0F, 4.0F};
  frame.camera.target = {0.0F, 0.0F, 0.0F};
  return frame;
}

PictureSettings WarmUpFrame::small(const PictureSettings& settings) {
  PictureSettings less = settings;
  less.width_px = less.height_px = 64;
  less.shadow_map_px = 256;
  less.sky_directions = std::min(settings.sky_directions, 2);
  return less;
}

}  // namespace taut::renderer
