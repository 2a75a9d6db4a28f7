// Writer of ZIP archives in memory.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace symreal::tool {

// Bytes of an archive of these files (name, content). Equal files give equal bytes: time stamps are fixed.
std::string archive(std::vector<std::pair<std::string, std::string>> const &files);

} // namespace symreal::tool
