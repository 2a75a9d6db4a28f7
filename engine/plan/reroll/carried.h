// What the body of a loop carries on: over several iterations from one variable to the next.
#pragma once

#include "engine/plan/reroll/body_builder.h"
#include "engine/plan/reroll/memory.h"

#include <map>

namespace symreal::reroll {

class Carried {
public:
  Carried(BodyBuilder &body, Memory const &memory) : body_(body), memory_(memory) {}

  // Of what operation `next` of the body computes, and of its values in the first iterations.
  NodeId leaf(std::uint32_t next, std::vector<NodeId> first) {
    auto const [entry, is_new] = leaves_.try_emplace({next, first}, no_node);
    if (!is_new) return entry->second;
    Leaf leaf{Leaf::Kind::carried, {memory_.home(first.front())}};
    first.erase(first.begin());
    if (!first.empty()) leaf.next = this->leaf(next, std::move(first));
    return entry->second = body_.leaf(std::move(leaf));
  }

  // Once it is known what the body computes.
  void carry(std::vector<NodeId> const &computed) {
    for (auto const &[key, leaf] : leaves_)
      if (key.second.size() == 1) body_.carry(leaf, computed[key.first]);
  }

private:
  BodyBuilder &body_;
  Memory const &memory_;
  std::map<std::pair<std::uint32_t, std::vector<NodeId>>, NodeId> leaves_;
};

} // namespace symreal::reroll
