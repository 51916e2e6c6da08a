#pragma once

#include <filesystem>

#include "app/base/files.hpp"
#include "app/bodies/rig_pose.hpp"
#include "app/models/placement.hpp"

namespace taut::app {

/// Where the vertices of a model file are in each frame of a motion, in the model's unit and axes. Frames are
/// computed or read as they are asked for, so that memory does not grow with the length of the motion.
/// Several threads may ask at once, and the same question has the same answer.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Returns how many frames there are, at least 1.
  virtual std::size_t frames() const = 0;
  /// Returns how many vertices each frame has.
  virtual std::size_t vertices() const = 0;
  /// Returns how many frames there are in a second; empty if the motion does not say.
  virtual std::optional<double> rate_hz() const = 0;
  /// Fills `positions` with where each vertex is in the frame. Requires a frame below frames() and a span
  /// with an entry for each vertex. Throws InputError that names the file if it cannot be read.
  virtual void read(std::size_t frame, std::span<sim::Vec3> positions) const = 0;
  /// Returns the joints in the frame; empty if the motion moves no joints but vertices.
  virtual std::optional<RigPose> pose(std::size_t /*frame*/) const { return std::nullopt; }
};

/// The furthest a vertex goes from one frame to the next, in m. Further, the frames are of something else.
inline constexpr double furthest_in_frame_m = 1.0;

/// How vertices of a file become those of a body.
struct FileVertexPlaces {
  std::vector<std::size_t> file_vertex;  ///< per vertex of the body, the vertex of the file that is meant
  Placement placement;
};

/// Returns the frames of a motion as those of a body in the scene, in m. The last few are remembered, as a simulation
/// asks for the same two again and again. A frame that is remembered beside the one before it or after it was
/// compared with it, so that no two frames in a row are handed out between which a vertex jumps: for a frame in
/// which a position is not a number, or a vertex goes further than a metre from the one before, they throw
/// InputError that names the file, the frame of the file and the vertex of the file.
///
/// `motion` is the file's name, for messages. Frames before `first` are left out: requires one that the
/// source has, and a rate above 0.
std::shared_ptr<const sim::BodyFrames> placed_frames(std::filesystem::path motion,
                                                     std::unique_ptr<const FrameSource> source, FileVertexPlaces places,
                                                     double rate_hz, std::size_t first);

/// Opens a point cache (PC2, version 1; Autodesk's "Point Oven" layout). It holds 32-bit numbers, lowest byte
/// first. How fast it is played is not in it. Throws InputError that names the file, where, what was found
/// and what was expected.
std::unique_ptr<const FrameSource> open_pc2(const std::filesystem::path& file);

// The same layout, to be written.

/// The header of a cache.
struct PointCacheContent {
  std::size_t vertices = 0;
  std::size_t frames = 0;
  int first_frame = 0;  ///< its number
};

inline constexpr std::size_t pc2_header_bytes = 32;

/// Returns what such a file begins with; the positions of its frames follow.
std::string pc2_header(const PointCacheContent& content);
/// Returns the positions of one frame in single precision.
std::string pc2_frame(std::span<const sim::Vec3> positions);
/// Returns the number of frames that the header of a file says, complete or not; nothing if it has none.
std::optional<std::size_t> pc2_frames(const SeekableFile& file);

/// The motion of a body and the file it is in.
struct OpenedMotion {
  std::filesystem::path file;
  std::unique_ptr<const FrameSource> frames = nullptr;  ///< null: the body keeps its shape
  std::vector<std::string> remarks = {};                ///< what was chosen and did not fit, for people
};

/// How often a clip is looked at, and how fast a motion is played that does not say, if nobody asks for more.
inline constexpr double usual_frame_rate_hz = 60.0;

/// Opens the motion that a body's source names, by the ending of its file; without one, the clip of its model
/// that is asked for. `rig` is that of the model, empty if it has none, and `up` the direction of the
/// model that is up. Throws InputError that names the file.
OpenedMotion open_motion(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up);

/// The same of a BVH file (bvh_frames.cpp).
OpenedMotion open_bvh(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up);

/// Where a motion that repeats goes on after its last frame.
struct LoopBegin {
  std::size_t frame = 0;
  double furthest_m = 0.0;  ///< that a vertex is from where it is in the last frame
  bool meets = false;       ///< within 1 mm: the last frame is this one again
};

/// Returns the earliest frame at which every vertex is within 1 mm of where it is in the last one, so that
/// what leads into a motion is not repeated. It is looked for in the first half and the first two seconds; if
/// there is none, the first frame is returned. Throws what the motion throws.
LoopBegin find_loop_begin(const sim::BodyFrames& motion, std::size_t vertices);

/// How a motion that repeats goes on, for people.
std::string describe(const LoopBegin& begin);

/// Returns the motion from the frame `first` on, and again from `begin` on without end. Throws InputError if
/// a vertex goes further from the last frame to the begin than it may in a frame (placed_frames()).
std::shared_ptr<const sim::BodyFrames> looped(std::shared_ptr<const sim::BodyFrames> motion, const LoopBegin& begin,
                                              std::size_t first);

inline constexpr std::size_t no_clip = static_cast<std::size_t>(-1);

/// Returns the names of the clips; of one without a name its number, counted from 1.
std::vector<std::string> names_of_clips(const Rig& rig);

/// Returns "'Walk' (1.2 s), 'Wave' (3 s)", or "none".
std::string describe_clips(const Rig& rig);

}  // namespace taut::app
