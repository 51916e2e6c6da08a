#include "app/models/model_arrays.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace taut::app {
namespace {

template <class T>
void put(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <class T>
void put_list(std::string& bytes, const T& list) {
  using Item = typename T::value_type;
  put(bytes, static_cast<std::uint64_t>(list.size()));
  bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Item));
}

class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  template <class T>
  T take() {
    T value;
    require(sizeof(T), 1);
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  template <class List>
  List take_list() {
    using Item = typename List::value_type;
    const auto count = take<std::uint64_t>();
    require(sizeof(Item), count);
    List list(count, Item{});
    if (count > 0) {
      std::memcpy(list.data(), bytes_.data() + at_, count * sizeof(Item));
    }
    at_ += count * sizeof(Item);
    return list;
  }

  bool at_end() const { return at_ == bytes_.size(); }

 private:
  void require(std::size_t item_bytes, std::uint64_t count) const {
    if (count > (bytes_.size() - at_) / item_bytes) {
      throw std::runtime_error("the arrays of a model are incomplete");
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

constexpr std::uint8_t no_axis = 255;

}  // namespace

std::string encode(const ModelArrays& model) {
  std::string bytes;
  bytes.reserve(model.positions.size() * sizeof(sim::Vec3) +
                (model.corners.size() + model.corner_counts.size()) * sizeof(sim::Index) + 256);
  put_list(bytes, model.positions);
  put_list(bytes, model.corner_counts);
  put_list(bytes, model.corners);
  put_list(bytes, model.position_of_vertex);
  put_list(bytes, model.format);
  put(bytes, static_cast<std::uint64_t>(model.meshes));
  put(bytes, static_cast<std::uint64_t>(model.ignored_lines));
  put(bytes, static_cast<std::uint64_t>(model.ignored_points));
  put(bytes, model.metres_per_unit.value_or(0.0));
  put(bytes, model.up ? static_cast<std::uint8_t>(*model.up) : no_axis);
  return bytes;
}

ModelArrays decode(const std::string& bytes) {
  ByteReader reader(bytes);
  ModelArrays model;
  model.positions = reader.take_list<std::vector<sim::Vec3>>();
  model.corner_counts = reader.take_list<std::vector<std::uint32_t>>();
  model.corners = reader.take_list<std::vector<sim::Index>>();
  model.position_of_vertex = reader.take_list<std::vector<sim::Index>>();
  model.format = reader.take_list<std::string>();
  model.meshes = reader.take<std::uint64_t>();
  model.ignored_lines = reader.take<std::uint64_t>();
  model.ignored_points = reader.take<std::uint64_t>();
  const auto unit = reader.take<double>();
  const auto axis = reader.take<std::uint8_t>();
  const auto is_position = [&](sim::Index index) { return index < model.positions.size(); };
  const bool has_positions =
      std::all_of(model.position_of_vertex.begin(), model.position_of_vertex.end(), is_position);
  if (!reader.at_end() || !has_positions ||
      (axis != no_axis && axis > static_cast<std::uint8_t>(ModelAxis::minus_z))) {
    throw std::runtime_error("the arrays of a model are not as expected");
  }
  model.metres_per_unit = unit > 0.0 ? std::optional(unit) : std::nullopt;
  model.up = axis != no_axis ? std::optional(static_cast<ModelAxis>(axis)) : std::nullopt;
  return model;
}

}  // namespace taut::app
