// What the kernel has left in objects of static storage duration that nobody told of: text, bytes, or what code that is
// not rewritten wrote there.
#include "trace/nodes/externals.h"
#include "trace/report/events.h"
#include "trace/state/state.h"

#include <cstdlib>
#include <cstring>
#include <cxxabi.h>

namespace symreal::trace {

namespace {

std::string readable(std::string const &linkers_name) {
  int status = 0;
  char *const text = abi::__cxa_demangle(linkers_name.c_str(), nullptr, nullptr, &status);
  std::string const name = status == 0 && text ? text : linkers_name;
  std::free(text);
  return name;
}

} // namespace

// All that was told and judged, and what an object that is scratch owns.
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
  for (Integers::Noted const &one : integers_.noted()) add(one.integer.address, one.integer.size);
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

void State::judge_memory(Place const &kernel) {
  if (!image_) return;
  // An external function may keep what it likes.
  bool const calls_externals = !Externals::current().functions().empty();
  for (memory::Change const &change : image_->changes(known_changes())) {
    if (change.region != memory::Region::static_object) continue;
    auto const named = names_.find(change.object);
    if (named == names_.end() && calls_externals) continue;
    if (named != names_.end() && reported_.contains(named->second.site)) continue;
    std::string const name = named == names_.end() ? readable(change.name) : std::string(named->second.site.name);
    report({DiagnosticId::state_not_output, named == names_.end() ? kernel : place_of(named->second.site),
            "the kernel changes bytes " + std::to_string(change.first) + " to " + std::to_string(change.end - 1) +
                " of '" + name + "' (static, " + std::to_string(change.size) + " bytes), which is not an output"});
  }
}

} // namespace symreal::trace
