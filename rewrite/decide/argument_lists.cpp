#include "rewrite/decide/argument_lists.h"

#include "rewrite/facts/spans.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

// All functions that receive the list of `function`, itself included.
std::set<std::string> reached_from(Facts const &facts, std::string const &function) {
  std::set<std::string> reached;
  std::vector<std::string> pending = {function};
  while (!pending.empty()) {
    std::string const one = std::move(pending.back());
    pending.pop_back();
    if (!reached.insert(one).second) continue;
    if (auto const found = facts.lists.find(one); found != facts.lists.end())
      pending.insert(pending.end(), found->second.handed.begin(), found->second.handed.end());
  }
  return reached;
}

void report_lists(Facts const &facts, Place const &call, std::string const &function, Result &result) {
  bool const reads = reads_numbers(facts, function);
  for (std::string const &name : reached_from(facts, function)) {
    if (name.empty()) continue;
    auto const found = facts.lists.find(name);
    Note const given{call, "'" + function + "' is given a REAL here"};
    if (found == facts.lists.end()) {
      result.diagnostics.push_back(
          {DiagnosticId::boundary_call, call, "a REAL goes to '" + name + "', which the given sources do not define"});
      continue;
    }
    for (auto const &[place, outside] : found->second.outside)
      if (reads || !outside.leaves)
        result.diagnostics.push_back(
            {DiagnosticId::boundary_call,
             outside.place,
             "a list of arguments with a REAL in it goes to '" + outside.function + "', which is outside the roots",
             {given}});
  }
}

bool may_print(Facts const &facts, std::string const &function) {
  std::set<std::string> const reached = reached_from(facts, function);
  return std::any_of(facts.lists.begin(), facts.lists.end(), [&](auto const &one) {
    return one.second.prints && (reached.contains(one.first) || reached.contains(""));
  });
}

} // namespace

bool reads_numbers(Facts const &facts, std::string const &function) {
  auto const found = facts.lists.find(function);
  return found != facts.lists.end() && found->second.reads;
}

void follow_argument_lists(Facts &facts, Result &result) {
  for (auto &[name, list] : facts.lists)
    for (std::string const &reached : reached_from(facts, name))
      list.reads = list.reads || reads_numbers(facts, reached);
  std::set<std::string> given;
  for (Wrap const &wrap : facts.wraps)
    if (wrap.use == Use::value && facts.lists.contains(wrap.detail) && given.insert(wrap.detail).second)
      report_lists(facts, place_in(facts.files.at(wrap.span.file), wrap.span.begin), wrap.detail, result);
  // A function of the library that prints such a list prints carried values, when the program runs.
  for (std::string const &name : given)
    if (reads_numbers(facts, name)) facts.makes_text |= may_print(facts, name);
}

} // namespace symreal::rewrite
