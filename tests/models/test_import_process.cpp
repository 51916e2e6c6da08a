#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>

#include "app/base/errors.hpp"
#include "app/models/garment_import.hpp"
#include "app/models/import_process.hpp"
#include "app/models/model_arrays.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::message_of;
using test::TemporaryFolder;

/// An importer that misbehaves as a damaged model can make one misbehave.
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
  return message_of<InputError>([&] { import_garment(model, limits); });
}

TEST(ImportProcess, SurvivesACrash) {
  const std::string error = error_with("kill -SEGV $$");
  EXPECT_CONTAINS(error, "dress.obj': the library that reads models crashed on it (Segmentation fault)");
  EXPECT_CONTAINS(error_with("kill -ABRT $$"), "crashed on it (Aborted)");
  EXPECT_CONTAINS(error_with("exit 3"), "failed on it (exit code 3)");
}

TEST(ImportProcess, EndsWhatHangs) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_CONTAINS(error_with("exec /bin/sleep 60", {.seconds = 1}), "dress.obj': reading it takes more than 1 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_CONTAINS(error_with("kill -XCPU $$"), "reading it takes more than 18 s");
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
  EXPECT_CONTAINS(message_of<InputError>([&] { import_garment(model); }), "none' does not start");
  ::unsetenv("TAUT_IMPORTER");
}

/// Whether something is true in a process that is confined to a folder.
template <class Question> bool holds_in(const TemporaryFolder& folder, const Question& question) {
  const pid_t child = ::fork();
  if (child == 0) {
    const bool is_confined = confine_to(std::vector<std::filesystem::path>{folder / ""});
    ::_exit(question(is_confined) ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

constexpr const char* not_confined = "this kernel has no Landlock (Linux 5.13), which keeps files from a process";

TEST(Confinement, LeavesAFolderToReadAndNothingElse) {
  const TemporaryFolder folder;
  const auto inside = folder.write("shirt.obj", "v 0 0 0\n");
  const auto opens = [](const std::filesystem::path& path, int flags) {
    return [path, flags](bool) { return ::open(path.c_str(), flags, 0600) >= 0; };
  };
  EXPECT_TRUE(holds_in(folder, opens(inside, O_RDONLY)));
  EXPECT_FALSE(holds_in(folder, [](bool) { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0; }));
  EXPECT_FALSE(holds_in(folder, [](bool) { return ::socket(AF_UNIX, SOCK_DGRAM, 0) >= 0; }));
  EXPECT_TRUE(holds_in(folder, [](bool) { return ::execl("/bin/false", "false", nullptr) == -1; }));
  if (!holds_in(folder, [](bool is_confined) { return is_confined; })) {
    GTEST_SKIP() << not_confined;
  }
  EXPECT_FALSE(holds_in(folder, opens("/etc/passwd", O_RDONLY)));
  EXPECT_FALSE(holds_in(folder, opens(inside, O_RDWR)));
  EXPECT_FALSE(holds_in(folder, opens(folder / "new", O_WRONLY | O_CREAT)));
  EXPECT_FALSE(holds_in(folder, [&](bool) { return ::unlink(inside.c_str()) == 0; }));
}

TEST(Confinement, IsThatOfAModelsReader) {
  const TemporaryFolder folder;
  if (!holds_in(folder, [](bool is_confined) { return is_confined; })) {
    GTEST_SKIP() << not_confined;
  }
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
  EXPECT_CONTAINS(message_of<InputError>([&] { import_garment(model, {.memory_mib = 96}); }),
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
