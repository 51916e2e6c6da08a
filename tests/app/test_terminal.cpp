#include <gtest/gtest.h>

#include "app/base/terminal.hpp"

namespace taut::app {
namespace {

TEST(Terminal, LinesBreakBetweenWordsBelowTheirSecondColumn) {
  EXPECT_EQ(wrap_lines("short\n", 40), "short\n");
  EXPECT_EQ(wrap_lines("  --up AXIS    the direction that is up in the model\n\nlast", 40),
            "  --up AXIS    the direction that is up\n               in the model\n\nlast");
  EXPECT_EQ(wrap_lines("one two three four five six seven", 24), "one two three four five\nsix seven");
}

TEST(Terminal, AWordThatIsTooLongStaysWhole) {
  const std::string path(60, 'x');
  EXPECT_EQ(wrap_lines("a " + path + " b", 30), "a\n" + path + "\nb");
  EXPECT_EQ(wrap_lines(path, 10), path);
}

TEST(Terminal, ATextColumnThatWouldBeTooNarrowIsGivenUp) {
  EXPECT_EQ(wrap_lines("  an option that is long  its text of several words, more than twenty", 30),
            "  an option that is long  its\n  text of several words, more\n  than twenty");
  EXPECT_EQ(wrap_lines("  taut view              a window", 24), "  taut view\n  a window");
}

TEST(Terminal, ALineIsCutBetweenLetters) {
  EXPECT_EQ(cut_line("frame 7", 40), "frame 7");
  EXPECT_EQ(cut_line("frame 7", 5), "frame");
  EXPECT_EQ(cut_line("caf\xC3\xA9.obj", 4), "caf");
  EXPECT_EQ(cut_line("caf\xC3\xA9.obj", 5), "caf\xC3\xA9");
  EXPECT_EQ(cut_line("\xC3\xA9", 1), "");
}

TEST(Terminal, AFileHasTheColumnsOfTheEnvironment) {
  const int file = ::fileno(std::tmpfile());
  ::unsetenv("COLUMNS");
  EXPECT_EQ(terminal_columns(file, 77), 77U);
  ::setenv("COLUMNS", "40", 1);
  EXPECT_EQ(terminal_columns(file, 77), 40U);
  for (const char* nonsense : {"0", "", "-3", "wide"}) {
    ::setenv("COLUMNS", nonsense, 1);
    EXPECT_EQ(terminal_columns(file, 77), 77U) << nonsense;
  }
  ::unsetenv("COLUMNS");
}

}  // namespace
}  // namespace taut::app
