#include "engine/optimise/algebra/reciprocals.h"

namespace symreal::algebra {

Network with_common_reciprocals(Network const &network) {
  std::vector<char> const live = live_nodes(network);
  std::vector<std::uint32_t> quotients(network.size(), 0); // indexed by denominator
  auto is_quotient = [&](Index node) {
    return live[node] && network[node].kind == Kind::quotient && !network[node].is_free();
  };
  for (Index node = 0; node < network.size(); ++node)
    if (is_quotient(node)) ++quotients[network[node].b.node()];

  auto is_common = [&](Index denominator) {
    auto const count = static_cast<int>(quotients[denominator]), division = network.context()->division;
    return division + count < count * division;
  };

  std::vector<Literal> now(network.size());
  auto literal = [&](Literal old) { return now[old.node()].negated_if(old.is_negative()); };
  Network result(network.context());
  for (Index node = 0; node < network.size(); ++node) {
    if (!live[node]) continue;
    Literal const a = network[node].a, b = network[node].b;
    if (is_quotient(node) && is_common(b.node()))
      now[node] = result.product(literal(a), result.quotient(result.one(), literal(b)));
    else
      now[node] = result.copy(network, network[node], literal);
  }
  for (Literal root : network.roots) result.roots.push_back(literal(root));
  return result;
}

} // namespace symreal::algebra
