// Journal of the state: merges the facts that two processes have learned on their ways to one place.
#include "runtime/trace/state/state.h"

#include <algorithm>

namespace symreal::trace {

void State::begin_journal() {
  journal_.clear();
  keeps_journal_ = true;
  has_met_outside_ = false;
}

bool State::learn(std::vector<StateNote> const &notes) {
  return std::ranges::all_of(notes, [this](StateNote const &note) { return learn(note); });
}

// Its journal has these notes as well from now on.
bool State::learn(StateNote const &one) {
  auto const *number = static_cast<RealNumber const *>(one.object);
  switch (one.kind) {
  case StateNote::Kind::named:
    if ((shadow_.at(one.object) & mark::named) != 0 && names_.contains(one.object)) return true;
    shadow_.add(one.object, 1, mark::named);
    names_[one.object] = {one.size, one.site};
    break;
  case StateNote::Kind::read:
    if ((shadow_.at(number) & mark::read) != 0) return true;
    shadow_.add(number, sizeof *number, mark::noted);
    add_read(number, one.value, one.site);
    return true;
  case StateNote::Kind::read_scalar: {
    auto const &noted = scalars_.noted();
    auto const known = std::ranges::find(noted, one.object, [](auto const &each) { return each.scalar.address; });
    if (known != noted.end()) return known->is_read; // else it was written here before, and there it was not
    (void)read_at(one.site);
    scalars_.note(one.scalar, one.site, Scalars::First::read);
    break;
  }
  case StateNote::Kind::written:
    if ((shadow_.at(one.object) & mark::written) != 0) return true;
    shadow_.add(one.object, one.size, mark::noted | mark::written);
    written_.push_back({one.object, one.size, one.site});
    break;
  case StateNote::Kind::written_scalar:
    if (!scalars_.is_noted(one.object)) scalars_.note(one.scalar, one.site, Scalars::First::written);
    scalars_.change(one.object);
    break;
  case StateNote::Kind::changed:
    if ((shadow_.at(one.object) & mark::changed) != 0) return true;
    shadow_.add(one.object, 1, mark::changed);
    changed_.push_back({one.object, one.visit, one.site});
    break;
  case StateNote::Kind::taken_back: (void)take_written(number); return true;
  case StateNote::Kind::kept: was_written(number); break;
  }
  note(one);
  return true;
}

} // namespace symreal::trace
