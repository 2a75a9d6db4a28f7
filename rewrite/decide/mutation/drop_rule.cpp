#include "rewrite/decide/mutation/drop_rule.h"

#include <cstdlib>
#include <functional>

namespace symreal::rewrite {
namespace {

// The uses that are one rule together; any other is one by itself.
std::map<std::string_view, std::set<Use>> const groups = {
    {"width", {Use::width, Use::as_width}},
    {"range", {Use::range_begin, Use::range_end}},
    {"formatting", {Use::formatting, Use::shown}},
    {"layouts", {Use::layout, Use::padding}},
};
std::map<std::string, std::function<void(Facts &)>> const others = {
    {"members", [](Facts &facts) { facts.members.clear(); }},
    {"shared", [](Facts &facts) { facts.shared.clear(); }},
    {"quoted", [](Facts &facts) { facts.quoted.clear(), facts.pasted.clear(); }},
    {"text_calls", [](Facts &facts) { facts.text_calls.clear(); }},
    {"selects", [](Facts &facts) { facts.decisions.clear(); }},
    {"boundaries", [](Facts &facts) { facts.uses.clear(); }},
    {"number_readers", [](Facts &facts) { facts.lists.clear(); }},
};

std::set<Use> uses_of(std::string_view rule) {
  if (auto const group = groups.find(rule); group != groups.end()) return group->second;
  if (std::optional<Use> const use = find_use(rule)) return {*use};
  return {};
}

} // namespace

// A rule is also an id such as SYM035: what the reading of the sources reports under it.
void drop_rule(Facts &facts) {
  char const *const name = std::getenv("SYMREAL_DROP_RULE");
  if (!name || !*name) return;
  std::set<Use> const dropped = uses_of(name);
  if (!dropped.empty())
    std::erase_if(facts.wraps, [&](Wrap const &wrap) { return dropped.contains(wrap.use); });
  else if (auto const other = others.find(name); other != others.end())
    other->second(facts);
  else if (find_diagnostic(name))
    std::erase_if(facts.diagnostics, [&](Diagnostic const &one) { return code(one.id) == name; });
  else
    internal_failure("SYMREAL_DROP_RULE names a rule", __FILE__, __LINE__);
}

} // namespace symreal::rewrite
