#include <charconv>
#include <sstream>

#include "app/base/errors.hpp"
#include "app/viewer/session/key_names.hpp"
#include "app/viewer/session/session.hpp"

namespace taut::app {
namespace {

using renderer::WindowEvent;

// Limits on what a session may ask for, so that a damaged one ends with an error.
constexpr int most_frames = 1000000;
constexpr int largest_side_px = 16384;

// The words of one line, and where it stands.
class Line {
 public:
  Line(const std::string& file, int number, const std::string& text)
      : file_(file), number_(number), text_(text), words_(text) {
    words_ >> verb_;
  }

  const std::string& verb() const { return verb_; }

  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(file_ + ':' + std::to_string(number_) + ": found '" + text_ + "', expected " + expected);
  }

  std::string word(const char* expected) {
    std::string found;
    if (!(words_ >> found)) {
      fail(expected);
    }
    return found;
  }

  // All that follows, spaces included: a path.
  std::string rest(const char* expected) {
    std::string found;
    std::getline(words_ >> std::ws, found);
    if (found.empty()) {
      fail(expected);
    }
    return found;
  }

  // The whole of a text.
  template <class Number, class... Base>
  Number parsed(const std::string& text, const char* expected, Base... base) const {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, base...);
    if (error != std::errc() || stop != end) {
      fail(expected);
    }
    return value;
  }

  template <class Number>
  Number number(const char* expected, Number lowest, Number highest) {
    const auto value = parsed<Number>(word(expected), expected);
    if (!(value >= lowest && value <= highest)) {
      fail(expected);
    }
    return value;
  }

  bool is_down(const char* expected) {
    const std::string found = word(expected);
    if (found != "down" && found != "up") {
      fail(expected);
    }
    return found == "down";
  }

  bool has_more() { return !(words_ >> std::ws).eof(); }

 private:
  const std::string& file_;
  int number_;
  const std::string& text_;
  std::istringstream words_;
  std::string verb_;
};

renderer::Resized read_size(Line& line, const char* expected) {
  const int width = line.number<int>(expected, 0, largest_side_px);
  return {width, line.number<int>(expected, 0, largest_side_px)};
}

WindowEvent read_resize(Line& line) {
  return read_size(line, "resize WIDTH HEIGHT in pixels");
}

WindowEvent read_key(Line& line) {
  constexpr const char* expected = "key NAME down|up, with a name such as space, a, f12, left";
  const std::optional<int> key = key_named(line.word(expected));
  if (!key) {
    line.fail(expected);
  }
  return renderer::KeyChanged{*key, line.is_down(expected)};
}

WindowEvent read_button(Line& line) {
  constexpr const char* expected = "button left|right|middle down|up";
  const std::string name = line.word(expected);
  if (name != "left" && name != "right" && name != "middle") {
    line.fail(expected);
  }
  const auto button = name == "left"    ? renderer::PointerButton::left
                      : name == "right" ? renderer::PointerButton::right
                                        : renderer::PointerButton::middle;
  return renderer::ButtonChanged{button, line.is_down(expected)};
}

WindowEvent read_text(Line& line) {
  constexpr const char* expected = "text U+0041, the number of a character";
  const std::string word = line.word(expected);
  const auto code =
      line.parsed<std::uint32_t>(word.substr(std::min<std::size_t>(2, word.size())), expected, 16);
  if (!word.starts_with("U+") || code > 0x10FFFF) {
    line.fail(expected);
  }
  return renderer::TextTyped{code};
}

std::optional<SessionEvent> read_event(Line& line) {
  constexpr double far_px = 1e6;
  const std::string& verb = line.verb();
  if (verb == "key") return read_key(line);
  if (verb == "button") return read_button(line);
  if (verb == "text") return read_text(line);
  if (verb == "drop") return WindowEvent(renderer::FileDropped{line.rest("drop PATH")});
  if (verb == "resize") return read_resize(line);
  if (verb == "lose-context") return ContextLost{};
  if (verb == "scale") return WindowEvent(renderer::ScaleChanged{line.number("scale 0.25 to 8", 0.25, 8.0)});
  if (verb == "move") {
    const double x = line.number("move X Y in pixels", -far_px, far_px);
    return WindowEvent(renderer::PointerMoved{x, line.number("move X Y in pixels", -far_px, far_px)});
  }
  if (verb == "wheel") {
    const double x = line.number("wheel X Y in notches", -far_px, far_px);
    return WindowEvent(renderer::WheelTurned{x, line.number("wheel X Y in notches", -far_px, far_px)});
  }
  if (verb == "at") {
    PointAt point{line.word("at ITEM X Y")};
    point.x = line.number("at ITEM X Y, with X and Y across it from 0 to 1", -10.0, 10.0);
    point.y = line.number("at ITEM X Y, with X and Y across it from 0 to 1", -10.0, 10.0);
    return point;
  }
  return std::nullopt;
}

bool read_start(Line& line, SessionStart& start) {
  if (line.verb() == "scene") {
    start.scene = line.rest("scene SCENE");
  } else if (line.verb() == "set") {
    start.overrides.push_back(parse_override(line.rest("set KEY=VALUE")));
  } else if (line.verb() == "compare") {
    constexpr const char* expected = "compare SOLVER, such as provot";
    start.compared_with = solver_named(line.word(expected));
    if (!start.compared_with) {
      line.fail(expected);
    }
  } else if (line.verb() == "window") {
    constexpr const char* expected = "window WIDTH HEIGHT SCALE";
    start.size = read_size(line, expected);
    start.scale = line.number(expected, 0.25, 8.0);
  } else {
    return false;
  }
  return true;
}

class Parser {
 public:
  void read(Line& line) {
    const std::string& verb = line.verb();
    if (verb == "frame") {
      const int count = line.has_more() ? line.number("frame COUNT", 1, most_frames) : 1;
      frames_in_file_ += count;
      if (frames_in_file_ > most_frames) {
        line.fail("no more than a million frames");
      }
      for (int i = 0; i < count; ++i) {
        finish_frame();
      }
    } else if (verb == "paced") {
      constexpr const char* expected = "paced SECONDS ADVANCES SNAPSHOT";
      frame_.elapsed_s = line.number(expected, 0.0, 1e6);
      frame_.pace.emplace();
      frame_.pace->advances = line.number<std::uint64_t>(expected, 0, UINT64_MAX);
      frame_.pace->shown = line.number<std::uint64_t>(expected, 0, UINT64_MAX);
      finish_frame();
    } else if (verb == "state") {
      if (session_.frames.empty() || !frame_.events.empty()) {
        line.fail("state after a frame");
      }
      constexpr const char* expected = "state and 16 hexadecimal digits";
      session_.frames.back().expected_state = line.parsed<std::uint64_t>(line.word(expected), expected, 16);
    } else if (auto event = read_event(line)) {
      frame_.events.push_back(std::move(*event));
    } else if (!session_.frames.empty() || !read_start(line, session_.start)) {
      line.fail(
          "an event, frame, paced or state; scene, set, compare and window stand before the first frame");
    }
  }

  // Events that no frame follows get one.
  Session finish() {
    if (!frame_.events.empty()) {
      finish_frame();
    }
    return std::move(session_);
  }

 private:
  void finish_frame() {
    session_.frames.push_back(std::move(frame_));
    frame_ = {};
  }

  Session session_;
  SessionFrame frame_;
  int frames_in_file_ = 0;
};

}  // namespace

Session parse_session(const std::string& text, const std::string& name) {
  std::istringstream lines(text);
  std::string content;
  Parser parser;
  int number = 0;
  while (std::getline(lines, content)) {
    ++number;
    Line line(name, number, content);
    if (number == 1) {
      if (content != "taut-session 1") {
        line.fail("taut-session 1");
      }
    } else if (!line.verb().empty() && line.verb().front() != '#') {
      parser.read(line);
    }
  }
  if (number == 0) {
    throw InputError(name + ": is empty, expected taut-session 1");
  }
  return parser.finish();
}

}  // namespace taut::app
