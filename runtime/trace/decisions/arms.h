// Processes that execute the arms of a decision, one each, and the commands that they receive.
//
//   created ──executes──▶ stands at a decision ──advance──▶ two processes, one for each outcome
//                                 │  ▲
//                                 └──┘ merge: it goes on for others that stand there, with other numbers
//
// The one in which all arms have come together goes on as the program.
#pragma once

#include "runtime/trace/decisions/arrival.h"

#include <array>
#include <optional>
#include <span>
#include <sys/types.h>

namespace symreal::trace {

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
  int count() const { return count_; }

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
  std::span<Channel> opened() { return {channels_.data(), static_cast<std::size_t>(count_)}; }

  std::array<Channel, most> channels_ = {}; // the first `count_` are open
  int count_ = 0;
  int reports_[2] = {-1, -1};
  pid_t *pids_ = nullptr; // shared
};

void write_merge(Arms::Merge const &merge, MessageWriter &writer);
Arms::Merge read_merge(MessageReader &reader);

} // namespace symreal::trace
