#include "app/viewer/session/session.hpp"

#include "app/base/files.hpp"
#include "app/base/json_reading.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

using Json = nlohmann::json;
using renderer::ButtonChanged;
using renderer::KeyChanged;
using renderer::PointerMoved;
using renderer::WindowEvent;

// Limits on a session's requests, so that a damaged session ends with an error.
constexpr int max_frames = 1000000;
constexpr int max_side_px = 16384;
constexpr double far_px = 1e6;

constexpr std::array button_names = {"left", "right", "middle"};

/// Form of each kind of line, with its verb first.
constexpr std::array<std::pair<std::string_view, const char*>, 17> forms = {{
    {"taut-session", R"(["taut-session", 2])"},
    {"scene", R"(["scene", SCENE])"},
    {"set", R"(["set", "KEY=VALUE"])"},
    {"compare", R"(["compare", SOLVER], such as "provot")"},
    {"window", R"(["window", WIDTH, HEIGHT, SCALE])"},
    {"key", R"(["key", CODE, true|false], with an ASCII code or one of GLFW)"},
    {"text", R"(["text", CODE], the number of a character)"},
    {"move", R"(["move", X, Y] in pixels)"},
    {"button", R"(["button", "left"|"right"|"middle", true|false])"},
    {"wheel", R"(["wheel", X, Y] in notches)"},
    {"drop", R"(["drop", PATH])"},
    {"resize", R"(["resize", WIDTH, HEIGHT] in pixels)"},
    {"scale", R"(["scale", SCALE], 0.25 to 8)"},
    {"at", R"(["at", ITEM, X, Y], with X and Y across it from 0 to 1)"},
    {"frame", R"(["frame", COUNT], no more than a million in all)"},
    {"paced", R"(["paced", SECONDS, ADVANCES, SNAPSHOT])"},
    {"state", R"(["state", HASH] after a frame)"},
}};

struct EventWriter {
  Json operator()(const KeyChanged& event) const { return Json::array({"key", event.key, event.down}); }
  Json operator()(const renderer::TextTyped& event) const {
    return Json::array({"text", static_cast<std::uint32_t>(event.character)});
  }
  Json operator()(const PointerMoved& event) const { return Json::array({"move", event.x_px, event.y_px}); }
  Json operator()(const ButtonChanged& event) const {
    return Json::array({"button", button_names[static_cast<std::size_t>(event.button)], event.down});
  }
  Json operator()(const renderer::WheelTurned& event) const { return Json::array({"wheel", event.x, event.y}); }
  Json operator()(const renderer::FileDropped& event) const { return Json::array({"drop", event.path}); }
  Json operator()(const renderer::Resized& event) const {
    return Json::array({"resize", event.width_px, event.height_px});
  }
  Json operator()(const renderer::ScaleChanged& event) const { return Json::array({"scale", event.scale}); }
  Json operator()(const WindowEvent& event) const { return std::visit(*this, event); }
  Json operator()(const PointAt& event) const { return Json::array({"at", event.item, event.x, event.y}); }
};

std::string json_line(const Json& values) { return values.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

/// Returns the values of a line; empty if it is not JSON.
Json parse_line(const std::string& text) try { return parse_json<Json>(text, "", ""); } catch (const InputError&) {
  return {};
}

/// A line whose values are read in order.
class SessionLine {
 public:
  SessionLine(const std::string& file, int number, const std::string& text)
      : file_(file), number_(number), text_(text), values_(parse_line(text)) {
    if (!values_.is_array() || values_.empty() || !values_[0].is_string()) {
      fail(number == 1 ? forms[0].second : R"(a list [VERB, ...])");
    }
  }

  std::string verb() const { return values_[0]; }

  [[noreturn]] void fail(const std::string& expected) const {
    constexpr std::size_t max_shown = 200;
    const std::string found = text_.size() > max_shown ? text_.substr(0, max_shown) + "..." : text_;
    throw InputError(file_ + ':' + std::to_string(number_) + ": found '" + printable(found) + "', expected " + expected);
  }
  [[noreturn]] void fail() const {
    const auto* const form = std::ranges::find_if(forms, [&](const auto& f) { return f.first == verb(); });
    fail(form != forms.end() ? form->second
                             : "an event, frame, paced or state; scene, set, compare and window stand before "
                               "the first frame");
  }

  template <class Number> Number number(Number lowest, Number highest) {
    const Json& value = next();
    const bool is_right = std::is_integral_v<Number> ? value.is_number_integer() : value.is_number();
    const double found = is_right ? value.get<double>() : NAN;
    if (!(found >= static_cast<double>(lowest) && found <= static_cast<double>(highest))) fail();
    return value.get<Number>();
  }
  bool flag() {
    const Json& value = next();
    return value.is_boolean() ? value.get<bool>() : (fail(), false);
  }
  std::string text() {
    const Json& value = next();
    return value.is_string() && !value.get_ref<const std::string&>().empty() ? value.get<std::string>() : (fail(), "");
  }
  bool has_more() const { return taken_ < values_.size(); }

 private:
  const Json& next() { return has_more() ? values_[taken_++] : (fail(), values_[0]); }

  const std::string& file_;
  int number_;
  const std::string& text_;
  Json values_;
  std::size_t taken_ = 1;
};

renderer::Resized read_size(SessionLine& line) {
  const int width = line.number(0, max_side_px);
  return {width, line.number(0, max_side_px)};
}

renderer::PointerButton read_button(SessionLine& line) {
  const auto* const name = std::ranges::find(button_names, line.text());
  return name != button_names.end() ? static_cast<renderer::PointerButton>(name - button_names.begin())
                                    : (line.fail(), renderer::PointerButton::left);
}

// Reads an event. Values in braces are evaluated from left to right.
std::optional<SessionEvent> read_event(SessionLine& line) {
  const std::string verb = line.verb();
  if (verb == "key") return WindowEvent(KeyChanged{line.number(0, renderer::keys::last), line.flag()});
  if (verb == "button") return WindowEvent(ButtonChanged{read_button(line), line.flag()});
  if (verb == "text") return WindowEvent(renderer::TextTyped{line.number<std::uint32_t>(0, 0x10FFFF)});
  if (verb == "drop") return WindowEvent(renderer::FileDropped{line.text()});
  if (verb == "resize") return WindowEvent(read_size(line));
  if (verb == "scale") return WindowEvent(renderer::ScaleChanged{line.number(0.25, 8.0)});
  if (verb == "move") return WindowEvent(PointerMoved{line.number(-far_px, far_px), line.number(-far_px, far_px)});
  if (verb == "wheel") {
    return WindowEvent(renderer::WheelTurned{line.number(-far_px, far_px), line.number(-far_px, far_px)});
  }
  if (verb == "at") return PointAt{line.text(), line.number(-10.0, 10.0), line.number(-10.0, 10.0)};
  return std::nullopt;
}

bool read_start(SessionLine& line, SessionStart& start) {
  const std::string verb = line.verb();
  if (verb == "scene") {
    start.scene = line.text();
  } else if (verb == "set") {
    const std::string change = line.text();
    if (change.find('=', 1) == std::string::npos) line.fail();
    start.overrides.push_back(parse_override(change));
  } else if (verb == "compare") {
    start.compared_with = solver_named(line.text());
    if (!start.compared_with) line.fail();
  } else if (verb == "window") {
    start.size = read_size(line);
    start.scale = line.number(0.25, 8.0);
  } else {
    return false;
  }
  return true;
}

void read_line(SessionLine& line, RecordedSession& session, SessionFrame& frame) {
  const std::string verb = line.verb();
  const auto finish_frame = [&] { session.frames.push_back(std::exchange(frame, {})); };
  if (verb == "frame") {
    const int count = line.has_more() ? line.number(1, max_frames - static_cast<int>(session.frames.size())) : 1;
    for (int i = 0; i < count; ++i) finish_frame();
  } else if (verb == "paced") {
    frame.elapsed_s = line.number(0.0, 1e6);
    frame.pace = Pace{line.number<std::uint64_t>(0, UINT64_MAX), line.number<std::uint64_t>(0, UINT64_MAX)};
    finish_frame();
  } else if (verb == "state") {
    if (session.frames.empty() || !frame.events.empty()) line.fail();
    session.frames.back().expected_state = line.number<std::uint64_t>(0, UINT64_MAX);
  } else if (auto event = read_event(line)) {
    frame.events.push_back(std::move(*event));
  } else if (!session.frames.empty() || !read_start(line, session.start)) {
    line.fail("an event, frame, paced or state; scene, set, compare and window stand before the first frame");
  }
  if (line.has_more()) line.fail();
}

template <class Event> const Event* as(const SessionEvent& event) {
  const auto* from_window = std::get_if<WindowEvent>(&event);
  return from_window != nullptr ? std::get_if<Event>(from_window) : nullptr;
}

bool moves_pointer(const SessionEvent& event) {
  return as<PointerMoved>(event) != nullptr || std::holds_alternative<PointAt>(event);
}

// Returns true if `next` must wait for another frame, because a frame does not show the order of its events. Otherwise
// cloth that is released would miss the last position of the drag.
bool has_to_wait(const SessionEvent& next, const std::vector<SessionEvent>& taken) {
  return std::ranges::any_of(taken, [&](const SessionEvent& before) {
    const auto* button = as<ButtonChanged>(before);
    const auto* key = as<KeyChanged>(before);
    const auto* next_button = as<ButtonChanged>(next);
    const auto* next_key = as<KeyChanged>(next);
    // Files are loaded one by one, each with its own messages.
    const bool drops_two = as<renderer::FileDropped>(before) != nullptr && as<renderer::FileDropped>(next) != nullptr;
    const bool lets_go = next_button != nullptr && !next_button->down;
    return drops_two || (lets_go && moves_pointer(before)) ||
           (button != nullptr && (moves_pointer(next) || next_button != nullptr)) ||
           (key != nullptr && next_key != nullptr && key->key == next_key->key && key->down != next_key->down);
  });
}

}  // namespace

std::string session_head(const SessionStart& start) {
  std::string text = json_line({"taut-session", 2}) + json_line({"scene", start.scene});
  for (const Override& changed : start.overrides) text += json_line({"set", changed.key + '=' + changed.value});
  if (start.compared_with) text += json_line({"compare", sim::to_name(*start.compared_with)});
  return text + json_line({"window", start.size.width_px, start.size.height_px, start.scale});
}

std::string session_lines(const SessionFrame& frame) {
  std::string text;
  for (const SessionEvent& event : frame.events) text += json_line(std::visit(EventWriter{}, event));
  text += frame.pace ? json_line({"paced", frame.elapsed_s, frame.pace->advances, frame.pace->shown})
                     : json_line({"frame", 1});
  return frame.expected_state ? text + json_line({"state", *frame.expected_state}) : text;
}

RecordedSession read_session(const std::filesystem::path& file) {
  return parse_session(read_text_file(file), file.string());
}

RecordedSession parse_session(const std::string& text, const std::string& name) {
  if (text.empty()) throw InputError(name + ": is empty, expected " + forms[0].second);
  std::istringstream lines(text);
  RecordedSession session;
  SessionFrame frame;
  int number = 0;
  for (std::string content; std::getline(lines, content);) {
    if (++number == 1) {
      SessionLine line(name, number, content);
      if (line.verb() != forms[0].first || line.number(0, 1000) != 2) line.fail(forms[0].second);
    } else if (!content.empty() && content.front() != '#') {
      SessionLine line(name, number, content);
      read_line(line, session, frame);
    }
  }
  // Trailing events without a frame get one.
  if (!frame.events.empty()) session.frames.push_back(std::move(frame));
  return session;
}

SessionRecorder::SessionRecorder(const std::filesystem::path& file, const SessionStart& start) : path_(file) {
  prepare_parent_folder(file);
  file_.open(file, std::ios::trunc);
  file_ << session_head(start) << std::flush;
  if (!file_) throw InputError("cannot write '" + file.string() + "'");
}

void SessionRecorder::add(const SessionFrame& frame) {
  file_ << session_lines(frame) << std::flush;
  if (!file_) throw InputError("cannot write '" + path_.string() + "': is the disk full?");
}

std::vector<SessionEvent> InputQueue::take_frame() {
  std::vector<SessionEvent> frame_events;
  while (!waiting_.empty() && !has_to_wait(waiting_.front(), frame_events)) {
    const bool replaces =
        !frame_events.empty() && moves_pointer(frame_events.back()) && moves_pointer(waiting_.front());
    if (replaces) frame_events.pop_back();
    frame_events.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  return frame_events;
}

}  // namespace taut::app
