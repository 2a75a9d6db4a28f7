#include "runtime/trace/state/state.h"

#include "engine/support/mutation/is_dropped.h"
#include "runtime/memory/own_memory.h"
#include "runtime/memory/static_objects.h"
#include "runtime/trace/report/call_stack.h"
#include "runtime/trace/report/events.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace symreal::trace {

void State::begin(void const *frame) {
  *this = {};
  find_own_stack(frame);
  constant_memory_ = find_constant_memory();
  // Tests whether the heap hooks are active.
  detail::recording = true;
  void *(*volatile allocate)(std::size_t) = std::malloc;
  void *block = allocate(sizeof(double));
  heap_is_known_ = [&] {
    Pause const pause;
    return (shadow_.at(block) & mark::own) != 0;
  }();
  std::free(block);
  // An allocator of the program's own keeps its blocks in its static objects, those of the bookkeeping among them.
  if (heap_is_known_) image_ = memory::MemoryImage::capture(frame);
}

Site State::site_of(void const *address, char const *name, char const *place) const {
  auto next = names_.upper_bound(address);
  if (next == names_.begin()) return {name, place};
  auto const &[begin, object] = *--next;
  auto const offset = static_cast<std::size_t>(static_cast<char const *>(address) - static_cast<char const *>(begin));
  return offset < object.size ? object.site : Site{name, place};
}

bool State::is_constant(void const *address) const {
  return std::ranges::any_of(constant_memory_, [address](MemoryRange const &range) { return range.contains(address); });
}

bool State::is_chosen(void const *address) const {
  return std::ranges::any_of(chosen_, [address](MemoryRange const &range) { return range.contains(address); });
}

void State::chosen(void const *begin, std::size_t size) {
  if (is_dropped("chosen")) return;
  auto const *words = static_cast<char const *>(begin);
  for (std::size_t at = 0; at + sizeof(void *) <= size; at += sizeof(void *)) {
    if (is_constant(words + at) && !is_chosen(words + at))
      continue; // a pointer of a constant leads to the same for ever
    void const *target = nullptr;
    std::memcpy(static_cast<void *>(&target), words + at, sizeof target);
    auto const around =
        std::ranges::find_if(constant_memory_, [target](MemoryRange const &range) { return range.contains(target); });
    bool const is_fixed = (shadow_.at(words + at) & mark::constant) != 0; // the pragma says so of the pointer
    if (around == constant_memory_.end() || is_fixed || is_chosen(target)) continue;
    memory::Constant const object = memory::constant_around(target);
    MemoryRange const range = {std::max(around->begin, reinterpret_cast<std::uintptr_t>(object.begin)),
                               std::min(around->end, reinterpret_cast<std::uintptr_t>(object.end))};
    chosen_.push_back(range);
    shadow_.remove(reinterpret_cast<void const *>(range.begin), range.end - range.begin, mark::own);
  }
}

// Whether the memory outlives the kernel, so that other code may change or read it.
bool State::outlives(void const *address) {
  if ((shadow_.at(address) & mark::own) != 0) return false;
  bool const constant = is_constant(address) && !is_chosen(address);
  bool const unknown = !heap_is_known_ && site_of(address, "", "").name.empty();
  if (constant || unknown) shadow_.add(address, 1, mark::own);
  overlooked_ = overlooked_ || (unknown && !constant);
  return !constant && !unknown;
}

// Name in the source: a name of C that means something else in C++ is renamed (SYMREAL_REAL_NAME).
static std::string_view source_name(std::string_view name) {
  std::size_t const at = name.find("REAL_NAME(");
  if (at == name.npos || !name.ends_with(')')) return name;
  name.remove_prefix(name.find('(', at) + 1);
  name.remove_suffix(1);
  return name;
}

// Small objects share a word.
void State::named(void const *object, std::size_t size, detail::Scope scope, char const *name, char const *place) {
  if ((shadow_.at(object) & mark::named) != 0 && names_.contains(object)) return;
  shadow_.add(object, 1, mark::named);
  names_[object] = {size, {source_name(name), place, scope}};
  note({StateNote::Kind::named, object, size, names_[object].site});
}

void State::local(void const *object, std::size_t size, detail::Scope scope, char const *name, char const *place) {
  named(object, size, scope, name, place);
  if (scope == detail::Scope::around) widen_around(object, size);
}

State::Read &State::read_at(Site const &site) {
  auto [found, is_new] = reads_.try_emplace(site);
  if (is_new) found->second.stack = call_stack();
  return found->second;
}

void State::read(RealNumber const *number, char const *name, char const *place) {
  // A constant may be read; a change of it is detected when the kernel ends.
  Marks const judged = is_dropped("constant_changed") ? mark::may_be_read : mark::is_judged;
  if ((shadow_.at(number) & judged) != 0 || !outlives(number)) return;
  shadow_.add(number, sizeof *number, mark::noted);
  Site const site = site_of(number, name, place);
  if (number->is_node()) { // code that is not rewritten has written it
    shadow_.add(number, sizeof *number, mark::written);
    written_.push_back({number, sizeof *number, site});
    return;
  }
  add_read(number, number->plain(), site);
}

void State::add_read(RealNumber const *number, double value, Site const &site) {
  shadow_.add(number, sizeof *number, mark::read);
  Read &read = read_at(site);
  read.numbers.push_back(number);
  read.values.push_back(value);
  note({.kind = StateNote::Kind::read, .object = number, .site = site, .value = value});
}

void State::read(ScalarObject scalar, char const *name, char const *place) {
  if (scalars_.is_noted(scalar.address) || !outlives(scalar.address)) return;
  Site const site = site_of(scalar.address, name, place);
  (void)read_at(site);
  scalars_.note(scalar, site, Scalars::First::read);
  note({.kind = StateNote::Kind::read_scalar, .object = scalar.address, .site = site, .scalar = scalar});
}

void State::read_pointer(void const *pointer, detail::Behind what, char const *name, char const *place) {
  void const *target = nullptr;
  std::memcpy(static_cast<void *>(&target), pointer, sizeof target);
  if (!target || is_constant(target))
    read(ScalarObject{pointer, sizeof target, ScalarObject::Kind::target}, name, place);
  if (what == detail::Behind::objects) chosen(pointer, sizeof target);
}

void State::written(ScalarObject scalar, char const *name, char const *place) {
  if (!scalars_.is_noted(scalar.address) && outlives(scalar.address))
    scalars_.note(scalar, site_of(scalar.address, name, place), Scalars::First::written);
  scalars_.change(scalar.address);
  if (keeps_journal_ && scalars_.is_noted(scalar.address))
    note({.kind = StateNote::Kind::written_scalar,
          .object = scalar.address,
          .site = site_of(scalar.address, name, place),
          .scalar = scalar});
}

bool State::counted(void const *object, detail::Visit visit) {
  if (!counted_.try_emplace(object, visit).second) return true;
  detail::FirstPart first;
  Numbers numbers(first);
  visit(object, numbers);
  void const *part = first.address();
  bool const is_own = part && (detail::is_own(part) || (!outlives(part) && !is_constant(part)));
  if (is_own) counted_.erase(object);
  return !is_own;
}

void State::check_bits(TornNumbers::Bits bits, char const *name, char const *place) {
  if (!session().torn_numbers.is_symbolic(bits) || !reported_bits_.insert(place).second) return;
  report({DiagnosticId::reinterpretation, written_place(place),
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

bool State::is_first_write(void const *address, std::size_t size) {
  if ((shadow_.at(address) & (mark::own | mark::written)) != 0 || !outlives(address)) return false;
  shadow_.add(address, size, mark::noted | mark::written);
  return true;
}

void State::written(void const *begin, std::size_t size, char const *name, char const *place) {
  if (!is_first_write(begin, size)) return;
  written_.push_back({begin, size, site_of(begin, name, place)});
  note({StateNote::Kind::written, begin, size, written_.back().site});
}

bool State::is_foreign(RealNumber const *number) {
  return !number->is_node() && !detail::is_own(number) &&
         (shadow_.at(number) & (mark::may_be_read | mark::written)) == 0 && outlives(number);
}

bool State::take_written(RealNumber const *number) {
  Marks const before = shadow_.at(number);
  if ((before & mark::written) == 0) return false;
  shadow_.set(number, sizeof *number, before & static_cast<Marks>(~(mark::noted | mark::written)));
  note({StateNote::Kind::taken_back, number});
  return true;
}

void State::keep(RealNumber const *number, double value) {
  bool const is_read = (shadow_.at(number) & mark::read) != 0;
  was_written(number);
  note({StateNote::Kind::kept, number});
  if (is_read) return;
  auto const site =
      std::find_if(written_.rbegin(), written_.rend(), [number](Written const &each) { return each.begin == number; });
  if (site != written_.rend()) add_read(number, value, site->site);
}

void State::changed(void const *object, detail::Visit visit, char const *name, char const *place) {
  if ((shadow_.at(object) & (mark::own | mark::changed)) != 0 || !heap_is_known_) return;
  shadow_.add(object, 1, mark::changed);
  changed_.push_back({object, visit, site_of(object, name, place)});
  note({.kind = StateNote::Kind::changed, .object = object, .site = changed_.back().site, .visit = visit});
}

void State::constant(void const *begin, std::size_t size) {
  auto const at = reinterpret_cast<std::uintptr_t>(begin);
  std::uintptr_t const first = (at + 7) / 8 * 8, last = (at + size) / 8 * 8;
  if (first < last) shadow_.add(static_cast<char const *>(begin) + (first - at), last - first, mark::constant);
  if (first != at || last != at + size) scalars_.annotate(begin, size);
}

void State::input(RealNumber const *number, std::string const &label, Place const &place) {
  shadow_.add(number, sizeof *number, mark::input);
  inputs_.push_back({number, number->to_bits(), &*labels_.insert(label).first, place});
}

void State::member(ScalarObject scalar, std::string const &label, Place const &place) {
  if (!members_.insert(scalar.address).second) return;
  // A scalar of an argument by value is read as the kernel's own.
  if (detail::on_own_stack(scalar.address) || is_private(site_of(scalar.address, "", ""))) {
    Frozen &copy = copies_.try_emplace(label, Frozen{label, place, {}}).first->second;
    if (std::optional<double> const value = Scalars::value_of(scalar)) copy.values.push_back(*value);
    copy.is_member = true;
  }
}

bool State::output(RealNumber const *number) {
  Marks const before = shadow_.at(number);
  shadow_.add(number, sizeof *number, mark::output);
  outputs_.push_back(number);
  return number->is_node() || (before & (mark::may_be_read | mark::written)) != 0 || detail::on_own_stack(number) ||
         !outlives(number) || has_changed(number);
}

void State::scratch(void const *object, std::size_t size, detail::Visit visit) {
  scratch_.push_back({object, size, visit});
}

void State::outside(std::string const &name, std::vector<double> const &values) {
  std::vector<double> &met = outside_[{name, call_stack()}];
  met.insert(met.end(), values.begin(), values.end());
  has_met_outside_ = true;
}

void State::allocated(void *block, std::size_t size) {
  Pause const pause;
  shadow_.set(block, size, mark::own);
  // A block that was given back may hold nodes that its next owner does not overwrite.
  constexpr std::size_t most = std::size_t{1} << 20;
  if (size <= most) std::memset(block, 0, size);
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
  scalars_.move(block, size, to);
}

void State::constant_with_owned(void const *begin, std::size_t size) {
  memory::Known const object{static_cast<char const *>(begin), size};
  for (memory::Known const &one : image_ ? image_->owned(object) : std::vector{object}) constant(one.begin, one.size);
}

bool State::has_changed(RealNumber const *number) const {
  char const *before = image_ ? image_->before(number) : nullptr;
  return before && std::memcmp(before, static_cast<void const *>(number), sizeof *number) != 0;
}

void State::decided() {
  for (Initialisation &one : initialisations_) one.depends_on_input = true;
}

void State::give_up_initialisation(void const *guard) {
  std::erase_if(initialisations_, [guard](Initialisation const &one) { return one.guard == guard; });
}

// An initialised object is like any other: later changes in it are state.
void State::end_initialisation(void const *guard) {
  auto const found = std::ranges::find(initialisations_, guard, &Initialisation::guard);
  if (found == initialisations_.end()) return;
  Initialisation ended = std::move(*found);
  initialisations_.erase(found);
  if (!image_) return;
  ended.objects = image_->guarded(guard);
  if (ended.objects.empty()) return; // the runtime's own
  image_->update(guard, sizeof(std::uint64_t));
  std::vector<memory::HeapBlock> const blocks = memory::heap_blocks();
  for (memory::Change const &object : ended.objects) {
    memory::Known const bytes{object.object, object.size};
    ended.depends_on_input = ended.depends_on_input || holds_input(bytes);
    image_->update(bytes.begin, bytes.size);
    for (memory::Known const &owned : image_->owned(bytes, blocks)) {
      auto const block = std::ranges::find(blocks, owned.begin, &memory::HeapBlock::begin);
      if (block != blocks.end()) image_->add(*block);
    }
  }
  initialised_.push_back(std::move(ended));
}

// Journal of the state: merges the facts that two processes have learned on their ways to one place.

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
