// A folder that is written as a whole.
#pragma once

#include "tool/output/outputs.h"

#include <string>
#include <vector>

namespace symreal::tool {

// Its path, without a slash at the end.
std::string folder_path(std::string const &given);

// Fails unless the files may stand in the folder: it is not there, is empty, or is what Symreal wrote for the same
// kernel. The first file tells that by its first line.
void require_folder(std::string const &folder, std::vector<OutputFile> const &files);

// A new folder appears with all of its files or not at all.
void write_folder(std::string const &folder, std::vector<OutputFile> const &files);

} // namespace symreal::tool
