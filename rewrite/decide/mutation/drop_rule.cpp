#include "rewrite/decide/mutation/drop_rule.h"

#include "engine/support/mutation/is_dropped.h"

#include <cstdlib>
#include <functional>

namespace symreal::rewrite {
namespace {

// The uses that are one rule together; any other is one by itself.
std::map<std::string_view, std::set<Use>> const groups = {
    {"width", {Use::width, Use::as_width}},     {"range", {Use::range_begin, Use::range_end}},
    {"fill", {Use::fill_begin, Use::fill_end}}, {"formatting", {Use::formatting, Use::shown}},
    {"layouts", {Use::layout, Use::padding}},
};
// Macros of a use whose words begin like this.
std::function<void(Facts &)> drop(Use use, std::string_view words) {
  return [=](Facts &facts) {
    std::erase_if(facts.wraps, [&](Wrap const &wrap) { return wrap.use == use && wrap.detail.starts_with(words); });
  };
}

// Calls `change` with each wrap of the use, which it replaces.
template <class Change> void change_wraps(Facts &facts, Use use, Change change) {
  std::vector<Wrap> changed;
  for (Wrap const &wrap : facts.wraps)
    if (wrap.use == use) changed.push_back(wrap);
  for (Wrap const &wrap : changed) {
    facts.wraps.erase(wrap);
    change(wrap);
  }
}

// A function as a value is another one at each use.
void give_own_addresses(Facts &facts) {
  change_wraps(facts, Use::function, [&](Wrap const &wrap) {
    std::string const function =
        facts.files.at(wrap.span.file).text.substr(wrap.span.begin, wrap.span.end - wrap.span.begin);
    std::string const specifier = wrap.detail.ends_with("noexcept") ? " noexcept" : "";
    facts.wraps.insert({wrap.span, Use::instead,
                        "(*static_cast<::symreal::symreal_pointer_to<" + wrap.detail + ">>([](auto... symreal_x)" +
                            specifier + " { return " + function + "(symreal_x...); }))"});
  });
}

// A returned value is not made in the type of the function first: (label, ..., type) without the last.
void return_as_written(Facts &facts) {
  change_wraps(facts, Use::returned, [&](Wrap wrap) {
    constexpr std::string_view as = "_AS(";
    if (std::size_t const at = wrap.detail.find(as); at != wrap.detail.npos && at < wrap.detail.find('(')) {
      wrap.detail.erase(at, as.size() - 1);
      wrap.detail.erase(wrap.detail.rfind(", ("));
    }
    facts.wraps.insert(wrap);
  });
}

std::map<std::string, std::function<void(Facts &)>> const others = {
    {"members", [](Facts &facts) { facts.members.clear(); }},
    {"shared", [](Facts &facts) { facts.shared.clear(); }},
    {"quoted", [](Facts &facts) { facts.quoted.clear(), facts.pasted.clear(); }},
    {"text_calls", [](Facts &facts) { facts.text_calls.clear(); }},
    {"selects", [](Facts &facts) { facts.decisions.clear(); }},
    {"arithmetic", [](Facts &facts) { facts.arithmetic.clear(); }},
    {"boundaries", [](Facts &facts) { facts.uses.clear(); }},
    {"number_readers", [](Facts &facts) { facts.lists.clear(); }},
    {"lists_handed_on",
     [](Facts &facts) {
       for (auto &[name, list] : facts.lists) list.handed.clear();
     }},
    {"lists_that_leave",
     [](Facts &facts) {
       for (auto &[name, list] : facts.lists) list.outside.clear();
     }},
    {"written_first",
     [](Facts &facts) {
       change_wraps(facts, Use::local_state,
                    [&](Wrap const &wrap) { facts.wraps.insert({wrap.span, Use::scratch_state, wrap.detail}); });
     }},
    {"one_address", give_own_addresses},
    {"returned_as", return_as_written},
    {"returned_whole", drop(Use::returned, "_WHOLE(")},
    {"asked", drop(Use::of_c, "SYMREAL_REAL_INT(")},
    {"part_stored", drop(Use::part, "stored")},
    {"part_replaced", drop(Use::part, "replaced")},
    {"part_read", drop(Use::part, "read")},
    {"part_used", drop(Use::part, "used")},
    {"bytes_set", drop(Use::bytes, "set_")},
    {"bytes_moved", drop(Use::bytes, "move_")},
};

std::set<Use> uses_of(std::string_view rule) {
  if (auto const group = groups.find(rule); group != groups.end()) return group->second;
  if (std::optional<Use> const use = find_use(rule)) return {*use};
  return {};
}

} // namespace

// A rule is also an id such as SYM035: the diagnostics with this id from the reading of the sources.
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
  else if (!asks_by_name(name))
    internal_failure("SYMREAL_DROP_RULE names a rule", __FILE__, __LINE__);
}

} // namespace symreal::rewrite
