#include "engine/graph/graph_line.h"
#include "engine/graph/graph_text.h"
#include "engine/graph/implicit.h"
#include "engine/graph/node_table.h"
#include "engine/graph/validate.h"
#include "engine/support/number.h"

#include <algorithm>
#include <map>
#include <set>

namespace symreal {

namespace {

ExternalValue read_value(Line &line) {
  std::string const &word = line.word("a parameter");
  auto const known = std::ranges::find(kind_names, word);
  if (known == kind_names.end()) line.error("'" + word + "' is not a kind of parameter");
  ExternalValue value{static_cast<ExternalValue::Kind>(known - kind_names.begin()), 1, {}};
  if (value.kind == ExternalValue::Kind::integer)
    value.type = line.string("the type of the integer");
  else if (value.kind != ExternalValue::Kind::number)
    value.count = line.count("number of doubles");
  return value;
}

void read_table(Line &line, std::vector<Table> &tables) {
  if (line.count("table") != tables.size()) line.error("tables must follow each other from 0 on");
  Table table{line.string("the table's name"), line.extents(), {}, line.optional_place()};
  if (table.extents.empty() || table.extents.size() > 2) line.error("a table has one or two extents");
  std::size_t count = 1;
  for (std::size_t extent : table.extents) count *= extent;
  if (count == 0) line.error("a table has at least one element");
  if (!line.accept("=")) line.error("'=' is missing");
  for (std::size_t k = 0; k < count; ++k) table.values.push_back(line.number("a value"));
  tables.push_back(std::move(table));
}

class Reader {
public:
  Graph read(std::string_view text, std::string const &file_name) {
    unsigned number = 0;
    while (!text.empty()) {
      std::size_t end = std::min(text.find('\n'), text.size());
      Line line(text.substr(0, end), {file_name, ++number, 0});
      number_ = number;
      text.remove_prefix(std::min(end + 1, text.size()));
      if (line.done()) continue;
      read_line(line);
      if (!line.done()) line.unexpected();
    }
    Line end("", {file_name, number, 0});
    if (!headed_) end.error("the file is not a graph: its first line must be 'symreal-graph 1'");
    graph_.nodes = table_.release();
    if (located_) {
      locations_.resize(graph_.nodes.size(), no_location);
      graph_.node_location = std::move(locations_);
    }
    if (named_nodes_) {
      names_.resize(graph_.nodes.size(), no_name);
      graph_.node_name = std::move(names_);
    }
    if (!graph_.node_exact.empty()) graph_.node_exact.resize(graph_.nodes.size(), 0);
    NodeId node = no_node;
    if (std::string const violation = find_violation(graph_, &node); !violation.empty()) {
      auto const named = std::ranges::find(named_, node);
      if (named == named_.end()) end.error(violation);
      std::size_t const k = static_cast<std::size_t>(named - named_.begin());
      Line("", {file_name, line_of_[k], 0})
          .error("node %" + std::to_string(k) + violation.substr(violation.find(' ', 5)));
    }
    check_states(file_name);
    return std::move(graph_);
  }

private:
  static constexpr std::size_t most_slots = std::size_t{1} << 28; // the capacity of a recording

  void read_line(Line &line) {
    std::string head = line.word("a line");
    if (!headed_) {
      if (head != "symreal-graph" || line.count("version") != 1) line.error("the first line must be 'symreal-graph 1'");
      headed_ = true;
    } else if (head == "kernel")
      once(line, head), graph_.kernel = line.string("the kernel's name");
    else if (head == "decisions")
      once(line, head), read_decisions(line);
    else if (head == "from" && line.word("a kind of recording") == "instructions")
      graph_.from_instructions = true;
    else if (head == "input")
      read_object(line, graph_.inputs, &graph_.input_values);
    else if (head == "parameter")
      read_object(line, graph_.parameters, &graph_.parameter_values);
    else if (head == "output")
      read_object(line, graph_.outputs, nullptr);
    else if (head == "state")
      read_state(line);
    else if (head == "differentiate")
      read_wish(line);
    else if (head == "derivative")
      graph_.derivatives.push_back(line.string("what was differentiated"));
    else if (head == "matrix")
      read_matrix(line);
    else if (head == "frozen")
      read_frozen(line);
    else if (head == "executed")
      read_executed(line);
    else if (head == "result")
      read_root(line, graph_.results);
    else if (head == "precomputed")
      read_root(line, graph_.precomputed);
    else if (head == "guard")
      read_guard(line);
    else if (head == "table")
      read_table(line, graph_.tables);
    else if (head == "external")
      read_external(line, graph_.externals);
    else if (head == "effect")
      once(line, head), graph_.last_effect = read_operand(line);
    else if (head == "location")
      read_location(line);
    else if (head[0] == '%')
      read_node(line, head);
    else
      line.error("'" + head + "' does not begin a line of a graph");
  }

  void check_states(std::string const &file_name) {
    std::vector<StatePair> const states = graph_.states;
    for (std::size_t k = 0; k < states.size(); ++k) graph_.states[k].place = {file_name, state_lines_[k], 0};
    (void)find_states(graph_);
    graph_.states = states;
  }

  void once(Line const &line, std::string const &head) {
    if (!once_.insert(head).second) line.error("a graph has one line '" + head + "'");
  }

  void read_decisions(Line &line) {
    static constexpr std::array<std::string_view, 5> policies = {"error", "guard", "select", "explore", "auto"};
    graph_.decisions = line.word("a policy");
    if (std::ranges::find(policies, graph_.decisions) == policies.end())
      line.error("'" + graph_.decisions + "' is not a policy of decisions");
  }

  static void read_object(Line &line, std::vector<Object> &objects, std::vector<double> *values) {
    Object object;
    object.label = line.string("the label");
    object.extents = line.extents();
    object.members = read_members(line);
    std::size_t const count = number_count(object.extents, object.members);
    std::size_t const before = objects.empty() ? 0 : objects.back().first + objects.back().count;
    if (count > most_slots - before)
      line.error("the objects have more than " + std::to_string(most_slots) + " numbers");
    object.place = line.optional_place();
    if (line.accept("range")) {
      double low = line.number("lower end of the range");
      object.range = {low, line.number("upper end of the range")};
      if (!is_range(*object.range)) line.error("the range holds no number");
    }
    object.count = static_cast<std::uint32_t>(count);
    object.first = static_cast<std::uint32_t>(before);
    objects.push_back(object);
    if (!values) return;
    bool given = line.accept("=");
    for (std::size_t k = 0; k < count; ++k) values->push_back(given ? line.number("a value") : 0);
  }

  // Parses: { "name" [n] { ... } ... }, or nothing.
  static std::vector<Member> read_members(Line &line) {
    std::vector<Member> members;
    if (!line.accept("{")) return members;
    while (!line.accept("}")) {
      Member member{line.string("the name of a member")};
      member.extents = line.extents();
      member.members = read_members(line);
      members.push_back(std::move(member));
    }
    if (members.empty()) line.error("a structure without members");
    return members;
  }

  void read_wish(Line &line) {
    DerivativeWish wish{line.string("what to differentiate"), {}};
    wish.place = line.optional_place();
    graph_.wishes.push_back(std::move(wish));
  }

  void read_matrix(Line &line) {
    DerivativeMatrix matrix{line.count("the output")};
    std::vector<std::size_t> const extents = line.extents();
    if (extents.size() != 2) line.error("a matrix has two extents");
    matrix.rows = static_cast<std::uint32_t>(extents[0]), matrix.columns = static_cast<std::uint32_t>(extents[1]);
    matrix.is_packed = line.accept("packed");
    matrix.is_symmetric = line.accept("symmetric");
    if (!line.accept("=")) line.error("'=' is missing");
    while (!line.done()) {
      matrix.row.push_back(line.count("a row"));
      matrix.column.push_back(line.count("a column"));
    }
    graph_.matrices.push_back(std::move(matrix));
  }

  void read_state(Line &line) {
    StatePair pair{line.string("the state"), line.string("its derivative"), {}};
    pair.place = line.optional_place();
    state_lines_.push_back(number_);
    graph_.states.push_back(std::move(pair));
  }

  void read_frozen(Line &line) {
    Frozen frozen{line.string("the name"), line.optional_place(), {}};
    frozen.is_around = line.accept("around");
    frozen.is_member = line.accept("member");
    if (line.accept("="))
      while (!line.done()) frozen.values.push_back(line.number("a value"));
    graph_.frozen.push_back(std::move(frozen));
  }

  void read_executed(Line &line) {
    Op const op = read_operation(line);
    if (graph_.executed[op] != 0) line.error("the operation has been counted already");
    graph_.executed[op] = line.count("count");
  }

  static Op read_operation(Line &line) {
    std::string name = line.word("an operation");
    auto op = find_operation(name);
    if (!op) line.error("'" + name + "' is not an operation");
    return *op;
  }

  void read_node(Line &line, std::string const &head) {
    if (head != "%" + std::to_string(named_.size()))
      line.error("nodes are numbered from %0 on; expected %" + std::to_string(named_.size()));
    if (!line.accept("=")) line.error("'=' is missing");
    line_of_.push_back(number_);
    if (line.accept("input")) return named_.push_back(table_.append(Node::input(line.count("slot"))));
    if (line.accept("parameter")) return named_.push_back(table_.append(Node::parameter(line.count("slot"))));
    Op op = read_operation(line);
    std::array<NodeId, 3> operand = {no_node, no_node, no_node};
    for (unsigned i = 0; i < arity(op); ++i) operand[i] = read_operand(line);
    named_.push_back(table_.append(table_.operation(op, operand[0], operand[1], operand[2])));
    if (line.accept("exact")) {
      graph_.node_exact.resize(table_.size(), 0);
      graph_.node_exact.back() = 1;
    }
    if (LocationId location = read_location_use(line); location != no_location) {
      located_ = true;
      locations_.resize(table_.size(), no_location);
      locations_.back() = location;
    }
    if (!line.done() && line.peek()[0] == '"') {
      named_nodes_ = true;
      names_.resize(table_.size(), no_name);
      names_.back() = name_id(line.string("the name"));
    }
  }

  NameId name_id(std::string const &name) {
    auto [found, is_new] = name_ids_.try_emplace(name, static_cast<NameId>(graph_.names.size()));
    if (is_new) graph_.names.push_back(name);
    return found->second;
  }

  static LocationId read_location_use(Line &line) {
    if (line.done() || line.peek()[0] != '@') return no_location;
    std::string text = line.word("a location");
    std::optional<LocationId> const id = parse_natural(std::string_view(text).substr(1));
    if (!id) line.error("'" + text + "' is not a location");
    return *id;
  }

  void read_guard(Line &line) {
    if (line.count("guard") != graph_.guards.size()) line.error("guards must follow each other from 0 on");
    NodeId condition = read_operand(line);
    LocationId location = read_location_use(line);
    graph_.guards.push_back({condition, location, line.string("the condition in words")});
  }

  void read_location(Line &line) {
    if (line.count("location") != graph_.locations.size()) line.error("locations must follow each other from 0 on");
    Location location;
    while (!line.done() && line.peek() == "at") location.places.push_back(line.optional_place());
    if (line.accept("stack"))
      while (!line.done()) {
        std::string const &text = line.word("an address");
        std::optional<std::uint64_t> const address = parse_natural<std::uint64_t>(text);
        if (!address) line.error("'" + text + "' is not an address");
        location.addresses.push_back(*address);
      }
    graph_.locations.push_back(std::move(location));
  }

  void read_root(Line &line, std::vector<NodeId> &roots) {
    if (line.count("slot") != roots.size()) line.error("slots must follow each other from 0 on");
    roots.push_back(read_operand(line));
  }

  NodeId read_operand(Line &line) {
    if (!line.done() && line.peek()[0] != '%') return table_.constant(line.number("an operand"));
    std::string text = line.word("an operand");
    std::optional<NodeId> const id = parse_natural(std::string_view(text).substr(1));
    if (!id || *id >= named_.size()) line.error("'" + text + "' is not a node above this line");
    return named_[*id];
  }

  Graph graph_;
  NodeTable table_;
  std::vector<NodeId> named_; // node of each %k
  std::vector<unsigned> line_of_, state_lines_;
  unsigned number_ = 0; // line number
  std::set<std::string> once_;
  LongArray<LocationId> locations_;
  LongArray<NameId> names_;
  std::map<std::string, NameId> name_ids_;
  bool located_ = false, named_nodes_ = false;
  bool headed_ = false;
};

} // namespace

void read_external(Line &line, std::vector<External> &externals) {
  if (line.count("function") != externals.size()) line.error("functions must follow each other from 0 on");
  External external{line.string("the function's name"), line.accept("pure"), {}, {}, {}};
  if (line.accept("returns")) external.returned = read_value(line);
  if (line.accept("takes"))
    while (!line.done() && line.peek() != "at" && line.peek() != "derivative")
      external.parameters.push_back(read_value(line));
  while (line.accept("derivative")) {
    bool const is_returned = line.accept("returned");
    external.derivatives.push_back({line.string("the name of its derivative"), is_returned});
  }
  std::string const violation = is_implicit(external) ? "" : find_violation(external);
  if (!violation.empty()) line.error(violation);
  external.place = line.optional_place();
  externals.push_back(std::move(external));
}

Graph read_graph(std::string_view text, std::string const &file_name) { return Reader().read(text, file_name); }

} // namespace symreal
