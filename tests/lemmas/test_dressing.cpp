// What dressing promises, for random places of a body.

#include <gtest/gtest.h>

#include "app/bodies/body_loading.hpp"
#include "app/garments/dressing/fit.hpp"
#include "app/models/garment_loading.hpp"
#include "check.hpp"
#include "numbers.hpp"

namespace taut::app {
namespace {

TEST(Lemma, FitIsTheSameWhereverTheBodyStands) {
  const std::filesystem::path assets = TAUT_ASSETS_FOLDER;
  BodySource source;
  source.file = assets / "bodies/mannequin_female_34.glb";
  source.dress = 90;
  Scene scene;
  scene.bodies.push_back({.body = {.name = "mannequin", .shape = sim::BodyMesh{}}, .source = source});
  const LoadedBodies bodies = load_bodies(scene);
  for (const char* name : {"dress.obj", "trousers.obj"}) {
    scene.garment.file = assets / "garments" / name;
    const LoadedGarment loaded = load_garment(scene);
    const std::vector<sim::Vec3>& start_m = loaded.garment->mesh.positions;
    const std::vector<FitRow> expected = compute_fit(bodies, *loaded.garment, start_m);
    ASSERT_GE(expected.size(), 4U) << name;
    EXPECT_TRUE(sim::holds(name, [&] {
      sim::Numbers some(*rc::gen::arbitrary<unsigned>());
      const sim::Vec3 by_m = some.vector(2.0);
      LoadedBodies moved = bodies;
      moved.all[0].motion.path = {{0.0, by_m}};
      std::vector<sim::Vec3> moved_m = start_m;
      for (sim::Vec3& p : moved_m) p += by_m;
      const std::vector<FitRow> found = compute_fit(moved, *loaded.garment, moved_m);
      RC_ASSERT(found.size() == expected.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        RC_ASSERT(found[k].name == expected[k].name);
        RC_ASSERT(std::abs(found[k].body_m - expected[k].body_m) < 1e-3);
        RC_ASSERT(std::abs(found[k].garment_m - expected[k].garment_m) < 1e-3);
        RC_ASSERT(std::abs(found[k].body_at_height_m - expected[k].body_at_height_m) < 1e-3);
      }
    }));
  }
}

}  // namespace
}  // namespace taut::app
