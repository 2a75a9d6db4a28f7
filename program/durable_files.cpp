#include "program/durable_files.h"

#include "diagnostics/diagnostic.h"
#include "support/files.h"

#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/SHA256.h>

#include <cerrno>
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

// The directory knows about its files only then.
void sync_directory_of(std::string const &path) {
  std::string const directory = std::filesystem::path(path).parent_path().string();
  int const descriptor = open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) give_up(directory, errno);
  // Some file systems cannot sync a directory; they have nothing to sync there.
  int const reason = fsync(descriptor) != 0 && errno != EINVAL ? errno : 0;
  close(descriptor);
  if (reason != 0) give_up(directory, reason);
}

} // namespace

void write_durably(std::string const &path, std::string const &text, unsigned permissions) {
  int const descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) give_up(path, errno);
  int reason = write_whole(descriptor, text.data(), text.size()) ? 0 : errno;
  if (reason == 0 && (fchmod(descriptor, permissions) != 0 || fsync(descriptor) != 0)) reason = errno;
  if (close(descriptor) != 0 && reason == 0) reason = errno;
  if (reason != 0) give_up(path, reason);
  sync_directory_of(path);
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
