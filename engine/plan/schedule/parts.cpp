#include "engine/plan/schedule/parts.h"

#include <algorithm>
#include <numeric>

namespace symreal {

bool waits_for_other_parts(Schedule const &plan, FunctionBody const &body, std::size_t part) {
  auto const begin_of = [&](std::size_t k) { return k == 0 ? 0 : body.parts[k - 1].end; };
  std::size_t stage_begin = begin_of(part);
  for (std::size_t k = part; k-- > 0 && body.parts[k].stage == body.parts[part].stage;) stage_begin = begin_of(k);
  std::vector<char> is_variable(body.regions.value_count(), 0), is_others(body.regions.value_count(), 0);
  for (std::size_t k = 0; k < body.parts[part].end; ++k) {
    is_variable[body.variables[k]] = 1;
    is_others[body.variables[k]] = k >= stage_begin && k < begin_of(part);
  }
  bool waits = false;
  for (std::size_t k = begin_of(part); k < body.parts[part].end; ++k)
    for_each_before(
        plan, body, k, [&](NodeId id) { return is_variable[id] != 0; },
        [&](NodeId before) { waits |= is_others[before] != 0; });
  return waits;
}

Schedule shared_out(Schedule const &plan, std::vector<Share> const &shares, unsigned threads) {
  FunctionBody const &body = plan.compute;
  std::vector<std::size_t> order(body.variables.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto const key = [&](std::size_t k) { return std::pair(shares[k].stage, shares[k].thread); };
  std::ranges::stable_sort(order, {}, key);
  Schedule result = plan;
  result.threads = threads;
  for (std::size_t at = 0; at < order.size(); ++at) {
    result.compute.variables[at] = body.variables[order[at]];
    result.compute.region[at] = body.region[order[at]];
    std::vector<ThreadPart> &parts = result.compute.parts;
    if (at == 0 || key(order[at - 1]) != key(order[at])) {
      bool const same_stage = at != 0 && shares[order[at - 1]].stage == shares[order[at]].stage;
      parts.push_back({parts.empty() ? 0 : parts.back().stage + (same_stage ? 0U : 1U), at});
    }
    parts.back().end = at + 1;
  }
  for (Check &check : result.compute.checks) check.before = order.size();
  return result;
}

} // namespace symreal
