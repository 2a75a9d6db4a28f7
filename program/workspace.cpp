#include "program/workspace.h"

#include "diagnostics/diagnostic.h"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

// What an interrupt removes. The handler forks `rm`, since removing a tree is not safe in a handler.
std::atomic<char const *> doomed = nullptr;

void remove_and_die(int signal_number) {
  if (char const *path = doomed.exchange(nullptr)) {
    if (fork() == 0) {
      execlp("rm", "rm", "-rf", path, static_cast<char *>(nullptr));
      _exit(127);
    }
  }
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

} // namespace

Workspace::Workspace(bool keep) : keep_(keep) {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "symreal-XXXXXX").string();
  if (error || !mkdtemp(name.data()))
    fail(DiagnosticId::no_workspace, {},
         "no directory can be made for the build: " + std::string(std::strerror(errno)));
  path_ = name;
  if (keep_) return;
  doomed = path_.c_str();
  for (int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal_number, remove_and_die);
}

Workspace::~Workspace() {
  if (keep_) return;
  for (int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal_number, SIG_DFL);
  doomed = nullptr;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Workspace::directory(std::string const &name) const {
  std::string path = file(name);
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(DiagnosticId::no_workspace, {path}, "the directory cannot be made: " + error.message());
  return path;
}

} // namespace symreal::program
