// A file in memory behind an ordinary name.
//
// A graph of a hundred million nodes is two gigabytes. On a disk it would be written out in the middle of the run, for
// a reader that comes a moment later.
#pragma once

#include <string>

namespace symreal::program {

class MemoryFile {
public:
  // Other processes of the same user open it by this path. Where the system has no such files nothing is made: who
  // opens the path to write makes an ordinary file.
  explicit MemoryFile(std::string path);
  ~MemoryFile();
  MemoryFile(MemoryFile &&other) noexcept;
  MemoryFile(MemoryFile const &) = delete;

private:
  std::string path_;
  int descriptor_;
};

} // namespace symreal::program
