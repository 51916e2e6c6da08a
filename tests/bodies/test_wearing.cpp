// Garments that do not surround the body at first and are put on it.

#include <algorithm>
#include <glm/geometric.hpp>

#include "../models/garment_shapes.hpp"
#include "app/garments/dressing/fit.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/models/hanging/garment_measures.hpp"
#include "app/models/inspecting/scene_crossings.hpp"
#include "app/models/reading/file_mesh.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "loading.hpp"

namespace taut::app {
namespace {

const std::filesystem::path assets = TAUT_ASSETS_FOLDER;

/// A garment, the body that wears it, and the messages.
struct Fitting {
  Scene scene;
  LoadedBodies bodies;
  LoadedGarment loaded;
  std::vector<std::string> said;

  const std::vector<sim::Vec3>& places_m() const { return loaded.garment->mesh.positions; }
  std::size_t crossings(double time_s) const {
    const sim::Surface cloth = {places_m(), loaded.garment->mesh.triangles};
    return scene_crossings(cloth, bodies.all, time_s).back().pairs.size();
  }
  std::vector<FitRow> fit() const { return compute_fit(bodies, *loaded.garment, places_m()); }
};

struct Wearing : testing::Test {
  Fitting put(const std::filesystem::path& garment, const std::string& mannequin, double scale = 1.0) {
    Fitting fitting;
    Scene& scene = fitting.scene;
    scene.garment.file = garment;
    scene.garment.scale = scale;
    scene.garment.up = ModelAxis::y;
    scene.garment.mesh = mesh_choice;
    source.file = assets / "bodies" / ("mannequin_" + mannequin + ".glb");
    source.dress = 90;
    scene.bodies.push_back({.body = {.name = mannequin, .shape = sim::BodyMesh{}, .motion = motion}, .source = source});
    fitting.bodies = load_bodies(scene);
    fitting.loaded = load_garment(scene);
    fitting.said = put_on(fitting.loaded, scene, fitting.bodies);
    return fitting;
  }

  /// Writes the T-shirt, moved by `go`, as a file without landmarks.
  std::filesystem::path shirt(const std::function<sim::Vec3(const sim::Vec3&)>& go) const {
    Scene scene;
    scene.garment.file = assets / "garments/tshirt_1028.obj";
    sim::Mesh mesh = load_garment(scene).garment->mesh;
    std::transform(mesh.positions.begin(), mesh.positions.end(), mesh.positions.begin(), go);
    return written(mesh);
  }
  std::filesystem::path written(const sim::Mesh& mesh) const {
    return folder.write("garment.obj", obj_text(mesh, mesh.positions));
  }

  /// Rotates the body by this angle about its vertical axis.
  void turn(double degrees) { motion.spin = {.turns_per_s = degrees / 360.0, .from_s = -9.0, .until_s = -8.0}; }
  /// Returns the message when the skirt, which is wider than deep, is put on a body that is rotated by this angle.
  std::string said_of_skirt(const sim::Vec3& at_m, double degrees) {
    sim::Mesh mesh = test::translate(test::skirt(), at_m);
    for (sim::Vec3& p : mesh.positions) {
      p.x += 0.2 * (p.x - at_m.x);
    }
    turn(degrees);
    const Fitting worn = put(written(mesh), "female_34");
    return worn.said.empty() ? "" : worn.said[0];
  }

  const std::filesystem::path tshirt = assets / "garments/tshirt_1028.obj";
  test::TemporaryFolder folder;
  BodySource source;
  sim::RigidMotion motion;
  MeshChoice mesh_choice = MeshChoice::automatic;
};

TEST_F(Wearing, WhatLiesAboutTheBodyStays) {
  const Fitting worn = put(tshirt, "male_40");
  EXPECT_TRUE(worn.said.empty());
  Scene alone;
  alone.garment.file = tshirt;
  EXPECT_EQ(worn.places_m(), load_garment(alone).garment->mesh.positions);
  EXPECT_TRUE(worn.loaded.pins.empty()) << "it is worn and hangs from nothing";
}

TEST_F(Wearing, AGarmentComesToTheBodyFromAnywhere) {
  const Fitting from_far = put(shirt([](const sim::Vec3& p) { return p + sim::Vec3(3.0, -1.0, 0.5); }), "male_40");
  ASSERT_EQ(from_far.said.size(), 1U);
  EXPECT_CONTAINS(from_far.said[0], "it is moved by 3.2 m, so that its neck is at that of the body 'male_40'");
  EXPECT_EQ(from_far.crossings(-1.5), 0U);
  const GarmentMarks marks = find_garment_marks(*from_far.loaded.garment, from_far.places_m(), {});
  EXPECT_NEAR(marks.top->upper.y, 1.64, 1e-6) << "as high as the joint of the neck";
  const Fitting turned = put(shirt([](const sim::Vec3& p) { return sim::Vec3(-p.x, p.y, -p.z); }), "male_40");
  EXPECT_CONTAINS(turned.said.at(0), "turned about the vertical");
  const Fitting quarter = put(shirt([](const sim::Vec3& p) { return sim::Vec3(p.z, p.y, -p.x); }), "male_40");
  for (std::size_t v = 0; v < turned.places_m().size(); ++v) {
    EXPECT_LT(glm::distance(turned.places_m()[v], from_far.places_m()[v]), 1e-6) << v;
    EXPECT_LT(glm::distance(quarter.places_m()[v], from_far.places_m()[v]), 1e-6) << v;
  }
}

TEST_F(Wearing, AShirtOfAManIsWornByAWoman) {
  Fitting worn = put(tshirt, "female_34");
  EXPECT_CONTAINS(worn.said.at(0), "it is moved by 0.24");
  EXPECT_EQ(worn.crossings(-1.5), 0U);
  EXPECT_GT(worn.crossings(0.0), 0U) << "the body has still to grow into it";
  sim::Simulation simulation = make_simulation(worn.scene, worn.loaded, worn.bodies.all);
  EXPECT_EQ(go_to_start(worn.scene, worn.bodies, simulation), 0);
  const sim::Surface cloth = {simulation.state().current, simulation.garment().mesh.triangles};
  EXPECT_TRUE(scene_crossings(cloth, worn.bodies.all, 0.0).back().pairs.empty());
}

TEST_F(Wearing, WhatTheShouldersCrossBeginsAboveThem) {
  const Fitting worn = put(shirt([](const sim::Vec3& p) {
                             const double beside_m = std::clamp(std::abs(p.x) - 0.1, 0.0, 0.1);
                             return p - sim::Vec3(0.0, 1.5 * beside_m, 0.0);
                           }),
                           "female_34");
  ASSERT_GE(worn.said.size(), 2U);
  EXPECT_CONTAINS(worn.said[1], " cm above that");
  EXPECT_EQ(worn.crossings(-1.5), 0U);
}

// A scan has no joints.
TEST_F(Wearing, ABodyWithoutJointsGrowsFromThoseOfItsShape) {
  const Fitting person = put(tshirt, "female_34");
  const auto& mesh = *std::get<sim::BodyMesh>(person.bodies.all[0].shape).data;
  Scene scene;
  scene.garment.file = tshirt;
  BodySource scan;
  scan.file = folder.write("scan.obj", obj_text({mesh.positions_m, mesh.triangles, {}}, mesh.positions_m));
  scan.dress = 90;
  scene.bodies.push_back({.body = {.name = "scan", .shape = sim::BodyMesh{}}, .source = scan});
  LoadedBodies bodies = load_bodies(scene);
  ASSERT_FALSE(bodies.remarks.empty());
  EXPECT_CONTAINS(bodies.remarks[0], "those that it grows from are guessed from its shape");
  LoadedGarment loaded = load_garment(scene);
  put_on(loaded, scene, bodies);
  const JointPlaces found = compute_joint_positions(*bodies.wearers[0]->rig, bodies.wearers[0]->pose, {});
  const Wearer& known = *person.bodies.wearers[0];
  const JointPlaces there = compute_joint_positions(*known.rig, known.pose, known.places.placement);
  for (const char* joint : {"neck", "left arm", "right arm"}) {
    EXPECT_LT(glm::distance(found.at(joint), there.at(joint)), 0.06) << joint;
  }
  sim::Simulation simulation = make_simulation(scene, loaded, bodies.all);
  EXPECT_EQ(go_to_start(scene, bodies, simulation), 0) << "nothing crosses";
}

TEST_F(Wearing, ABodyIsLedFromWhereTheGarmentLiesToItsMotion) {
  source.motion = assets / "motions/raise_arms.bvh";
  source.start_s = 1.5;
  const Fitting worn = put(tshirt, "male_40");
  ASSERT_EQ(worn.said.size(), 1U);
  EXPECT_CONTAINS(worn.said[0], "is led to the first frame of its motion");
  EXPECT_EQ(worn.crossings(-1.5), 0U);
  EXPECT_NEAR(sim::compute_extent(worn.places_m()).lower.y, 1.0, 0.2) << "it is not moved";
}

TEST_F(Wearing, ArmsBeginInTheSleeves) {
  source.motion = assets / "motions/raise_arms.bvh";
  source.start_s = 1.5;
  Fitting worn = put(shirt([](const sim::Vec3& p) { return p + sim::Vec3(3.0, -1.0, 0.5); }), "male_40");
  ASSERT_EQ(worn.said.size(), 2U);
  EXPECT_EQ(worn.said[1], "the arms begin in its sleeves");
  EXPECT_EQ(worn.crossings(-1.5), 0U);
  const auto& mesh = std::get<sim::BodyMesh>(worn.bodies.all[0].shape);
  std::vector<sim::Vec3> grown_m(mesh.data->positions_m.size());
  mesh.frames->positions_in(90, grown_m);
  std::vector<sim::Vec3> expected_m(grown_m.size());
  worn.bodies.wearers[0]->frames->positions_in(90, expected_m);
  EXPECT_EQ(grown_m, expected_m) << "they end where the motion begins";
}

TEST_F(Wearing, WhatIsTooSmallByItsGirthsIsRefusedBeforeTheFirstFrame) {
  Fitting worn = put(tshirt, "male_40", 0.8);
  sim::Simulation simulation = make_simulation(worn.scene, worn.loaded, worn.bodies.all);
  const std::string error = test::error_message<InputError>([&] { go_to_start(worn.scene, worn.bodies, simulation); });
  EXPECT_CONTAINS(error, "the garment cannot be put on: found ");
  EXPECT_CONTAINS(error, "chest 102.6 cm in a garment of ");
  EXPECT_CONTAINS(error, "stretched by at most solver.max_stretch = ");
}

TEST_F(Wearing, WhatIsTooSmallSaysWhere) {
  Fitting worn = put(tshirt, "male_40", 0.93);
  worn.scene.simulation.solver.max_substeps = 40;  // the run gives up sooner
  sim::Simulation simulation = make_simulation(worn.scene, worn.loaded, worn.bodies.all);
  const std::string error =
      test::error_message<PromiseBroken>([&] { go_to_start(worn.scene, worn.bodies, simulation); });
  EXPECT_CONTAINS(error, "while it is dressed, in frame ");
  EXPECT_CONTAINS(error, "; it does not fit: ");
  EXPECT_CONTAINS(error, "upper chest 111.9 cm in a garment of 109.8 cm");
}

TEST(RequireWearable, CountsTheStretchThatClothMayHave) {
  Scene scene;
  scene.simulation.solver.bounded.max_stretch = 0.2;
  FitRow row{"chest", 1.0, 0.9};
  row.body_at_height_m = 1.0;
  EXPECT_NO_THROW(require_wearable(scene, std::array{row}));
  scene.simulation.solver.bounded.max_stretch = 0.01;
  row.garment_m = 0.7;
  EXPECT_THROW(require_wearable(scene, std::array{row}), InputError);
}

TEST_F(Wearing, EaseIsWhatTheClothIsLarger) {
  const std::vector<FitRow> rows = put(tshirt, "male_40").fit();
  std::map<std::string, FitRow> by_name;
  for (const FitRow& row : rows) {
    by_name.emplace(row.name, row);
  }
  ASSERT_EQ(rows.size(), 7U) << "it does not reach to the seat";
  EXPECT_NEAR(by_name["chest"].body_m, 1.026, 0.002);
  EXPECT_NEAR(by_name["chest"].garment_m, 1.12, 0.005);
  EXPECT_STREQ(fit_word(by_name["chest"]), "fitted");
  EXPECT_NEAR(by_name["hem"].garment_m, 1.043, 0.002) << "as the pattern has it";
  EXPECT_NEAR(by_name["neck"].garment_m, 0.639, 0.01) << "likewise";
  EXPECT_NEAR(by_name["armhole"].garment_m, 0.56, 0.04) << "likewise";
  EXPECT_GT(by_name["upper arm"].garment_m, by_name["upper arm"].body_m);
  EXPECT_CONTAINS(describe(rows), "chest           102.6 cm    111.");
  EXPECT_EQ(describe_misfit(rows), "");
  EXPECT_STREQ(fit_word({"shoulder width", 0.4, 0.39}), "fitted");
  EXPECT_STREQ(fit_word({"shoulder width", 0.4, 0.37}), "narrow");
  EXPECT_STREQ(fit_word({"shoulder width", 0.4, 0.44}), "wide");
  EXPECT_STREQ(fit_word({"chest", 1.0, 0.99}), "too small");
  EXPECT_STREQ(fit_word({"chest", 1.0, 1.01}), "tight");
  EXPECT_STREQ(fit_word({"chest", 1.0, 1.03}), "tight");
  EXPECT_STREQ(fit_word({"chest", 1.0, 1.05}), "fitted");
  EXPECT_STREQ(fit_word({"chest", 1.0, 1.13}), "loose");
}

TEST_F(Wearing, ASkirtComesToTheWaist) {
  const Fitting worn = put(written(test::skirt()), "female_34");
  EXPECT_CONTAINS(worn.said.at(0), "so that its waist is at that of the body");
  const GarmentMarks marks = find_garment_marks(*worn.loaded.garment, worn.places_m(), {});
  EXPECT_TRUE(marks.is_worn_at_waist);
  EXPECT_NEAR(marks.top_height_m, find_girth(worn.bodies.wearers[0]->measures, "waist")->height_m, 1e-6);
  const std::vector<FitRow> rows = worn.fit();
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front().name, "waist") << "it does not reach to the chest";
}

TEST_F(Wearing, WhatIsNearAndFacesAsTheBodyDoesStays) {
  const Fitting worn = put(written(test::skirt()), "female_34");
  const double low_m = sim::compute_extent(worn.places_m()).lower.y;
  const sim::Vec3 there_m = {0.0, low_m, worn.bodies.wearers[0]->measures.waist_m->z};
  EXPECT_EQ(said_of_skirt(there_m + sim::Vec3(0.04, 0.0, 0.0), 0.0), "");
  EXPECT_CONTAINS(said_of_skirt(there_m + sim::Vec3(0.06, 0.0, 0.0), 0.0), "it is moved by 0.06 m");
  EXPECT_EQ(said_of_skirt(there_m, 40.0), "");
  EXPECT_CONTAINS(said_of_skirt(there_m, 50.0), "turned about the vertical");
}

TEST_F(Wearing, WhatIsMovedTurnsAsTheBodyIsTurned) {
  const std::string turned = "turned about the vertical";
  EXPECT_EQ(said_of_skirt({3.0, 0.0, 0.0}, 9.0).find(turned), std::string::npos);
  EXPECT_CONTAINS(said_of_skirt({3.0, 0.0, 0.0}, 14.0), turned);
}

TEST_F(Wearing, AWaistAtTheEdgeOfAGarmentCounts) {
  const Fitting worn = put(written(test::skirt()), "female_34");
  const auto first_row = [&](double lower_m) {
    std::vector<sim::Vec3> places_m = worn.places_m();
    for (sim::Vec3& p : places_m) {
      p.y -= lower_m;
    }
    return compute_fit(worn.bodies, *worn.loaded.garment, places_m).at(0).name;
  };
  EXPECT_EQ(first_row(0.015), "waist");
  EXPECT_EQ(first_row(0.025), "seat");
}

TEST_F(Wearing, WhatHasNoOpeningStaysAndSaysSo) {
  const Fitting worn = put(written(test::translate(test::cape(), {3.0, 0.0, 0.0})), "female_34");
  ASSERT_EQ(worn.said.size(), 1U);
  EXPECT_CONTAINS(worn.said[0], "it stays where it is: no neck opening and no waist was found on it");
  for (const FitRow& row : worn.fit()) EXPECT_GT(row.garment_m, 0.0) << row.name;
}

TEST_F(Wearing, TrousersComeForkToForkAndAreMeasuredRoundBothLegs) {
  sim::Mesh mesh = test::translate(test::trousers(), {3.0, 0.0, 0.0});
  const Fitting worn = put(written(mesh), "female_34");
  const BodyMeasures& measures = worn.bodies.wearers[0]->measures;
  const auto tube = find_tube({worn.places_m(), worn.loaded.garment->mesh.triangles});
  ASSERT_TRUE(tube && tube->fork_m);
  EXPECT_NEAR(*tube->fork_m, measures.levels[measures.fork].height_m - 0.01, 0.005);
  const sim::Extent box = sim::compute_extent(worn.places_m());
  const double leg_m = leg_at({worn.places_m(), worn.loaded.garment->mesh.triangles}, box.lower.y + 0.05).value();
  EXPECT_GT(girth_at({worn.places_m(), worn.loaded.garment->mesh.triangles}, box.lower.y + 0.05).value(), 1.2 * leg_m);
  const std::vector<FitRow> rows = worn.fit();
  const auto waistband = std::ranges::find(rows, "waistband", &FitRow::name);
  ASSERT_NE(waistband, rows.end()) << describe(rows);
  EXPECT_EQ(waistband->garment_m, find_garment_marks(*worn.loaded.garment, worn.places_m(), {}).top_m);
  EXPECT_NEAR(waistband->body_m, measures.level_at(box.upper.y).girth_m, 0.02);
}

TEST_F(Wearing, AModelThatFollowsComesAlong) {
  mesh_choice = MeshChoice::fitted;
  const Fitting worn = put(shirt([](const sim::Vec3& p) { return p + sim::Vec3(3.0, 0.0, 0.0); }), "male_40");
  ASSERT_TRUE(worn.loaded.following);
  const sim::Vec3 simulated_m = sim::compute_extent(worn.places_m()).middle();
  EXPECT_LT(std::abs(simulated_m.x), 0.1);
  EXPECT_LT(glm::distance(sim::compute_extent(worn.loaded.following->mesh.positions).middle(), simulated_m), 0.02);
}

TEST_F(Wearing, SaysWhereClothIsStretchedMost) {
  const Fitting worn = put(tshirt, "male_40");
  const std::vector<FitRow> rows = worn.fit();
  std::vector<sim::Vec3> wide_m = worn.places_m();
  EXPECT_EQ(describe_tightness(worn.bodies, *worn.loaded.garment, wide_m, rows), "");
  for (sim::Vec3& p : wide_m) {
    p.z *= p.y < 1.25 && p.z > 0.0 ? 1.2 : 1.0;  // widens the waist in front
  }
  EXPECT_CONTAINS(describe_tightness(worn.bodies, *worn.loaded.garment, wide_m, rows), "stretched most: at the ");
}

TEST_F(Wearing, NamesThreeTightPlacesThatStretchByHalfAPercent) {
  const Fitting worn = put(tshirt, "male_40");
  const std::vector<FitRow> rows = worn.fit();
  const auto widened = [&](double factor) {
    std::vector<sim::Vec3> wide_m = worn.places_m();
    for (sim::Vec3& p : wide_m) p *= sim::Vec3(factor, 1.0, factor);
    return describe_tightness(worn.bodies, *worn.loaded.garment, wide_m, rows);
  };
  EXPECT_EQ(std::ranges::count(widened(1.2), '%'), 3) << widened(1.2);
  EXPECT_EQ(widened(1.004), "");
  EXPECT_CONTAINS(widened(1.008), "stretched most: ");
}

TEST_F(Wearing, NamesTheStretchOfATenthOfTheTrianglesNearAGirth) {
  const Fitting worn = put(assets / "garments/tshirt_5280.obj", "male_40");
  const std::vector<FitRow> rows = worn.fit();
  const double waist_m = *std::ranges::find(rows, "waist", &FitRow::name)->height_m;
  // Lengthens a strip in front by a fifth, between two heights over the waist.
  const auto lengthened = [&](double from_m, double to_m, double half_width_m) {
    std::vector<sim::Vec3> long_m = worn.places_m();
    for (sim::Vec3& p : long_m) {
      if (p.z > 0.05 && std::abs(p.x) < half_width_m)
        p.y += 0.2 * std::clamp(p.y - waist_m - from_m, 0.0, to_m - from_m);
    }
    return describe_tightness(worn.bodies, *worn.loaded.garment, long_m, rows);
  };
  EXPECT_CONTAINS(lengthened(0.02, 0.04, 1.0), "at the waist in front");
  EXPECT_EQ(lengthened(0.055, 0.075, 1.0).find("waist"), std::string::npos) << "it is above the waist";
  const std::string strip = lengthened(-0.05, 0.05, 0.03);
  const std::size_t percent = strip.find("at the waist in front ") + std::string("at the waist in front ").size();
  ASSERT_LT(percent, strip.size()) << strip;
  EXPECT_NEAR(std::stod(strip.substr(percent)), 18.5, 1.0) << strip;
}

TEST_F(Wearing, NamesTheSideOfTheWearerThatIsStretchedMost) {
  const Fitting worn = put(tshirt, "male_40");
  const std::vector<FitRow> rows = worn.fit();
  const auto widened = [&](double side) {
    std::vector<sim::Vec3> wide_m = worn.places_m();
    for (sim::Vec3& p : wide_m) p.z *= p.y < 1.25 && side * p.x > 0.12 ? 1.2 : 1.0;
    return describe_tightness(worn.bodies, *worn.loaded.garment, wide_m, rows);
  };
  EXPECT_CONTAINS(widened(1.0), "on the left");
  EXPECT_CONTAINS(widened(-1.0), "on the right");
}

TEST_F(Wearing, WhatIsNotStretchedMeasuresWornAsAtRest) {
  const Fitting worn = put(tshirt, "male_40");
  std::vector<FitRow> rows = worn.fit();
  measure_worn(*worn.loaded.garment, worn.places_m(), rows);
  EXPECT_EQ(std::ranges::count_if(rows, [](const FitRow& row) { return row.worn_m.has_value(); }), 3);
  for (const FitRow& row : rows) EXPECT_NEAR(row.worn_m.value_or(row.garment_m), row.garment_m, 1e-9) << row.name;
  EXPECT_CONTAINS(describe_worn(rows), "chest 111.");
  EXPECT_CONTAINS(describe_worn(rows), " cm (+0.0 %)");
}

TEST_F(Wearing, WhatLiesTooHighComesDown) {
  const Fitting worn = put(written(test::skirt()), "female_34");
  const double low_m = sim::compute_extent(worn.places_m()).lower.y;
  const sim::Vec3 there_m = {0.0, low_m, worn.bodies.wearers[0]->measures.waist_m->z};
  EXPECT_EQ(said_of_skirt(there_m + sim::Vec3(0.0, 0.04, 0.0), 0.0), "");
  EXPECT_CONTAINS(said_of_skirt(there_m + sim::Vec3(0.0, 0.06, 0.0), 0.0), "it is moved by 0.06 m");
  EXPECT_EQ(said_of_skirt(there_m - sim::Vec3(0.0, 0.1, 0.0), 0.0), "") << "clothes may be worn lower";
  EXPECT_CONTAINS(said_of_skirt(there_m - sim::Vec3(0.0, 0.2, 0.0), 0.0), "it is moved by 0.2 m");
}

}  // namespace
}  // namespace taut::app
