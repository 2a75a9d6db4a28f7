#include "runtime/trace/state/state.h"

#include "engine/support/mutation/is_dropped.h"
#include "engine/support/number.h"
#include "runtime/memory/object_end.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/call_stack.h"
#include "runtime/trace/report/events.h"
#include "runtime/trace/report/written_place.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <tuple>

namespace symreal {

namespace trace {

Place State::place_of(Site const &site) { return written_place(site.place); }

State &State::current() {
  static constinit thread_local State *state = nullptr;
  if (!state) state = memory::make_own<State>();
  return *state;
}

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
  if (!TornNumbers::current().is_symbolic(bits) || !reported_bits_.insert(place).second) return;
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

// A number that holds a node is an ordinary one again.
void State::make_plain(RealNumber const *number) { Pool::current().make_plain(*const_cast<RealNumber *>(number)); }

void State::report_lost(Site const &site) {
  if (is_private(site) || !reported_.insert(site).second) return;
  report({DiagnosticId::state_not_output, written_place(site.place),
          "the kernel writes '" + std::string(site.name) + "', which is not an output"});
}

// Marks the object and the heap blocks reachable from it as scratch: ownership, by a container, a smart pointer or a
// plain pointer, cannot be read from the bytes.
void State::leave(memory::Known object, std::vector<memory::HeapBlock> const &blocks) {
  std::vector<memory::Known> const all = image_ ? image_->owned(object, blocks) : std::vector<memory::Known>{object};
  for (memory::Known const &one : all) {
    if ((shadow_.at(one.begin) & mark::freed) != 0) continue;
    for (std::size_t k = 0; k < one.size / sizeof(RealNumber); ++k) {
      RealNumber const *number = reinterpret_cast<RealNumber const *>(one.begin) + k;
      shadow_.add(number, sizeof *number, mark::scratch);
      make_plain(number);
    }
    scalars_.forget(one.begin, one.size);
  }
}

// Marks all scratch objects: their final contents are not lost state.
void State::mark_scratch() {
  std::vector<memory::HeapBlock> const blocks = memory::heap_blocks();
  for (auto const &[begin, object] : names_)
    if (scratch_files_.contains(place_of(object.site).file))
      scratch_.push_back({begin, object.size, [](void const *, Numbers &) {}});
  for (Scratch const &one : scratch_) {
    if ((shadow_.at(one.object) & mark::freed) != 0) continue;
    struct {
      State &state;
      void operator()(RealNumber const *number) const {
        state.shadow_.add(number, sizeof *number, mark::scratch);
        state.make_plain(number);
      }
      void operator()(ScalarObject scalar) const { state.scalars_.forget(scalar); }
    } left{*this};
    Numbers numbers(left);
    one.visit(one.object, numbers);
    leave({static_cast<char const *>(one.object), one.size}, blocks);
  }
}

// The caller sees changed inputs.
void State::judge_inputs() {
  for (Input const &one : inputs_) {
    bool const is_own = detail::on_own_stack(one.number) || (shadow_.at(one.number) & mark::own) != 0 ||
                        is_private(site_of(one.number, "", ""));
    if (is_own || may_be_left(one.number) || one.number->to_bits() == one.bits) continue;
    auto const written = std::find_if(written_.begin(), written_.end(),
                                      [&one](Written const &each) { return each.begin == one.number; });
    if (written != written_.end())
      report_lost(written->site);
    else if (reported_inputs_.insert(one.label).second)
      report({DiagnosticId::state_not_output, one.place,
              "the kernel writes input '" + *one.label + "', which is not an output"});
  }
}

// Whether a part of this container is annotated, so that its number of elements shows.
bool State::vouches(void const *container) {
  struct {
    State &state;
    bool any = false;
    void operator()(RealNumber const *number) { any = any || (state.shadow_.at(number) & mark::vouches) != 0; }
    void operator()(ScalarObject scalar) {
      any = any || state.scalars_.is_annotated(scalar) || state.members_.contains(scalar.address) ||
            (state.shadow_.at(scalar.address) & mark::vouches) != 0;
    }
  } look{*this};
  if ((shadow_.at(container) & mark::freed) != 0) return false;
  Numbers numbers(look);
  if (auto const counted = counted_.find(container); counted != counted_.end())
    counted->second(container, numbers);
  else
    for (Changed const &one : changed_)
      if (one.object == container) one.visit(one.object, numbers);
  return look.any;
}

// A scalar that was read keeps the value that it had then; one that has changed is lost. A static one of a function
// that this path writes before it reads it may be read on another, which is the original's where a guard fails.
void State::judge_scalars(bool has_guards) {
  for (Scalars::Noted const &one : scalars_.noted()) {
    Marks const marks = shadow_.at(one.scalar.address);
    if ((marks & mark::freed) != 0) continue;
    bool const is_object = one.scalar.kind == ScalarObject::Kind::object; // which its elements vouch for
    bool const is_vouched = is_object && vouches(one.scalar.address);
    bool const is_constant = (marks & (is_object ? mark::vouches : mark::constant)) != 0 ||
                             scalars_.is_annotated(one.scalar) || (is_object && one.is_scratch) || is_vouched;
    bool const private_scratch = one.site.scope == detail::Scope::scratch ||
                                 (!one.is_read && one.site.scope == detail::Scope::function && !has_guards);
    if (one.is_lost() && is_vouched) continue;
    if (one.is_lost() && private_scratch)
      event({"scratch", std::string(one.site.name)});
    else if (one.is_lost() && !is_private(one.site))
      report_lost(one.site);
    else if (one.is_read && !is_constant) {
      Read &read = reads_[one.site];
      (members_.contains(one.scalar.address) ? read.members : read.scalars).push_back(one.value());
    }
  }
}

void State::warn_overlooked() const {
  report({DiagnosticId::state_not_looked_for,
          {},
          "Symreal did not look at what the kernel reads through pointers and from members: the program has an "
          "allocator of its own"});
}

// Adds the known values; targets of function pointers and contents of library objects are unknown.
static void add_known(std::vector<double> &values, std::vector<std::optional<double>> const &scalars) {
  for (std::optional<double> const &scalar : scalars)
    if (scalar) values.push_back(*scalar);
}

// State that was read freezes its value at that time, unless it has changed since.
void State::judge_reads(std::vector<Frozen> &frozen) {
  for (auto &[site, read] : reads_) {
    Frozen state{std::string(site.name), written_place(site.place), {}, site.scope == detail::Scope::around, false,
                 std::move(read.stack)};
    std::vector<double> kept; // by outputs
    for (std::size_t k = 0; k < read.numbers.size(); ++k) {
      RealNumber const *number = read.numbers[k];
      Marks const marks = shadow_.at(number);
      bool const changed_since =
          (marks & mark::freed) == 0 && number->to_bits() != RealNumber(read.values[k]).to_bits();
      if (changed_since && (marks & mark::may_be_left) == 0 && !is_private(site))
        report_lost(site);
      else if ((marks & mark::constant) == 0 && !was_written_by_kernel(number, read.values[k]))
        ((marks & mark::output) != 0 && !is_private(site) ? kept : state.values).push_back(read.values[k]);
      if (changed_since) make_plain(number);
    }
    bool const any_frozen = !state.values.empty();
    add_known(state.values, read.scalars);
    if (!kept.empty())
      report({DiagnosticId::output_keeps_value, state.place,
              "a result depends on what output '" + state.name + "' held before (" + shortest(kept[0]) +
                  (kept.size() > 1 ? ", ...)" : ")")});
    Frozen members = state;
    members.values.clear();
    add_known(members.values, read.members);
    members.is_member = true;
    if (!read.members.empty()) frozen.push_back(std::move(members));
    if (any_frozen || !read.scalars.empty()) frozen.push_back(std::move(state));
  }
  for (auto &[label, copy] : copies_) frozen.push_back(std::move(copy));
}

void State::judge_writes() {
  for (Written const &one : written_)
    for (std::size_t k = 0; k < one.size / sizeof(RealNumber); ++k) {
      auto const *number = static_cast<RealNumber const *>(one.begin) + k;
      Marks const marks = shadow_.at(number);
      if ((marks & (mark::may_be_left | mark::input)) == 0) report_lost(one.site);
      if ((marks & mark::freed) == 0) make_plain(number);
    }
  for (Changed const &one : changed_) {
    if ((shadow_.at(one.object) & mark::freed) != 0) continue;
    auto look = [&](RealNumber const *number) {
      if (number->is_node() && (shadow_.at(number) & (mark::may_be_left | mark::input)) == 0) report_lost(one.site);
      make_plain(number);
    };
    Numbers numbers(look);
    one.visit(one.object, numbers);
  }
}

void State::end_untold() {
  detail::recording = false;
  std::vector<memory::Change> const changes = image_ ? image_->changes({}) : std::vector<memory::Change>();
  for (memory::Change const &change : changes) {
    std::size_t const first = change.first / sizeof(RealNumber) * sizeof(RealNumber);
    Pool::current().make_plain(change.object + first,
                               std::min(change.size, change.end + sizeof(RealNumber) - 1) - first);
  }
  image_.reset();
  shadow_.clear();
}

std::vector<Frozen> State::end(Place const &kernel, bool has_guards) {
  detail::recording = false;
  judge_initialised(kernel); // while the objects still hold nodes
  mark_scratch();
  judge_inputs();
  judge_scalars(has_guards && !is_dropped("beyond_guards"));
  std::vector<Frozen> frozen;
  judge_reads(frozen);
  for (auto &[function, values] : outside_)
    frozen.push_back({function.first, {}, std::move(values), false, false, function.second});
  judge_writes();
  judge_memory(kernel);
  image_.reset();
  // Sorted, since the order of operand evaluation is the compiler's choice.
  std::sort(frozen.begin(), frozen.end(), [](Frozen const &a, Frozen const &b) {
    return std::tie(a.place.file, a.place.line, a.place.column, a.name) <
           std::tie(b.place.file, b.place.line, b.place.column, b.name);
  });
  if (overlooked_) warn_overlooked();
  tell_clauses(frozen, kernel);
  shadow_.clear();
  return frozen;
}

} // namespace trace
} // namespace symreal
