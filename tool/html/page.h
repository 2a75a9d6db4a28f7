// Assembly of a self-contained page: template, style, scripts, chart library and data.
#pragma once

#include "engine/support/asset.h"

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

namespace symreal::tool {

std::string page(std::string const &title, nlohmann::ordered_json const &data);

// The page's files, the template first.
std::span<Asset const> assets();

} // namespace symreal::tool
