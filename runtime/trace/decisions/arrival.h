// Arrival of an arm's process at a later decision, where it stands: all that another process needs to go on for both.
#pragma once

#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/join/process_image.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/state/state.h"

#include <vector>

namespace symreal::trace {

// Extent of a recording at the decision where its arms parted.
struct PartingPoint {
  NodeId nodes = 0;
  std::size_t guards = 0, told = 0;
  RealNumber last_effect = 0.0;
  bool has_text = false;

  static PartingPoint now();
};

struct Arrival {
  // Facts that two arrivals must agree on to merge, besides their memory.
  struct Facts {
    std::size_t tables = 0, externals = 0;
    int policy = 0;
    unsigned arithmetic = 0;   // rounding and other modes
    std::size_t interface = 0; // of a kernel that has ended
    bool operator==(Facts const &) const = default;
  };

  Facts facts;
  ProcessImage image;
  std::vector<Pool::Row> nodes; // recorded since
  std::vector<Guards::Recorded> guards;
  std::vector<StateNote> notes;
  std::vector<std::uintptr_t> stack; // of the decision
  RealNumber arm = 1.0;              // the condition under which the program comes here
  bool is_hypothetical = false;

  // Nullopt if something other than numbers has happened on the way: an effect, a diagnostic.
  static std::optional<Arrival> here(PartingPoint const &since, Stand *stand, bool is_hypothetical);
  static std::optional<Arrival> at_end(PartingPoint const &since, std::vector<RealNumber> const &results,
                                       std::size_t interface, bool is_hypothetical);
  void write(MessageWriter &writer) const;
  static Arrival read(MessageReader &reader);

private:
  static std::optional<Arrival> since(PartingPoint const &parted, bool is_hypothetical);
};

void write_guards(std::vector<Guards::Recorded> const &guards, MessageWriter &writer);
std::vector<Guards::Recorded> read_guards(MessageReader &reader);

} // namespace symreal::trace
