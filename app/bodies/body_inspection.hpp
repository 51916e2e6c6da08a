#pragma once

#include "app/bodies/body_girths.hpp"
#include "app/bodies/motion_opening.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

/// The fastest that a vertex of a body is.
struct FastestVertex {
  double speed_m_per_s = 0.0;
  std::size_t frame = 0;  ///< of the motion, into which it goes
  sim::Vec3 place_m = sim::Vec3(0.0);
};

/// How a body moves over time.
struct MotionInspection {
  std::size_t frames = 0;
  double rate_hz = 0.0;
  FastestVertex fastest;
  LoopBegin loop;  ///< where it goes on if it repeats
};

/// Where a body crosses itself.
struct CrossingFrame {
  std::size_t frame = 0;
  std::string pairs;  ///< how many, and where the first is, for people
};

/// The contents of a body's file, and its motion.
struct BodyInspection {
  std::string file;
  std::string format;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t shells = 0;  ///< closed surfaces by themselves
  sim::Vec3 size_m = sim::Vec3(0.0);
  double volume_m3 = 0.0;
  std::vector<Girth> girths;               ///< as it was stored, upright and looking along z
  std::vector<std::string> joints;         ///< that vertices follow
  std::size_t shapes = 0;                  ///< that are mixed in
  std::string clips;                       ///< names and lengths, or "none"
  std::optional<MotionInspection> motion;  ///< of the motion or the clip that is played
  std::size_t frames_looked_at = 0;        ///< for crossings, spread over the motion
  std::vector<CrossingFrame> crossings;
  std::vector<std::string> remarks;  ///< what was guessed, chosen and repaired
};

/// Reads a body and goes through all of its motion. Throws InputError as load_bodies() does.
BodyInspection inspect_body(const BodySource& source);

/// The inspection as text for people, and for programs.
std::string describe(const BodyInspection& body);
Json json_of(const BodyInspection& body);

}  // namespace taut::app
