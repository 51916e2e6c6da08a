#include "app/output/picture_record.hpp"

#include "app/base/errors.hpp"
#include "app/models/reading/surface_colours.hpp"
#include "app/output/output_pattern.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {
namespace {

constexpr const char* program_keyword = "Software";
constexpr const char* scene_keyword = "Taut Scene";
constexpr const char* frame_keyword = "Taut Frame";
constexpr const char* state_keyword = "Taut State";
constexpr const char* renderer_keyword = "Taut Renderer";

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./:=,+%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text;
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_literal = byte >= 0x20 && byte < 0x7F && c != '\'' && c != '\\';
    text += is_literal ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
  }
  return (text == word ? "'" : "$'") + text + '\'';
}

/// A picture file. If it is trusted, its scene may name any file of this machine.
struct PictureFile {
  std::filesystem::path file;
  bool is_trusted = false;
};

/// Returns an asset of the program, a file beside the picture, or the file at the recorded path.
std::filesystem::path find_file(const std::filesystem::path& recorded, const PictureFile& picture) {
  const std::filesystem::path folder = std::filesystem::absolute(picture.file).parent_path();
  const std::filesystem::path asset = assets_folder() / recorded, beside = folder / recorded.filename();
  std::error_code ignored;
  if (recorded.is_relative() && is_inside(asset, assets_folder()) && std::filesystem::exists(asset, ignored))
    return asset;
  for (const std::filesystem::path& candidate : {recorded, beside}) {
    if (!std::filesystem::exists(candidate, ignored)) continue;
    if (picture.is_trusted || is_inside(candidate, folder)) return candidate;
  }
  if (std::filesystem::exists(recorded, ignored)) {
    throw InputError(
        "the scene in '{}' names '{}', which is not in the picture's folder; expected '{}', or --trust, "
        "which opens any file that a picture names",
        picture.file.string(), recorded.string(), beside.string());
  }
  return recorded;
}

// Uses the file names of the table, because the members already have a scene file's folder in front.
template <class Files, class Models>
void find_files(const toml::node_view<const toml::node>& table, const Files& files, const PictureFile& picture,
                Models& models) {
  for (const auto& [key, member] : files) {
    if (const auto recorded = table[key].template value<std::string>()) models.*member = find_file(*recorded, picture);
  }
}

DrawnScene read_scene(const std::string& text, const PictureFile& picture) {
  const Source source{"the scene in '" + picture.file.string() + '\'', false};
  const toml::table settings = read_toml_text(text, source.name);
  DrawnScene scene;
  const SceneFormat<DrawnScene> format = drawn_scene_format();
  KeyReader(format.keys, source, scene).read(settings);
  find_files(settings["garment"], garment_files, picture, scene.garment);
  find_files(settings["start"], std::array{std::pair("checkpoint", &DrawnScene::checkpoint)}, picture, scene);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    find_files(settings["bodies"][k], body_files, picture, scene.bodies[k].source);
  }
  if (names_image(scene.picture.texture)) {
    scene.picture.texture = find_file(*settings["picture"]["texture"].value<std::string>(), picture);
  }
  scene.name = picture.file.stem().string();
  scene.files_read = {picture.file};
  return scene;
}

std::vector<renderer::PngText> read_texts(const std::filesystem::path& file) {
  const std::string bytes = read_text_file(file, max_model_bytes);
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  try {
    return renderer::read_png_texts({data, bytes.size()}, file.string());
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
}

template <class Number>
Number parse_number(const std::string& text, int base, const char* keyword, const std::filesystem::path& file) {
  const std::optional<Number> number = number_in<Number>(text, base);
  if (!number || text.starts_with('-')) {
    throw InputError("the entry '{}' of '{}' is '{}', expected a number", keyword, file.string(), text);
  }
  return *number;
}

}  // namespace

std::string shell_line(std::span<const std::string> words) {
  return join(collect<std::string>(words, shell_word), " ");
}

std::string command_text(std::span<const std::string> arguments) {
  return arguments.empty() ? "taut" : "taut " + shell_line(arguments);
}

std::vector<renderer::PngText> picture_texts(const PictureOrigin& origin, const FrameRecord& record) {
  return {program_text(),
          {"Taut Command", origin.command},
          {scene_keyword, origin.scene},
          {renderer_keyword, origin.gl_renderer},
          {frame_keyword, fmt::format("{}", record.frame)},
          {state_keyword, fmt::format("{:016x}", record.state_hash)},
          {"Taut Stretch", fmt::format("{}", record.stretch.max)},
          {"Taut Surface Stretch", fmt::format("{}", record.surface_stretch.max)}};
}

renderer::PngText program_text() { return {program_keyword, "taut " + program_version()}; }

bool is_own_picture(const std::filesystem::path& file) {
  try {
    const std::vector<renderer::PngText> texts = read_texts(file);
    const auto found = std::ranges::find(texts, program_keyword, &renderer::PngText::keyword);
    return found != texts.end() && found->text.starts_with("taut ");
  } catch (const InputError&) {
    return false;  // not a PNG, or not readable
  }
}

std::filesystem::path choose_name(const std::filesystem::path& name) {
  const std::string ending = name.extension().string();
  return choose_free_stem(std::filesystem::path(name).replace_extension(), is_own_picture(name), {ending}) += ending;
}

bool is_picture(const std::filesystem::path& file) { return file.extension() == ".png"; }

PictureRecord read_picture_record(const std::filesystem::path& file, std::span<const Override> overrides,
                                  bool is_trusted) {
  const std::vector<renderer::PngText> texts = read_texts(file);
  const auto entry = [&](const char* keyword) {
    const auto found = std::ranges::find(texts, keyword, &renderer::PngText::keyword);
    if (found == texts.end()) {
      throw InputError(
          "the picture '{}' does not say how it was made: it has no entry '{}', as pictures of taut render "
          "have",
          file.string(), keyword);
    }
    return found->text;
  };
  PictureRecord record;
  record.scene = read_scene(entry(scene_keyword), {file, is_trusted});
  apply_overrides(overrides, record.scene);
  record.frame = parse_number<int>(entry(frame_keyword), 10, frame_keyword, file);
  if (record.frame > max_frame) {
    throw InputError("the entry '{}' of '{}' is {}, expected a frame from 0 to {}", frame_keyword, file.string(),
                     record.frame, max_frame);
  }
  record.state_hash = parse_number<std::uint64_t>(entry(state_keyword), 16, state_keyword, file);
  record.program = entry(program_keyword);
  record.gl_renderer = entry(renderer_keyword);
  return record;
}

}  // namespace taut::app
