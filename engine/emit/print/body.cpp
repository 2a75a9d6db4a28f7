#include "engine/emit/print/body.h"

#include "engine/emit/origins/origins.h"
#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/externals.h"
#include "engine/plan/schedule/dependences.h"
#include "engine/support/text.h"

#include <algorithm>

namespace symreal {

Origin origin_of(Emission const &emission, std::vector<NodeId> const &operations) {
  if (!emission.options.origins && !emission.options.trace_comments) return {};
  Origin origin{locations_of(emission.graph(), operations), {}};
  if (emission.options.trace_comments && !origin.locations.empty())
    origin.comment = describe_locations(emission.graph(), origin.locations);
  return origin;
}

static bool is_about_variable(BlockStep const &step) {
  return step.kind == BlockStep::Kind::declare || step.kind == BlockStep::Kind::set ||
         step.kind == BlockStep::Kind::set_const || step.kind == BlockStep::Kind::keep;
}

BodyPrinter::BodyPrinter(Emission &emission, PlanFunction const &body, std::string_view target)
    : emission_(emission),
      language_(emission.language),
      body_(body),
      target_(target),
      chunks_(cut(emission.plan, body, {language_.functions.most_statements, language_.functions.parts_store})),
      context_(emission, body),
      constant_(language_, language_.statements.constant, {"type", "name", "value"}),
      set_(language_, language_.statements.set, {"type", "name", "value"}),
      declarations_(language_) {}

void BodyPrinter::spell_inputs(std::vector<std::string> leaves, std::vector<char> const &constant) {
  context_.leaves = std::move(leaves);
  if (!context_.constant_paths.empty()) context_.constant_paths = constant_on_a_path(emission_.graph(), constant);
}

bool BodyPrinter::is_call(std::size_t statement) const {
  return is_call_node(emission_.plan, body_, body_.variables[statement]);
}

TypeSyntax const &BodyPrinter::type_syntax(std::size_t statement) const {
  static constexpr TypeSyntax Language::*types[] = {
#define VALUE_KIND(kind, syntax) &Language::syntax,
#include "engine/plan/value_kinds.def"
#undef VALUE_KIND
  };
  emission_.uses.truths = emission_.uses.truths || kind(statement) == ValueKind::truth;
  return language_.*types[static_cast<std::size_t>(kind(statement))];
}

void BodyPrinter::begin(CodeText &out) const {
  if (!emission_.options.check_values) return;
  for (std::size_t k = 0; k < body_.variables.size(); ++k)
    if (kind(k) == ValueKind::f64 && !is_call(k)) {
      emission_.uses.value_checks = true;
      return out.statement(2, language_.statements.value_check_begin);
    }
}

bool BodyPrinter::statements(std::size_t chunk, CodeText &out, std::size_t indent) {
  bool checks = false;
  for (std::size_t k = chunks_.begin[chunk]; k < chunks_.begin[chunk + 1]; ++k) {
    NodeId const id = body_.variables[k];
    context_.variable[id] = static_cast<std::uint32_t>(k);
    if (is_call(k)) context_.kept[id] = chunks_.spill_slot[id]; // its results are stored there at once
  }
  for (BlockStep const &step : blocks(emission_.plan, body_, chunks_, chunk)) {
    if (step.kind == BlockStep::Kind::close || step.kind == BlockStep::Kind::otherwise) indent -= 2;
    print_step(step, indent, out);
    if (step.kind == BlockStep::Kind::open || step.kind == BlockStep::Kind::otherwise) indent += 2;
    checks = checks || step.kind == BlockStep::Kind::check;
  }
  if (chunks_.size() == 1) return checks;
  if (chunk == chunks_.stores.first_chunk) context_.copied = chunks_.copy_slot;
  for (std::size_t k = chunks_.begin[chunk]; k < chunks_.begin[chunk + 1]; ++k) {
    NodeId const id = body_.variables[k];
    context_.variable[id] = no_slot; // later chunks read a variable of this chunk from v
    context_.kept[id] = chunks_.spill_slot[id];
  }
  return checks;
}

void BodyPrinter::print_step(BlockStep const &step, std::size_t indent, CodeText &out) {
  if (is_about_variable(step) && is_call(step.index)) return print_call(step, indent, out);
  StatementSyntax const &syntax = language_.statements;
  switch (step.kind) {
  case BlockStep::Kind::declare: return declare(step.index, indent, out);
  case BlockStep::Kind::open:
    return out.statement(indent,
                         fill(language_, syntax.open, {{"condition", print_condition(context_, step.literal)}}));
  case BlockStep::Kind::otherwise: return out.statement(indent, syntax.otherwise);
  case BlockStep::Kind::close: return out.statement(indent, syntax.close);
  case BlockStep::Kind::set: return set(step.index, false, indent, out);
  case BlockStep::Kind::set_const: return set(step.index, true, indent, out);
  case BlockStep::Kind::keep: {
    NodeId const id = body_.variables[step.index];
    begin_store("v", chunks_.spill_slot[id]);
    print_use(context_, id, value_);
    return end_store(id, indent, out);
  }
  case BlockStep::Kind::copy: {
    NodeId const id = chunks_.stores.copied[step.index];
    begin_store("v", chunks_.copy_slot[id]);
    print_expression(context_, id, value_);
    return end_store(id, indent, out);
  }
  case BlockStep::Kind::store: return store_result(step.index, indent, out);
  case BlockStep::Kind::check: {
    std::string const condition = print_condition(context_, {body_.checks[step.index].condition, false});
    return out.statement(
        indent, fill(language_, syntax.check, {{"condition", condition}, {"number", std::to_string(step.index + 1)}}));
  }
  }
}

void BodyPrinter::declare(std::size_t statement, std::size_t indent, CodeText &out) {
  StatementSyntax const &syntax = language_.statements;
  auto const &[type_name, zero] = type_syntax(statement);
  std::string const name = context_.spelling(statement);
  note_variable(name);
  if (!syntax.first_declaration.empty())
    declarations_.statement(2, fill(language_, syntax.first_declaration, {{"type", type_name}, {"name", name}}));
  out.statement(indent, fill(language_, syntax.variable, {{"type", type_name}, {"name", name}, {"value", zero}}));
}

void BodyPrinter::set(std::size_t statement, bool declares, std::size_t indent, CodeText &out) {
  StatementSyntax const &syntax = language_.statements;
  NodeId const id = body_.variables[statement];
  if (before_) before_(statement, out);
  context_.spelled_out.clear();
  name_.clear();
  value_.clear();
  line_.clear();
  if (context_.is_gate(id))
    value_ = print_gate(context_, id);
  else
    print_expression(context_, id, value_);
  context_.spelling.append_to(name_, statement);
  std::string_view const type_name = type_syntax(statement).name;
  if (declares) note_variable(name_);
  if (declares && !syntax.first_declaration.empty())
    declarations_.statement(2, fill(language_, syntax.first_declaration, {{"type", type_name}, {"name", name_}}));
  (declares ? constant_ : set_).append_to(line_, {type_name, name_, value_});
  out.statement(indent, line_, origin_of(emission_, context_.spelled_out));
  if (emission_.options.check_values && kind(statement) == ValueKind::f64) check_value(statement, indent, out);
}

// Debug variant: reports the first NaN or infinity of a call with its source line.
void BodyPrinter::check_value(std::size_t statement, std::size_t indent, CodeText &out) const {
  Graph const &graph = emission_.graph();
  NodeId const id = body_.variables[statement];
  std::string const name = context_.spelling(statement);
  std::string text = name;
  if (!is_leaf(graph.nodes[id].op)) text += " = " + std::string(info(graph.nodes[id].op).name);
  if (std::string const place = describe_locations(graph, locations_of(graph, {id})); !place.empty())
    text += " at " + printable(place);
  for (std::size_t at = 0; (at = text.find("??", at)) != text.npos;) text.insert(++at, " "); // C's trigraphs
  LineLimits const &lines = language_.lines;
  out.lines(std::string(lines.base + indent / 2 * lines.step, ' ') +
            fill(language_, language_.statements.value_check, {{"name", name}, {"text", escaped(text)}}) + "\n");
}

// Prints a call, with an array for its results: a local one, or v, where later chunks read them.
void BodyPrinter::print_call(BlockStep const &step, std::size_t indent, CodeText &out) {
  if (step.kind == BlockStep::Kind::keep) return;
  StatementSyntax const &syntax = language_.statements;
  CallStatement const call(context_, step.index);
  std::string const count = std::to_string(std::max<std::size_t>(call.function().result_count(), 1));
  if (call.has_array() && step.kind != BlockStep::Kind::set) {
    std::string const array = fill(language_, step.kind == BlockStep::Kind::declare ? syntax.zero_array : syntax.array,
                                   {{"name", call.array()}, {"count", count}});
    bool const stands_first = !syntax.first_declaration.empty();
    (stands_first ? declarations_ : out).statement(stands_first ? 2 : indent, array);
    if (stands_first && step.kind == BlockStep::Kind::declare)
      out.statement(indent, fill(language_, syntax.set, {{"name", call.array()}, {"value", language_.number.zero}}));
  }
  if (step.kind == BlockStep::Kind::declare) return;
  context_.spelled_out = {body_.variables[step.index]};
  std::vector<std::string> const lines = call.print();
  for (std::size_t k = 0; k < lines.size(); ++k)
    out.statement(indent, lines[k], k + 1 == lines.size() ? origin_of(emission_, context_.spelled_out) : Origin());
}

void BodyPrinter::begin_store(std::string_view array, std::size_t index) {
  name_.clear();
  value_.clear();
  context_.append_element(name_, array, index);
}

void BodyPrinter::end_store(NodeId id, std::size_t indent, CodeText &out) {
  if (context_.kind(id) != ValueKind::u64) {
    line_.clear();
    set_.append_to(line_, {{}, name_, value_});
    return out.statement(indent, line_);
  }
  emission_.uses.keep_integer = true;
  out.statement(indent, fill(language_, language_.statements.keep_integer, {{"element", name_}, {"value", value_}}));
}

void BodyPrinter::checks(CodeText &out) {
  for (std::size_t k = 0; k < body_.checks.size(); ++k) print_step({BlockStep::Kind::check, k}, 2, out);
}

void BodyPrinter::store_result(std::size_t result, std::size_t indent, CodeText &out) {
  NodeId const id = body_.results[result];
  begin_store(target_, result);
  print_use(context_, id, value_);
  end_store(id, indent, out);
}

std::size_t BodyPrinter::result_groups() const {
  std::size_t const most = language_.functions.most_statements, count = chunks_.stores.behind.size();
  if (chunks_.size() == 1 || !language_.functions.parts_store || count <= most) return 1;
  return (count + most - 1) / most;
}

void BodyPrinter::results(std::size_t group, CodeText &out) {
  std::vector<std::size_t> const &behind = chunks_.stores.behind;
  std::size_t const groups = result_groups();
  for (std::size_t k = behind.size() * group / groups; k < behind.size() * (group + 1) / groups; ++k)
    store_result(behind[k], 2, out);
}

// Keeps the names only for languages that list them.
void BodyPrinter::note_variable(std::string const &name) {
  FunctionSyntax const &syntax = language_.functions;
  if (!syntax.locals.empty() || !syntax.no_locals.empty()) variables_.push_back(name);
}

} // namespace symreal
