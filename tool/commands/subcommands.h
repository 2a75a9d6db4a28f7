// One subcommand a file. Each adds itself to the command line; its callback runs it and sets the exit status.
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

void add_scan(CLI::App &app, Session &session);
void add_generate(CLI::App &app, Session &session);
void add_record(CLI::App &app, Session &session);
void add_verify(CLI::App &app, Session &session);
void add_rewrite(CLI::App &app, Session &session);
void add_undo(CLI::App &app, Session &session);
void add_opt(CLI::App &app, Session &session);
void add_explain(CLI::App &app, Session &session);
void add_cache(CLI::App &app, Session &session);

// Compiler flags given to a subcommand that compiles nothing would do nothing.
void refuse_flags(Session const &session);

} // namespace symreal::tool
