#include "program/build/read_files.h"

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <mutex>
#include <set>
#include <sys/stat.h>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

struct Known {
  std::mutex mutex;
  std::set<std::string> read, written, absent; // absolute paths
  bool are_all = true;
};

// Never destroyed: threads may outlive static objects.
Known &known() {
  static auto *const files = new Known;
  return *files;
}

void note(std::set<std::string> Known::*set, std::string const &path) {
  std::error_code error;
  fs::path name = fs::absolute(path, error);
  // Resolves links first if the path has "..", which behind a link leads elsewhere.
  bool const goes_up = std::find(name.begin(), name.end(), "..") != name.end();
  name = goes_up ? fs::weakly_canonical(name.parent_path(), error) / name.filename() : name.lexically_normal();
  if (error) return;
  std::string absolute = name.string();
  std::lock_guard const lock(known().mutex);
  (known().*set).insert(std::move(absolute));
}

// Is this a pseudo file of the system, or one that changes all the time?
bool is_of_system(std::string const &path) {
  for (char const *start : {"/proc/", "/sys/", "/dev/", "/etc/ld.so.cache"})
    if (path.starts_with(start)) return true;
  return false;
}

} // namespace

void note_read(std::string const &path) { note(&Known::read, path); }
void note_absent(std::string const &path) { note(&Known::absent, path); }

void note_opened(std::string const &path, int flags) {
  struct stat status{};
  bool const exists = stat(path.c_str(), &status) == 0;
  if (is_of_system(path) || (exists && !S_ISREG(status.st_mode))) return;
  bool const writes = (flags & O_ACCMODE) != O_RDONLY, is_own = [&] {
    std::lock_guard const lock(known().mutex);
    return known().written.contains(path);
  }();
  bool const reads = (flags & O_ACCMODE) != O_WRONLY && exists && (flags & O_TRUNC) == 0;
  if (reads && !is_own) note_read(path);
  if (writes) note(&Known::written, path);
  if (!exists && !writes && !is_own) note_absent(path);
}

void note_unseen() {
  std::lock_guard const lock(known().mutex);
  known().are_all = false;
}

std::string identity_of(std::string const &path) {
  struct stat status{};
  if (stat(path.c_str(), &status) == 0) return fmt::format("{}:{}", status.st_dev, status.st_ino);
  std::error_code error;
  fs::path const absolute = fs::absolute(path, error);
  fs::path const directory = fs::canonical(absolute.parent_path(), error);
  return (error ? absolute.lexically_normal() : directory / absolute.filename()).string();
}

std::optional<std::string> known_as(std::string const &path) {
  std::string const wanted = identity_of(path);
  std::lock_guard const lock(known().mutex);
  for (auto const *set : {&known().read, &known().written})
    for (std::string const &one : *set)
      if (identity_of(one) == wanted) return one;
  return {};
}

ReadFiles files_read() {
  std::lock_guard const lock(known().mutex);
  return {{known().read.begin(), known().read.end()}, {known().absent.begin(), known().absent.end()}, known().are_all};
}

} // namespace symreal::program
