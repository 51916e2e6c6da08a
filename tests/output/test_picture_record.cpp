#include <gtest/gtest.h>

#include <map>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/output/picture_record.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

renderer::Image small_picture() { return renderer::make_image(4, 3); }

std::filesystem::path write_record(const TemporaryFolder& folder, const DrawnScene& scene) {
  FrameRecord record;
  record.frame = 12;
  record.state_hash = 0xFEDCBA9876543210U;
  const auto file = folder / "picture.png";
  write_file(file, renderer::encode_png(small_picture(),
                                        picture_texts({"taut render x", scene_text(scene), "llvmpipe"}, record)));
  return file;
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

TEST(PictureRecord, BuiltInScenesReadBackAsTheyWere) {
  const TemporaryFolder folder;
  ASSERT_FALSE(built_in_scenes().empty());
  for (const BuiltInScene& built_in : built_in_scenes()) {
    const DrawnScene scene = find_scene(built_in.name, {});
    const PictureRecord record = read_picture_record(write_record(folder, scene), {});
    EXPECT_EQ(scene_text(record.scene), scene_text(scene));
    EXPECT_EQ(record.scene.camera.framing.azimuth_rad, scene.camera.framing.azimuth_rad);
    EXPECT_EQ(record.scene.simulation, scene.simulation);
    EXPECT_EQ(record.frame, 12);
    EXPECT_EQ(record.state_hash, 0xFEDCBA9876543210U);
    EXPECT_EQ(record.gl_renderer, "llvmpipe");
    EXPECT_EQ(scene_text(scene).find(assets_folder().string()), std::string::npos) << "a path of this machine";
  }
}

TEST(PictureRecord, AnImageOnTheClothIsFoundInTheAssetsOfAnyMachine) {
  const TemporaryFolder folder;
  DrawnScene scene = find_scene("tshirt", {});
  for (const std::filesystem::path& texture :
       {assets_folder() / "textures/print.png", std::filesystem::path(no_texture), std::filesystem::path()}) {
    scene.picture.texture = texture;
    EXPECT_EQ(read_picture_record(write_record(folder, scene), {}).scene.picture.texture, texture);
    EXPECT_EQ(scene_text(scene).find(assets_folder().string()), std::string::npos);
  }
  const Override print = {"picture.texture", "prints/sun.png", "--texture prints/sun.png"};
  EXPECT_EQ(find_scene("tshirt", std::span(&print, 1)).picture.texture, "prints/sun.png");
}

constexpr const char* all_kinds = R"(
title = "quotes \" and \\, Größe, tab \t, line \n"
[garment.grid]
columns = 3
rows = 3
[pins]
at = ["top-left", 4, { nearest = [0.1, -0.0, 1e-17] }]
[solver]
compression = 0.30000000000000004
[gravity]
acceleration = [0, -9.81, 0.1]
[camera]
eye = [1, 2.1, 3.7]
target = [0, 0.1, 0]
[picture]
ground = "none"
outside_colour = "#0180fe"
stretch_range = [0.01, 0.33]
[[forces]]
vertex = 3
force = [0.1, 0.2, 0.3]
[[bodies]]
shape = "sphere"
radius = 0.7
[[bodies]]
shape = "capsule"
start_radius = 0.1
end_radius = 0.2
end = [0, 1, 0]
[[bodies]]
shape = "plane"
)";

TEST(PictureRecord, EveryKindOfValueReadsBackBitForBit) {
  const TemporaryFolder folder;
  const DrawnScene scene = read_scene_file(folder.write("scene.toml", all_kinds));
  const std::string text = scene_text(scene);
  EXPECT_TRUE(is_ascii(text)) << text;
  const DrawnScene again = read_picture_record(write_record(folder, scene), {}).scene;
  EXPECT_EQ(scene_text(again), text);
  EXPECT_EQ(again.title, scene.title);
  EXPECT_EQ(again.simulation.solver.strong.rigidity.compression, 0.30000000000000004);
  EXPECT_EQ(*again.camera.eye, *scene.camera.eye);
  EXPECT_EQ(again.bodies.size(), 3U);
  // The text alone is a scene file.
  EXPECT_EQ(scene_text(read_scene_file(folder.write("again.toml", text))), text);
}

TEST(PictureRecord, SaysBothStretches) {
  FrameRecord record;
  record.stretch.max = 0.25;
  record.surface_stretch.max = 0.5;
  std::map<std::string, std::string> said;
  for (const renderer::PngText& text : picture_texts({}, record)) {
    said[text.keyword] = text.text;
  }
  EXPECT_EQ(said["Taut Stretch"], "0.25");
  EXPECT_EQ(said["Taut Surface Stretch"], "0.5");
}

TEST(PictureRecord, OverridesChangeTheRecordedScene) {
  const TemporaryFolder folder;
  const auto file = write_record(folder, find_scene("cloth-fall", {}));
  const std::vector<Override> overrides = {parse_override("camera.azimuth=0")};
  EXPECT_EQ(read_picture_record(file, overrides).scene.camera.framing.azimuth_rad, 0.0F);
}

TEST(PictureRecord, AGarmentIsFoundInTheAssetsOrBesideThePicture) {
  const TemporaryFolder folder;
  const DrawnScene shirt = find_scene("tshirt-gravity", {});
  EXPECT_CONTAINS(scene_text(shirt), "file = \"garments/tshirt_10600.obj\"");
  EXPECT_TRUE(std::filesystem::exists(read_picture_record(write_record(folder, shirt), {}).scene.garment.file));

  DrawnScene other = shirt;
  other.garment.file = "/nowhere/any.obj";
  const auto picture = write_record(folder, other);
  EXPECT_EQ(read_picture_record(picture, {}).scene.garment.file, "/nowhere/any.obj");
  const auto beside = folder.write("any.obj", "v 0 0 0\n");
  EXPECT_EQ(read_picture_record(picture, {}).scene.garment.file, beside);
}

TEST(PictureRecord, ABodyIsFoundInTheAssetsOrBesideThePicture) {
  const TemporaryFolder folder;
  DrawnScene scene = find_scene("needles", {});
  EXPECT_CONTAINS(scene_text(scene), "file = \"bodies/needles.obj\"");
  const BodySource found = read_picture_record(write_record(folder, scene), {}).scene.bodies.at(0).source;
  EXPECT_EQ(found.file, assets_folder() / "bodies/needles.obj");
  EXPECT_TRUE(found.motion.empty());
  EXPECT_CONTAINS(scene_text(scene, GarmentNaming::full_path), assets_folder().string() + "/bodies/needles");

  scene.bodies[0].source.file = "/nowhere/any.obj";
  scene.bodies[0].source.motion = "/nowhere/any.pc2";
  const auto picture = write_record(folder, scene);
  EXPECT_EQ(read_picture_record(picture, {}).scene.bodies.at(0).source.file, "/nowhere/any.obj");
  const auto beside = folder.write("any.obj", "v 0 0 0\n"), frames = folder.write("any.pc2", "");
  EXPECT_EQ(read_picture_record(picture, {}).scene.bodies.at(0).source.file, beside);
  EXPECT_EQ(read_picture_record(picture, {}).scene.bodies.at(0).source.motion, frames);
}

TEST(PictureRecord, AFileOutsideOfThePicturesFolderIsOpenedWhereThatIsTrusted) {
  const TemporaryFolder folder;
  const auto elsewhere = folder.write("any.obj", "v 0 0 0\n");
  std::filesystem::create_directory(folder / "sent");
  DrawnScene scene = find_scene("tshirt-gravity", {});
  const auto refusal = [&] {
    std::filesystem::rename(write_record(folder, scene), folder / "sent/picture.png");
    return error_message<InputError>([&] { read_picture_record(folder / "sent/picture.png", {}); });
  };
  scene.garment.file = elsewhere;
  EXPECT_CONTAINS(refusal(), "names '" + elsewhere.string() + "', which is not in the picture's folder");
  EXPECT_EQ(read_picture_record(folder / "sent/picture.png", {}, true).scene.garment.file, elsewhere);
  std::filesystem::create_symlink(elsewhere, folder / "sent/any.obj");
  EXPECT_CONTAINS(refusal(), "not in the picture's folder");
  scene.garment.file = assets_folder() / "garments/../../../../../../../../../../../etc/passwd";
  EXPECT_CONTAINS(refusal(), "not in the picture's folder");
  scene = find_scene("tshirt-gravity", {});
  scene.checkpoint = elsewhere;
  EXPECT_CONTAINS(refusal(), "not in the picture's folder");
  scene = find_scene("tshirt-gravity", {});
  scene.picture.texture = elsewhere;
  EXPECT_CONTAINS(refusal(), "not in the picture's folder");
  scene = find_scene("needles", {});
  scene.bodies[0].source.motion = elsewhere;
  EXPECT_CONTAINS(refusal(), "not in the picture's folder");
}

// File names can hold any bytes. A scene with such bytes would not be TOML and could not be read back.
TEST(PictureRecord, AGarmentWhoseNameIsNoUtf8CanBeReadBack) {
  const TemporaryFolder folder;
  DrawnScene scene = find_scene("tshirt-gravity", {});
  scene.garment.file = "/nowhere/bl\xFFse \xC3\xA9.obj";
  const std::string text = scene_text(scene);
  EXPECT_TRUE(is_ascii(text)) << text;
  EXPECT_EQ(read_picture_record(write_record(folder, scene), {}).scene.garment.file,
            "/nowhere/bl\xEF\xBF\xBDse \xC3\xA9.obj");
}

TEST(PictureRecord, APictureOfAnotherOriginIsNamed) {
  const TemporaryFolder folder;
  write_file(folder / "plain.png", renderer::encode_png(small_picture()));
  EXPECT_CONTAINS(error_message<InputError>([&] { read_picture_record(folder / "plain.png", {}); }),
                  "plain.png' does not say how it was made");
  folder.write("text.png", "not a picture");
  EXPECT_CONTAINS(error_message<InputError>([&] { read_picture_record(folder / "text.png", {}); }),
                  "is no PNG picture");
  const std::vector<renderer::PngText> texts = {{"Taut Scene", "[garment.grid\n"}};
  write_file(folder / "bad.png", renderer::encode_png(small_picture(), texts));
  EXPECT_CONTAINS(error_message<InputError>([&] { read_picture_record(folder / "bad.png", {}); }), "is not TOML");
}

TEST(PictureRecord, BadNumbersAreNamed) {
  const TemporaryFolder folder;
  const std::string scene = scene_text(find_scene("cloth-fall", {}));
  const std::vector<renderer::PngText> texts = {{"Taut Scene", scene}, {"Taut Frame", "-3"}};
  write_file(folder / "bad.png", renderer::encode_png(small_picture(), texts));
  EXPECT_CONTAINS(error_message<InputError>([&] { read_picture_record(folder / "bad.png", {}); }), "'Taut Frame' of '");
  const std::vector<renderer::PngText> late = {{"Taut Scene", scene}, {"Taut Frame", "2000000000"}};
  write_file(folder / "bad.png", renderer::encode_png(small_picture(), late));
  EXPECT_CONTAINS(error_message<InputError>([&] { read_picture_record(folder / "bad.png", {}); }),
                  "is 2000000000, expected a frame from 0 to 1000000");
}

TEST(CommandText, IsUnderstoodByAShell) {
  const std::vector<std::string> plain = {"render", "cloth-fall", "--set", "wind.speed=4"};
  EXPECT_EQ(command_text(plain), "taut render cloth-fall --set wind.speed=4");
  const std::vector<std::string> odd = {"a b", "it's", "", "f_{frame:04}.png", "ä\\"};
  EXPECT_EQ(command_text(odd), "taut 'a b' $'it\\x27s' '' 'f_{frame:04}.png' $'\\xc3\\xa4\\x5c'");
}

}  // namespace
}  // namespace taut::app
