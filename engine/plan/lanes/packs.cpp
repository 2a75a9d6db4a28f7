#include "engine/plan/lanes/packs.h"

#include "engine/plan/lanes/match.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace symreal::lanes {

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
std::optional<std::uint32_t> Packs::lane_in(NodeId node, Source::Part const &part) const {
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
std::optional<Source> Packs::from_parts(std::vector<NodeId> const &nodes, Source::Part const &first,
                                        std::vector<Source::Part> const &others) const {
  auto const try_parts = [&](std::vector<Source::Part> const &parts) -> std::optional<Source> {
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
  for (Source::Part const &other : others)
    if (auto source = try_parts({first, other})) return source;
  return {};
}

// Shuffle of computed lanes.
std::optional<Source> Packs::shuffled(std::vector<NodeId> const &nodes) const {
  if (std::ranges::any_of(nodes, [&](NodeId node) { return places_[node].empty(); })) return {};
  std::optional<Source> of_two;
  for (Lane const &place : places_[nodes[0]]) {
    Source::Part const first{.pack = place.vector};
    auto const outside = std::ranges::find_if(nodes, [&](NodeId node) { return !lane_in(node, first); });
    std::vector<Source::Part> others;
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
    return Source::Part{.array = array, .first = std::min(first, extent - width)};
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
  Source::Part const low = window(lowest / width * width), high = window(highest / width * width);
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
