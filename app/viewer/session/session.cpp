#include "app/viewer/session/session.hpp"

#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/viewer/session/key_names.hpp"

namespace taut::app {
namespace {

const char* name_of(renderer::PointerButton button) {
  constexpr std::array names = {"left", "right", "middle"};
  return names[static_cast<std::size_t>(button)];
}

struct EventWriter {
  std::string operator()(const renderer::KeyChanged& event) const {
    return fmt::format("key {} {}", key_name(event.key), event.down ? "down" : "up");
  }
  std::string operator()(const renderer::TextTyped& event) const {
    return fmt::format("text U+{:04X}", static_cast<std::uint32_t>(event.character));
  }
  std::string operator()(const renderer::PointerMoved& event) const {
    return fmt::format("move {} {}", event.x_px, event.y_px);
  }
  std::string operator()(const renderer::ButtonChanged& event) const {
    return fmt::format("button {} {}", name_of(event.button), event.down ? "down" : "up");
  }
  std::string operator()(const renderer::WheelTurned& event) const {
    return fmt::format("wheel {} {}", event.x, event.y);
  }
  std::string operator()(const renderer::FileDropped& event) const { return "drop " + event.path; }
  std::string operator()(const renderer::Resized& event) const {
    return fmt::format("resize {} {}", event.width_px, event.height_px);
  }
  std::string operator()(const renderer::ScaleChanged& event) const {
    return fmt::format("scale {}", event.scale);
  }
  std::string operator()(const renderer::WindowEvent& event) const { return std::visit(*this, event); }
  std::string operator()(const PointAt& event) const {
    return fmt::format("at {} {} {}", event.item, event.x, event.y);
  }
  std::string operator()(const ContextLost&) const { return "lose-context"; }
};

}  // namespace

std::string session_head(const SessionStart& start) {
  std::string text = "taut-session 1\nscene " + start.scene + '\n';
  for (const Override& changed : start.overrides) {
    text += "set " + changed.key + '=' + changed.value + '\n';
  }
  if (start.compared_with) {
    text += std::string("compare ") + sim::name_of(*start.compared_with) + '\n';
  }
  return text + fmt::format("window {} {} {}\n", start.size.width_px, start.size.height_px, start.scale);
}

std::string session_lines(const SessionFrame& frame) {
  std::string text;
  for (const SessionEvent& event : frame.events) {
    text += std::visit(EventWriter{}, event) + '\n';
  }
  if (frame.pace) {
    text += fmt::format("paced {} {} {}\n", frame.elapsed_s, frame.pace->advances, frame.pace->shown);
  } else {
    text += "frame 1\n";
  }
  if (frame.expected_state) {
    text += fmt::format("state {:016x}\n", *frame.expected_state);
  }
  return text;
}

Session read_session(const std::filesystem::path& file) {
  return parse_session(read_text_file(file), file.string());
}

SessionRecorder::SessionRecorder(const std::filesystem::path& file, const SessionStart& start) : path_(file) {
  prepare_folder_of(file);
  file_.open(file, std::ios::trunc);
  file_ << session_head(start) << std::flush;
  if (!file_) {
    throw InputError("cannot write '" + file.string() + "'");
  }
}

void SessionRecorder::add(const SessionFrame& frame) {
  file_ << session_lines(frame) << std::flush;
  if (!file_) {
    throw InputError("cannot write '" + path_.string() + "': is the disk full?");
  }
}

}  // namespace taut::app
