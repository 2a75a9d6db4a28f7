// Header search flags for compilations with rewritten headers.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// Inserts the counterpart of each search directory, if any, before it, so that the search order stays, and the
// counterpart of each -include header. `searched` receives the directories as the flags name them.
std::vector<std::string>
search_flags(std::vector<std::string> const &flags,
             std::function<std::optional<std::string>(std::string const &name)> const &counterpart,
             std::vector<std::string> &searched);

} // namespace symreal::program
