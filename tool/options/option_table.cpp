#include "tool/options/option_table.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

namespace symreal::tool {
namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

struct Help {
  std::map<std::string, std::string> titles;   // by option, or by "SUBCOMMAND OPTION" if that subcommand has its own
  std::map<std::string, std::string> examples; // by subcommand, in the spelling of the table
};

Help read_table() {
  Help help;
  auto const add = [&](std::string const &before, char const *title, char const *options) {
    for (std::string const &word : words_of(options)) help.titles[before + word] = title;
  };
#define GROUP(title, options) add("", title, options);
#define GROUP_IN(subcommand, title, options) add(#subcommand " ", title, options);
#define EXCLUDES(...)
#define NEEDS(...)
#define EXAMPLE(subcommand, command, purpose) help.examples[#subcommand] += "\n  " command "\n      " purpose;
#include "tool/options/option_table.def"
#undef GROUP
#undef GROUP_IN
#undef EXCLUDES
#undef NEEDS
#undef EXAMPLE
  return help;
}

// A row EXCLUDES or NEEDS.
struct Pairs {
  std::string_view subcommands, options, others; // words
  bool are_excluded;                             // false: needed
  DiagnosticId id;
  std::string_view message; // {}: the option that is too much or lacks the other
};

// Is the option given, as in --debug=values with this word? Not if it is a flag that is set to false, or an empty word.
bool is_given(CLI::App const &command, std::string const &name) {
  std::size_t const end = std::min(name.find('='), name.size());
  CLI::Option const *const option = command.get_option_no_throw(name.substr(0, end));
  if (!option || option->count() == 0) return false;
  if (end != name.size()) {
    std::vector<std::string> const words = option->as<std::vector<std::string>>();
    return std::ranges::find(words, name.substr(end + 1)) != words.end();
  }
  bool const is_flag = option->get_items_expected_max() == 0;
  return is_flag ? option->as<bool>() : option->results() != std::vector<std::string>{""};
}

} // namespace

void arrange_help(CLI::App &app) {
  Help const help = read_table();
  for (CLI::App *command : app.get_subcommands({})) {
    std::string name = command->get_name();
    for (CLI::Option *option : command->get_options()) {
      auto found = help.titles.find(name + " " + option->get_name());
      if (found == help.titles.end()) found = help.titles.find(option->get_name());
      if (found != help.titles.end()) option->group(found->second);
    }
    std::ranges::replace(name, '-', '_');
    if (auto const found = help.examples.find(name); found != help.examples.end())
      command->footer("Examples:" + found->second);
  }
}

void require_compatible(CLI::App const &command) {
  static constexpr Pairs table[] = {
#define GROUP(...)
#define GROUP_IN(...)
#define EXAMPLE(...)
#define EXCLUDES(subcommands, options, others, id, message)                                                            \
  {subcommands, options, others, true, DiagnosticId::id, message},
#define NEEDS(subcommands, options, others, id, message)                                                               \
  {subcommands, options, others, false, DiagnosticId::id, message},
#include "tool/options/option_table.def"
#undef GROUP
#undef GROUP_IN
#undef EXAMPLE
#undef EXCLUDES
#undef NEEDS
  };
  for (Pairs const &row : table) {
    if (std::vector<std::string> const all = words_of(row.subcommands);
        std::ranges::find(all, command.get_name()) == all.end())
      continue;
    for (std::string const &option : words_of(row.options))
      for (std::string const &other : words_of(row.others))
        if (is_given(command, option) && is_given(command, other) == row.are_excluded)
          fail(row.id, {}, fmt::format(fmt::runtime(row.message), row.are_excluded ? other : option));
  }
}

void require_one_of(std::string const &option, std::string const &value, std::string_view words) {
  for (std::string_view rest = words; !rest.empty();) {
    std::size_t end = rest.find('|');
    if (rest.substr(0, end) == value) return;
    rest = end == rest.npos ? "" : rest.substr(end + 1);
  }
  fail(DiagnosticId::bad_option, {}, option + " takes " + std::string(words) + ", not '" + value + "'");
}

} // namespace symreal::tool
