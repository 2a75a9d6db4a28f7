// The statements of one function, chunk by chunk.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/expression.h"
#include "engine/plan/schedule/blocks.h"

#include <functional>
#include <utility>

namespace symreal {

class BodyPrinter {
public:
  // `target`: the array that takes the results.
  BodyPrinter(Emission &emission, FunctionBody const &body, bool is_compute, std::string_view target);

  std::size_t chunk_count() const { return chunks_.size(); }
  std::size_t spill_count() const { return chunks_.spill_count; }
  std::vector<std::size_t> const &parts() const { return chunks_.part; } // per chunk; none: one thread computes all

  // What the outermost function begins with.
  void begin(CodeText &out) const;
  // The chunks in order. Whether one of its statements may return the number of a guard.
  bool statements(std::size_t chunk, CodeText &out, std::size_t indent = 2);
  // The guards of a body of parts, after the last chunk.
  void checks(CodeText &out);
  // Stores the results that no chunk stores: so many groups of them, which stand behind the last chunk.
  std::size_t result_groups() const;
  void results(std::size_t group, CodeText &out);

  // How the inputs are spelled, where they are no elements of `input`, and which compilers may know to be constant.
  void spell_inputs(std::vector<std::string> leaves, std::vector<char> const &constant);
  // Is called before each statement, while statements() prints.
  void set_before(std::function<void(std::size_t, CodeText &)> print) { before_ = std::move(print); }
  // A node, once the statements are printed.
  std::string use(NodeId node) { return print_use(context_, node); }

  // The arrays that the text has named since this was asked.
  ArrayNames const &arrays() const { return context_.arrays; }
  ArrayNames take_arrays() { return std::exchange(context_.arrays, {}); }
  void note_array(std::string_view array) { context_.arrays.insert(array); }
  // The declarations since this was asked, where they stand before the first statement.
  CodeText take_declarations() { return std::exchange(declarations_, CodeText(language_)); }

  // The variables since this was asked.
  std::vector<std::string> take_variables() { return std::exchange(variables_, {}); }

private:
  enum class Type : std::uint8_t { number, truth, wide };
  Type type(std::size_t statement) const;
  TypeSyntax const &type_syntax(std::size_t statement) const;
  bool is_call(std::size_t statement) const;

  void print_step(Step const &step, std::size_t indent, CodeText &out);
  void declare(std::size_t statement, std::size_t indent, CodeText &out);
  void set(std::size_t statement, bool declares, std::size_t indent, CodeText &out);
  void check_value(std::size_t statement, std::size_t indent, CodeText &out) const;
  void print_call(Step const &step, std::size_t indent, CodeText &out);
  void store_result(std::size_t result, std::size_t indent, CodeText &out);
  // What stores a value in an element: `value_` takes it between the two.
  void begin_store(std::string_view array, std::size_t index);
  void end_store(NodeId id, std::size_t indent, CodeText &out);
  void note_variable(std::string const &name);
  Origin origin() const;

  Emission &emission_;
  Language const &language_;
  FunctionBody const &body_;
  bool is_compute_;
  std::string_view target_;
  Chunks chunks_;
  FunctionContext context_;
  PreparedPattern constant_, set_;
  std::string name_, value_, line_; // of the statement that is printed
  CodeText declarations_;
  std::vector<std::string> variables_;
  std::function<void(std::size_t, CodeText &)> before_ = nullptr;
};

} // namespace symreal
