#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "app/base/errors.hpp"
#include "app/drawing/garment_colours.hpp"
#include "app/models/reading/file_mesh.hpp"
#include "app/models/reading/garment_import.hpp"
#include "app/models/reading/import_process.hpp"
#include "app/models/reading/model_arrays.hpp"
#include "app/scene/scene_format.hpp"
#include "renderer/page/png.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

// A scene in metres with y up. Nothing is guessed, so positions stay the same as in the file.
DrawnScene make_scene(const std::filesystem::path& file) {
  DrawnScene scene;
  scene.garment.file = file;
  scene.garment.scale = 1.0;
  scene.garment.up = ModelAxis::y;
  return scene;
}

std::string encode_png(int width_px, int height_px, const std::array<std::uint8_t, 4>& rgba) {
  renderer::Image image = renderer::make_image(width_px, height_px, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = rgba[i % 4];
  }
  const std::vector<std::uint8_t> bytes = renderer::encode_png(image);
  return {bytes.begin(), bytes.end()};
}

std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = (three << 8U) | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[(three >> (18 - 6 * k)) & 63U] : '=';
    }
  }
  return text;
}

// A cross of six squares, folded to a cube. Each corner of the cube has up to three places in the picture.
const std::string cube_text =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "vt 0.25 0\nvt 0.5 0\nvt 0 0.25\nvt 0.25 0.25\nvt 0.5 0.25\nvt 0.75 0.25\nvt 1 0.25\n"
    "vt 0 0.5\nvt 0.25 0.5\nvt 0.5 0.5\nvt 0.75 0.5\nvt 1 0.5\nvt 0.25 0.75\nvt 0.5 0.75\n"
    "f 5/4 6/5 7/10 8/9\nf 6/5 2/6 3/11 7/10\nf 2/6 1/7 4/12 3/11\nf 1/3 5/4 8/9 4/8\n"
    "f 8/9 7/10 3/14 4/13\nf 1/1 2/2 6/5 5/4\n";

using Corner = std::tuple<double, double, double, float, float>;

/// Corners of every triangle with their texture coordinates, in any order.
std::multiset<std::set<Corner>> list_corners(const LoadedGarment& loaded) {
  std::multiset<std::set<Corner>> all;
  const sim::Mesh& mesh = loaded.garment->mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::set<Corner> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const sim::Vec3& p = mesh.positions[mesh.triangles[t][k]];
      const glm::vec2& uv = loaded.colours.corner_uv.at(3 * t + k);
      corners.emplace(p.x, p.y, p.z, uv.x, uv.y);
    }
    all.insert(corners);
  }
  return all;
}

TEST(SurfaceColours, ACubeHasTheSameCornersAfterItIsWrittenAndRead) {
  const TemporaryFolder folder;
  const LoadedGarment cube = load_garment(make_scene(folder.write("cube.obj", cube_text)));
  const auto corners = list_corners(cube);
  EXPECT_EQ(corners.size(), 12U);
  EXPECT_TRUE(corners.contains({{0, 0, 1, 0.25F, 0.25F}, {1, 0, 1, 0.5F, 0.25F}, {1, 1, 1, 0.5F, 0.5F}}));
  const sim::Mesh& mesh = cube.garment->mesh;
  const std::string text = obj_text(mesh, mesh.positions, cube.colours.corner_uv);
  std::size_t places = 0;
  for (std::size_t at = text.find("\nvt "); at != std::string::npos; at = text.find("\nvt ", at + 1)) {
    ++places;
  }
  EXPECT_EQ(places, 14U);
  EXPECT_EQ(list_corners(load_garment(make_scene(folder.write("again.obj", text)))), corners);
  EXPECT_NEAR(cube.metres_per_uv, 4.0, 1e-6);
}

// Texture coordinates of every corner equal its position. They must stay equal after triangles are dropped, turned,
// cut or moved.
TEST(SurfaceColours, FollowTrianglesThatAreDroppedTurnedAndSubdivided) {
  const TemporaryFolder folder;
  const auto path = folder.write("sheet.obj",
                                 "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 1.5 2 0\nv 0 2 0\nv 0.5 0 0\n"
                                 "vt 0 0\nvt 1 0\nvt 2 0\nvt 0 1\nvt 1 1\nvt 2 1\nvt 1.5 2\nvt 0 2\nvt 0.5 0\nvt 7 7\n"
                                 "f 1/10 9/10 2/10\n"  // without area
                                 "f 1/1 2/2 5/5 4/4\n"
                                 "f 2/2 6/6 3/3\n"  // faces the other side
                                 "f 2/2 6/6 5/5\n"
                                 "f 2/10 5/10 6/10\n"  // repeated
                                 "f 4/4 5/5 6/6 7/7 8/8\n");
  DrawnScene scene = make_scene(path);
  scene.garment.subdivisions = 1;
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_EQ(loaded.repairs->degenerate_triangles, 1U);
  EXPECT_EQ(loaded.repairs->duplicate_triangles, 1U);
  EXPECT_GE(loaded.repairs->turned_triangles, 1U);
  const sim::Mesh& mesh = loaded.garment->mesh;
  ASSERT_EQ(loaded.colours.corner_uv.size(), 3 * mesh.triangles.size());
  for (std::size_t c = 0; c < loaded.colours.corner_uv.size(); ++c) {
    const sim::Vec3& p = mesh.positions[mesh.triangles[c / 3][c % 3]];
    EXPECT_EQ(glm::dvec2(loaded.colours.corner_uv[c]), glm::dvec2(p.x, p.y)) << "corner " << c;
  }
}

TEST(SurfaceColours, OfAnObjAreReadWhateverIsDamaged) {
  const ModelArrays model = read_obj(
                                "vt 0.5 +0.25 0\nvt x y\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1/1 2/2 3/9\nf 1/-1 "
                                "2//3 3\nvt 3 4\nf 1/3 2/-3 3/x\n")
                                .value();
  const glm::vec2 none(0.0F);
  EXPECT_EQ(model.colours.corner_uv,
            (std::vector<glm::vec2>{{0.5F, 0.25F}, none, none, none, none, none, {3, 4}, {0.5F, 0.25F}, none}));
  EXPECT_TRUE(read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")->colours.corner_uv.empty());
}

/// Two triangles of different materials.
std::filesystem::path write_two(const TemporaryFolder& folder, const std::string& mtl) {
  folder.write("two.mtl", mtl);
  return folder.write("two.obj",
                      "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                      "usemtl red cotton\nf 1/1 2/2 3/3\nusemtl blue\nf 1/1 3/3 4/4\n");
}

TEST(SurfaceColours, OfAnObjComeFromItsMaterials) {
  const TemporaryFolder folder;
  folder.write("check.png", encode_png(2, 3, {10, 20, 30, 255}));
  const DrawnScene scene = make_scene(write_two(
      folder, "newmtl red cotton\nKd 0.5 0.25 0\nmap_Kd -s 1 1 1 C:\\cloth\\check.png\r\nnewmtl blue\nKd 0 0 1\n"));
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_EQ(loaded.colours.material_of_face, (std::vector<sim::Index>{0, 1}));
  const DrawnColours drawn = drawn_colours(scene, loaded);
  ASSERT_EQ(drawn.base_colours.size(), 2U);
  EXPECT_EQ(drawn.base_colours[0].map.height_px, 3);
  EXPECT_EQ(drawn.base_colours[0].map.rgba->at(1), 20);
  EXPECT_EQ(drawn.base_colours[1].map.rgba, nullptr);
  EXPECT_EQ(drawn.base_colours[1].outside_colour, glm::vec3(0, 0, 1));
  EXPECT_TRUE(loaded.colours.remarks.empty());
}

TEST(SurfaceColours, NeedNoImageButOneThatIsNotGrey) {
  const TemporaryFolder folder;
  const DrawnScene red =
      make_scene(write_two(folder, "newmtl red cotton\nKd 0.7 0.1 0.15\nnewmtl blue\nKd 0.8 0.8 0.8\n"));
  const DrawnColours drawn = drawn_colours(red, load_garment(red));
  ASSERT_EQ(drawn.base_colours.size(), 2U);
  EXPECT_EQ(drawn.base_colours[0].outside_colour, glm::vec3(0.7F, 0.1F, 0.15F));
  const DrawnScene grey =
      make_scene(write_two(folder, "newmtl red cotton\nKd 0.8 0.8 0.8\nnewmtl blue\nKd 0.6 0.6 0.6\n"));
  EXPECT_TRUE(drawn_colours(grey, load_garment(grey)).base_colours.empty());
}

TEST(SurfaceColours, GiveWayToWhatTheSceneAsksFor) {
  const TemporaryFolder folder;
  folder.write("check.png", encode_png(1, 1, {10, 20, 30, 255}));
  folder.write("print.png", encode_png(4, 4, {1, 2, 3, 4}));
  DrawnScene scene = make_scene(write_two(folder, "newmtl blue\nmap_Kd check.png\n"));
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_EQ(drawn_colours(scene, loaded).base_colours.size(), 2U);
  scene.picture.cloth.outside_colour = renderer::rgb(0x00FF00);
  EXPECT_TRUE(drawn_colours(scene, loaded).base_colours.empty());
  scene.picture.texture = folder / "print.png";
  const DrawnColours print = drawn_colours(scene, loaded);
  ASSERT_EQ(print.base_colours.size(), 1U);
  EXPECT_EQ(print.base_colours[0].outside_colour, renderer::rgb(0x00FF00));
  ASSERT_EQ(print.base_colours[0].map.rgba->size(), 64U);
  EXPECT_EQ(print.base_colours[0].map.rgba->at(3), 4);
  scene.picture = {};
  scene.picture.texture = no_texture;
  EXPECT_TRUE(drawn_colours(scene, loaded).base_colours.empty());
}

TEST(SurfaceColours, OfLayersAreThoseOfTheirFabrics) {
  const TemporaryFolder folder;
  folder.write("two.landmarks.toml", "layers = 2\n[fabrics]\n\"over.\" = \"denim\"\n");
  DrawnScene scene = make_scene(folder.write(
      "two.obj",
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0.1\nv 1 0 0.1\nv 1 1 0.1\ng under\nf 1 2 3\ng over.front\nf 4 5 6\n"));
  const auto make_of = [](const char* fabric, DrawnScene& made) {
    apply_overrides(drawn_scene_format(), std::vector<Override>{{"cloth.fabric", fabric, "--fabric"}}, made);
  };
  make_of("cotton", scene);
  const LoadedGarment loaded = load_garment(scene);
  const DrawnColours drawn = drawn_colours(scene, loaded);
  ASSERT_EQ(drawn.base_colours.size(), 2U);
  EXPECT_EQ(drawn.base_colours[0].outside_colour, scene.picture.cloth.outside_colour);
  EXPECT_NE(drawn.base_colours[0].outside_colour, drawn.base_colours[1].outside_colour);
  DrawnScene denim;
  make_of("denim", denim);
  EXPECT_EQ(drawn.base_colours[1].outside_colour, denim.picture.cloth.outside_colour);
  EXPECT_EQ(drawn.base_colour_of_triangle, (std::vector<std::uint32_t>{0, 1}));
  scene.picture.texture = no_texture;
  EXPECT_TRUE(drawn_colours(scene, loaded).base_colours.empty());
}

TEST(SurfaceColours, DoNotComeFromOutsideOfTheModelsFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "model");
  for (const auto& file : {write_two(folder, "newmtl blue\nmap_Kd ../check.png\n"), folder / "two.mtl"}) {
    std::filesystem::rename(file, folder / "model" / file.filename());
  }
  const DrawnScene scene = make_scene(folder / "model/two.obj");
  folder.write("check.png", encode_png(1, 1, {10, 20, 30, 255}));
  const std::vector<std::string> outside = load_garment(scene).colours.remarks;
  ASSERT_EQ(outside.size(), 1U);
  EXPECT_CONTAINS(outside[0], ", of which nothing outside of the model's folder is read");
  std::filesystem::rename(folder / "check.png", folder / "model/check.png");
  EXPECT_TRUE(load_garment(scene).colours.remarks.empty());
}

TEST(SurfaceColours, SayWhichImageIsMissingAndWhereItWasLookedFor) {
  const TemporaryFolder folder;
  const DrawnScene scene = make_scene(
      write_two(folder, "newmtl blue\nKd 0 0 1\nmap_Kd stripes/fine.png\nnewmtl red cotton\nmap_Kd two.mtl\n"));
  const LoadedGarment loaded = load_garment(scene);
  ASSERT_EQ(loaded.colours.remarks.size(), 2U);
  const std::string said = loaded.colours.remarks[0] + loaded.colours.remarks[1];
  EXPECT_CONTAINS(
      said, "the image 'stripes/fine.png' of its material 'blue' is not drawn, its base colour is: it is neither");
  EXPECT_CONTAINS(said, (folder / "textures/fine.png").string());
  EXPECT_CONTAINS(said, "the image 'two.mtl' of its material 'red cotton' is not drawn");
  const DrawnColours drawn = drawn_colours(scene, loaded);
  EXPECT_EQ(drawn.remarks.size(), 2U);
  ASSERT_EQ(drawn.base_colours.size(), 2U);
  EXPECT_EQ(drawn.base_colours[1].outside_colour, glm::vec3(0, 0, 1));
}

TEST(SurfaceColours, APrintNeedsCoordinatesAndAnImage) {
  const TemporaryFolder folder;
  DrawnScene scene = make_scene(folder.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"));
  const LoadedGarment loaded = load_garment(scene);
  scene.picture.texture = folder.write("print.png", encode_png(1, 1, {1, 2, 3, 4}));
  EXPECT_CONTAINS(error_message<InputError>([&] { drawn_colours(scene, loaded); }),
                  "print.png' cannot be drawn, as the garment has no texture coordinates");
  EXPECT_CONTAINS(error_message<InputError>([&] { read_image(folder / "none.png"); }), "there is no file");
  EXPECT_CONTAINS(error_message<InputError>([&] { read_image(folder.write("text.png", "not a picture")); }),
                  "text.png': it is no image that can be read");
  std::string vast = encode_png(1, 1, {1, 2, 3, 4});
  vast[18] = vast[22] = 0x23;
  EXPECT_CONTAINS(error_message<InputError>([&] { read_image(folder.write("vast.png", vast)); }),
                  "8961 x 8961 pixels, more than");
}

TEST(SurfaceColours, OfTheTShirtAreToScale) {
  const LoadedGarment loaded = load_garment(make_scene(std::string(TAUT_ASSETS_FOLDER) + "/garments/tshirt_1028.obj"));
  EXPECT_EQ(loaded.metres_per_uv, 1.5);
  EXPECT_NEAR(metres_per_uv(loaded.garment->mesh, loaded.colours.corner_uv), 1.5, 0.01);
  EXPECT_EQ(metres_per_uv(loaded.garment->mesh, {}), 0.0);
}

TEST(SurfaceColours, AnImpossibleScaleIsRefused) {
  const TemporaryFolder folder;
  const DrawnScene scene = make_scene(folder.write("cube.obj", cube_text));
  folder.write("cube.landmarks.toml", "# scale\nmetres_per_uv = 0\n");
  EXPECT_CONTAINS(error_message<InputError>([&] { load_garment(scene); }),
                  "cube.landmarks.toml:2: metres_per_uv: found 0, expected a number above 0");
}

// Coordinates of glTF count from the top; its colours are linear.
TEST(SurfaceColours, OfAGltfComeFromWithinIt) {
  const TemporaryFolder folder;
  // Positions (0,0,0) (1,0,0) (0,1,0), then coordinates (0,1) (1,1) (0,0).
  const std::array<float, 15> numbers = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 0};
  const std::string bytes(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
  const auto path =
      folder.write("shirt.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
"materials":[{"name":"cotton","pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[0.5,1,1,1]}}],
"textures":[{"source":0}],"images":[{"mimeType":"image/png","uri":"data:image/png;base64,)" +
                                     base64(encode_png(2, 2, {255, 100, 50, 128})) + R"("}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
"buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)" +
                                     base64(bytes) + R"("}]})");
  const ImportedModel model = import_garment(path, {}, ReadParts::model);
  EXPECT_EQ(model.colours.corner_uv, (std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 1}}));
  ASSERT_EQ(model.colours.material_of_face.size(), 1U);
  const SurfaceMaterial& material = model.colours.materials.at(model.colours.material_of_face[0]);
  EXPECT_EQ(material.name, "cotton");
  EXPECT_EQ(material.map, 0U);
  ASSERT_EQ(model.colours.maps.size(), 1U);
  // Half of the light of 255 is 188. An opaque material has no alpha.
  const std::vector<std::uint8_t>& rgba = *model.colours.maps[0].rgba;
  EXPECT_EQ(std::vector<std::uint8_t>(rgba.begin(), rgba.begin() + 4), (std::vector<std::uint8_t>{188, 100, 50, 255}));
  EXPECT_TRUE(import_garment(path).colours.maps.empty());
}

}  // namespace
}  // namespace taut::app
