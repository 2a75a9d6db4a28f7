#include "tool/options/help.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

namespace symreal::tool {
namespace {

struct Help {
  std::map<std::string, std::string> titles;   // by option, or by "SUBCOMMAND OPTION" if that subcommand has its own
  std::map<std::string, std::string> examples; // by subcommand, in the spelling of the table
};

Help read_table() {
  Help help;
  auto const add = [&](std::string const &before, char const *title, char const *options) {
    std::istringstream words(options);
    for (std::string word; words >> word;) help.titles[before + word] = title;
  };
#define GROUP(title, options) add("", title, options);
#define GROUP_IN(subcommand, title, options) add(#subcommand " ", title, options);
#define EXAMPLE(subcommand, command, purpose) help.examples[#subcommand] += "\n  " command "\n      " purpose;
#include "tool/options/help.def"
#undef GROUP
#undef GROUP_IN
#undef EXAMPLE
  return help;
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

} // namespace symreal::tool
