// What is drawn keeps layers apart, as what is simulated does: hems, borders and the bulges between vertices.
#include <gtest/gtest.h>

#include "app/bodies/body_loading.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/models/garment_loading.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {
namespace {

// Returns whether the simulated triangles have a vertex in common.
bool are_one_layer(const sim::Triangle& a, const sim::Triangle& b) {
  return std::ranges::any_of(a, [&](sim::Index v) { return std::ranges::find(b, v) != b.end(); });
}

// Returns the number of pairs of drawn triangles that cross although their simulated ones are of different layers.
std::size_t crossings_of_drawn(const DrawnScene& scene, const sim::Simulation& simulation, float pixels_per_m) {
  const sim::Garment& garment = simulation.garment();
  GarmentSurface surface(garment);
  SurfaceClearances clearances(scene, garment, simulation.surroundings().bodies, surface.edge_m(),
                               surface.rim_radius_m());
  surface.set_freedom(clearances.freedom());
  surface.set_wrinkled(true);
  surface.set_detail(pixels_per_m, renderer::min_split_px);
  const std::vector<sim::Vec3>& positions_m = simulation.state().current;
  EXPECT_TRUE(surface.leaves_triangles());
  surface.place(to_float(positions_m), clearances.find(positions_m, simulation.state().time_s));
  const renderer::SurfaceView view = surface.view();
  sim::Mesh drawn;
  for (const glm::vec3& position : view.positions) drawn.positions.emplace_back(position);
  for (std::size_t i = 0; i < view.triangles.size(); i += 3) {
    drawn.triangles.push_back({view.triangles[i], view.triangles[i + 1], view.triangles[i + 2]});
  }
  std::size_t count = 0;
  for (const sim::CrossingPair& pair : sim::find_crossing_pairs({drawn.positions, drawn.triangles})) {
    const std::span<const std::uint32_t> parents = view.refinement->parent_triangles;
    const std::vector<sim::Triangle>& simulated = garment.mesh.triangles;
    count += are_one_layer(simulated[parents[pair.first]], simulated[parents[pair.second]]) ? 0 : 1;
  }
  return count;
}

struct Moment {
  const char* scene;
  int frame;
};

class DrawnLayers : public testing::TestWithParam<Moment> {};

TEST_P(DrawnLayers, DoNotCross) {
  DrawnScene scene = find_scene(GetParam().scene, {});
  const LoadedBodies bodies = load_bodies(scene);
  sim::Simulation simulation = make_simulation(scene, load_garment(scene), bodies.all);
  go_to_start(scene, bodies, simulation);
  for (int frame = 0; frame < GetParam().frame; ++frame) simulation.advance_frame();
  // A hem alone leaves the triangles, or the whole surface does.
  for (const float pixels_per_m : {900.0F, 3000.0F}) {
    EXPECT_EQ(crossings_of_drawn(scene, simulation, pixels_per_m), 0U) << pixels_per_m;
  }
}

std::string name_of(const testing::TestParamInfo<Moment>& info) {
  std::string name = info.param.scene;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Short, DrawnLayers,
                         testing::Values(Moment{"tshirt-wind-1", 100}, Moment{"tshirt-wind-10", 60}), name_of);
INSTANTIATE_TEST_SUITE_P(Long, DrawnLayers,
                         testing::Values(Moment{"layers", 60}, Moment{"washing-line", 120}, Moment{"flag", 120},
                                         Moment{"outfit-walk", 30}, Moment{"table-cloth-2", 90},
                                         Moment{"twisted-cylinder", 120}, Moment{"reef-knot", 60},
                                         Moment{"funnel", 90}),
                         name_of);

}  // namespace
}  // namespace taut::app
