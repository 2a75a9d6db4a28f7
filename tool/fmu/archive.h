// A ZIP archive in memory.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace symreal::tool {

// The bytes of an archive of these files, names first. Equal files give equal bytes: no time stands in it.
std::string archive(std::vector<std::pair<std::string, std::string>> const &files);

} // namespace symreal::tool
