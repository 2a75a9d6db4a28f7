// verify --merge: joins the results of all shards of a verification.
#pragma once

#include "tool/commands/subcommands.h"

#include <string>
#include <vector>

namespace symreal::tool {

// `command`: verify, whose other options would have no effect. Returns the exit status.
int verify_merge(CLI::App const &command, std::vector<std::string> const &files, bool json, Session const &session);

} // namespace symreal::tool
