#include "trace/state.h"

#include "trace/events.h"
#include "trace/pool.h"

#include <charconv>

namespace symreal {

__thread bool detail::recording = false;

void detail::note_state(void *object, std::size_t size, bool is_numbers, char const *name, char const *place) noexcept {
  trace::State::current().note(object, size, is_numbers, name, place);
}

namespace trace {

State &State::current() {
  static constinit thread_local State *state = nullptr;
  if (!state) state = new State;
  return *state;
}

void State::begin() {
  touched_.clear();
  order_.clear();
  declared_.clear();
  detail::recording = true;
}

// "file:line:column", as the rewriter writes it.
static Place parse_place(std::string text) {
  unsigned numbers[2] = {0, 0};
  for (unsigned &number : numbers) {
    std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) return {text, 0, 0};
    std::from_chars(text.data() + colon + 1, text.data() + text.size(), number);
    text.resize(colon);
  }
  return {text, numbers[1], numbers[0]};
}

static bool holds_node(void *object, std::size_t size) {
  auto *numbers = static_cast<RealNumber *>(object);
  for (std::size_t k = 0; k < size / sizeof(RealNumber); ++k)
    if (Pool::current().owns(numbers[k])) return true;
  return false;
}

void State::note(void *object, std::size_t size, bool is_numbers, char const *name, char const *place) {
  auto [found, is_new] = touched_.try_emplace(object);
  if (!is_new) return;
  order_.push_back(object);
  found->second = {size, is_numbers, name, parse_place(place), {}};
  if (!is_numbers) return;
  for (std::size_t k = 0; k < size / sizeof(RealNumber); ++k) {
    RealNumber number = static_cast<RealNumber *>(object)[k];
    found->second.values.push_back(number.is_node() ? Pool::current().carried_value(number) : number.plain());
  }
}

bool State::is_declared(void *object, Touched const &touched) const {
  auto *begin = static_cast<char *>(object), *end = begin + touched.size;
  if (!touched.is_numbers) { // which of its bytes are numbers is not known: one annotated member stands for all
    auto next = declared_.lower_bound(object);
    return next != declared_.end() && *next < end;
  }
  for (char *number = begin; number != end; number += sizeof(RealNumber))
    if (!declared_.contains(number)) return false;
  return true;
}

std::vector<Frozen> State::end() {
  detail::recording = false;
  std::vector<Frozen> frozen;
  for (void *object : order_) {
    Touched const &touched = touched_[object];
    if (is_declared(object, touched)) continue;
    if (!holds_node(object, touched.size)) {
      frozen.push_back({touched.name, touched.place, touched.values});
      continue;
    }
    report({DiagnosticId::state_not_output, Severity::error, touched.place,
            "'" + touched.name + "' is written by the kernel and is no output"});
    auto *numbers = static_cast<RealNumber *>(object);
    for (std::size_t k = 0; k < touched.size / sizeof(RealNumber); ++k)
      if (Pool::current().owns(numbers[k])) numbers[k] = Pool::current().final_value(numbers[k]);
  }
  return frozen;
}

} // namespace trace
} // namespace symreal
