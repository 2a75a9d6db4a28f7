// Names of the runtime's classes: the texts that typeid returns are overwritten with the original's type names, so that
// all readers, libraries included, find these.
#include "runtime/memory/own_memory.h"
#include "runtime/trace/report/events.h"
#include "runtime/trace/report/written_place.h"
#include "runtime/trace/text/mangled_types.h"

#include <symreal/environment.h>
#include <symreal/type_names.h>

#include <cstring>
#include <set>
#include <string>

namespace symreal {

namespace trace {
namespace {

struct Names {
  std::set<std::string> texts;    // that the program holds on to
  std::set<std::string> reported; // places
};
Names &names() {
  static constinit thread_local Names *all = nullptr;
  if (!all) all = memory::make_own<Names>();
  return *all;
}

bool is_of_numbers(char const *name) { return std::strstr(name, "7symreal5types") != nullptr; }

// Lambdas are numbered, and the symbolic program has more of them than the original. Clang has "$_0" as well.
bool is_of_lambda(char const *name) {
  return std::strstr(name, "EUl") || std::strstr(name, "_Ul") || std::strstr(name, "$_");
}

// The name is shorter than the one that stands there.
bool overwrite(char const *there, std::string const &name) {
  std::size_t const size = std::strlen(there) + 1;
  if (name.size() >= size || !make_writable(there, size)) return false;
  std::memcpy(const_cast<char *>(there), name.c_str(), name.size() + 1);
  return true;
}

} // namespace
} // namespace trace

namespace detail {

using trace::Pause;

// `place`: of the request for its name, hash or order; null for a mere comparison.
void give_name(char const *mangled, char const *place) noexcept {
  bool const reports = place && recording, is_ours = trace::is_of_numbers(mangled);
  if (!is_ours && !(reports && trace::is_of_lambda(mangled))) return;
  Pause const pause;
  std::optional<std::string> const original = is_ours ? trace::original_type_name(mangled) : std::nullopt;
  if (original && trace::overwrite(mangled, *original)) return;
  if (reports && trace::names().reported.insert(place).second)
    trace::report({DiagnosticId::type_name, trace::written_place(place),
                   "the name, hash or order is asked for of a type that has another name in the original"});
}

std::type_info const &named(std::type_info const &type, char const *place) noexcept {
  give_name(type.name(), place);
  return type;
}

char const *named(char const *text) noexcept {
  if (!text || !std::strstr(text, "symreal::")) return text;
  Pause const pause;
  std::string name(text);
  name.resize(original_name(text, name.data()));
  return trace::names().texts.insert(name).first->c_str();
}

} // namespace detail
} // namespace symreal
