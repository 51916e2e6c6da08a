#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/garments/dressing/dressing.hpp"
#include "app/scene/scene_file.hpp"

namespace taut::app {

/// Reads the meshes of the scene's bodies and opens their motions. Meshes that the caller gave are taken as they are.
/// Throws InputError that names the body, the file and the place:
/// - as make_body_mesh() does for a mesh that is not closed (body_mesh.hpp);
/// - on a motion of another number of vertices, or in which a vertex jumps by more than a metre in a frame that the run
/// shows; placed_frames() throws it for later frames when they are read;
/// - on a body that is to be dressed and whose vertices follow no joints.
/// Leaves clearance for `garments` layers, or for as many as the scene's garment has (GarmentFacts).
LoadedBodies load_bodies(const Scene& scene, int garments = 1);

/// Reads one body of the scene again, and returns the bodies with its remarks alone. Throws as load_bodies() does.
LoadedBodies reload_body(const Scene& scene, std::size_t body, LoadedBodies bodies);

/// Number of frames in which a body grows into its clothes if none is given.
inline constexpr int usual_dressing_frames = 90;

/// Decides whether a scene that has these overrides dresses its body, changes the scene to that, and loads its bodies.
/// A garment and a body that are given together are dressed: where the overrides name a body that can be dressed and do
/// not set `body.dress`, the body grows into the scene's model. The pins of a dressed garment are removed.
LoadedBodies choose_dressing(std::span<const Override> overrides, Scene& scene);

/// A body with the other contents of its file.
struct ReadBody {
  sim::BodyMesh mesh;
  std::shared_ptr<const Rig> rig;         ///< never null; empty if nothing in the file moves the body
  JointPlaces joints;                     ///< joints of the stored pose
  std::shared_ptr<const Wearer> wearer;   ///< null if the body is not dressed
  std::string format;                     ///< name of the file's format
  std::vector<std::string> files = {};    ///< files that were read: the body's and those that it names
  std::vector<std::string> remarks = {};  ///< lines for people
  FileVertexPlaces places = {};           ///< vertices and placement of the mesh
  std::size_t file_vertices = 0;
};

/// Reads the rig of a body. Returns an empty one, never null, if nothing in the file moves the body. Throws InputError
/// that names the file.
std::shared_ptr<const Rig> read_rig(const std::filesystem::path& file);

/// Duration that a body is shown, from 0 s, frame rate, and number of garments worn over each other.
struct ShownTime {
  double duration_s = 0.0;
  double frame_rate_hz = 60.0;
  int garments = 1;
};

/// Reads one body. Throws as load_bodies() does.
ReadBody read_body(const BodySource& source, const ShownTime& shown);
/// Makes a body of a model that was read. The name of the source's file is used in messages.
ReadBody make_body(const BodySource& source, ImportedModel model, const ShownTime& shown);

/// Prints the remarks of load_bodies() and other lines, with the scene's name in front. Prints nothing to a null file.
void print_body_remarks(const Scene& scene, const std::vector<std::string>& remarks, std::FILE* output);

/// Reads a body and all of its motion. Returns, for programs and with units in the names of numbers: its size, the
/// girths of the stored pose, the joints that vertices follow, the motion or the clip that is played, the examined
/// frames in which the body crosses itself, and the guesses and repairs. The examined frames are spread over the
/// motion. Throws InputError as load_bodies() does.
nlohmann::ordered_json inspect_body(const BodySource& source);

}  // namespace taut::app
