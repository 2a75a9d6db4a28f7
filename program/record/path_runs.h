// Runs of the symbolic program: how it is told what to record, and runs along one path under policy explore.
#pragma once

#include "program/build/process.h"
#include "program/record/events.h"
#include "program/record/explore.h"
#include "program/record/record.h"

#include <string>

namespace symreal::program {

// The program records into the directory.
Command recording_command(std::string const &executable, RunOptions const &options, std::string const &directory);

// Whether the K-th kernel has decisions to explore, after the first run, in which the first kernel was on a path.
bool is_to_explore(Events const &first_run, std::size_t kernel);

// In seconds, after a first run that took so long. Where its values do not lead the program may go round for ever.
double path_time_limit(double first_run, RunOptions const &options);

// The program runs along this path of the K-th kernel, and ends there. `directory` is left for the next.
PathRun run_along(std::string const &path_variable, std::size_t kernel, std::string const &executable,
                  RunOptions const &options, std::string const &directory);

} // namespace symreal::program
