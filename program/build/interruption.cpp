#include "program/build/interruption.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace symreal::program {

// Records are never freed, as a handler may be reading the list; inactive ones are reused.
struct Doomed::Record {
  std::atomic<bool> is_taken = true, is_active = false;
  Kind kind = Kind::file;
  pid_t group = 0;
  std::string path;
  Record *next = nullptr;
};

namespace {

using Record = Doomed::Record;

constexpr std::array ending_signals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

std::atomic<Record *> first_record = nullptr;
std::atomic<bool> is_ending = false;
pid_t owner = 0;

template <class Use> void for_each_active(Doomed::Kind kind, Use use) {
  for (Record *one = first_record; one; one = one->next)
    if (one->is_active && one->kind == kind) use(*one);
}

// Removes a tree by a forked `rm`, as that is not safe in a handler. Retries, since a process that was just killed may
// still have created a file.
void remove_tree(char const *path) {
  constexpr int most_tries = 3;
  for (int tries = 0; tries < most_tries; ++tries) {
    pid_t const child = fork();
    if (child == 0) {
      execlp("rm", "rm", "-rf", path, static_cast<char *>(nullptr));
      _exit(127);
    }
    int status = 0;
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (child < 0 || status == 0) return;
    usleep(50'000);
  }
}

void end_everything(int signal_number) {
  if (getpid() != owner) _exit(128 + signal_number); // a child between fork and exec
  while (is_ending.exchange(true)) pause();          // another thread is cleaning up
  for_each_active(Doomed::Kind::processes, [](Record const &one) { kill(-one.group, SIGKILL); });
  for_each_active(Doomed::Kind::file, [](Record const &one) { unlink(one.path.c_str()); });
  for_each_active(Doomed::Kind::tree, [](Record const &one) { remove_tree(one.path.c_str()); });
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

void catch_signals() {
  static bool const once = [] {
    owner = getpid();
    for (int const number : ending_signals) {
      struct sigaction before{}, now{};
      now.sa_handler = end_everything;
      now.sa_flags = SA_RESTART;
      sigfillset(&now.sa_mask);
      if (sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_DFL) sigaction(number, &now, nullptr);
    }
    return true;
  }();
  (void)once;
}

Record *taken_record() {
  catch_signals();
  for (Record *one = first_record; one; one = one->next)
    if (bool is_taken = false; one->is_taken.compare_exchange_strong(is_taken, true)) return one;
  auto *const fresh = new Record;
  fresh->next = first_record;
  while (!first_record.compare_exchange_weak(fresh->next, fresh)) {
  }
  return fresh;
}

} // namespace

Doomed::Doomed(Kind kind, std::string const &path) : record_(taken_record()) {
  record_->kind = kind;
  record_->path = path;
  record_->is_active = true;
}

Doomed::Doomed(pid_t group) : record_(taken_record()) {
  record_->kind = Kind::processes;
  record_->group = group;
  record_->is_active = true;
}

Doomed &Doomed::operator=(Doomed &&other) noexcept {
  std::swap(record_, other.record_);
  return *this;
}

void Doomed::spare() {
  if (!record_) return;
  while (is_ending && getpid() == owner) pause(); // the handler may be reading the record
  record_->is_active = false;
  record_->is_taken = false;
  record_ = nullptr;
}

Uninterrupted::Uninterrupted() {
  sigset_t blocked;
  sigemptyset(&blocked);
  for (int const number : ending_signals) sigaddset(&blocked, number);
  pthread_sigmask(SIG_BLOCK, &blocked, &before_);
}

Uninterrupted::~Uninterrupted() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

} // namespace symreal::program
