// What a word of the command line that is not understood may have been meant for.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

// The word of the list that differs least from `word`; empty where none is near.
std::string nearest(std::string const &word, std::vector<std::string> const &list);

// "; did you mean 'roots'?" for a word that is near to one of the list, which commas separate; else nothing.
std::string did_you_mean(std::string const &word, std::string const &list);

// `words` follow the program's name, up to `--`. What to say of the first that names no subcommand, or no option of the
// subcommand; empty where there is none.
std::string explain_unknown(CLI::App const &app, std::vector<std::string> const &words);

} // namespace symreal::tool
