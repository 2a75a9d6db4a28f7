#include "rewrite/decide/mutation/drop_rule.h"

#include <cstdlib>
#include <functional>

namespace symreal::rewrite {
namespace {

// The uses by their names, those that are one rule together; and what is no use.
std::map<std::string, std::set<Use>> const uses = {
    {"returned", {Use::returned}},
    {"declared", {Use::declared}},
    {"cast", {Use::cast}},
    {"conversion", {Use::conversion}},
    {"integer", {Use::integer}},
    {"linkage", {Use::linkage}},
    {"table", {Use::table}},
    {"value", {Use::value}},
    {"enumeration", {Use::enumeration}},
    {"promoted", {Use::promoted}},
    {"of_c", {Use::of_c}},
    {"counted", {Use::counted}},
    {"width", {Use::width, Use::as_width}},
    {"literal", {Use::literal}},
    {"external", {Use::external}},
    {"function", {Use::function}},
    {"range", {Use::range_begin, Use::range_end}},
    {"bits", {Use::bits}},
    {"read", {Use::read}},
    {"written", {Use::written}},
    {"changed", {Use::changed}},
    {"bytes", {Use::bytes}},
    {"state", {Use::state}},
    {"local_state", {Use::local_state}},
    {"pasted", {Use::pasted}},
    {"prototype", {Use::prototype}},
    {"name", {Use::name}},
    {"division", {Use::division}},
    {"environment", {Use::environment}},
    {"formatting", {Use::formatting}},
    {"text", {Use::text}},
    {"later", {Use::later}},
    {"now", {Use::now}},
    {"argument", {Use::argument}},
    {"truth", {Use::truth}},
    {"layouts", {Use::layout, Use::padding}},
    {"padding", {Use::padding}},
};
std::map<std::string, std::function<void(Facts &)>> const others = {
    {"members", [](Facts &facts) { facts.members.clear(); }},
    {"shared", [](Facts &facts) { facts.shared.clear(); }},
    {"quoted", [](Facts &facts) { facts.quoted.clear(), facts.pasted.clear(); }},
    {"text_calls", [](Facts &facts) { facts.text_calls.clear(); }},
    {"selects", [](Facts &facts) { facts.decisions.clear(); }},
    {"boundaries", [](Facts &facts) { facts.uses.clear(); }},
    {"number_readers", [](Facts &facts) { facts.number_readers.clear(); }},
};

} // namespace

// A rule is also an id such as SYM035: what the reading of the sources reports under it.
void drop_rule(Facts &facts) {
  char const *const name = std::getenv("SYMREAL_DROP_RULE");
  if (!name || !*name) return;
  if (auto const found = uses.find(name); found != uses.end())
    std::erase_if(facts.wraps, [&](Wrap const &wrap) { return found->second.contains(wrap.use); });
  else if (auto const other = others.find(name); other != others.end())
    other->second(facts);
  else if (find_diagnostic(name))
    std::erase_if(facts.diagnostics, [&](Diagnostic const &one) { return code(one.id) == name; });
  else
    internal_failure("SYMREAL_DROP_RULE names a rule", __FILE__, __LINE__);
}

} // namespace symreal::rewrite
