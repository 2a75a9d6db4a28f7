#include "engine/plan/reroll/copies.h"

#include "engine/plan/reroll/body_builder.h"
#include "engine/plan/reroll/nest.h"
#include "engine/plan/reroll/roles.h"

#include <algorithm>
#include <iterator>

namespace symreal::reroll {

namespace {

// Copies from one operation of a loop, with their elements in memory; or of one constant, with zeros as elements.
struct Group {
  std::vector<std::uint32_t> numbers, elements = {}; // indices of the copies
};

// Copies that one loop, or one loop nest, performs.
struct Line {
  std::vector<std::uint32_t> numbers;
  Access place, element;
  std::optional<Nest> nest = {};
  NodeId constant = no_node;
};

bool is_number(Graph const &graph, NodeId node, Memory const &memory) {
  return graph.nodes[node].is_constant() && !memory.has_home(node);
}

std::optional<Line> whole(Group const &group, std::vector<std::uint32_t> const &places) {
  auto const count = static_cast<std::uint32_t>(places.size());
  Line line{group.numbers, access_of(places), access_of(group.elements)};
  line.nest = nest_of(count, {&line.place, &line.element});
  for (Access const *access : {&line.place, &line.element})
    if (access->is_listed() && !(line.nest && nested(*access, *line.nest))) return {};
  return line;
}

// Lines of a group: maximal runs whose sources and targets both advance by constant steps.
std::vector<Line> lines_of(Group const &group, Copies const &copies) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t const number : group.numbers) places.push_back(copies.places[number]);
  if (std::optional<Line> line = whole(group, places)) return {std::move(*line)};
  std::vector<Line> lines;
  auto const step = [](std::vector<std::uint32_t> const &list, std::size_t k) {
    return static_cast<std::int64_t>(list[k]) - static_cast<std::int64_t>(list[k - 1]);
  };
  for (std::size_t begin = 0, end; begin < places.size(); begin = end) {
    end = begin + 1;
    Line line{{}, {places[begin]}, {group.elements[begin]}};
    if (end < places.size()) {
      line.place.step = step(places, end);
      line.element.step = step(group.elements, end);
    }
    while (end < places.size() && step(places, end) == line.place.step &&
           step(group.elements, end) == line.element.step)
      ++end;
    line.numbers.assign(group.numbers.begin() + static_cast<std::ptrdiff_t>(begin),
                        group.numbers.begin() + static_cast<std::ptrdiff_t>(end));
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Line> lines_of(Graph const &graph, Copies const &copies, Memory const &memory) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Group> by_operation;
  std::map<NodeId, Group> by_constant;
  for (std::uint32_t number = 0; number < copies.nodes.size(); ++number) {
    NodeId const node = copies.nodes[number];
    if (std::optional<Cell> const cell = memory.cell(node)) {
      Group &group = by_operation[{cell->loop, cell->position}];
      group.numbers.push_back(number);
      group.elements.push_back(memory.home(node));
    } else if (is_number(graph, node, memory)) {
      by_constant[node].numbers.push_back(number);
      by_constant[node].elements.push_back(0);
    }
  }
  std::vector<Line> all;
  for (auto const &[operation, group] : by_operation)
    std::ranges::move(lines_of(group, copies), std::back_inserter(all));
  for (auto const &[constant, group] : by_constant)
    for (Line &line : lines_of(group, copies)) {
      line.constant = constant;
      all.push_back(std::move(line));
    }
  return all;
}

} // namespace

void add_copies(Graph const &graph, Copies const &copies, Memory const &memory, std::vector<Step> &steps) {
  constexpr std::size_t most_stores = 500;
  std::vector<char> done(copies.nodes.size(), 0);
  std::map<std::pair<std::size_t, std::optional<Nest>>, std::vector<Line>> loops; // by iteration count
  for (Line const &line : lines_of(graph, copies, memory)) {
    if (line.numbers.size() < least_count) continue;
    for (std::uint32_t const number : line.numbers) done[number] = 1;
    loops[{line.numbers.size(), line.nest}].push_back(line);
  }
  for (auto const &[times, lines] : loops) {
    BodyBuilder body(graph);
    for (Line const &line : lines)
      body.store(line.constant == no_node ? body.leaf({Leaf::Kind::memory, line.element})
                                          : body.constant(graph.nodes[line.constant].value()),
                 copies.are_results, line.place);
    steps.push_back(body.finish(static_cast<std::uint32_t>(times.first)));
  }
  BodyBuilder body(graph);
  std::size_t in_body = 0;
  auto const finish = [&] {
    if (in_body != 0) steps.push_back(body.finish(1));
    body = BodyBuilder(graph);
    in_body = 0;
  };
  for (std::size_t number = 0; number < copies.nodes.size(); ++number) {
    if (done[number]) continue;
    NodeId const node = copies.nodes[number];
    body.store(is_number(graph, node, memory) ? body.constant(graph.nodes[node].value())
                                              : body.leaf({Leaf::Kind::memory, {memory.home(node)}}),
               copies.are_results, {copies.places[number]});
    if (++in_body == most_stores) finish();
  }
  finish();
}

void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> const &done,
                       Memory const &memory, std::vector<Step> &steps) {
  Copies copies{{}, {}, true};
  for (std::uint32_t slot = 0; slot < stored.size(); ++slot) {
    if (done[slot]) continue;
    copies.nodes.push_back(stored[slot]);
    copies.places.push_back(slot);
  }
  add_copies(graph, copies, memory, steps);
}

} // namespace symreal::reroll
