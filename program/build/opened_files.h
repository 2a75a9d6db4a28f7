// What a process, and each process that it starts, opens: the system asks for leave before it opens a file (a filter of
// seccomp with a listener), and gets it once the name is noted. Nothing of the program changes, whatever it is linked
// of.
#pragma once

#include <functional>
#include <string>
#include <sys/types.h>

namespace symreal::program {

// An absolute path and the flags of open(2).
using OpenSink = std::function<void(std::string const &path, int flags)>;

class OpenedFiles {
public:
  OpenedFiles();
  ~OpenedFiles();
  OpenedFiles(OpenedFiles const &) = delete;
  OpenedFiles &operator=(OpenedFiles const &) = delete;

  // In the child, as the last step before it becomes the program; allocates nothing.
  void install() const noexcept;
  // In the parent, once the child is the program: calls `sink` in a thread of its own until the last of the processes
  // has ended. False: this system does not tell.
  bool serve(OpenSink sink);

private:
  int ends_[2] = {-1, -1}; // a socket, by which the child hands over the listener
};

} // namespace symreal::program
