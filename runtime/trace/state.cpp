#include "trace/state.h"

#include "trace/call_stack.h"
#include "trace/events.h"
#include "trace/own_memory.h"
#include "trace/pool.h"
#include "trace/written_place.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <tuple>

namespace symreal {

namespace trace {

State &State::current() {
  static constinit thread_local State *state = nullptr;
  if (!state) state = new State;
  return *state;
}

void State::begin(void const *frame) {
  *this = {};
  find_own_stack(frame);
  constant_memory_ = find_constant_memory();
  // Are we told of what is allocated?
  detail::recording = true;
  void *(*volatile allocate)(std::size_t) = std::malloc;
  void *block = allocate(sizeof(double));
  heap_is_known_ = (shadow_.at(block) & mark::own) != 0;
  std::free(block);
}

Site State::site_of(void const *address, char const *name, char const *place) const {
  auto next = names_.upper_bound(address);
  if (next == names_.begin()) return {name, place};
  auto const &[begin, object] = *--next;
  auto const offset = static_cast<std::size_t>(static_cast<char const *>(address) - static_cast<char const *>(begin));
  return offset < object.size ? object.site : Site{name, place};
}

// Does what lies there outlive the kernel, so that others may change or read it?
bool State::outlives(void const *address) {
  if ((shadow_.at(address) & mark::own) != 0) return false;
  bool const constant = std::any_of(constant_memory_.begin(), constant_memory_.end(),
                                    [address](MemoryRange const &range) { return range.contains(address); });
  bool const unknown = !heap_is_known_ && site_of(address, "", "").name.empty();
  if (constant || unknown) shadow_.add(address, 1, mark::own);
  overlooked_ = overlooked_ || (unknown && !constant);
  return !constant && !unknown;
}

// Is this the first time that the kernel meets a number that is not its own? From then on it is noted.
bool State::in_question(void const *address) {
  if ((shadow_.at(address) & mark::judged) != 0 || !outlives(address)) return false;
  shadow_.add(address, sizeof(RealNumber), mark::noted);
  return true;
}

// Small objects share a word.
void State::named(void const *object, std::size_t size, detail::Scope scope, char const *name, char const *place) {
  if ((shadow_.at(object) & mark::named) != 0 && names_.contains(object)) return;
  shadow_.add(object, 1, mark::named);
  names_[object] = {size, {name, place, scope}};
}

State::Read &State::read_at(Site const &site) {
  auto [found, is_new] = reads_.try_emplace(site);
  if (is_new) found->second.stack = call_stack();
  return found->second;
}

void State::read(RealNumber const *number, char const *name, char const *place) {
  if (!in_question(number)) return;
  Site const site = site_of(number, name, place);
  if (number->is_node()) { // code that is not rewritten has written it
    written_.push_back({number, sizeof *number, site});
    return;
  }
  Read &read = read_at(site);
  read.numbers.push_back(number);
  read.values.push_back(number->plain());
}

void State::read(IntegerObject integer, char const *name, char const *place) {
  if (integers_.is_noted(integer.address) || !outlives(integer.address)) return;
  Site const site = site_of(integer.address, name, place);
  (void)read_at(site);
  integers_.note(integer, site, Integers::First::read);
}

void State::written(IntegerObject integer, char const *name, char const *place) {
  if (!integers_.is_noted(integer.address) && outlives(integer.address))
    integers_.note(integer, site_of(integer.address, name, place), Integers::First::written);
  integers_.change(integer.address);
}

void State::check_bits(void const *begin, std::size_t size, char const *name, char const *place) {
  std::uintptr_t const first = reinterpret_cast<std::uintptr_t>(begin) / sizeof(RealNumber);
  std::uintptr_t const end =
      (reinterpret_cast<std::uintptr_t>(begin) + size + sizeof(RealNumber) - 1) / sizeof(RealNumber);
  auto const *numbers = reinterpret_cast<RealNumber const *>(first * sizeof(RealNumber));
  bool const any = std::any_of(numbers, numbers + (end - first), [](RealNumber number) { return number.is_node(); });
  if (!any || !reported_bits_.insert(place).second) return;
  report({DiagnosticId::reinterpretation, Severity::error, written_place(place),
          "the bytes behind '" + std::string(name) + "' are those of a symbolic value"});
}

void const *State::other_range_end(void const *end, bool is_last, char const *place) {
  for (std::size_t k = range_ends_.size(); k-- > 0;) {
    RangeEnd const other = range_ends_[k];
    if (other.is_last == is_last || std::strcmp(other.place, place) != 0) continue;
    range_ends_.resize(k);
    return other.end;
  }
  range_ends_.push_back({end, is_last, place});
  return nullptr;
}

void State::written(void const *begin, std::size_t size, char const *name, char const *place) {
  if (in_question(begin)) written_.push_back({begin, size, site_of(begin, name, place)});
}

void State::changed(void const *object, detail::Visit visit, char const *name, char const *place) {
  if ((shadow_.at(object) & (mark::own | mark::changed)) != 0 || !heap_is_known_) return;
  shadow_.add(object, 1, mark::changed);
  changed_.push_back({object, visit, site_of(object, name, place)});
}

void State::annotated(void const *begin, std::size_t size) {
  auto const at = reinterpret_cast<std::uintptr_t>(begin);
  std::uintptr_t const first = (at + 7) / 8 * 8, last = (at + size) / 8 * 8;
  if (first < last) shadow_.add(static_cast<char const *>(begin) + (first - at), last - first, mark::annotated);
  if (first != at || last != at + size) integers_.annotate(begin, size);
}

void State::scratch(void const *object, std::size_t size, detail::Visit visit) {
  scratch_.push_back({object, size, visit});
}

void State::allocated(void *block, std::size_t size) {
  Pause const pause;
  shadow_.set(block, size, mark::own);
}

void State::released(void *block, std::size_t size) {
  Pause const pause;
  shadow_.set(block, size, mark::freed);
}

void State::moved(void *block, std::size_t size, void *to, std::size_t new_size) {
  Pause const pause;
  std::vector<Marks> marks = shadow_.copy(block, size);
  marks.resize((new_size + 7) / 8, mark::own);
  shadow_.set(block, size, mark::freed);
  shadow_.paste(to, marks);
  integers_.move(block, size, to);
}

// Does the number hold a node that nobody will read, now that the kernel ends? It becomes ordinary again.
bool State::is_lost(RealNumber const *number) {
  if ((shadow_.at(number) & (mark::annotated | mark::freed)) != 0 || !Pool::current().owns(*number)) return false;
  *const_cast<RealNumber *>(number) = Pool::current().final_value(*number);
  return true;
}

void State::report_lost(Site const &site) {
  if (!reported_.insert(site).second) return;
  report({DiagnosticId::state_not_output, Severity::error, written_place(site.place),
          "'" + std::string(site.name) + "' is written by the kernel and is no output"});
}

// Nothing that a scratch object holds is lost.
void State::forget_scratch() {
  for (Scratch const &one : scratch_) {
    if ((shadow_.at(one.object) & mark::freed) != 0) continue;
    auto forget = [this](RealNumber const *number) { (void)is_lost(number); };
    for (std::size_t k = 0; k < one.size / sizeof(RealNumber); ++k)
      forget(static_cast<RealNumber const *>(one.object) + k);
    struct {
      State &state;
      void operator()(RealNumber const *number) const { (void)state.is_lost(number); }
      void operator()(IntegerObject integer) const { state.integers_.forget(integer); }
    } owned{*this};
    Numbers numbers(owned);
    one.visit(one.object, numbers);
    integers_.forget(one.object, one.size);
  }
}

// An integer that was read keeps the value that it had then; one that has changed is lost.
void State::judge_integers() {
  for (Integers::Noted const &one : integers_.noted()) {
    if ((shadow_.at(one.integer.address) & (mark::freed | mark::annotated)) != 0) continue;
    if (integers_.is_annotated(one.integer)) continue;
    bool const private_scratch = !one.is_read && one.site.scope == detail::Scope::function;
    if (one.is_lost() && !private_scratch)
      report_lost(one.site);
    else if (one.is_read)
      reads_[one.site].integers.push_back(one.value());
  }
}

void State::warn_overlooked() const {
  report({DiagnosticId::state_not_looked_for,
          Severity::warning,
          {},
          "what the kernel reads through pointers and from members was not looked at: the program has an allocator of "
          "its own"});
}

std::vector<Frozen> State::end() {
  detail::recording = false;
  forget_scratch();
  judge_integers();
  std::vector<Frozen> frozen;
  for (auto &[site, read] : reads_) {
    Frozen state{std::string(site.name), written_place(site.place), {}, std::move(read.stack)};
    for (std::size_t k = 0; k < read.numbers.size(); ++k) {
      if (is_lost(read.numbers[k]))
        report_lost(site);
      else if ((shadow_.at(read.numbers[k]) & mark::annotated) == 0)
        state.values.push_back(read.values[k]);
    }
    state.values.insert(state.values.end(), read.integers.begin(), read.integers.end());
    if (!state.values.empty()) frozen.push_back(std::move(state));
  }
  for (Written const &one : written_)
    for (std::size_t k = 0; k < one.size / sizeof(RealNumber); ++k)
      if (is_lost(static_cast<RealNumber const *>(one.begin) + k)) report_lost(one.site);
  for (Changed const &one : changed_) {
    if ((shadow_.at(one.object) & mark::freed) != 0) continue;
    auto look = [&](RealNumber const *number) {
      if (is_lost(number)) report_lost(one.site);
    };
    Numbers numbers(look);
    one.visit(one.object, numbers);
  }
  // In which order operands are evaluated is the compiler's choice.
  std::sort(frozen.begin(), frozen.end(), [](Frozen const &a, Frozen const &b) {
    return std::tie(a.place.file, a.place.line, a.place.column, a.name) <
           std::tie(b.place.file, b.place.line, b.place.column, b.name);
  });
  if (overlooked_) warn_overlooked();
  shadow_.clear();
  return frozen;
}

} // namespace trace
} // namespace symreal
