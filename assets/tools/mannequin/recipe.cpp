#include "tailor/mannequin/recipe.hpp"

#include <toml++/toml.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace taut::tailor {
namespace {

/// A table of a file, and its place in the file.
struct Place {
  std::string where;
  const toml::table& table;

  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(where + ": " + what); }

  std::string text(const char* key) const {
    const auto value = table[key].value<std::string>();
    return value ? *value : (fail(std::string(key) + " is missing or no text"), "");
  }

  double number(const char* key, double otherwise) const {
    return table.contains(key) ? numbers(key, 1, 1).front() : otherwise;
  }

  std::vector<double> numbers(const char* key, std::size_t least, std::size_t most) const {
    const toml::array one{table[key].value_or(std::nan(""))};
    const toml::array* found = table[key].as_array();
    return list(found != nullptr ? *found : one, key, least, most);
  }

  std::vector<double> list(const toml::array& array, const std::string& name, std::size_t least,
                           std::size_t most) const {
    std::vector<double> result;
    for (const toml::node& node : array) {
      result.push_back(node.value<double>().value_or(std::nan("")));
      if (!std::isfinite(result.back())) {
        fail(name + " holds something other than numbers");
      }
    }
    if (result.size() < least || result.size() > most) {
      fail(name + " holds " + std::to_string(result.size()) + " numbers, expected " + std::to_string(least));
    }
    return result;
  }

  Vec3 vector(const char* key, const Vec3& otherwise) const {
    if (!table.contains(key)) {
      return otherwise;
    }
    const std::vector<double> v = numbers(key, 3, 3);
    return {v[0], v[1], v[2]};
  }
};

toml::table parse(const std::filesystem::path& file) {
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(file.string() + ": " + std::string(error.description()));
  }
}

std::vector<Place> tables(const std::filesystem::path& file, const toml::table& root, const char* key) {
  const toml::array* array = root[key].as_array();
  if (array == nullptr || array->empty()) {
    throw std::runtime_error(file.string() + ": no [[" + key + "]]");
  }
  std::vector<Place> result;
  for (const toml::node& node : *array) {
    if (node.as_table() == nullptr) {
      throw std::runtime_error(file.string() + ": " + key + " holds something other than tables");
    }
    result.push_back(
        {file.string() + ", " + key + " " + std::to_string(result.size() + 1), *node.as_table()});
  }
  return result;
}

Curve<6> read_rows(const Place& place) {
  const toml::array* rows = place.table["rows"].as_array();
  if (rows == nullptr || rows->size() < 2) {
    place.fail("rows is missing or shorter than two rows");
  }
  std::vector<double> knots;
  std::vector<Curve<6>::Values> values;
  for (const toml::node& node : *rows) {
    if (node.as_array() == nullptr) {
      place.fail("rows holds something other than lists of 7 numbers");
    }
    const auto r = place.list(*node.as_array(), "a row", 7, 7);
    if (!knots.empty() && r[0] <= knots.back()) {
      place.fail("rows do not increase at " + std::to_string(r[0]));
    }
    if (r[2] < 0.0 || r[3] > r[4] || r[4] > r[5] || std::abs(r[6]) >= 1.0) {
      place.fail("the row at " + std::to_string(r[0]) +
                 " is not along, centre, half width >= 0, back <= "
                 "widest <= front, squareness between -1 and 1");
    }
    knots.push_back(r[0]);
    values.push_back(
        {r[1], r[4], r[2] * r[2], (r[4] - r[3]) * (r[4] - r[3]), (r[5] - r[4]) * (r[5] - r[4]), r[6]});
  }
  return {knots, values};
}

/// An ellipsoid is a part as well: the squares of its sections' sizes are parabolas.
Curve<6> read_ball(const Place& place) {
  const std::vector<double> r = place.numbers("ball", 3, 3);
  if (!(r[0] > 0.0 && r[1] > 0.0 && r[2] > 0.0)) {
    place.fail("ball is not three radii above 0: along, side, front");
  }
  const double side_2 = r[1] * r[1];
  const double front_2 = r[2] * r[2];
  return {{-r[0], 0.0, r[0]},
          {{0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, side_2, front_2, front_2, 0.0}, {}}};
}

PartRecipe read_part(const Place& place) {
  PartRecipe result;
  result.chain = place.text("chain");
  Part& part = result.part;
  part.name = place.text("name");
  part.blend_m = place.number("blend", part.blend_m);
  part.edge_m = place.number("edge", part.edge_m);
  part.on_midline = place.table["midline"].value_or(false);
  part.is_hollow = place.table["hollow"].value_or(false);
  result.is_detail = place.table["detail"].value_or(false);
  if (part.is_hollow && !result.is_detail) {
    place.fail("only a detail can be hollow");
  }
  // Along, side and front of the chain are x, y and z until the part is placed on it.
  part.frame.origin_m = place.vector("origin", Vec3(0.0));
  part.frame.along = glm::normalize(place.vector("along", Vec3(1.0, 0.0, 0.0)));
  const Vec3 front = place.vector("front", Vec3(0.0, 0.0, 1.0));
  part.frame.side = glm::normalize(glm::cross(front, part.frame.along));
  part.frame.front = glm::cross(part.frame.along, part.frame.side);
  part.sections = place.table.contains("ball") ? read_ball(place) : read_rows(place);
  return result;
}

JointRecipe read_joint(const Place& place) {
  JointRecipe joint;
  joint.name = place.text("name");
  joint.parent = place.table["parent"].value_or(std::string());
  joint.chain = place.text("chain");
  joint.place_m = place.vector("at", Vec3(0.0));
  joint.hinge = glm::normalize(place.vector("hinge", Vec3(0.0, 1.0, 0.0)));
  joint.width_m = place.number("width", 0.05);
  return joint;
}

}  // namespace

Measurements read_measurements(const std::filesystem::path& file, const std::string& size) {
  const toml::table root = parse(file);
  const toml::table* table = root["mm"][size].as_table();
  if (table == nullptr) {
    throw std::runtime_error(file.string() + ": no size [mm." + size + "]");
  }
  Measurements result;
  for (const auto& [key, value] : *table) {
    const double mm = value.value<double>().value_or(0.0);
    if (!(mm > 0.0 && mm < 3000.0)) {
      throw std::runtime_error(file.string() + ": " + size + "." + std::string(key.str()) +
                               " is no length from 0 to 3000 mm");
    }
    result[std::string(key.str())] = mm * 1e-3;
  }
  return result;
}

ShapeRecipe read_shape(const std::filesystem::path& file) {
  const toml::table root = parse(file);
  ShapeRecipe recipe;
  recipe.reference = Place{file.string(), root}.text("reference");
  for (const Place& place : tables(file, root, "part")) {
    recipe.parts.push_back(read_part(place));
  }
  for (const Place& place : tables(file, root, "joint")) {
    recipe.joints.push_back(read_joint(place));
  }
  return recipe;
}

}  // namespace taut::tailor
