#include "engine/diagnostics/diagnostic.h"
#include "program/build/cache_directory.h"
#include "tool/commands/subcommands.h"

#include <fmt/format.h>
#include <iostream>
#include <memory>

namespace symreal::tool {
namespace {

void show(char const *what, program::CacheContents const &contents, std::string const &directory) {
  std::cout << fmt::format("{}{} objects and programs, {:.1f} MB, in {}\n", what, contents.files,
                           static_cast<double>(contents.bytes) / 1e6, directory);
}

} // namespace

void add_cache(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("cache", "Show the size and path of the cache, or clear it");
  auto clear = std::make_shared<bool>(false);
  command->add_flag("--clear", *clear, "Remove it");
  command->callback([clear, &session] {
    refuse_flags(session);
    std::string const directory = program::usual_cache_directory();
    if (directory.empty())
      fail(DiagnosticId::bad_option, {}, "there is no cache: neither XDG_CACHE_HOME nor HOME is set");
    if (*clear)
      show("removed ", program::clear_cache(directory), directory);
    else
      show("", program::cache_contents(directory), directory);
  });
}

} // namespace symreal::tool
