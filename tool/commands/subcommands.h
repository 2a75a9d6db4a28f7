// Subcommands: each is a source file and a row of subcommands.def, adds itself to the command line, and has a callback
// that runs it and sets the exit status.
#pragma once

#include "tool/options/source_options.h"

namespace symreal::tool {

// Exit statuses.
enum Status { clean = 0, error = 1, partly_skipped = 2, verification_failed = 3, out_of_date = 4 };

struct Session {
  CompilerFlags flags; // flags after --
  int status = clean;
  ConfiguredOptions configured = {}; // options set by the project's configuration
};

#define SUBCOMMAND(name) void add_##name(CLI::App &app, Session &session);
#include "tool/commands/subcommands.def"
#undef SUBCOMMAND

// Refuses compiler flags for a subcommand that compiles nothing.
void refuse_flags(Session const &session);

} // namespace symreal::tool
