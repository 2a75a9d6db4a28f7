#include "engine/plan/reroll/results.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <set>

namespace symreal::reroll {

namespace {

constexpr std::uint32_t least_rows = 16; // of a mirrored matrix

class SquareMatrix {
public:
  SquareMatrix(std::vector<NodeId> const &stored, std::uint32_t first, std::uint32_t rows)
      : stored_(stored),
        first_(first),
        rows_(rows) {}

  bool is_symmetric() const {
    for (std::uint32_t row = 0; row < rows_; ++row)
      for (std::uint32_t column = 0; column < row; ++column)
        if (at(row, column) != at(column, row)) return false;
    return true;
  }

  // Whether consecutive iterations of loops compute more row neighbours than column neighbours above the diagonal.
  bool is_by_rows(Memory const &memory) const {
    std::int64_t surplus = 0;
    for (std::uint32_t row = 0; row < rows_; ++row)
      for (std::uint32_t column = row + 1; column < rows_; ++column) {
        if (column + 1 < rows_) surplus += are_in_turn(memory, at(row, column), at(row, column + 1));
        if (row + 1 < column) surplus -= are_in_turn(memory, at(row, column), at(row + 1, column));
      }
    return surplus >= 0;
  }

private:
  NodeId at(std::uint32_t row, std::uint32_t column) const { return stored_[first_ + rows_ * row + column]; }

  static bool are_in_turn(Memory const &memory, NodeId a, NodeId b) {
    std::optional<Cell> const one = memory.cell(a), other = memory.cell(b);
    return one && other && one->loop == other->loop && one->position == other->position &&
           std::abs(one->iteration - other->iteration) == 1;
  }

  std::vector<NodeId> const &stored_;
  std::uint32_t first_, rows_;
};

// Dimension of the square matrices in the object, or of the one that a flat array of its size forms; 0 if not square.
std::uint32_t rows_of(Object const &object) {
  std::vector<std::size_t> const &extents = object.extents;
  if (extents.empty() || !object.members.empty()) return 0;
  if (extents.size() > 1) return extents.back() == extents.end()[-2] ? static_cast<std::uint32_t>(extents.back()) : 0;
  auto const rows = static_cast<std::uint32_t>(std::lround(std::sqrt(object.count)));
  return rows * rows == object.count ? rows : 0;
}

using Slots = std::set<std::uint32_t>;

// Removes one result per iteration, at an affine index of the iteration; nullopt if no such line exists.
std::optional<Access> take_line(std::vector<Slots> &iterations) {
  auto const is_line = [&](Access const &access) {
    for (std::size_t k = 0; k < iterations.size(); ++k)
      if (!iterations[k].contains(static_cast<std::uint32_t>(access.at(k)))) return false;
    return true;
  };
  for (std::uint32_t const first : iterations[0])
    for (std::uint32_t const second : iterations[1]) {
      Access access{first, static_cast<std::int64_t>(second) - static_cast<std::int64_t>(first)};
      if (!is_line(access)) continue;
      for (std::size_t k = 0; k < iterations.size(); ++k) iterations[k].erase(static_cast<std::uint32_t>(access.at(k)));
      return access;
    }
  return {};
}

// Likewise, at an affine index of a loop nest.
std::optional<Access> take_nest(std::vector<Slots> &iterations, std::optional<Nest> const &rows) {
  Access access;
  for (Slots const &slots : iterations) {
    if (slots.empty()) return {};
    access.elements.push_back(*slots.begin());
  }
  if (rows ? !nested(access, *rows) : !nest_of(static_cast<std::uint32_t>(iterations.size()), {&access})) return {};
  for (Slots &slots : iterations) slots.erase(slots.begin());
  return access;
}

std::optional<Access> take(std::vector<Slots> &iterations, std::optional<Nest> const &rows) {
  std::optional<Access> line = take_line(iterations);
  return line ? line : take_nest(iterations, rows);
}

// Copies from one operation of a loop, with their elements in memory; or of one constant, with zeros as elements.
struct CopyGroup {
  std::vector<std::uint32_t> numbers, elements = {}; // indices of the copies
};

// Copies that one loop, or one loop nest, performs.
struct CopyLine {
  std::vector<std::uint32_t> numbers;
  Access place, element;
  std::optional<Nest> nest = {};
  NodeId constant = no_node;
};

bool is_number(Graph const &graph, NodeId node, Memory const &memory) {
  return graph.nodes[node].is_constant() && !memory.has_home(node);
}

std::optional<CopyLine> whole(CopyGroup const &group, std::vector<std::uint32_t> const &places) {
  auto const count = static_cast<std::uint32_t>(places.size());
  CopyLine line{group.numbers, access_of(places), access_of(group.elements)};
  line.nest = nest_of(count, {&line.place, &line.element});
  for (Access const *access : {&line.place, &line.element})
    if (access->is_listed() && !(line.nest && nested(*access, *line.nest))) return {};
  return line;
}

// Lines of a group: maximal runs whose sources and targets both advance by constant steps.
std::vector<CopyLine> lines_of(CopyGroup const &group, Copies const &copies) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t const number : group.numbers) places.push_back(copies.places[number]);
  if (std::optional<CopyLine> line = whole(group, places)) return {std::move(*line)};
  std::vector<CopyLine> lines;
  auto const step = [](std::vector<std::uint32_t> const &list, std::size_t k) {
    return static_cast<std::int64_t>(list[k]) - static_cast<std::int64_t>(list[k - 1]);
  };
  for (std::size_t begin = 0, end; begin < places.size(); begin = end) {
    end = begin + 1;
    CopyLine line{{}, {places[begin]}, {group.elements[begin]}};
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

std::vector<CopyLine> lines_of(Graph const &graph, Copies const &copies, Memory const &memory) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, CopyGroup> by_operation;
  std::map<NodeId, CopyGroup> by_constant;
  for (std::uint32_t number = 0; number < copies.nodes.size(); ++number) {
    NodeId const node = copies.nodes[number];
    if (std::optional<Cell> const cell = memory.cell(node)) {
      CopyGroup &group = by_operation[{cell->loop, cell->position}];
      group.numbers.push_back(number);
      group.elements.push_back(memory.home(node));
    } else if (is_number(graph, node, memory)) {
      by_constant[node].numbers.push_back(number);
      by_constant[node].elements.push_back(0);
    }
  }
  std::vector<CopyLine> all;
  for (auto const &[operation, group] : by_operation)
    std::ranges::move(lines_of(group, copies), std::back_inserter(all));
  for (auto const &[constant, group] : by_constant)
    for (CopyLine &line : lines_of(group, copies)) {
      line.constant = constant;
      all.push_back(std::move(line));
    }
  return all;
}

} // namespace

std::vector<Mirror> mirrors(std::vector<Object> const &objects, std::vector<NodeId> const &stored,
                            Memory const &memory) {
  std::vector<Mirror> found;
  for (Object const &object : objects) {
    std::uint32_t const rows = rows_of(object);
    if (rows < least_rows) continue;
    for (std::uint32_t first = object.first; first < object.first + object.count; first += rows * rows)
      if (SquareMatrix const matrix(stored, first, rows); matrix.is_symmetric())
        found.push_back({first, rows, matrix.is_by_rows(memory)});
  }
  return found;
}

DirectResults direct_results(Sequence const &sequence, std::vector<LoopBody> const &loops,
                             std::vector<NodeId> const &stored, std::vector<Mirror> const &mirrors,
                             Memory const &memory, std::size_t begin) {
  DirectResults results{std::vector<std::vector<LoopResult>>(loops.size()), {}, std::vector<char>(stored.size(), 0)};
  for (Mirror const &mirror : mirrors)
    for_each_copy(mirror, [&](std::uint32_t to, std::uint32_t) { results.is_stored[to] = 1; });
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Slots>> by_operation; // per operation, iteration
  for (std::uint32_t slot = 0; slot < stored.size(); ++slot) {
    NodeId const node = stored[slot];
    if (results.is_stored[slot] || !sequence.is_computed(node) || sequence.position[node] < begin) continue;
    if (std::optional<Cell> const cell = memory.cell(node)) {
      std::vector<Slots> &iterations = by_operation[{cell->loop, cell->position}];
      iterations.resize(loops[cell->loop].repeat.count);
      iterations[static_cast<std::size_t>(cell->iteration)].insert(slot);
    } else {
      results.of_operation[node].push_back(slot);
      results.is_stored[slot] = 1;
    }
  }
  for (auto &[operation, iterations] : by_operation)
    while (auto const found = take(iterations, loops[operation.first].repeat.rows)) {
      for (std::size_t k = 0; k < iterations.size(); ++k) results.is_stored[found->at(k)] = 1;
      results.of_loop[operation.first].push_back({operation.second, *found});
    }
  return results;
}

void add_copies(Graph const &graph, Copies const &copies, Memory const &memory, std::vector<LoopStep> &steps) {
  constexpr std::size_t most_stores = 500;
  std::vector<char> done(copies.nodes.size(), 0);
  std::map<std::pair<std::size_t, std::optional<Nest>>, std::vector<CopyLine>> loops; // by iteration count
  for (CopyLine const &line : lines_of(graph, copies, memory)) {
    if (line.numbers.size() < least_count) continue;
    for (std::uint32_t const number : line.numbers) done[number] = 1;
    loops[{line.numbers.size(), line.nest}].push_back(line);
  }
  for (auto const &[times, lines] : loops) {
    BodyBuilder body(graph);
    for (CopyLine const &line : lines)
      body.store(line.constant == no_node ? body.leaf({Array::memory, line.element})
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
                                              : body.leaf({Array::memory, {memory.home(node)}}),
               copies.are_results, {copies.places[number]});
    if (++in_body == most_stores) finish();
  }
  finish();
}

void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> const &done,
                       Memory const &memory, std::vector<LoopStep> &steps) {
  Copies copies{{}, {}, true};
  for (std::uint32_t slot = 0; slot < stored.size(); ++slot) {
    if (done[slot]) continue;
    copies.nodes.push_back(stored[slot]);
    copies.places.push_back(slot);
  }
  add_copies(graph, copies, memory, steps);
}

} // namespace symreal::reroll
