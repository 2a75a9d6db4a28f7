// Printing of the statements of one function, chunk by chunk.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/expression.h"
#include "engine/plan/schedule/blocks.h"

#include <functional>
#include <utility>

namespace symreal {

// Origin of the operations, as far as the options ask for it.
Origin origin_of(Emission const &emission, std::vector<NodeId> const &operations);

class BodyPrinter {
public:
  // `target`: array for the results.
  BodyPrinter(Emission &emission, PlanFunction const &body, std::string_view target);

  std::size_t chunk_count() const { return chunks_.size(); }
  std::size_t spill_count() const { return chunks_.spill_count; }
  std::vector<std::size_t> const &parts() const { return chunks_.part; } // per chunk; empty: one thread computes all

  // Prints the first lines of the outermost function.
  void begin(CodeText &out) const;
  // Prints a chunk; chunks must be printed in order. Returns whether a statement may return the number of a guard.
  bool statements(std::size_t chunk, CodeText &out, std::size_t indent = 2);
  // Prints the guards of a body of parts, after the last chunk.
  void checks(CodeText &out);
  // Number of groups of results that no chunk stores; they follow the last chunk.
  std::size_t result_groups() const;
  void results(std::size_t group, CodeText &out);

  // Spellings of inputs that are not elements of `input`, and whether compilers may find each input constant.
  void spell_inputs(std::vector<std::string> leaves, std::vector<char> const &constant);
  // Sets a callback that statements() calls before each statement.
  void set_before(std::function<void(std::size_t, CodeText &)> print) { before_ = std::move(print); }
  // Spelling of a node after its statement is printed.
  std::string use(NodeId node) { return print_use(context_, node); }

  // Arrays that the text has named since the last call of take_arrays.
  ArrayNames const &arrays() const { return context_.arrays; }
  ArrayNames take_arrays() { return std::exchange(context_.arrays, {}); }
  void note_array(std::string_view array) { context_.arrays.insert(array); }
  // Declarations since the last call, for languages that require them before the first statement.
  CodeText take_declarations() { return std::exchange(declarations_, CodeText(language_)); }

  // Variables since the last call.
  std::vector<std::string> take_variables() { return std::exchange(variables_, {}); }

private:
  ValueKind kind(std::size_t statement) const { return context_.kind(body_.variables[statement]); }
  TypeSyntax const &type_syntax(std::size_t statement) const;
  bool is_call(std::size_t statement) const;

  void print_step(BlockStep const &step, std::size_t indent, CodeText &out);
  void declare(std::size_t statement, std::size_t indent, CodeText &out);
  void set(std::size_t statement, bool declares, std::size_t indent, CodeText &out);
  void check_value(std::size_t statement, std::size_t indent, CodeText &out) const;
  void print_call(BlockStep const &step, std::size_t indent, CodeText &out);
  void store_result(std::size_t result, std::size_t indent, CodeText &out);
  // Begin and end of the store of a value in an element: `value_` takes the value between the two.
  void begin_store(std::string_view array, std::size_t index);
  void end_store(NodeId id, std::size_t indent, CodeText &out);
  void note_variable(std::string const &name);

  Emission &emission_;
  Language const &language_;
  PlanFunction const &body_;
  std::string_view target_;
  Chunks chunks_;
  FunctionContext context_;
  PreparedPattern constant_, set_;
  std::string name_, value_, line_; // of the current statement
  CodeText declarations_;
  std::vector<std::string> variables_;
  std::function<void(std::size_t, CodeText &)> before_ = nullptr;
};

} // namespace symreal
