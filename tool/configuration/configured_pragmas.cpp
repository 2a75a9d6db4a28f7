#include "tool/configuration/configured_pragmas.h"

#include "tool/configuration/unknown_words.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace symreal::tool {
namespace {

using rewrite::ConfiguredClause;
using rewrite::ConfiguredText;

// Clauses that may also be called by their plural, since they are lists.
constexpr std::array<std::string_view, 5> plurals = {"input", "parameter", "constant", "output", "table"};
constexpr std::array<std::string_view, 3> others = {"scratch", "call", "decisions"};

// The pragma's word for a key, if it has one.
std::optional<std::string> clause_name(std::string const &key) {
  for (std::string_view one : plurals)
    if (key == one || key == std::string(one) + "s") return std::string(one);
  if (std::find(others.begin(), others.end(), key) != others.end()) return key;
  return {};
}

ConfiguredClause range_clause(Yaml const &node, Place const &place) {
  ConfiguredClause clause{{"range", place}, {}};
  for (Yaml const &one : node.list()) clause.items.push_back(one.text());
  if (clause.items.size() != 2) node.fail("a range has two numbers, as in [-1, 1]");
  return clause;
}

// One clause for each input, since a range is that of the inputs before it.
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

ConfiguredText required_function(std::vector<Yaml::Entry> const &entries, Yaml const &node) {
  for (auto const &[key, value] : entries)
    if (key.text == "function") return value.text();
  node.fail("'function' is missing: which one this is about");
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
    std::optional<std::string> const name = clause_name(key.text);
    if (key.text == "file") {
      std::error_code error;
      kernel.file = std::filesystem::canonical(std::filesystem::path(directory) / value.text().text, error).string();
      if (error) value.fail("'" + value.text().text + "' does not exist");
    } else if (!name)
      refuse_key(key,
                 "function, file, inputs, parameters, constants, scratch, outputs, range, tables, call, decisions");
    else if (*name == "input")
      add_inputs(kernel.clauses, {*name, key.place}, value, range);
    else {
      kernel.clauses.push_back({{*name, key.place}, {}});
      for (Yaml const &one : value.list()) kernel.clauses.back().items.push_back(one.text());
    }
  }
  return kernel;
}

rewrite::ConfiguredExternal read_external(Yaml const &node) {
  std::vector<Yaml::Entry> const entries = node.entries();
  rewrite::ConfiguredExternal external{required_function(entries, node), false, {}};
  for (auto const &[key, value] : entries) {
    if (key.text == "function") continue;
    std::optional<std::string> const name = clause_name(key.text);
    if (key.text == "pure")
      external.pure = value.truth();
    else if (name == "input" || name == "output") {
      external.clauses.push_back({{*name, key.place}, {}});
      for (Yaml const &one : value.list()) external.clauses.back().items.push_back(one.text());
    } else
      refuse_key(key, "function, pure, inputs, outputs");
  }
  return external;
}

} // namespace symreal::tool
