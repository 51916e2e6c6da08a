#include <gtest/gtest.h>

#include <filesystem>

#include "app/base/errors.hpp"
#include "app/viewer/session/input_queue.hpp"
#include "app/viewer/session/session.hpp"

namespace taut::app {
namespace {

using renderer::ButtonChanged;
using renderer::KeyChanged;
using renderer::PointerButton;
using renderer::PointerMoved;
using renderer::WindowEvent;

std::string message_of(const std::string& text) {
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
          PointAt{"wind.speed", 0.25, 0.75},
          ContextLost{}};
}

TEST(Session, WhatIsWrittenReadsBackTheSame) {
  SessionFrame paced{one_of_each(), 0.016683333333333332, Pace{12, 34}, 0x0123456789abcdefU};
  SessionFrame plain{{WindowEvent(PointerMoved{3.0, 4.0})}, 1.0 / 60.0, std::nullopt, std::nullopt};
  SessionStart start;
  start.scene = "a scene.toml";
  start.overrides = {parse_override("wind.speed=4")};
  start.size = {640, 480};
  start.scale = 1.5;

  const Session read =
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

TEST(Session, EveryKeyReadsBackTheSame) {
  for (int key = 0; key <= renderer::keys::last; ++key) {
    const SessionFrame frame{{WindowEvent(KeyChanged{key, true})}, 1.0 / 60.0, std::nullopt, std::nullopt};
    const Session read = parse_session("taut-session 1\n" + session_lines(frame), "s.txt");
    EXPECT_EQ(read.frames.front(), frame) << key;
  }
}

TEST(Session, CountsFramesAndGivesLastEventsOne) {
  const Session read = parse_session("taut-session 1\n# a remark\n\nframe 3\nkey h down\n", "s.txt");
  ASSERT_EQ(read.frames.size(), 4U);
  EXPECT_TRUE(read.frames[2].events.empty());
  EXPECT_EQ(read.frames[3].events.size(), 1U);
}

TEST(Session, SaysWhereWhatIsWrong) {
  EXPECT_EQ(message_of(""), "s.txt: is empty, expected taut-session 1");
  EXPECT_EQ(message_of("taut-session 2\n"), "s.txt:1: found 'taut-session 2', expected taut-session 1");
  const std::string head = "taut-session 1\n";
  EXPECT_NE(message_of(head + "key nokey down\n").find("s.txt:2: found 'key nokey down', expected key"),
            std::string::npos);
  for (const char* line :
       {"key a",       "button up left", "move 1",  "move 1 x",      "wheel 1",   "drop",
        "resize -1 4", "resize 99999 4", "scale 0", "scale nan",     "at",        "at item 1",
        "text 41",     "text U+110000",  "frame 0", "frame 9999999", "paced 1 2", "state 12",
        "jump",        "move inf 0"}) {
    EXPECT_NE(message_of(head + line + '\n').find("s.txt:2: found '"), std::string::npos) << line;
  }
  EXPECT_NE(message_of(head + "frame\nscene x\n").find("s.txt:3"), std::string::npos);
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
