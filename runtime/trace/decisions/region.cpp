#include "runtime/trace/decisions/region.h"

#include "runtime/trace/decisions/decisions.h"

#include <algorithm>
#include <ctime>
#include <set>
#include <tuple>

namespace symreal::trace {
namespace {

constexpr std::size_t pieces_of_a_late_arm = 200;

// An arm may go round for ever: generous, by how long the program has run.
int milliseconds_for_an_arm() {
  timespec used;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  double const seconds = static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  return static_cast<int>(500 + 20 * 1000 * std::min(seconds, 10.0));
}

} // namespace

Region::Region(Pool &pool, Arms &arms, PartingPoint const &parted, RealNumber condition, bool is_hypothetical,
               std::size_t most_pieces)
    : pool_(pool),
      arms_(arms),
      parted_(parted),
      condition_(condition),
      is_hypothetical_(is_hypothetical),
      most_pieces_(most_pieces) {}

std::optional<int> Region::run() {
  wants_another_round_ = wants_more_arms_ = false;
  ways_.clear();
  where_.clear();
  places_.clear();
  arms_used_ = 1;
  Place root;
  root.condition = condition_;
  root.is_hypothetical = is_hypothetical_;
  root.ways = {0};
  ways_.push_back({});
  places_.push_back(root);
  for (;;) {
    std::optional<std::size_t> const at = next_place();
    if (!at) return std::nullopt;
    bool const is_last = std::ranges::count(places_, false, &Place::has_gone_on) == 1;
    if (places_[*at].ways.size() > 1) merge(*at, is_last);
    int const arm = ways_[places_[*at].ways.front()].arm;
    if (is_last && *at != 0) return arm;
    if (places_[*at].is_end) return std::nullopt; // and so are the others: they have other results
    if (tried_ + 2 > most_pieces_) return std::nullopt;
    if (arms_used_ + 2 > arms_.count()) {
      wants_more_arms_ = arms_.count() < Arms::most;
      return std::nullopt;
    }
    places_[*at].has_gone_on = true;
    arms_.send(arm, {.what = Arms::advance, .arm = {arms_used_, arms_used_ + 1}});
    arms_used_ += 2;
    std::optional<Arms::Report> const report = arms_.receive(milliseconds_for_an_arm());
    if (!report) {
      tried_ += pieces_of_a_late_arm;
      return std::nullopt;
    }
    for (bool outcome : {false, true}) {
      if (report->arm[outcome] == Arms::settled) continue;
      ++costs_.pieces;
      ++tried_;
      if (report->arm[outcome] == Arms::none || !arrive(report->arm[outcome], *at, outcome)) return std::nullopt;
    }
  }
}

// The one that waits for the fewest others.
std::optional<std::size_t> Region::next_place() const {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (places_[k].has_gone_on) continue;
    auto const key = [this](Place const &place) { return std::tuple(place.is_end, rank(place), place.generation); };
    if (!best || key(places_[k]) < key(places_[*best])) best = k;
  }
  return best;
}

int Region::rank(Place const &place) const {
  if (place.ways.empty() || late_.empty() || &place == &places_.front()) return 0;
  ProcessImage const &image = ways_[place.ways.front()].arrival.image;
  return static_cast<int>(
      std::ranges::count_if(late_, [&](ProcessImage const &one) { return one.differences(image).has_value(); }));
}

NodeId Region::here(Way const &way, NodeId node) const {
  return node < parted_.nodes ? node : way.nodes[node - parted_.nodes];
}

RealNumber Region::here(Way const &way, std::uint64_t bits) const {
  RealNumber const number = RealNumber::from_bits(bits);
  return pool_.owns(number) ? pool_.number(here(way, pool_.node(number))) : number;
}

bool Region::arrive(int arm, std::size_t from, bool outcome) {
  std::optional<Arrival> arrival = arms_.arrival(arm);
  if (!arrival) return false;
  std::size_t const number = ways_.size();
  ways_.push_back({arm, from, outcome, std::move(*arrival), {}});
  Way &way = ways_.back();
  way.nodes = pool_.adopt(parted_.nodes, way.arrival.nodes);
  way.arrival.image.renumber(parted_.nodes, way.nodes);
  places_[from].next[outcome] = number;
  bool const is_hypothetical = way.arrival.is_hypothetical;
  auto const has_met = [&](Place const &place) {
    if (&place == &places_.front()) return false;
    Arrival const &other = ways_[place.ways.front()].arrival;
    return other.facts == way.arrival.facts && other.image.differences(way.arrival.image).has_value();
  };
  auto const found = std::ranges::find_if(places_, has_met);
  auto const at = static_cast<std::size_t>(found - places_.begin());
  if (found != places_.end() && found->has_gone_on) {
    wants_another_round_ = !comes_by(from, at); // else it goes round
    late_.push_back(std::move(way.arrival.image));
    return false;
  }
  where_[number] = at;
  if (found == places_.end()) {
    Place place;
    place.condition = RealNumber::from_bits(way.arrival.image.word(way.arrival.image.condition_at()));
    place.arm = here(way, way.arrival.arm.to_bits());
    place.is_hypothetical = is_hypothetical;
    place.is_end = !way.arrival.image.stand();
    places_.push_back(std::move(place));
  }
  Place &place = places_[at];
  // An arm of the program itself comes first: its effects are done, so it goes on for all.
  place.ways.insert(is_hypothetical ? place.ways.end() : place.ways.begin(), number);
  place.is_hypothetical = place.is_hypothetical && is_hypothetical;
  place.generation = std::max(place.generation, places_[from].generation + 1);
  return true;
}

// Whether a way to the place goes through the other.
bool Region::comes_by(std::size_t place, std::size_t before) const {
  if (place == before) return true;
  return place != 0 &&
         std::ranges::any_of(places_[place].ways, [&](std::size_t way) { return comes_by(ways_[way].from, before); });
}

std::optional<Region::Numbers> Region::numbers(std::size_t from, std::size_t to,
                                               std::vector<std::uint64_t *> const &addresses, Known &known) {
  if (auto const found = known.find(from); found != known.end()) return found->second;
  auto const arriving = [&](bool outcome) -> std::optional<Numbers> {
    std::optional<std::size_t> const next = places_[from].next[outcome];
    if (!next) return std::nullopt;
    Way const &way = ways_[*next];
    std::size_t const place = where_.at(*next);
    if (place != to)
      return places_[place].has_gone_on ? numbers(place, to, addresses, known) : std::optional<Numbers>();
    Numbers words;
    for (std::uint64_t *address : addresses) words.push_back(RealNumber::from_bits(way.arrival.image.word(address)));
    return words;
  };
  std::optional<Numbers> const of_no = arriving(false), of_yes = arriving(true);
  if (!of_no) return known[from] = of_yes;
  if (!of_yes) return known[from] = of_no;
  Numbers result;
  for (std::size_t k = 0; k < addresses.size(); ++k) {
    RealNumber const yes = (*of_yes)[k], no = (*of_no)[k];
    result.push_back(k == 0 ? chosen_condition(places_[from].condition, yes, no)
                            : chosen(places_[from].condition, yes, no));
  }
  return known[from] = std::move(result);
}

RealNumber Region::chosen(RealNumber condition, RealNumber yes, RealNumber no) {
  if (yes.to_bits() == no.to_bits()) return yes;
  std::size_t const before = pool_.nodes().size();
  RealNumber const number = pool_.record(Op::select, condition, yes, no);
  if (pool_.node(number) >= before) ++costs_.selects;
  return number;
}

std::vector<std::vector<std::uintptr_t>> Region::decided_at() const {
  std::set<std::vector<std::uintptr_t>> all;
  for (Place const &place : places_)
    if (place.has_gone_on && &place != &places_.front()) all.insert(ways_[place.ways.front()].arrival.stack);
  return {all.begin(), all.end()};
}

// One comparison of selected numbers rather than a select between two.
RealNumber Region::chosen_condition(RealNumber condition, RealNumber yes, RealNumber no) {
  if (yes.to_bits() == no.to_bits() || !yes.is_node() || !no.is_node()) return chosen(condition, yes, no);
  Node const a = pool_.nodes()[pool_.node(yes)], b = pool_.nodes()[pool_.node(no)];
  if (a.op != b.op) return chosen(condition, yes, no);
  switch (a.op) {
  case Op::lt:
  case Op::le:
  case Op::gt:
  case Op::ge:
  case Op::eq:
  case Op::ne:
    return pool_.record(a.op, chosen(condition, pool_.number(a.operand[0]), pool_.number(b.operand[0])),
                        chosen(condition, pool_.number(a.operand[1]), pool_.number(b.operand[1])), 0.0);
  case Op::logical_not:
    return pool_.record(a.op, chosen_condition(condition, pool_.number(a.operand[0]), pool_.number(b.operand[0])), 0.0,
                        0.0);
  default: return chosen(condition, yes, no);
  }
}

// Guards of a place: one that each arm needs on all of its way is needed unconditionally.
std::vector<Guards::Recorded> Region::guards(Place const &place) const {
  struct Needed {
    Guards::Recorded guard;
    bool everywhere = false;
    std::size_t whole = 0; // ways that need it on all of their arm
  };
  std::vector<NodeId> order;
  std::map<NodeId, Needed> all;
  std::set<NodeId> own_arms;
  for (std::size_t k : place.ways) {
    RealNumber const arm = here(ways_[k], ways_[k].arrival.arm.to_bits());
    NodeId const own = arm.is_node() ? pool_.node(arm) : no_node;
    own_arms.insert(own);
    std::set<NodeId> whole;
    for (Guards::Recorded const &one : ways_[k].arrival.guards) {
      Guards::Recorded guard = renumbered(one, [&](NodeId node) { return here(ways_[k], node); });
      auto const [found, is_new] = all.try_emplace(guard.needed, Needed{guard});
      if (is_new) order.push_back(guard.needed);
      Needed &needed = found->second;
      needed.everywhere = needed.everywhere || guard.arms.empty();
      needed.guard.arms.insert(guard.arms.begin(), guard.arms.end());
      if (guard.arms.contains(own) && whole.insert(guard.needed).second) ++needed.whole;
    }
  }
  std::vector<Guards::Recorded> result;
  for (NodeId condition : order) {
    auto &[guard, everywhere, whole] = all.at(condition);
    if (whole == place.ways.size()) {
      for (NodeId arm : own_arms) guard.arms.erase(arm);
      if (place.arm.is_node())
        guard.arms.insert(pool_.node(place.arm));
      else
        everywhere = true;
    }
    if (everywhere) guard.arms.clear();
    result.push_back(std::move(guard));
  }
  return result;
}

// The first of the ways goes on for the others.
void Region::merge(std::size_t at, bool is_last) {
  Place &place = places_[at];
  Way const &first = ways_[place.ways.front()];
  std::uint64_t *const condition_at = first.arrival.image.condition_at();
  std::vector<std::uint64_t *> addresses = {condition_at};
  Arms::Merge merge;
  for (std::size_t k : place.ways) {
    Way const &way = ways_[k];
    if (&way == &first) continue;
    std::optional<std::vector<std::uint64_t *>> const differing = first.arrival.image.differences(way.arrival.image);
    internal_check(differing.has_value()); // or they had not met
    addresses.insert(addresses.end(), differing->begin(), differing->end());
    merge.notes.insert(merge.notes.end(), way.arrival.notes.begin(), way.arrival.notes.end());
  }
  std::ranges::sort(addresses.begin() + 1, addresses.end());
  addresses.erase(std::unique(addresses.begin() + 1, addresses.end()), addresses.end());
  std::erase_if(addresses, [&, k = 0](std::uint64_t *address) mutable { return k++ != 0 && address == condition_at; });
  Known known;
  std::optional<Numbers> const numbers = this->numbers(0, at, addresses, known);
  internal_check(numbers.has_value()); // each of these ways comes from the root
  for (std::size_t k = 0; k < addresses.size(); ++k)
    merge.numbers.emplace_back(addresses[k], pool_.node((*numbers)[k]));
  place.condition = numbers->front();
  std::vector<std::size_t> const &ways = place.ways;
  if (ways.size() == 2 && ways_[ways[0]].from == ways_[ways[1]].from) {
    place.arm = places_[first.from].arm;
  } else {
    SymbolicBool any(false);
    for (std::size_t k : ways) any = any | SymbolicBool::from_condition(here(ways_[k], ways_[k].arrival.arm.to_bits()));
    place.arm = any.condition();
  }
  if (is_last) place.arm = 1.0;
  merge.guards = guards(place);
  merge.arm = place.arm.is_node() ? pool_.node(place.arm) : no_node;
  merge.is_hypothetical = place.is_hypothetical;
  merge.nodes = pool_.rows_from(parted_.nodes);
  MessageWriter writer;
  write_merge(merge, writer);
  arms_.send(first.arm, {.what = Arms::merge}, writer.bytes());
}

} // namespace symreal::trace
