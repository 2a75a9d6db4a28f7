#include "schedule/regions.h"

#include <algorithm>

namespace symreal {

static constexpr std::uint32_t longest = 20; // C99 compilers must accept blocks nested 127 deep

RegionId Regions::append(RegionId before, Code last) {
  auto [found, is_new] =
      by_content_.try_emplace(std::uint64_t{before} << 32 | last, static_cast<RegionId>(entries_.size()));
  if (is_new) entries_.push_back({before, last, entries_[before].size + 1});
  return found->second;
}

RegionId Regions::make(std::vector<Code> const &ascending) {
  RegionId region = everywhere;
  for (Code code : ascending) region = append(region, code);
  return region;
}

std::vector<Regions::Code> Regions::codes(RegionId region) const {
  std::vector<Code> result(entries_[region].size);
  for (std::size_t k = result.size(); k-- > 0; region = entries_[region].before) result[k] = entries_[region].last;
  return result;
}

std::vector<Literal> Regions::literals(RegionId region) const {
  std::vector<Literal> result;
  for (Code code : codes(region)) result.push_back({code / 2, code % 2 != 0});
  std::stable_sort(result.begin(), result.end(),
                   [&](Literal const &a, Literal const &b) { return depth_.at(a.condition) < depth_.at(b.condition); });
  return result;
}

RegionId Regions::with(RegionId region, Literal literal) {
  Code const code = 2 * literal.condition + (literal.holds ? 1 : 0);
  auto [depth, is_new] = depth_.try_emplace(literal.condition, entries_[region].size);
  if (!is_new) depth->second = std::min(depth->second, entries_[region].size);
  if (entries_[region].size == 0 || entries_[region].last < code) return append(region, code);
  std::vector<Code> set = codes(region);
  auto place = std::lower_bound(set.begin(), set.end(), code);
  if (*place == code) return region;
  set.insert(place, code);
  return make(set);
}

RegionId Regions::united(RegionId a, RegionId b) {
  if (a == b || b == everywhere) return a;
  if (a == everywhere) return b;
  std::vector<Code> x = codes(a), y = codes(b), both;
  std::set_union(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(both));
  return make(both);
}

bool Regions::contains(RegionId whole, RegionId part) const {
  if (whole == part || part == everywhere) return true;
  std::vector<Code> x = codes(whole), y = codes(part);
  return std::includes(x.begin(), x.end(), y.begin(), y.end());
}

// A gate that only one of them has may stand for literals of the other. The youngest first: what a gate stands for has
// only older gates, so both come down to those that they share.
void Regions::open_gates(std::vector<Code> &x, std::vector<Code> &y) const {
  auto youngest = [&](std::vector<Code> const &set, std::vector<Code> const &other) {
    for (std::size_t k = set.size(); k-- > 0 && is_gate(set[k] / 2);)
      if (!std::binary_search(other.begin(), other.end(), set[k])) return set[k];
    return Code{0};
  };
  while (true) {
    Code const in_x = youngest(x, y), in_y = youngest(y, x), gate = std::max(in_x, in_y);
    if (gate == 0) return;
    std::vector<Code> &set = gate == in_x ? x : y;
    std::vector<Code> const meant = codes(of_gate(gate / 2));
    std::vector<Code> opened;
    std::erase(set, gate);
    std::set_union(set.begin(), set.end(), meant.begin(), meant.end(), std::back_inserter(opened));
    set = std::move(opened);
  }
}

RegionId Regions::intersection(RegionId a, RegionId b) {
  if (a == b) return a;
  if (a == everywhere || b == everywhere) return everywhere;
  auto [known, is_new] = intersections_.try_emplace(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), everywhere);
  if (!is_new) return known->second;
  std::vector<Code> x = codes(a), y = codes(b), both;
  open_gates(x, y);
  std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(both));
  RegionId const result = make(both);
  return intersections_[std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)] = result;
}

RegionId Regions::shortened(RegionId region) {
  if (entries_[region].size < longest) return region;
  auto [found, is_new] = gate_region_.try_emplace(region, everywhere);
  if (is_new) {
    Literal const gate{static_cast<NodeId>(value_count()), true};
    gates_.push_back(region);
    found->second = with(everywhere, gate);
  }
  return found->second;
}

namespace {

constexpr RegionId unknown = ~RegionId{0};

// A negation is no condition of its own, so that c and !c make one if and else.
Literal literal(Graph const &graph, std::vector<char> const &is_read, NodeId condition, bool holds) {
  while (graph.nodes[condition].op == Op::logical_not && !is_read[condition]) {
    condition = graph.nodes[condition].operand[0];
    holds = !holds;
  }
  return {condition, holds};
}

bool has_conditions(Graph const &graph, std::vector<char> const &is_needed) {
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Op const op = graph.nodes[id].op;
    if (is_needed[id] && (op == Op::select || op == Op::logical_and || op == Op::logical_or)) return true;
  }
  return false;
}

// From users to operands.
void find_needs(Graph const &graph, std::vector<NodeId> const &roots, std::vector<char> const &is_needed,
                std::vector<char> const &is_read, Placement &placement) {
  Regions &regions = placement.regions;
  std::vector<RegionId> &of_node = placement.of_node;
  for (NodeId root : roots) of_node[root] = everywhere;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (!is_needed[id]) continue;
    if (is_read[id]) {
      of_node[id] = everywhere;
      continue;
    }
    RegionId const here = of_node[id] = regions.shortened(of_node[id]);
    Node const &node = graph.nodes[id];
    for (unsigned i = 0; i < arity(node.op); ++i) {
      RegionId use = here;
      if (i > 0 && (node.op == Op::select || node.op == Op::logical_and || node.op == Op::logical_or)) {
        bool const holds = node.op == Op::select ? i == 1 : node.op == Op::logical_and;
        use = regions.with(here, literal(graph, is_read, node.operand[0], holds));
      }
      if (is_read[node.operand[i]]) continue;
      RegionId &region = of_node[node.operand[i]];
      region = region == unknown ? use : regions.intersection(region, use);
    }
  }
}

// From operands to users.
void move_quiet_ones_out(Graph const &graph, std::vector<char> const &is_needed, Placement &placement) {
  Regions &regions = placement.regions;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!is_needed[id]) continue;
    RegionId &region = placement.of_node[id];
    if (region == everywhere || !info(graph.nodes[id].op).has(flag::QUIET)) continue;
    RegionId operands = everywhere;
    for (NodeId operand : graph.nodes[id].operand)
      if (operand != no_node) operands = regions.united(operands, placement.of_node[operand]);
    if (regions.contains(region, operands)) region = operands;
  }
}

} // namespace

Placement place(Graph const &graph, std::vector<NodeId> const &roots, std::vector<char> const &is_needed,
                std::vector<char> const &is_read) {
  Placement placement{Regions(graph.nodes.size()), {}};
  if (!has_conditions(graph, is_needed)) return placement;
  placement.of_node.assign(graph.nodes.size(), unknown);
  find_needs(graph, roots, is_needed, is_read, placement);
  move_quiet_ones_out(graph, is_needed, placement);
  return placement;
}

} // namespace symreal
