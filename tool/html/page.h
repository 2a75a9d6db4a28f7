// Assembly of a self-contained page: template, style, scripts, chart library and data.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace symreal::tool {

std::string page(std::string const &title, nlohmann::ordered_json const &data);

} // namespace symreal::tool
