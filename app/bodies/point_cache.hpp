#pragma once

#include "app/base/files.hpp"
#include "app/bodies/frame_source.hpp"

namespace taut::app {

/// Opens a point cache (PC2, version 1; Autodesk's "Point Oven" layout). It holds 32-bit numbers, lowest byte
/// first. How fast it is played is not in it. Throws InputError that names the file, where, what was found
/// and what was expected.
std::unique_ptr<const FrameSource> open_pc2(const std::filesystem::path& file);

/// Opens a LightWave motion cache (MDD): the number of frames and of points, the time of each frame in
/// seconds, then positions, as 32-bit numbers, highest byte first. Its rate is the mean one of its times.
/// Throws InputError as above.
std::unique_ptr<const FrameSource> open_mdd(const std::filesystem::path& file);

// The same layouts, to be written.

enum class PointCacheFormat { pc2, mdd };

/// The header of a cache.
struct PointCacheContent {
  std::size_t vertices = 0;
  std::size_t frames = 0;
  int first_frame = 0;  ///< its number
  double frame_rate_hz = 0.0;
};

/// Returns what such a file begins with; the positions of its frames follow.
std::string point_cache_header(PointCacheFormat format, const PointCacheContent& content);
/// Returns how many bytes it has.
std::size_t point_cache_header_bytes(PointCacheFormat format, std::size_t frames);
/// Returns the positions of one frame in single precision.
std::string point_cache_frame(PointCacheFormat format, std::span<const sim::Vec3> positions);
/// Returns how many bytes a frame has in both formats.
std::size_t point_cache_frame_bytes(std::size_t vertices);
/// Returns the number of frames that the header of a file says, complete or not; nothing if it has none.
std::optional<std::size_t> point_cache_frames(PointCacheFormat format, const SeekableFile& file);

}  // namespace taut::app
