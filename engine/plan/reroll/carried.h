// Loop-carried values of a body: a value that is read several iterations later moves from variable to variable.
#pragma once

#include "engine/plan/reroll/body_builder.h"
#include "engine/plan/reroll/memory.h"

#include <map>

namespace symreal::reroll {

class Carried {
public:
  Carried(BodyBuilder &body, Memory const &memory) : body_(body), memory_(memory) {}

  // Leaf for the value of body operation `next`; `first`: its values in the first iterations.
  NodeId leaf(std::uint32_t next, std::vector<NodeId> first) {
    auto const [entry, is_new] = leaves_.try_emplace({next, first}, no_node);
    if (!is_new) return entry->second;
    Leaf leaf{Leaf::Kind::carried, {memory_.home(first.front())}};
    first.erase(first.begin());
    if (!first.empty()) leaf.next = this->leaf(next, std::move(first));
    return entry->second = body_.leaf(std::move(leaf));
  }

  // Completes the leaves once the body's operations exist.
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
