#include "engine/plan/schedule/schedule_text.h"

#include "engine/graph/graph.h"
#include "engine/graph/graph_line.h"
#include "engine/graph/graph_text.h"
#include "engine/plan/schedule/dependences.h"
#include "engine/support/number.h"

#include <algorithm>
#include <ostream>
#include <sstream>

namespace symreal {

namespace {

constexpr std::string_view schedule_head = "symreal-plan", functions_begin = "\nfunction ";

class ScheduleWriter {
public:
  ScheduleWriter(std::ostream &out, Schedule const &plan)
      : out_(out),
        plan_(plan),
        number_(line_numbers(*plan.graph)) {}

  void write() {
    std::ostringstream graph;
    write_graph(graph, *plan_.graph);
    std::string const text = graph.str();
    out_ << schedule_head << " 1\n" << text.substr(text.find('\n') + 1);
    write_function("preprocess", plan_.preprocess);
    for (std::size_t slot = 0; slot < plan_.preprocess.results.size(); ++slot)
      out_ << "store " << slot << ' ' << spell(plan_.preprocess, plan_.preprocess.results[slot]) << '\n';
    write_function("compute", plan_.compute);
  }

private:
  void write_function(char const *name, FunctionBody const &body) {
    out_ << "function " << name << '\n';
    for (std::size_t id = 1; id < body.regions.regions.size(); ++id) {
      out_ << "region " << id;
      for (Literal const &literal : body.regions.literals(static_cast<RegionId>(id)))
        out_ << (literal.holds ? " " : " !") << spell(body, literal.condition);
      out_ << '\n';
    }
    for (std::size_t gate = 0; gate < body.regions.gates.size(); ++gate) {
      out_ << "gate " << gate << (body.regions.gates[gate].empty() ? "" : " any");
      for (RegionId alternative : body.regions.gates[gate]) out_ << ' ' << alternative;
      out_ << '\n';
    }
    std::size_t check = 0, part = 0;
    for (std::size_t k = 0; k <= body.variables.size(); ++k) {
      for (; check < body.checks.size() && body.checks[check].before == k; ++check) out_ << "check " << check << '\n';
      for (; part < body.parts.size() && body.parts[part].end == k; ++part)
        out_ << "part " << body.parts[part].stage << " of " << plan_.threads << " threads\n";
      if (k == body.variables.size()) break;
      NodeId const id = body.variables[k];
      out_ << "set " << spell(body, id);
      if (body.region[k] != everywhere) out_ << " in " << body.region[k];
      out_ << (body.wanted_returns.contains(id) ? " returned\n" : "\n");
    }
  }

  std::string spell(FunctionBody const &body, NodeId id) const {
    if (body.regions.is_gate(id)) return "?" + std::to_string(id - body.regions.node_count);
    Node const &node = plan_.graph->nodes[id];
    return node.is_constant() ? shortest(node.value()) : "%" + std::to_string(number_[id]);
  }

  std::ostream &out_;
  Schedule const &plan_;
  std::vector<NodeId> number_;
};

// Position of the first line other than comments and empty lines.
std::size_t head_of(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && (text[at] == ';' || text[at] == '\n'))
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}

class ScheduleReader {
public:
  ReadSchedule read(std::string_view text, std::string const &file_name) {
    std::size_t const begin = std::min(text.find(functions_begin), text.size());
    std::string graph(text.substr(0, begin)); // its head has the same version
    graph.replace(head_of(graph), schedule_head.size(), "symreal-graph");
    graph_ = std::make_unique<Graph>(read_graph(graph, file_name));
    for (std::size_t id = 0; id < graph_->nodes.size(); ++id)
      if (!graph_->nodes[id].is_constant()) nodes_.push_back(static_cast<NodeId>(id));
    for (FunctionBody *body : {&plan_.preprocess, &plan_.compute})
      body->regions.node_count = static_cast<NodeId>(graph_->nodes.size());
    auto number = static_cast<unsigned>(std::ranges::count(text.substr(0, begin), '\n')) + 1;
    std::string_view rest = text.substr(std::min(begin + 1, text.size()));
    while (!rest.empty()) {
      std::size_t const end = std::min(rest.find('\n'), rest.size());
      Line line(rest.substr(0, end), {file_name, ++number, 0});
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (line.done()) continue;
      read_line(line);
      if (!line.done()) line.unexpected();
    }
    Line end("", {file_name, number, 0});
    if (body_ != &plan_.compute) end.error("a plan has the functions preprocess and compute, in this order");
    if (!plan_.compute.parts.empty() && plan_.compute.parts.back().end != plan_.compute.variables.size())
      end.error("the last statements are in no part");
    if (plan_.compute.checks.size() != graph_->guards.size()) end.error("the graph has guards that are not checked");
    require_results(end);
    finish();
    return {std::move(graph_), std::move(plan_)};
  }

private:
  void read_line(Line &line) {
    std::string const head = line.word("a line");
    if (head == "function")
      read_function(line);
    else if (!body_)
      line.error("the lines of a function follow 'function'");
    else if (head == "region")
      read_region(line);
    else if (head == "gate")
      read_gate(line);
    else if (head == "set")
      read_set(line);
    else if (head == "check")
      read_check(line);
    else if (head == "part")
      read_part(line);
    else if (head == "store")
      read_store(line);
    else
      line.error("'" + head + "' begins no line of a plan");
  }

  void read_function(Line &line) {
    std::string const name = line.word("the function's name");
    FunctionBody *const next = body_ ? &plan_.compute : &plan_.preprocess;
    if (name != (body_ ? "compute" : "preprocess") || body_ == next)
      line.error("a plan has the functions preprocess and compute, in this order");
    if (body_) plan_.constant_slot = constant_slots(*graph_, plan_.preprocess.results);
    body_ = next;
    is_set_.assign(graph_->nodes.size(), 0);
    is_nested_.assign(graph_->nodes.size(), 0);
    gates_.clear();
  }

  void read_region(Line &line) {
    if (line.count("region") != body_->regions.regions.size()) line.error("regions must follow each other from 1 on");
    std::vector<Literal> literals;
    while (!line.done()) {
      std::string word = line.word("a condition");
      bool const holds = word[0] != '!';
      literals.push_back({value(line, holds ? word : word.substr(1)), holds});
      NodeId const condition = literals.back().condition;
      if (!body_->regions.is_gate(condition)) require_number(line, condition);
    }
    body_->regions.regions.push_back(std::move(literals));
  }

  void read_gate(Line &line) {
    if (line.count("gate") != body_->regions.gates.size()) line.error("gates must follow each other from 0 on");
    std::vector<RegionId> alternatives;
    if (line.accept("any"))
      while (!line.done()) alternatives.push_back(read_region_use(line));
    body_->regions.gates.push_back(std::move(alternatives));
  }

  void read_set(Line &line) {
    NodeId const id = value(line, line.word("a node"));
    bool const is_gate = body_->regions.is_gate(id);
    if (is_gate) gates_.resize(body_->regions.gates.size());
    char &is_set = is_gate ? gates_[id - body_->regions.node_count] : is_set_[id];
    if (is_set) line.error("this is set already");
    if (!is_gate) require_statement(line, id);
    RegionId const region = line.accept("in") ? read_region_use(line) : everywhere;
    for (Literal const &literal : body_->regions.literals(region)) require_set(line, literal.condition);
    for_each_operand(plan_of_body(), *body_, body_ == &plan_.compute, id, [&](NodeId use) { require_set(line, use); });
    if (line.accept("returned")) {
      if (!is_call_node(plan_of_body(), *body_, id) || returned_count(id) == 0)
        line.error("only a call returns something");
      body_->wanted_returns.insert(id);
    }
    is_set = 1;
    body_->variables.push_back(id);
    body_->region.push_back(region);
  }

  void read_check(Line &line) {
    if (body_ != &plan_.compute) line.error("compute checks the guards");
    std::size_t const guard = line.count("guard");
    if (guard != body_->checks.size() || guard >= graph_->guards.size())
      line.error("the guards of the graph must follow each other from 0 on");
    NodeId const condition = graph_->guards[guard].condition;
    require_set(line, condition);
    body_->checks.push_back({condition, body_->variables.size()});
  }

  void read_part(Line &line) {
    std::vector<ThreadPart> &parts = body_->parts;
    if (body_ != &plan_.compute) line.error("threads share compute");
    std::size_t const stage = line.count("stage"), begin = parts.empty() ? 0 : parts.back().end;
    std::size_t const next = parts.empty() ? 0 : parts.back().stage + std::size_t{1};
    if (stage != next && stage + 1 != next) line.error("stages must follow each other from 0 on");
    if (body_->variables.size() == begin) line.error("a part has a statement");
    if (!line.accept("of")) line.error("'of' is missing");
    unsigned const threads = line.count("number of threads");
    if (threads < 2 || threads > most_threads) line.error("2 threads at least share an evaluation, and 64 at most");
    if (!parts.empty() && threads != plan_.threads) line.error("all parts are for as many threads");
    if (!line.accept("threads")) line.error("'threads' is missing");
    plan_.threads = threads;
    parts.push_back({static_cast<std::uint32_t>(stage), body_->variables.size()});
    if (!waits_for_other_parts(plan_of_body(), *body_, parts.size() - 1)) return;
    line.error("the part needs what another part of its stage computes");
  }

  void read_store(Line &line) {
    if (body_ != &plan_.preprocess) line.error("preprocess stores what compute reads");
    if (line.count("slot") != body_->results.size()) line.error("slots must follow each other from 0 on");
    NodeId const id = value(line, line.word("a node"));
    if (body_->regions.is_gate(id)) line.error("a gate is not a number");
    if (graph_->nodes[id].is_constant()) line.error("a constant needs no slot");
    if (!is_wide(graph_->nodes[id].op)) require_number(line, id);
    require_set(line, id);
    body_->results.push_back(id);
  }

  std::size_t returned_count(NodeId call) const {
    return graph_->externals[function_of(*graph_, graph_->nodes[call])].returned_count();
  }

  void require_number(Line const &line, NodeId id) const {
    Op const op = graph_->nodes[id].op;
    if (!is_leaf(op) && info(op).has(flag::STRUCTURE | flag::WIDE)) line.error("this is not a number");
  }

  // Checks that the node may follow `set`.
  void require_statement(Line const &line, NodeId id) {
    if (graph_->nodes[id].op == Op::argument) line.error("a list of arguments is part of its call");
    if (is_nested_[id]) line.error("a statement above has computed this for itself: set it before that");
    require_visible(line, id);
  }

  void require_visible(Line const &line, NodeId id) {
    Node const &node = graph_->nodes[id];
    if (body_ == &plan_.preprocess && node.attribute == Attribute::variable)
      line.error("preprocess sees no inputs, which this depends on");
    if (body_ == &plan_.compute && node.op == Op::parameter && !plan_of_body().element(id))
      line.error("compute sees no parameters, but what preprocess stores");
  }

  RegionId read_region_use(Line &line) {
    RegionId const region = line.count("region");
    if (region >= body_->regions.regions.size()) line.error("no region above has this number");
    return region;
  }

  // Parses %4, ?0, or a constant of the graph.
  NodeId value(Line &line, std::string const &word) {
    if (word[0] == '%' || word[0] == '?') {
      bool const is_gate = word[0] == '?'; // possibly a gate set later
      std::optional<NodeId> const number = parse_natural(std::string_view(word).substr(1));
      std::size_t const count = is_gate ? no_node - body_->regions.node_count : nodes_.size();
      if (!number || *number >= count) line.error("'" + word + "' is not a node of the graph");
      return is_gate ? body_->regions.node_count + *number : nodes_[*number];
    }
    auto const number = parse_number(word);
    if (!number) line.error("'" + word + "' is neither a node nor a number");
    Node const constant = Node::constant(*number);
    auto const found = std::ranges::find(graph_->nodes, constant);
    if (found == graph_->nodes.end()) line.error("the graph has no constant " + word);
    return static_cast<NodeId>(found - graph_->nodes.begin());
  }

  // Checks that all variables of a use are set above, and all calls: a call cannot be nested.
  void require_set(Line &line, NodeId use) {
    Schedule const &plan = plan_of_body();
    bool const in_compute = body_ == &plan_.compute;
    auto const is_above = [&](NodeId id) {
      if (!body_->regions.is_gate(id)) return is_set_[id] != 0;
      std::size_t const gate = id - body_->regions.node_count;
      if (gate >= gates_.size() || !gates_[gate]) line.error("gate " + std::to_string(gate) + " is not set above");
      return true;
    };
    for_each_read(
        *graph_, use, is_above,
        [&](NodeId id) {
          require_visible(line, id);
          Node const &node = graph_->nodes[id];
          if (is_call(node.op)) line.error("a call that this needs is not set above");
          is_nested_[id] = !node.is_constant();
          if (is_read(plan, in_compute, id)) return true;
          if (node.op == Op::returned && is_set_[node.operand[0]]) require_returned(line, node);
          return false;
        },
        [](NodeId) {});
  }

  // Checks that a call set above keeps this result.
  void require_returned(Line const &line, Node const &node) const {
    NodeId const call = node.operand[0];
    if (result_of(*graph_, node) < returned_count(call) && !body_->wanted_returns.contains(call))
      line.error("the call that this needs does not say 'returned'");
  }

  // Checks the outputs, which are stored at the end, after all reads of inputs.
  void require_results(Line &line) {
    Schedule const &plan = plan_of_body();
    for (std::size_t slot = 0; slot < graph_->results.size(); ++slot) {
      NodeId const id = graph_->results[slot];
      Node const &node = graph_->nodes[id];
      if (!is_set_[id] && !node.is_constant() && node.op != Op::returned && !plan.element(id))
        line.error("result " + std::to_string(slot) + " is not set");
      require_set(line, id);
    }
    if (graph_->last_effect != no_node && !is_set_[graph_->last_effect]) line.error("the last effect is not set");
  }

  // The schedule, with the graph and slots that the statement order requires.
  Schedule const &plan_of_body() {
    plan_.graph = graph_.get();
    if (plan_.constant_slot.empty()) plan_.constant_slot.assign(graph_->nodes.size(), no_slot);
    return plan_;
  }

  void finish() {
    plan_of_body();
    plan_.constant_count = plan_.preprocess.results.size();
    plan_.compute.results = graph_->results;
  }

  std::unique_ptr<Graph> graph_;
  Schedule plan_{};
  FunctionBody *body_ = nullptr;
  std::vector<NodeId> nodes_;        // node of each %k
  std::vector<char> is_set_, gates_; // by a statement above, in this function
  std::vector<char> is_nested_;      // in a statement above
};

} // namespace

void write_schedule(std::ostream &out, Schedule const &plan) { ScheduleWriter(out, plan).write(); }

bool is_schedule(std::string_view text) { return text.substr(head_of(text)).starts_with(schedule_head); }

ReadSchedule read_schedule(std::string_view text, std::string const &file_name) {
  return ScheduleReader().read(text, file_name);
}

} // namespace symreal
