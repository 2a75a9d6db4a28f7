// Cleanup on signals: kills the processes that the tool started, with their descendants, and removes unfinished files.
// SIGINT, SIGTERM, SIGHUP and SIGPIPE are caught once the first resource is registered; signals ignored at startup
// (nohup) stay ignored.
#pragma once

#include <csignal>
#include <string>
#include <sys/types.h>

namespace symreal::program {

class Doomed {
public:
  enum class Kind { file, tree, processes }; // file; directory tree; process group

  Doomed() = default;
  Doomed(Kind kind, std::string const &path);
  explicit Doomed(pid_t group);
  ~Doomed() { spare(); }
  Doomed(Doomed &&other) noexcept : record_(other.record_) { other.record_ = nullptr; }
  Doomed &operator=(Doomed &&other) noexcept;

  // Unregisters the resource: it is to be kept, or is gone already.
  void spare();

  struct Record;

private:
  Record *record_ = nullptr;
};

// Blocks signals in this thread, which is the one that renames results.
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
