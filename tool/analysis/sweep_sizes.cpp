#include "tool/analysis/sweep_table.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace symreal::tool {

namespace {

[[noreturn]] void refuse(std::string const &text) {
  fail(DiagnosticId::bad_option, {},
       "--sweep takes NAME=FIRST..LAST, NAME=FIRST..LAST:STEP or NAME=VALUE,VALUE,..., not '" + text + "'");
}

long number(std::string_view word, std::string const &text) {
  long value = 0;
  auto const [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failed != std::errc() || end != word.data() + word.size()) refuse(text);
  return value;
}

bool is_name(std::string_view word) {
  auto const fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !word.empty() && !std::isdigit(static_cast<unsigned char>(word[0])) && std::ranges::all_of(word, fits);
}

} // namespace

SweepSizes parse_sweep(std::string const &text) {
  constexpr std::size_t most = 1000;
  std::size_t const equals = std::min(text.find('='), text.size() - 1);
  SweepSizes result{text.substr(0, equals), {}};
  if (!is_name(result.name)) refuse(text);
  std::string_view rest = std::string_view(text).substr(equals + 1);
  if (std::size_t const dots = rest.find(".."); dots != rest.npos) {
    std::size_t const colon = rest.find(':');
    long const first = number(rest.substr(0, dots), text);
    long const last = number(rest.substr(dots + 2, colon == rest.npos ? colon : colon - dots - 2), text);
    long const step = colon == rest.npos ? 1 : number(rest.substr(colon + 1), text);
    if (step < 1 || last < first || last - first > (1L << 32)) refuse(text);
    for (long value = first; value <= last && result.values.size() <= most; value += step)
      result.values.push_back(value);
  } else {
    for (std::size_t end = 0; end != rest.npos; rest.remove_prefix(std::min(end, rest.size() - 1) + 1)) {
      end = rest.find(',');
      result.values.push_back(number(rest.substr(0, end), text));
    }
    std::ranges::sort(result.values);
  }
  if (std::ranges::adjacent_find(result.values) != result.values.end()) refuse(text);
  if (result.values.size() < 2) fail(DiagnosticId::bad_option, {}, "--sweep needs two sizes at least: '" + text + "'");
  if (result.values.size() > most)
    fail(DiagnosticId::bad_option, {}, fmt::format("--sweep records each size: more than {} are too many", most));
  return result;
}

} // namespace symreal::tool
