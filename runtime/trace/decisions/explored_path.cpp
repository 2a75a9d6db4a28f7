#include "trace/decisions/explored_path.h"

#include "trace/decisions/guards.h"
#include "trace/decisions/policy.h"
#include "trace/decisions/zero_test.h"
#include "trace/describe/describe.h"
#include "trace/kernel/kernel.h"
#include "trace/nodes/pool.h"
#include "trace/report/call_stack.h"
#include "trace/report/events.h"

#include <charconv>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

namespace symreal::trace {
namespace {

// The file `taken`. Written at once: the program may end in any way.
void note_taken(bool outcome) {
  static int const file = open((record_directory() + "/taken").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  (void)!write(file, outcome ? "t" : "f", 1);
}

std::size_t number(std::string_view text) {
  std::size_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

} // namespace

ExploredPath &ExploredPath::current() {
  static constinit thread_local ExploredPath *path = nullptr;
  if (!path) path = new ExploredPath;
  return *path;
}

bool ExploredPath::is_asked_for() { return std::getenv("SYMREAL_PATH"); }

void ExploredPath::begin() {
  std::size_t const kernel = kernels_++;
  count_ = followed_ = beyond_ = 0;
  is_explored_ = is_hypothetical_ = is_cut_at_end_ = false;
  prescribed_.clear();
  known_ = KnownOutcomes(floating_point() == FloatingPoint::strict);
  char const *const asked = std::getenv("SYMREAL_PATH");
  std::string_view const path = asked ? asked : "";
  std::size_t const first = path.find(':'), last = path.rfind(':');
  if (first == path.npos || number(path.substr(0, first)) != kernel) return;
  is_explored_ = true;
  prescribed_ = path.substr(first + 1, last - first - 1);
  depth_ = number(path.substr(last + 1));
  explores_zeros_ = path.ends_with('z');
  is_cut_at_end_ = prescribed_.ends_with('!');
  if (is_cut_at_end_) prescribed_.pop_back();
}

bool ExploredPath::decide(RealNumber condition, bool carried) {
  Pool &pool = Pool::current();
  NodeId const id = pool.node(condition);
  if (std::optional<bool> const known = known_.outcome(pool.nodes(), id)) {
    ++followed_;
    is_hypothetical_ = is_hypothetical_ || *known != carried;
    return *known;
  }
  if (!is_explored_) { // this kernel's turn is in another run
    if (count_++ == 0) event({"undecided", std::to_string(kernels_ - 1)});
    return carried;
  }
  std::optional<bool> const nonzero = explores_zeros_ ? std::nullopt : outcome_without_zero(pool.nodes(), id);
  if (nonzero && (is_hypothetical_ || *nonzero == carried)) {
    is_hypothetical_ = is_hypothetical_ || *nonzero != carried;
    tell(id, *nonzero, condition, *nonzero ? "T" : "F");
    return *nonzero;
  }
  if (count_ >= depth_) {
    if (is_hypothetical_) Kernel::current().sink().cut_off();
    Guards::current().add(SymbolicBool::from_condition(condition), carried);
    known_.add(pool.nodes(), id, carried);
    ++beyond_;
    return carried;
  }
  bool const outcome = count_ < prescribed_.size() ? prescribed_[count_] == 't' : carried;
  is_hypothetical_ = is_hypothetical_ || outcome != carried;
  take(id, outcome, condition);
  if (is_cut_at_end_ && count_ == prescribed_.size()) Kernel::current().sink().cut_off();
  return outcome;
}

void ExploredPath::take(NodeId condition, bool outcome, RealNumber number) {
  ++count_;
  tell(condition, outcome, number, outcome ? "t" : "f");
  note_taken(outcome);
}

void ExploredPath::tell(NodeId condition, bool outcome, RealNumber number, char const *letter) {
  known_.add(Pool::current().nodes(), condition, outcome);
  event({"decided", std::to_string(condition), letter, describe(number), hexadecimal(call_stack())});
}

void ExploredPath::end() {
  if (is_explored_ && followed_ != 0) event({"followed", std::to_string(followed_)});
  if (beyond_ != 0) event({"beyond", std::to_string(beyond_)});
}

} // namespace symreal::trace
