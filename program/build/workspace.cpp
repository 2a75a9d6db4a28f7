#include "program/build/workspace.h"

#include "engine/diagnostics/diagnostic.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

constexpr char const *name_start = "symreal-", *lock_name = "/.lock";

bool is_own(std::string const &path, mode_t type) {
  struct stat status{};
  return lstat(path.c_str(), &status) == 0 && (status.st_mode & S_IFMT) == type && status.st_uid == geteuid();
}

// Removes a workspace whose owner has ended: the system then releases its lock. A workspace without a lock is kept for
// the user, or is about to be locked.
void remove_if_dead(std::string const &path) {
  std::string const lock = path + lock_name;
  if (!is_own(path, S_IFDIR) || !is_own(lock, S_IFREG)) return;
  int const descriptor = open(lock.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return;
  std::error_code ignored;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) fs::remove_all(path, ignored);
  close(descriptor);
}

// Removes dead workspaces, once a run.
void remove_dead_workspaces(fs::path const &directory) {
  static bool is_done = false;
  if (std::exchange(is_done, true)) return;
  std::error_code error;
  for (fs::directory_iterator one(directory, fs::directory_options::skip_permission_denied, error), end;
       !error && one != end; one.increment(error))
    if (one->path().filename().string().starts_with(name_start)) remove_if_dead(one->path().string());
}

} // namespace

Workspace::Workspace(bool keep) : keep_(keep) {
  std::error_code error;
  fs::path const directory = fs::temp_directory_path(error);
  std::string name = (directory / name_start).string() + "XXXXXX";
  if (error || !mkdtemp(name.data()))
    fail(DiagnosticId::no_workspace, {},
         "no directory can be made for the build: " + std::string(std::strerror(errno)));
  path_ = name;
  if (keep_) return;
  doomed_ = Doomed(Doomed::Kind::tree, path_);
  remove_dead_workspaces(directory);
  // Renames the lock file only once it is locked.
  std::string const lock = path_ + lock_name, fresh = lock + ".new";
  lock_ = open(fresh.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) == 0) fs::rename(fresh, lock, error);
}

Workspace::~Workspace() {
  if (keep_) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

std::string Workspace::directory(std::string const &name) const {
  std::string path = file(name);
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(DiagnosticId::no_workspace, {path}, "the directory cannot be made: " + error.message());
  return path;
}

} // namespace symreal::program
