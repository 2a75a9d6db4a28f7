// Arms of one decision until all have come together: the places where they have met, and the selects for numbers in
// which they differ.
//
// A place is reached by arms of one or more decisions. The order in which decisions are followed affects only which
// arms meet: a place that has gone on before its last arm came begins anew, in another round, and waits longer.
#pragma once

#include "runtime/trace/decisions/arms.h"

#include <map>

namespace symreal::trace {

struct JoinCosts {
  std::size_t pieces = 0, selects = 0;
};

class Region {
public:
  static constexpr std::size_t most_rounds = 8;

  static constexpr std::size_t unbounded = static_cast<std::size_t>(-1);

  // `most_pieces`: limit on the pieces of a run, all rounds together.
  Region(Pool &pool, Arms &arms, PartingPoint const &parted, RealNumber condition, bool is_hypothetical,
         std::size_t most_pieces);

  // The first arm stands at the decision. Returns the arm in which all ways have come together.
  std::optional<int> run();
  // Whether another round, in which a place waits longer, may succeed.
  bool wants_another_round() const { return wants_another_round_; }
  // Whether a region with more arms may succeed.
  bool wants_more_arms() const { return wants_more_arms_; }
  JoinCosts costs() const { return costs_; }
  // Pieces of all rounds; an arm that does not come to a place in time counts as many as might have run in that time.
  std::size_t tried() const { return tried_; }
  // Addresses of the later decisions at which arms have parted.
  std::vector<std::vector<std::uintptr_t>> decided_at() const;

private:
  // A way that has come to a place: from which place, by which outcome.
  struct Way {
    int arm = 0;
    std::size_t from = 0;
    bool outcome = false;
    Arrival arrival = {};
    std::vector<NodeId> nodes = {}; // those recorded since, as the coordinator has them
  };
  struct Place {
    std::vector<std::size_t> ways = {}; // the first goes on for all
    int generation = 0;
    bool has_gone_on = false, is_end = false; // of the kernel
    std::optional<std::size_t> next[2] = {};  // ways
    RealNumber condition = 1.0, arm = 1.0;
    bool is_hypothetical = false;
  };
  using Numbers = std::vector<RealNumber>;

  bool arrive(int arm, std::size_t from, bool outcome);
  void merge(std::size_t place, bool is_last);
  std::vector<Guards::Recorded> guards(Place const &place) const;
  bool comes_by(std::size_t place, std::size_t before) const;
  // Node or bits of an arm, in the coordinator's numbering.
  NodeId here(Way const &way, NodeId node) const;
  RealNumber here(Way const &way, std::uint64_t bits) const;
  // Memo of the numbers at these addresses, by place; the condition lies at the first address.
  using Known = std::map<std::size_t, std::optional<Numbers>>;
  std::optional<Numbers> numbers(std::size_t from, std::size_t to, std::vector<std::uint64_t *> const &addresses,
                                 Known &known);
  RealNumber chosen(RealNumber condition, RealNumber yes, RealNumber no);
  RealNumber chosen_condition(RealNumber condition, RealNumber yes, RealNumber no);
  int rank(Place const &place) const;
  std::optional<std::size_t> next_place() const;

  Pool &pool_;
  Arms &arms_;
  PartingPoint const parted_;
  RealNumber const condition_;
  bool const is_hypothetical_;
  std::vector<Way> ways_;
  std::vector<Place> places_;
  std::vector<ProcessImage> late_;           // places that have gone on too early, in earlier rounds
  std::map<std::size_t, std::size_t> where_; // by way: the place
  bool wants_another_round_ = false, wants_more_arms_ = false;
  std::size_t const most_pieces_;
  std::size_t tried_ = 0;
  int arms_used_ = 0;
  JoinCosts costs_;
};

} // namespace symreal::trace
