// A file in memory with a path in the file system.
//
// A graph of a hundred million nodes takes two gigabytes; a disk file would be written out although it is read at once.
#pragma once

#include <string>

namespace symreal::program {

class MemoryFile {
public:
  // Other processes of the same user open it by this path. Without system support nothing is created, and opening the
  // path for writing creates an ordinary file.
  explicit MemoryFile(std::string path);
  ~MemoryFile();
  MemoryFile(MemoryFile &&other) noexcept;
  MemoryFile(MemoryFile const &) = delete;

private:
  std::string path_;
  int descriptor_;
};

} // namespace symreal::program
