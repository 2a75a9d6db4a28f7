#include "tool/configuration/configuration.h"

#include "rewrite/facts/tables.h"
#include "rewrite/text/source_text.h"
#include "tool/configuration/unknown_words.h"
#include "tool/configuration/yaml.h"

#include <filesystem>
#include <optional>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;
using rewrite::Clause;
using rewrite::ConfiguredClause;
using rewrite::ConfiguredText;

// The parts of a configuration that replace pragmas:
//
//   kernels:
//     - function: arm::inverse_dynamics     # its clauses are those of the pragma
//       inputs: [q, "qd[0:n]"]              # items, or item: [low, high]
//       range: [-3.14, 3.14]                # of inputs without a range of their own
//       parameters: m
//       outputs: tau[0:n]

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
      one.fail("'" + whole.text + "' is not a derivative, as jacobian(tau, [q, qd]) is");
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
      kernel.file = fs::canonical(fs::path(directory) / value.text().text, error).string();
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

// File name for messages: relative if the file is below the current directory.
std::string shown(fs::path const &file) {
  fs::path const near = file.lexically_proximate(fs::current_path());
  return near.begin() != near.end() && *near.begin() == ".." ? file.string() : near.string();
}

Configuration::Option read_option(Yaml::Entry const &entry) {
  Configuration::Option option{entry.key.text, {}, entry.key.place};
  for (Yaml const &value : entry.value.list()) option.values.push_back(value.text().text);
  return option;
}

// Is the option excluded from `options`, since it locates the configuration or has a key of its own?
bool has_own_key(std::string const &name) {
  return name == "config" || name == "root" || name == "type-name" || name == "help" || name == "numeric";
}

CLI::Option *find_option(CLI::App &command, std::string const &name) {
  if (name.empty() || name.front() == '-') return nullptr;
  return command.get_option_no_throw((name.size() == 1 ? "-" : "--") + name);
}

void refuse_unknown(Configuration::Option const &option, CLI::App &command) {
  if (has_own_key(option.name))
    fail(DiagnosticId::configuration, option.place, "'" + option.name + "' cannot be set under 'options'");
  for (CLI::App *one : command.get_parent()->get_subcommands([](CLI::App *) { return true; }))
    if (find_option(*one, option.name)) return;
  fail(DiagnosticId::configuration, option.place, "no subcommand has an option '" + option.name + "'");
}

void set(CLI::Option &known, Configuration::Option const &option, std::string const &directory) {
  bool const is_path = known.get_type_name() == "FILE" || known.get_type_name() == "DIR";
  for (std::string const &value : option.values)
    known.add_result(is_path ? (fs::path(directory) / value).string() : value);
  try {
    known.run_callback();
  } catch (CLI::Error const &problem) {
    fail(DiagnosticId::configuration, option.place, problem.what());
  }
}

} // namespace

std::string find_configuration(std::string const &directory) {
  std::error_code error;
  fs::path at = fs::weakly_canonical(directory.empty() ? "." : directory, error);
  while (!error) {
    fs::path const file = at / ".symreal.yaml";
    if (fs::is_regular_file(file, error)) return shown(file);
    error.clear();
    if (!at.has_relative_path()) break;
    at = at.parent_path();
  }
  return {};
}

Configuration read_configuration(std::string const &file) {
  Configuration result;
  std::error_code is_no_file; // a pipe has no canonical name
  fs::path const canonical = fs::weakly_canonical(file, is_no_file);
  result.directory = (is_no_file ? fs::absolute(file) : canonical).parent_path().string();
  auto const below = [&](std::string const &name) { return (fs::path(result.directory) / name).string(); };
  result.exclude.directory = result.directory;
  for (auto const &[key, value] : read_yaml(file).entries()) {
    if (key.text == "roots")
      for (Yaml const &one : value.list()) {
        result.roots.push_back(below(one.text().text));
        if (!fs::is_directory(result.roots.back())) one.fail("'" + one.text().text + "' is not a directory");
      }
    else if (key.text == "exclude")
      for (Yaml const &one : value.list()) result.exclude.patterns.push_back(one.text().text);
    else if (key.text == "type")
      result.type_name = value.text().text;
    else if (key.text == "options")
      for (Yaml::Entry const &one : value.entries()) result.options.push_back(read_option(one));
    else if (key.text == "kernels")
      for (Yaml const &one : value.list())
        if (one.is_map())
          result.kernels.push_back(read_kernel(one, result.directory));
        else
          result.calls.push_back(one.text());
    else if (key.text == "externals")
      for (Yaml const &one : value.list()) result.externals.push_back(read_external(one));
    else
      refuse_key(key, "roots, exclude, type, options, kernels, externals");
  }
  return result;
}

void set_options(Configuration const &configuration, CLI::App &command, ConfiguredOptions &given) {
  for (Configuration::Option const &option : configuration.options) {
    refuse_unknown(option, command);
    CLI::Option *known = find_option(command, option.name);
    if (!known || known->count() != 0) continue;
    set(*known, option, configuration.directory);
    given[known->get_name()] = option.place;
  }
}

Diagnostic located(Diagnostic diagnostic, ConfiguredOptions const &given) {
  if (!diagnostic.place.file.empty()) return diagnostic;
  std::string const name = diagnostic.message.substr(0, diagnostic.message.find_first_of(" :"));
  if (auto const found = given.find(name); found != given.end()) diagnostic.place = found->second;
  return diagnostic;
}

} // namespace symreal::tool
