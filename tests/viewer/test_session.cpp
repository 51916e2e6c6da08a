#include <gtest/gtest.h>

#include <filesystem>

#include "app/base/errors.hpp"
#include "app/viewer/session/session.hpp"

namespace taut::app {
namespace {

using renderer::ButtonChanged;
using renderer::KeyChanged;
using renderer::PointerButton;
using renderer::PointerMoved;
using renderer::WindowEvent;

std::string error_message(const std::string& text) {
  try {
    parse_session(text, "s.txt");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<SessionEvent> one_of_each() {
  return {WindowEvent(KeyChanged{'W', true}),
          WindowEvent(KeyChanged{renderer::keys::f12, false}),
          WindowEvent(KeyChanged{'#', true}),
          WindowEvent(renderer::TextTyped{U'\u00e9'}),
          WindowEvent(PointerMoved{0.1, -1234.5678901234567}),
          WindowEvent(ButtonChanged{PointerButton::middle, true}),
          WindowEvent(renderer::WheelTurned{-0.5, 1.0}),
          WindowEvent(renderer::FileDropped{"/a folder/with spaces.obj"}),
          WindowEvent(renderer::Resized{1, 1}),
          WindowEvent(renderer::ScaleChanged{1.25}),
          PointAt{"wind.speed", 0.25, 0.75}};
}

TEST(RecordedSession, WhatIsWrittenReadsBackTheSame) {
  SessionFrame paced{one_of_each(), 0.016683333333333332, Pace{12, 34}, 0x0123456789abcdefU};
  SessionFrame plain{{WindowEvent(PointerMoved{3.0, 4.0})}, 1.0 / 60.0, std::nullopt, std::nullopt};
  SessionStart start;
  start.scene = "a scene.toml";
  start.overrides = {parse_override("wind.speed=4")};
  start.size = {640, 480};
  start.scale = 1.5;

  const RecordedSession read =
      parse_session(session_head(start) + session_lines(paced) + session_lines(plain), "s.txt");
  EXPECT_EQ(read.start.scene, start.scene);
  ASSERT_EQ(read.start.overrides.size(), 1U);
  EXPECT_EQ(read.start.overrides[0].key, "wind.speed");
  EXPECT_EQ(read.start.size, start.size);
  EXPECT_EQ(read.start.scale, 1.5);
  ASSERT_EQ(read.frames.size(), 2U);
  EXPECT_EQ(read.frames[0], paced);
  EXPECT_EQ(read.frames[1], plain);
}

TEST(RecordedSession, EveryKeyReadsBackTheSame) {
  for (int key = 0; key <= renderer::keys::last; ++key) {
    const SessionFrame frame{{WindowEvent(KeyChanged{key, true})}, 1.0 / 60.0, std::nullopt, std::nullopt};
    const RecordedSession read = parse_session("[\"taut-session\", 2]\n" + session_lines(frame), "s.txt");
    EXPECT_EQ(read.frames.front(), frame) << key;
  }
}

TEST(RecordedSession, CountsFramesAndGivesLastEventsOne) {
  const RecordedSession read =
      parse_session("[\"taut-session\", 2]\n# a remark\n\n[\"frame\", 3]\n[\"key\", 72, true]\n", "s.txt");
  ASSERT_EQ(read.frames.size(), 4U);
  EXPECT_TRUE(read.frames[2].events.empty());
  EXPECT_EQ(read.frames[3].events.size(), 1U);
}

TEST(RecordedSession, SaysWhereWhatIsWrong) {
  EXPECT_EQ(error_message(""), R"(s.txt: is empty, expected ["taut-session", 2])");
  EXPECT_EQ(error_message("taut-session 1\n"), R"(s.txt:1: found 'taut-session 1', expected ["taut-session", 2])");
  EXPECT_EQ(error_message(R"(["taut-session", 3])"),
            R"(s.txt:1: found '["taut-session", 3]', expected ["taut-session", 2])");
  const std::string head = "[\"taut-session\", 2]\n";
  const std::string wrong_key = R"(["key", "h", true])";
  EXPECT_NE(error_message(head + wrong_key).find("s.txt:2: found '" + wrong_key + "', expected [\"key\", CODE"),
            std::string::npos);
  for (const char* line : {R"(["key", 65])",
                           R"(["key", 999, true])",
                           R"(["key", 65, 1])",
                           R"(["button", "up", true])",
                           R"(["move", 1])",
                           R"(["move", 1, "x"])",
                           R"(["move", 1, 2, 3])",
                           R"(["wheel", 1])",
                           R"(["drop"])",
                           R"(["drop", ""])",
                           R"(["resize", -1, 4])",
                           R"(["resize", 99999, 4])",
                           R"(["resize", 1.5, 4])",
                           R"(["scale", 0])",
                           R"(["scale", null])",
                           R"(["at"])",
                           R"(["at", "item", 1])",
                           R"(["text", -1])",
                           R"(["text", 1114112])",
                           R"(["frame", 0])",
                           R"(["frame", 9999999])",
                           R"(["paced", 1, 2])",
                           R"(["paced", 1, 2, 184467440737095516160])",
                           R"(["state", 12])",
                           R"(["set", "wind.speed", "4"])",
                           R"(["set", "=4"])",
                           R"(["jump"])",
                           R"(["move", 1e999, 0])",
                           R"([])",
                           R"({"move": [1, 2]})",
                           "frame 1"}) {
    EXPECT_NE(error_message(head + line + '\n').find("s.txt:2: found '"), std::string::npos) << line;
  }
  EXPECT_NE(error_message(head + "[\"frame\"]\n[\"scene\", \"x\"]\n").find("s.txt:3"), std::string::npos);
}

TEST(InputQueue, SpreadsAClickThatIsShorterThanAFrame) {
  InputQueue queue;
  queue.add(WindowEvent(PointerMoved{1, 1}));
  queue.add(WindowEvent(PointerMoved{2, 2}));
  queue.add(WindowEvent(ButtonChanged{PointerButton::left, true}));
  queue.add(WindowEvent(PointerMoved{3, 3}));
  queue.add(WindowEvent(ButtonChanged{PointerButton::left, false}));
  const std::vector<SessionEvent> first = {WindowEvent(PointerMoved{2, 2}),
                                           WindowEvent(ButtonChanged{PointerButton::left, true})};
  const std::vector<SessionEvent> second = {WindowEvent(PointerMoved{3, 3})};
  const std::vector<SessionEvent> third = {WindowEvent(ButtonChanged{PointerButton::left, false})};
  EXPECT_EQ(queue.take_frame(), first);
  EXPECT_EQ(queue.take_frame(), second);
  EXPECT_EQ(queue.take_frame(), third);
  EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, SpreadsAKeyThatGoesDownAndUp) {
  InputQueue queue;
  queue.add(WindowEvent(KeyChanged{'A', true}));
  queue.add(WindowEvent(KeyChanged{'B', true}));
  queue.add(WindowEvent(KeyChanged{'A', false}));
  EXPECT_EQ(queue.take_frame().size(), 2U);
  EXPECT_EQ(queue.take_frame().size(), 1U);
  EXPECT_TRUE(queue.take_frame().empty());
}

}  // namespace
}  // namespace taut::app
