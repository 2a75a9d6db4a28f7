#include "runtime/trace/decisions/join.h"

#include "engine/support/page_allocator.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/decisions/decisions.h"
#include "runtime/trace/report/events.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <iterator>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace symreal::trace {
namespace {

constexpr int come_together = 77, need_more_arms = 78;

bool has_other_threads() {
  std::error_code error;
  std::filesystem::directory_iterator threads("/proc/self/task", error);
  return !error && std::distance(threads, {}) > 1;
}

} // namespace

int Join::exit_status(pid_t process) {
  int status = 0;
  while (process > 0 && waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return process > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

JoinCosts const &Join::costs() const { return shared_->costs; }

std::optional<bool> Join::attempt(Stand &stand, Traveller &traveller, std::size_t most_pieces) {
  if (has_other_threads()) return std::nullopt;         // a fork would lose them
  if (memory::has_mapped_memory()) return std::nullopt; // a process image leaves mapped memory out
  if (!shared_) {
    void *const memory = map_anonymous(sizeof(Shared), MAP_SHARED);
    if (memory == MAP_FAILED) return std::nullopt;
    shared_ = static_cast<Shared *>(memory);
    is_root_ = true;
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    shared_->main = getpid();
  }
  shared_->tried = 0;
  int status = need_more_arms;
  for (int arms = Arms::usual; status == need_more_arms; arms = std::min(4 * arms, Arms::most)) {
    shared_->unwritten_count = 0;
    pid_t const coordinator = fork();
    if (coordinator < 0) return std::nullopt;
    if (coordinator == 0) {
      is_root_ = false;
      keep_events(true);
      return coordinate(stand, traveller, most_pieces, arms);
    }
    status = exit_status(coordinator);
  }
  if (status != come_together) {
    checkpoint_.go_back({shared_->unwritten, shared_->unwritten_count});
    return std::nullopt;
  }
  if (is_root_) stand_for_main();
  _exit(0);
}

// The driver waits for this process: it ends as the program does.
void Join::stand_for_main() {
  checkpoint_.leave_to_others();
  for (;;) {
    int status = 0;
    pid_t const ended = waitpid(-1, &status, 0);
    if (ended < 0 && errno != EINTR) _exit(1);
    if (ended < 0 || ended != shared_->main) continue;
    if (WIFSIGNALED(status)) {
      signal(WTERMSIG(status), SIG_DFL);
      raise(WTERMSIG(status));
    }
    _exit(WEXITSTATUS(status));
  }
}

void Join::hand_over(pid_t process) {
  if (!shared_ || is_root_) return;
  shared_->main = process;
  _exit(0);
}

std::optional<bool> Join::coordinate(Stand &stand, Traveller &traveller, std::size_t most_pieces, int arms) {
  parted_ = PartingPoint::now();
  state_.begin_journal();
  std::size_t const tried_before = shared_->tried;
  Region region(pool_, arms_, parted_, RealNumber::from_bits(stand.condition), traveller.is_hypothetical(),
                most_pieces - std::min(most_pieces, tried_before));
  std::optional<int> last;
  for (std::size_t round = 0; round < Region::most_rounds && !last; ++round) {
    if (!arms_.open(arms, shared_->arms)) break;
    pid_t const first = fork();
    if (first == 0) {
      is_arm_ = true;
      hide_output();
      arms_.become(arm_ = 0);
      return serve(&stand, nullptr, traveller);
    }
    last = first < 0 ? std::nullopt : region.run();
    shared_->tried = tried_before + region.tried();
    if (last) break;
    arms_.kill_all();
    arms_.close_all();
    if (region.wants_more_arms()) _exit(need_more_arms); // another begins as this one has
    if (!region.wants_another_round()) break;
  }
  if (!last) _exit(0);
  arms_.kill_all(*last); // before the last goes on, and has arms of its own
  shared_->costs = region.costs();
  shared_->main = arms_.pid(*last);
  MessageWriter writer;
  std::vector<std::vector<std::uintptr_t>> const all = region.decided_at();
  writer.put(all.size());
  for (std::vector<std::uintptr_t> const &one : all) writer.put_all(one);
  arms_.send(*last, {.what = Arms::go_on}, writer.bytes());
  _exit(come_together);
}

std::optional<bool> Join::stand(Stand &stand, Traveller &traveller) {
  arrive(Arrival::here(parted_, &stand, traveller.is_hypothetical()));
  return serve(&stand, nullptr, traveller);
}

void Join::stand_at_end(std::vector<RealNumber> &results, std::size_t interface, Traveller &traveller) {
  arrive(Arrival::at_end(parted_, results, interface, traveller.is_hypothetical()));
  (void)serve(nullptr, &results, traveller);
}

void Join::arrive(std::optional<Arrival> const &arrival) {
  if (!arrival) leave();
  arms_.write_arrival(arm_, *arrival);
  (void)!write(arrived_, "", 1);
  close(arrived_);
}

void Join::leave() { _exit(1); }

void Join::leave_unwritten(std::span<Unwritten const> unwritten) {
  if (unwritten.size() <= most_unwritten) {
    std::ranges::copy(unwritten, shared_->unwritten);
    shared_->unwritten_count = unwritten.size();
  }
  leave();
}

// Discards standard output and error in an arm: other arms may execute the same statements.
void Join::hide_output() {
  int const nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (int k : {0, 1}) {
    shown_[k] = fcntl(k + 1, F_DUPFD_CLOEXEC, 3);
    if (nowhere >= 0) dup2(nowhere, k + 1);
  }
  if (nowhere >= 0) close(nowhere);
}

void Join::show_output() {
  for (int k : {0, 1}) {
    if (shown_[k] < 0) continue;
    dup2(shown_[k], k + 1);
    close(std::exchange(shown_[k], -1));
  }
}

// Executes the coordinator's commands.
std::optional<bool> Join::serve(Stand *stand, std::vector<RealNumber> *results, Traveller &traveller) {
  std::vector<char> bytes;
  for (;;) {
    Arms::Command const command = arms_.listen(arm_, bytes);
    MessageReader reader(bytes);
    if (command.what == Arms::merge) {
      merge(read_merge(reader), results, traveller);
    } else if (command.what == Arms::go_on) {
      is_arm_ = false;
      show_output();
      conditions_.arm = 1.0;
      arms_.close_all();
      keep_events(false);
      for (auto left = reader.get<std::size_t>(); left != 0; --left)
        event(events::JoinedAt{reader.get_all<wire::Stack>()});
      return std::nullopt;
    } else {
      RealNumber const condition = RealNumber::from_bits(stand->condition);
      std::optional<bool> const settled = traveller.settled(condition);
      Arms::Report report;
      for (bool outcome : {false, true}) {
        if (settled && *settled != outcome) {
          report.arm[outcome] = Arms::settled;
          continue;
        }
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) leave();
        pid_t const arm = fork();
        if (arm == 0) {
          close(ends[0]);
          arrived_ = ends[1];
          arms_.become(arm_ = command.arm[outcome]);
          return outcome;
        }
        close(ends[1]);
        char byte = 0;
        ssize_t got = arm < 0 ? 0 : -1;
        while (got < 0) got = read(ends[0], &byte, 1);
        close(ends[0]);
        report.arm[outcome] = got == 1 ? command.arm[outcome] : Arms::none;
        if (got != 1) break; // one that does not arrive is enough
      }
      arms_.report(report);
      _exit(0);
    }
  }
}

void Join::merge(Arms::Merge const &merge, std::vector<RealNumber> *results, Traveller &traveller) {
  std::vector<NodeId> const now = pool_.adopt(parted_.nodes, merge.nodes);
  auto const here = [&](NodeId node) { return node < parted_.nodes ? node : now[node - parted_.nodes]; };
  for (auto const &[address, node] : merge.numbers) {
    RealNumber const number = pool_.number(here(node));
    if (!results)
      *address = number.to_bits();
    else if (address)
      (*results)[ProcessImage::result_at(address)] = number;
  }
  std::vector<Guards::Recorded> guards = merge.guards;
  for (Guards::Recorded &guard : guards) guard = renumbered(std::move(guard), here);
  guards_.replace(parted_.guards, std::move(guards));
  bool const recording = std::exchange(detail::recording, false);
  bool const has_learned = state_.learn(merge.notes);
  detail::recording = recording;
  if (!has_learned) leave();
  conditions_.arm = merge.arm == no_node ? RealNumber(1.0) : pool_.number(here(merge.arm));
  traveller.forget(merge.is_hypothetical);
}

} // namespace symreal::trace
