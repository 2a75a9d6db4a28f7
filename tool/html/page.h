// Assembly of a self-contained page: template, style, scripts, chart library and data.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace symreal::tool {

std::string page(std::string const &title, nlohmann::ordered_json const &data);

// File of the page, which CMake embeds into the tool (cmake/embed.cmake).
struct Asset {
  std::string_view name; // "page/report.css"
  std::string_view text;
};

// All assets, the template first.
std::span<Asset const> assets();

} // namespace symreal::tool
