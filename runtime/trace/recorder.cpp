// Recording: annotated numbers become nodes, and at the kernel's end the graph is checked, handed over, and every
// annotated number becomes an ordinary one again.
#include "engine/graph/graph_binary.h"
#include "engine/graph/names.h"
#include "engine/support/mutation/is_dropped.h"
#include "engine/support/number.h"
#include "runtime/trace/report/events.h"
#include "runtime/trace/session.h"
#include "runtime/trace/sinks.h"
#include "runtime/wire/request.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <set>
#include <unistd.h>
#include <unordered_map>

namespace symreal::trace {
namespace {

void hand_to_driver(Graph const &graph, std::string const &output_file) {
  static std::atomic<unsigned> delivered = 0;
  unsigned number = delivered++;
  std::string const name = std::to_string(number) + ".graph";
  write_binary_graph(record_directory() + "/" + name, graph);
  event(events::Kernel{graph.kernel, name, output_file});
  for (Frozen const &frozen : graph.frozen) {
    std::string values;
    for (double value : frozen.values) values += (values.empty() ? "" : " ") + shortest(value);
    event(events::Frozen{graph.kernel, frozen.name, to_string(frozen.place), values, frozen.stack});
  }
  flush_events();
  char const *wanted = wire::requested(wire::Entry::kernels);
  if (wanted && number + 1 == std::strtoul(wanted, nullptr, 10)) {
    std::fflush(nullptr);
    std::cout.flush();
    _exit(0);
  }
}

// Writes the graph to the driver's directory; in a program started by hand, passes it to generate_here.
void deliver(Graph const &graph, std::string const &output_file) {
  try {
    if (record_directory().empty())
      generate_here(graph, output_file);
    else
      hand_to_driver(graph, output_file);
  } catch (DiagnosticError const &error) {
    report(error.diagnostic());
    give_up();
  } catch (std::bad_alloc const &) {
    report({DiagnosticId::out_of_memory,
            {},
            "the system gives no more memory to hand kernel '" + graph.kernel + "' over"});
    give_up();
  }
}

class Recorder final : public Sink {
public:
  // `has_notes`: the program notes its reads and writes besides its annotations.
  explicit Recorder(bool has_notes) : has_notes_(has_notes) {}

  void begin(std::string const &name, void const *frame) override {
    graph_ = {};
    implicit_ = {};
    unwritten_.clear();
    declared_.clear();
    overlaps_.clear();
    written_.clear();
    std::copy(std::begin(detail::executed), std::end(detail::executed), executed_before_.by_op.begin());
    modes_at_begin_ = Environment::unusual_modes();
    session_.begin_kernel(name, frame);
  }

  void begin_object(Kind kind, std::string const &label, Place const &place) override {
    kind_ = kind;
    object_ = {label, {}, 0, 0, place};
    shape_.clear();
    is_ragged_ = false;
    kept_.clear();
    for (Object const &met : objects(kind)) {
      if (met.label != label || met.place.line != place.line || met.place.column != place.column) continue;
      report({kind == Kind::output ? DiagnosticId::output_met_twice : DiagnosticId::input_met_twice, place,
              "'" + label + "' is annotated again before its kernel has ended"});
      give_up();
    }
  }

  void element(void *number, bool is_temporary) override {
    Pause const pause;
    auto &real = *static_cast<RealNumber *>(number);
    if (implicit_.is_open()) return implicit_.element(&real);
    Pool &pool = session_.pool;
    switch (kind_) {
    case Kind::constant:
    case Kind::scratch: break;
    case Kind::output:
      graph_.results.push_back(pool.node(real));
      if (is_temporary) break;
      written_.push_back(&real);
      check_overlap(number);
      if (!session_.state.output(&real) && has_notes_) keep(real);
      break;
    case Kind::input:
    case Kind::parameter: {
      if (!is_temporary) {
        claim(number);
        make_writable(static_cast<double *>(number));
      }
      bool is_input = kind_ == Kind::input;
      std::vector<double> &values = is_input ? graph_.input_values : graph_.parameter_values;
      double value = pool.carried_value(real);
      auto slot = static_cast<std::uint32_t>(values.size());
      values.push_back(value);
      real = pool.leaf(is_input ? Node::input(slot) : Node::parameter(slot), value);
      if (is_temporary) break;
      written_.push_back(&real);
      session_.state.input(&real, object_.label, object_.place);
    }
    }
    ++object_.count;
  }

  void scalar(ScalarObject scalar) override {
    Pause const pause;
    std::string name = object_.label;
    for (Level const &level : shape_) name += "." + level.members.back().name;
    if (kind_ == Kind::input || kind_ == Kind::parameter) session_.state.member(scalar, name, object_.place);
  }

  // Receives objects of the original, whose annotations tell bytes.
  void bytes(void const *begin, std::size_t size) override {
    Pause const pause;
    if (kind_ == Kind::constant) session_.state.constant_with_owned(begin, size);
    if (kind_ == Kind::scratch) session_.state.scratch(begin, size, [](void const *, Numbers &) {});
  }
  void holder(void const *begin, std::size_t size) override {
    if (kind_ == Kind::output) handed_over(begin, size);
  }
  void handed_over(void const *begin, std::size_t size) override {
    if (is_dropped("handed_over")) return;
    Pause const pause;
    session_.state.handed_over(begin, size);
  }
  void own(void const *begin, std::size_t size) override {
    Pause const pause;
    session_.state.local(begin, size, detail::Scope::parameter, "a parameter", "");
  }

  void begin_members() override { shape_.emplace_back(); }
  void begin_member(std::string const &name) override {
    shape_.back().members.push_back({name});
    shape_.back().count_before = object_.count;
  }
  void end_member(std::vector<std::size_t> const &extents) override {
    Level &level = shape_.back();
    Member &member = level.members.back();
    member.extents = extents;
    std::size_t const count = object_.count - level.count_before;
    if (number_count(extents, member.members) != count) member = {member.name, {count}};
    if (count == 0) level.members.pop_back(); // a scalar, or empty
  }
  // The elements of an array of structures are of one shape, or the object is one long row.
  void end_members() override {
    std::vector<Member> members = std::move(shape_.back().members);
    shape_.pop_back();
    std::vector<Member> &known = shape_.empty() ? object_.members : shape_.back().members.back().members;
    if (known.empty())
      known = std::move(members);
    else if (known != members)
      is_ragged_ = true;
  }

  void end_object(std::vector<std::size_t> extents) override {
    if (is_ragged_) object_.members.clear();
    if (number_count(extents, object_.members) != object_.count) { // ragged: one long row
      object_.members.clear();
      extents = {object_.count};
    }
    object_.extents = std::move(extents);
    if (kind_ == Kind::constant || kind_ == Kind::scratch) return;
    if (!kept_.empty()) report_kept();
    std::vector<Object> &list = objects(kind_);
    object_.first = list.empty() ? 0 : list.back().first + list.back().count;
    list.push_back(object_);
  }

  bool begin_implicit(std::string const &label, Place const &place) override {
    implicit_.begin(label, place);
    return true;
  }
  void end_implicit() override {
    Pause const pause;
    implicit_.end();
  }

  void set_range(double low, double high) override {
    if (graph_.inputs.empty()) return;
    Place const last = graph_.inputs.back().place;
    // Inputs of this pragma without a range get this one.
    for (Object &input : graph_.inputs)
      if (!input.range && input.place.line == last.line && input.place.file == last.file) input.range = {low, high};
  }

  void set_state(StatePair const &state) override { graph_.states.push_back(state); }

  void differentiate(DerivativeWish const &wish) override { graph_.wishes.push_back(wish); }

  void end(std::string const &name, std::string const &output_file, Place const &place) override {
    if (session_.join.is_arm()) end_arm(place);
    session_.leave_kernel(name, place, unwritten_);
    memory::OwnWork const own;
    graph_.kernel = name;
    // A kernel left by an exception on a hypothetical path has no result.
    if (graph_.outputs.empty() && session_.path.is_hypothetical()) give_up();
    check_modes(place);
    for (std::size_t op = 0; op < graph_.executed.by_op.size(); ++op)
      graph_.executed.by_op[op] = detail::executed[op] - executed_before_.by_op[op];
    check_outputs(place);
    session_.end_kernel(graph_, place, has_notes_, written_);
    hand_over(output_file);
  }

  void cut_off() override {
    Pause const pause;
    graph_.outputs.clear();
    graph_.results.clear();
    graph_.states.clear();
    session_.cut_off_kernel(graph_);
    hand_over("");
    give_up();
  }

  Graph const &interface() const override { return graph_; }

private:
  std::vector<Object> &objects(Kind kind) {
    return kind == Kind::input ? graph_.inputs : kind == Kind::parameter ? graph_.parameters : graph_.outputs;
  }

  // Other changes that the arm leaves behind, besides its results, need a path of their own.
  void end_arm(Place const &place) {
    memory::OwnWork const own;
    if (!unwritten_.empty()) session_.join.leave_unwritten(unwritten_);
    if (graph_.outputs.empty() || session_.leaves_more(place, has_notes_)) session_.join.leave();
    std::string interface;
    for (std::vector<Object> const *list : {&graph_.inputs, &graph_.parameters, &graph_.outputs})
      for (Object const &object : *list) interface += object.label + " " + std::to_string(object.count) + "\n";
    session_.path.end_arm(graph_.results, std::hash<std::string>()(interface));
  }

  void hand_over(std::string const &output_file) {
    locate_nodes(graph_.node_location);
    deliver(graph_, output_file);
  }

  // Reports an output that overlaps an input of another name: the caller decides whether they overlap.
  void check_overlap(void *number) {
    auto const input = declared_.find(number);
    if (input == declared_.end() || first_name(input->second.first) == first_name(object_.label)) return;
    if (!overlaps_.insert(object_.label).second) return;
    report({DiagnosticId::input_met_twice, object_.place,
            "output '" + object_.label + "' overlaps '" + input->second.first + "' (" +
                to_string(input->second.second) + "), so the result would hold only for calls with this overlap"});
  }

  // Base object of a label: `x` of "*this->x[0:2].y".
  static std::string first_name(std::string label) {
    for (std::string const prefix : {"*", "&", "(", "this->", "*"})
      if (label.starts_with(prefix)) label.erase(0, prefix.size());
    return label.substr(0, label.find_first_of("[.-*&() "));
  }

  // Reports elements of the output that the kernel did not write: they keep the caller's values.
  void report_kept() const {
    std::string const what = object_.members.empty() ? "element" : "member";
    std::string elements = object_.count == 1 ? "" : " in " + what + (kept_.size() == 1 ? "" : "s");
    constexpr std::size_t most = 4;
    for (std::size_t k = 0; object_.count > 1 && k < std::min(kept_.size(), most); ++k) {
      auto const element = static_cast<std::uint32_t>(kept_[k].element);
      elements += k ? ", " : " ";
      elements += object_.members.empty() ? std::to_string(element) : element_name("", object_, element).substr(1);
    }
    if (kept_.size() > most) elements += ", ...";
    report({DiagnosticId::output_keeps_value, object_.place,
            "the kernel does not write output '" + object_.label + "'" + elements +
                ", which keeps what it held before (" + shortest(kept_[0].value) +
                (kept_.size() > 1 ? ", ...)" : ")")});
  }

  // Notes an output that holds a plain number and may not have been written.
  void keep(RealNumber &number) {
    unwritten_.push_back({&number, number.plain()});
    std::map<RealNumber *, double> const &held = session_.checkpoint.held();
    auto const before = held.find(&number);
    kept_.push_back({object_.count, before == held.end() ? number.plain() : before->second});
  }

  // Reports an element that is declared as an input or parameter twice.
  void claim(void *number) {
    auto [found, is_new] = declared_.try_emplace(number, object_.label, object_.place);
    if (is_new) return;
    report({DiagnosticId::input_met_twice, object_.place,
            "an element of '" + object_.label + "' already belongs to '" + found->second.first + "' (" +
                to_string(found->second.second) + ")"});
    give_up();
  }

  // Nodes of the same code share a location. Works in place: recordings of this length need the memory.
  void locate_nodes(LongArray<std::uint32_t> &addresses) {
    static_assert(std::is_same_v<std::uint32_t, LocationId>);
    std::unordered_map<std::uint32_t, LocationId> known;
    std::uint32_t last_address = 0;
    LocationId last = no_location;
    for (std::uint32_t &address : addresses) {
      if (address != last_address) {
        last_address = address;
        auto [found, is_new] = known.try_emplace(address, static_cast<LocationId>(graph_.locations.size()));
        if (address == 0)
          found->second = no_location;
        else if (is_new)
          graph_.locations.push_back({{}, {address}});
        last = found->second;
      }
      address = last;
    }
  }

  void check_modes(Place const &end) {
    auto const refuse = [this](char const *when, std::string const &modes, Place const &place) {
      if (!modes.empty())
        report({DiagnosticId::arithmetic_modes, place,
                "kernel '" + graph_.kernel + "' " + when + " where arithmetic " + modes});
    };
    std::string const modes = Environment::unusual_modes();
    refuse("begins", modes_at_begin_, graph_.inputs.empty() ? end : graph_.inputs.front().place);
    if (modes != modes_at_begin_) refuse("ends", modes, end);
  }

  void check_outputs(Place const &end) {
    if (graph_.outputs.empty())
      report({DiagnosticId::no_output, end, "kernel '" + graph_.kernel + "' ends without an output"});
    if (!session_.guards.empty() || session_.path.has_decisions())
      return; // on one path of several an output may well be constant
    for (Object const &output : graph_.outputs) {
      auto first = graph_.results.begin() + output.first;
      bool constant = std::all_of(first, first + output.count, [this](NodeId id) {
        return session_.pool.nodes()[id].attribute == Attribute::constant;
      });
      if (constant)
        report({DiagnosticId::constant_output, output.place,
                "output '" + output.label + "' depends on no input and no parameter"});
    }
  }

  Session &session_ = Session::of_this_thread();
  bool const has_notes_;
  Graph graph_;
  Kind kind_ = Kind::input;
  Implicit implicit_;
  Object object_;
  struct Kept {
    std::size_t element;
    double value;
  };
  struct Level {
    std::vector<Member> members;
    std::size_t count_before; // of the numbers of the object, when the last of them began
  };
  std::vector<Level> shape_; // of the structure that is walked through, outermost first
  bool is_ragged_ = false;
  std::vector<Kept> kept_;           // of this output
  std::vector<Unwritten> unwritten_; // of all outputs
  std::set<std::string> overlaps_;   // that are reported
  OperationCounts executed_before_;
  std::string modes_at_begin_;                               // of arithmetic, if unusual
  std::map<void *, std::pair<std::string, Place>> declared_; // inputs and parameters by address
  std::vector<RealNumber *> written_;                        // hold nodes, and become plain again
};

} // namespace

std::unique_ptr<Sink> make_recorder() { return std::make_unique<Recorder>(/*has_notes=*/true); }
std::unique_ptr<Sink> make_recorder_of_original() { return std::make_unique<Recorder>(watches_memory()); }

} // namespace symreal::trace
