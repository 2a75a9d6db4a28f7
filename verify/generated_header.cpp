#include "verify/generated_header.h"

#include "engine/emit/language/banner.h"
#include "engine/emit/languages/languages.h"
#include "engine/emit/print/emission.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/support/files.h"
#include "engine/support/mutation/is_dropped.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string_view>
#include <vector>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

struct Token {
  std::string_view text;
  std::size_t line;
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

// Offset behind the next occurrence of `end`, or the end of the text.
std::size_t end_of(std::string_view text, std::string_view end) {
  std::size_t const at = text.find(end, 1);
  return at == text.npos ? text.size() : at + end.size();
}

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t line = 1;
  while (!text.empty()) {
    std::size_t length = 1;
    bool const is_comment = text.starts_with("/*") || text.starts_with("//");
    if (is_comment)
      length = text[1] == '*' ? end_of(text.substr(1), "*/") + 1 : std::min(text.find('\n'), text.size());
    else if (text[0] == '"')
      length = end_of(text, "\"");
    else if (is_word(text[0]))
      length = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_word) - text.begin());
    std::string_view const token = text.substr(0, length);
    // Blanks are dropped; a backslash that joins lines stays a token.
    if (!is_comment && !std::isspace(static_cast<unsigned char>(token[0]))) tokens.push_back({token, line});
    line += static_cast<std::size_t>(std::ranges::count(token, '\n'));
    text.remove_prefix(length);
  }
  return tokens;
}

// Name of the include guard, which is derived from the file's name.
std::string_view guard_of(std::vector<Token> const &tokens) {
  for (std::size_t k = 0; k + 2 < tokens.size(); ++k)
    if (tokens[k].text == "#" && tokens[k + 1].text == "ifndef") return tokens[k + 2].text;
  return {};
}

std::string line_of(std::string_view text, std::size_t line) {
  for (; line > 1; --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  text = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return std::string(text);
}

// The kernel as it was generated, reduced to the parts that a header shows.
Graph shown_of(Graph const &recorded, Banner const &banner) {
  std::optional<Graph> differentiated;
  if (!banner.derivatives.empty()) {
    differentiated = differentiate(recorded, banner.derivatives, [](Diagnostic const &) {});
    if (!banner.has_values) differentiated = derivatives_of(std::move(*differentiated), recorded.outputs.size());
  }
  Graph shown = without_nodes(differentiated ? *differentiated : recorded);
  shown.guards.resize(banner.guards, Guard{0, no_location, "a condition"});
  return shown;
}

std::string generated_text(std::string const &generated, Banner const &banner, Graph const &shown) {
  Language const &usual = *find_language(is_generated_cpp(generated) ? "cpp" : "c");
  Language const language = banner.is_single ? in_single_precision(usual) : usual;
  Plan plan{};
  plan.graph = &shown;
  plan.constant_count = banner.constants;
  EmitOptions options;
  options.base_name = fs::path(generated).stem().string();
  options.prefix = banner.prefix;
  options.mode = banner.mode;
  options.is_single = banner.is_single;
  Emission const emission{plan, language, options};
  auto const &companions = language.files.companions;
  return std::ranges::find(companions, "", &Companion::option)->text(emission);
}

[[noreturn]] void refuse(std::string const &header, std::size_t line, std::string const &why) {
  fail(DiagnosticId::header_differs, {header, static_cast<unsigned>(line), 1}, why);
}

} // namespace

std::string header_of(std::string const &generated) {
  return fs::path(generated).replace_extension(is_generated_cpp(generated) ? ".hpp" : ".h").string();
}

bool require_header(std::string const &generated, Banner const &banner, Graph const &recorded) {
  std::string const header = header_of(generated);
  if (!fs::exists(header)) return false;
  if (is_dropped("SYM188")) return true;
  std::string const there = read_file(header);
  if (banner_of(there) != banner_of(read_file(generated)))
    refuse(header, 1, "this header was generated with other code than '" + generated + "'");
  std::string const wanted = generated_text(generated, banner, shown_of(recorded, banner));
  std::vector<Token> const found = tokens_of(there), expected = tokens_of(wanted);
  std::string_view const own_guard = guard_of(found), usual_guard = guard_of(expected);
  auto const is_same = [&](Token const &one, Token const &other) {
    return one.text == other.text || (one.text == own_guard && other.text == usual_guard);
  };
  auto const [here, there_too] = std::ranges::mismatch(found, expected, is_same);
  if (here == found.end() && there_too == expected.end()) return true;
  if (here == found.end())
    refuse(header, found.empty() ? 1 : found.back().line,
           fmt::format("the header ends before '{}'", line_of(wanted, there_too->line)));
  refuse(header, here->line,
         fmt::format("the header has '{}' where the recorded kernel gives {}", line_of(there, here->line),
                     there_too == expected.end() ? "nothing" : "'" + line_of(wanted, there_too->line) + "'"));
}

} // namespace symreal::program
