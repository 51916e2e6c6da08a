#include "app/drawing/drawn_bodies.hpp"

#include "app/drawing/framing.hpp"
#include "app/models/hanger.hpp"

namespace taut::app {
namespace {

const renderer::Colour body_colour = renderer::rgb(0xB9B4AC);

// Share of an edge that the surface may leave its triangles by, where no cloth is near.
constexpr float most_body_bulge = 0.2F;

float mean_edge_m(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles) {
  double sum_m = 0.0;
  for (std::uint32_t side = 0; side < triangles.size(); ++side) {
    sum_m += glm::distance(positions[triangles[side]], positions[triangles[renderer::next_corner(side)]]);
  }
  return static_cast<float>(sum_m / static_cast<double>(std::max<std::size_t>(triangles.size(), 1)));
}

renderer::SurfaceView plain_view(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                 std::span<const std::uint32_t> triangles) {
  renderer::SurfaceView view;
  view.positions = positions;
  view.normals = normals;
  view.triangles = triangles;
  view.style.outside_colour = body_colour;
  view.style.inside_colour = body_colour;
  view.style.translucency = 0.0F;
  return view;
}

// A capsule whose radius changes is drawn as the balls at its ends and the larger of them between.
struct RoundMaker {
  std::vector<renderer::TriangleMesh>& meshes;

  void operator()(const sim::Plane&) const {}
  void operator()(const sim::BodyMesh&) const {}
  void operator()(const sim::Sphere& ball) const {
    meshes.push_back(renderer::make_sphere(glm::vec3(ball.centre_m), static_cast<float>(ball.radius_m)));
  }
  void operator()(const sim::Capsule& limb) const {
    meshes.push_back(renderer::make_capsule(glm::vec3(limb.start_m), glm::vec3(limb.end_m),
                                            static_cast<float>(std::min(limb.start_radius_m, limb.end_radius_m))));
    if (limb.start_radius_m != limb.end_radius_m) {
      (*this)(sim::Sphere{limb.start_m, limb.start_radius_m});
      (*this)(sim::Sphere{limb.end_m, limb.end_radius_m});
    }
  }
};

// The hook that a hanger hangs by, in m: its wire, its neck and its bend, of which this share of a circle is there.
constexpr float wire_m = 0.0022F, neck_m = 0.03F, bend_m = 0.02F, bent = 0.7F;
constexpr int bends = 16;
constexpr double thinner_bar = 0.75;

void add_hook(const sim::Capsule& bar, std::vector<renderer::TriangleMesh>& meshes) {
  const glm::vec3 foot(bar.start_m);
  const glm::vec3 up{0.0F, 1.0F, 0.0F};
  glm::vec3 aside(bar.end_m - bar.start_m);
  aside = glm::normalize(glm::vec3{aside.x, 0.0F, aside.z});
  const glm::vec3 middle = foot + (neck_m + bend_m) * up;
  glm::vec3 from = foot;
  for (int i = 0; i <= bends; ++i) {
    const float turn = 2.0F * std::numbers::pi_v<float> * bent * static_cast<float>(i) / bends;
    const glm::vec3 to = middle + bend_m * (std::sin(turn) * aside - std::cos(turn) * up);
    meshes.push_back(renderer::make_capsule(from, to, wire_m, 10));
    from = to;
  }
}

// Wind with the longest arrows.
constexpr float fastest_m_per_s = 20.0F;
// Shares of the box's radius: of the shortest and the longest arrow, from arrow to arrow, and of the gap
// between their heads and the box.
constexpr float shortest = 0.4F;
constexpr float longest = 1.0F;
constexpr float apart = 0.4F;
constexpr float gap = 0.15F;
// Length of a head, share of the box's radius, and its half width, share of that.
constexpr float head = 0.12F;
constexpr float head_width = 0.4F;

}  // namespace

DrawnBodies::DrawnBodies(std::vector<sim::Body> bodies)
    : bodies_(std::move(bodies)),
      move_(std::ranges::any_of(bodies_, [](const sim::Body& body) { return sim::is_moving_after(body, 0.0); })),
      round_(bodies_.size()) {
  std::size_t first_room = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (const auto* shape = std::get_if<sim::BodyMesh>(&bodies_[b].shape)) {
      Mesh& mesh = meshes_[b];
      mesh.rest_positions = to_float(shape->data->positions_m);
      mesh.triangles = flat(shape->data->triangles);
      mesh.edge_m = mean_edge_m(mesh.rest_positions, mesh.triangles);
      mesh.first_room = first_room;
      first_room += mesh.rest_positions.size();
    }
  }
}

void DrawnBodies::set_detail(float pixels_per_m, std::optional<float> shortest_edge_px) {
  for (auto& [body, mesh] : meshes_) {
    const int levels = !shortest_edge_px ? 0
                                         : renderer::refinement_levels(mesh.edge_m * pixels_per_m,
                                                                       mesh.triangles.size() / 3, *shortest_edge_px);
    if (!mesh.surface || levels != mesh.levels) {
      mesh.levels = levels;
      mesh.surface.emplace(mesh.rest_positions, mesh.triangles, levels,
                           renderer::SurfaceFreedom{most_body_bulge * mesh.edge_m});
      placed_s_.reset();
    }
  }
}

void DrawnBodies::place(double time_s, std::span<const float> rooms_m) {
  const bool stays = placed_s_ && (!move_ || *placed_s_ == time_s);
  if (stays && rooms_m.empty()) return;
  for (auto& [body, mesh] : meshes_) {
    mesh.surface->place(mesh_positions(bodies_[body], time_s),
                        rooms_m.empty() ? rooms_m : rooms_m.subspan(mesh.first_room, mesh.rest_positions.size()));
  }
  for (std::size_t b = 0; b < bodies_.size() && !stays; ++b) {
    round_[b].clear();
    sim::Shape shape = sim::shape_at(bodies_[b], time_s);
    if (auto* bar = std::get_if<sim::Capsule>(&shape); bar != nullptr && bodies_[b].name.starts_with("hanger, ")) {
      // Thinner, or the drawn surface, which cuts corners, would show it.
      bar->start_radius_m *= thinner_bar;
      bar->end_radius_m *= thinner_bar;
      if (bodies_[b].name == hanger_left) add_hook(*bar, round_[b]);
    }
    std::visit(RoundMaker{round_[b]}, shape);
  }
  placed_s_ = time_s;
}

std::vector<renderer::SurfaceView> DrawnBodies::views() const {
  std::vector<renderer::SurfaceView> views;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (const renderer::TriangleMesh& mesh : round_[b]) {
      views.push_back(plain_view(mesh.positions, mesh.normals, mesh.triangles));
    }
    if (const auto mesh = meshes_.find(b); mesh != meshes_.end()) {
      const renderer::SmoothSurface& surface = *mesh->second.surface;
      renderer::SurfaceView& view =
          views.emplace_back(plain_view(surface.positions(), surface.normals(), surface.triangles()));
      view.refinement = renderer::Refinement{surface.mesh().coarse_vertex_count(), mesh->second.triangles,
                                             surface.parents(), surface.parent_triangles()};
    }
  }
  return views;
}

std::vector<glm::vec3> wind_arrows(const sim::Wind& wind, const std::vector<sim::Vec3>& positions) {
  std::vector<glm::vec3> lines;
  const auto speed = static_cast<float>(wind.speed_m_per_s);
  if (speed <= 0.0F) return lines;
  const glm::vec3 along = glm::normalize(glm::vec3(wind.direction));
  const glm::vec3 up_ish = std::abs(along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{0, 0, 1};
  const glm::vec3 right = glm::normalize(glm::cross(along, up_ish));
  const glm::vec3 up = glm::cross(right, along);
  const renderer::Box around = renderer::bounding_box(to_float(positions));
  const glm::vec3 middle = 0.5F * (around.lower + around.upper);
  const glm::vec3 half = 0.5F * (around.upper - around.lower);
  const float radius = glm::length(half);
  const float reach = glm::dot(glm::abs(along), half);
  const float length = radius * std::clamp(longest * speed / fastest_m_per_s, shortest, longest);
  for (const float row : {-1.0F, 0.0F, 1.0F}) {
    for (const float column : {-0.5F, 0.5F}) {
      const glm::vec3 tip = middle - along * (reach + gap * radius) + apart * radius * (row * up + column * right);
      lines.insert(lines.end(), {tip - length * along, tip});
      for (const glm::vec3& side : {right, -right, up, -up}) {
        lines.insert(lines.end(), {tip, tip - head * radius * (along - head_width * side)});
      }
    }
  }
  return lines;
}

}  // namespace taut::app
