// All that goes when a signal ends the tool: the processes that it started, with those that these started, and files
// that are of no use yet. SIGINT, SIGTERM, SIGHUP and SIGPIPE are caught from the first of them on; a signal that the
// tool was started with as an ignored one, as by nohup, stays so.
#pragma once

#include <csignal>
#include <string>
#include <sys/types.h>

namespace symreal::program {

class Doomed {
public:
  enum class Kind { file, tree, processes }; // a directory with all below it; a group of processes

  Doomed() = default;
  Doomed(Kind kind, std::string const &path);
  explicit Doomed(pid_t group);
  ~Doomed() { spare(); }
  Doomed(Doomed &&other) noexcept : record_(other.record_) { other.record_ = nullptr; }
  Doomed &operator=(Doomed &&other) noexcept;

  // It stays whatever happens, or is gone already.
  void spare();

  struct Record;

private:
  Record *record_ = nullptr;
};

// No signal comes meanwhile in this thread, which is the one that renames results.
class Uninterrupted {
public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(Uninterrupted const &) = delete;
  Uninterrupted &operator=(Uninterrupted const &) = delete;

private:
  sigset_t before_;
};

} // namespace symreal::program
