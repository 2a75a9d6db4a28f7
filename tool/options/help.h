// Layout of --help: options in groups, two examples a subcommand. The table is help.def.
#pragma once

#include <CLI/CLI.hpp>

namespace symreal::tool {

void arrange_help(CLI::App &app);

} // namespace symreal::tool
