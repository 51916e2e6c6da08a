#include <gtest/gtest.h>

#include "app/drawing/drawing.hpp"
#include "app/drawing/framing.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/drawing/garment_surface.hpp"
#include "sim/measures.hpp"
#include "sim/mesh/grid.hpp"

namespace taut::app {
namespace {

DrawnScene horizontal_cloth() {
  DrawnScene scene;
  scene.garment.grid = {.columns = 3, .rows = 3, .plane = sim::GridPlane::horizontal};
  return scene;
}

renderer::Box compute_reach(const DrawnScene& scene, const std::vector<sim::Index>& pins) {
  return expected_reach(scene, sim::make_garment(sim::make_grid(scene.garment.grid)), named_bodies(scene), pins);
}

TEST(Framing, ExpectsClothToHangBelowItsPins) {
  const DrawnScene scene = horizontal_cloth();
  const renderer::Box reach = compute_reach(scene, {0, 2});
  EXPECT_NEAR(reach.lower.y, -std::sqrt(1.25), 1e-6);
  EXPECT_EQ(reach.upper.y, 0.0F);
  EXPECT_EQ(compute_reach(scene, {}).lower.y, 0.0F);
}

TEST(Framing, SeesWhatClothFallsOnto) {
  DrawnScene scene = horizontal_cloth();
  scene.bodies.push_back({.body = {.shape = sim::Sphere{sim::Vec3(0, -2, 0), 0.5}}});
  scene.bodies.push_back({.body = {.shape = sim::Plane{sim::Vec3(0, -3, 0)}}});
  const renderer::Box reach = compute_reach(scene, {});
  EXPECT_EQ(reach.lower.y, -3.0F);
  EXPECT_EQ(*ground_height(scene, named_bodies(scene), reach), -3.0F);
}

TEST(Framing, PutsTheGroundBelowEverything) {
  DrawnScene scene;
  const renderer::Box reach{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_LT(*ground_height(scene, {}, reach), -1.0F);
  scene.picture.ground = {GroundKind::fixed, 0.5};
  EXPECT_EQ(*ground_height(scene, {}, reach), 0.5F);
  scene.picture.ground = {GroundKind::none, 0.0};
  EXPECT_FALSE(ground_height(scene, {}, reach).has_value());
}

TEST(Framing, TakesTheEyeAsGiven) {
  DrawnScene scene;
  scene.camera.eye = glm::vec3(1, 2, 3);
  scene.camera.target = glm::vec3(0, 1, 0);
  const renderer::Camera camera = scene_camera(scene, {{-1, -1, -1}, {1, 1, 1}}, 1.5F);
  EXPECT_EQ(camera.eye, *scene.camera.eye);
  EXPECT_EQ(camera.target, *scene.camera.target);
}

sim::Garment make_cloth(const DrawnScene& scene) { return sim::make_garment(sim::make_grid(scene.garment.grid)); }

/// Fraction of the vertices that the camera sees within the picture.
float share_in_picture(const renderer::Camera& camera, float aspect, std::span<const sim::Vec3> positions) {
  const glm::mat4 to_clip = camera.projection(aspect) * camera.view();
  const auto is_seen = [&](const sim::Vec3& position) {
    const glm::vec4 clip = to_clip * glm::vec4(glm::vec3(position), 1.0F);
    return clip.w > 0.0F && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
  };
  const auto seen = std::ranges::count_if(positions, is_seen);
  return static_cast<float>(seen) / static_cast<float>(std::max<std::size_t>(positions.size(), 1));
}

std::vector<sim::Vec3> translate(std::vector<sim::Vec3> positions, const sim::Vec3& way) {
  for (sim::Vec3& position : positions) {
    position += way;
  }
  return positions;
}

TEST(FittedView, SeesTheGarmentInEveryFrameAndNoMore) {
  DrawnScene scene = horizontal_cloth();
  const sim::Garment cloth = make_cloth(scene);
  const std::vector<sim::Vec3> far = translate(cloth.mesh.positions, {3, 1, 0});
  FittedView both(scene, cloth, {});
  both.add(cloth.mesh.positions, cloth.mesh.positions, 0.0);
  both.add(far, far, 0.1);
  const float aspect = scene.picture.settings.aspect();
  DrawnScene placed = scene;
  both.place_camera(placed);
  const renderer::Camera camera = scene_camera(placed, {}, aspect);
  EXPECT_EQ(share_in_picture(camera, aspect, cloth.mesh.positions), 1.0F);
  EXPECT_EQ(share_in_picture(camera, aspect, far), 1.0F);
  EXPECT_LT(placed.picture.ground.height_m, 0.0);

  DrawnScene followed = scene;
  FittedView of_model(scene, cloth, {});
  of_model.add(cloth.mesh.positions, far, 0.0);
  of_model.place_camera(followed);
  EXPECT_EQ(share_in_picture(scene_camera(followed, {}, aspect), aspect, far), 1.0F) << "which reaches farther";

  FittedView one(scene, cloth, {});
  one.add(cloth.mesh.positions, cloth.mesh.positions, 0.0);
  one.place_camera(scene);
  const renderer::Camera near = scene_camera(scene, {}, aspect);
  EXPECT_EQ(share_in_picture(near, aspect, cloth.mesh.positions), 1.0F);
  EXPECT_EQ(share_in_picture(near, aspect, far), 0.0F);
}

TEST(FittedView, LeavesACameraThatIsGivenAlone) {
  DrawnScene scene = horizontal_cloth();
  EXPECT_TRUE(is_fitted(scene));
  scene.camera.box = renderer::Box{};
  EXPECT_FALSE(is_fitted(scene));
  scene.camera = {};
  scene.camera.eye = glm::vec3(1.0F);
  EXPECT_FALSE(is_fitted(scene));
}

TEST(FittedView, OfACameraThatFollowsIsThatOfAGarmentThatStays) {
  DrawnScene scene = horizontal_cloth();
  scene.camera.follow = true;
  const sim::Garment cloth = make_cloth(scene);
  DrawnScene stays = scene;
  FittedView still(scene, cloth, {});
  still.add(cloth.mesh.positions, cloth.mesh.positions, 0.0);
  still.place_camera(stays);
  DrawnScene moves = scene;
  FittedView moving(scene, cloth, {});
  const std::vector<sim::Vec3> away = translate(cloth.mesh.positions, {30, -7, 2});
  moving.add(away, away, 0.0);
  moving.place_camera(moves);
  EXPECT_LT(glm::distance(*stays.camera.eye, *moves.camera.eye), 1e-4F);

  OffscreenRenderer offscreen("auto");
  GarmentPainter painter(offscreen.renderer(), stays, cloth, {}, {});
  painter.view(translate(cloth.mesh.positions, {30, -7, 2}), 0.0);
  EXPECT_LT(glm::distance(painter.camera().eye, *stays.camera.eye + glm::vec3(30, -7, 2)), 1e-4F);
}

TEST(DrawingQuality, CostsMoreForPrintAndLessForADraft) {
  PictureStyle style;
  const renderer::PictureSettings normal = to_picture_settings(style);
  style.quality = DrawingQuality::draft;
  EXPECT_EQ(to_picture_settings(style).samples, 1);
  EXPECT_GT(min_edge_px(style), min_edge_px({}));
  style.quality = DrawingQuality::high;
  EXPECT_EQ(to_picture_settings(style).supersampling, 2 * normal.supersampling);
  EXPECT_EQ(to_picture_settings(style).width_px, normal.width_px) << "of the finished picture";
  EXPECT_LT(min_edge_px(style), min_edge_px({}));
  style.passes = 9;
  EXPECT_EQ(to_picture_settings(style).passes, 1);
  style.quality = DrawingQuality::final;
  EXPECT_EQ(to_picture_settings(style).passes, 9);
}

TEST(WindArrows, ComeFromWhereItBlowsAndGrowWithIt) {
  const std::vector<sim::Vec3> box{{-1, -1, -1}, {1, 1, 1}};
  sim::Wind wind;
  wind.direction = {2, 0, 0};
  wind.speed_m_per_s = 0.0;
  renderer::Camera camera;
  camera.eye = {0, 0, 9};
  camera.target = {0, 0, 0};
  EXPECT_TRUE(wind_arrows(wind, box, camera).empty());
  const auto length_at = [&](double speed_m_per_s) {
    wind.speed_m_per_s = speed_m_per_s;
    const std::vector<glm::vec3> arrows = wind_arrows(wind, box, camera);
    EXPECT_LT(arrows[1].x, -1.0F) << "beside the box";
    EXPECT_EQ(arrows[0].y, arrows[1].y);
    return arrows[1].x - arrows[0].x;
  };
  EXPECT_NEAR(length_at(20.0), 2.0F * length_at(10.0), 1e-5F);
  EXPECT_EQ(length_at(50.0), length_at(20.0));
  wind.direction = {0, 0, 1};  // towards the eye
  for (const glm::vec3& point : wind_arrows(wind, box, camera)) EXPECT_GT(std::abs(point.x), 1.0F) << "beside the box";
}

TEST(SpringLines, ShowOneKindOrAllInAColourEach) {
  const sim::Garment cloth = make_cloth(horizontal_cloth());
  const std::vector<glm::vec3> positions = to_float(cloth.mesh.positions);
  const auto make_lines = [&](WhichSprings shown) {
    SpringLines lines(cloth, shown, 1.0F);
    renderer::FrameView frame;
    lines.add(positions, frame);
    std::vector<std::size_t> counts;
    for (const renderer::LineView& line : frame.lines) {
      EXPECT_TRUE(&line == &frame.lines[0] || line.colour != frame.lines[0].colour);
      counts.push_back(line.points.size() / 2);
    }
    return counts;
  };
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(make_lines(WhichSprings::none), Counts{});
  EXPECT_EQ(make_lines(WhichSprings::structural), Counts{12});
  EXPECT_EQ(make_lines(WhichSprings::all), (Counts{6, 8, 12}));
}

TEST(StretchLegend, EndsAtTheBoundWhereTheSceneSaysNothingElse) {
  DrawnScene scene;
  scene.simulation.solver.kind = sim::SolverKind::bounded;
  scene.simulation.solver.bounded.max_stretch = 0.013;
  renderer::Legend legend = stretch_legend(scene);
  EXPECT_EQ(legend.minimum, 0.0F);
  EXPECT_EQ(legend.maximum, 0.013F);
  EXPECT_EQ(legend.bound, 0.013F);
  scene.picture.stretch_range = std::array{-0.01, 0.03};
  legend = stretch_legend(scene);
  EXPECT_EQ(legend.minimum, -0.01F);
  EXPECT_EQ(legend.maximum, 0.03F);
  EXPECT_EQ(legend.bound, 0.013F);
}

TEST(StretchLegend, NamesWhatItShowsAndMarksABoundOfThat) {
  DrawnScene scene;
  scene.simulation.solver.bounded.max_stretch = 0.01;
  const auto bound_of = [&](sim::SolverKind solver, sim::BoundKind held, StretchOf shown) {
    scene.simulation.solver.kind = solver;
    scene.simulation.solver.bounded.bound = held;
    scene.picture.stretch_of = shown;
    return stretch_legend(scene).bound;
  };
  using enum sim::SolverKind;
  EXPECT_EQ(bound_of(bounded, sim::BoundKind::springs, StretchOf::springs), 0.01F);
  EXPECT_EQ(stretch_legend(scene).title, "stretch of springs");
  EXPECT_EQ(bound_of(bounded, sim::BoundKind::springs, StretchOf::surface), std::nullopt);
  EXPECT_EQ(stretch_legend(scene).title, "stretch of the surface");
  EXPECT_EQ(stretch_legend(scene).maximum, 0.01F) << "colours end where those of the springs do";
  EXPECT_EQ(bound_of(bounded, sim::BoundKind::surface, StretchOf::surface), 0.01F);
  EXPECT_EQ(bound_of(bounded, sim::BoundKind::surface, StretchOf::springs), 0.01F) << "held with the surface";
  EXPECT_EQ(bound_of(provot, sim::BoundKind::surface, StretchOf::surface), std::nullopt) << "pulls springs";
}

TEST(GarmentPainter, ColoursTheStretchOfWhatTheSceneNames) {
  DrawnScene scene = horizontal_cloth();
  scene.picture.surface = SurfaceLook::stretch;
  const sim::Garment garment = sim::make_garment(sim::make_grid(scene.garment.grid));
  std::vector<sim::Vec3> sheared = garment.mesh.positions;
  for (sim::Vec3& p : sheared) {
    p.x += 0.3 * p.z;
  }
  OffscreenRenderer offscreen("auto");
  const auto colours = [&](StretchOf shown) {
    scene.picture.stretch_of = shown;
    GarmentPainter painter(offscreen.renderer(), scene, garment, {}, {});
    const std::span<const float> values = painter.view(sheared, 0.0).surfaces.back().scalars->values;
    return std::vector<float>(values.begin(), values.begin() + sheared.size());
  };
  const auto single = [](const std::vector<double>& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  const std::vector<float> of_springs = colours(StretchOf::springs);
  const std::vector<float> of_surface = colours(StretchOf::surface);
  EXPECT_EQ(of_springs, single(sim::vertex_stretch(garment.springs, sheared)));
  EXPECT_EQ(of_surface, single(sim::vertex_surface_stretch(garment, sheared)));
  EXPECT_GT(of_surface[4], of_springs[4] + 0.1F);
}

TEST(GarmentPainter, DrawsBodiesWhereTheyAreAtTheTimeOfTheFrame) {
  const auto corner = std::make_shared<const sim::BodyMeshData>(
      sim::BodyMeshData{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
  const sim::RigidMotion upwards = {.shift = {{0, 1, 0}, 0, 2}};
  const DrawnScene scene = horizontal_cloth();
  const std::vector<sim::Body> bodies = {{.shape = sim::Sphere{{0, -2, 0}, 0.5}, .motion = upwards},
                                         {.shape = sim::BodyMesh{corner}, .motion = upwards},
                                         {.shape = sim::Plane{{0, -4, 0}}, .motion = upwards}};
  const sim::Garment garment = sim::make_garment(sim::make_grid(scene.garment.grid));
  OffscreenRenderer offscreen("auto");
  GarmentPainter painter(offscreen.renderer(), scene, garment, bodies, {});
  for (const double time_s : {0.0, 1.5, 9.0, 0.5}) {
    const auto raised_m = static_cast<float>(std::min(time_s, 2.0));
    const renderer::FrameView& view = painter.view(garment.mesh.positions, time_s);
    ASSERT_EQ(view.surfaces.size(), 3U) << "two bodies and the cloth";
    EXPECT_NEAR(renderer::bounding_box(view.surfaces[0].positions).upper.y, -1.5F + raised_m, 1e-6);
    EXPECT_NEAR(view.surfaces[1].positions[0].y, raised_m, 1e-6);
    EXPECT_GT(view.surfaces[1].normals[2].y, 0.5F);
    EXPECT_GT(view.surfaces[1].triangles.size(), 3 * corner->triangles.size()) << "it is drawn smooth";
    EXPECT_EQ(view.surfaces[1].refinement->coarse_vertices, corner->positions_m.size());
    EXPECT_NEAR(*view.ground_height_m, -4.0F + raised_m, 1e-6);
    EXPECT_EQ(view.surfaces[2].refinement->coarse_vertices, garment.mesh.positions.size());
  }
}

TEST(StretchLegend, HasNoBoundWhereTheSolverMeansNone) {
  DrawnScene scene;
  scene.simulation.solver.kind = sim::SolverKind::strong;
  const renderer::Legend legend = stretch_legend(scene);
  EXPECT_EQ(legend.maximum, 0.05F);
  EXPECT_FALSE(legend.bound.has_value());
}

TEST(Framing, LooksAtTheBroadSideOfAModel) {
  DrawnScene scene;
  const renderer::Box deep{{-0.25F, 0.0F, -0.5F}, {0.25F, 1.0F, 0.5F}};
  const renderer::Box hardly_deeper{{-0.4F, 0.0F, -0.5F}, {0.4F, 1.0F, 0.5F}};
  const auto looks_along = [&](const renderer::Box& reach) {
    const renderer::Camera camera = scene_camera(scene, reach, 1.0F);
    const glm::vec3 way = glm::abs(camera.eye - camera.target);
    return way.x > way.z ? 'x' : 'z';
  };
  EXPECT_EQ(looks_along(deep), 'z') << "a grid is seen as ever";
  scene.garment.file = "shirt.obj";
  EXPECT_EQ(looks_along(deep), 'x');
  EXPECT_EQ(looks_along(hardly_deeper), 'z');
  scene.camera.framing.azimuth_rad = 0.0F;
  EXPECT_EQ(looks_along(deep), 'z') << "as asked for";
}

}  // namespace
}  // namespace taut::app
