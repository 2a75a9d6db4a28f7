#include "engine/emit/print/externals.h"

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/module.h"
#include "engine/graph/external.h"
#include "engine/graph/graph.h"
#include "engine/support/number.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal {

using Kind = ExternalValue::Kind;

BridgeInteger const *find_integer(BridgeSyntax const &syntax, std::string_view c) {
  for (BridgeInteger const &integer : syntax.integers)
    if (integer.c == c) return &integer;
  return nullptr;
}

namespace {

// Adds the number of doubles in each struct that the function takes or returns.
void add_structures(External const &external, std::set<std::size_t> &counts) {
  auto const add = [&](ExternalValue const &value) {
    if (value.kind == Kind::object) counts.insert(value.count);
  };
  add(external.returned);
  for (ExternalValue const &parameter : external.parameters) add(parameter);
}

std::string of_structures(Filling fill, std::set<std::size_t> const &counts, std::string_view pattern) {
  std::string text;
  for (std::size_t count : counts) text += fill.set("count", count)(pattern);
  return text;
}

std::string structures(Emission const &emission) {
  std::set<std::size_t> counts;
  for (std::size_t number : emission.uses.externals) add_structures(emission.graph().externals[number], counts);
  return of_structures(interface_names(emission), counts, emission.language.externals.bridge.structure);
}

class BridgePrinter {
public:
  BridgePrinter(Emission const &emission, External const &external, std::string const &name)
      : language_(emission.language),
        syntax_(language_.externals.bridge),
        external_(external) {
    fill_ = interface_names(emission);
    fill_.set_name("name", name).set("c_name", external.name);
    fill_.set("argument_count", external.argument_count()).set("result_count", external.result_count());
    std::set<std::size_t> counts;
    add_structures(external, counts);
    fill_.set("structures", of_structures(fill_, counts, syntax_.import_structure));
    ExternalValue const &returned = external.returned;
    fill_.set("count", std::size_t{returned.count});
    if (returned.kind == Kind::integer) fill_.set("type", std::string(integer(returned).type));
    fill_.set("result",
              by_result(syntax_.no_result, syntax_.number_result, syntax_.integer_result, syntax_.object_result));
    result_ = external.returned_count();
    for (std::size_t p = 0; p < external.parameters.size(); ++p) add(p);
    fill_.set("names", fmt::format("{}", fmt::join(names_, ", "))).set("declared", declared_);
    fill_.set("passed", fmt::format("{}", fmt::join(passed_, ", "))).set("copies", copies_);
  }

  std::string declaration() const { return fill_(one_of(syntax_.declaration, syntax_.declaration_without_result)); }

  std::string bridge() {
    std::string made = fill_(one_of(syntax_.made, syntax_.made_without_result));
    if (external_.returned.kind == Kind::integer)
      made = converted(external_.returned, made, &BridgeInteger::from, syntax_.from_integer);
    fill_.set("made", made);
    fill_.set("locals", external_.returned.kind == Kind::object ? fill_(syntax_.object_local) : "");
    fill_.set("stored", by_result(syntax_.no_store, syntax_.number_store, syntax_.number_store, syntax_.object_store));
    return fill_(syntax_.bridge);
  }

private:
  std::string_view one_of(std::string_view pattern, std::string_view without_result) const {
    return external_.returned.kind != Kind::none || without_result.empty() ? pattern : without_result;
  }

  std::string by_result(std::string_view none, std::string_view number, std::string_view integer,
                        std::string_view object) const {
    Kind const kind = external_.returned.kind;
    return fill_(kind == Kind::none ? none : kind == Kind::number ? number : kind == Kind::object ? object : integer);
  }

  BridgeInteger const &integer(ExternalValue const &value) const {
    BridgeInteger const *const found = find_integer(syntax_, value.type);
    internal_check(found != nullptr); // require_expressible has checked it
    return *found;
  }

  std::string converted(ExternalValue const &value, std::string const &text, std::string_view BridgeInteger::*own,
                        std::string_view usual) const {
    BridgeInteger const &type = integer(value);
    return Filling(fill_)
        .set("value", text)
        .set("type", std::string(type.type))((type.*own).empty() ? usual : type.*own);
  }

  void add(std::size_t p) {
    ExternalValue const &parameter = external_.parameters[p];
    bool const is_written = parameter.kind == Kind::output || parameter.kind == Kind::updated;
    std::size_t const at = (is_written ? result_ : argument_) + base(), count = parameter.count;
    Filling fill = fill_;
    names_.push_back(fmt::format("p{}", p));
    fill.set("p", names_.back()).set("count", count);
    fill.set("at", at).set("last", at + count - 1).set("next", at + count);
    if (parameter.kind == Kind::updated) {
      fill.set("from", argument_ + base()).set("from_last", argument_ + count - 1 + base());
      fill.set("from_next", argument_ + count + base());
      copies_ += fill(syntax_.copy);
    }
    Passing const &passing = parameter.kind == Kind::number    ? syntax_.number
                             : parameter.kind == Kind::integer ? syntax_.integer
                             : parameter.kind == Kind::input   ? syntax_.input
                             : parameter.kind == Kind::object  ? syntax_.object
                                                               : syntax_.output;
    if (parameter.kind == Kind::integer) {
      fill.set("type", std::string(integer(parameter).type));
      fill.set("value", converted(parameter, fill(syntax_.number.passed), &BridgeInteger::to, syntax_.to_integer));
    }
    declared_ += fill(passing.declared);
    passed_.push_back(fill(passing.passed));
    if (is_written) result_ += count;
    if (parameter.is_given()) argument_ += count;
  }

  std::size_t base() const { return language_.expressions.first_index; }

  Language const &language_;
  BridgeSyntax const &syntax_;
  External const &external_;
  Filling fill_;
  std::size_t argument_ = 0, result_ = 0;
  std::vector<std::string> names_, passed_;
  std::string declared_, copies_;
};

template <class Print> std::string of_each(Emission const &emission, Print const &print) {
  std::string text;
  for (std::size_t number : emission.uses.externals)
    text += print(BridgePrinter(emission, emission.graph().externals[number], emission.bridges[number]));
  return text;
}

bool has_bridges(Emission const &emission) {
  return emission.language.externals.bridge.is_given() && !emission.uses.externals.empty();
}

// Breaks the lines that are too long.
std::string laid_out(Language const &language, std::string_view text) {
  CodeText lines(language);
  while (!text.empty()) {
    std::size_t const end = std::min(text.find('\n'), text.size()), begin = std::min(text.find_first_not_of(' '), end);
    if (begin == end) lines.lines("\n");
    lines.statement(begin * 2 / language.lines.step, text.substr(begin, end - begin));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines.take_text();
}

} // namespace

std::string print_bridge_declarations(Emission const &emission) {
  if (!has_bridges(emission)) return {};
  BridgeSyntax const &syntax = emission.language.externals.bridge;
  Filling const fill = interface_names(emission);
  auto const declaration = [](BridgePrinter printer) { return printer.declaration(); };
  return indented(emission.language, fill(syntax.begin)) +
         laid_out(emission.language, structures(emission) + of_each(emission, declaration)) +
         indented(emission.language, fill(syntax.end));
}

std::string print_bridges(Emission const &emission) {
  if (!has_bridges(emission)) return {};
  return laid_out(emission.language, of_each(emission, [](BridgePrinter printer) { return printer.bridge(); }));
}

// Statement that calls the bridge of function `number` of the graph.
static std::string bridge_call(Emission const &emission, std::size_t number, ExternalCall const &call) {
  std::size_t const base = emission.language.expressions.first_index, count = call.function.result_count();
  return Filling()
      .set("name", emission.bridges[number])
      .set("arguments", fmt::format("{}", fmt::join(call.arguments, ", ")))
      .set("array", call.array)
      .set("first", call.first + base)
      .set("next", call.first + count + base)(with_words(emission.language, emission.language.externals.bridge.call));
}

CallStatement::CallStatement(FunctionContext &context, std::size_t statement)
    : context_(context),
      statement_(statement),
      call_(context.body.variables[statement]),
      number_(function_of(context.graph(), context.graph().nodes[call_])),
      function_(context.graph().externals[number_]),
      is_wanted_(context.body.wanted_returns.contains(call_)) {}

bool CallStatement::has_array() const {
  if (context_.emission.language.externals.bridge.is_given()) return !is_kept(); // a bridge stores all results
  return !is_kept() && function_.result_count() > (is_wanted_ ? 0 : function_.returned_count());
}

std::vector<std::string> CallStatement::print() const {
  Graph const &graph = context_.graph();
  UsedFeatures &uses = context_.emission.uses;
  uses.externals.insert(number_);
  if (is_kept()) context_.arrays.insert("v");
  std::vector<NodeId> const values = arguments_of(graph, graph.nodes[call_].operand[0]);
  bool const is_folded = !context_.constant_paths.empty() && find_complex_function(function_);
  NodeId const hidden = is_folded ? hidden_argument(graph, context_.constant_paths, values) : no_node;
  Language const &language = context_.emission.language;
  bool const has_bridge = language.externals.bridge.is_given(); // bridges take numbers only
  ExternalCall call{function_, std::to_string(statement_),           {},
                    array(),   is_kept() ? context_.kept[call_] : 0, is_wanted_};
  for (NodeId value : values) {
    bool const is_integer =
        !has_bridge && graph.nodes[value].is_constant() && function_.takes_integer(call.arguments.size());
    std::string const use = is_integer ? shortest(graph.nodes[value].value()) : print_argument(context_, value);
    uses.hidden = uses.hidden || value == hidden;
    call.arguments.push_back(value == hidden ? fill(language, language.expressions.hidden, {{"x", use}}) : use);
  }
  if (has_bridge) return {bridge_call(context_.emission, number_, call)};
  return language.externals.call(call);
}

} // namespace symreal
