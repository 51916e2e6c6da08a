// Messages about files that no reader accepts.

#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/models/reading/garment_import.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

struct Unreadable : testing::Test {
  std::string error_text(const std::string& name, const std::string& text) const {
    const auto path = folder.write(name, text);
    const std::string error = test::error_message<InputError>([&] { import_garment(path); });
    EXPECT_CONTAINS(error, "cannot read a model from '" + path.string() + "': ");
    return error;
  }

  test::TemporaryFolder folder;
};

constexpr const char* advice = "expected a 3D model";

TEST_F(Unreadable, NamesTheFileThatIsMissing) {
  const std::string error =
      error_text("a.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "cloth.bin"}],
"scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}]})");
  EXPECT_CONTAINS(error, "could not open referenced file \"cloth.bin\"");
  EXPECT_EQ(error.find(advice), std::string::npos);
}

TEST_F(Unreadable, NamesTheCompression) {
  EXPECT_CONTAINS(
      error_text("a.gltf", R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco_mesh_compression"],)"),
      "compressed with Draco in a way that is not read; save it without compression");
  EXPECT_CONTAINS(error_text("b.gltf",
                             R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "extensions":
{"EXT_meshopt_compression": {"fallback": true}}}], "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}]})"),
                  "missing the \"uri\" attribute; its meshes are compressed with EXT_meshopt_compression in a way that "
                  "is not read");
}

TEST_F(Unreadable, SaysWhatIsReadOnlyOfWhatIsNoModel) {
  EXPECT_CONTAINS(error_text("notes.txt", "Buy milk.\n"), advice);
  EXPECT_CONTAINS(error_text("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), advice);
  EXPECT_EQ(error_text("damaged.obj", "v 0 zero 0\nf 1 1 1\n").find(advice), std::string::npos);
}

}  // namespace
}  // namespace taut::app
