// A subcommand is a file and a row of subcommands.def. It adds itself to the command line; its callback runs it and
// sets the exit status.
#pragma once

#include "tool/options/options.h"

namespace symreal::tool {

// Exit statuses.
enum Status { clean = 0, error = 1, partly_skipped = 2, verification_failed = 3, out_of_date = 4 };

struct Session {
  CompilerFlags flags; // what stood after --
  int status = clean;
  ConfiguredOptions configured = {}; // options that the project's configuration gave
};

#define SUBCOMMAND(name) void add_##name(CLI::App &app, Session &session);
#include "tool/commands/subcommands.def"
#undef SUBCOMMAND

// Compiler flags given to a subcommand that compiles nothing would do nothing.
void refuse_flags(Session const &session);

} // namespace symreal::tool
