// Suggestions for unknown words of the command line.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

// The word of the list nearest to `word`; empty if none is near.
std::string nearest(std::string const &word, std::vector<std::string> const &list);

// "; did you mean 'roots'?" if the comma-separated list has a near word; else empty.
std::string did_you_mean(std::string const &word, std::string const &list);

// Message about the first unknown subcommand or option of the subcommand; empty if all words are known. `words`: words
// after the program's name, up to `--`.
std::string explain_unknown(CLI::App const &app, std::vector<std::string> const &words);

} // namespace symreal::tool
