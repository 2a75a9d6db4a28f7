#include "tool/options/help.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

namespace symreal::tool {
namespace {

// Group title by option, or by "SUBCOMMAND OPTION" if the option differs there.
std::map<std::string, std::string> titles() {
  std::map<std::string, std::string> result;
  auto const add = [&](std::string const &before, char const *title, char const *options) {
    std::istringstream words(options);
    for (std::string word; words >> word;) result[before + word] = title;
  };
#define GROUP(title, options) add("", title, options);
#define GROUP_IN(subcommand, title, options) add(#subcommand " ", title, options);
#define EXAMPLE(subcommand, command, purpose)
#include "tool/options/help.def"
#undef GROUP
#undef GROUP_IN
#undef EXAMPLE
  return result;
}

std::map<std::string, std::string> examples() {
  std::map<std::string, std::string> result;
#define GROUP(title, options)
#define GROUP_IN(subcommand, title, options)
#define EXAMPLE(subcommand, command, purpose) result[#subcommand] += "  " command "\n      " purpose "\n";
#include "tool/options/help.def"
#undef GROUP
#undef GROUP_IN
#undef EXAMPLE
  return result;
}

} // namespace

void arrange_help(CLI::App &app) {
  auto const title_of = titles();
  auto const example_of = examples();
  for (CLI::App *command : app.get_subcommands({})) {
    std::string name = command->get_name();
    for (CLI::Option *option : command->get_options()) {
      auto found = title_of.find(name + " " + option->get_name());
      if (found == title_of.end()) found = title_of.find(option->get_name());
      if (found != title_of.end()) option->group(found->second);
    }
    std::ranges::replace(name, '-', '_');
    if (auto const found = example_of.find(name); found != example_of.end())
      command->footer("Examples:\n" + found->second.substr(0, found->second.size() - 1));
  }
}

} // namespace symreal::tool
