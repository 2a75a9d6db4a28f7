// Forms of `verify` that run nothing: results of shards are merged, or object code is compared.
#pragma once

#include "tool/commands/subcommands.h"
#include "tool/options/recording_options.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace symreal::tool {

void print_json(nlohmann::ordered_json const &kernels);

// Joins the results of all shards of a verification. Returns the exit status.
int merge_shards(std::vector<std::string> const &files, bool as_json, CLI::App const &command, Session const &session);

// Compares object code before and after rewriting. Returns the exit status.
int compare_numeric(std::vector<std::string> const &files, std::string const &c_compiler, SourceOptions &source,
                    CLI::App &command, Session &session);

} // namespace symreal::tool
