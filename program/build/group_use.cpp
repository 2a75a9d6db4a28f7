#include "program/build/group_use.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

// User and system time of a process and of the children that it has waited for.
double seconds_of(fs::path const &process) {
  std::ifstream in(process / "stat");
  std::string line;
  std::getline(in, line);
  std::size_t const name_end = line.rfind(')'); // the program's name may contain blanks
  if (name_end == line.npos) return 0;
  std::istringstream rest(line.substr(name_end + 1));
  constexpr int before = 11; // fields between the name and the times
  std::string passed;
  for (int i = 0; i < before; ++i) rest >> passed;
  double ticks = 0;
  for (int i = 0; i < 4; ++i) {
    double one = 0;
    rest >> one;
    ticks += one;
  }
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::size_t memory_of(fs::path const &process) {
  std::ifstream in(process / "status");
  for (std::string word; in >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmHWM:" && in >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

} // namespace

GroupUse use_of_group(pid_t group) {
  GroupUse use;
  std::error_code error;
  for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
    std::string const name = at->path().filename().string();
    pid_t process = 0;
    std::from_chars(name.data(), name.data() + name.size(), process);
    if (process == 0 || getpgid(process) != group) continue;
    use.seconds += seconds_of(at->path());
    use.most_memory = std::max(use.most_memory, memory_of(at->path()));
  }
  return use;
}

} // namespace symreal::program
