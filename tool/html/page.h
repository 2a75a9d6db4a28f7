// One self-contained page: the template, its style, its scripts, the chart library and the data.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace symreal::tool {

std::string page(std::string const &title, nlohmann::ordered_json const &data);

} // namespace symreal::tool
