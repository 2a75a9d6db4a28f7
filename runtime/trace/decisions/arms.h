// Processes that execute the arms of a decision, one each: the commands that they receive, and their arrivals at a
// later decision, where they stand.
//
//   created ──executes──▶ stands at a decision ──advance──▶ two processes, one for each outcome
//                                 │  ▲
//                                 └──┘ merge: it goes on for others that stand there, with other numbers
//
// The one in which all arms have come together goes on as the program.
#pragma once

#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/join/process_image.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/state/state.h"

#include <optional>
#include <sys/types.h>
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

// Arrival of an arm's process: all that another process needs to go on for both.
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

// State shared by all processes of a region: their ids and channels.
class Arms {
public:
  static constexpr int most = 1000;
  static constexpr int usual = 16;   // enough for most regions: channels cost more than their traffic
  static constexpr int none = -1;    // no process came there
  static constexpr int settled = -2; // an outcome that cannot occur

  static constexpr char advance = 'a', merge = 'm', go_on = 'g';
  struct Command {
    char what = 0;
    int arm[2] = {none, none};
    std::size_t size = 0; // of the bytes that follow
  };
  struct Report {
    int arm[2] = {none, none};
  };
  struct Merge {
    std::vector<Pool::Row> nodes;
    std::vector<std::pair<std::uint64_t *, NodeId>> numbers;
    std::vector<Guards::Recorded> guards;
    std::vector<StateNote> notes;
    NodeId arm = no_node;
    bool is_hypothetical = false;
  };

  // Opens channels for `count` arms.
  bool open(int count, pid_t *shared_pids);
  void close_all();
  int count() const { return static_cast<int>(channels_.size()); }

  // The coordinator's side.
  void send(int arm, Command command, std::vector<char> const &bytes = {}) const;
  std::optional<Report> receive(int milliseconds) const;
  std::optional<Arrival> arrival(int arm) const;
  void kill_all(int but = none) const;
  pid_t pid(int arm) const { return pids_[arm]; }

  // The arm's side.
  void become(int arm);
  void write_arrival(int arm, Arrival const &arrival) const;
  Command listen(int arm, std::vector<char> &bytes) const;
  void report(Report report) const;

private:
  struct Channel {
    int listen = -1, speak = -1, file = -1;
  };

  std::vector<Channel> channels_; // one for each arm
  int reports_[2] = {-1, -1};
  pid_t *pids_ = nullptr; // shared
};

void write_merge(Arms::Merge const &merge, MessageWriter &writer);
Arms::Merge read_merge(MessageReader &reader);

} // namespace symreal::trace
