#include "engine/plan/schedule/regions.h"

#include <algorithm>

namespace symreal {

static constexpr std::uint32_t longest = 20; // C99 compilers must accept blocks nested 127 deep
static constexpr std::size_t most_alternatives = 16;

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
  for (Code code : codes(region))
    if (!is_gate(code / 2) || !gate_at(code / 2).released) result.push_back({code / 2, code % 2 != 0});
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

// Replaces gates of long regions that only one set has by their literals. The youngest comes first: a gate's literals
// contain only older gates, so both sets come down to shared ones.
void Regions::open_gates(std::vector<Code> &x, std::vector<Code> &y) const {
  auto youngest = [&](std::vector<Code> const &set, std::vector<Code> const &other) {
    for (std::size_t k = set.size(); k-- > 0 && is_gate(set[k] / 2);)
      if (alternatives(set[k] / 2).empty() && !std::binary_search(other.begin(), other.end(), set[k])) return set[k];
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
  return is_new ? found->second = make_gate(everywhere, {region}) : found->second;
}

RegionId Regions::make_gate(RegionId around, Gate gate) {
  Literal const literal{static_cast<NodeId>(value_count()), true};
  gates_.push_back(std::move(gate));
  return with(around, literal);
}

// Whether the regions differ in the outcome of one condition only: their union is then the common rest.
bool Regions::differ_in_one_outcome(RegionId a, RegionId b, std::vector<Code> &common) const {
  if (entries_[a].size != entries_[b].size) return false;
  std::vector<Code> const x = codes(a), y = codes(b);
  common.clear();
  for (std::size_t k = 0; k < x.size(); ++k)
    if (x[k] == y[k])
      common.push_back(x[k]);
    else if (x[k] / 2 != y[k] / 2)
      return false;
  return common.size() + 1 == x.size();
}

void Regions::add_use(std::vector<RegionId> &uses, RegionId region) {
  std::vector<Code> common;
  for (std::size_t k = 0; k < uses.size();) {
    if (contains(region, uses[k])) return;
    bool const together = differ_in_one_outcome(uses[k], region, common);
    if (!together && !contains(uses[k], region)) {
      ++k;
      continue;
    }
    uses.erase(uses.begin() + static_cast<std::ptrdiff_t>(k));
    if (!together) continue;
    region = make(common);
    k = 0;
  }
  uses.push_back(region);
}

RegionId Regions::either(RegionId common, std::vector<RegionId> const &uses) {
  if (uses.size() < 2 || uses.size() > most_alternatives) return common;
  std::vector<Code> const around = codes(common);
  std::vector<RegionId> key = {common};
  for (RegionId use : uses) {
    std::vector<Code> const all = codes(use);
    std::vector<Code> rest;
    std::set_difference(all.begin(), all.end(), around.begin(), around.end(), std::back_inserter(rest));
    if (rest.empty()) return common;
    key.push_back(make(rest));
  }
  std::sort(key.begin() + 1, key.end());
  auto [found, is_new] = alternatives_region_.try_emplace(key, everywhere);
  if (is_new) found->second = make_gate(common, {common, {key.begin() + 1, key.end()}});
  return found->second;
}

namespace {

constexpr RegionId unknown = ~RegionId{0};

// Literal of a condition, without negations, so that c and !c become one if and else.
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

// Propagates regions from users to operands. `uses` lists the regions of nodes with several.
void find_needs(Graph const &graph, std::vector<NodeId> const &roots, std::vector<char> const &is_needed,
                std::vector<char> const &is_read, Placement &placement) {
  Regions &regions = placement.regions;
  std::vector<RegionId> &of_node = placement.of_node;
  std::unordered_map<NodeId, std::vector<RegionId>> uses;
  for (NodeId root : roots) of_node[root] = everywhere;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (!is_needed[id]) continue;
    if (is_read[id]) {
      of_node[id] = everywhere;
      continue;
    }
    if (auto found = uses.find(static_cast<NodeId>(id)); found != uses.end()) {
      of_node[id] = regions.either(of_node[id], found->second);
      uses.erase(found);
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
      if (region == unknown) region = use;
      auto several = uses.find(node.operand[i]);
      if (several == uses.end()) {
        if (region == use || region == everywhere) continue;
        several = uses.emplace(node.operand[i], std::vector<RegionId>{region}).first;
      }
      regions.add_use(several->second, use);
      region = regions.intersection(region, use);
    }
  }
}

// Hoists quiet operations, from operands to users.
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

RegionTable tabulate(Regions const &regions, std::size_t node_count, std::vector<RegionId> &region) {
  RegionTable table{static_cast<NodeId>(node_count)};
  std::unordered_map<RegionId, RegionId> number = {{everywhere, everywhere}};
  auto const renumber = [&](RegionId id) {
    auto const [found, is_new] = number.try_emplace(id, static_cast<RegionId>(table.regions.size()));
    if (is_new) table.regions.push_back(regions.literals(id));
    return found->second;
  };
  for (RegionId &id : region) id = renumber(id);
  for (std::size_t gate = node_count; gate < regions.value_count(); ++gate) {
    std::vector<RegionId> &alternatives = table.gates.emplace_back();
    for (RegionId alternative : regions.alternatives(static_cast<NodeId>(gate)))
      alternatives.push_back(renumber(alternative));
  }
  return table;
}

} // namespace symreal
