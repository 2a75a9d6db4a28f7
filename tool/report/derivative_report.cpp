#include "tool/report/derivative_report.h"

#include "engine/graph/names.h"
#include "engine/support/number.h"
#include "tool/report/verification_record.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>
#include <span>
#include <tuple>

namespace symreal::tool {
namespace {

using Element = program::DerivativeElement;
using Result = program::DerivativeResult;
using Json = nlohmann::ordered_json;

std::size_t first_of(Result const &result, Object const &object) { return object.first - result.objects.front().first; }

std::string name_of(Result const &result, std::size_t k) {
  std::size_t const slot = result.objects.front().first + k;
  return element_name(result.objects, static_cast<std::uint32_t>(slot)).value_or("element " + std::to_string(k));
}

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

Json sample_json(Sample const &sample) {
  return {{"inputs", numbers_json(sample.inputs)}, {"parameters", numbers_json(sample.parameters)}};
}

Sample sample_of(Json const &json) { return {numbers_of(json.at("inputs")), numbers_of(json.at("parameters"))}; }

} // namespace

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

Json to_json(Result const &result) {
  Json json = {{"samples", result.tried},
               {"samples_compared_with_formulas", result.promised},
               {"samples_left_out", result.left_out},
               {"tolerance", result.tolerance},
               {"objects", Json::array()},
               {"elements", Json::array()}};
  for (Object const &object : result.objects)
    json["objects"].push_back({{"label", object.label}, {"extents", object.extents}});
  for (std::size_t k = 0; k < result.elements.size(); ++k) {
    Element const &element = result.elements[k];
    json["elements"].push_back({{"name", name_of(result, k)},
                                {"judged", element.judged},
                                {"different", element.different},
                                {"different_from_formulas", element.broken},
                                {"worst_error_by_allowed", number_json(element.error)}});
    if (element.different != 0)
      json["elements"].back()["worst"] = {{"by_differences", element.is_by_differences},
                                          {"expected", number_json(element.expected)},
                                          {"found", number_json(element.found)},
                                          {"sample", sample_json(*element.worst)}};
    if (element.broken != 0)
      json["elements"].back()["off_formulas"] = {{"expected", number_json(element.promised)},
                                                 {"found", number_json(element.given)},
                                                 {"sample", sample_json(*element.first_broken)}};
  }
  return json;
}

Result derivatives_of(Json const &json, std::size_t outputs) {
  Result result;
  result.tried = json.at("samples");
  result.promised = json.at("samples_compared_with_formulas");
  result.left_out = json.at("samples_left_out");
  result.tolerance = json.at("tolerance");
  auto next = static_cast<std::uint32_t>(outputs);
  for (Json const &one : json.at("objects")) {
    Object object{one.at("label"), one.at("extents").get<std::vector<std::size_t>>(), next};
    object.count = static_cast<std::uint32_t>(number_count(object.extents, {}));
    next += object.count;
    result.objects.push_back(std::move(object));
  }
  for (Json const &one : json.at("elements")) {
    Element &element = result.elements.emplace_back();
    element.judged = one.at("judged");
    element.different = one.at("different");
    element.broken = one.at("different_from_formulas");
    element.error = number_of(one.at("worst_error_by_allowed"));
    if (one.contains("worst")) {
      Json const &worst = one["worst"];
      element.is_by_differences = worst.at("by_differences");
      element.expected = number_of(worst.at("expected"));
      element.found = number_of(worst.at("found"));
      element.worst = std::make_shared<Sample const>(sample_of(worst.at("sample")));
    }
    if (one.contains("off_formulas")) {
      Json const &broken = one["off_formulas"];
      element.promised = number_of(broken.at("expected"));
      element.given = number_of(broken.at("found"));
      element.first_broken = std::make_shared<Sample const>(sample_of(broken.at("sample")));
    }
  }
  if (result.objects.empty() || result.elements.size() + outputs != next) throw std::invalid_argument("no derivatives");
  return result;
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
