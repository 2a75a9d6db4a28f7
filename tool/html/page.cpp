#include "tool/html/page.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

std::string escaped_html(std::string_view text) {
  std::string result;
  for (char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

// JSON for a <script> element: escapes "<", which occurs in strings only and would end the script or begin a comment.
// Replaces invalid UTF-8.
std::string script_json(nlohmann::ordered_json const &data) {
  std::string const text = data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string result;
  result.reserve(text.size());
  for (char c : text)
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

std::string content_of(std::string_view place, std::string const &title, nlohmann::ordered_json const &data) {
  if (place == "title") return escaped_html(title);
  if (place == "data") return script_json(data);
  auto const asset = std::ranges::find(assets(), place, &Asset::name);
  internal_check(asset != assets().end());
  return std::string(asset->text);
}

} // namespace

std::string page(std::string const &title, nlohmann::ordered_json const &data) {
  std::string_view rest = assets().front().text; // the template, with placeholders {{name}}
  std::string text;
  for (std::size_t begin; (begin = rest.find("{{")) != rest.npos;) {
    std::size_t const end = rest.find("}}", begin);
    text += rest.substr(0, begin);
    text += content_of(rest.substr(begin + 2, end - begin - 2), title, data);
    rest = rest.substr(end + 2);
  }
  return text.append(rest);
}

} // namespace symreal::tool
