// --depfile: what a result depends on, as a rule of make.
//
// A file that is there is a prerequisite with an empty rule of its own, so that its removal leads to a new run and not
// to the end of the build: sources and headers, the configuration, what options name, what the recorded program opened,
// the compilers, and Symreal itself. A file that was asked for and is absent cannot be one in the form that make, ninja
// and CMake share. There its directory stands for it. A rule whose name ends in .mk is for GNU make alone, which looks
// for the file itself: $(wildcard ...). That form also has the .symreal.yaml that is not there.
#pragma once

#include "program/record/front.h"
#include "tool/options/project_options.h"

#include <string>

namespace symreal::tool {

std::string dependencies(std::string const &depfile, std::string const &target, program::Front const &front,
                         program::FrontRequest const &request, ProjectOptions const &project);

// Where --depfile lacks what the system does not tell: unseen_files.
void warn_of_unseen(std::string const &depfile);

} // namespace symreal::tool
