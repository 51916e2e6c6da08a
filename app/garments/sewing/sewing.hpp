#pragma once

#include "app/base/errors.hpp"
#include "app/garments/sewing/closing.hpp"
#include "app/scene/scene_file.hpp"

namespace taut::app {

/// A pattern that was read, and its file.
struct NamedPattern {
  std::filesystem::path file;
  SewingPattern pattern;
};

/// Reads a pattern as read_sewing_pattern().
inline NamedPattern read_named_pattern(const std::filesystem::path& file) { return {file, read_sewing_pattern(file)}; }

/// Settings of sewing.
struct SewingSettings {
  int triangles = 4000;                        ///< approximate count
  int frames = 1500;                           ///< largest count, from the start of wearing until rest
  std::vector<NamedPattern> over = {};         ///< patterns that are sewn over the first, inner ones first
  std::vector<std::string> over_fabrics = {};  ///< their fabrics (find_fabric()); empty: the scene's fabric
  bool is_exact = false;                       ///< true for the exact count of triangles, with one pattern
};

/// State of a garment during sewing.
struct SewingStep {
  const char* name = "";
  sim::Garment garment = {};
  std::vector<sim::Vec3> positions_m = {};
  double time_s = 0.0;  ///< time of the bodies; the flat pattern lies where there are none
};

/// A pattern that was sewn, at rest.
struct SewnGarment {
  SewingPattern pattern = {};  ///< pattern of all layers; panels of outer layers are named "FILE.NAME"
  CutPieces pieces = {};
  std::string fabric = {};  ///< name or absolute path; empty if none was requested
  std::vector<std::string> over_fabrics = {};
  std::vector<std::string> over_names = {};
  SewnPieces sewn = {};
  std::vector<std::string> remarks = {};  ///< for people
  std::vector<SewingStep> steps = {};     ///< panels side by side, placed, half closed
  int frames = 0;                         ///< count until rest
  bool is_at_rest = false;
  double rms_speed_m_per_s = 0.0;  ///< speed in the last frame
  double max_stretch = 0.0;        ///< largest stretch of any triangle in any direction, a fraction
  double bound = 0.0;              ///< bound of this stretch during sewing and wearing
  double time_s = 0.0;             ///< time of the bodies
};

/// A pattern that cannot be sewn. The message says why.
struct SewingFailed : PromiseBroken {
  SewingFailed(const std::string& message, SewnGarment as_it_is)
      : PromiseBroken(message), garment(std::move(as_it_is)) {}

  SewnGarment garment;  ///< state at that moment
};

/// Sews a pattern on the dressed body of a scene: pieces are placed about the thin body, their seams are drawn
/// together, the body grows into the garment, and the garment comes to rest in the scene's air. Without a body, the
/// pieces close where the pattern places them, and the garment comes to rest without gravity and wind.
/// `stage` is called with a description of each stage. Throws InputError, SewingFailed if a seam stays open or the
/// garment is too small, and Interrupted.
SewnGarment sew(NamedPattern pattern, const Scene& scene, LoadedBodies& bodies, const SewingSettings& settings,
                const std::function<void(const std::string&)>& stage);

/// Measures the stretch of a garment that was sewn. Throws SewingFailed if it is not on its body, crosses something or
/// exceeds the bound.
void require_worn(const Scene& scene, const LoadedBodies& bodies, SewnGarment& garment);

/// Returns "at rest", or how the garment still moves.
std::string describe_rest(const SewnGarment& garment);

/// Returns the garment as a Wavefront OBJ in metres. Groups are named after panels; texture coordinates are cm of the
/// cloth.
std::string to_obj(const SewnGarment& garment);

/// Returns the text of the file beside it (landmarks_path()): its seams, and that texture coordinates give its rest
/// lengths.
std::string to_landmarks_text(const SewnGarment& garment);

/// Sews the scene's garment, if it is a sewing pattern, on the last body that is read from a file, or without a body,
/// and lets the scene begin with the result. The result is a file for this pattern, body, fabric and bound in the
/// folder for temporary files, which is sewn once. Other scenes are unchanged. Must be called before load_bodies().
/// Returns a report for people. Throws as sew() does.
std::vector<std::string> sew_garment(Scene& scene, const std::function<void(const std::string&)>& stage = {});

/// Calls sew_garment() and then choose_dressing(). Returns and throws as both do; the report comes before the remarks.
LoadedBodies sew_and_load_bodies(Scene& scene, std::span<const Override> overrides = {},
                                 const std::function<void(const std::string&)>& stage = {});

}  // namespace taut::app
