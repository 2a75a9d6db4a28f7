#include "reroll/result_copies.h"

#include "reroll/body_builder.h"
#include "reroll/nest.h"
#include "reroll/roles.h"

#include <algorithm>
#include <iterator>

namespace symreal::reroll {

namespace {

// Results of one operation of a loop and where they stand in memory; or those that are one constant, and zeros.
struct Copies {
  std::vector<std::uint32_t> results, elements;
};

// Those that one loop stores, or two, one in the other.
struct Line {
  Access result, element;
  std::uint32_t count;
  std::optional<Nest> nest = {};
  NodeId constant = no_node;
};

bool is_number(Graph const &graph, NodeId node, Memory const &memory) {
  return graph.nodes[node].is_constant() && !memory.has_home(node);
}

std::optional<Line> whole(Copies const &copies) {
  auto const count = static_cast<std::uint32_t>(copies.results.size());
  Line line{access_of(copies.results), access_of(copies.elements), count};
  line.nest = nest_of(count, {&line.result, &line.element});
  for (Access const *access : {&line.result, &line.element})
    if (access->is_listed() && !(line.nest && nested(*access, *line.nest))) return {};
  return line;
}

// Stretches of them that are a step apart in both arrays.
std::vector<Line> lines_of(Copies const &copies) {
  if (std::optional<Line> line = whole(copies)) return {std::move(*line)};
  std::vector<Line> lines;
  auto const step = [](std::vector<std::uint32_t> const &places, std::size_t k) {
    return static_cast<std::int64_t>(places[k]) - static_cast<std::int64_t>(places[k - 1]);
  };
  for (std::size_t begin = 0, end; begin < copies.results.size(); begin = end) {
    end = begin + 1;
    Line line{{copies.results[begin]}, {copies.elements[begin]}, 1};
    if (end < copies.results.size()) {
      line.result.step = step(copies.results, end);
      line.element.step = step(copies.elements, end);
    }
    while (end < copies.results.size() && step(copies.results, end) == line.result.step &&
           step(copies.elements, end) == line.element.step)
      ++end;
    line.count = static_cast<std::uint32_t>(end - begin);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Line> lines_of(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> const &done,
                           Memory const &memory) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Copies> by_operation;
  std::map<NodeId, Copies> by_constant;
  for (std::uint32_t slot = 0; slot < stored.size(); ++slot) {
    if (done[slot]) continue;
    if (std::optional<Cell> const cell = memory.cell(stored[slot])) {
      Copies &copies = by_operation[{cell->loop, cell->position}];
      copies.results.push_back(slot);
      copies.elements.push_back(memory.home(stored[slot]));
    } else if (is_number(graph, stored[slot], memory)) {
      by_constant[stored[slot]].results.push_back(slot);
      by_constant[stored[slot]].elements.push_back(0);
    }
  }
  std::vector<Line> all;
  for (auto const &[operation, copies] : by_operation) std::ranges::move(lines_of(copies), std::back_inserter(all));
  for (auto const &[constant, copies] : by_constant)
    for (Line &line : lines_of(copies)) {
      line.constant = constant;
      all.push_back(std::move(line));
    }
  return all;
}

} // namespace

void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> done,
                       Memory const &memory, std::vector<Step> &steps) {
  constexpr std::size_t most_stores = 500;
  std::map<std::pair<std::uint32_t, std::optional<Nest>>, std::vector<Line>> loops; // by how often they go round
  for (Line const &line : lines_of(graph, stored, done, memory)) {
    if (line.count < least_count) continue;
    loops[{line.count, line.nest}].push_back(line);
    for (std::uint32_t k = 0; k < line.count; ++k) done[line.result.at(k)] = 1;
  }
  for (auto const &[times, lines] : loops) {
    BodyBuilder body(graph);
    for (Line const &line : lines)
      body.store(line.constant == no_node ? body.leaf({Leaf::Kind::memory, line.element})
                                          : body.constant(graph.nodes[line.constant].value()),
                 true, line.result);
    steps.push_back(body.finish(times.first));
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
    body.store(is_number(graph, node, memory) ? body.constant(graph.nodes[node].value())
                                              : body.leaf({Leaf::Kind::memory, {memory.home(node)}}),
               true, {slot});
    if (++in_body == most_stores) finish();
  }
  finish();
}

} // namespace symreal::reroll
