#include "engine/plan/schedule/cuts.h"

#include "engine/plan/schedule/order.h"

#include <algorithm>
#include <utility>

namespace symreal {

static constexpr std::uint32_t nowhere = ~std::uint32_t{0}; // statements are fewer than nodes

Cuts::Cuts(Schedule const &plan, FunctionBody const &body, bool in_compute)
    : loaded_by_(body.variables.size(), nowhere) {
  std::vector<std::uint32_t> statement(body.regions.value_count(), nowhere),
      last_reader(body.variables.size(), nowhere);
  auto const end = static_cast<std::uint32_t>(body.variables.size());
  reads_.all.reserve(2 * std::size_t{end});
  dying_.all.reserve(end);
  for (std::uint32_t k = 0; k < end; ++k) {
    auto const note = [&](NodeId use) {
      for_each_read(
          *plan.graph, use, [&](NodeId id) { return statement[id] != nowhere; },
          [&](NodeId id) { return is_read(plan, in_compute, id); },
          [&](NodeId id) {
            reads_.all.push_back(statement[id]);
            last_reader[statement[id]] = k;
          });
    };
    for (Literal const &literal : body.regions.literals(body.region[k])) note(literal.condition);
    for_each_operand(plan, body, in_compute, body.variables[k], note);
    statement[body.variables[k]] = k;
    reads_.end_row();
  }
  for (std::uint32_t k = 0; k < end; ++k) {
    for (std::uint32_t const read : reads_[k])
      if (std::exchange(last_reader[read], last_reader[read] == k ? nowhere : last_reader[read]) == k)
        dying_.all.push_back(read);
    dying_.end_row();
  }
}

std::vector<std::size_t> Cuts::between(std::size_t first, std::size_t end, std::size_t most_statements) {
  std::vector<std::size_t> begins;
  while (first < end) {
    begins.push_back(first);
    bool const is_long = end - first > most_statements;
    first = is_long ? best_end(first, most_statements) : end;
  }
  return begins;
}

std::size_t Cuts::best_end(std::size_t begin, std::size_t most_statements) {
  constexpr std::size_t unknown = ~std::size_t{0};
  auto const chunk = static_cast<std::uint32_t>(begin);
  std::size_t best = begin + most_statements, best_cost = unknown, loaded = 0, stored = 0;
  for (std::size_t k = begin; k < begin + most_statements; ++k) {
    for (std::uint32_t const read : reads_[k])
      if (read < begin && std::exchange(loaded_by_[read], chunk) != chunk) ++loaded;
    ++stored; // whether or not it is read
    for (std::uint32_t const dying : dying_[k])
      if (dying >= begin) --stored;
    std::size_t const length = k + 1 - begin, cost = loaded + stored;
    if (length < most_statements / 2) continue;
    if (best_cost != unknown && cost * (best - begin) > best_cost * length) continue;
    best = k + 1;
    best_cost = cost;
  }
  return best;
}

} // namespace symreal
