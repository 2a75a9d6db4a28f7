// A folder that is written as a whole.
#pragma once

#include "program/build/durable_files.h"
#include "tool/output/outputs.h"

#include <string>

namespace symreal::tool {

// Its path, without a slash at the end.
std::string folder_path(std::string const &given);

// Fails unless the files may stand in the folder: it is not there, is empty, or is what Symreal wrote for the same
// kernel. The first file tells that by its first line.
void require_folder(OutputFolder const &folder);

// A folder that is not there appears with all of its files at once.
void stage_folder(OutputFolder const &folder, program::StagedFiles &staged);

} // namespace symreal::tool
