#include "program/record/memory_file.h"

#include <filesystem>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace symreal::program {

MemoryFile::MemoryFile(std::string path) : path_(std::move(path)), descriptor_(memfd_create("symreal", MFD_CLOEXEC)) {
  if (descriptor_ < 0) return;
  std::string const opened = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(descriptor_);
  std::error_code problem;
  std::filesystem::create_symlink(opened, path_, problem);
}

MemoryFile::MemoryFile(MemoryFile &&other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

// The file vanishes with its last descriptor.
MemoryFile::~MemoryFile() {
  if (descriptor_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  close(descriptor_);
}

} // namespace symreal::program
