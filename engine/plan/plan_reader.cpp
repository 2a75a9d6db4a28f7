#include "engine/graph/graph_line.h"
#include "engine/graph/graph_text.h"
#include "engine/plan/lanes/check.h"
#include "engine/plan/plan_text.h"
#include "engine/plan/schedule/angles.h"
#include "engine/plan/schedule/schedule_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>

namespace symreal {

namespace {

using reroll::Access, reroll::Leaf, reroll::LoopFunction, reroll::LoopStep;

// Operations of all iterations that the reader examines: more are refused, as examining them would take minutes.
constexpr std::uint64_t most_examined = 100'000'000;

// The lines of a text, with their numbers.
class Lines {
public:
  Lines(std::string_view text, std::string const &file_name, unsigned number)
      : rest_(text),
        file_name_(file_name),
        number_(number) {}

  bool done() const { return rest_.empty(); }
  unsigned number() const { return number_; }
  std::string_view next_text() {
    std::size_t const end = std::min(rest_.find('\n'), rest_.size());
    std::string_view const line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return line;
  }
  Line next() {
    std::string_view const text = next_text();
    return Line(text, place());
  }
  // Begins with a line of this word?
  bool starts_with(std::string_view word) const {
    return rest_.starts_with(word) &&
           (rest_.size() == word.size() || std::string_view(" \n;").find(rest_[word.size()]) != std::string_view::npos);
  }
  Place place() const { return {file_name_, number_, 0}; }

private:
  std::string_view rest_;
  std::string const &file_name_;
  unsigned number_;
};

std::int32_t signed_number(Line &line, char const *what) {
  double const number = line.number(what);
  if (number != std::trunc(number) || std::abs(number) > std::numeric_limits<std::int32_t>::max())
    line.error(std::string(what) + " is a whole number");
  return static_cast<std::int32_t>(number);
}

constexpr std::array arrays = {Array::input, Array::constants, Array::sine, Array::cosine};

// The enumerator of this name; nullopt if the name is unknown. `names`: those of the enumerators, in order.
template <class Enum> std::optional<Enum> find_name(std::span<std::string_view const> names, std::string_view name) {
  auto const found = std::ranges::find(names, name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
}

// The node of `%4` or of a constant.
class NodeNames {
public:
  explicit NodeNames(Graph const &graph) : graph_(graph) {
    for (NodeId id = 0; id < graph.nodes.size(); ++id)
      if (!graph.nodes[id].is_constant()) nodes_.push_back(id);
  }

  NodeId find(Line &line, std::string const &word) const {
    if (word[0] == '%') {
      std::optional<NodeId> const number = parse_natural(std::string_view(word).substr(1));
      if (!number || *number >= nodes_.size()) line.error("'" + word + "' is not a node of the graph");
      return nodes_[*number];
    }
    auto const number = parse_number(word);
    if (!number) line.error("'" + word + "' is neither a node nor a number");
    auto const found = std::ranges::find(graph_.nodes, Node::constant(*number));
    if (found == graph_.nodes.end()) line.error("the graph has no constant " + word);
    return static_cast<NodeId>(found - graph_.nodes.begin());
  }

private:
  Graph const &graph_;
  std::vector<NodeId> nodes_; // node of each %k
};

// Sizes of the arrays of a function.
struct ArraySizes {
  std::size_t given, read, angles, results, guards;
};

// Follows which elements of memory and which results the steps have stored.
class StepCheck {
public:
  StepCheck(ArraySizes const &sizes, std::size_t memory) : sizes_(sizes), memory_(memory), results_(sizes.results) {}

  // The first thing that is wrong with a step; empty if it is sound.
  std::string find_fault(LoopStep const &step) {
    std::size_t const carried =
        static_cast<std::size_t>(std::ranges::count(step.leaves, Leaf::Kind::carried, &Leaf::kind));
    Graph const &body = step.body;
    if (body.input_count() != step.leaves.size()) return "the body has as many inputs as the step has leaves";
    if (body.output_count() != step.stores.size() + carried)
      return "the results of the body are what the step stores, and then what its leaves carry";
    if (!body.guards.empty() || body.last_effect != no_node || body.parameter_count() != 0)
      return "a body has neither guards nor effects nor parameters";
    for (Node const &node : body.nodes)
      if (is_call(node.op) || is_wide(node.op)) return "loops have neither calls nor integers of 64 bits";
    examined_ += std::uint64_t{step.count} * (body.nodes.size() + step.stores.size() + 1);
    if (step.count == 0 || examined_ > most_examined) return "the steps have no iterations, or too many";
    if (step.nest && !is_nest_of(*step.nest, step.count)) return "the nest has another number of iterations";
    std::size_t result = step.stores.size();
    for (Leaf const &leaf : step.leaves)
      if (leaf.kind == Leaf::Kind::carried && body.results[result++] != leaf.next)
        return "the last results of the body are what its leaves carry";
    for (Leaf const &leaf : step.leaves)
      if (leaf.access.is_listed() && leaf.access.elements.size() != step.count)
        return "an access has an element per iteration";
    for (reroll::Store const &store : step.stores)
      if (store.access.is_listed() && store.access.elements.size() != step.count)
        return "an access has an element per iteration";
    for (std::uint32_t k = 0; k < step.count; ++k)
      if (std::string fault = iteration(step, k); !fault.empty()) return fault;
    return {};
  }

  std::string find_fault_at_end(LoopFunction const &function) {
    for (reroll::Mirror const &mirror : function.mirrors) {
      if (mirror.first + std::uint64_t{mirror.rows} * mirror.rows > results_.size())
        return "the matrix is beyond the results";
      reroll::for_each_copy(mirror, [&](std::uint32_t to, std::uint32_t from) { results_[to] = results_[from]; });
    }
    if (function.checks.size() != sizes_.guards) return "each guard has one 'check'";
    for (std::uint32_t const element : function.checks)
      if (element >= memory_.size() || !memory_[element]) return "a guard is checked that no step has computed";
    return std::ranges::count(results_, 0) == 0 ? "" : "a result is not stored";
  }

private:
  // Turns are not empty, so that products of the numbers stay small.
  static bool is_nest_of(reroll::Nest const &nest, std::uint32_t count) {
    if (nest.turns == 0 || nest.turns > count || nest.inner == 0 || nest.inner > count) return false;
    std::int64_t const last = nest.inner + std::int64_t{nest.growth} * (nest.turns - 1);
    return last > 0 && last <= count && reroll::begin_of(nest, nest.turns) == count;
  }

  std::string iteration(LoopStep const &step, std::uint32_t k) {
    for (Leaf const &leaf : step.leaves) {
      if (leaf.kind == Leaf::Kind::values || (leaf.kind == Leaf::Kind::carried && k != 0)) continue;
      std::size_t const element = leaf.access.at(k);
      if (element >= size_of(leaf.kind)) return fmt::format("iteration {} reads an element beyond its array", k);
      bool const is_memory = leaf.kind == Leaf::Kind::memory || leaf.kind == Leaf::Kind::carried;
      if (is_memory && !memory_[element]) return fmt::format("iteration {} reads memory that no step has stored", k);
    }
    for (reroll::Store const &store : step.stores) {
      std::vector<char> &array = store.is_result ? results_ : memory_;
      std::size_t const element = store.access.at(k);
      if (element >= array.size()) return fmt::format("iteration {} stores an element beyond its array", k);
      array[element] = 1;
    }
    return {};
  }

  std::size_t size_of(Leaf::Kind kind) const {
    switch (kind) {
    case Leaf::Kind::given: return sizes_.given;
    case Leaf::Kind::read: return sizes_.read;
    case Leaf::Kind::sine:
    case Leaf::Kind::cosine: return sizes_.angles;
    default: return memory_.size();
    }
  }

  ArraySizes sizes_;
  std::vector<char> memory_, results_; // whether the element is stored
  std::uint64_t examined_ = 0;
};

class PlanReader {
public:
  explicit PlanReader(std::string const &file_name) : file_name_(file_name) {}

  ReadPlan read(std::string_view text) {
    std::size_t const begin = begin_of_plan(text);
    ReadSchedule schedule = read_schedule(text.substr(0, begin), file_name_);
    graph_ = std::move(schedule.graph);
    plan_.schedule = std::move(schedule.plan);
    keep_shared_lines(text.substr(0, begin));
    Lines lines(text.substr(begin), file_name_, static_cast<unsigned>(std::ranges::count(text.substr(0, begin), '\n')));
    while (!lines.done()) {
      bool const is_body = lines.starts_with("body");
      Line line = lines.next();
      if (line.done()) continue;
      if (is_body)
        read_body(lines);
      else
        read_line(line);
      if (!is_body && !line.done()) line.unexpected();
    }
    Line end("", lines.place());
    finish_function(end);
    if (lanes_) finish_lanes(end);
    return {std::move(graph_), std::move(plan_)};
  }

private:
  // Position of the first line behind the schedule.
  static std::size_t begin_of_plan(std::string_view text) {
    std::size_t begin = text.size();
    for (std::string_view const line : {"\nangles", "\nloops ", "\nlanes "})
      if (std::size_t const at = text.find(line); at != text.npos) begin = std::min(begin, at + 1);
    return begin;
  }

  void keep_shared_lines(std::string_view text) {
    Lines lines(text, file_name_, 0);
    while (!lines.done()) {
      std::string_view const line = lines.next_text();
      if (line.starts_with("location ") || line.starts_with("table ")) shared_ += std::string(line) + '\n';
    }
  }

  void read_line(Line &line) {
    std::string const head = line.word("a line");
    if (head == "angles") {
      if (plan_.loops || lanes_) line.error("'angles' stands before loops and vectors");
      plan_.schedule = with_angles(std::move(plan_.schedule));
      if (plan_.schedule.angles.size() == 0) line.error("the schedule has no sines and cosines to begin with");
    } else if (head == "loops")
      read_loops(line);
    else if (head == "lanes")
      read_lanes(line);
    else if (head == "vector" && lanes_)
      read_vector(line);
    else if (head == "compute" && lanes_)
      read_item(line);
    else if (head == "store" && lanes_)
      read_vector_store(line);
    else if (!function_)
      line.error("'" + head + "' begins no line of a plan here");
    else if (head == "memory")
      function_->memory = line.count("size");
    else if (head == "step")
      read_step(line);
    else if (head == "mirror")
      read_mirror(line);
    else if (head == "check")
      function_->checks.push_back(line.count("element"));
    else if (function_->steps.empty())
      line.error("'" + head + "' follows 'step'");
    else if (head == "nest")
      read_nest(line);
    else if (head == "leaf")
      read_leaf(line);
    else if (head == "store")
      read_store(line);
    else
      line.error("'" + head + "' begins no line of a plan");
  }

  void read_loops(Line &line) {
    finish_function(line);
    if (lanes_) line.error("a plan has loops or vectors");
    if (!plan_.loops) plan_.loops.emplace();
    std::string const name = line.word("the function's name");
    Schedule const &schedule = plan_.schedule;
    std::optional<LoopFunction> *function = nullptr;
    if (name == "preprocess") {
      function = &plan_.loops->preprocess;
      sizes_ = {graph_->parameter_count(), 0, 0, schedule.preprocess.results.size(), 0};
    } else if (name == "angles") {
      function = &plan_.loops->computed_angles;
      sizes_ = {graph_->input_count(), schedule.constant_count, 0, schedule.angles.computed.results.size(), 0};
    } else if (name == "compute") {
      function = &plan_.loops->compute;
      sizes_ = {graph_->input_count(), schedule.constant_count, schedule.angles.size(), graph_->results.size(),
                graph_->guards.size()};
    }
    if (!function || *function) line.error("loops are those of preprocess, angles or compute, once each");
    function_ = &function->emplace();
    function_->operations = line.count("number of operations");
    function_->in_loops = line.count("number of operations");
    function_->loops = line.count("number of loops");
  }

  // The step is whole where another line than its own follows.
  void read_step(Line &line) {
    finish_step(line);
    function_->steps.emplace_back().count = line.count("number of iterations");
    carried_.clear();
    has_body_ = false;
  }

  void read_nest(Line &line) {
    std::uint32_t const turns = line.count("number of turns"), inner = line.count("number of iterations");
    function_->steps.back().nest = {turns, inner, signed_number(line, "growth")};
  }

  static Access read_access(Line &line) {
    Access access;
    if (line.accept("of"))
      while (!line.done() && line.peek() != "next") access.elements.push_back(line.count("element"));
    else
      access = {signed_number(line, "first element"), signed_number(line, "step"), {}};
    return access;
  }

  void read_leaf(Line &line) {
    if (has_body_) line.error("the leaves of a step stand before its body");
    std::string const name = line.word("the kind of leaf");
    auto const kind = find_name<Leaf::Kind>(reroll::leaf_kind_names, name);
    if (!kind) line.error("'" + name + "' is not a kind of leaf");
    Leaf leaf{*kind};
    if (kind == Leaf::Kind::values) {
      if (line.accept("by")) {
        if (!line.accept("turn") || !function_->steps.back().nest) line.error("'by turn' is of a nest");
        leaf.by_turn = true;
      }
      while (!line.done()) leaf.values.push_back(line.number("a value"));
      if (leaf.values.empty()) line.error("a table has a value");
    } else {
      leaf.access = read_access(line);
    }
    if (kind == Leaf::Kind::carried) {
      if (!line.accept("next")) line.error("'next' is missing");
      carried_.emplace_back(function_->steps.back().leaves.size(), line.word("a node"));
    }
    function_->steps.back().leaves.push_back(std::move(leaf));
  }

  void read_body(Lines &lines) {
    Line const begin("", lines.place());
    if (!function_ || function_->steps.empty() || has_body_) begin.error("a step has one body");
    has_body_ = true;
    // Lines keep their numbers in messages: those of the shared ones are in front.
    std::string text = "symreal-graph 1\n" + shared_, padding;
    auto const own = static_cast<std::size_t>(std::ranges::count(text, '\n'));
    if (lines.number() > own) padding.assign(lines.number() - own, '\n');
    text = padding + text;
    for (;;) {
      if (lines.done()) Line("", lines.place()).error("'end' is missing");
      std::string_view const line = lines.next_text();
      if (line == "end") break;
      text.append(line) += '\n';
    }
    LoopStep &step = function_->steps.back();
    step.body = read_graph(text, file_name_);
    NodeNames const names(step.body);
    for (auto const &[leaf, next] : carried_) {
      Line line(next, lines.place());
      step.leaves[leaf].next = names.find(line, line.word("a node"));
    }
  }

  void read_store(Line &line) {
    LoopStep &step = function_->steps.back();
    if (!has_body_ || step.stores.size() >= step.body.results.size()) line.error("the body has no such result");
    bool const is_result = line.accept("output");
    if (!is_result && !line.accept("memory")) line.error("a step stores to 'memory' or to 'output'");
    step.stores.push_back({step.body.results[step.stores.size()], is_result, read_access(line)});
  }

  void read_mirror(Line &line) {
    std::uint32_t const first = line.count("first element"), rows = line.count("number of rows");
    if (!line.accept("from")) line.error("'from' is missing");
    bool const from_above = line.accept("above");
    if (!from_above && !line.accept("below")) line.error("a half is 'above' or 'below'");
    function_->mirrors.push_back({first, rows, from_above});
  }

  void finish_step(Line const &line) {
    if (!function_->steps.empty() && !has_body_) line.error("the step above has no body");
  }

  void finish_function(Line const &line) {
    if (!function_) return;
    finish_step(line);
    StepCheck check(sizes_, function_->memory);
    for (std::size_t k = 0; k < function_->steps.size(); ++k)
      if (std::string const fault = check.find_fault(function_->steps[k]); !fault.empty())
        line.error(fmt::format("step {}: {}", k, fault));
    if (std::string const fault = check.find_fault_at_end(*function_); !fault.empty()) line.error(fault);
    function_ = nullptr;
  }

  void read_lanes(Line &line) {
    if (plan_.loops || lanes_) line.error("a plan has loops, or the vectors of compute once");
    if (plan_.schedule.threads > 1) line.error("threads share out statements, which vectors hold several of");
    if (std::string const why = obstacle_to_lanes(plan_.schedule); !why.empty())
      line.error("compute has no vectors: " + why);
    plan_.lanes.emplace();
    lanes_ = &plan_.lanes->compute.emplace();
    lanes_->width = line.count("number of lanes");
    if (lanes_->width != 2 && lanes_->width != 4 && lanes_->width != 8) line.error("vectors have 2, 4 or 8 lanes");
    lanes_->operations = line.count("number of operations");
    lanes_->in_lanes = line.count("number of operations");
    lanes_->lane.resize(graph_->nodes.size());
    names_.emplace(*graph_);
  }

  void read_vector(Line &line) {
    using Form = lanes::Vector::Form;
    auto const id = static_cast<lanes::VectorId>(lanes_->vectors.size());
    std::string const name = line.word("the form of a vector");
    lanes::Vector vector;
    auto const form = find_name<Form>(lanes::form_names, name);
    std::optional<Op> const op = find_operation(name);
    if (!form && (!op || arity(*op) > 2)) line.error("'" + name + "' is not a form of a vector");
    vector.form = form.value_or(Form::operation);
    if (op) vector.op = *op;
    if (vector.form == Form::load) read_load(line, vector);
    std::size_t operands = 0;
    while (!line.done() && operands < 2 && std::isdigit(static_cast<unsigned char>(line.peek()[0])))
      vector.operand[operands++] = read_vector_use(line, id);
    if (vector.form == Form::operation ? operands != arity(vector.op)
        : vector.form == Form::shuffle ? operands == 0
                                       : operands != 0)
      line.error("the vector has another number of operands");
    if (line.accept("subtracts"))
      for (std::size_t lane = 0; lane < lanes_->width; ++lane) vector.subtracts.push_back(line.count("sign") != 0);
    if (vector.form == Form::shuffle) {
      if (!line.accept("takes")) line.error("'takes' is missing");
      for (std::size_t lane = 0; lane < lanes_->width; ++lane) {
        vector.from.push_back(line.count("lane"));
        if (vector.from.back() >= operands * lanes_->width) line.error("an operand has no such lane");
      }
    }
    if (!line.accept(":")) line.error("':' is missing");
    for (std::uint32_t lane = 0; lane < lanes_->width; ++lane)
      vector.nodes.push_back(read_lane(line, vector, id, lane));
    lanes_->vectors.push_back(std::move(vector));
  }

  void read_load(Line &line, lanes::Vector &vector) {
    std::string const name = line.word("an array");
    auto const array = std::ranges::find(arrays, name, name_of);
    if (array == arrays.end()) line.error("'" + name + "' is not an array");
    vector.array = *array;
    vector.first = line.count("first element");
    if (vector.first + lanes_->width > lanes::ScalarFunction(plan_.schedule, lanes_->width).extent(vector.array))
      line.error("the vector is beyond its array");
  }

  NodeId read_lane(Line &line, lanes::Vector const &vector, lanes::VectorId id, std::uint32_t lane) {
    std::string word = line.word("a node");
    if (word == "-") {
      if (vector.form != lanes::Vector::Form::load) line.error("only elements that a load passes over hold no node");
      return no_node;
    }
    bool const is_elsewhere = word[0] == '~';
    NodeId const node = names_->find(line, is_elsewhere ? word.substr(1) : word);
    if (vector.form != lanes::Vector::Form::operation || is_elsewhere) return node;
    if (lanes_->lane[node].is_given()) line.error("a lane above computes this");
    lanes_->lane[node] = {id, lane};
    return node;
  }

  lanes::VectorId read_vector_use(Line &line, lanes::VectorId before) {
    lanes::VectorId const id = line.count("vector");
    if (id >= before) line.error("no vector above has this number");
    return id;
  }

  void read_item(Line &line) {
    bool const is_vector = line.accept("vector");
    auto const count = static_cast<lanes::VectorId>(lanes_->vectors.size());
    std::uint32_t const id = is_vector ? read_vector_use(line, count) : names_->find(line, line.word("a node"));
    if (!is_vector && (is_leaf(graph_->nodes[id].op) || lanes_->lane[id].is_given()))
      line.error("a scalar operation is one that no lane computes");
    lanes_->order.push_back({is_vector, id});
  }

  void read_vector_store(Line &line) {
    if (!line.accept("vector")) line.error("'vector' is missing");
    lanes::VectorId const id = read_vector_use(line, static_cast<lanes::VectorId>(lanes_->vectors.size()));
    if (!line.accept("at")) line.error("'at' is missing");
    std::size_t const first = line.count("first result");
    if (first + lanes_->width > graph_->results.size()) line.error("the vector is beyond the results");
    lanes_->stores.push_back({id, first});
  }

  void finish_lanes(Line const &line) {
    lanes::ScalarFunction const function(plan_.schedule, lanes_->width);
    if (std::string const difference = lanes::find_difference(function, *lanes_); !difference.empty())
      line.error("the vectors compute something else: " + difference);
  }

  std::string const &file_name_;
  std::unique_ptr<Graph> graph_;
  Plan plan_{};
  std::string shared_; // lines of the graph that the bodies of its loops share
  LoopFunction *function_ = nullptr;
  ArraySizes sizes_{};
  std::vector<std::pair<std::size_t, std::string>> carried_; // leaf of the step, and its node in the body to come
  bool has_body_ = false;
  lanes::LaneFunction *lanes_ = nullptr;
  std::optional<NodeNames> names_;
};

} // namespace

bool is_plan(std::string_view text) { return is_schedule(text); }

ReadPlan read_plan(std::string_view text, std::string const &file_name) { return PlanReader(file_name).read(text); }

} // namespace symreal
