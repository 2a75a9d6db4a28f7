#include "program/record/events.h"

#include <fstream>
#include <utility>

namespace symreal::program {
namespace {

namespace events = wire::events;

DiagnosticId id_of(std::string const &code) {
  DiagnosticInfo const *found = find_diagnostic(code);
  internal_check(found);
  return found->id;
}

// Adds an event of each type.
struct Collector {
  Events &all;

  void operator()(events::Started const &one) { all.started.push_back(one.kernel); }
  void operator()(events::Kernel const &one) {
    all.kernels.push_back({one.name, one.graph_file, one.output_file, all.started.empty() ? "" : all.started.back(),
                           std::exchange(all.scratch, {}), std::exchange(all.clauses, {})});
  }
  void operator()(events::Error const &one) { add(one, Severity::error); }
  void operator()(events::Warning const &one) { add(one, Severity::warning); }
  void operator()(events::Located const &one) { all.located.push_back({id_of(one.code), one.message, one.stack, 0}); }
  void operator()(events::Met const &one) {
    all.located.push_back({id_of(one.code), one.message, one.stack, one.count});
  }
  void operator()(events::Frozen const &one) { all.frozen.push_back(one); }
  void operator()(events::Scratch const &one) { all.scratch.push_back(one.name); }
  void operator()(events::Clause const &one) { all.clauses[one.clause] = one.names; }
  void operator()(events::Decision const &one) { all.decisions.push_back({one.count, one.condition, one.stack}); }
  void operator()(events::Carried const &one) { all.carried.push_back({one.count, one.condition, one.stack}); }
  void operator()(events::Settled const &one) { all.settled.push_back({one.count, one.condition, one.stack}); }
  void operator()(events::Decided const &one) {
    auto const is_one_of = [&one](std::string_view outcomes) { return outcomes.find(one.outcome) != outcomes.npos; };
    all.decided.push_back({static_cast<std::uint32_t>(one.node), is_one_of("tTY"), is_one_of("TFYN"), is_one_of("j"),
                           is_one_of("YN"), one.condition, one.stack});
  }
  void operator()(events::Joined const &one) { all.joined.push_back(one); }
  void operator()(events::JoinedAt const &one) { all.joined_at.push_back(one.stack); }
  void operator()(events::InVain const &one) { all.in_vain += one.pieces; }
  void operator()(events::Followed const &one) { all.followed = one.count; }
  void operator()(events::Beyond const &one) { all.beyond = one.count; }
  void operator()(events::Undecided const &one) { all.undecided.push_back(one.kernel); }
  void operator()(events::Cut const &) { all.is_cut_off = true; }

private:
  template <class Event> void add(Event const &one, Severity severity) {
    Place const place{one.file, static_cast<unsigned>(one.line), static_cast<unsigned>(one.column)};
    all.diagnostics.push_back({id_of(one.code), place, one.message, {}, severity});
  }
};

} // namespace

Events read_events(std::string const &path) {
  Events all;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) wire::read_event(line, Collector{all});
  return all;
}

std::vector<std::uint64_t> read_crash(std::string const &path) {
  std::ifstream in(path);
  std::string signal, list;
  in >> signal >> list;
  if (list.ends_with(',')) list.pop_back();
  return list.empty() ? std::vector<std::uint64_t>() : wire::read_stack(list);
}

} // namespace symreal::program
