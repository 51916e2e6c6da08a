#pragma once

#include <memory>

#include "app/bodies/point_cache.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/output/output_pattern.hpp"

namespace taut::app {

// The formats behind open_sink(), which see. `loaded` must outlive them.

/// One OBJ of the last frame, or one of each.
std::unique_ptr<FrameSink> make_obj_sink(const ExportSettings& settings, const GarmentInScene& loaded);

/// PC2 or MDD, and beside it an OBJ of the same vertices at rest.
std::unique_ptr<FrameSink> make_point_cache_sink(PointCacheFormat format, const ExportSettings& settings,
                                                 const GarmentInScene& loaded, const WrittenMoment& start);

/// One binary glTF 2.0 with a morph target for each frame and an animation that plays them. It holds them in
/// memory until the end. Throws InputError if they would be more than a gibibyte.
std::unique_ptr<FrameSink> make_gltf_sink(const ExportSettings& settings, const GarmentInScene& loaded);

/// How many frames that is.
int most_gltf_frames(const GarmentInScene& loaded);

/// A PVD collection and a folder beside it with a VTP file for each frame: the simulated mesh with the
/// stretch of its triangles and vertices, and the smallest distance of the frame.
std::unique_ptr<FrameSink> make_vtk_sink(const ExportSettings& settings);

/// NAME.obj beside NAME.pc2.
std::filesystem::path obj_beside(const std::filesystem::path& cache);

/// Frame `frame` of the folder beside the collection: NAME/NAME_0001.vtp.
std::filesystem::path vtp_beside(const std::filesystem::path& collection, int frame);

}  // namespace taut::app
