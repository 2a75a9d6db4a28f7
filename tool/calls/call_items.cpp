#include "tool/calls/call_items.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::tool {

using rewrite::CallParameter;
using rewrite::Section;
using Kind = CallParameter::Kind;

std::string with(std::string text, std::string const &mark, std::string const &value) {
  for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + value.size()))
    text.replace(at, mark.size(), value);
  return text;
}

std::string end_of(Section const &section) {
  return section.low == "0" ? section.length : "(" + section.low + ") + (" + section.length + ")";
}

std::string larger(std::string const &one, std::string const &other) {
  return fmt::format("({0} > {1} ? {0} : {1})", one, other);
}

void CallItems::problem(Place const &place, std::string message) {
  binding_.problems.push_back(
      {DiagnosticId::call_specification, place, std::move(message), {{function_.place, function_.declaration}}});
}

CallItems::Parameter const *CallItems::parameter(std::string const &name) const {
  for (CallParameter const &one : function_.parameters)
    if (one.name == name) return &one;
  return nullptr;
}

std::vector<Section> CallItems::sections(Item const &item) const {
  CallParameter const *of = parameter(item.base);
  std::vector<Section> all = item.sections;
  if (of && of->kind == Kind::pointer && all.empty() && is_whole(item))
    for (std::string const &extent : of->extents) all.push_back({"0", extent});
  return all;
}

std::string CallItems::count(CallParameter const &of, std::size_t dimension) const {
  std::vector<std::string> counts;
  for (Item const &item : spec_.items) {
    std::string const index = item.base + "[";
    if (dimension == 0 && item.base == of.name && item.path.starts_with(index))
      counts.push_back("(" + item.path.substr(index.size(), item.path.find(']') - index.size()) + ") + 1");
    bool const is_base = item.base == of.name && item.path == item.base;
    std::vector<Section> const all = sections(item);
    if (!is_base || dimension >= all.size()) continue;
    std::string const needed = end_of(all[dimension]);
    if (std::find(counts.begin(), counts.end(), needed) == counts.end()) counts.push_back(needed);
  }
  std::string most;
  for (std::string const &one : counts) most = most.empty() ? one : larger(most, one);
  return most;
}

CallItems::Parameter::Member const *CallItems::other_member(Item const &item) const {
  CallParameter const *of = parameter(item.base);
  if (!of) return nullptr;
  std::size_t const begin = item.path.find(item.base) + item.base.size();
  std::string path = with(item.path.substr(begin), "->", ".");
  for (CallParameter::Member const &one : of->other_members)
    if (one.path == path) return &one;
  return nullptr;
}

bool CallItems::is_integer(Item const &item) const {
  CallParameter::Member const *member = other_member(item);
  return member && member->kind == CallParameter::Member::Kind::integer && item.sections.empty();
}

CallItems::Item const *CallItems::item_of(CallParameter const &one) const {
  for (Item const &item : spec_.items)
    if (item.base == one.name) return &item;
  return nullptr;
}

CallItems::Item const *CallItems::value_of(CallParameter const &one) const {
  for (Item const &item : spec_.items)
    if (item.base == one.name && is_whole(item) && item.kind != "output") return &item;
  return nullptr;
}

CallItems::Parameter const *CallItems::structure(Item const &item) const {
  CallParameter const *of = parameter(item.base);
  bool const is_whole_one = item.path == item.base || item.path == "*" + item.base;
  bool const has_rest =
      std::any_of(item.behind.begin(), item.behind.end(), [](std::string const &one) { return !one.empty(); });
  return of && !item.is_list && is_whole_one && !has_rest && !of->members.empty() ? of : nullptr;
}

bool CallItems::is_extent(std::string const &name) const {
  return std::any_of(spec_.items.begin(), spec_.items.end(), [&](Item const &item) {
    return std::any_of(item.sections.begin(), item.sections.end(),
                       [&](Section const &one) { return one.length == name; });
  });
}

} // namespace symreal::tool
