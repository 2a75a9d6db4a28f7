#include "engine/optimise/algebra/mutable_network.h"

namespace symreal::algebra {

// The length of the largest window of the search.
static constexpr std::size_t farthest = 1000;

MutableNetwork::MutableNetwork(Network const &network) : source_(network), by_value_(network.size()) {
  std::vector<char> live = live_nodes(network);
  live[network.zero().node()] = live[network.one().node()] = 1;
  for (Index node = 0; node < network.size(); ++node) {
    nodes_.push_back(network[node]);
    references_.push_back(0);
    users_.emplace_back();
    visited_.push_back(0);
    if (!live[node]) continue;
    if (std::uint32_t &known = by_value_[network[node].value.key()]; known == KeyTable::none) known = node;
    network.for_each_operand(network[node], [&](Literal operand) { add_user(operand, node); });
  }
  for (Literal root : network.roots) ++references_[root.node()];
  for (Literal always : {network.zero(), network.one()}) ++references_[always.node()];
  roots_ = network.roots;
}

Value MutableNetwork::value(Literal literal) const {
  Value const &value = nodes_[literal.node()].value;
  return literal.is_negative() ? -value : value;
}

void MutableNetwork::add_user(Literal operand, Index user) {
  ++references_[operand.node()];
  users_[operand.node()].push_back(user);
}

Index MutableNetwork::find(Residue first) const {
  std::uint32_t const node = by_value_.find(magnitude(first));
  return node != KeyTable::none && is_alive(node) ? node : no_index;
}

// Drops the references of dead nodes to their operands, for at most `most` nodes.
int MutableNetwork::release_operands(Index node, std::size_t most) {
  int freed = 0;
  released_.clear();
  open_ = {node};
  while (!open_.empty() && released_.size() < most) {
    Index const at = open_.back();
    open_.pop_back();
    released_.push_back(at);
    for_each_operand(at, [&](Literal operand) {
      if (--references_[operand.node()] != 0) return;
      freed += cost(operand.node());
      open_.push_back(operand.node());
    });
  }
  return freed;
}

int MutableNetwork::cone_cost(Index node) { return freed(node, {}) + cost(node); }

int MutableNetwork::freed(Index node, std::span<Literal const> kept) {
  for (Literal literal : kept) ++references_[literal.node()];
  int const count = release_operands(node, farthest);
  for (Index released : released_) for_each_operand(released, [&](Literal operand) { ++references_[operand.node()]; });
  for (Literal literal : kept) --references_[literal.node()];
  return count;
}

void MutableNetwork::look_for_users(Index node) {
  ++search_;
  open_ = {node};
  visited_[node] = search_;
  for (std::size_t visits = 0; !open_.empty(); ++visits) {
    far_visits_ += visits > farthest;
    Index const at = open_.back();
    open_.pop_back();
    for (Index user : users_[at]) {
      if (visited_[user] == search_ || !is_alive(user)) continue;
      bool is_user = false;
      for_each_operand(user, [&](Literal operand) { is_user = is_user || operand.node() == at; });
      if (!is_user) continue;
      visited_[user] = search_;
      open_.push_back(user);
    }
  }
}

Index MutableNetwork::append(NetworkNode const &node) {
  auto const made = static_cast<Index>(nodes_.size());
  nodes_.push_back(node);
  references_.push_back(0);
  users_.emplace_back();
  visited_.push_back(0);
  by_value_[node.value.key()] = made; // the latest of equal nodes is alive
  return made;
}

Literal MutableNetwork::constant(Value const &value) {
  return Literal::of(append({Kind::constant, Attribute::constant, no_hazard, {}, {}, value}));
}

Literal MutableNetwork::make(Kind kind, Literal a, Literal b) {
  Value const made = kind == Kind::sum ? value(a) + value(b) : value(a) * value(b);
  NetworkNode const &x = nodes_[a.node()], &y = nodes_[b.node()];
  NetworkNode const node = {
      kind, std::max(x.attribute, y.attribute), source_.hazards().unite(x.hazards, y.hazards), a, b, made};
  Index const id = append(node);
  add_user(a, id);
  add_user(b, id);
  return Literal::of(id);
}

void MutableNetwork::replace(Index node, Kind kind, Literal a, Literal b) {
  Value const made = kind == Kind::sum ? value(a) + value(b) : value(a) * value(b);
  if (!equal_in_field(made, nodes_[node].value)) {
    a = -a;
    if (kind == Kind::sum) b = -b;
  }
  add_user(a, node);
  add_user(b, node);
  release_operands(node, nodes_.size());
  nodes_[node].kind = kind;
  nodes_[node].a = a;
  nodes_[node].b = b;
}

// Copies operands before users, whose order `replace` may have broken.
Network MutableNetwork::finished() const {
  Network result(source_.context());
  LiteralMap now(nodes_.size());
  std::vector<char> is_done(nodes_.size(), 0);
  for (Literal root : roots_) {
    std::vector<Index> open = {root.node()};
    while (!open.empty()) {
      Index const at = open.back();
      std::size_t const before = open.size();
      if (!is_done[at])
        for_each_operand(at, [&](Literal operand) {
          if (!is_done[operand.node()]) open.push_back(operand.node());
        });
      if (open.size() != before) continue;
      open.pop_back();
      if (std::exchange(is_done[at], char{1})) continue;
      now[at] = result.copy(source_, nodes_[at], now);
    }
  }
  for (Literal root : roots_) result.roots.push_back(now(root));
  return result;
}

} // namespace symreal::algebra
