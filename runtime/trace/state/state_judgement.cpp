// Judgement of the state when the kernel ends: what it has read and is baked in, what it has written and is lost. The
// memory that outlives it is compared with its snapshot, which finds text, bytes, and all writes of code that was not
// rewritten and so does not notify the State. Clauses are suggested, as far as the kernel's pragma can name them:
// variables of namespaces and files, and inputs.
#include "runtime/trace/state/state.h"

#include "engine/support/mutation/is_dropped.h"
#include "engine/support/number.h"
#include "runtime/memory/static_objects.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <cxxabi.h>
#include <tuple>

namespace symreal::trace {

namespace {

// A temporary that a reference keeps alive has the reference's name.
std::string readable(std::string const &linkers_name) {
  int status = 0;
  char *const text = abi::__cxa_demangle(linkers_name.c_str(), nullptr, nullptr, &status);
  std::string name = status == 0 && text ? text : linkers_name;
  std::free(text);
  constexpr std::string_view temporary = "reference temporary #";
  if (name.starts_with(temporary)) name.erase(0, name.find(" for ") + 5);
  constexpr std::string_view real = "symreal::types::RealNumber";
  for (std::size_t at = name.find(real); at != name.npos; at = name.find(real, at))
    name.replace(at, real.size(), "double");
  return name;
}

// An argument in the program that calls a function without one.
bool is_of_driver(std::string const &name) {
  return name.starts_with("_ZZ") && name.find("symreal_call_") != name.npos;
}

// Adds the known values; targets of function pointers and contents of library objects are unknown.
void add_known(std::vector<double> &values, std::vector<std::optional<double>> const &scalars) {
  for (std::optional<double> const &scalar : scalars)
    if (scalar) values.push_back(*scalar);
}

// A variable of a function, which no other function can name; gcc numbers those of C.
bool is_local(memory::StaticObject const &object) {
  return object.name.starts_with("_ZZ") ||
         (!object.name.starts_with("_Z") && object.name.find('.') != std::string::npos);
}

// Whether the place is in a source. A kernel that is a call, on the command line or in the configuration, has items
// that are names of the function's file.
bool is_source(std::string_view file) { return !file.starts_with("--") && !file.ends_with(".yaml"); }

std::string list(std::set<std::string> const &names) {
  std::string text;
  for (std::string const &name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

} // namespace

// A number that holds a node is an ordinary one again.
void State::make_plain(RealNumber const *number) { session().pool.make_plain(*const_cast<RealNumber *>(number)); }

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
    if (scratch_files_.contains(written_place(object.site.place).file))
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
      event(events::Scratch{std::string(one.site.name)});
    else if (one.is_lost() && !is_private(one.site))
      report_lost(one.site);
    else if (one.is_read && !is_constant) {
      Read &read = reads_[one.site];
      (members_.contains(one.scalar.address) ? read.members : read.scalars).push_back(one.value());
    }
  }
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

// Memory with notified and judged changes, and memory that scratch objects own.
std::vector<memory::Known> State::known_changes() {
  std::vector<memory::Known> known;
  auto const add = [&known](void const *begin, std::size_t size) { // elements of an array stand in order
    auto const *const first = static_cast<char const *>(begin);
    if (!known.empty() && known.back().begin + known.back().size == first)
      known.back().size += size;
    else
      known.push_back({first, size});
  };
  for (Input const &one : inputs_) add(one.number, sizeof *one.number);
  for (RealNumber const *number : outputs_) add(number, sizeof *number);
  for (Written const &one : written_) add(one.begin, one.size);
  for (auto const &[site, read] : reads_)
    for (RealNumber const *number : read.numbers) add(number, sizeof *number);
  for (Scalars::Noted const &one : scalars_.noted()) add(one.scalar.address, one.scalar.size);
  for (memory::Known const &one : handed_over_) add(one.begin, one.size);
  for (auto const &[object, named] : names_)
    if (is_private(named.site)) add(object, named.size);
  for (Changed const &one : changed_)
    if (reported_.contains(one.site)) add(one.object, 1);
  for (Scratch const &one : scratch_) {
    if (!image_ || (shadow_.at(one.object) & mark::freed) != 0) continue;
    for (memory::Known const &owned : image_->owned({static_cast<char const *>(one.object), one.size}))
      known.push_back(owned);
  }
  return known;
}

// A number that had this value when it was read, and another one when the kernel began: code that is not rewritten has
// written it. The initial value of a static object of a function does not count.
bool State::was_written_by_kernel(RealNumber const *number, double value) const {
  if (!image_) return false;
  char const *before = image_->before(number);
  auto const bits = std::bit_cast<std::uint64_t>(value);
  if (!before || std::memcmp(before, &bits, sizeof bits) == 0) return false;
  auto const *at = reinterpret_cast<char const *>(number);
  return std::ranges::none_of(image_->initialised(), [at](memory::Change const &object) {
    return object.object <= at && at < object.object + object.size;
  });
}

// Whether the object or what it owns holds nodes, or it points to its caller's stack or to an input.
bool State::holds_input(memory::Known object) const {
  if (!image_) return false;
  std::vector<memory::Known> const owned = image_->owned(object, memory::heap_blocks());
  auto const each_word = [](memory::Known part, auto found) {
    std::size_t const skipped = (8 - reinterpret_cast<std::uintptr_t>(part.begin) % 8) % 8;
    for (std::size_t k = skipped; k + 8 <= part.size; k += 8) {
      std::uint64_t bits;
      std::memcpy(&bits, part.begin + k, sizeof bits);
      if (found(bits)) return true;
    }
    return false;
  };
  if (std::ranges::any_of(owned, [&](memory::Known part) { return each_word(part, Pool::is_tagged); })) return true;
  return each_word(object, [this](std::uint64_t bits) {
    auto const *address = reinterpret_cast<void const *>(bits);
    if (image_->region_of(address) == memory::Region::stack || detail::on_own_stack(address)) return true;
    return (image_->region_of(address) != memory::Region::static_object ||
            is_of_driver(image_->static_name(address))) &&
           std::ranges::any_of(inputs_, [address](Input const &one) { return one.number == address; });
  });
}

std::string State::name_of(memory::Change const &change) const {
  auto const named = names_.find(change.object);
  return named == names_.end() ? readable(change.name) : std::string(named->second.site.name);
}

void State::report_initialised(memory::Change const &object, Place const &kernel) {
  auto const named = names_.find(object.object);
  bool const is_named = named != names_.end();
  if (is_named && !reported_.insert(named->second.site).second) return;
  report(
      {DiagnosticId::static_of_inputs, is_named ? written_place(named->second.site.place) : kernel,
       "the first call initialises static '" + name_of(object) + "' from its inputs, and later calls keep this value"});
}

// A later call finds the object as the first call has initialised it, whatever its own inputs are. Without a guard that
// marks the end of its initialisation, its value at the end of the kernel is judged.
void State::judge_initialised(Place const &kernel) {
  if (!image_) return;
  for (Initialisation const &one : initialised_)
    if (one.depends_on_input)
      for (memory::Change const &object : one.objects) report_initialised(object, kernel);
  for (memory::Change const &object : image_->initialised())
    if (holds_input({object.object, object.size})) report_initialised(object, kernel);
}

void State::judge_memory(Place const &kernel) {
  if (!image_ || is_dropped("memory")) return;
  // An external function may keep state of its own.
  bool const calls_externals = !session().externals.functions().empty();
  for (memory::Change const &change : image_->changes(known_changes())) {
    auto const named = names_.find(change.object);
    bool const is_named = named != names_.end();
    if (is_named ? reported_.contains(named->second.site) : calls_externals) continue;
    std::string const size = std::to_string(change.size) + " bytes";
    std::string what = "bytes " + std::to_string(change.first) + " to " + std::to_string(change.end - 1) + " of ";
    switch (change.region) {
    case memory::Region::static_object: what += "'" + name_of(change) + "' (static, " + size + ")"; break;
    case memory::Region::heap_block: what += "a block of " + size + " on the heap"; break;
    case memory::Region::stack:
      what = std::to_string(change.end - change.first) + (change.end - change.first == 1 ? " byte" : " bytes") +
             " in a variable of a calling function";
      break;
    }
    report({DiagnosticId::state_not_output, is_named ? written_place(named->second.site.place) : kernel,
            "the kernel changes " + what + ", which is not an output"});
  }
}

// Suggests clauses.
void State::tell_clauses(std::vector<Frozen> const &frozen, Place const &kernel) const {
  if (frozen.empty() && reported_.empty() && reported_inputs_.empty()) return;
  std::set<std::string> scratch, constant, input, output, elsewhere; // the last: of other files
  for (std::string const *label : reported_inputs_) output.insert(*label);
  std::vector<memory::StaticObject> const objects = memory::find_static_objects();
  for (auto const &[begin, named] : names_) {
    auto const object = std::find_if(objects.begin(), objects.end(), [at = begin](memory::StaticObject const &one) {
      return one.begin <= at && at < one.begin + one.size;
    });
    if (object == objects.end()) continue;
    std::string const name(named.site.name);
    Place const place = written_place(named.site.place);
    bool const is_elsewhere = object->is_of_one_file && is_source(kernel.file) && place.file != kernel.file;
    bool const can_be_named = named.site.scope == detail::Scope::any && !is_local(*object) && !is_elsewhere;
    bool const is_read = std::any_of(frozen.begin(), frozen.end(), [&](Frozen const &one) {
      return !one.is_member && one.name == name && to_string(one.place) == to_string(place);
    });
    if (reported_.contains(named.site) && (can_be_named || place.file == kernel.file)) {
      auto const read = reads_.find(named.site);
      bool const is_state = read != reads_.end() && !read->second.numbers.empty();
      if (can_be_named && is_state) {
        input.insert(name);
        output.insert(name);
      } else {
        scratch.insert(can_be_named ? name : "file");
        if (can_be_named && read != reads_.end()) constant.insert(name); // an integer, which the kernel changes
      }
    } else if (is_read && can_be_named) {
      constant.insert(name);
    } else if (reported_.contains(named.site)) {
      elsewhere.insert(name);
    }
  }
  for (auto const &[clause, names] :
       {std::pair("input", &input), std::pair("constant", &constant), std::pair("output", &output),
        std::pair("scratch", &scratch), std::pair("elsewhere", &elsewhere)})
    if (!names->empty()) event(events::Clause{clause, list(*names)});
}

void State::end_untold() {
  detail::recording = false;
  std::vector<memory::Change> const changes = image_ ? image_->changes({}) : std::vector<memory::Change>();
  for (memory::Change const &change : changes) {
    std::size_t const first = change.first / sizeof(RealNumber) * sizeof(RealNumber);
    session().pool.make_plain(change.object + first,
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
  if (overlooked_)
    report({DiagnosticId::state_not_looked_for,
            {},
            "Symreal did not look at what the kernel reads through pointers and from members: the program has an "
            "allocator of its own"});
  tell_clauses(frozen, kernel);
  shadow_.clear();
  return frozen;
}

} // namespace symreal::trace
