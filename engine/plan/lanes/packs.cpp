#include "engine/plan/lanes/packs.h"

#include <algorithm>
#include <utility>

namespace symreal::lanes {

namespace {

// Operations on several nodes as one vector operation.
struct Match {
  Op op;
  std::vector<char> subtracts = {};           // as in Vector
  std::array<std::vector<NodeId>, 2> operand; // the second is empty for unary operations
};

constexpr int deepest_look = 3;

// Mismatch of two values in lanes at this distance: 0 for one node, or for elements at the same distance.
class Distance {
public:
  Distance(ScalarFunction const &function, std::ptrdiff_t lanes) : function_(function), lanes_(lanes) {}

  double between(NodeId x, NodeId y, int depth = deepest_look) const {
    if (x == y) return 0;
    if (function_.is_constant(x) && function_.is_constant(y)) return 1;
    if (function_.is_element(x) && function_.is_element(y)) return elements(function_.element(x), function_.element(y));
    if (!function_.can_be_packed(x) || !function_.can_be_packed(y)) return unlike;
    Node const &a = function_.node(x), &b = function_.node(y);
    if (kind(a.op) != kind(b.op)) return unlike;
    if (depth == 0) return 1;
    double apart = pair(a, b, 0, 0, depth);
    if (arity(a.op) == 2) {
      apart += pair(a, b, 1, 1, depth);
      if (exchanges(a.op) || exchanges(b.op))
        apart = std::min(apart, pair(a, b, 0, 1, depth) + pair(a, b, 1, 0, depth));
    }
    return std::min(apart / 2, unlike - 1);
  }

  static Op kind(Op op) { return op == Op::sub ? Op::add : op; }
  static bool exchanges(Op op) { return op == Op::add || op == Op::mul; }

private:
  static constexpr double unlike = 8;

  double pair(Node const &a, Node const &b, std::size_t i, std::size_t k, int depth) const {
    return between(a.operand[i], b.operand[k], depth - 1);
  }
  double elements(Element x, Element y) const {
    if (x.array != y.array) return unlike;
    auto const apart = static_cast<std::ptrdiff_t>(y.index) - static_cast<std::ptrdiff_t>(x.index) - lanes_;
    return apart == 0 ? 0 : 1 + static_cast<double>(std::min<std::ptrdiff_t>(std::abs(apart), 32)) / 8;
  }

  ScalarFunction const &function_;
  std::ptrdiff_t lanes_;
};

// Matched operations; nullopt if they differ, have no vector form, or are all the same node.
std::optional<Match> match(ScalarFunction const &function, std::vector<NodeId> const &nodes) {
  Op const kind = Distance::kind(function.node(nodes[0]).op);
  bool all_same = true;
  for (NodeId id : nodes) {
    if (!function.can_be_packed(id) || Distance::kind(function.node(id).op) != kind) return {};
    all_same = all_same && id == nodes[0];
  }
  if (all_same) return {};
  auto const is_sub = [&](NodeId id) { return function.node(id).op == Op::sub; };
  auto const subs = std::ranges::count_if(nodes, is_sub);
  Match result{.op = subs == std::ssize(nodes) ? Op::sub : kind, .operand = {}};
  if (subs != 0 && result.op != Op::sub)
    for (NodeId id : nodes) result.subtracts.push_back(is_sub(id));
  if (arity(kind) == 1) {
    for (NodeId id : nodes) result.operand[0].push_back(function.node(id).operand[0]);
    return result;
  }
  // The operands of a difference cannot be exchanged, so the first difference, if any, determines the order for all.
  std::size_t const anchor =
      subs == 0 ? 0 : static_cast<std::size_t>(std::ranges::find_if(nodes, is_sub) - nodes.begin());
  Node const &like = function.node(nodes[anchor]);
  for (std::size_t lane = 0; lane < nodes.size(); ++lane) {
    Node const &node = function.node(nodes[lane]);
    NodeId x = node.operand[0], y = node.operand[1];
    Distance const distance(function, static_cast<std::ptrdiff_t>(lane) - static_cast<std::ptrdiff_t>(anchor));
    if (Distance::exchanges(node.op) && distance.between(like.operand[0], y) + distance.between(like.operand[1], x) <
                                            distance.between(like.operand[0], x) + distance.between(like.operand[1], y))
      std::swap(x, y);
    result.operand[0].push_back(x);
    result.operand[1].push_back(y);
  }
  return result;
}

} // namespace

VectorId Packs::grow(std::vector<NodeId> const &nodes) {
  VectorId const root = find_or_add(nodes);
  while (!new_.empty()) {
    VectorId const id = new_.back();
    new_.pop_back();
    try_operation(id);
  }
  return root;
}

VectorId Packs::find_or_add(std::vector<NodeId> const &nodes) {
  auto const [at, is_new] = by_nodes_.try_emplace(nodes, static_cast<VectorId>(packs_.size()));
  if (is_new) {
    packs_.push_back({nodes});
    new_.push_back(at->second);
  }
  return at->second;
}

void Packs::try_operation(VectorId id) {
  std::vector<NodeId> const nodes = packs_[id].nodes;
  std::optional<Match> const found = match(function_, nodes);
  if (!found || shuffled(nodes)) return;
  for (std::size_t i = 0; i < 2 && !found->operand[i].empty(); ++i) {
    VectorId const operand = find_or_add(found->operand[i]);
    packs_[id].operand[i] = operand;
  }
  packs_[id].op = found->op;
  packs_[id].subtracts = found->subtracts;
  set_operation(id, true);
}

void Packs::set_operation(VectorId id, bool is_operation) {
  if (std::exchange(packs_[id].is_operation, is_operation) == is_operation) return;
  for (std::uint32_t lane = 0; lane < packs_[id].nodes.size(); ++lane) {
    std::vector<Lane> &places = places_[packs_[id].nodes[lane]];
    if (is_operation)
      places.push_back({id, lane});
    else
      std::erase_if(places, [&](Lane const &place) { return place.vector == id; });
  }
}

void Packs::cut(std::size_t size) {
  while (packs_.size() > size) {
    auto const id = static_cast<VectorId>(packs_.size() - 1);
    if (packs_[id].is_operation) set_operation(id, false);
    by_nodes_.erase(packs_[id].nodes);
    packs_.pop_back();
  }
}

Source Packs::source(VectorId id) const {
  std::vector<NodeId> const &nodes = packs_[id].nodes;
  if (std::ranges::all_of(nodes, [&](NodeId node) { return function_.is_constant(node); }))
    return {Vector::Form::constants};
  bool const is_one = std::ranges::all_of(nodes, [&](NodeId node) { return node == nodes[0]; });
  if (is_one && !place(nodes[0]).is_given()) return {Vector::Form::splat};
  if (auto source = loaded(nodes)) return *source;
  if (auto source = shuffled(nodes)) return *source;
  if (auto source = column(nodes)) return *source;
  return {Vector::Form::build};
}

// Lane of the part that has the node.
std::optional<std::uint32_t> Packs::lane_in(NodeId node, Source::Window const &part) const {
  if (part.is_load()) {
    if (!function_.is_element(node)) return {};
    Element const element = function_.element(node);
    bool const is_there =
        element.array == part.array && element.index >= part.first && element.index < part.first + function_.width();
    if (!is_there) return {};
    return static_cast<std::uint32_t>(element.index - part.first);
  }
  for (Lane const &place : places_[node])
    if (place.vector == part.pack) return place.lane;
  return {};
}

// Shuffle of nodes that are all in the first part, or in it and one of the others.
std::optional<Source> Packs::from_parts(std::vector<NodeId> const &nodes, Source::Window const &first,
                                        std::vector<Source::Window> const &others) const {
  auto const try_parts = [&](std::vector<Source::Window> const &parts) -> std::optional<Source> {
    Source source{Vector::Form::shuffle, parts, {}};
    for (NodeId node : nodes) {
      std::optional<std::uint32_t> lane = lane_in(node, parts[0]);
      if (!lane && parts.size() == 2) {
        lane = lane_in(node, parts[1]);
        if (lane) *lane += static_cast<std::uint32_t>(function_.width());
      }
      if (!lane) return {};
      source.from.push_back(*lane);
    }
    return source;
  };
  if (auto source = try_parts({first})) return source;
  for (Source::Window const &other : others)
    if (auto source = try_parts({first, other})) return source;
  return {};
}

// Shuffle of computed lanes.
std::optional<Source> Packs::shuffled(std::vector<NodeId> const &nodes) const {
  if (std::ranges::any_of(nodes, [&](NodeId node) { return places_[node].empty(); })) return {};
  std::optional<Source> of_two;
  for (Lane const &place : places_[nodes[0]]) {
    Source::Window const first{.pack = place.vector};
    auto const outside = std::ranges::find_if(nodes, [&](NodeId node) { return !lane_in(node, first); });
    std::vector<Source::Window> others;
    if (outside != nodes.end())
      for (Lane const &other : places_[*outside]) others.push_back({.pack = other.vector});
    std::optional<Source> source = from_parts(nodes, first, others);
    if (source && source->parts.size() == 1) return source;
    if (source && !of_two) of_two = std::move(source);
  }
  return of_two;
}

// Load of contiguous elements of one array, or shuffle of one or two windows of it.
std::optional<Source> Packs::loaded(std::vector<NodeId> const &nodes) const {
  if (!std::ranges::all_of(nodes, [&](NodeId node) { return function_.is_element(node); })) return {};
  Array const array = function_.element(nodes[0]).array;
  std::size_t const width = function_.width(), extent = function_.extent(array);
  if (extent < width ||
      !std::ranges::all_of(nodes, [&](NodeId node) { return function_.element(node).array == array; }))
    return {};
  auto const index = [&](std::size_t lane) { return function_.element(nodes[lane]).index; };
  auto const window = [&](std::size_t first) {
    return Source::Window{.array = array, .first = std::min(first, extent - width)};
  };
  bool side_by_side = true;
  for (std::size_t lane = 1; lane < width; ++lane) side_by_side = side_by_side && index(lane) == index(0) + lane;
  if (side_by_side) return Source{Vector::Form::load, {window(index(0))}, {}};
  std::size_t lowest = index(0), highest = index(0);
  for (std::size_t lane = 1; lane < width; ++lane) {
    lowest = std::min(lowest, index(lane));
    highest = std::max(highest, index(lane));
  }
  // Windows that begin at multiples of the width are shared more often.
  Source::Window const low = window(lowest / width * width), high = window(highest / width * width);
  if (auto source = from_parts(nodes, low, {})) return source;
  if (highest - lowest < width) return from_parts(nodes, window(lowest), {});
  return from_parts(nodes, low, {high});
}

// Strided elements of one array, whose surrounding rows are inside the array.
std::optional<Source> Packs::column(std::vector<NodeId> const &nodes) const {
  if (!std::ranges::all_of(nodes, [&](NodeId node) { return function_.is_element(node); })) return {};
  Element const first = function_.element(nodes[0]), second = function_.element(nodes[1]);
  std::size_t const width = function_.width();
  if (second.index <= first.index) return {};
  std::size_t const stride = second.index - first.index, row = first.index / width * width;
  for (std::size_t lane = 0; lane < width; ++lane) {
    Element const element = function_.element(nodes[lane]);
    if (element.array != first.array || element.index != first.index + lane * stride) return {};
  }
  if (row + (width - 1) * stride + width > function_.extent(first.array)) return {};
  return Source{.form = Vector::Form::build,
                .parts = {{.array = first.array, .first = row}},
                .column = first.index - row,
                .stride = stride};
}

} // namespace symreal::lanes
