#include "app/viewer/state/motion_choices.hpp"

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/motion_opening.hpp"
#include "app/bodies/rig_frames.hpp"
#include "app/viewer/state/choices.hpp"

namespace taut::app {
namespace {

BodySource moved_by(BodySource source, const Choice& motion) {
  source.motion = motion.file;
  source.clip = motion.file.empty() ? motion.name : "";
  source.frame_rate_hz.reset();
  source.start_s = 0.0;
  source.loop = true;
  return source;
}

bool fits(const BodySource& source, const std::shared_ptr<const Rig>& rig, const Choice& motion) {
  try {
    open_motion(moved_by(source, motion), rig, ModelAxis::y);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::vector<Choice> choices_for(const BodySource& source, const std::shared_ptr<const Rig>& rig) {
  std::vector<Choice> choices = files_in("motions", ".bvh");
  for (Choice& motion : choices) {
    motion.label = motion.name;
    std::replace(motion.label.begin(), motion.label.end(), '_', ' ');
  }
  for (const std::string& clip : names_of_clips(*rig)) {
    choices.push_back({clip, clip + " (its own)", ""});
  }
  std::erase_if(choices, [&](const Choice& motion) { return !fits(source, rig, motion); });
  return choices;
}

}  // namespace

MotionChoices motion_choices(const DrawnScene& scene, const MotionChoices& known) {
  for (std::size_t body = 0; body < scene.body_sources.size(); ++body) {
    const BodySource& source = scene.body_sources[body];
    if (source.file.empty()) {
      continue;
    }
    if (source.file == known.of) {
      return {body, known.of, known.choices};
    }
    try {
      const std::shared_ptr<const Rig> rig = read_rig(source.file);
      if (!rig->influences.empty()) {
        return {body, source.file, choices_for(source, rig)};
      }
    } catch (const InputError&) {
      continue;
    }
  }
  return {};
}

bool is_chosen(const Choice& motion, const BodySource& source) {
  return motion.file.empty() ? source.motion.empty() && source.clip == motion.name
                             : source.motion.lexically_normal() == motion.file.lexically_normal();
}

DrawnScene with_motion(const DrawnScene& scene, std::size_t body, const Choice& motion,
                       std::vector<std::string>& remarks) {
  DrawnScene moved = scene;
  moved.checkpoint.clear();
  BodySource& source = moved.body_sources.at(body);
  source = moved_by(source, motion);
  std::get<sim::BodyMesh>(moved.surroundings.bodies.at(body).shape) = {};
  try {
    remarks = load_bodies(moved);
  } catch (const InputError&) {
    source.loop = false;
    remarks = load_bodies(moved);
  }
  return moved;
}

}  // namespace taut::app
