// Suggested clauses for a kernel's state, as far as its pragma can name it: variables of namespaces and files, and
// inputs.
#include "runtime/memory/static_objects.h"
#include "runtime/trace/report/events.h"
#include "runtime/trace/state/state.h"

#include <algorithm>

namespace symreal::trace {

namespace {

using memory::StaticObject;

// A variable of a function, which no other function can name; gcc numbers those of C.
bool is_local(StaticObject const &object) {
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

void State::tell_clauses(std::vector<Frozen> const &frozen, Place const &kernel) const {
  if (frozen.empty() && reported_.empty() && reported_inputs_.empty()) return;
  std::set<std::string> scratch, constant, input, output, elsewhere; // the last: of other files
  for (std::string const *label : reported_inputs_) output.insert(*label);
  std::vector<StaticObject> const objects = memory::find_static_objects();
  for (auto const &[begin, named] : names_) {
    auto const object = std::find_if(objects.begin(), objects.end(), [at = begin](StaticObject const &one) {
      return one.begin <= at && at < one.begin + one.size;
    });
    if (object == objects.end()) continue;
    std::string const name(named.site.name);
    Place const place = place_of(named.site);
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
    if (!names->empty()) event({"clause", clause, list(*names)});
}

} // namespace symreal::trace
