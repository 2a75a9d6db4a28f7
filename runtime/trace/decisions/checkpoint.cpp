#include "runtime/trace/decisions/checkpoint.h"

#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/decisions/explored_path.h"
#include "runtime/trace/decisions/join.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace symreal::trace {
namespace {

constexpr double nonsense = -6.48074069840786e97; // the poison: any number that programs do not compute

} // namespace

void Checkpoint::begin() {
  held_.clear();
  end(); // of a kernel that was left
  if (!ExploredPath::is_asked_for()) return;
  for (int ends[2]; pipe2(ends, O_CLOEXEC) == 0;) {
    copy_ = fork();
    if (copy_ == 0) {
      close(ends[1]);
      wait_as_copy(ends[0]);
      continue;
    }
    close(ends[0]);
    to_copy_ = ends[1];
    if (copy_ < 0) end();
    return;
  }
}

// Waits until the process sends the outputs to poison, or needs its copy no more.
void Checkpoint::wait_as_copy(int source) {
  bool is_needed = false;
  for (Unwritten one; read(source, &one, sizeof one) == sizeof one; is_needed = true) {
    held_[one.number] = one.value;
    *one.number = nonsense;
  }
  close(source);
  if (!is_needed) _exit(0);
}

void Checkpoint::go_back(std::span<Unwritten const> unwritten) {
  std::vector<Unwritten> doubtful(unwritten.begin(), unwritten.end());
  std::erase_if(doubtful, [this](Unwritten const &one) { return held_.contains(one.number); });
  if (copy_ <= 0 || doubtful.empty()) return;
  for (Unwritten const &one : doubtful)
    if (write(to_copy_, &one, sizeof one) != sizeof one) return; // not the last: the copy is gone
  close(to_copy_);
  join_.hand_over(copy_);
  int status = 0;
  while (waitpid(copy_, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) raise(WTERMSIG(status));
  _exit(WEXITSTATUS(status));
}

void Checkpoint::leave_to_others() {
  if (to_copy_ >= 0) close(std::exchange(to_copy_, -1));
  copy_ = 0;
}

void Checkpoint::end() {
  if (to_copy_ >= 0) close(std::exchange(to_copy_, -1));
  if (int const copy = std::exchange(copy_, 0); copy > 0)
    while (waitpid(copy, nullptr, 0) < 0 && errno == EINTR) {
    }
}

} // namespace symreal::trace
