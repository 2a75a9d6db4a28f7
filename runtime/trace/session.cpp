#include "runtime/trace/session.h"

#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/leaks/trap.h"
#include "runtime/trace/outside/world.h"
#include "runtime/trace/report/events.h"

namespace symreal::trace {

Parts *make_parts() { return memory::make_own<Session>(); }

Session::Session()
    : Parts{pool_,       torn_numbers_, externals_, external_shapes_, kernel_,      state_,     conditions_, guards_,
            checkpoint_, join_,         path_,      text_marks_,      environment_, type_names_} {}

void Session::begin_kernel(std::string const &name, void const *frame) {
  checkpoint_.begin(); // first: the copy that waits goes through all that follows when it goes on
  event(events::Started{name});
  flush_events(); // the kernel may crash
  pool_.begin();
  state_.begin(frame); // memory that is allocated from here on is the kernel's
  torn_numbers_.begin();
  guards_.begin();
  path_.begin();
  externals_.begin();
  text_marks_.begin();
  enable_trap(); // it tells the pool's nodes from other numbers
  // Behind all that writes files and starts processes. An arm (join.h) watches since it was the program.
  if (!join_.is_arm()) watch_world();
  environment_.begin(); // last: it sees errno as the kernel will
}

// Reports effects of the kernel: generated code has only those of external functions, which are unrestricted.
static void judge_world(Place const &place, Externals const &externals) {
  std::vector<Effect> const effects = effects_on_world();
  if (!externals.functions().empty()) return;
  for (Effect const &effect : effects)
    if (effect.kind == Effect::Kind::changes)
      report({DiagnosticId::effect_outside, place,
              "the kernel " + effect.what + ", and the generated code would not do so"});
}

void Session::leave_kernel(std::string const &name, Place const &place, std::span<Unwritten const> unwritten) {
  judge_world(place, externals_); // first: what follows writes files and starts processes
  memory::OwnWork const own;
  if (!disable_trap()) // arithmetic from here on is the recorder's
    report({DiagnosticId::trap_lost, place,
            "kernel '" + name + "' changes the floating-point environment or the handler of SIGFPE or SIGTRAP"});
  checkpoint_.go_back(unwritten); // before anything is told of this process, for which the copy may go on
  checkpoint_.end();
}

// Annotated numbers still hold nodes: they are compared with those that they held.
std::vector<Frozen> Session::judge_memory(Place const &place, bool has_notes) {
  torn_numbers_.end();
  if (has_notes) return state_.end(place, !guards_.empty());
  state_.end_untold();
  return {};
}

void Session::end_kernel(Graph &graph, Place const &place, bool has_notes, std::span<RealNumber *const> written) {
  graph.frozen = judge_memory(place, has_notes);
  text_marks_.end();
  for (RealNumber *number : written) pool_.make_plain(*number); // while the pool has their values
  guards_.end(graph);
  path_.end();
  release_nodes(graph);
}

// The pool last: the last effect gets its node from it.
void Session::release_nodes(Graph &graph) {
  externals_.end(graph);
  graph.node_location = pool_.take_places();
  graph.node_exact = pool_.exact();
  graph.nodes = pool_.end();
}

void Session::cut_off_kernel(Graph &graph) {
  (void)disable_trap();
  event(events::Cut());
  release_nodes(graph);
}

bool Session::leaves_more(Place const &place, bool has_notes) {
  return Join::would([&] {
    (void)judge_memory(place, has_notes);
    return anything_wrong() || has_told(events::Scratch::name_of_event);
  });
}

} // namespace symreal::trace
