#include "app/models/model_arrays.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "app/models/array_coding.hpp"

namespace taut::app {
namespace {

constexpr std::uint8_t no_axis = 255;

}  // namespace

void number_by_first_use(ModelArrays& model) {
  constexpr sim::Index unused = std::numeric_limits<sim::Index>::max();
  std::vector<sim::Index> number_of(model.positions.size(), unused);
  std::vector<sim::Vec3> positions;
  positions.reserve(model.positions.size());
  const auto number = [&](sim::Index old) {
    if (number_of[old] == unused) {
      number_of[old] = static_cast<sim::Index>(positions.size());
      positions.push_back(model.positions[old]);
    }
    return number_of[old];
  };
  for (sim::Index& corner : model.corners) {
    corner = number(corner);
  }
  for (sim::Index old = 0; old < number_of.size(); ++old) {
    number(old);
  }
  model.positions = std::move(positions);
  model.position_of_vertex = std::move(number_of);
}

std::string encode(const ModelArrays& model) {
  ArrayWriter out;
  out.bytes.reserve(model.positions.size() * sizeof(sim::Vec3) +
                    (model.corners.size() + model.corner_counts.size()) * sizeof(sim::Index) + 256);
  out.put_list(model.positions);
  out.put_list(model.corner_counts);
  out.put_list(model.corners);
  out.put_list(model.position_of_vertex);
  put_all(model.sections, out, [&](const FaceSection& section) {
    out.put(section.first_face);
    out.put_list(section.line);
  });
  out.put(static_cast<std::uint8_t>(model.has_normals ? 1 : 0));
  out.put_list(model.format);
  out.put(static_cast<std::uint64_t>(model.meshes));
  out.put(static_cast<std::uint64_t>(model.ignored_lines));
  out.put(static_cast<std::uint64_t>(model.ignored_points));
  out.put(model.metres_per_unit.value_or(0.0));
  out.put(model.up ? static_cast<std::uint8_t>(*model.up) : no_axis);
  encode(model.rig, out);
  encode(model.colours, out);
  return std::move(out.bytes);
}

ModelArrays decode(const std::string& bytes) {
  ArrayReader reader(bytes);
  ModelArrays model;
  model.positions = reader.take_list<std::vector<sim::Vec3>>();
  model.corner_counts = reader.take_list<std::vector<std::uint32_t>>();
  model.corners = reader.take_list<std::vector<sim::Index>>();
  model.position_of_vertex = reader.take_list<std::vector<sim::Index>>();
  take_all(model.sections, reader, [&](FaceSection& section) {
    section.first_face = reader.take<std::uint32_t>();
    section.line = reader.take_list<std::string>();
  });
  model.has_normals = reader.take<std::uint8_t>() != 0;
  model.format = reader.take_list<std::string>();
  model.meshes = reader.take<std::uint64_t>();
  model.ignored_lines = reader.take<std::uint64_t>();
  model.ignored_points = reader.take<std::uint64_t>();
  const auto unit = reader.take<double>();
  const auto axis = reader.take<std::uint8_t>();
  model.rig = decode_rig(reader);
  model.colours = decode_colours(reader, model.corners.size(), model.corner_counts.size());
  const auto is_position = [&](sim::Index index) { return index < model.positions.size(); };
  const bool has_positions =
      std::all_of(model.position_of_vertex.begin(), model.position_of_vertex.end(), is_position);
  const bool has_rig = model.rig.empty() || model.rig.in_part.size() == model.positions.size();
  if (!reader.at_end() || !has_positions || !has_rig ||
      (axis != no_axis && axis > static_cast<std::uint8_t>(ModelAxis::minus_z))) {
    throw std::runtime_error("the arrays of a model are not as expected");
  }
  model.metres_per_unit = unit > 0.0 ? std::optional(unit) : std::nullopt;
  model.up = axis != no_axis ? std::optional(static_cast<ModelAxis>(axis)) : std::nullopt;
  return model;
}

}  // namespace taut::app
