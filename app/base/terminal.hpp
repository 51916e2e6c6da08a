#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Returns the environment variable COLUMNS, or else the columns of the terminal that a file descriptor writes to;
/// `otherwise` if it is none.
std::size_t terminal_columns(int file_descriptor, std::size_t otherwise);

/// Returns the start of a line in UTF-8 that has at most so many bytes, without a part of a letter.
std::string_view cut_line(std::string_view line, std::size_t bytes);

/// Breaks lines between words, if they have more columns. Lines that continue another begin below the second column of
/// an option's line, which two blanks separate from the first, or else below the line's first word.
std::string wrap_lines(std::string_view text, std::size_t columns);

}  // namespace taut::app
