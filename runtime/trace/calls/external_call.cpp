// Calls of functions that are not recorded: run with the carried values, and kept as nodes. Functions of complex
// numbers are pure external functions that are always at hand; so is the implicit function of a pragma.
#include "runtime/trace/calls/external_call.h"

#include "engine/graph/graph_line.h"
#include "engine/graph/implicit.h"
#include "runtime/trace/decisions/decisions.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <symreal/complex.h>
#include <symreal/external.h>

#include <array>
#include <cmath>
#include <memory>
#include <span>

namespace symreal {

namespace trace {

namespace {

// Nodes of a call: its arguments as a list, its function, and what it is ordered after, unless the function is pure.
RealNumber record_external_call(External const &external, std::span<RealNumber const> arguments, void const *caller) {
  Pool &pool = session().pool;
  NodeTable const &nodes = pool.nodes();
  NodeId list = pool.node(0.0);
  for (RealNumber const number : arguments) {
    NodeId const value = pool.node(number); // before the table is asked: a constant may be new
    list = pool.node(pool.leaf(nodes.operation(Op::argument, list, value), 0, caller));
  }
  NodeId const function = pool.node(static_cast<double>(session().externals.number(external)));
  if (external.pure) return pool.leaf(nodes.operation(Op::call, list, function), 0, caller);
  NodeId const before = pool.node(session().externals.last_effect());
  RealNumber const call = pool.leaf(nodes.operation(Op::call_in_order, list, function, before), 0, caller);
  session().externals.set_last_effect(call);
  return call;
}

RealNumber record_result(RealNumber call, std::size_t number, double value, void const *caller) {
  Pool &pool = session().pool;
  NodeId const which = pool.node(static_cast<double>(number));
  return pool.leaf(pool.nodes().operation(Op::returned, pool.node(call), which), value, caller);
}

} // namespace

void Implicit::begin(std::string const &label, Place const &place) {
  parts_.push_back({label, place, {}, {}});
  is_open_ = true;
}

void Implicit::element(RealNumber *number) {
  parts_.back().places.push_back(number);
  parts_.back().numbers.push_back(*number);
}

void Implicit::end() {
  is_open_ = false;
  if (parts_.size() == 2) {
    relate(parts_[0], parts_[1]);
    parts_.clear();
  }
}

void Implicit::relate(Part const &unknown, Part const &residual) const {
  auto const refuse = [](Part const &part, std::string const &why) {
    report({DiagnosticId::pragma_item, part.place, "implicit(x, r): '" + part.label + "' " + why});
    give_up();
  };
  std::size_t const count = unknown.numbers.size();
  if (residual.numbers.size() != count)
    refuse(residual, "has " + std::to_string(residual.numbers.size()) + " numbers, and '" + unknown.label + "' has " +
                         std::to_string(count));
  Pool &pool = session().pool;
  for (RealNumber const number : unknown.numbers) {
    if (!number.is_node()) refuse(unknown, "depends on no input: nothing was solved");
    if (is_leaf(pool.nodes()[pool.node(number)].op)) refuse(unknown, "is an input or a parameter: nothing was solved");
  }
  for (RealNumber const number : residual.numbers)
    if (!number.is_node()) refuse(residual, "does not depend on '" + unknown.label + "'");
  void const *const caller = __builtin_return_address(0);
  std::vector<RealNumber> arguments = unknown.numbers;
  arguments.insert(arguments.end(), residual.numbers.begin(), residual.numbers.end());
  RealNumber const call = record_external_call(implicit_function(static_cast<std::uint32_t>(count)), arguments, caller);
  for (std::size_t k = 0; k < count; ++k)
    *unknown.places[k] = record_result(call, k, pool.carried_value(unknown.numbers[k]), caller);
}

} // namespace trace

namespace detail {

using trace::ExternalShapes;
using trace::Pool;
using trace::session;
using Kind = ExternalValue::Kind;

void const *here() noexcept { return __builtin_return_address(0); }

namespace {

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  while (!text.empty()) {
    std::size_t const end = std::min(text.find(' '), text.size());
    if (end != 0) result.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

ExternalShapes::Shape const &shape_of(ExternalDescription const &description) {
  ExternalShapes::Key const key(description.name, description.shape, description.pure);
  auto [found, is_new] = session().external_shapes.known.try_emplace(key);
  if (!is_new) return found->second;
  std::string const head = std::string("0 \"") + description.name + "\"" + (description.pure ? " pure " : " ");
  Line line(head + description.shape, {description.file, description.line, description.column});
  std::vector<External> externals;
  read_external(line, externals);
  externals[0].place = {description.file, description.line, description.column};
  return found->second = {std::move(externals[0]), words(description.sizes)};
}

// A product of numbers and of the values of integer parameters, $0, $1, ...
std::uint32_t evaluate_size(std::string const &text, std::vector<double> const &integers) {
  double product = 1;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t const end = std::min(text.find('*', at), text.size());
    std::string const factor = text.substr(at, end - at);
    product *= factor[0] == '$' ? integers.at(std::stoul(factor.substr(1))) : std::stod(factor);
    at = end + 1;
  }
  return product >= 1 && product < 1e9 ? static_cast<std::uint32_t>(product) : 0;
}

} // namespace

struct ExternalCall::State {
  External external;
  std::vector<std::string> const *sizes;
  void const *caller;
  std::size_t parameter = 0;    // the next
  std::vector<double> integers; // per parameter; 0 if not an integer
  std::vector<RealNumber> arguments;
  bool is_symbolic = false;
  struct Copy {
    RealNumber *original;
    std::unique_ptr<double[]> numbers;
    std::uint32_t count;
    bool is_written;
  };
  std::vector<Copy> copies;
  std::size_t result = 0; // the next
  RealNumber call;

  [[noreturn]] void refuse(std::string const &why) {
    trace::report_here(DiagnosticId::external_call, "in the call of '" + external.name + "' " + why);
    trace::give_up();
  }

  double argument(RealNumber number) {
    arguments.push_back(number);
    is_symbolic |= number.is_node();
    return number.is_node() ? needed_value(number) : number.plain();
  }

  // After the last argument: the node of the call, if one is needed.
  void record() {
    Pool &pool = session().pool;
    ++executed[static_cast<unsigned>(external.pure ? Op::call : Op::call_in_order)];
    if (!pool.is_recording() || (external.pure && !is_symbolic)) return;
    if (!external.pure && session().conditions.path.is_node()) {
      trace::report_here(DiagnosticId::external_under_condition,
                         "'" + external.name + "' may have effects and is called in an arm of a decision");
      trace::give_up();
    }
    call = trace::record_external_call(external, arguments, caller);
  }

  RealNumber next_result(double value) {
    std::size_t const number = result++;
    if (!call.is_node()) return value;
    return trace::record_result(call, number, value, caller);
  }

  void take_written() {
    for (Copy const &copy : copies)
      for (std::uint32_t k = 0; copy.is_written && k < copy.count; ++k) copy.original[k] = next_result(copy.numbers[k]);
  }
};

ExternalCall::ExternalCall(ExternalDescription const &description, void const *caller) noexcept
    : state_(new State) { // NOLINT(bugprone-unhandled-exception-at-new): without memory the program ends
  ExternalShapes::Shape const &shape = shape_of(description);
  state_->external = shape.external;
  state_->sizes = &shape.sizes;
  state_->caller = caller;
  state_->call = 0.0;
}

ExternalCall::~ExternalCall() { delete state_; }

void ExternalCall::note(double integer) noexcept { state_->integers.push_back(integer); }

double ExternalCall::number(RealNumber argument) noexcept {
  ++state_->parameter;
  return state_->argument(argument);
}

void ExternalCall::integer(double argument) noexcept {
  ++state_->parameter;
  state_->arguments.emplace_back(argument);
}

void *ExternalCall::pointer(void *numbers) noexcept {
  State &state = *state_;
  ExternalValue &parameter = state.external.parameters[state.parameter];
  if (!state.sizes->empty() && (*state.sizes)[state.parameter] != "0")
    parameter.count = evaluate_size((*state.sizes)[state.parameter], state.integers);
  ++state.parameter;
  if (!numbers) state.refuse("parameter " + std::to_string(state.parameter) + " is a null pointer");
  if (parameter.count == 0) state.refuse("parameter " + std::to_string(state.parameter) + " has no elements");
  auto *original = static_cast<RealNumber *>(numbers);
  bool const is_read = parameter.kind != Kind::output;
  State::Copy &copy = state.copies.emplace_back(State::Copy{original, std::make_unique<double[]>(parameter.count),
                                                            parameter.count, parameter.kind != Kind::input});
  for (std::uint32_t k = 0; is_read && k < parameter.count; ++k) copy.numbers[k] = state.argument(original[k]);
  return copy.numbers.get();
}

void ExternalCall::object(void *numbers, std::size_t count) noexcept {
  ++state_->parameter;
  auto *number = static_cast<RealNumber *>(numbers);
  for (std::size_t k = 0; k < count; ++k) number[k] = state_->argument(number[k]);
}

RealNumber ExternalCall::returned(double value) noexcept {
  state_->record();
  RealNumber const result = state_->next_result(value);
  state_->take_written();
  return result;
}

void ExternalCall::returned(void *numbers, std::size_t count) noexcept {
  state_->record();
  auto *number = static_cast<RealNumber *>(numbers);
  for (std::size_t k = 0; k < count; ++k) number[k] = state_->next_result(number[k].plain());
  state_->take_written();
}

void ExternalCall::returned() noexcept {
  state_->record();
  state_->take_written();
}

bool products_are_formulas() noexcept { return trace::floating_point() != FloatingPoint::strict; }

ComplexParts compute_parts(ComplexFunction function, ComplexParts x, ComplexParts y) noexcept {
  std::array<RealNumber, 4> const all = {x.real, x.imaginary, y.real, y.imaginary};
  std::span const operands(all.data(), std::size_t{2} * info(function).arity);
  ++executed[static_cast<unsigned>(Op::call)];
  Pool &pool = session().pool;
  std::array<double, 4> arguments{};
  bool is_symbolic = false, is_missing = false;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    is_symbolic |= operands[k].is_node();
    arguments[k] = pool.carried_value(operands[k]);
    is_missing |= trace::is_missing(arguments[k]);
  }
  std::array<double, 2> results{missing_value(), missing_value()};
  if (!is_missing) evaluate(function, std::span(arguments.data(), operands.size()), results);
  if (!is_symbolic) return {results[0], results[1]};

  void const *const caller = __builtin_return_address(0);
  RealNumber const call = trace::record_external_call(external_of(function), operands, caller);
  RealNumber const real = trace::record_result(call, 0, results[0], caller);
  return {real, trace::record_result(call, 1, results[1], caller)};
}

} // namespace detail
} // namespace symreal
