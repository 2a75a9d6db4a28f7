// Comparison of the memory that outlives a kernel with its snapshot: finds text, bytes, and all writes of code that was
// not rewritten and so does not notify the State.
#include "engine/support/mutation/is_dropped.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"
#include "runtime/trace/state/state.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <cxxabi.h>

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

} // namespace

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

void State::constant_with_owned(void const *begin, std::size_t size) {
  memory::Known const object{static_cast<char const *>(begin), size};
  for (memory::Known const &one : image_ ? image_->owned(object) : std::vector{object}) constant(one.begin, one.size);
}

bool State::has_changed(RealNumber const *number) const {
  char const *before = image_ ? image_->before(number) : nullptr;
  return before && std::memcmp(before, static_cast<void const *>(number), sizeof *number) != 0;
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

// An argument in the program that calls a function without one.
static bool is_of_driver(std::string const &name) {
  return name.starts_with("_ZZ") && name.find("symreal_call_") != name.npos;
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

void State::report_initialised(memory::Change const &object, Place const &kernel) {
  auto const named = names_.find(object.object);
  bool const is_named = named != names_.end();
  if (is_named && !reported_.insert(named->second.site).second) return;
  report(
      {DiagnosticId::static_of_inputs, is_named ? place_of(named->second.site) : kernel,
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
  bool const calls_externals = !Externals::current().functions().empty();
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
    report({DiagnosticId::state_not_output, is_named ? place_of(named->second.site) : kernel,
            "the kernel changes " + what + ", which is not an output"});
  }
}

} // namespace symreal::trace
