#include "tool/scheduling/unit_option.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace symreal::tool {
namespace {

constexpr unsigned most_units = 65'536;

unsigned read_count(std::string const &word) {
  unsigned count = 0;
  auto const [end, failed] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (word.empty() || failed != std::errc() || end != word.data() + word.size() || count > most_units)
    fail(DiagnosticId::bad_option, {},
         "--units takes a number up to " + std::to_string(most_units) + ", or kinds such as mul=2,other=1; not '" +
             word + "'");
  if (count == 0) fail(DiagnosticId::no_unit, {}, "0 units can run no task");
  return count;
}

// Group of an operation, by its syntactic form.
std::string_view group_of(Op op) {
  switch (info(op).form) {
  case Form::call:
  case Form::local: return "function";
  case Form::external: return "external";
  default: return "arithmetic";
  }
}

bool is_kind(std::string const &name) {
  return find_operation(name) || name == "arithmetic" || name == "function" || name == "external" || name == "other";
}

struct Kind {
  std::string name;
  unsigned count;
};

std::vector<Kind> read_kinds(std::string const &words) {
  std::vector<Kind> kinds;
  std::istringstream stream(words);
  for (std::string word; std::getline(stream, word, ',');) {
    std::size_t const equals = std::min(word.find('='), word.size());
    Kind kind{word.substr(0, equals), read_count(word.substr(std::min(equals + 1, word.size())))};
    if (!is_kind(kind.name))
      fail(DiagnosticId::bad_option, {},
           "--units: '" + kind.name + "' is no operation, and none of arithmetic, function, external, other");
    if (std::ranges::find(kinds, kind.name, &Kind::name) != kinds.end())
      fail(DiagnosticId::bad_option, {}, "--units lists '" + kind.name + "' twice");
    kinds.push_back(std::move(kind));
  }
  if (kinds.size() > 255) fail(DiagnosticId::bad_option, {}, "--units takes up to 255 kinds");
  return kinds;
}

void set_kinds(TaskInput &input, std::vector<Kind> const &kinds) {
  for (TaskId task = 0; task < input.tasks.size(); ++task) {
    Op const op = input.operation[task];
    auto found = kinds.end();
    for (std::string_view name : {info(op).name, group_of(op), std::string_view("other")})
      if (found == kinds.end()) found = std::ranges::find(kinds, name, &Kind::name);
    if (found == kinds.end())
      fail(DiagnosticId::no_unit, {input.file, 0, 0},
           "no unit runs '" + std::string(info(op).name) + "', which is of kind '" + std::string(group_of(op)) + "'");
    input.tasks.kind.push_back(static_cast<std::uint8_t>(found - kinds.begin()));
  }
}

} // namespace

NamedUnits read_units(std::string const &words, Time communication, TaskInput &input) {
  NamedUnits result{{{}, communication}, {}};
  if (words.find('=') == words.npos) {
    result.units.count = {read_count(words)};
    for (unsigned i = 0; i < result.units.count[0]; ++i) result.name.push_back("unit " + std::to_string(i));
    return result;
  }
  if (!input.is_recorded())
    fail(DiagnosticId::bad_option, {},
         "--units takes a number here: the tasks of '" + input.file + "' are of one kind");
  std::vector<Kind> const kinds = read_kinds(words);
  set_kinds(input, kinds);
  for (Kind const &kind : kinds) {
    result.units.count.push_back(kind.count);
    for (unsigned i = 0; i < kind.count; ++i) result.name.push_back(kind.name + " " + std::to_string(i));
  }
  if (result.name.size() > most_units)
    fail(DiagnosticId::bad_option, {}, "--units takes up to " + std::to_string(most_units) + " units");
  return result;
}

} // namespace symreal::tool
