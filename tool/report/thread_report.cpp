#include "tool/report/thread_report.h"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

namespace symreal::tool {

void print_threads(std::ostream &out, program::ThreadResult const &result) {
  fmt::print(out, "  {} threads share an evaluation, and one computes the same numbers on {}", result.threads,
             result.different == 0 ? "all samples" : fmt::format("all samples but {}", result.different));
  if (!result.times) {
    fmt::print(out, "; not timed\n");
    return;
  }
  program::ThreadTimes const &times = *result.times;
  fmt::print(
      out,
      "\n  it takes {:.3g} us in place of {:.3g} us: {:.2f} times as fast ({:.2f} to {:.2f}, quartiles of {} turns)\n",
      times.together / 1e3, times.alone / 1e3, times.gain, times.low, times.high, times.turns);
}

nlohmann::ordered_json to_json(program::ThreadResult const &result) {
  nlohmann::ordered_json json = {{"threads", result.threads}, {"different", result.different}};
  if (result.times)
    json["nanoseconds"] = {{"alone", result.times->alone},
                           {"together", result.times->together},
                           {"times_as_fast", {result.times->low, result.times->gain, result.times->high}}};
  return json;
}

std::optional<Diagnostic> thread_failure(program::Verification const &verification, std::string const &file) {
  if (!verification.threads || verification.threads->different == 0) return {};
  return Diagnostic{DiagnosticId::verification_mismatch,
                    {file},
                    fmt::format("on {} samples {} threads compute other numbers than one",
                                verification.threads->different, verification.threads->threads)};
}

} // namespace symreal::tool
