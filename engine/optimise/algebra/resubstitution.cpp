#include "engine/optimise/algebra/resubstitution.h"

#include "engine/optimise/algebra/proposals.h"

#include <algorithm>

namespace symreal::algebra {

namespace {

class Resubstitution {
public:
  Resubstitution(Network const &network, ResubstitutionSettings const &settings, Search &search)
      : network_(network),
        settings_(settings),
        search_(search),
        proposals_(network_, settings, search) {}

  Network run() {
    for (Index node : order()) {
      if (search_.is_over()) break;
      if (!network_.is_alive(node)) continue;
      Proposal const best = proposals_.best_for(node);
      if (best.gain > 0 || (best.gain == 0 && chance() < settings_.sideways)) apply(node, best);
    }
    return network_.finished();
  }

private:
  double chance() { return static_cast<double>(search_.random() >> 11) * 0x1p-53; }

  std::vector<Index> order() {
    std::vector<Index> nodes;
    for (Index node = 0; node < network_.size(); ++node)
      if (network_.is_alive(node) && network_.cost(node) != 0) nodes.push_back(node);
    for (std::size_t i = nodes.size(); i > 1; --i) std::swap(nodes[i - 1], nodes[search_.random() % i]);
    if (settings_.largest_first) {
      std::vector<int> size(network_.size());
      for (Index node : nodes) size[node] = network_.cone_cost(node);
      std::ranges::stable_sort(nodes, std::greater(), [&](Index node) { return size[node]; });
    }
    return nodes;
  }

  void apply(Index target, Proposal const &proposal) {
    std::array<Literal, 3> results{};
    Literal constant;
    if (std::ranges::any_of(proposal.steps, [](auto &step) { return step.b == Proposal::constant_result(); })) {
      constant = network_.constant(proposal.constant);
      proposals_.add(constant.node());
    }
    auto now = [&](Literal literal) {
      if (!Proposal::is_result(literal)) return literal;
      std::uint32_t const step = (literal.bits - Proposal::first_result) / 2;
      return (step == 7 ? constant : results[step]).negated_if((literal.bits - Proposal::first_result) % 2 != 0);
    };
    int const last = proposal.operations - 1;
    for (int i = 0; i < last; ++i) {
      results[i] = network_.make(proposal.steps[i].kind, now(proposal.steps[i].a), now(proposal.steps[i].b));
      proposals_.add(results[i].node());
    }
    network_.replace(target, proposal.steps[last].kind, now(proposal.steps[last].a), now(proposal.steps[last].b));
  }

  MutableNetwork network_;
  ResubstitutionSettings const &settings_;
  Search &search_;
  Proposals proposals_;
};

} // namespace

Network resubstituted(Network const &network, ResubstitutionSettings const &settings, Search &search) {
  return Resubstitution(network, settings, search).run();
}

} // namespace symreal::algebra
