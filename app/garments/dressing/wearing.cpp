#include "app/garments/dressing/wearing.hpp"

#include <fmt/core.h>

#include "app/bodies/body_mesh.hpp"
#include "app/bodies/rig_pose.hpp"
#include "app/garments/dressing/tuning.hpp"
#include "app/models/hanging/garment_measures.hpp"
#include "app/models/hanging/hanger.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {
namespace {

using namespace dressing;

/// Target of a garment on a body when the run begins.
struct GarmentTarget {
  sim::Vec3 top_m;  ///< base of the neck, or middle of the waist
  sim::Vec3 front;
};

sim::Vec3 facing_direction(const JointPlaces& joints) {
  const std::vector<ArmJoints> arms = find_arms(joints);
  const sim::Vec3 front = arms.empty() ? sim::Vec3(0.0) : glm::cross(arms[0].outwards, sim::Vec3(0.0, 1.0, 0.0));
  return glm::length(front) > 0.0 ? glm::normalize(front) : sim::Vec3(0.0, 0.0, 1.0);
}

/// `measured_m` is the base of the neck or the middle of the waist in the stored pose.
GarmentTarget find_garment_target(const sim::Body& body, const Wearer& wearer, const JointPlaces& joints,
                                  const char* joint, const sim::Vec3& measured_m) {
  GarmentTarget wanted{measured_m, facing_direction(joints)};
  if (joints.contains(joint)) wanted.top_m += joints.at(joint) - wearer.stored_joints.at(joint);
  const sim::Pose pose = sim::pose_at(body.motion, 0.0);
  return GarmentTarget{pose(wanted.top_m), pose.rotation * wanted.front};
}

/// A turn about the vertical through `from_m`, which moves to `to_m`.
struct Move {
  sim::Vec3 from_m, to_m;
  double cosine = 1.0, sine = 0.0;

  sim::Vec3 operator()(const sim::Vec3& p) const {
    const sim::Vec3 d = p - from_m;
    return to_m + sim::Vec3(cosine * d.x + sine * d.z, d.y, cosine * d.z - sine * d.x);
  }
};

Move move_to(const GarmentMarks& marks, const GarmentTarget& wanted) {
  const sim::Vec3 middle = marks.top->middle();
  Move move{{middle.x, marks.is_worn_at_waist ? marks.top_height_m : marks.neck_base_m, middle.z}, wanted.top_m};
  sim::Vec3 front = marks.front;
  if (!marks.is_front_known && glm::dot(front, wanted.front) < 0.0) front = -front;
  const double cosine = glm::dot(front, wanted.front);
  if (cosine < min_unturned_cosine) {
    move.cosine = cosine;
    move.sine = glm::cross(front, wanted.front).y;
  }
  return move;
}

void apply(const Move& move, LoadedGarment& loaded) {
  sim::Garment garment = *loaded.garment;
  const auto go = [&](std::vector<sim::Vec3>& positions_m) {
    std::transform(positions_m.begin(), positions_m.end(), positions_m.begin(), move);
  };
  go(garment.mesh.positions);
  go(garment.untangled_m);
  if (loaded.start_m) go(*loaded.start_m);
  loaded.garment = sim::share(std::move(garment));
  if (loaded.following) {
    FollowingModel model = *loaded.following;
    go(model.mesh.positions);
    loaded.following = std::make_shared<const FollowingModel>(std::move(model));
  }
}

/// Returns whether the garment crosses the body at the start of its growth.
bool crosses(const LoadedGarment& loaded, const sim::Body& body) {
  const auto& mesh = std::get<sim::BodyMesh>(body.shape);
  const std::vector<sim::Vec3> thin_m = mesh_positions_m(body, mesh.frames->first_s());
  return !sim::find_crossing_pairs(surface_at_start(loaded), {thin_m, mesh.data->triangles}).empty();
}

/// Adds the bones of both limbs, turned towards the nearest opening. An opening at the start of a limb turns no bone.
void add_limbs(const Wearer& wearer, const sim::Body& body, const LimbParts& parts,
               const std::vector<LimbOpening>& openings, std::vector<TurnedBone>& bones) {
  const sim::Pose pose = sim::pose_at(body.motion, 0.0);
  for (const double side : {1.0, -1.0}) {
    const std::optional<Limb> limb = find_limb(wearer, side, parts);
    if (openings.empty() || !limb) continue;
    const sim::Vec3 begin_m = pose(limb->begin_m);
    const sim::Vec3 way_m = find_nearest_opening(openings, begin_m).middle_m - begin_m;
    if (glm::length(way_m) > min_limb_distance_m)
      turn_limb(wearer, *limb, glm::transpose(pose.rotation) * way_m, bones);
  }
}

/// Turns the limbs into sleeves and legs if the body crosses the garment. Returns a report for people.
std::string begin_in_limbs(const Wearer& wearer, const GarmentMarks& marks, const LoadedGarment& loaded,
                           sim::Body& body) {
  std::vector<TurnedBone> bones;
  add_limbs(wearer, body, arm_parts, marks.cuffs, bones);
  const std::size_t of_arms = bones.size();
  add_limbs(wearer, body, leg_parts, marks.legs, bones);
  if (bones.empty() || !crosses(loaded, body)) return "";
  std::get<sim::BodyMesh>(body.shape).frames =
      make_growing_frames(wearer, make_turning_poses(*wearer.rig, wearer.pose, bones));
  return of_arms > 0 ? "the arms begin in its sleeves" : "the legs begin in its own";
}

/// Returns the move of a garment with two legs that puts its fork right below the body's.
std::optional<Move> move_to_fork(const GarmentMarks& marks, const sim::Surface& garment, const Wearer& wearer,
                                 const GarmentTarget& at_waist) {
  const std::optional<GarmentTube> tube = find_tube(garment);
  const BodyMeasures& measures = wearer.measures;
  if (marks.legs.empty() || !tube || !tube->fork_m || measures.levels.empty() || measures.fork == 0) {
    return std::nullopt;
  }
  const double fork_m = measures.levels[measures.fork].height_m - below_fork_m;
  GarmentTarget wanted = at_waist;
  wanted.top_m.y += fork_m + marks.top_height_m - *tube->fork_m - measures.waist_m->y;
  return move_to(marks, wanted);
}

/// Returns whether a garment already lies about the body. It may be worn lower than at the waist or the neck.
bool lies_about(const Move& move) {
  const sim::Vec3 way_m = move.to_m - move.from_m;
  return glm::length(glm::dvec2(way_m.x, way_m.z)) < max_worn_distance_m && way_m.y > -max_worn_distance_m &&
         way_m.y < max_worn_drop_m && move.cosine > min_worn_cosine;
}

/// Makes the parts of the model that are no cloth a body, which the scene does not name, if they can be one and cross
/// no cloth.
void add_rigid_parts(LoadedGarment& loaded, LoadedBodies& bodies) {
  constexpr const char* name = "the garment's stand";
  std::erase_if(bodies.all, [](const sim::Body& body) { return body.name == name; });
  ImportedModel model;
  model.positions = loaded.rigid.mesh.positions;
  model.triangles = loaded.rigid.mesh.triangles;
  if (model.triangles.empty() || !bodies.all.empty()) return;
  BodySource source;
  source.scale = 1.0;
  source.up = ModelAxis::y;
  try {
    LoadedMesh made = make_body_mesh(source, model);
    bodies.all.push_back({.name = name,
                          .shape = sim::BodyMesh{std::make_shared<const sim::BodyMeshData>(
                              sim::BodyMeshData{std::move(made.mesh.positions), std::move(made.mesh.triangles)})}});
    loaded.rigid.is_body = crossings_with(bodies.all, 0, 0.0, surface_at_start(loaded)).pairs.empty();
    if (!loaded.rigid.is_body) bodies.all.clear();
  } catch (const InputError&) {  // it is not closed
  }
}

}  // namespace

Dressed dressed_body(const LoadedBodies& bodies) {
  for (std::size_t b = 0; b < bodies.wearers.size(); ++b) {
    if (bodies.wearers[b]) return {bodies.wearers[b].get(), b};
  }
  return {};
}

sim::Vec3 front_of_dressed(const LoadedBodies& bodies) {
  const Dressed dressed = dressed_body(bodies);
  if (dressed.wearer == nullptr) return {0.0, 0.0, 1.0};
  return sim::pose_at(bodies.all[dressed.body].motion, 0.0).rotation * facing_direction(dressed.wearer->joints);
}

double compute_lift(const sim::Body& body, const Wearer& wearer) {
  for (const char* joint : {"neck", "hips"}) {
    if (wearer.joints.contains(joint)) {
      return sim::pose_at(body.motion, 0.0)(wearer.joints.at(joint)).y - wearer.stored_joints.at(joint).y;
    }
  }
  return 0.0;
}

bool is_worn_at_waist(const GarmentMarks& marks, const BodyMeasures& measures, double lift_m) {
  const bool ends_above_arms =
      !measures.levels.empty() && marks.top_height_m - lift_m > measures.levels.back().height_m;
  return marks.is_worn_at_waist && !ends_above_arms;
}

std::vector<std::string> put_on(LoadedGarment& loaded, const Scene& scene, LoadedBodies& bodies) {
  const Dressed dressed = dressed_body(bodies);
  if (dressed.wearer == nullptr || scene.garment.has_start()) return {};
  const Wearer& wearer = *dressed.wearer;
  const std::size_t b = dressed.body;
  sim::Body& body = bodies.all[b];
  const auto marks_now = [&] {
    GarmentMarks marks = find_garment_marks(*loaded.garment, surface_at_start(loaded).positions_m, loaded.landmarks);
    marks.is_worn_at_waist = is_worn_at_waist(marks, wearer.measures, compute_lift(body, wearer));
    return marks;
  };
  const GarmentMarks marks = marks_now();
  const bool at_waist = marks.is_worn_at_waist;
  const std::optional<sim::Vec3>& measured_m = at_waist ? wearer.measures.waist_m : wearer.measures.neck_m;
  std::get<sim::BodyMesh>(body.shape).frames = wearer.frames;
  if (!marks.top || !measured_m) {
    return {fmt::format("it stays where it is: {} was found on {}",
                        marks.top ? "no neck" : "no neck opening and no waist",
                        marks.top ? describe_body(bodies.all, b) : "it")};
  }
  const sim::Surface garment = surface_at_start(loaded);
  const auto move_in = [&](const JointPlaces& joints) {
    const GarmentTarget wanted = find_garment_target(body, wearer, joints, at_waist ? "hips" : "neck", *measured_m);
    const auto to_fork = at_waist ? move_to_fork(marks, garment, wearer, wanted) : std::nullopt;
    return to_fork.value_or(move_to(marks, wanted));
  };
  auto& frames = std::get<sim::BodyMesh>(body.shape).frames;
  const Move move = move_in(wearer.joints);
  if (lies_about(move) && !crosses(loaded, body)) return {};
  if (wearer.motion && lies_about(move_in(wearer.stored_joints))) {
    frames = make_growing_frames(wearer, make_poses_from_stored(wearer));
    if (!crosses(loaded, body)) {
      return {
          fmt::format("{} begins as it was stored, where the garment lies about it, and is led to the first "
                      "frame of its motion",
                      describe_body(bodies.all, b))};
    }
    frames = wearer.frames;
  }
  apply(move, loaded);
  std::vector<std::string> said = {fmt::format("it is moved by {:.3g} m{}, so that its {} is at that of {}",
                                               glm::distance(move.from_m, move.to_m),
                                               move.cosine == 1.0 ? "" : " and turned about the vertical",
                                               at_waist ? "waist" : "neck", describe_body(bodies.all, b))};
  // Garments that were draped on wider shoulders hang lower beside the neck.
  std::string limbs = begin_in_limbs(wearer, marks_now(), loaded, body);
  double lifted_m = 0.0;
  const auto lift = [&](double by_m) {
    apply({sim::Vec3(0.0), {0.0, by_m, 0.0}}, loaded);
    lifted_m += by_m;
    frames = wearer.frames;
    limbs = begin_in_limbs(wearer, marks_now(), loaded, body);
  };
  while (lifted_m < max_lift_m && crosses(loaded, body)) lift(lift_step_m);
  if (lifted_m > 0.0 && crosses(loaded, body)) lift(-lifted_m);
  if (lifted_m > 0.0) said.push_back(fmt::format("it begins {:.0f} cm above that", 100.0 * lifted_m));
  if (!limbs.empty()) said.push_back(limbs);
  return said;
}

std::vector<std::string> put_where_it_begins(LoadedGarment& loaded, Scene& scene, LoadedBodies& bodies) {
  add_rigid_parts(loaded, bodies);
  put_on_hanger(loaded, scene, bodies.all);
  return put_on(loaded, scene, bodies);
}

}  // namespace taut::app
