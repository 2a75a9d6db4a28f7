// Runs of the symbolic program: commands that tell it what to record, and runs along one path under policy explore.
#pragma once

#include "program/build/process.h"
#include "program/record/events.h"
#include "program/record/explore.h"
#include "program/record/record.h"

#include <string>

namespace symreal::program {

// Command that makes the program record into the directory.
Command recording_command(std::string const &executable, RunOptions const &options, std::string const &directory);

// Does the K-th kernel have decisions to explore, by the first run, which had the first kernel on a path?
bool is_to_explore(Events const &first_run, std::size_t kernel);

// Time limit in seconds, given the time of the first run. A path against the program's values may loop for ever.
double path_time_limit(double first_run, RunOptions const &options);

// Runs the program along this path of the K-th kernel, where it ends. Leaves `directory` to the next run.
PathRun run_along(std::string const &path_variable, std::size_t kernel, std::string const &executable,
                  RunOptions const &options, std::string const &directory);

} // namespace symreal::program
