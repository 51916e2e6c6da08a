#pragma once

#include "app/base/errors.hpp"
#include "app/scene/scene_key.hpp"
#include "app/sewing/closing.hpp"

namespace taut::app {

/// How a pattern is sewn.
struct SewingSettings {
  int triangles = 4000;                          ///< about so many
  int frames = 600;                              ///< at most, from when it is worn until it rests
  std::vector<std::filesystem::path> over = {};  ///< patterns that are sewn over the scene's garment, inner ones first
  std::vector<std::string> over_fabrics = {};    ///< theirs (find_fabric()); empty: that of the scene's garment
  bool is_exact = false;                         ///< exactly so many triangles, of one pattern
};

/// How a garment lay while it was sewn.
struct SewingStep {
  const char* name = "";
  sim::Garment garment = {};
  std::vector<sim::Vec3> positions_m = {};
  double time_s = 0.0;  ///< of the bodies; the pattern lies where there are none
};

/// A pattern that was sewn on the body of a scene, as it rests there.
struct SewnGarment {
  SewingPattern pattern = {};  ///< of all layers; panels of outer ones are called "FILE.NAME"
  CutPieces pieces = {};
  std::string fabric = {};  ///< a name or an absolute path; empty: none was asked for
  std::vector<std::string> over_fabrics = {};
  std::vector<std::string> over_names = {};
  SewnPieces sewn = {};
  std::vector<std::string> remarks = {};  ///< for people
  std::vector<SewingStep> steps = {};     ///< its panels side by side, placed, half closed
  int frames = 0;                         ///< until it rested
  bool is_at_rest = false;
  double rms_speed_m_per_s = 0.0;  ///< in the last frame
  double max_stretch = 0.0;        ///< of any triangle in any direction, measured by code of its own, a fraction
  double bound = 0.0;              ///< of that, while it was sewn and worn
  double time_s = 0.0;             ///< of the bodies
};

/// The pattern cannot be sewn. The message says why.
struct SewingFailed : PromiseBroken {
  SewingFailed(const std::string& message, SewnGarment as_it_is)
      : PromiseBroken(message), garment(std::move(as_it_is)) {}

  SewnGarment garment;  ///< at that moment
};

/// Reads the pattern that is the scene's garment and sews it on the body that is dressed: pieces are placed
/// about the body while it is thin, their seams are drawn together, the body grows into what was sewn, and
/// that comes to rest. Requires that the bodies are loaded; `stage` is called with what is done. Throws
/// InputError, SewingFailed where a seam stays open or the garment is too small, Interrupted.
SewnGarment sew(Scene& scene, const SewingSettings& settings, const std::function<void(const std::string&)>& stage);

/// The garment as a Wavefront OBJ in metres: groups are named after panels, texture coordinates are cm of the
/// cloth.
std::string obj_of(const SewnGarment& garment);

/// The text of the file beside it (landmarks_path()): that it is at rest as its texture coordinates say, and
/// its seams.
std::string landmarks_of(const SewnGarment& garment);

/// Where a scene's garment is a sewing pattern, sews it on the last body that is read from a file, and lets
/// the scene begin with what was sewn: a file for this pattern, body, fabric and bound in the folder for
/// temporary files, which is sewn once. Leaves other scenes alone. To be called before load_bodies(). Returns
/// what was done, for people. Throws as sew() does, and InputError if there is no body.
std::vector<std::string> sew_garment(Scene& scene, const std::function<void(const std::string&)>& stage = {});

/// sew_garment() and then load_bodies(), of a scene with these overrides. Returns and throws as both do.
std::vector<std::string> sew_and_load_bodies(Scene& scene, std::span<const Override> overrides = {},
                                             const std::function<void(const std::string&)>& stage = {});

}  // namespace taut::app
