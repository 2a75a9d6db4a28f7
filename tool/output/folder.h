// Output folders that are written as a whole.
#pragma once

#include "program/build/durable_files.h"
#include "tool/output/outputs.h"

#include <string>

namespace symreal::tool {

// Path of the folder without a trailing slash.
std::string folder_path(std::string const &given);

// Fails unless the folder is absent, empty, or written by Symreal for the same kernel, as the first line of its first
// file tells.
void require_folder(OutputFolder const &folder);

// Stages the files; a new folder appears with all of them at once.
void stage_folder(OutputFolder const &folder, program::StagedFiles &staged);

} // namespace symreal::tool
