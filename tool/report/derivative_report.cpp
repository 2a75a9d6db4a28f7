#include "tool/report/derivative_report.h"

#include "engine/graph/names.h"
#include "engine/support/number.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <span>
#include <tuple>

namespace symreal::tool {
namespace {

using Element = program::DerivativeElement;
using Result = program::DerivativeResult;

std::size_t first_of(Result const &result, Object const &object) { return object.first - result.objects.front().first; }

// The element with the largest error; one that differs comes first.
std::size_t worst_of(Result const &result, Object const &object) {
  std::size_t const first = first_of(result, object);
  auto key = [&](std::size_t k) {
    Element const &element = result.elements[k];
    return std::tuple(element.different != 0, element.broken != 0, element.error);
  };
  std::size_t worst = first;
  for (std::size_t k = first; k < first + object.count; ++k)
    if (key(k) > key(worst)) worst = k;
  return worst;
}

std::string count_of(Result const &result, std::size_t Element::*samples) {
  auto const is_meant = [&](Element const &element) { return element.*samples != 0; };
  return fmt::format("{} of {} elements of derivatives", std::ranges::count_if(result.elements, is_meant),
                     result.elements.size());
}

Diagnostic mismatch(std::string const &file, std::string message, std::string note) {
  return {DiagnosticId::verification_mismatch, {file}, std::move(message), {{{}, std::move(note)}}};
}

std::optional<Diagnostic> off_differences(Result const &result, std::string const &file) {
  for (Object const &object : result.objects) {
    std::size_t const worst = worst_of(result, object);
    Element const &element = result.elements[worst];
    if (element.different != 0)
      return mismatch(file, count_of(result, &Element::different) + " differ from those of the original",
                      fmt::format("{}: {} give {}, generated {}, inputs {}", name_of(result, worst),
                                  element.is_by_differences ? "differences" : "dual numbers",
                                  shortest(element.expected), shortest(element.found),
                                  number_list(element.worst->inputs)));
  }
  return {};
}

std::optional<Diagnostic> off_formulas(Result const &result, std::string const &file) {
  auto const broken = std::ranges::find_if(result.elements, [](Element const &element) { return element.broken != 0; });
  if (broken == result.elements.end()) return {};
  auto const k = static_cast<std::size_t>(broken - result.elements.begin());
  return mismatch(file, count_of(result, &Element::broken) + " differ from their formulas before any pass",
                  fmt::format("{}: the formulas give {}, generated {}, inputs {}", name_of(result, k),
                              shortest(broken->promised), shortest(broken->given),
                              number_list(broken->first_broken->inputs)));
}

} // namespace

std::string name_of(Result const &result, std::size_t k) {
  std::size_t const slot = result.objects.front().first + k;
  return element_name(result.objects, static_cast<std::uint32_t>(slot)).value_or("element " + std::to_string(k));
}

std::string number_list(std::vector<double> const &values) {
  constexpr std::size_t most = 16;
  std::string text;
  for (std::size_t i = 0; i < values.size() && i < most; ++i) text += (i ? ", " : "") + shortest(values[i]);
  return values.size() > most ? text + ", ..." : text;
}

void print_derivatives(std::ostream &out, Result const &result) {
  fmt::print(out, "  {:<28}{:>10}{:>22}{:>12}{:>16}\n", "derivative", "elements", "worst error/allowed", "different",
             "samples judged");
  for (Object const &object : result.objects) {
    std::size_t const worst = worst_of(result, object);
    auto const elements = std::span(result.elements).subspan(first_of(result, object), object.count);
    auto const is_wrong = [](Element const &element) { return element.different != 0 || element.broken != 0; };
    auto const least = std::ranges::min_element(elements, {}, &Element::judged);
    fmt::print(out, "  {:<28}{:>10}{:>22.2g}{:>12}{:>16}\n", name_of(result, worst), object.count,
               result.elements[worst].error, std::ranges::count_if(elements, is_wrong),
               fmt::format("{} of {}", least->judged, result.tried));
  }
  if (result.left_out != 0)
    fmt::print(out, "  derivatives are compared on {} of {} samples, as many as their size allows\n", result.tried,
               result.tried + result.left_out);
}

std::optional<Diagnostic> derivative_failure(Result const &result, std::string const &file, bool is_whole) {
  if (std::optional<Diagnostic> failure = off_differences(result, file)) return failure;
  if (std::optional<Diagnostic> failure = off_formulas(result, file)) return failure;
  if (!is_whole) return {}; // other shards may judge the rest
  std::size_t const wanted = std::min(program::least_judged, std::max<std::size_t>(result.tried / 2, 1));
  for (std::size_t k = 0; k < result.elements.size(); ++k)
    if (result.elements[k].judged < wanted)
      return Diagnostic{DiagnosticId::derivative_unverified,
                        {file},
                        fmt::format("{} can be checked on {} of {} samples, and {} are required", name_of(result, k),
                                    result.elements[k].judged, result.tried, wanted)};
  return {};
}

} // namespace symreal::tool
