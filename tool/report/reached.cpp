#include "tool/report/reached.h"

#include <algorithm>
#include <fmt/ostream.h>
#include <set>

namespace symreal::tool {
namespace {

class Within {
public:
  explicit Within(rewrite::Reach const &reach) : reach_(reach) {}

  bool operator()(Place const &place) const {
    return std::any_of(reach_.functions.begin(), reach_.functions.end(), [&](rewrite::ReachedFunction const &one) {
      return one.begin.file == place.file && one.begin.line <= place.line && place.line <= one.end.line;
    });
  }

private:
  rewrite::Reach const &reach_;
};

std::string use(rewrite::ReachedState const &state) {
  if (state.is_written) return "written";
  return state.is_passed_on ? "its address is passed on" : "read";
}

void print_state(std::ostream &out, rewrite::Reach const &reach) {
  if (reach.state.empty()) return;
  out << "  state that outlives a call\n";
  std::set<std::string> changed;
  for (rewrite::ReachedState const &one : reach.state) {
    fmt::print(out, "    {}: {}, {}\n", to_string(one.place), one.name, use(one));
    if (one.is_written || one.is_passed_on) changed.insert(one.name);
  }
  std::string list;
  for (std::string const &name : changed) list += (list.empty() ? "" : ", ") + name;
  if (!list.empty()) fmt::print(out, "    where nobody reads what a call leaves in them: scratch({})\n", list);
}

} // namespace

void print_reach(std::ostream &out, std::string const &function, rewrite::Reach const &reach,
                 rewrite::Result const &result) {
  Within const within(reach);
  std::set<std::string> files;
  for (rewrite::ReachedFunction const &one : reach.functions) files.insert(one.begin.file);
  fmt::print(out, "{} reaches {} functions in {} files\n", function, reach.functions.size(), files.size());
  print_state(out, reach);
  std::string title;
  auto const line = [&](char const *of, std::string const &text) {
    if (title != of) fmt::print(out, "  {}\n", of);
    title = of;
    fmt::print(out, "    {}\n", text);
  };
  for (rewrite::Decision const &one : result.decisions)
    if (within(one.place))
      line("decisions on values",
           fmt::format("{}: {} {}", to_string(one.place), one.kind,
                       one.selectable ? "can be a select" : "cannot be a select because of " + words(one.reason)));
  for (rewrite::Conversion const &one : result.conversions)
    if (within(one.place)) line("conversions of values", to_string(one.place) + ": to " + one.type);
  for (Diagnostic const &one : result.diagnostics)
    if (within(one.place))
      line("what blocks it", fmt::format("{}: {} [{}]", to_string(one.place), one.message, code(one.id)));
  for (Note const &one : reach.not_followed) line("not followed", to_string(one.place) + ": " + one.message);
  for (std::string const &one : reach.undefined) line("called, but not defined in the given sources", one);
}

} // namespace symreal::tool
