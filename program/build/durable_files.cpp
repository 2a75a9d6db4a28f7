#include "program/build/durable_files.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"

#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/SHA256.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace symreal::program {
namespace {

[[noreturn]] void give_up(std::string const &path, int reason) {
  fail(DiagnosticId::unwritable_output, {path}, "cannot write '" + path + "': " + std::strerror(reason));
}

// Syncs the directory, without which a new or renamed file may be lost.
void sync_directory_of(std::string const &path) {
  std::string const directory = std::filesystem::path(path).parent_path().string();
  int const descriptor = open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) give_up(directory, errno);
  // Ignores EINVAL: some file systems neither support nor need syncing a directory.
  int const reason = fsync(descriptor) != 0 && errno != EINVAL ? errno : 0;
  close(descriptor);
  if (reason != 0) give_up(directory, reason);
}

// Writes the text and closes the file. Returns 0, or the errno of the failure.
int written(int descriptor, std::string const &text, unsigned permissions) {
  int reason = write_whole(descriptor, text.data(), text.size()) ? 0 : errno;
  if (reason == 0 && (fchmod(descriptor, permissions) != 0 || fsync(descriptor) != 0)) reason = errno;
  if (close(descriptor) != 0 && reason == 0) reason = errno;
  return reason;
}

} // namespace

void write_durably(std::string const &path, std::string const &text, unsigned permissions) {
  int const descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) give_up(path, errno);
  if (int const reason = written(descriptor, text, permissions); reason != 0) give_up(path, reason);
  sync_directory_of(path);
}

unsigned usual_permissions() {
  mode_t const mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

StagedFiles::~StagedFiles() {
  std::error_code ignored;
  for (StagedFile const &one : steps_)
    if (!one.is_done) std::filesystem::remove_all(one.temporary, ignored);
  for (auto one = made_.rbegin(); one != made_.rend(); ++one) rmdir(one->c_str());
}

void StagedFiles::make_directory(std::string const &path) {
  std::filesystem::path at;
  for (std::filesystem::path const &part : std::filesystem::path(path)) {
    at /= part;
    if (mkdir(at.c_str(), 0777) == 0)
      made_.push_back(at.string());
    else if (std::error_code ignored; !std::filesystem::is_directory(at, ignored))
      give_up(path, errno);
  }
}

void StagedFiles::add(std::string const &path, std::string const &text) {
  if (holds(path, text)) return;
  std::string temporary = path + ".XXXXXX";
  int const descriptor = mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0) give_up(path, errno);
  steps_.push_back({temporary, path, Doomed(Doomed::Kind::file, temporary)});
  int const reason = written(descriptor, text, usual_permissions());
  if (reason != 0) give_up(path, reason);
}

std::string StagedFiles::add_directory(std::string const &path) {
  std::string temporary = path + ".XXXXXX";
  if (!mkdtemp(temporary.data())) give_up(path, errno);
  steps_.push_back({temporary, path, Doomed(Doomed::Kind::tree, temporary)});
  if (chmod(temporary.c_str(), usual_permissions() | 0111) != 0) give_up(path, errno);
  return temporary;
}

// Without hard links on the file system, the replaced file is not kept and cannot be restored.
void StagedFiles::take_place(StagedFile &step) {
  struct stat there{};
  std::string const old = step.temporary + "~";
  if (lstat(step.path.c_str(), &there) == 0 && !S_ISDIR(there.st_mode) &&
      linkat(AT_FDCWD, step.path.c_str(), AT_FDCWD, old.c_str(), 0) == 0)
    step.old = old;
  if (rename(step.temporary.c_str(), step.path.c_str()) != 0) give_up(step.path, errno);
  step.is_done = true;
}

void StagedFiles::take_back(StagedFile &step) noexcept {
  std::error_code ignored;
  if (!step.old.empty() && step.is_done)
    std::filesystem::rename(step.old, step.path, ignored);
  else if (!step.old.empty())
    std::filesystem::remove(step.old, ignored);
  else if (step.is_done)
    std::filesystem::remove_all(step.path, ignored);
}

void StagedFiles::commit() {
  Uninterrupted const whole;
  try {
    for (StagedFile &one : steps_) take_place(one);
  } catch (...) {
    for (auto one = steps_.rbegin(); one != steps_.rend(); ++one) take_back(*one);
    throw;
  }
  for (StagedFile const &one : steps_)
    if (!one.old.empty()) unlink(one.old.c_str());
  steps_.clear();
  made_.clear();
}

void rename_durably(std::string const &from, std::string const &to) {
  if (rename(from.c_str(), to.c_str()) != 0) give_up(to, errno);
  sync_directory_of(to);
}

void remove_durably(std::string const &path) {
  if (unlink(path.c_str()) != 0) {
    if (errno == ENOENT) return;
    give_up(path, errno);
  }
  sync_directory_of(path);
}

std::string content_hash(std::string const &text) {
  llvm::SHA256 hash;
  hash.update(text);
  return llvm::toHex(hash.final(), /*LowerCase=*/true);
}

std::string file_hash(std::string const &path) {
  try {
    return content_hash(read_file(path));
  } catch (DiagnosticError const &) {
    return {};
  }
}

} // namespace symreal::program
