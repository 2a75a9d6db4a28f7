// Where a compiler looks for headers, when there are rewritten ones.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// The flags with the counterpart of each search directory, if it has one, before it, so that the order of the search
// stays, and with that of each header that they include. `searched` receives the directories as the flags name them.
std::vector<std::string>
search_flags(std::vector<std::string> const &flags,
             std::function<std::optional<std::string>(std::string const &name)> const &counterpart,
             std::vector<std::string> &searched);

} // namespace symreal::program
