#include "runtime/trace/decisions/explored_path.h"

#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/decisions/decisions.h"
#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/decisions/known_outcomes.h"
#include "runtime/trace/describe/describe.h"
#include "runtime/trace/kernel/kernel.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/call_stack.h"
#include "runtime/trace/report/events.h"
#include "runtime/wire/request.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

namespace symreal::trace {
namespace {

int taken_file() {
  static int const file =
      open((record_directory() + "/taken").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  return file;
}

// The file `taken`. Written at once: the program may end in any way.
void note_taken(char outcome) { (void)!write(taken_file(), &outcome, 1); }

std::size_t number(std::string_view text) {
  std::size_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

} // namespace

bool ExploredPath::is_asked_for() { return wire::requested(wire::Entry::path) != nullptr; }

void ExploredPath::begin() {
  std::size_t const kernel = kernels_++;
  count_ = followed_ = beyond_ = 0;
  is_explored_ = is_hypothetical_ = is_cut_at_end_ = false;
  prescribed_.clear();
  known_ = KnownOutcomes(floating_point() == FloatingPoint::strict);
  char const *const asked = wire::requested(wire::Entry::path);
  std::string_view const path = asked ? asked : "";
  std::size_t const first = path.find(':'), second = path.find(':', first + 1), last = path.rfind(':');
  if (first == path.npos || number(path.substr(0, first)) != kernel) return;
  is_explored_ = true;
  (void)!ftruncate(taken_file(), 0); // notes of a process that went back to here (checkpoint.h)
  prescribed_ = path.substr(first + 1, second - first - 1);
  depth_ = number(path.substr(second + 1));
  explores_zeros_ = path.substr(second).find('z') != path.npos;
  pieces_left_ = number(path.substr(last + 1));
  is_cut_at_end_ = prescribed_.ends_with('!');
  if (is_cut_at_end_) prescribed_.pop_back();
}

std::optional<bool> ExploredPath::known(NodeId condition) const {
  NodeTable const &nodes = pool_.nodes();
  std::optional<bool> const outcome = known_.outcome(nodes, condition);
  return outcome ? outcome : outcome_of_bounds(nodes, condition);
}

std::optional<ExploredPath::Assumed> ExploredPath::assumed(NodeId condition, bool carried) const {
  NodeTable const &nodes = pool_.nodes();
  auto const may_be = [&](std::optional<bool> outcome) { return outcome && (is_hypothetical_ || *outcome == carried); };
  std::optional<bool> const nonzero = explores_zeros_ ? std::nullopt : outcome_without_zero(nodes, condition);
  if (may_be(nonzero)) return Assumed{*nonzero, Guards::Reason::zero};
  std::optional<bool> const in_range = outcome_in_ranges(nodes, condition, kernel_.interface().inputs);
  return may_be(in_range) ? std::optional(Assumed{*in_range, Guards::Reason::range}) : std::nullopt;
}

bool ExploredPath::decide(Stand &stand) {
  for (;;) {
    RealNumber const condition = RealNumber::from_bits(stand.condition);
    bool const carried = pool_.carried_value(condition) != 0;
    if (!condition.is_node()) return carried; // all that came together here agree
    NodeId const id = pool_.node(condition);
    if (std::optional<bool> const outcome = known(id)) {
      ++followed_;
      is_hypothetical_ = is_hypothetical_ || *outcome != carried;
      return *outcome;
    }
    if (!is_explored_) { // this kernel's turn is in another run
      if (count_++ == 0) event(events::Undecided{kernels_ - 1});
      return carried;
    }
    bool const is_arm = join_.is_arm();
    if (std::optional<Assumed> const one = assumed(id, carried)) {
      if (is_arm) {
        guards_.add(SymbolicBool::from_condition(condition), one->outcome, one->reason);
        known_.add(pool_.nodes(), id, one->outcome);
      } else {
        bool const is_by_range = one->reason == Guards::Reason::range;
        tell(id, one->outcome, condition, is_by_range ? (one->outcome ? "Y" : "N") : one->outcome ? "T" : "F");
      }
      is_hypothetical_ = is_hypothetical_ || one->outcome != carried;
      return one->outcome;
    }
    if (is_arm) {
      if (count_ >= depth_) join_.leave();
      if (std::optional<bool> const outcome = join_.stand(stand, *this)) return take_in_arm(stand, *outcome);
      end_attempt(); // this process is the program now, and decides here
      continue;
    }
    if (count_ >= depth_) {
      if (is_hypothetical_) kernel_.sink().cut_off();
      guards_.add(SymbolicBool::from_condition(condition), carried);
      known_.add(pool_.nodes(), id, carried);
      ++beyond_;
      return carried;
    }
    bool const is_prescribed = count_ < prescribed_.size();
    if (is_prescribed ? prescribed_[count_] == 'j' : pieces_left_ != 0) {
      begin_attempt(condition);
      std::size_t const most = is_prescribed ? Region::unbounded : pieces_left_;
      if (std::optional<bool> const outcome = join_.attempt(stand, *this, most)) return take_in_arm(stand, *outcome);
      note_in_vain(join_.tried());
    }
    bool const outcome = is_prescribed ? prescribed_[count_] == 't' : carried;
    is_hypothetical_ = is_hypothetical_ || outcome != carried;
    take(id, outcome, condition);
    if (is_cut_at_end_ && count_ == prescribed_.size()) kernel_.sink().cut_off();
    return outcome;
  }
}

// Takes an outcome in a process that executes an arm.
bool ExploredPath::take_in_arm(Stand const &stand, bool outcome) {
  RealNumber const number = RealNumber::from_bits(stand.condition);
  bool const carried = pool_.carried_value(number) != 0;
  is_hypothetical_ = is_hypothetical_ || outcome != carried;
  if (!number.is_node()) return outcome;
  NodeId const id = pool_.node(number);
  SymbolicBool const condition = SymbolicBool::from_condition(number);
  if (std::optional<Assumed> const one = assumed(id, carried); one && one->outcome == outcome) {
    guards_.add(condition, outcome, one->reason);
  } else {
    conditions_.arm = (SymbolicBool::from_condition(conditions_.arm) & (outcome ? condition : !condition)).condition();
    ++count_;
  }
  known_.add(pool_.nodes(), id, outcome);
  return outcome;
}

std::optional<bool> ExploredPath::settled(RealNumber condition) const {
  bool const carried = pool_.carried_value(condition) != 0;
  if (!condition.is_node()) return carried;
  NodeId const id = pool_.node(condition);
  if (std::optional<bool> const outcome = known(id)) return outcome;
  std::optional<Assumed> const one = assumed(id, carried);
  return one ? std::optional(one->outcome) : std::nullopt;
}

void ExploredPath::forget(bool is_hypothetical) {
  known_ = known_before_;
  is_hypothetical_ = is_hypothetical;
}

void ExploredPath::begin_attempt(RealNumber condition) {
  known_before_ = known_;
  count_before_ = count_;
  guards_before_ = guards_.recorded().size();
  attempted_ = condition;
  attempted_at_ = call_stack();
}

void ExploredPath::note_in_vain(std::size_t pieces) {
  pieces_left_ -= std::min(pieces_left_, pieces);
  event(events::InVain{pieces});
}

// The decision at which the arms have parted is joined, so it does not count as one between paths.
void ExploredPath::end_attempt() {
  count_ = count_before_ + 1;
  known_ = known_before_;
  JoinCosts const costs = join_.costs();
  event(events::Decided{pool_.node(attempted_), "j", describe(attempted_), attempted_at_});
  event(events::JoinedAt{attempted_at_});
  auto const guards = [this](Guards::Reason reason) { return guards_.count(guards_before_, reason); };
  event(events::Joined{costs.pieces, costs.selects, guards(Guards::Reason::zero), guards(Guards::Reason::range)});
  note_taken('j');
}

void ExploredPath::end_arm(std::vector<NodeId> &results, std::size_t interface) {
  std::vector<RealNumber> numbers;
  for (NodeId id : results) numbers.push_back(pool_.number(id));
  join_.stand_at_end(numbers, interface, *this);
  for (std::size_t k = 0; k < results.size(); ++k) results[k] = pool_.node(numbers[k]);
  end_attempt();
}

void ExploredPath::take(NodeId condition, bool outcome, RealNumber number) {
  ++count_;
  tell(condition, outcome, number, outcome ? "t" : "f");
  note_taken(outcome ? 't' : 'f');
}

void ExploredPath::tell(NodeId condition, bool outcome, RealNumber number, char const *letter) {
  known_.add(pool_.nodes(), condition, outcome);
  event(events::Decided{condition, letter, describe(number), call_stack()});
}

void ExploredPath::end() {
  if (is_explored_ && followed_ != 0) event(events::Followed{followed_});
  if (beyond_ != 0) event(events::Beyond{beyond_});
}

} // namespace symreal::trace
