#include "app/bodies/turned_frames.hpp"

#include <array>
#include <glm/geometric.hpp>
#include <utility>

namespace taut::app {
namespace {

/// Where the body's x, y and z are found in a file: the axis of each, and its sign.
struct Axes {
  const char* name;
  std::array<int, 3> axis;
  sim::Vec3 sign;

  sim::Vec3 operator()(const sim::Vec3& p) const {
    return sign * sim::Vec3(p[axis[0]], p[axis[1]], p[axis[2]]);
  }
};

/// The body's own first.
const std::array<Axes, 5> systems = {{{"x, y, z", {0, 1, 2}, {1, 1, 1}},
                                      {"x, z, -y", {0, 2, 1}, {1, 1, -1}},
                                      {"x, -z, y", {0, 2, 1}, {1, -1, 1}},
                                      {"x, y, -z", {0, 1, 2}, {1, 1, -1}},
                                      {"x, z, y", {0, 2, 1}, {1, 1, 1}}}};

/// Square of how many times nearer a first frame has to be for its axes to be taken.
constexpr double clearly_nearer = 9.0;

class TurnedFrames final : public FrameSource {
 public:
  TurnedFrames(std::unique_ptr<const FrameSource> motion, const Axes& axes)
      : motion_(std::move(motion)), axes_(axes) {}

  std::size_t frames() const override { return motion_->frames(); }
  std::size_t vertices() const override { return motion_->vertices(); }
  std::optional<double> rate_hz() const override { return motion_->rate_hz(); }
  void read(std::size_t frame, std::span<sim::Vec3> positions) const override {
    motion_->read(frame, positions);
    for (sim::Vec3& position : positions) {
      position = axes_(position);
    }
  }

 private:
  std::unique_ptr<const FrameSource> motion_;
  Axes axes_;
};

/// The sum of the squares, in m^2.
double distance_from(const LoadedMesh& body, const std::vector<sim::Vec3>& in_file, const Axes& axes) {
  double sum = 0.0;
  for (std::size_t v = 0; v < body.mesh.positions.size(); ++v) {
    const sim::Vec3 apart =
        body.places.placement(axes(in_file[body.places.file_vertex[v]])) - body.mesh.positions[v];
    sum += glm::dot(apart, apart);
  }
  return sum;
}

}  // namespace

std::unique_ptr<const FrameSource> in_axes_of(const LoadedMesh& body,
                                              std::unique_ptr<const FrameSource> motion,
                                              std::vector<std::string>& remarks) {
  if (motion->pose(0)) {
    return motion;
  }
  std::vector<sim::Vec3> in_file(motion->vertices());
  motion->read(0, in_file);
  const double own = distance_from(body, in_file, systems.front());
  const Axes* nearest = &systems.front();
  double distance = own / clearly_nearer;
  for (const Axes& axes : systems) {
    if (const double here = distance_from(body, in_file, axes); here < distance) {
      nearest = &axes;
      distance = here;
    }
  }
  if (nearest == &systems.front()) {
    return motion;
  }
  remarks.push_back(
      std::string("its motion is in other axes than it, guessed from its first frame: there (") +
      nearest->name + ") are its x, y and z");
  return std::make_unique<TurnedFrames>(std::move(motion), *nearest);
}

}  // namespace taut::app
