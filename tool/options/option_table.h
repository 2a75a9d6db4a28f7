// The table of options, option_table.def: their layout in --help, examples, and pairs that do not go together.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>

namespace symreal::tool {

// Puts the options of every subcommand in groups, and its examples below.
void arrange_help(CLI::App &app);

// Fails for options of this subcommand that exclude each other, and for one that lacks the other that it needs.
void require_compatible(CLI::App const &command);

// Fails unless `value` is one of the words, separated by '|'.
void require_one_of(std::string const &option, std::string const &value, std::string_view words);

} // namespace symreal::tool
