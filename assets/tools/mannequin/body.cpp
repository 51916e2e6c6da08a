#include "tailor/mannequin/body.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace taut::tailor {
namespace {

/// Arms point 43 degrees below the horizontal, where the cap of a T-shirt's sleeve meets its armhole without strain.
const Vec3 arm_direction = {0.7313537, -0.6819984, 0.0};
/// Legs are turned outward by 2.5 degrees each, so that they do not touch.
const Vec3 leg_direction = {0.0436194, -0.9990482, 0.0};

/// Heights above the floor and lengths along arms, in metres.
struct Landmarks {
  double ankle, knee, upper_leg, crotch, hip_joint, seat, hips, waist, underbust, chest, shoulder, neck_point,
      neck, head, top;
  double shoulder_half_width, biceps, elbow, wrist, fingertip;
  double hip_half_width;
};

double get(const Measurements& m, const std::string& name) {
  const auto found = m.find(name);
  if (found == m.end()) {
    throw std::runtime_error("the measurement '" + name + "' is missing");
  }
  return found->second;
}

/// The tape's length along the curved back is slightly larger than the difference of the heights.
Landmarks landmarks(const Measurements& m) {
  constexpr double height_of_back = 0.959;
  constexpr double slope_of_shoulder = 0.2308682;  // tan 13 degrees, all sizes
  Landmarks l{};
  l.waist = get(m, "waistToFloor");
  l.neck_point = l.waist + height_of_back * get(m, "hpsToWaistBack");
  l.chest = l.waist + get(m, "hpsToWaistFront") - get(m, "hpsToBust");
  l.underbust = m.contains("underbust") ? l.waist + get(m, "waistToUnderbust") : l.waist;
  l.hips = l.waist - get(m, "waistToHips");
  l.seat = l.waist - get(m, "waistToSeat");
  l.upper_leg = l.waist - get(m, "waistToUpperLeg") - 0.02;  // just below the fork, where a tape fits
  l.crotch = l.upper_leg + 0.03;
  l.hip_joint = l.crotch + 0.075;
  l.knee = l.waist - get(m, "waistToKnee");
  l.ankle = 0.093 * l.waist;
  const double head = get(m, "head") / 0.601;
  l.neck = l.neck_point + 0.045 * head;
  l.head = l.neck_point + 0.185 * head;
  l.top = l.neck_point + 0.272 * head;
  l.shoulder_half_width = 0.5 * get(m, "shoulderToShoulder");
  l.shoulder = l.neck_point - slope_of_shoulder * (l.shoulder_half_width - 0.165 * get(m, "neck"));
  l.elbow = get(m, "shoulderToElbow");
  l.wrist = get(m, "shoulderToWrist");
  l.biceps = 0.5 * l.elbow;
  l.fingertip = l.wrist * 1.31;
  // Thighs and hips of these girths then end at the same width, and the thighs do not touch.
  l.hip_half_width = 0.1825 * get(m, "seat") - 0.145 * get(m, "upperLeg") - 0.0035;
  return l;
}

Chain make_chain(const std::string& name, const Frame& frame, const Vec3& reference_origin_m,
                 const std::vector<double>& sized_m, const std::vector<double>& reference_m,
                 const std::vector<double>& girths_m) {
  Chain chain;
  chain.name = name;
  chain.frame = frame;
  chain.reference_origin_m = reference_origin_m;
  chain.sized_m = sized_m;
  chain.reference_m = reference_m;
  chain.girths_m = girths_m;
  chain.set_factors(std::vector<double>(girths_m.size(), 1.0));
  return chain;
}

std::vector<double> heights(const Landmarks& l) {
  return {0.0, l.crotch, l.seat, l.hips, l.waist, l.chest, l.shoulder, l.neck_point, l.head, l.top};
}

Vec3 shoulder_joint(const Landmarks& l) {
  return {l.shoulder_half_width - 0.045, l.shoulder - 0.055, -0.015};
}
Vec3 hip_joint(const Landmarks& l) {
  return {l.hip_half_width, l.hip_joint, -0.005};
}

Chain make_leg(const Landmarks& sized, const Landmarks& reference) {
  const auto down = [](const Landmarks& l) {
    std::vector<double> t;
    for (const double height : {l.crotch, l.knee, l.ankle, 0.0}) {
      t.push_back((height - l.hip_joint) / leg_direction.y);
    }
    t.insert(t.begin(), 0.0);
    return t;
  };
  const auto girth = [&sized](double height) { return (height - sized.hip_joint) / leg_direction.y; };
  const Frame frame = {
      hip_joint(sized), leg_direction, {-leg_direction.y, leg_direction.x, 0.0}, {0.0, 0.0, 1.0}};
  return make_chain("leg", frame, hip_joint(reference), down(sized), down(reference),
                    {girth(sized.upper_leg), girth(sized.knee), girth(sized.ankle)});
}

std::vector<Chain> make_chains(const Landmarks& sized, const Landmarks& reference, const Measurements& m,
                               const Measurements& reference_m, bool with_underbust) {
  std::vector<double> girths = {sized.seat, sized.hips, sized.waist, sized.chest, sized.neck, sized.head};
  if (with_underbust) {
    girths.insert(girths.begin() + 3, sized.underbust);
  }
  const Frame upright = {};
  std::vector<Chain> chains;
  chains.push_back(make_chain("trunk", upright, Vec3(0.0), heights(sized), heights(reference), girths));

  Chain shoulder = make_chain("shoulder", upright, Vec3(0.0), heights(sized), heights(reference), {0.0, 1.0});
  const double thicker = 0.5 + 0.5 * get(m, "chest") / get(reference_m, "chest");
  shoulder.set_factors({thicker, thicker});
  shoulder.side_factor = sized.shoulder_half_width / reference.shoulder_half_width / thicker;
  chains.push_back(shoulder);

  const Frame arm = {
      shoulder_joint(sized), arm_direction, {-arm_direction.y, arm_direction.x, 0.0}, {0.0, 0.0, 1.0}};
  const auto lengths = [](const Landmarks& l) {
    return std::vector<double>{-0.1, 0.0, l.elbow, l.wrist, l.fingertip};
  };
  chains.push_back(make_chain("arm", arm, shoulder_joint(reference), lengths(sized), lengths(reference),
                              {sized.biceps, sized.wrist}));
  chains.push_back(make_leg(sized, reference));
  return chains;
}

std::size_t chain_index(const Shape& shape, const std::string& name) {
  for (std::size_t c = 0; c < shape.chains.size(); ++c) {
    if (shape.chains[c].name == name) {
      return c;
    }
  }
  throw std::runtime_error("the chain '" + name + "' is unknown; there are trunk, shoulder, arm and leg");
}

Vec3 turn(const Frame& frame, const Vec3& v) { return v.x * frame.along + v.y * frame.side + v.z * frame.front; }

void add_part(Shape& shape, const PartRecipe& recipe) {
  Part part = recipe.part;
  part.chain = chain_index(shape, recipe.chain);
  const Chain& chain = shape.chains[part.chain];
  part.frame = {chain.reference_origin_m + turn(chain.frame, part.frame.origin_m), turn(chain.frame, part.frame.along),
                turn(chain.frame, part.frame.side), turn(chain.frame, part.frame.front)};
  (recipe.is_detail ? shape.details : shape.parts).push_back(part);
}

std::vector<Tape> make_tapes(const Shape& shape, const Landmarks& l, const Measurements& m,
                             bool with_underbust) {
  std::vector<Tape> tapes;
  const auto level = [&](const char* name, double height) {
    tapes.push_back({name, 0, {0.0, height, 0.0}, {0.0, 1.0, 0.0}, get(m, name)});
  };
  level("seat", l.seat);
  level("hips", l.hips);
  level("waist", l.waist);
  if (with_underbust) {
    level("underbust", l.underbust);
  }
  level("chest", l.chest);
  level("neck", l.neck);
  level("head", l.head);
  const auto around_arm = [&](const char* name, double t) {
    const Frame& frame = shape.chains[2].frame;
    tapes.push_back(
        {name, 2, frame.origin_m + t * frame.along + 0.01 * frame.front, frame.along, get(m, name)});
  };
  around_arm("biceps", l.biceps);
  around_arm("wrist", l.wrist);
  const auto around_leg = [&](const char* name, double height) {
    const Frame& frame = shape.chains[3].frame;
    const double t = (height - l.hip_joint) / frame.along.y;
    tapes.push_back({name, 3, frame.origin_m + t * frame.along, {0.0, 1.0, 0.0}, get(m, name)});
  };
  around_leg("upperLeg", l.upper_leg);
  around_leg("knee", l.knee);
  around_leg("ankle", l.ankle);
  return tapes;
}

void add_joint(Body& body, const JointRecipe& recipe, bool right) {
  const auto sided = [right](const std::string& name) {
    return right && name.starts_with("Left") ? "Right" + name.substr(4) : name;
  };
  Joint joint;
  joint.name = sided(recipe.name);
  joint.recipe = recipe;
  joint.chain = chain_index(body.shape, recipe.chain);
  joint.is_right = right;
  const Chain& chain = body.shape.chains[joint.chain];
  joint.place_m = chain.sized(chain.reference_origin_m + turn(chain.frame, recipe.place_m));
  joint.place_m.x *= right ? -1.0 : 1.0;
  for (std::size_t j = 0; j < body.joints.size(); ++j) {
    joint.parent = body.joints[j].name == sided(recipe.parent) ? static_cast<int>(j) : joint.parent;
  }
  if (joint.parent < 0 && !recipe.parent.empty()) {
    throw std::runtime_error("the joint '" + recipe.name + "' has the parent '" + recipe.parent +
                             "', which does not stand before it");
  }
  body.joints.push_back(joint);
}

}  // namespace

Body make_body(const ShapeRecipe& recipe, const Measurements& reference, const Measurements& sized) {
  const Landmarks l = landmarks(sized);
  const bool with_underbust = sized.contains("underbust");
  Body body;
  body.shape.chains = make_chains(l, landmarks(reference), sized, reference, with_underbust);
  for (const PartRecipe& part : recipe.parts) {
    add_part(body.shape, part);
  }
  body.shoulder_tip_m = {l.shoulder_half_width, l.shoulder, 0.0};
  body.tapes = make_tapes(body.shape, l, sized, with_underbust);
  for (const bool right : {false, true}) {
    for (const JointRecipe& joint : recipe.joints) {
      if (!right || joint.name.starts_with("Left")) {
        add_joint(body, joint, right);
      }
    }
  }
  return body;
}

}  // namespace taut::tailor
