#pragma once

#include <filesystem>

#include "app/base/files.hpp"
#include "app/bodies/rig_pose.hpp"
#include "app/models/hanging/placement.hpp"

namespace taut::app {

/// Positions of a model file's vertices in each frame of a motion, in the model's unit and axes. Frames are computed or
/// read on request, so that memory does not grow with the length of the motion. Several threads may read at once. The
/// same frame always has the same positions.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Returns the number of frames, at least 1.
  virtual std::size_t frames() const = 0;
  /// Returns the number of vertices in each frame.
  virtual std::size_t vertices() const = 0;
  /// Returns the number of frames in a second; empty if the motion does not say.
  virtual std::optional<double> rate_hz() const = 0;
  /// Fills `positions` with the vertices of the frame. Requires a frame below frames() and a span with an entry for
  /// each vertex. Throws InputError that names the file if it cannot be read.
  virtual void read(std::size_t frame, std::span<sim::Vec3> positions) const = 0;
  /// Returns the joints in the frame; empty if the motion moves no joints but vertices.
  virtual std::optional<RigPose> pose(std::size_t /*frame*/) const { return std::nullopt; }
};

/// Largest distance that a vertex moves from one frame to the next, in m. Frames that exceed it belong to another body.
inline constexpr double max_motion_per_frame_m = 1.0;

/// Axes of a motion: the axis and the sign of each of its body's x, y and z.
struct AxisSystem {
  const char* name = "x, y, z";
  std::array<int, 3> axis = {0, 1, 2};
  sim::Vec3 sign{1.0};

  sim::Vec3 operator()(const sim::Vec3& p) const { return sign * sim::Vec3(p[axis[0]], p[axis[1]], p[axis[2]]); }
};

/// Map from a body's vertices to the vertices of its file.
struct FileVertexPlaces {
  std::vector<std::size_t> file_vertex;  ///< per vertex of the body, its vertex in the file
  Placement placement;
  AxisSystem motion_axes = {};  ///< axes of the frames of its motion
};

/// Returns a motion as the frames of a body in the scene, in m. The last few are cached, since a simulation
/// reads the same two again and again. A frame is compared with the frames before and after it that are cached, so that
/// a jump between two consecutive frames is found. Frames throw InputError that names the file, the frame of the file
/// and the vertex of the file if a position is not a number or a vertex moves by more than a metre in one frame.
/// `motion` is the file's name, for messages. Frames before `first` are left out. Requires that the source has this
/// frame, and a rate above 0.
std::shared_ptr<const sim::BodyFrames> placed_frames(std::filesystem::path motion,
                                                     std::unique_ptr<const FrameSource> source, FileVertexPlaces places,
                                                     double rate_hz, std::size_t first);

/// Opens a point cache (PC2, version 1; Autodesk's "Point Oven" layout). It holds 32-bit numbers, lowest byte first. It
/// does not hold the frame rate. Throws InputError that names the file, the place, and the found and expected content.
std::unique_ptr<const FrameSource> open_pc2(const std::filesystem::path& file);

// Functions that write the same layout.

/// Content of a cache, for its header.
struct PointCacheContent {
  std::size_t vertices = 0;
  std::size_t frames = 0;
  int first_frame = 0;  ///< number of the first frame
};

inline constexpr std::size_t pc2_header_bytes = 32;

/// Returns the header of a file; the positions of its frames follow.
std::string pc2_header(const PointCacheContent& content);
/// Returns the positions of one frame in single precision.
std::string pc2_frame(std::span<const sim::Vec3> positions);
/// Returns the number of frames in the header of a file, whether the file is complete or not; nothing if it has no
/// header.
std::optional<std::size_t> pc2_frames(const SeekableFile& file);

struct OpenedMotion {
  std::filesystem::path file;
  std::unique_ptr<const FrameSource> frames = nullptr;  ///< null if the body keeps its shape
  std::vector<std::string> remarks = {};                ///< choices and mismatches, for people
};

/// Frame rate of clips, and of motions whose file has none, if the source gives none.
inline constexpr double usual_frame_rate_hz = 60.0;

/// Opens the motion that a body's source names, by the ending of its file. Without such a name, opens the clip of its
/// model that the source names. `rig` is the model's, empty if it has none, and `up` is the axis of the model that is
/// up. Throws InputError that names the file.
OpenedMotion open_motion(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up);

/// Opens a BVH file (bvh_frames.cpp) likewise.
OpenedMotion open_bvh(const BodySource& source, const std::shared_ptr<const Rig>& rig, ModelAxis up);

/// Frame at which a motion that repeats continues after its last frame.
struct LoopBegin {
  std::size_t frame = 0;
  double max_distance_m = 0.0;  ///< largest distance of a vertex from its position in the last frame
  bool meets = false;           ///< true if the last frame equals this one within 1 mm
};

/// Returns the earliest frame in which every vertex is within 1 mm of its position in the last one, so that the lead-in
/// of a motion is not repeated. The first half and the first two seconds are searched. Returns the first frame if there
/// is none. Throws what the motion throws.
LoopBegin find_loop_begin(const sim::BodyFrames& motion, std::size_t vertices);

/// Describes for people how a motion that repeats continues.
std::string describe(const LoopBegin& begin);

/// Returns the motion from the frame `first`, repeated from `begin` without end. Throws InputError if a vertex moves
/// further from the last frame to the start than it may in a frame (placed_frames()).
std::shared_ptr<const sim::BodyFrames> make_loop(std::shared_ptr<const sim::BodyFrames> motion, const LoopBegin& begin,
                                                 std::size_t first);

inline constexpr std::size_t no_clip = static_cast<std::size_t>(-1);

/// Returns the names of the clips. A clip without a name is named by its number, counted from 1.
std::vector<std::string> names_of_clips(const Rig& rig);

/// Returns "'Walk' (1.2 s), 'Wave' (3 s)", or "none".
std::string describe_clips(const Rig& rig);

}  // namespace taut::app
