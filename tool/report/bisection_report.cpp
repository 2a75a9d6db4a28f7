#include "tool/report/bisection_report.h"

#include "engine/emit/origins/origins.h"
#include "engine/graph/names.h"
#include "engine/support/number.h"
#include "verify/bisection.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::tool {

std::string bisected(program::Recorded const &recorded, program::Banner const &banner,
                     program::Verification const &verification, program::VerificationOptions const &options) {
  auto const output = std::ranges::find_if(verification.outputs, [](auto const &one) { return one.different != 0; });
  if (output == verification.outputs.end()) return "bisection: no output differs in a single call";
  Graph const &graph = recorded.graph;
  if (!graph.externals.empty() || banner.is_single)
    return "bisection: a graph of code in single precision, or that calls functions, cannot be evaluated pass by pass";
  std::optional<program::Culprit> const culprit =
      program::find_culprit(graph, program::default_pipeline(banner.mode), PassSettings(banner.mode), options.tolerance,
                            verification.named.at(output->worst_sample));
  if (!culprit)
    return "bisection: no pass of the usual ones changes an output there: the difference comes with the recording, "
           "with the emitted code or with its compilation";
  std::vector<std::string> const names = identifiers(graph.outputs);
  std::string text;
  for (std::size_t i = 0; i < graph.outputs.size(); ++i)
    if (Object const &object = graph.outputs[i]; culprit->output - object.first < object.count)
      text = fmt::format("bisection: pass {} is the first to change an output: {} from {} to {}", culprit->pass,
                         element_name(names[i], object, static_cast<std::uint32_t>(culprit->output - object.first)),
                         shortest(culprit->before), shortest(culprit->after));
  if (culprit->rewrites == 0) return text;
  text += fmt::format("; its rewrite number {} does it: {}", culprit->rewrites, culprit->rule);
  std::string const place = culprit->location == no_location ? "" : describe_locations(graph, {culprit->location});
  return place.empty() ? text : text + ", of what stands at " + place;
}

} // namespace symreal::tool
