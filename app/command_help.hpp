#pragma once

#include <toml++/toml.h>

#include <CLI/CLI.hpp>

#include "prelude.hpp"

namespace taut::app {

/// Kinds that help texts name in braces, such as "{solvers}", with their lists of names.
using NameLists = std::span<const std::pair<const char*, std::string>>;

/// Gives each command and its options the texts of assets/texts/help.toml: purposes, names of values, groups, examples.
/// The help of a command is short, and complete in the modes `All` and `Sub`.
void add_help(CLI::App& command, const std::string& name, const toml::table& texts, NameLists lists);

/// Prints a text whose lines fit the terminal.
void print_help(const std::string& text);

}  // namespace taut::app
