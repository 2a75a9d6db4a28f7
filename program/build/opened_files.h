// Observer of the files that a process and its descendants open: a seccomp filter with a listener holds each open call
// until its path is noted. Works for any program, however it is linked.
#pragma once

#include <functional>
#include <string>
#include <sys/types.h>

namespace symreal::program {

// Receiver of an absolute path and the flags of open(2).
using OpenSink = std::function<void(std::string const &path, int flags)>;

class OpenedFiles {
public:
  OpenedFiles();
  ~OpenedFiles();
  OpenedFiles(OpenedFiles const &) = delete;
  OpenedFiles &operator=(OpenedFiles const &) = delete;

  // Installs the filter in the child, just before exec; allocates nothing.
  void install() const noexcept;
  // Serves the filter in the parent, after the child's exec: calls `sink` in its own thread until the last process has
  // ended. False if the system does not support it.
  bool serve(OpenSink sink);

private:
  int ends_[2] = {-1, -1}; // socket pair by which the child passes the listener
};

} // namespace symreal::program
