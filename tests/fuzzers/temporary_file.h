// A file in memory with the text of an input, for what reads by name.
#pragma once

#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace symreal::fuzz {

class TemporaryFile {
public:
  explicit TemporaryFile(std::string_view text) : descriptor_(memfd_create("input", 0)) {
    if (descriptor_ < 0 || write(descriptor_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) _exit(2);
  }
  ~TemporaryFile() { close(descriptor_); }
  TemporaryFile(TemporaryFile const &) = delete;
  TemporaryFile &operator=(TemporaryFile const &) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
  int descriptor_;
};

} // namespace symreal::fuzz
