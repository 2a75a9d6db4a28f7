#include "engine/emit/requirements.h"

#include "engine/emit/print/externals.h"
#include "engine/graph/external.h"
#include "engine/graph/graph.h"
#include "engine/graph/implicit.h"
#include "engine/graph/names.h"
#include "engine/support/number.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace symreal {

namespace {

template <class Test> bool has_live(Graph const &graph, Test const &test) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id] && !is_leaf(graph.nodes[id].op) && test(graph.nodes[id].op)) return true;
  return false;
}

// A file whose name is an identifier in its contents needs a valid one.
void require_file_name(Language const &language, EmitOptions const &options) {
  bool const names_it = std::ranges::any_of(language.files.companions, [&](Companion const &file) {
    return file.is_named_after_file && options.extras.contains(file.option);
  });
  if (!names_it && !language.module.is_named_after_file) return;
  if (identifier(options.base_name, language.names) == options.base_name) return;
  fail(DiagnosticId::bad_option, {},
       "a file of --lang=" + std::string(language.name) + " is called as what it contains, and '" + options.base_name +
           "' cannot be a name there: give another with -o");
}

// Requirements of calls on bridges.
template <class Require> void require_bridges(Graph const &graph, BridgeSyntax const &syntax, std::string const &kernel,
                                              Require const &require) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!live[id] || !is_call(graph.nodes[id].op)) continue;
    External const &external = graph.externals[function_of(graph, graph.nodes[id])];
    require(false, find_complex_function(external).has_value(), kernel + "functions of complex numbers");
    auto const look = [&](ExternalValue const &value) {
      require(find_integer(syntax, value.type), value.kind == ExternalValue::Kind::integer,
              kernel + "'" + external.name + "', which has an integer of type '" + value.type + "'");
    };
    look(external.returned);
    for (ExternalValue const &parameter : external.parameters) look(parameter);
  }
}

} // namespace

void require_expressible(Plan const &plan, Language const &language, EmitOptions const &options) {
  Graph const &graph = *plan.graph;
  auto const require = [&](bool is_there, bool is_wanted, std::string const &what) {
    if (is_wanted && !is_there)
      fail(DiagnosticId::bad_option, {}, what + ", which --lang=" + std::string(language.name) + " does not have");
  };
  require_file_name(language, options);
  std::string const kernel = "kernel '" + graph.kernel + "' needs ";
  bool const calls = has_live(graph, is_call);
  require(language.externals.is_given(), calls, kernel + "external functions");
  if (calls && language.externals.bridge.is_given()) require_bridges(graph, language.externals.bridge, kernel, require);
  require(!language.tables.begin.empty(), has_live(graph, [](Op op) { return op == Op::lookup || op == Op::lookup2; }),
          kernel + "tables");
  bool const has_integers = language.files.integer_functions || !language.files.helpers.empty();
  require(has_integers, has_live(graph, [](Op op) { return info(op).form == Form::local || is_wide(op); }),
          kernel + "integers of 64 bits");
  for (Op const op : language.lacks)
    require(false, has_live(graph, [&](Op other) { return other == op; }),
            kernel + "operation " + std::string(info(op).name));
  require(!language.statements.check.empty(), !graph.guards.empty(), kernel + "guards");
  require(!language.statements.value_check.empty(), options.check_values, "--debug=values needs reports of values");
  require(language.parallel.is_given(), plan.threads > 1, "--parallel needs OpenMP sections");
  for (std::string const &extra : options.extras) {
    bool const is_there =
        std::ranges::any_of(language.files.companions, [&](Companion const &file) { return file.option == extra; });
    require(is_there, true, "--" + extra + " needs a file of its own");
  }
}

namespace {

constexpr std::string_view way_out = "; generate it with --real=double";

[[noreturn]] void refuse(std::string const &what) { fail(DiagnosticId::bad_option, {}, what + std::string(way_out)); }

bool overflows(double value) { return std::isfinite(value) && std::isinf(static_cast<float>(value)); }

void require_in_range(std::string const &of, std::span<double const> values) {
  auto const found = std::ranges::find_if(values, overflows);
  if (found != values.end()) refuse(of + " " + shortest(*found) + ", and a float ends at 3.4e38");
}

// Whether the operation needs integers beyond the 24 bits of a float: of 64 bits, and those that wrap at 32.
bool is_beyond(Op op) {
  return info(op).has(flag::WIDE | flag::TAKES_WIDE) || op == Op::mul_uint32 || op == Op::wrap_int32 ||
         op == Op::wrap_uint32;
}

void require_operations(std::string const &kernel, Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!live[id]) continue;
    if (node.is_constant()) {
      double const value = node.value();
      require_in_range(kernel + "computes with", {&value, 1});
    }
    if (is_leaf(node.op)) continue;
    if (is_call(node.op)) refuse(kernel + "calls a function that takes doubles");
    if (is_beyond(node.op))
      refuse(kernel + "computes with integers of 32 bits that wrap, or of 64 (" + std::string(info(node.op).name) +
             "), and a float holds 24");
  }
}

} // namespace

void require_single(Graph const &graph, Language const &language, EmitOptions const &options) {
  if (language.single.number.name.empty())
    fail(DiagnosticId::bad_option, {},
         "--real=float needs single precision, which --lang=" + std::string(language.name) + " does not have");
  for (Companion const &companion : language.files.companions)
    if (companion.takes_doubles && options.extras.contains(companion.option))
      fail(DiagnosticId::bad_option, {},
           "--" + std::string(companion.option) + " hands on doubles: leave --real=float out");
  std::string const kernel = "kernel '" + graph.kernel + "' ";
  require_operations(kernel, graph);
  for (Table const &table : graph.tables) require_in_range(kernel + "has a table with", table.values);
  if (!options.extras.contains("mainline")) return; // only a main program has the recorded values
  require_in_range(kernel + "was recorded with the input", graph.input_values);
  require_in_range(kernel + "was recorded with the parameter", graph.parameter_values);
}

namespace {

// Tokeniser for C: identifiers and single characters, without comments, strings and preprocessor lines.
class Tokens {
public:
  explicit Tokens(std::string_view text) : text_(text) {}

  // The next token; empty at the end.
  std::string_view next() {
    skip();
    std::size_t end = at_ + (at_ < text_.size());
    if (is_part(at_))
      while (is_part(end)) ++end;
    std::string_view const token = text_.substr(at_, end - at_);
    at_ = end;
    return token;
  }

private:
  bool is_part(std::size_t at) const {
    return at < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at])) || text_[at] == '_');
  }
  bool begins(std::string_view mark) const { return text_.substr(at_).starts_with(mark); }

  void skip() {
    while (at_ < text_.size()) {
      if (begins("/*")) {
        at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
      } else if (begins("#")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (begins("\"")) {
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\';
        at_ = std::min(at_ + 1, text_.size());
      } else if (std::isspace(static_cast<unsigned char>(text_[at_]))) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

// Macros of <math.h> and <stdbool.h>, which would change a prototype of that name.
bool is_macro(std::string_view name) {
  static constexpr std::string_view macros[] = {
      "bool",        "true",          "false",       "isnan",     "isinf",    "isfinite",
      "isnormal",    "signbit",       "fpclassify",  "isgreater", "isless",   "isgreaterequal",
      "islessequal", "islessgreater", "isunordered", "NAN",       "INFINITY", "HUGE_VAL"};
  return std::ranges::find(macros, name) != std::end(macros);
}

bool is_of_mathematical_library(std::string_view name) {
  return std::ranges::any_of(operations(), [&](OperationInfo const &operation) {
    return operation.form == Form::call && operation.c == name;
  });
}

// Declaration counts of names, and names in other roles.
struct Names {
  std::map<std::string_view, std::size_t> declarations;
  std::set<std::string_view> others;

  void look_at(std::string_view text) {
    Tokens tokens(text);
    std::string_view before;
    for (std::string_view token = tokens.next(); !token.empty();) {
      std::string_view const behind = tokens.next();
      if (auto const found = declarations.find(token); found != declarations.end()) {
        bool const is_behind_type = !before.empty() && before != "return" && (before == "*" || is_word(before));
        if (behind != "(" || before == ".") others.insert(found->first);
        found->second += is_behind_type;
      }
      before = token;
      token = behind;
    }
  }

private:
  static bool is_word(std::string_view token) {
    return std::isalnum(static_cast<unsigned char>(token[0])) || token[0] == '_';
  }
};

} // namespace

void require_other_names(Emission const &emission, std::vector<EmittedFile> const &files) {
  Language const &language = emission.language;
  if (!language.externals.call || emission.uses.externals.empty()) return;
  Names names;
  for (std::size_t const number : emission.uses.externals) names.declarations[emission.graph().externals[number].name];
  for (EmittedFile const &file : files) names.look_at(file.text);
  for (std::size_t const number : emission.uses.externals) {
    External const &external = emission.graph().externals[number];
    std::string const &name = external.name;
    if (is_implicit(external) || find_complex_function(external) || is_of_mathematical_library(name)) continue;
    bool const is_word = language.has_namespace && language.names.is_keyword(name);
    bool const is_function_alone = names.declarations[name] <= 1 && !names.others.contains(name);
    if (name != "main" && !is_word && !is_macro(name) && is_function_alone) continue;
    bool const is_own = name == "compute" || name == "preprocess" || name == "guard_text";
    fail(DiagnosticId::bad_option, external.place,
         "kernel '" + emission.graph().kernel + "' calls '" + name +
             "', and code of --lang=" + std::string(language.name) + " has that name for something else: " +
             (is_own ? "give its own functions a --prefix" : "call a function of another name that calls this one"));
  }
}

} // namespace symreal
