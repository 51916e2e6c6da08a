#pragma once

#include "app/bodies/dressing.hpp"
#include "app/scene/scene_file.hpp"

namespace taut::app {

/// Reads the meshes of the scene's bodies and opens their motions; bodies that were read already are left
/// alone. Returns what was guessed, chosen and repaired, a line each, for people. Throws InputError that
/// names the body, the file and the place:
/// - as make_body_mesh() does for a mesh that is not closed (body_mesh.hpp);
/// - on a motion of another number of vertices, or in which a vertex jumps by more than a metre in a frame
/// that the run shows; of later frames placed_frames() throws it when they are asked for;
/// - on a body that is to be dressed and whose vertices follow no joints.
/// It leaves room for so many garments over each other, or as many as the scene's is (GarmentFacts).
std::vector<std::string> load_bodies(Scene& scene, int garments = 1);

/// Frames in which a body grows into its clothes where nobody says how many.
inline constexpr int usual_dressing_frames = 90;

/// The same of a scene with these overrides. A garment and a body that are given together are worn: where the
/// overrides name a body that can be dressed and say nothing of it, it grows into the scene's model. The
/// pins of what is put on let go.
std::vector<std::string> load_bodies(Scene& scene, std::span<const Override> overrides);

/// A body with what its file has besides.
struct ReadBody {
  sim::BodyMesh mesh;
  std::shared_ptr<const Rig> rig;         ///< never null; empty if nothing in the file moves it
  JointPlaces joints;                     ///< as they were stored
  std::shared_ptr<const Wearer> wearer;   ///< null: it is not dressed
  std::string format;                     ///< name of the file's format
  std::vector<std::string> files = {};    ///< that were read: its own and those that it names
  std::vector<std::string> remarks = {};  ///< as load_bodies() returns them
  FileVertexPlaces places = {};           ///< of the mesh
  std::size_t file_vertices = 0;
};

/// Reads what moves the body in a file; never null, empty if nothing does. Throws InputError that names the
/// file.
std::shared_ptr<const Rig> read_rig(const std::filesystem::path& file);

/// How long a body is shown, from 0 s, at what rate, and in how many garments over each other.
struct ShownTime {
  double duration_s = 0.0;
  double frame_rate_hz = 60.0;
  int garments = 1;
};

/// Reads one body. Throws as load_bodies() does.
ReadBody read_body(const BodySource& source, const ShownTime& shown);
/// The same of a model that was read; the name of the source's file is for messages.
ReadBody body_of(const BodySource& source, ImportedModel model, const ShownTime& shown);

/// Prints the lines that load_bodies() returned, with the scene's name in front. Null: prints nothing.
void print_body_remarks(const Scene& scene, const std::vector<std::string>& remarks, std::FILE* output);

/// Reads a body and goes through all of its motion. Returns for programs, with units in the names of numbers:
/// its size, girths as it was stored, joints that vertices follow, the motion or the clip that is played, the
/// frames in which it crosses itself, of some spread over the motion, and what was guessed and repaired.
/// Throws InputError as load_bodies() does.
Json inspect_body(const BodySource& source);

}  // namespace taut::app
