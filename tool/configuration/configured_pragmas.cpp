#include "tool/configuration/configured_pragmas.h"

#include "rewrite/facts/clause.h"
#include "rewrite/text/source_text.h"
#include "tool/configuration/unknown_words.h"

#include <filesystem>
#include <optional>

namespace symreal::tool {
namespace {

using rewrite::Clause;
using rewrite::ConfiguredClause;
using rewrite::ConfiguredText;

ConfiguredClause range_clause(Yaml const &node, Place const &place) {
  ConfiguredClause clause{{name_of(Clause::range), place}, {}};
  for (Yaml const &one : node.list()) clause.items.push_back(one.text());
  if (clause.items.size() != 2) node.fail("a range has two numbers, as in [-1, 1]");
  if (std::string const wrong = rewrite::wrong_range(clause.items[0].text, clause.items[1].text); !wrong.empty())
    symreal::fail(DiagnosticId::bad_range, clause.items[0].place, wrong);
  return clause;
}

// Adds one clause for each input, since a range applies to the inputs before it.
void add_inputs(std::vector<ConfiguredClause> &clauses, ConfiguredText const &name, Yaml const &node,
                std::optional<ConfiguredClause> const &range) {
  auto const add = [&](ConfiguredText item) { clauses.push_back({name, {std::move(item)}}); };
  for (Yaml const &one : node.list()) {
    if (!one.is_map()) {
      add(one.text());
      if (range) clauses.push_back(*range);
      continue;
    }
    for (auto const &[item, own] : one.entries()) {
      add(item);
      clauses.push_back(range_clause(own, item.place));
    }
  }
}

// Adds derivative clauses; "jacobian(tau, [q, qd])" is spelled as in the pragma.
void add_derivatives(std::vector<ConfiguredClause> &clauses, Yaml const &node) {
  for (Yaml const &one : node.list()) {
    ConfiguredText const whole = one.text();
    std::size_t const open = whole.text.find('(');
    std::optional<Clause> const clause = rewrite::find_clause(whole.text.substr(0, open));
    if (!clause || !rewrite::info(*clause).has(rewrite::trait::WORDS) || !whole.text.ends_with(')'))
      one.fail("'" + whole.text + "' is no derivative, as jacobian(tau, [q, qd]) is");
    std::string const inner = whole.text.substr(open + 1, whole.text.size() - open - 2);
    clauses.push_back({{name_of(*clause), whole.place}, {{inner, whole.place}}});
  }
}

ConfiguredText required_function(std::vector<Yaml::Entry> const &entries, Yaml const &node) {
  for (auto const &[key, value] : entries)
    if (key.text == "function") return value.text();
  node.fail("'function' is missing: name the function of this entry");
}

// List of the configuration's keys for clauses.
std::string keys() {
  std::string list;
  for (rewrite::ClauseInfo const &row : rewrite::clause_table())
    if (!row.key.empty()) list += (list.empty() ? "" : ", ") + std::string(row.key);
  return list;
}

[[noreturn]] void refuse_key(ConfiguredText const &key, std::string const &there_are) {
  fail(DiagnosticId::configuration, key.place,
       "unknown key '" + key.text + "'; there are: " + there_are + did_you_mean(key.text, there_are));
}

} // namespace

rewrite::ConfiguredKernel read_kernel(Yaml const &node, std::string const &directory) {
  std::vector<Yaml::Entry> const entries = node.entries();
  rewrite::ConfiguredKernel kernel{required_function(entries, node), {}, {}};
  std::optional<ConfiguredClause> range;
  for (auto const &[key, value] : entries)
    if (key.text == "range") range = range_clause(value, key.place);
  for (auto const &[key, value] : entries) {
    if (key.text == "function" || key.text == "range") continue;
    std::optional<Clause> const clause = rewrite::find_configured_clause(key.text);
    if (key.text == "file") {
      std::error_code error;
      kernel.file = std::filesystem::canonical(std::filesystem::path(directory) / value.text().text, error).string();
      if (error) value.fail("'" + value.text().text + "' does not exist");
    } else if (key.text == "derivatives")
      add_derivatives(kernel.clauses, value);
    else if (!clause)
      refuse_key(key, "function, file, " + keys() + ", derivatives");
    else if (*clause == Clause::input)
      add_inputs(kernel.clauses, {name_of(*clause), key.place}, value, range);
    else {
      kernel.clauses.push_back({{name_of(*clause), key.place}, {}});
      for (Yaml const &one : value.list()) kernel.clauses.back().items.push_back(one.text());
    }
  }
  return kernel;
}

rewrite::ConfiguredExternal read_external(Yaml const &node) {
  std::vector<Yaml::Entry> const entries = node.entries();
  rewrite::ConfiguredExternal external{required_function(entries, node), false, {}, {}};
  for (auto const &[key, value] : entries) {
    if (key.text == "function") continue;
    std::optional<Clause> const clause = rewrite::find_configured_clause(key.text);
    if (key.text == "pure")
      external.pure = value.truth();
    else if (key.text == "derivatives")
      for (Yaml const &one : value.list()) external.derivatives.push_back(one.text());
    else if (clause == Clause::input || clause == Clause::output) {
      external.clauses.push_back({{name_of(*clause), key.place}, {}});
      for (Yaml const &one : value.list()) external.clauses.back().items.push_back(one.text());
    } else
      refuse_key(key, "function, pure, derivatives, inputs, outputs");
  }
  return external;
}

} // namespace symreal::tool
