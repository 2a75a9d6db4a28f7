#include "engine/plan/text/loop_reader.h"

#include "engine/graph/graph_text.h"
#include "engine/plan/text/loop_check.h"

#include <cmath>
#include <limits>

namespace symreal {

using reroll::Access, reroll::Leaf, reroll::LoopStep;

static std::int32_t signed_number(Line &line, char const *what) {
  double const number = line.number(what);
  if (number != std::trunc(number) || std::abs(number) > std::numeric_limits<std::int32_t>::max())
    line.error(std::string(what) + " is a whole number");
  return static_cast<std::int32_t>(number);
}

LoopReader::LoopReader(Plan const &plan, PlanFunction &function, std::string const &shared,
                       std::string const &file_name, Line &line)
    : plan_(plan),
      function_(function),
      loops_(function.loops.emplace()),
      shared_(shared),
      file_name_(file_name) {
  loops_.operations = line.count("number of operations");
  loops_.in_loops = line.count("number of operations");
  loops_.loops = line.count("number of loops");
}

bool LoopReader::read(std::string const &head, Line &line, Lines &lines) {
  if (head == "memory")
    loops_.memory = line.count("size");
  else if (head == "step")
    read_step(line);
  else if (head == "mirror")
    read_mirror(line);
  else if (head == "check")
    loops_.checks.push_back(line.count("element"));
  else if (loops_.steps.empty())
    line.error("'" + head + "' follows 'step'");
  else if (head == "nest")
    read_nest(line);
  else if (head == "leaf")
    read_leaf(line);
  else if (head == "body")
    read_body(line, lines);
  else if (head == "store")
    read_store(line);
  else
    return false;
  return true;
}

// The step is whole where another line than its own follows.
void LoopReader::read_step(Line &line) {
  require_body(line);
  loops_.steps.emplace_back().count = line.count("number of iterations");
  carried_.clear();
  has_body_ = false;
}

void LoopReader::read_nest(Line &line) {
  std::uint32_t const turns = line.count("number of turns"), inner = line.count("number of iterations");
  loops_.steps.back().nest = {turns, inner, signed_number(line, "growth")};
}

static Access read_access(Line &line) {
  Access access;
  if (line.accept("of"))
    while (!line.done() && line.peek() != "next") access.elements.push_back(line.count("element"));
  else
    access = {signed_number(line, "first element"), signed_number(line, "step"), {}};
  return access;
}

void LoopReader::read_leaf(Line &line) {
  if (has_body_) line.error("the leaves of a step stand before its body");
  std::string const name = line.word("the kind of leaf");
  bool const is_carried = name == "carried";
  std::optional<Array> const array = is_carried ? Array::memory : find_array(name);
  if (!array) line.error("'" + name + "' is not an array");
  Leaf leaf{.array = *array, .is_carried = is_carried};
  if (array == Array::values) {
    if (line.accept("by")) {
      if (!line.accept("turn") || !loops_.steps.back().nest) line.error("'by turn' is of a nest");
      leaf.by_turn = true;
    }
    while (!line.done()) leaf.values.push_back(line.number("a value"));
    if (leaf.values.empty()) line.error("a table has a value");
  } else {
    leaf.access = read_access(line);
  }
  if (is_carried) {
    if (!line.accept("next")) line.error("'next' is missing");
    carried_.emplace_back(loops_.steps.back().leaves.size(), line.word("a node"));
  }
  loops_.steps.back().leaves.push_back(std::move(leaf));
}

void LoopReader::read_body(Line const &line, Lines &lines) {
  if (has_body_) line.error("a step has one body");
  has_body_ = true;
  // Lines keep their numbers in messages: those of the shared ones are in front.
  std::string text = "symreal-graph 1\n" + std::string(shared_), padding;
  auto const own = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  if (lines.number() > own) padding.assign(lines.number() - own, '\n');
  text = padding + text;
  for (;;) {
    if (lines.done()) Line("", lines.place()).error("'end' is missing");
    std::string_view const own_line = lines.next();
    if (own_line == "end") break;
    text.append(own_line) += '\n';
  }
  LoopStep &step = loops_.steps.back();
  step.body = read_graph(text, file_name_);
  NodeNames const names(step.body);
  for (auto const &[leaf, next] : carried_) {
    Line word(next, lines.place());
    step.leaves[leaf].next = names.find(word, word.word("a node"));
  }
}

void LoopReader::read_store(Line &line) {
  LoopStep &step = loops_.steps.back();
  if (!has_body_ || step.stores.size() >= step.body.results.size()) line.error("the body has no such result");
  bool const is_result = line.accept("output");
  if (!is_result && !line.accept("memory")) line.error("a step stores to 'memory' or to 'output'");
  step.stores.push_back({step.body.results[step.stores.size()], is_result, read_access(line)});
}

void LoopReader::read_mirror(Line &line) {
  std::uint32_t const first = line.count("first element"), rows = line.count("number of rows");
  if (!line.accept("from")) line.error("'from' is missing");
  bool const from_above = line.accept("above");
  if (!from_above && !line.accept("below")) line.error("a half is 'above' or 'below'");
  loops_.mirrors.push_back({first, rows, from_above});
}

void LoopReader::require_body(Line const &line) const {
  if (!loops_.steps.empty() && !has_body_) line.error("the step above has no body");
}

void LoopReader::finish(Line const &line) {
  require_body(line);
  if (std::string const fault = find_fault(plan_, function_); !fault.empty()) line.error(fault);
}

} // namespace symreal
