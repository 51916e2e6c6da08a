#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <random>

#include "any_arrays.hpp"
#include "app/base/errors.hpp"
#include "app/models/reading/garment_import.hpp"
#include "app/models/reading/import_process.hpp"
#include "app/models/reading/model_arrays.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

/// An importer that misbehaves like one that reads a damaged model.
class ImporterInstead {
 public:
  ImporterInstead(const TemporaryFolder& folder, const std::string& script) {
    const auto path = folder.write("importer", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    ::setenv("TAUT_IMPORTER", path.c_str(), 1);
  }
  ~ImporterInstead() { ::unsetenv("TAUT_IMPORTER"); }
};

std::string error_with(const std::string& script, const ImportLimits& limits = {}) {
  const TemporaryFolder folder;
  const ImporterInstead importer(folder, script);
  const auto model = folder.write("dress.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  return error_message<InputError>([&] { import_garment(model, limits); });
}

TEST(ImportProcess, SurvivesACrash) {
  const std::string error = error_with("kill -SEGV $$");
  EXPECT_CONTAINS(error, "dress.obj': the library that reads models crashed on it (Segmentation fault)");
  EXPECT_CONTAINS(error_with("kill -ABRT $$"), "crashed on it (Aborted)");
  EXPECT_CONTAINS(error_with("exit 3"), "failed on it (exit code 3)");
}

// A terminal sends Ctrl-C to the whole group: a reader that it ended would look like a crash.
TEST(ImportProcess, IsNotInterruptedByATerminal) {
  const TemporaryFolder folder;
  const auto group = folder / "group";
  const ImporterInstead importer(folder, "cut -d ' ' -f 5 /proc/self/stat > '" + group.string() + "'");
  EXPECT_THROW(import_garment(folder.write("dress.obj", "f 1 2 3\n"), {}), InputError);
  std::ifstream stream(group);
  pid_t found = 0;
  ASSERT_TRUE(stream >> found);
  EXPECT_NE(found, ::getpgrp());
}

TEST(ImportProcess, EndsWhatHangs) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_CONTAINS(error_with("exec /bin/sleep 60", {.seconds = 1}), "dress.obj': reading it takes more than 6 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  EXPECT_CONTAINS(error_with("kill -XCPU $$"), "reading it takes more than 8 s");
}

// Twenty programs on two cores leave each a tenth of one.
TEST(ImportProcess, WaitsForWhatGetsLittleOfAProcessor) {
  EXPECT_CONTAINS(error_with("/bin/sleep 2; exit 3", {.seconds = 1}), "failed on it (exit code 3)");
}

TEST(ImportProcess, DoesNotBelieveWhatItIsTold) {
  EXPECT_CONTAINS(error_with("exit 0"), "failed on it");
  EXPECT_CONTAINS(error_with("printf 'Anything at all, longer than a header.'"), "failed on it");
  EXPECT_CONTAINS(error_with("printf 'A\\010\\0\\0\\0\\0\\0\\0\\0\\377\\377\\377\\377\\377\\377\\377\\377'"),
                  "the arrays of a model are incomplete");
  EXPECT_CONTAINS(error_with("printf 'R\\005\\0\\0\\0\\0\\0\\0\\0Moths'"), "dress.obj': Moths");
}

TEST(ImportProcess, NamesAnImporterThatDoesNotStart) {
  const TemporaryFolder folder;
  ::setenv("TAUT_IMPORTER", (folder / "none").c_str(), 1);
  const auto model = folder.write("dress.obj", "v 0 0 0\n");
  EXPECT_CONTAINS(error_message<InputError>([&] { import_garment(model); }), "none' does not start");
  ::unsetenv("TAUT_IMPORTER");
}

TEST(Confinement, IsThatOfAModelsReader) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "here");
  folder.write("blue.mtl", "newmtl blue\nKd 0 0 1\n");
  const auto model = folder.write("dress.obj", "mtllib dress.mtl\nusemtl blue\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::filesystem::create_symlink(model, folder / "here/dress.obj");
  const auto colour = [&] {
    const ModelArrays read = read_model_in_process(folder / "here/dress.obj", {}, ReadParts::model);
    return read.colours.materials.empty() ? glm::vec3(-1) : read.colours.materials[0].base_colour;
  };
  std::filesystem::copy(folder / "blue.mtl", folder / "here/dress.mtl");
  EXPECT_EQ(colour(), glm::vec3(0, 0, 1)) << "a link to a model can be read";
  std::filesystem::remove(folder / "here/dress.mtl");
  std::filesystem::create_symlink(folder / "blue.mtl", folder / "here/dress.mtl");
  EXPECT_NE(colour(), glm::vec3(0, 0, 1)) << "what a model names elsewhere was read";
}

TEST(ImportProcess, KeepsToItsMemory) {
  if (!memory_is_limited) {
    GTEST_SKIP() << "no limit on memory goes with AddressSanitizer";
  }
  const TemporaryFolder folder;
  std::string text;
  for (int v = 0; v < 2'000'000; ++v) {
    text += "v 0 0 0\n";
  }
  const auto model = folder.write("huge.obj", text);
  EXPECT_CONTAINS(error_message<InputError>([&] { import_garment(model, {.memory_mib = 96}); }),
                  "huge.obj': reading it takes more than 96 MiB of memory");
}

ModelArrays some_arrays() {
  ModelArrays model;
  model.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model.faces.corner_counts = {3};
  model.faces.corners = {0, 1, 2};
  model.position_of_vertex = {2, 0, 1};
  model.format = "any";
  model.meshes = 7;
  model.up = ModelAxis::minus_z;
  model.metres_per_unit = 0.01;
  model.colours.corner_uv = {{0, 0}, {0.5F, 0}, {0, 2}};
  model.colours.material_of_face = {0};
  model.colours.materials = {{.name = "silk", .base_colour = {0, 0.5F, 1}, .map = 0}};
  model.colours.maps = {{1, 2, std::make_shared<const std::vector<std::uint8_t>>(8, std::uint8_t{7})}};
  model.colours.remarks = {"no lace"};
  return model;
}

TEST(ModelArrays, AreTheSameAfterwards) {
  const ModelArrays model = some_arrays(), again = decode(encode(model));
  EXPECT_EQ(again.positions, model.positions);
  EXPECT_EQ(again.faces.corner_counts, model.faces.corner_counts);
  EXPECT_EQ(again.faces.corners, model.faces.corners);
  EXPECT_EQ(again.position_of_vertex, model.position_of_vertex);
  EXPECT_EQ(again.format, "any");
  EXPECT_EQ(again.meshes, 7U);
  EXPECT_EQ(again.up, ModelAxis::minus_z);
  EXPECT_EQ(again.metres_per_unit, 0.01);
  EXPECT_EQ(again.colours.corner_uv, model.colours.corner_uv);
  EXPECT_EQ(again.colours.material_of_face, model.colours.material_of_face);
  EXPECT_EQ(again.colours.materials.at(0).base_colour, model.colours.materials[0].base_colour);
  EXPECT_EQ(again.colours.materials.at(0).map, 0U);
  EXPECT_EQ(*again.colours.maps.at(0).rgba, *model.colours.maps[0].rgba);
  EXPECT_EQ(again.colours.remarks, model.colours.remarks);
}

/// A triangle with a joint, a shape and an animation.
ModelArrays some_rigged_arrays() {
  ModelArrays model = some_arrays();
  Rig& rig = model.rig;
  rig.nodes = {{"root", no_node, glm::dmat4(1.0)}, {"joint", 0, glm::dmat4(1.0)}};
  rig.parts = {{0, "mesh", 0, 3, true}};
  rig.in_part = model.positions;
  rig.bones = {{1, glm::dmat4(1.0)}};
  rig.influences = {{0, 0, 1.0}, {2, 0, 1.0}};
  rig.targets = {{0, 0.5, {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}}};
  const RigKeys keys = {{0.0, 1.0}, {{0, 0, 0, 1}, {0, 0, 0, 1}}};
  rig.clips = {{"walk", 1.0, {{1, keys, keys, keys}}, {{0, keys}}, {}}};
  model.faces.sections = {{0, "g sleeve"}, {1, "g collar"}};
  return model;
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(ModelArrays, RefuseWhatNoModelHas) {
  const auto refuses = [](const char* what, const auto& change) {
    ModelArrays model = some_rigged_arrays();
    EXPECT_NO_THROW(decode(encode(model)));
    change(model);
    EXPECT_THROW(decode(encode(model)), std::runtime_error) << what;
  };
  refuses("an axis below the first", [](auto& m) { m.up = static_cast<ModelAxis>(-1); });
  refuses("an axis far below the first", [](auto& m) { m.up = static_cast<ModelAxis>(-100'000'000); });
  refuses("an image whose size needs more than 64 bits", [](auto& m) {
    m.colours.maps = {{1U << 31U, 1U << 31U, std::make_shared<const std::vector<std::uint8_t>>()}};
  });
  refuses("an image that is wider than any", [](auto& m) {
    m.colours.maps = {{8193, 1, std::make_shared<const std::vector<std::uint8_t>>(4 * 8193, std::uint8_t{0})}};
  });
  refuses("a unit without end", [](auto& m) { m.metres_per_unit = infinite; });
  refuses("a position that is no number", [](auto& m) { m.positions[1].y = no_number; });
  refuses("a position beyond all bounds", [](auto& m) { m.positions[1].y = 1e300; });
  refuses("a corner beyond the positions", [](auto& m) { m.faces.corners[0] = 3; });
  refuses("fewer corners than faces have", [](auto& m) { m.faces.corner_counts = {4}; });
  refuses("a face of two corners", [](auto& m) {
    m.faces.corner_counts = {3, 2};
    m.faces.corners = {0, 1, 2, 0, 1};
    m.colours = {};
  });
  refuses("corners whose sum overflows", [](auto& m) {
    m.faces.corner_counts.assign(2, 0x80000000U);
    m.faces.corners.clear();
    m.colours = {};
  });
  refuses("a vertex that has no position of its own", [](auto& m) { m.position_of_vertex = {0, 1, 1}; });
  refuses("fewer vertices than positions", [](auto& m) { m.position_of_vertex.pop_back(); });
  refuses("a section behind the faces", [](auto& m) { m.faces.sections[1].first_face = 2; });
  refuses("sections that go back",
          [](auto& m) { m.faces.sections[0].first_face = 1, m.faces.sections[1].first_face = 0; });
  refuses("a section of two lines", [](auto& m) { m.faces.sections[0].line = "g a\nv 1 2 3"; });
  refuses("a name without end", [](auto& m) { m.rig.nodes[0].name.assign((1U << 20U) + 1, 'a'); });
  refuses("a transform that is no number", [](auto& m) { m.rig.nodes[1].to_parent[3][0] = no_number; });
  refuses("a joint's frame that is no number", [](auto& m) { m.rig.bones[0].from_mesh[0][0] = infinite; });
  refuses("a weight that is no number", [](auto& m) { m.rig.influences[1].weight = no_number; });
  refuses("a joint of what follows none", [](auto& m) { m.rig.parts[0].is_skinned = false; });
  refuses("a shape's weight that is no number", [](auto& m) { m.rig.targets[0].weight = no_number; });
  refuses("a shape that is no number", [](auto& m) { m.rig.targets[0].offsets[2].x = no_number; });
  refuses("a part that is no number", [](auto& m) { m.rig.in_part[2].x = no_number; });
  refuses("a time that is no number", [](auto& m) { m.rig.clips[0].channels[0].scales.times_s[0] = no_number; });
  refuses("a key that is no number", [](auto& m) { m.rig.clips[0].targets[0].weights.values[0].x = no_number; });
  refuses("an animation without end", [](auto& m) { m.rig.clips[0].duration_s = 1e300; });
}

TEST(ModelArrays, TakeNoMoreMemoryThanTheirBytes) {
  // A list of 4 000 000 000 empty names would take 128 GB. A list as long as the bytes allow takes eight times
  // their memory.
  std::string bytes = encode({});
  ModelArrays two_remarks;
  two_remarks.colours.remarks = {"", ""};
  const std::string none = encode(two_remarks);
  std::size_t count_at = 0;
  while (bytes[count_at] == none[count_at]) ++count_at;
  const std::uint64_t count = 5'000'000;
  std::memcpy(bytes.data() + count_at, &count, sizeof(count));
  bytes.insert(count_at + sizeof(count), count * sizeof(std::uint64_t), '\0');
  EXPECT_CONTAINS(error_message<std::runtime_error>([&] { decode(bytes); }), "too many names");
}

// Random bytes for two seconds; tests/fuzz/fuzz_arrays.cpp searches further.
TEST(ModelArrays, CanBeUsedWhereTheyAreTaken) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  int all = 0, taken = 0;
  for (unsigned seed = 1; seed <= 20'000 && std::chrono::steady_clock::now() < end; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(2000);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    ++all;
    taken += test::are_taken_and_used(bytes) ? 1 : 0;
  }
  RecordProperty("taken", taken);
  EXPECT_GT(taken, all / 100);
  EXPECT_LT(taken, all);
}

TEST(ModelArrays, MendColours) {
  ModelArrays model = some_arrays();
  model.colours.corner_uv[1] = {std::numeric_limits<float>::quiet_NaN(), 3e38F};
  model.colours.materials[0].base_colour = {std::numeric_limits<float>::quiet_NaN(), -1, 7};
  const ModelArrays again = decode(encode(model));
  EXPECT_EQ(again.colours.corner_uv[1], glm::vec2(0));
  EXPECT_EQ(again.colours.materials[0].base_colour, glm::vec3(0, 0, 1));
}

TEST(ImportProcess, SaysNothingRawOfAFile) {
  EXPECT_CONTAINS(error_with("printf 'R\\010\\0\\0\\0\\0\\0\\0\\0Mo\\033[31m\\n'"), "dress.obj': Mo\\x1b[31m");
}

TEST(ModelArrays, RefuseEveryPrefixAndAnythingBehind) {
  const std::string bytes = encode(some_arrays());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(decode(bytes.substr(0, length)), std::runtime_error) << length;
  }
  EXPECT_THROW(decode(bytes + '\0'), std::runtime_error);
  ModelArrays no_axis = some_arrays();
  no_axis.up = static_cast<ModelAxis>(6);
  EXPECT_THROW(decode(encode(no_axis)), std::runtime_error);
  ModelArrays beyond = some_arrays();
  beyond.position_of_vertex.back() = 3;
  EXPECT_THROW(decode(encode(beyond)), std::runtime_error);
  const auto refuses = [](const auto& change) {
    ModelArrays model = some_arrays();
    change(model.colours);
    EXPECT_THROW(decode(encode(model)), std::runtime_error);
  };
  refuses([](SurfaceColours& colours) { colours.corner_uv.pop_back(); });
  refuses([](SurfaceColours& colours) { colours.material_of_face = {1}; });
  refuses([](SurfaceColours& colours) { colours.material_of_face = {0, 0}; });
  refuses([](SurfaceColours& colours) { colours.materials[0].map = 1; });
  refuses([](SurfaceColours& colours) { colours.maps[0].width_px = 2; });
}

}  // namespace
}  // namespace taut::app
