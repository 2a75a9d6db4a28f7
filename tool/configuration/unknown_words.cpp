#include "tool/configuration/unknown_words.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace symreal::tool {
namespace {

using Words = std::vector<std::string>;

// Edit distance: letters added, dropped or changed.
std::size_t distance(std::string const &one, std::string const &other) {
  std::vector<std::size_t> row(other.size() + 1);
  for (std::size_t k = 0; k < row.size(); ++k) row[k] = k;
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t before = row[0]++;
    for (std::size_t k = 0; k < other.size(); ++k) {
      std::size_t const replaced = before + (one[i] == other[k] ? 0 : 1);
      before = row[k + 1];
      row[k + 1] = std::min({replaced, row[k] + 1, before + 1});
    }
  }
  return row.back();
}

std::string name_of(std::string const &word) { return word.substr(0, word.find('=')); }

bool has(CLI::App const &command, std::string const &option) { return command.get_option_no_throw(option) != nullptr; }

Words options_of(CLI::App const &command) {
  Words names;
  for (CLI::Option const *option : command.get_options())
    if (std::string const name = option->get_name(); name.starts_with("-")) names.push_back(name);
  return names;
}

std::string explain_option(std::string const &option, CLI::App const &command, CLI::App const &app) {
  if (command.get_name() == "verify" && has(*app.get_subcommand("generate"), option))
    return fmt::format("verify does not take {}: it uses what the generated file was made with", option);
  Words others;
  for (CLI::App const *other : app.get_subcommands({}))
    if (has(*other, option)) others.push_back(other->get_name());
  if (!others.empty())
    return fmt::format("{} is an option of {}, not of {}", option, fmt::join(others, ", "), command.get_name());
  std::string const meant = nearest(option, options_of(command));
  return fmt::format("{} is not an option of {}{}", option, command.get_name(),
                     meant.empty() ? "" : fmt::format("; did you mean {}?", meant));
}

} // namespace

std::string nearest(std::string const &word, Words const &list) {
  std::size_t least = 1 + word.size() / 3;
  std::string found;
  for (std::string const &one : list)
    if (std::size_t const far = distance(word, one); far <= least && (found.empty() || far < least)) {
      least = far;
      found = one;
    }
  return found;
}

std::string did_you_mean(std::string const &word, std::string const &list) {
  Words words;
  std::istringstream in(list);
  for (std::string one; std::getline(in >> std::ws, one, ',');) words.push_back(one);
  std::string const meant = nearest(word, words);
  return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

std::string explain_unknown(CLI::App const &app, Words const &words) {
  if (words.empty() || words.front().starts_with("-")) return {};
  Words subcommands;
  for (CLI::App const *one : app.get_subcommands({})) subcommands.push_back(one->get_name());
  if (std::find(subcommands.begin(), subcommands.end(), words.front()) == subcommands.end()) {
    std::string const meant = nearest(words.front(), subcommands);
    return fmt::format("'{}' is not a subcommand; {}", words.front(),
                       meant.empty() ? fmt::format("there are: {}", fmt::join(subcommands, ", "))
                                     : fmt::format("did you mean '{}'?", meant));
  }
  CLI::App const &command = *app.get_subcommand(words.front());
  for (std::size_t k = 1; k < words.size(); ++k) {
    std::string const option = name_of(words[k]);
    bool const is_long = option.starts_with("--") && option.size() > 2;
    bool const is_short = option.size() == 2 && option[0] == '-';
    if (!is_long && !is_short) continue;
    if (!has(command, option)) return explain_option(option, command, app);
    if (words[k] == option && command.get_option(option)->get_items_expected_min() > 0) ++k; // skips the option's value
  }
  return {};
}

} // namespace symreal::tool
