#include "engine/plan/lanes/seeds.h"

#include <algorithm>
#include <bit>
#include <map>

namespace symreal::lanes {

namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (std::rotl(hash, 23) ^ word) * 0x9E3779B97F4A7C15;
  return hash ^ hash >> 32;
}

// Per node: hash of its shape, and sum of the indices that it reads.
class Shapes {
public:
  // Shapes of whole expressions, or of a few levels of operations.
  Shapes(Function const &function, Depth depth) : function_(function), count_(function.graph().nodes.size()) {
    shape.resize(count_);
    place.resize(count_, 0);
    for (NodeId id = 0; id < count_; ++id)
      if (function.is_computed(id))
        shape[id] = 4;
      else
        set_leaf(id);
    if (depth == Depth::whole) deepen(shape, place);
    for (int k = 0; depth == Depth::few && k < few; ++k) deepen(std::vector(shape), std::vector(place));
  }

  std::vector<std::uint64_t> shape, place;

private:
  static constexpr int few = 3;

  void set_leaf(NodeId id) {
    bool const is_element = function_.is_element(id);
    shape[id] = is_element ? 2 + static_cast<std::uint64_t>(function_.element(id).array) : 1;
    if (is_element) place[id] = function_.element(id).index;
  }

  // Extends the shapes by those of the operands, which may be updated in place.
  void deepen(std::vector<std::uint64_t> const &shapes, std::vector<std::uint64_t> const &places) {
    for (NodeId id = 0; id < count_; ++id) {
      if (!function_.is_computed(id)) continue;
      Node const &node = function_.node(id);
      std::uint64_t hash = mixed(5, static_cast<std::uint64_t>(node.op == Op::sub ? Op::add : node.op)), sum = 0;
      std::vector<std::uint64_t> operands;
      for (unsigned i = 0; i < arity(node.op); ++i) {
        operands.push_back(shapes[node.operand[i]]);
        sum += places[node.operand[i]];
      }
      if (node.op == Op::add || node.op == Op::mul || node.op == Op::sub) std::ranges::sort(operands);
      for (std::uint64_t operand : operands) hash = mixed(hash, operand);
      shape[id] = hash;
      place[id] = sum;
    }
  }

  Function const &function_;
  std::size_t count_;
};

} // namespace

std::vector<std::vector<std::vector<NodeId>>> alike(Function const &function, std::vector<NodeId> const &nodes,
                                                    Depth depth) {
  Shapes const shapes(function, depth);
  std::map<std::uint64_t, std::size_t> number; // of a shape, in order of its first node
  std::vector<std::vector<NodeId>> groups;
  for (NodeId id : nodes) {
    if (!function.can_be_packed(id)) continue;
    auto const [at, is_new] = number.try_emplace(shapes.shape[id], groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(id);
  }
  std::vector<std::vector<std::vector<NodeId>>> result;
  for (std::vector<NodeId> const &group : groups) {
    if (group.size() < function.width()) continue;
    result.push_back({group});
    std::ranges::sort(result.back()[0]);
    std::vector<NodeId> by_place = result.back()[0];
    std::ranges::stable_sort(by_place, {}, [&](NodeId id) { return shapes.place[id]; });
    if (by_place != result.back()[0]) result.back().push_back(std::move(by_place));
  }
  return result;
}

} // namespace symreal::lanes
