#include "tool/report/error_report.h"

#include "engine/graph/names.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

namespace symreal::tool {

using Json = nlohmann::ordered_json;

void print_errors(std::ostream &out, Graph const &graph, program::ErrorResult const &result) {
  fmt::print(out, "  exact values, in {} bits: ", result.bits);
  if (!result.obstacle.empty()) return fmt::print(out, "there are none: {}\n", result.obstacle);
  fmt::print(
      out, "{} sample{}{}{}\n", result.samples, result.samples == 1 ? "" : "s",
      result.untold == 0
          ? ""
          : fmt::format("; {} more, where a decision falls otherwise in them or a value is not finite", result.untold),
      result.left_out == 0 ? "" : fmt::format("; {} more were left out, for the time they take", result.left_out));
  if (result.samples == 0) return;
  fmt::print(out, "    {:<26}{:>22}{:>20}{:>36}\n", "error of", "the original, at most", "the code, at most",
             "nearer on: the original, the code");
  std::vector<std::string> const names = identifiers(graph.outputs);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    Object const &object = graph.outputs[i];
    if (object.count == 0) continue;
    auto const first = result.outputs.begin() + object.first;
    auto const worst = std::max_element(first, first + object.count, [](auto const &one, auto const &other) {
      return std::max(one.original, one.generated) < std::max(other.original, other.generated);
    });
    fmt::print(out, "    {:<26}{:>22.1e}{:>20.1e}{:>36}\n",
               element_name(names[i], object, static_cast<std::uint32_t>(worst - first)), worst->original,
               worst->generated, fmt::format("{}, {}", worst->original_nearer, worst->generated_nearer));
  }
}

Json to_json(program::ErrorResult const &result) {
  Json json = {{"bits", result.bits}};
  if (!result.obstacle.empty()) json["obstacle"] = result.obstacle;
  json.update({{"samples", result.samples},
               {"untold", result.untold},
               {"left_out", result.left_out},
               {"outputs", Json::array()}});
  for (program::ErrorsOfOutput const &output : result.outputs)
    json["outputs"].push_back({{"original", output.original},
                               {"generated", output.generated},
                               {"original_nearer", output.original_nearer},
                               {"generated_nearer", output.generated_nearer},
                               {"sample", output.worst_sample}});
  return json;
}

program::ErrorResult errors_of(Json const &json, std::size_t outputs) {
  program::ErrorResult result{.bits = json.at("bits"),
                              .obstacle = json.value("obstacle", ""),
                              .samples = json.at("samples"),
                              .untold = json.at("untold"),
                              .left_out = json.at("left_out"),
                              .outputs = {}};
  for (Json const &one : json.at("outputs"))
    result.outputs.push_back({one.at("original"), one.at("generated"), one.at("original_nearer"),
                              one.at("generated_nearer"), one.at("sample")});
  if (result.outputs.size() != outputs) throw std::invalid_argument("outputs without objects");
  return result;
}

} // namespace symreal::tool
