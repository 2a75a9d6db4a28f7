// --depfile: dependencies of a result, as a make rule.
//
// An existing file is a prerequisite with an empty rule of its own, so that its removal causes a new run instead of an
// error: sources and headers, the configuration, files that options name or that the recorded program opened, the
// compilers, and Symreal itself. An absent file cannot be a prerequisite in the dialect shared by make, ninja and
// CMake; its directory replaces it. A rule whose name ends in .mk is for GNU make, which looks for the file itself:
// $(wildcard ...). The .mk form also covers absent .symreal.yaml files.
#pragma once

#include "program/record/front.h"
#include "tool/options/source_options.h"

#include <string>

namespace symreal::tool {

std::string dependencies(std::string const &depfile, std::string const &target, program::Front const &front,
                         program::FrontRequest const &request, ProjectOptions const &project);

// Warns (unseen_files) if the system could not observe opened files, so that --depfile is incomplete.
void warn_of_unseen(std::string const &depfile);

} // namespace symreal::tool
