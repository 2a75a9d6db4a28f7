#include "engine/analysis/costs/thread_costs.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace symreal {

namespace {

double rounded(double nanoseconds) { return std::round(nanoseconds * 10) / 10; }

double time_of(nlohmann::json const &json, char const *which) {
  double const value = json.at(which).get<double>();
  if (!(value > 0 && value <= 1e9)) throw std::out_of_range(fmt::format("'{}' is {}, which is no time", which, value));
  return value;
}

unsigned count_of(nlohmann::json const &json, char const *which) {
  long const value = json.at(which).get<long>();
  if (value < 1 || value > 1L << 20)
    throw std::out_of_range(fmt::format("'{}' is {}, which is no number of them", which, value));
  return static_cast<unsigned>(value);
}

} // namespace

static double of(std::vector<ThreadCosts::Barrier> const &all, unsigned threads) {
  for (ThreadCosts::Barrier const &one : all)
    if (one.threads >= threads) return one.nanoseconds;
  return all.back().nanoseconds;
}

double ThreadCosts::barrier(unsigned threads) const { return of(barriers, threads); }
double ThreadCosts::sections_for(unsigned threads) const { return of(sections, threads); }

std::vector<ThreadCosts::Barrier> measured_sections(std::string_view output) {
  std::vector<ThreadCosts::Barrier> result;
  std::istringstream lines{std::string(output)};
  for (ThreadCosts::Barrier one{}; lines >> one.threads >> one.nanoseconds;)
    result.push_back({one.threads, rounded(one.nanoseconds)});
  return lines.eof() ? result : std::vector<ThreadCosts::Barrier>();
}

std::optional<ThreadCosts> measured_thread_costs(std::string_view output) {
  ThreadCosts costs;
  unsigned threads = 0, known = 0;
  double time = 0;
  std::istringstream lines{std::string(output)};
  for (std::string name; lines >> name; ++known) {
    if (name == "processors")
      lines >> costs.processors >> costs.cores;
    else if (name == "hand_over")
      lines >> costs.hand_over;
    else if (name == "wake")
      lines >> costs.wake;
    else if (name == "start")
      lines >> costs.start;
    else if (name == "barrier" && lines >> threads >> time)
      costs.barriers.push_back({threads, rounded(time)});
    else
      return {};
    if (!lines) return {};
  }
  for (double *one : {&costs.hand_over, &costs.wake, &costs.start}) *one = rounded(*one);
  bool const is_alone = costs.processors == 1 && known == 1;
  bool const is_all =
      costs.processors > 1 && costs.is_measured() && costs.hand_over > 0 && costs.wake > 0 && costs.start > 0;
  return is_alone || is_all ? std::optional(costs) : std::nullopt;
}

nlohmann::ordered_json to_json(ThreadCosts const &costs) {
  nlohmann::ordered_json json = {{"processors", costs.processors}, {"cores", costs.cores}};
  if (!costs.is_measured()) return json;
  json["hand_over"] = costs.hand_over;
  json["wake"] = costs.wake;
  json["start"] = costs.start;
  for (ThreadCosts::Barrier const &one : costs.barriers)
    json["barriers"].push_back({{"threads", one.threads}, {"nanoseconds", one.nanoseconds}});
  for (ThreadCosts::Barrier const &one : costs.sections)
    json["sections"].push_back({{"threads", one.threads}, {"nanoseconds", one.nanoseconds}});
  return json;
}

ThreadCosts thread_costs(nlohmann::json const &json) {
  ThreadCosts costs{count_of(json, "processors"), count_of(json, "cores")};
  if (!json.contains("barriers")) return costs;
  costs.hand_over = time_of(json, "hand_over");
  costs.wake = time_of(json, "wake");
  costs.start = time_of(json, "start");
  for (nlohmann::json const &one : json.at("barriers"))
    costs.barriers.push_back({count_of(one, "threads"), time_of(one, "nanoseconds")});
  if (json.contains("sections"))
    for (nlohmann::json const &one : json.at("sections"))
      costs.sections.push_back({count_of(one, "threads"), time_of(one, "nanoseconds")});
  if (costs.barriers.empty()) throw std::out_of_range("'barriers' has none");
  return costs;
}

} // namespace symreal
