#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tailor/mannequin/shape.hpp"

namespace taut::tailor {

/// Published measurements in metres, by name.
using Measurements = std::map<std::string, double>;

/// A joint of the reference body.
struct JointRecipe {
  std::string name;    ///< name of the left or middle joint; right ones are mirror images
  std::string parent;  ///< empty for the root
  std::string chain;
  Vec3 place_m;          ///< along the chain's axis, to its side, to its front
  Vec3 hinge;            ///< unit vector from the joint towards the flesh that follows it
  double width_m = 0.0;  ///< half the width over which the parent's influence becomes the joint's
};

/// A part as in the file: positions are along, to the side and to the front of its chain's axis.
struct PartRecipe {
  std::string chain;
  Part part;
  bool is_detail = false;
};

/// A body as drawn for one size, the reference.
struct ShapeRecipe {
  std::string reference;  ///< size that it is drawn for
  std::vector<PartRecipe> parts;
  std::vector<JointRecipe> joints;
};

/// Returns the measurements of a size, in metres. Throws std::runtime_error that names file and field.
Measurements read_measurements(const std::filesystem::path& file, const std::string& size);
/// Returns a shape's recipe. Throws std::runtime_error that names file and field.
ShapeRecipe read_shape(const std::filesystem::path& file);

}  // namespace taut::tailor
