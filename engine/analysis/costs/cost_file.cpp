#include "engine/analysis/costs/measuring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace symreal {

namespace {

struct Times {
  double latency, throughput;
};

// Times of an operation without those of its link, at least a tenth of a nanosecond, the limit of the measurement.
Times without(Times const &all, Times const &link) {
  auto const less = [](double a, double b) { return std::round(std::max(a - b, 0.1) * 100) / 100; };
  return {less(all.latency, link.latency), less(all.throughput, link.throughput)};
}

// Whether the operation maps 64-bit integers to one, so that its link converts both ways.
bool is_wide_link(OperationInfo const &row) { return row.has(flag::WIDE) && row.has(flag::TAKES_WIDE); }

Times scaled(Times const &times, int factor) { return {times.latency * factor, times.throughput * factor}; }

} // namespace

std::string cost_file_text(std::string_view output, std::string const &compiler,
                           std::optional<ThreadCosts> const &threads) {
  std::map<std::string, Times> times;
  std::istringstream lines{std::string(output)};
  for (auto [name, one] = std::pair(std::string(), Times{}); lines >> name >> one.latency >> one.throughput;)
    times[name] = one;
  if (!times.contains("-") || !times.contains("-wide") || !times.contains("add")) return {};
  Times const addition = without(times["add"], times["-"]);
  nlohmann::ordered_json json = {{"symreal-costs", 1}, {"compiler", compiler}, {"flags", measuring_flags}};
  nlohmann::ordered_json estimated = nlohmann::ordered_json::array();
  for (OperationInfo const &row : operations()) {
    std::string const name(row.name);
    bool const is_measured = times.contains(name);
    Times const cost = row.cost == 0 ? Times{0, 0}
                       : is_measured ? without(times[name], times[is_wide_link(row) ? "-wide" : "-"])
                                     : scaled(addition, row.cost);
    json["nanoseconds"][name] = {{"latency", cost.latency}, {"throughput", cost.throughput}};
    if (!is_measured && row.cost != 0) estimated.push_back(name);
  }
  json["estimated"] = estimated;
  if (threads) json["threads"] = to_json(*threads);
  return json.dump(2) + "\n";
}

} // namespace symreal
