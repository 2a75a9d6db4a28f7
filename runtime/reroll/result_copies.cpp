#include "reroll/result_copies.h"

#include "reroll/body_builder.h"

namespace symreal::reroll {

namespace {

// Results of one operation of a loop, a step apart in both arrays.
struct Line {
  std::uint32_t result, element, count = 1;
  std::int64_t result_step = 0, element_step = 0;

  bool take(std::uint32_t next_result, std::uint32_t next_element) {
    auto const step = [&](std::uint32_t first, std::uint32_t next) {
      return static_cast<std::int64_t>(next) - static_cast<std::int64_t>(first);
    };
    if (count == 1) {
      result_step = step(result, next_result);
      element_step = step(element, next_element);
    } else if (step(result, next_result) != result_step * count ||
               step(element, next_element) != element_step * count) {
      return false;
    }
    ++count;
    return true;
  }
};

std::vector<Line> lines_of(std::vector<NodeId> const &stored, std::vector<char> const &done, Memory const &memory) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Line>> by_operation;
  for (std::uint32_t slot = 0; slot < stored.size(); ++slot) {
    if (done[slot]) continue;
    std::optional<Cell> const cell = memory.cell(stored[slot]);
    if (!cell) continue;
    std::vector<Line> &lines = by_operation[{cell->loop, cell->position}];
    if (lines.empty() || !lines.back().take(slot, memory.home(stored[slot])))
      lines.push_back({slot, memory.home(stored[slot])});
  }
  std::vector<Line> all;
  for (auto const &[operation, lines] : by_operation) all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

} // namespace

void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> done,
                       Memory const &memory, std::vector<Step> &steps) {
  constexpr std::size_t most_stores = 500;
  std::map<std::uint32_t, std::vector<Line>> loops; // by how often they go round
  for (Line const &line : lines_of(stored, done, memory)) {
    if (line.count < least_count) continue;
    loops[line.count].push_back(line);
    for (std::uint32_t k = 0; k < line.count; ++k)
      done[static_cast<std::size_t>(line.result + line.result_step * k)] = 1;
  }
  for (auto const &[count, lines] : loops) {
    BodyBuilder body(graph);
    for (Line const &line : lines)
      body.store(body.leaf({Leaf::Kind::memory, {line.element, line.element_step}}), true,
                 {line.result, line.result_step});
    steps.push_back(body.finish(count));
  }
  BodyBuilder body(graph);
  std::size_t in_body = 0;
  auto const finish = [&] {
    if (in_body != 0) steps.push_back(body.finish(1));
    body = BodyBuilder(graph);
    in_body = 0;
  };
  for (std::uint32_t slot = 0; slot < stored.size(); ++slot) {
    if (done[slot]) continue;
    NodeId const node = stored[slot];
    bool const is_constant = graph.nodes[node].is_constant() && !memory.has_home(node);
    body.store(is_constant ? body.constant(graph.nodes[node].value())
                           : body.leaf({Leaf::Kind::memory, {memory.home(node)}}),
               true, {slot});
    if (++in_body == most_stores) finish();
  }
  finish();
}

} // namespace symreal::reroll
