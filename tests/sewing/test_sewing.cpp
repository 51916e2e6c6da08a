// Patterns sewn on a mannequin, and messages about patterns that cannot be sewn.

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <set>

#include "app/bodies/body_loading.hpp"
#include "app/garments/dressing/fit.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/placing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/hanging/landmarks.hpp"
#include "app/models/inspecting/scene_crossings.hpp"
#include "app/scene/scene_format.hpp"
#include "app/verify/stretch.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/topology.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

const std::filesystem::path assets = TAUT_ASSETS_FOLDER;

/// A skirt of two panels with these widths at the waist and the hem.
std::string skirt(double waist_cm, double hem_cm, double out_cm = 20.0, double height_cm = 40.0,
                  double top_cm = 105.0) {
  const auto panel = [&](const char* name, double depth_cm) {
    return fmt::format(
        R"("{}": {{"vertices": [[{}, 0], [{}, {}], [{}, {}], [{}, 0]], "edges": [{{"endpoints": [0, 1]}},
      {{"endpoints": [1, 2], "curvature": [0.5, -0.1]}}, {{"endpoints": [2, 3]}}, {{"endpoints": [3, 0]}}], "translation": [0, {}, {}]}})",
        name, -0.5 * waist_cm, -0.5 * hem_cm, -height_cm, 0.5 * hem_cm, -height_cm, 0.5 * waist_cm, top_cm, depth_cm);
  };
  return R"({"pattern": {"panels": {)" + panel("front", out_cm) + ", " + panel("back", -out_cm) +
         R"(}, "stitches": [[{"panel": "front", "edge": 0}, {"panel": "back", "edge": 0}],
            [{"panel": "front", "edge": 2}, {"panel": "back", "edge": 2}]]}})";
}

/// A rectangle of this width and height. The middle of its upper edge is at `top_m`, and it is rotated about z.
PatternPanel rectangle(const std::string& name, double width_m, double height_m, const sim::Vec3& top_m,
                       double angle_rad = 0.0) {
  PatternPanel panel{name, {}};
  const double half = 0.5 * width_m;
  const std::vector<sim::Vec2> corners = {{-half, -height_m}, {half, -height_m}, {half, 0.0}, {-half, 0.0}};
  for (std::size_t k = 0; k < 4; ++k) {
    panel.edges_m.push_back({corners[k], corners[(k + 1) % 4]});
  }
  panel.rotation[0] = {std::cos(angle_rad), std::sin(angle_rad), 0.0};
  panel.rotation[1] = {-std::sin(angle_rad), std::cos(angle_rad), 0.0};
  panel.translation_m = top_m;
  return panel;
}

struct Sewing : testing::Test {
  Scene scene_with(const std::filesystem::path& pattern) {
    Scene scene;
    scene.garment.file = pattern;
    scene.simulation.solver.bounded.max_stretch = 0.01;
    BodySource source;
    source.file = assets / "bodies/mannequin_female_34.glb";
    source.dress = 90;
    scene.bodies.push_back({.body = {.name = "mannequin", .shape = sim::BodyMesh{}}, .source = source});
    bodies = load_bodies(scene);
    return scene;
  }
  SewnGarment sewn(const Scene& scene, int triangles, int frames = 60) {
    return sew(read_named_pattern(scene.garment.file), scene, bodies, {triangles, frames}, [](const std::string&) {});
  }
  /// Closes the seams of the scene's pattern about its body.
  SewnPieces close_pattern(const Scene& scene, int triangles, const SewingReport& report) {
    const SewingPattern pattern = read_sewing_pattern(scene.garment.file);
    CutPieces pieces = cut_pieces(pattern, triangles);
    bring_to_body(pattern, bodies, pieces);
    place_pieces(pieces, scene, bodies);
    return close_seams(pieces, scene, bodies, thin_time_s(bodies), report);
  }

  test::TemporaryFolder folder;
  LoadedBodies bodies;  ///< bodies of the last scene
};

TEST_F(Sewing, ASkirtIsClosedWornAndAtRestAsItWasCut) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewnGarment garment = sewn(scene, 800);
  EXPECT_LE(garment.max_stretch, 0.01 + 1e-6);
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  const sim::Topology topology = sim::measure_topology(mesh, sim::make_adjacency(mesh));
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.boundary_loops, 2u);
  EXPECT_EQ(topology.non_manifold_edges, 0u);
  EXPECT_EQ(topology.misoriented_edges, 0u);
  for (const SceneCrossings& crossings :
       scene_crossings({mesh.positions, mesh.triangles}, bodies.all, garment.time_s)) {
    EXPECT_TRUE(crossings.pairs.empty());
  }
  EXPECT_EQ(mesh.positions.size(),
            garment.pieces.flat_m.size() - garment.pieces.seams[0].size() - garment.pieces.seams[1].size());
}

TEST_F(Sewing, ItsFileIsAGarmentThatIsAtRestAsItWasCut) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewnGarment garment = sewn(scene, 800, 1);
  const std::filesystem::path file = folder.write("sewn.obj", to_obj(garment));
  folder.write("sewn.landmarks.toml", to_landmarks_text(garment));
  Scene again;
  again.garment.file = file;
  const LoadedGarment loaded = load_garment(again);
  ASSERT_EQ(loaded.garment->mesh.triangles.size(), garment.pieces.triangles.size());
  EXPECT_EQ(loaded.landmarks.size(), 2u);
  EXPECT_DOUBLE_EQ(loaded.metres_per_uv, 0.01);
  ASSERT_EQ(loaded.file_faces.sections.size(), 2u);
  EXPECT_EQ(loaded.file_faces.sections[0].line, "g back");
  // Rest lengths equal the pattern's lengths, whatever the lengths of the worn garment.
  double flat_m = 0.0, all_m = 0.0;
  for (std::size_t s = 0; s < loaded.garment->springs.structural_count; ++s) {
    all_m += loaded.garment->springs.rest_lengths_m[s];
  }
  for (std::size_t s = 0; s < garment.sewn.garment.springs.structural_count; ++s) {
    flat_m += garment.sewn.garment.springs.rest_lengths_m[s];
  }
  EXPECT_NEAR(all_m, flat_m, 1e-7 * flat_m);
  EXPECT_LE(largest_stretch(loaded.garment->mesh, loaded.garment->mesh.positions).surface, 0.01 + 1e-6);
  double side_m = 0.0;
  const auto& seam = garment.pieces.seams[0];
  for (std::size_t k = 1; k < seam.size(); ++k) {
    side_m += glm::distance(garment.pieces.flat_m[seam[k - 1].first], garment.pieces.flat_m[seam[k].first]);
  }
  EXPECT_NEAR(side_m, std::hypot(0.4, 0.1), 5e-4);
}

TEST_F(Sewing, SaysThatWhatWasSewnIsTooSmall) {
  Scene scene = scene_with(folder.write("skirt.json", skirt(30.0, 38.0)));
  scene.simulation.solver.max_substeps = 30;  // more would try harder, and longer
  const std::string message = test::error_message<SewingFailed>([&] { sewn(scene, 200); });
  EXPECT_NE(message.find("its seams are closed, but it cannot be worn: it does not fit: "), std::string::npos)
      << message;
  EXPECT_NE(message.find(", where the body is "), std::string::npos) << message;
  EXPECT_NE(message.find("; while it is dressed, in frame "), std::string::npos) << message;
  EXPECT_NE(message.find("in a garment of 6"), std::string::npos) << message;
  EXPECT_NE(message.find("; it is tightest in the panel '"), std::string::npos) << message;
}

TEST_F(Sewing, AWaistThatGoesAroundNothingBeginsAtThatOfTheBody) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const Wearer& wearer = *dressed_body(bodies).wearer;
  const sim::Vec3 top_m = {0.0, 0.9, 0.2};
  const SewingPattern pattern = {
      {rectangle("front", 0.3, 0.6, top_m), rectangle("back", 0.3, 0.6, top_m - sim::Vec3(0.0, 0.0, 0.4))},
      {{{0, 1}, {1, 1}}, {{0, 3}, {1, 3}}}};
  CutPieces pieces = cut_pieces(pattern, 300);
  bring_to_body(pattern, bodies, pieces);
  EXPECT_NEAR(sim::compute_extent(pieces.placed_m).upper.y, wearer.measures.waist_m->y, 1e-6);
}

TEST_F(Sewing, ATopWithoutStrapsIsHeldUntilItRests) {
  const Scene scene = scene_with(folder.write("top.json", skirt(48.0, 39.0, 24.0, 24.0, 128.0)));
  const SewnGarment garment = sewn(scene, 800, 600);
  const sim::Extent range = sim::compute_extent(garment.sewn.garment.mesh.positions);
  EXPECT_TRUE(garment.is_at_rest);
  EXPECT_GT(range.upper.y, 1.206);  // without hands it slides down to 1.203
}

TEST_F(Sewing, ComesToRestInTwoSecondsOrThree) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewnGarment garment = sewn(scene, 800, 600);
  EXPECT_TRUE(garment.is_at_rest);
  EXPECT_LE(garment.frames, 180);
  EXPECT_LE(garment.rms_speed_m_per_s, 0.02);
}

TEST_F(Sewing, ComesToRestInTheAirOfTheScene) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewnGarment garment = sewn(scene, 800, 600);
  ASSERT_TRUE(garment.is_at_rest);
  EXPECT_EQ(describe_rest(garment), "at rest");
  const std::filesystem::path file = folder.write("sewn.obj", to_obj(garment));
  folder.write("sewn.landmarks.toml", to_landmarks_text(garment));
  Scene again = scene;
  again.garment.file = file;
  again.bodies[0].source.dress = 0;
  sim::Simulation simulation = make_simulation(again, load_garment(again), bodies.all);
  simulation.set_time(garment.time_s);
  for (int frame = 0; frame < 60; ++frame) simulation.advance_frame();
  EXPECT_LE(sim::rms_speed(simulation.change()), 0.025);
  SewnGarment moving = garment;
  moving.is_at_rest = false;
  EXPECT_NE(describe_rest(moving).find("still moving at "), std::string::npos);
}

TEST_F(Sewing, WhatMovesInTheAirOfTheSceneIsNotAtRest) {
  // In wind that thick air stills, the skirt flutters without it.
  Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  scene.surroundings.forces.air_drag_per_s = 0.0;
  scene.surroundings.forces.wind.speed_m_per_s = 8.0;
  const SewnGarment garment = sewn(scene, 400, 300);
  EXPECT_FALSE(garment.is_at_rest);
  EXPECT_GT(garment.rms_speed_m_per_s, 0.01);
}

TEST_F(Sewing, KeepsTheBoundInEveryFrameInWhichPiecesAreJoined) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  std::set<double> shares;
  double max_stretch = 0.0;
  const SewnPieces sewn =
      close_pattern(scene, 800, [&](double share, const sim::Garment& garment, const auto& positions_m) {
        max_stretch = std::max(max_stretch, sim::measure_surface_stretch(garment, positions_m).max);
        shares.insert(share);
      });
  EXPECT_EQ(sewn.gap_m, 0.0);
  EXPECT_GE(shares.size(), 2u) << "it was not joined while it was looked at";
  EXPECT_LE(max_stretch, 0.01 + 1e-6);
}

TEST_F(Sewing, ADressIsClosedAfterFortyFrames) {
  Scene scene = scene_with(assets / "patterns/wardrobe/dress.json");
  scene.simulation.solver.bounded.max_stretch = 0.05;
  scene.material = find_fabric_material("jersey", "--fabric");
  int frames = -1, first_join = 0;
  const SewnPieces sewn = close_pattern(scene, 700, [&](double share, const sim::Garment&, const auto&) {
    ++frames;
    if (first_join == 0 && share > 0.0) first_join = frames;
  });
  EXPECT_EQ(sewn.gap_m, 0.0);
  EXPECT_EQ(first_join, 12) << "what is nearly closed waits, or what is far from closed is tried";
  EXPECT_NEAR(frames, 40, 2) << "fewer: it was pulled harder or joined from farther away; more: it takes longer";
}

TEST_F(Sewing, RefusesWhatFellCrossesOrIsStretched) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewnGarment garment = sewn(scene, 400, 1);
  const auto refusal_of = [&](const std::function<sim::Vec3(const sim::Vec3&)>& move) {
    SewnGarment moved = garment;
    std::vector<sim::Vec3>& positions_m = moved.sewn.garment.mesh.positions;
    std::transform(positions_m.begin(), positions_m.end(), positions_m.begin(), move);
    return test::error_message<SewingFailed>([&] { require_worn(scene, bodies, moved); });
  };
  SewnGarment as_sewn = garment;
  EXPECT_NO_THROW(require_worn(scene, bodies, as_sewn));
  EXPECT_NE(refusal_of([](sim::Vec3 p) { return p - sim::Vec3(0.0, 1.0, 0.0); }).find("it falls down"),
            std::string::npos);
  EXPECT_NE(refusal_of([](sim::Vec3 p) { return p + sim::Vec3(1.0, 0.0, 0.0); }).find("does not go around the body"),
            std::string::npos);
  EXPECT_NE(refusal_of([](sim::Vec3 p) { return p + sim::Vec3(0.1, 0.0, 0.0); }).find("when it is worn, "),
            std::string::npos);
  EXPECT_NE(refusal_of([](sim::Vec3 p) { return sim::Vec3(1.3 * p.x, p.y, 1.3 * p.z); }).find("it is stretched by "),
            std::string::npos);
}

TEST_F(Sewing, WhatFallsIsShownWhereItLeavesTheBody) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(90.0, 95.0)));
  try {
    sewn(scene, 200, 1500);
    FAIL() << "it stays on the body";
  } catch (const SewingFailed& error) {
    EXPECT_NE(std::string(error.what()).find("it falls down"), std::string::npos) << error.what();
    const BodyMeasures& measures = dressed_body(bodies).wearer->measures;
    EXPECT_GT(sim::compute_extent(error.garment.sewn.garment.mesh.positions).upper.y,
              measures.levels[measures.fork].height_m - 0.1);
  }
}

TEST_F(Sewing, ALegWarmerStaysOnItsLeg) {
  std::string leg_warmer = skirt(19.0, 19.0, 12.0, 30.0, 10.0);
  leg_warmer.insert(leg_warmer.size() - 1, R"(, "properties": {"joint": "left leg"})");
  Scene scene = scene_with(folder.write("leg_warmer.json", leg_warmer));
  scene.simulation.solver.bounded.max_stretch = 0.3;
  const SewnGarment garment = sewn(scene, 300);
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  EXPECT_LT(sim::compute_extent(mesh.positions).upper.y, dressed_body(bodies).wearer->joints.at("left upleg").y);
  EXPECT_TRUE(compute_fit(bodies, garment.sewn.garment, mesh.positions).empty()) << "girths of both legs";
}

TEST_F(Sewing, ShortLevelSideSeamsAreNoShoulders) {
  // Each side of a wide tier is as level as a shoulder, and nothing of the body is below it.
  const Scene scene = scene_with(folder.write("tier.json", skirt(44.0, 80.0, 20.0, 15.0)));
  const SewingPattern tier = read_sewing_pattern(scene.garment.file);
  CutPieces pieces = cut_pieces(tier, 300);
  bring_to_body(tier, bodies, pieces);
  for (const sim::Vec3& p : pieces.placed_m) EXPECT_TRUE(std::isfinite(p.y));
  EXPECT_TRUE(pieces.first_seams.empty());
}

TEST_F(Sewing, SaysWhichSeamStaysOpenAndByHowMuch) {
  // The waist is sewn together as well, and the body is in between.
  std::string text = skirt(40.0, 60.0);
  text.replace(text.rfind("]}}"), 3, R"(, [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 3}]]}})");
  const Scene scene = scene_with(folder.write("skirt.json", text));
  try {
    sewn(scene, 400);
    FAIL() << "it was sewn";
  } catch (const SewingFailed& error) {
    EXPECT_NE(std::string(error.what()).find("a seam stays open: front, edge 3 with back, edge 3, by "),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("; the body is in the way, "), std::string::npos) << error.what();
    EXPECT_GT(error.garment.sewn.gap_m, 0.005);
    EXPECT_FALSE(error.garment.sewn.garment.mesh.triangles.empty()) << "there is nothing to draw";
  }
}

TEST_F(Sewing, SaysWhichPanelIsSewnToNothing) {
  std::string text = skirt(40.0, 60.0);
  text.replace(text.find("\"stitches\": [[") + 13, std::string::npos, "]}}");
  const Scene scene = scene_with(folder.write("skirt.json", text));
  const std::string message = test::error_message<InputError>([&] { sewn(scene, 200); });
  EXPECT_NE(message.find("the panel 'back': found no stitch to another panel"), std::string::npos) << message;
}

TEST_F(Sewing, SaysThatAPatternHasTheWrongUnit) {
  for (const double units_in_metre : {1e4, 10.0}) {
    std::string text = skirt(40.0, 60.0);
    text.insert(1, fmt::format(R"("properties": {{"units_in_meter": {}}}, )", units_in_metre));
    const Scene scene = scene_with(folder.write("skirt.json", text));
    const std::string message = test::error_message<InputError>([&] { sewn(scene, 200); });
    EXPECT_NE(message.find("m; properties.units_in_meter says what a unit is"), std::string::npos) << message;
  }
}

TEST_F(Sewing, ClothesAreAsLargeAsThoseOfDollsOrLessThanTwicePeoples) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const auto is_refused = [&](double size_m) {
    const SewingPattern pattern = {{rectangle("panel", size_m, size_m, {0.0, 1.0, 0.2})}, {}};
    CutPieces pieces = cut_pieces(pattern, 100);
    return test::error_message<InputError>([&] {
             bring_to_body(pattern, bodies, pieces);
           }).find("found a pattern of") != std::string::npos;
  };
  EXPECT_TRUE(is_refused(0.03));
  EXPECT_FALSE(is_refused(0.05));
  EXPECT_FALSE(is_refused(3.0));
  EXPECT_TRUE(is_refused(4.0));
}

TEST_F(Sewing, SaysWhichSeamsShareAnEdge) {
  std::string text = skirt(40.0, 60.0);
  text.replace(text.rfind("]}}"), 3, R"(, [{"panel": "front", "edge": 0}, {"panel": "front", "edge": 2}]]}})");
  const Scene scene = scene_with(folder.write("skirt.json", text));
  const std::string message = test::error_message<SewingFailed>([&] { sewn(scene, 200); });
  EXPECT_NE(message.find("it shares an edge with the seam of front, edge "), std::string::npos) << message;
}

TEST_F(Sewing, PanelsThatBeginWithinTheBodyGoAroundIt) {
  const Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0, 2.0)));
  const SewnGarment garment = sewn(scene, 400, 1);
  EXPECT_EQ(garment.sewn.gap_m, 0.0);
  EXPECT_EQ(garment.remarks.size(), 2u) << "that it was moved to the body and apart";
}

TEST_F(Sewing, APatternIsWornOverAnother) {
  Scene scene = scene_with(folder.write("inner.json", skirt(40.0, 60.0)));
  const std::filesystem::path outer = folder.write("outer.json", skirt(48.0, 80.0));
  scene.fabric = "cotton";
  scene.material = find_fabric_material("cotton", "--fabric");
  const SewnGarment garment = sew(read_named_pattern(scene.garment.file), scene, bodies,
                                  {1200, 60, {read_named_pattern(outer)}, {"denim"}}, [](const std::string&) {});
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  EXPECT_EQ(garment.pattern.panels[2].name, "outer.back");
  Scene again;
  again.material = scene.material;
  again.garment.file = folder.write("sewn.obj", to_obj(garment));
  folder.write("sewn.landmarks.toml", to_landmarks_text(garment));
  EXPECT_EQ(read_garment_facts(again.garment.file).layers, 2);
  EXPECT_EQ(find_scene(undrawn_format(), again.garment.file.string(), {}).material, scene.material);
  const std::vector<Override> silk = {{"cloth.fabric", "silk", "--fabric"}};
  EXPECT_EQ(find_scene(undrawn_format(), again.garment.file.string(), silk).material, find_fabric_material("silk", ""));
  const LoadedGarment loaded = load_garment(again);
  const std::vector<sim::Triangle>& triangles = loaded.garment->mesh.triangles;
  const sim::Index inner_vertex = triangles.front()[0], outer_vertex = triangles.back()[0];
  EXPECT_EQ(loaded.garment->material_at(inner_vertex).areal_density_kg_per_m2, scene.material.areal_density_kg_per_m2);
  EXPECT_EQ(loaded.garment->material_at(outer_vertex), find_fabric_material("denim", ""));
  const auto mass_kg = [](const sim::Garment& cloth) {
    return std::accumulate(cloth.masses_kg.begin(), cloth.masses_kg.end(), 0.0);
  };
  EXPECT_NEAR(mass_kg(*loaded.garment), mass_kg(garment.sewn.garment), 1e-4 * mass_kg(*loaded.garment));
  again.material = {};
  EXPECT_NE(test::error_message<InputError>([&] { load_garment(again); }).find("expected a fabric for all (--fabric)"),
            std::string::npos);
  EXPECT_EQ(sim::measure_topology(mesh, sim::make_adjacency(mesh)).components, 2u);
  EXPECT_LE(garment.max_stretch, 0.01 + 1e-6);
  for (const SceneCrossings& crossings :
       scene_crossings({mesh.positions, mesh.triangles}, bodies.all, garment.time_s)) {
    EXPECT_TRUE(crossings.pairs.empty());
  }
  // The outer skirt surrounds the inner one: its box is larger on all sides.
  std::array<sim::Extent, 2> boxes;
  const double middle_m =
      0.5 * (sim::compute_extent(mesh.positions).lower.y + sim::compute_extent(mesh.positions).upper.y);
  for (std::size_t v = 0; v < garment.pieces.flat_m.size(); ++v) {
    const sim::Vec3& at = mesh.positions[garment.sewn.vertex_of[v]];
    if (std::abs(at.y - middle_m) < 0.05) {
      boxes[garment.pieces.layer_of[garment.pieces.panel_of[v]]].add(at);
    }
  }
  EXPECT_LT(boxes[1].lower.x, boxes[0].lower.x);
  EXPECT_GT(boxes[1].upper.x, boxes[0].upper.x);
  EXPECT_LT(boxes[1].lower.z, boxes[0].lower.z);
  EXPECT_GT(boxes[1].upper.z, boxes[0].upper.z);
}

/// A square of this width about a point of the plane z = `depth_m`, and its four edges.
PatternPanel square_panel(const std::string& name, double width_m, double depth_m) {
  return rectangle(name, width_m, width_m, {0.0, 0.5 * width_m, depth_m});
}

TEST_F(Sewing, WithoutABodyACushionClosesAndRests) {
  const SewingPattern cushion = {{square_panel("upper", 0.4, 0.05), square_panel("lower", 0.4, -0.05)},
                                 {{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 2}, {1, 2}}, {{0, 3}, {1, 3}}}};
  Scene scene;
  scene.simulation.solver.bounded.max_stretch = 0.01;
  const SewnGarment garment = sew({"cushion.json", cushion}, scene, bodies, {800, 600}, [](const std::string&) {});
  EXPECT_TRUE(garment.is_at_rest);
  EXPECT_LE(garment.max_stretch, 0.01 + 1e-6);
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  const sim::Topology topology = sim::measure_topology(mesh, sim::make_adjacency(mesh));
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.boundary_loops, 0u);
  EXPECT_EQ(topology.misoriented_edges, 0u);
  EXPECT_TRUE(sim::find_crossing_pairs({mesh.positions, mesh.triangles}).empty());
  const sim::Extent box = sim::compute_extent(mesh.positions);
  EXPECT_LT(glm::length(box.middle()), 0.05) << "it does not stay where it was sewn";
  EXPECT_GT(box.size().x, 0.38);
}

TEST_F(Sewing, WithoutABodyAFlatPanelIsSewnToItself) {
  // Threads in its plane bend nothing out of the plane.
  const SewingPattern tube = {{rectangle("tube", 0.6, 0.3, {0.0, 0.3, 0.0})}, {{{0, 1}, {0, 3}}}};
  const SewnGarment garment = sew({"tube.json", tube}, {}, bodies, {800, 1}, [](const std::string&) {});
  EXPECT_EQ(garment.sewn.gap_m, 0.0);
}

TEST_F(Sewing, APatternWithoutABodyIsASceneOfItsOwn) {
  Scene scene;
  scene.garment.file = folder.write("skirt.json", skirt(40.0, 60.0));
  sew_garment(scene);
  const LoadedGarment loaded = load_garment(scene);
  const sim::Mesh& mesh = loaded.garment->mesh;
  EXPECT_EQ(sim::measure_topology(mesh, sim::make_adjacency(mesh)).boundary_loops, 2u);
  std::filesystem::remove(scene.garment.sewn);
}

TEST_F(Sewing, APatternLiesAboutTheJointThatItNames) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  SewingPattern pattern = {{square_panel("front", 0.3, 0.2), square_panel("back", 0.3, -0.2)},
                           {{{0, 1}, {1, 1}}, {{0, 3}, {1, 3}}}};
  pattern.joint = "head";
  CutPieces pieces = cut_pieces(pattern, 300);
  bring_to_body(pattern, bodies, pieces);
  const sim::Vec3 head_m = dressed_body(bodies).wearer->joints.at("head");
  EXPECT_LT(glm::distance(sim::compute_extent(pieces.placed_m).middle(), head_m), 1e-3);
  pattern.joint = "nose";
  const std::string message = test::error_message<InputError>([&] { bring_to_body(pattern, bodies, pieces); });
  EXPECT_NE(message.find("properties.joint: found 'nose', expected a joint of the body: "), std::string::npos);
}

TEST_F(Sewing, APonchoIsSewnOverTheArms) {
  const auto panel = [](const char* name, double depth_cm) {
    return fmt::format(
        R"("{}": {{"vertices": [[-50, -20], [-50, -50], [50, -50], [50, -20], [15, 0], [-15, 0]],
      "edges": [{{"endpoints": [0, 1]}}, {{"endpoints": [1, 2]}}, {{"endpoints": [2, 3]}}, {{"endpoints": [3, 4]}},
                {{"endpoints": [4, 5]}}, {{"endpoints": [5, 0]}}], "translation": [0, 150, {}]}})",
        name, depth_cm);
  };
  const Scene scene = scene_with(
      folder.write("poncho.json", R"({"pattern": {"panels": {)" + panel("front", 20.0) + ", " + panel("back", -20.0) +
                                      R"(}, "stitches": [[{"panel": "front", "edge": 3}, {"panel": "back", "edge": 3}],
                                            [{"panel": "front", "edge": 5}, {"panel": "back", "edge": 5}]]}})"));
  const SewnGarment garment = sewn(scene, 800, 1);
  const Wearer& wearer = *dressed_body(bodies).wearer;
  EXPECT_GT(sim::compute_extent(garment.sewn.garment.mesh.positions).upper.y, wearer.measures.neck_m->y - 0.05);
  const std::vector<FitRow> fit = compute_fit(bodies, garment.sewn.garment, garment.sewn.garment.mesh.positions);
  EXPECT_TRUE(std::ranges::none_of(fit, [](const FitRow& row) { return row.name == "waistband"; }));
}

TEST_F(Sewing, FactsOfAGarmentThatWasSewnAreNotThoseOfItsPattern) {
  const std::filesystem::path pattern = folder.write("skirt.json", skirt(40.0, 60.0));
  folder.write("skirt.landmarks.toml", "fabric = \"denim\"\nlayers = 2\n");
  EXPECT_EQ(find_scene(undrawn_format(), pattern.string(), {}).fabric, "");
  EXPECT_EQ(read_garment_facts(pattern).layers, 1);
}

TEST_F(Sewing, WhatWasSewnTightIsSimulatedWithinTheBoundItWasSewnWithin) {
  const std::filesystem::path garment = folder.write("skirt.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("skirt.landmarks.toml", "fabric = \"jersey\"\nmax_stretch = 0.6\n");
  const auto bound_of = [&](std::span<const Override> overrides) {
    return find_scene(undrawn_format(), garment.string(), overrides).simulation.solver.bounded.max_stretch;
  };
  EXPECT_EQ(bound_of({}), 0.6);
  EXPECT_EQ(bound_of(std::vector<Override>{{"cloth.fabric", "cotton", "--fabric"}}), 0.6);
  EXPECT_EQ(bound_of(std::vector<Override>{{"solver.max_stretch", "0.02", "--set"}}), 0.02);
}

TEST_F(Sewing, ASleeveIsTurnedToTheArmWithItsCuff) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  // A sleeve as wide as an arm, which hangs at 45 degrees, and a cuff at its end, 30 cm below the shoulder.
  constexpr double hanging = 0.785398;
  SewingPattern pattern;
  for (const double depth_m : {0.1, -0.1}) {
    const std::string side = depth_m > 0.0 ? "front" : "back";
    pattern.panels.push_back(rectangle(side, 0.4, 0.6, {0.0, 1.4, depth_m}));
    pattern.panels.push_back(rectangle(side + " sleeve", 0.2, 0.4, {0.22, 1.38, depth_m}, hanging));
    pattern.panels.push_back(rectangle(side + " cuff", 0.2, 0.05, {0.52, 1.08, depth_m}, hanging));
  }
  for (const std::size_t p : {0, 1}) {
    pattern.stitches.push_back({{3 * p + 1, 2}, {3 * p, 1}});
    pattern.stitches.push_back({{3 * p + 1, 0}, {3 * p + 2, 2}});
  }
  pattern.panels.push_back(rectangle("hood", 0.15, 0.35, {0.24, 1.8, 0.1}));
  CutPieces pieces = cut_pieces(pattern, 600);
  turn_sleeves(pattern, sim::Vec3(0.0), *dressed_body(bodies).wearer, pieces);
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  EXPECT_GT(boxes[2].middle().y, boxes[0].upper.y - 0.2) << "the cuff still hangs";
  EXPECT_LT(glm::distance(boxes[1].middle(), boxes[2].middle()), 0.3) << "it is torn from the sleeve";
  EXPECT_NEAR(boxes[6].upper.x - boxes[6].lower.x, 0.15, 1e-9) << "the hood is turned with it";
}

TEST_F(Sewing, SaysThatPanelsLieOnEachOther) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewingPattern pattern = {{rectangle("front", 0.4, 0.6, {}), rectangle("back", 0.4, 0.6, {})},
                                 {{{0, 1}, {1, 1}}}};
  CutPieces pieces = cut_pieces(pattern, 300);
  EXPECT_NE(test::error_message<InputError>([&] {
              bring_to_body(pattern, bodies, pieces);
            }).find("found all 2 panels of the pattern at "),
            std::string::npos);
}

TEST_F(Sewing, SeamsOfTheTShirtAreAsLongAsDrafted) {
  const std::filesystem::path drafted = folder / "tshirt.json";
  const std::string tshirt = (assets / "patterns/tshirt").string();
  ASSERT_EQ(std::system(("python3 " + tshirt + "/as_json.py " + tshirt + "/teagan.toml > " + drafted.string()).c_str()),
            0);
  const SewingPattern pattern = read_sewing_pattern(drafted);
  for (const int triangles : {1028, 5280, 10600}) {
    const CutPieces pieces = cut_pieces(pattern, triangles);
    ASSERT_EQ(pieces.seams.size(), 10u);
    for (std::size_t s = 0; s < pieces.seams.size(); ++s) {
      double first_m = 0.0, second_m = 0.0;
      for (std::size_t k = 1; k < pieces.seams[s].size(); ++k) {
        const auto& [a, b] = pieces.seams[s][k];
        const auto& before = pieces.seams[s][k - 1];
        first_m += glm::distance(pieces.flat_m[before.first], pieces.flat_m[a]);
        second_m += glm::distance(pieces.flat_m[before.second], pieces.flat_m[b]);
      }
      EXPECT_NEAR(first_m, polyline_length(pattern.line_of(pattern.stitches[s].first)), 5e-4) << triangles;
      EXPECT_NEAR(second_m, polyline_length(pattern.line_of(pattern.stitches[s].second)), 5e-4) << triangles;
    }
  }
}

TEST_F(Sewing, HeightsCountFromTheFeetOrFromTheChest) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const auto placed_top_m = [&](double top_m, double height_m) {
    const SewingPattern pattern = {
        {rectangle("front", 0.6, height_m, {0.0, top_m, 0.2}), rectangle("back", 0.6, height_m, {0.0, top_m, -0.2})},
        {{{0, 1}, {1, 1}}, {{0, 3}, {1, 3}}}};
    CutPieces pieces = cut_pieces(pattern, 300);
    bring_to_body(pattern, bodies, pieces);
    return sim::compute_extent(pieces.placed_m).upper.y;
  };
  EXPECT_LT(placed_top_m(0.75, 0.5), 1.0) << "shorts, from the feet";
  EXPECT_GT(placed_top_m(0.45, 0.5), 1.0) << "a short top, about the chest";
}

TEST_F(Sewing, WhatLiesAboutTheChestBeginsAtTheSideOfTheNeck) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewingPattern pattern = {
      {rectangle("front", 0.9, 0.5, {0.0, -0.1, 0.2}), rectangle("back", 0.9, 0.5, {0.0, -0.1, -0.2})},
      {{{0, 1}, {1, 1}}, {{0, 3}, {1, 3}}}};
  CutPieces pieces = cut_pieces(pattern, 300);
  bring_to_body(pattern, bodies, pieces);
  const double neck_m = dressed_body(bodies).wearer->measures.neck_m->y;
  EXPECT_NEAR(sim::compute_extent(pieces.placed_m).upper.y, neck_m - 0.29 - 0.1, 0.03);
}

TEST_F(Sewing, ShouldersLieAboveTheThinBody) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const Wearer& wearer = *dressed_body(bodies).wearer;
  // Seams are level, so that their height is above the highest bone below them.
  const SewingPattern pattern = {
      {rectangle("front", 0.06, 0.6, {0.08, 1.4, 0.1}), rectangle("back", 0.06, 0.6, {0.08, 1.4, -0.1})},
      {{{0, 2}, {1, 2}}}};
  CutPieces pieces = cut_pieces(pattern, 300);
  bring_to_body(pattern, bodies, pieces);
  const sim::Extent range = sim::compute_extent(pieces.placed_m);
  double bone_m = 0.0;
  for (const sim::Vec3& p : placed_m(wearer.places, compute_thin_shape(*wearer.rig, wearer.pose))) {
    if (p.x > range.lower.x && p.x < range.upper.x) bone_m = std::max(bone_m, p.y);
  }
  EXPECT_NEAR(range.upper.y - bone_m, 0.06, 0.015);
}

TEST_F(Sewing, ShoulderSeamsAreShortAndNearlyLevelAndNearTheHighest) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const auto find_shoulders = [&](const std::vector<std::array<PatternPanel, 2>>& pairs) {
    SewingPattern pattern;
    for (const auto& [front, back] : pairs) {
      const std::size_t first = pattern.panels.size();
      pattern.panels.insert(pattern.panels.end(), {front, back});
      pattern.stitches.push_back({{first, 2}, {first + 1, 2}});
    }
    CutPieces pieces = cut_pieces(pattern, 400);
    bring_to_body(pattern, bodies, pieces);
    return pieces.first_seams.size();
  };
  const auto pair = [](double width_m, sim::Vec3 top_m, double angle_rad = 0.0) {
    PatternPanel front = rectangle("front", width_m, 0.3, top_m, angle_rad);
    top_m.z = -top_m.z;
    return std::array<PatternPanel, 2>{front, rectangle("back", width_m, 0.3, top_m, angle_rad)};
  };
  // They are low: a seam that begins near the neck may be long, as in a poncho.
  const double shoulder_m = 0.9;
  EXPECT_EQ(find_shoulders({pair(0.2, {0.12, shoulder_m, 0.1})}), 1u);
  EXPECT_EQ(find_shoulders({pair(0.45, {0.23, shoulder_m, 0.1})}), 0u) << "a long one";
  EXPECT_EQ(find_shoulders({pair(0.2, {0.12, shoulder_m, 0.1}, -0.8)}), 1u) << "nearly 45 degrees";
  EXPECT_EQ(find_shoulders({pair(0.2, {0.12, shoulder_m, 0.1}, -1.0)}), 0u) << "a steep one";
  EXPECT_EQ(find_shoulders({pair(0.1, {0.06, shoulder_m, 0.1}), pair(0.1, {-0.06, shoulder_m - 0.15, 0.1})}), 2u);
  EXPECT_EQ(find_shoulders({pair(0.1, {0.06, shoulder_m, 0.1}), pair(0.1, {-0.06, shoulder_m - 0.3, 0.1})}), 1u)
      << "a low one";
}

TEST_F(Sewing, ShouldersAreFoundBelowAHood) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewingPattern pattern = {
      {rectangle("front", 0.2, 0.6, {0.15, 1.4, 0.1}), rectangle("back", 0.2, 0.6, {0.15, 1.4, -0.1}),
       rectangle("hood", 0.2, 0.4, {0.0, 1.8, 0.0})},
      {{{0, 2}, {1, 2}}, {{0, 3}, {2, 3}}}};
  CutPieces pieces = cut_pieces(pattern, 300);
  bring_to_body(pattern, bodies, pieces);
  EXPECT_EQ(pieces.first_seams, std::vector<std::size_t>{0});
}

TEST_F(Sewing, SleevesAreBesideTheShoulderAndNearIt) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const Wearer& wearer = *dressed_body(bodies).wearer;
  const sim::Vec3 shoulder_m = find_limb(wearer, 1.0, arm_parts)->begin_m;
  // A panel that hangs at 45 degrees. Its middle is over the shoulder by this height.
  const auto is_turned = [&](double beside, double over_m) {
    const double half = 0.1 * std::numbers::sqrt2 / 2.0;
    const sim::Vec3 top_m(beside * shoulder_m.x + half, shoulder_m.y + over_m + 2.0 * half, 0.0);
    const SewingPattern pattern = {{rectangle("sleeve", 0.2, 0.4, top_m, std::numbers::pi / 4.0)}, {}};
    CutPieces pieces = cut_pieces(pattern, 100);
    const std::vector<sim::Vec3> before_m = pieces.placed_m;
    turn_sleeves(pattern, sim::Vec3(0.0), wearer, pieces);
    return pieces.placed_m != before_m;
  };
  EXPECT_TRUE(is_turned(0.9, 0.0));
  EXPECT_FALSE(is_turned(0.45, 0.0)) << "a side panel";
  EXPECT_TRUE(is_turned(0.9, 0.09));
  EXPECT_FALSE(is_turned(0.9, 0.18)) << "a hood";
  EXPECT_TRUE(is_turned(0.9, -0.35));
  EXPECT_FALSE(is_turned(0.9, -0.5)) << "a pocket";
}

TEST_F(Sewing, ArmsAreLoweredBelowSeamsThatLieOverThem) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const Wearer& wearer = *dressed_body(bodies).wearer;
  const sim::Vec3 shoulder_m = find_limb(wearer, 1.0, arm_parts)->begin_m;
  CutPieces pieces = cut_pieces({{rectangle("front", 0.6, 0.9, {0.0, 1.0, 0.2})}, {}}, 300);
  pieces.seams = {{{0, 0}, {1, 1}}};
  pieces.first_seams = {0};
  const auto slope = [&](double over_arm_m) {
    pieces.placed_m[0] = shoulder_m - sim::Vec3(0.1, 0.0, 0.0);
    pieces.placed_m[1] = shoulder_m + sim::Vec3(over_arm_m, -0.5 * over_arm_m, 0.0);
    const sim::Vec3 way = turned_limbs(wearer, pieces).front().direction;
    return -way.y / std::abs(way.x);
  };
  EXPECT_NEAR(slope(0.07), 0.2, 0.05) << "arms are nearly level";
  EXPECT_NEAR(slope(0.15), slope(0.07) + 0.5, 1e-9) << "wide shoulders end beside the joint";
}

/// Returns the surface of a box about the middle, with these half sizes.
sim::Mesh box(const sim::Vec3& half_m) {
  sim::Mesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.positions.push_back(half_m * sim::Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Returns the panel turned about the vertical by this angle.
PatternPanel turn_panel(PatternPanel panel, double angle_rad) {
  panel.rotation[0] = {std::cos(angle_rad), 0.0, -std::sin(angle_rad)};
  panel.rotation[2] = {std::sin(angle_rad), 0.0, std::cos(angle_rad)};
  return panel;
}

constexpr double body_half_m = 0.1;

/// Places a panel about a box with this half width.
CutPieces place_about_box(const PatternPanel& panel, double half_m = body_half_m) {
  CutPieces pieces = cut_pieces({{panel}, {}}, 100);
  const sim::Mesh body = box({half_m, 1.0, half_m});
  part_and_draw_in({body.positions, body.triangles}, {0.0, 1.0, 0.0}, pieces);
  return pieces;
}

TEST(Placing, PiecesAreDrawnInToThreeCentimetres) {
  const CutPieces pieces = place_about_box(rectangle("front", 0.15, 0.3, {0.0, 0.2, 0.5}));
  EXPECT_NEAR(panel_boxes(pieces)[0].lower.z - body_half_m, 0.035, 0.01);
}

TEST(Placing, PiecesThatCrossTheBodyMoveJustOutOfIt) {
  const CutPieces pieces =
      place_about_box(turn_panel(rectangle("front", 0.3, 0.3, {0.0, 0.2, body_half_m - 0.036}), 0.01));
  EXPECT_NEAR(panel_boxes(pieces)[0].middle().z - body_half_m, 0.015, 0.004) << "by steps of a centimetre";
  constexpr double deep_half_m = 0.6;
  const CutPieces deep = place_about_box(rectangle("front", 1.5, 0.3, {0.0, 0.2, 0.1}), deep_half_m);
  EXPECT_GT(panel_boxes(deep)[0].lower.z, deep_half_m) << "it begins half a metre within";
}

TEST(Placing, OuterLayersLieOverInnerOnesThatFaceTheirWay) {
  // The outer panel begins 20 cm above the inner one and 10 cm further in.
  const auto find_rise_m = [](double angle_deg) {
    const double angle = angle_deg / 180.0 * std::numbers::pi;
    const sim::Vec3 way = {std::sin(angle), 0.0, std::cos(angle)};
    CutPieces pieces =
        cut_pieces({{rectangle("inner", 0.1, 0.3, {0.0, 0.15, 0.3}),
                     turn_panel(rectangle("outer", 0.1, 0.3, 0.2 * way + sim::Vec3(0.0, 0.65, 0.0)), angle)},
                    {}},
                   100);
    pieces.layer_of = {0, 1};
    part_and_draw_in({}, sim::Vec3(0.0), pieces);
    return glm::dot(panel_boxes(pieces)[1].middle(), way) - 0.2;
  };
  EXPECT_NEAR(find_rise_m(0.0), 0.1 + 0.04, 0.01);
  EXPECT_NEAR(find_rise_m(50.0), 0.1 + 0.04, 0.01);
  EXPECT_NEAR(find_rise_m(70.0), 0.0, 0.01) << "they lie beside each other";
}

TEST(Placing, PiecesThatFaceTheSameWayMoveAside) {
  const auto is_moved_aside = [](double angle_rad) {
    const sim::Vec3 at = {0.05, 0.2, 0.5};
    CutPieces pieces = cut_pieces(
        {{rectangle("one", 0.3, 0.3, at), turn_panel(rectangle("other", 0.3, 0.3, at), angle_rad)}, {}}, 100);
    const sim::Extent before = panel_boxes(pieces)[1];
    part_and_draw_in({}, {0.0, 1.0, 0.0}, pieces);
    const sim::Vec3 way = panel_boxes(pieces)[1].middle() - before.middle();
    return glm::length(way) > 0.05 &&
           std::abs(glm::dot(glm::normalize(way), sim::Vec3(std::sin(angle_rad), 0.0, std::cos(angle_rad)))) < 0.7;
  };
  EXPECT_TRUE(is_moved_aside(25.0 / 180.0 * std::numbers::pi));
  EXPECT_FALSE(is_moved_aside(55.0 / 180.0 * std::numbers::pi));
}

TEST(Placing, APieceWithoutABodyIsBowed) {
  CutPieces pieces = cut_pieces({{rectangle("square", 0.3, 0.3, {0.0, 0.15, 0.0})}, {}}, 100);
  part_and_draw_in({}, sim::Vec3(0.0), pieces);
  EXPECT_NEAR(sim::compute_extent(pieces.placed_m).size().z, 0.0021, 0.0005);
}

TEST(Placing, OuterShouldersLieOverInnerOnes) {
  CutPieces inner = cut_pieces({{rectangle("inner", 0.3, 0.3, {0.0, 1.4, 0.1})}, {}}, 100), outer = inner;
  outer.first_seams = {0};
  add_over(outer, inner);
  EXPECT_NEAR(panel_boxes(inner)[1].upper.y - panel_boxes(inner)[0].upper.y, 0.03, 0.01);
}

TEST(Placing, PiecesThatLieFlatMoveUp) {
  const double half = 0.1;
  const std::vector<sim::Vec3> body_m = {{-half, 0.0, -half}, {half, 0.0, -half}, {0.0, 0.0, half}, {0.0, 1.5, 0.0}};
  const std::vector<sim::Triangle> triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const auto find_rise_m = [&](double tilt) {
    PatternPanel panel = rectangle("panel", 0.3, 0.3, {0.0, 1.4, -0.15});
    panel.rotation[1] = {0.0, std::sin(tilt), std::cos(tilt)};
    panel.rotation[2] = {0.0, -std::cos(tilt), std::sin(tilt)};
    panel.translation_m += 0.3 * panel.rotation[1];
    CutPieces pieces = cut_pieces({{panel}, {}}, 100);
    const double before_m = sim::compute_extent(pieces.placed_m).middle().y;
    part_and_draw_in({body_m, triangles}, {0.0, 1.0, 0.0}, pieces);
    return sim::compute_extent(pieces.placed_m).middle().y - before_m;
  };
  EXPECT_GT(find_rise_m(0.07), 0.05);
  EXPECT_LT(find_rise_m(0.15), 0.05) << "it moves aside";
}

TEST_F(Sewing, LegsBeginInTrousersOnly) {
  scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const Wearer& wearer = *dressed_body(bodies).wearer;
  SewingPattern pattern = {
      {rectangle("left", 0.3, 0.9, {0.2, 1.0, 0.1}), rectangle("right", 0.3, 0.9, {-0.2, 1.0, 0.1})}, {}};
  constexpr std::size_t bones_of_arms = 4, bones_of_all = 8;
  EXPECT_EQ(turned_limbs(wearer, cut_pieces(pattern, 300)).size(), bones_of_all);
  const auto count_bones = [&](double offset_m) {
    const SewingPattern wide = {
        {rectangle("left", 0.6, 0.9, {offset_m, 1.0, 0.1}), rectangle("right", 0.6, 0.9, {-offset_m, 1.0, 0.1})}, {}};
    return turned_limbs(wearer, cut_pieces(wide, 300)).size();
  };
  EXPECT_EQ(count_bones(0.12), bones_of_all) << "panels of a leg reach over the middle at the crotch";
  EXPECT_EQ(count_bones(0.06), bones_of_arms) << "panels of a skirt need not lie in the middle";
  pattern.panels.push_back(rectangle("front", 0.6, 0.9, {0.0, 1.0, 0.2}));
  EXPECT_EQ(turned_limbs(wearer, cut_pieces(pattern, 300)).size(), bones_of_arms) << "it is a skirt";
  pattern.panels.back() = rectangle("front", 0.6, 0.87, {0.0, 1.0, 0.2});
  EXPECT_EQ(turned_limbs(wearer, cut_pieces(pattern, 300)).size(), bones_of_arms) << "its hem is not level";
  pattern.panels.back() = rectangle("lining", 0.6, 0.82, {0.0, 1.0, 0.2});
  EXPECT_EQ(turned_limbs(wearer, cut_pieces(pattern, 300)).size(), bones_of_all);
}

TEST_F(Sewing, WhatIsSewnForASceneStaysWhereNobodyElseWrites) {
  const char* const given = std::getenv("TMPDIR");
  const std::optional<std::string> before = given != nullptr ? std::optional<std::string>(given) : std::nullopt;
  Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  std::filesystem::create_directory(folder / "temporary");
  const std::filesystem::path usual = folder / "temporary" / fmt::format("taut-{}", ::getuid());
  std::filesystem::create_directory(usual);
  std::filesystem::permissions(usual, std::filesystem::perms::all);
  ::setenv("TMPDIR", (folder / "temporary").c_str(), 1);
  sew_garment(scene);
  before ? ::setenv("TMPDIR", before->c_str(), 1) : ::unsetenv("TMPDIR");
  const std::filesystem::path made = scene.garment.sewn.parent_path();
  EXPECT_NE(made, usual) << "others may write there";
  EXPECT_EQ(std::filesystem::status(made).permissions(), std::filesystem::perms::owner_all);
  EXPECT_TRUE(std::filesystem::exists(scene.garment.sewn));
}

TEST_F(Sewing, SewsAShirtThatNobodyHereMade) {
  const char* const folder_of_patterns = std::getenv("TAUT_PATTERNS");
  const std::filesystem::path pattern =
      std::filesystem::path(folder_of_patterns != nullptr ? folder_of_patterns : "") / "shirt_mean.json";
  if (!std::filesystem::exists(pattern)) {
    GTEST_SKIP() << "TAUT_PATTERNS names no folder with shirt_mean.json of GarmentCode";
  }
  const Scene scene = scene_with(pattern);
  const SewnGarment garment = sewn(scene, 2000);
  EXPECT_LE(garment.max_stretch, 0.01 + 1e-6);
  EXPECT_EQ(garment.sewn.gap_m, 0.0);
}

}  // namespace
}  // namespace taut::app
