#include "program/build/cache_directory.h"

#include "engine/support/files.h"
#include "engine/support/mutation/is_dropped.h"
#include "program/build/compiled_from.h"

#include <llvm/ADT/SmallString.h>
#include <llvm/Support/CachePruning.h>
#include <llvm/Support/Path.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "llvmcache-"; // prefix of the entries that llvm::pruneCache manages
constexpr char const *file_kind = ".file", *text_kind = ".text";

void mark_used(std::string const &entry) { utimensat(AT_FDCWD, entry.c_str(), nullptr, 0); }

// Hash at the head of an entry. It covers the key, since an entry under another key is as wrong as other content.
std::string hash_of(std::string_view key, std::string_view text) {
  return rewrite::content_id(std::string(key) + '\0' + std::string(text));
}

// Precompiled headers take tens of megabytes, so files are read piecewise into one buffer.
constexpr std::size_t piece_size = std::size_t{1} << 20;

struct Read {
  bool exists = true;
  bool is_whole = false; // owned by this user and read completely
};

// Reads an entry if it is a regular file of this user; never blocks. Calls `use` with each piece.
template <class Use> Read read_entry(std::string const &path, Use use) {
  int const descriptor = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return {errno != ENOENT && errno != ENOTDIR, false};
  struct stat status{};
  bool good = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid();
  std::size_t left = good ? static_cast<std::size_t>(status.st_size) : 0;
  std::string piece;
  while (good && left > 0) {
    piece.resize(std::min(left, piece_size));
    for (std::size_t at = 0; good && at < piece.size();) {
      ssize_t const got = read(descriptor, piece.data() + at, piece.size() - at);
      good = got > 0 || (got < 0 && errno == EINTR);
      if (got > 0) at += static_cast<std::size_t>(got);
    }
    left -= piece.size();
    if (good) use(std::string_view(piece));
  }
  close(descriptor);
  return {true, good};
}

// Hash of a file's contents.
class FileId {
public:
  void add(std::string_view piece) { of_pieces_ += rewrite::content_id(piece); }
  std::string result() const { return rewrite::content_id(of_pieces_); }

private:
  std::string of_pieces_;
};

// A file that is created and must not exist before.
class NewFile {
public:
  explicit NewFile(std::string const &path)
      : descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600)),
        good_(descriptor_ >= 0) {}
  ~NewFile() { end(); }
  NewFile(NewFile const &) = delete;
  NewFile &operator=(NewFile const &) = delete;

  void add(std::string_view text) { good_ = good_ && write_whole(descriptor_, text.data(), text.size()); }
  // Closes the file; false if not all of it was written.
  bool end() {
    if (descriptor_ >= 0) good_ = close(std::exchange(descriptor_, -1)) == 0 && good_;
    return good_;
  }

private:
  int descriptor_;
  bool good_;
};

} // namespace

std::string CacheDirectory::entry(std::string const &key, char const *kind) const {
  return fmt::format("{}/{}{}{}", path_, prefix, key, kind);
}

void CacheDirectory::tell_damaged(std::string const &entry) const {
  if (damaged_) damaged_(entry);
}

std::string CacheDirectory::temporary() {
  std::error_code error;
  fs::create_directories(path_, error);
  return entry(fmt::format("new.{}.{}", getpid(), added_++), "");
}

// Moves an entry into place; a cache that cannot be written is ignored.
bool CacheDirectory::place(std::string const &temporary, bool is_written, std::string const &entry) {
  std::error_code error;
  if (is_written && fs::is_directory(fs::symlink_status(entry, error))) rmdir(entry.c_str());
  error.clear();
  if (is_written) fs::rename(temporary, entry, error);
  bool const is_placed = is_written && !error;
  if (!is_placed) unlink(temporary.c_str());
  return is_placed;
}

std::optional<std::string> CacheDirectory::find(std::string const &key) {
  if (!exists()) return {};
  std::string const path = entry(key, text_kind);
  std::string text;
  Read const read = read_entry(path, [&](std::string_view piece) { text += piece; });
  if (!read.exists) return {};
  std::size_t const size = hash_of({}, {}).size();
  bool const is_whole = read.is_whole && text.size() >= size;
  if (!is_whole ||
      (hash_of(key, std::string_view(text).substr(size)) != text.substr(0, size) && !is_dropped("SYM189"))) {
    tell_damaged(path);
    return {};
  }
  mark_used(path);
  return text.erase(0, size);
}

void CacheDirectory::keep(std::string const &key, std::string const &text) {
  if (!exists()) return;
  std::string const made = temporary();
  NewFile file(made);
  file.add(hash_of(key, text));
  file.add(text);
  place(made, file.end(), entry(key, text_kind));
}

// A file entry is named by its content id, which a text entry under the key holds.
template <class Use> std::optional<std::string> CacheDirectory::find_file(std::string const &key, Use use) {
  std::optional<std::string> const id = find(key);
  if (!id) return {};
  std::string path = entry(*id, file_kind);
  FileId now;
  Read const read = read_entry(path, [&](std::string_view piece) {
    now.add(piece);
    use(piece);
  });
  if (!read.exists) return {};
  if (!read.is_whole || (now.result() != *id && !is_dropped("SYM189"))) {
    tell_damaged(path);
    return {};
  }
  mark_used(path);
  return path;
}

bool CacheDirectory::take_file(std::string const &key, std::string const &to) {
  std::optional<NewFile> file;
  auto const found = find_file(key, [&](std::string_view piece) {
    if (!file) {
      unlink(to.c_str());
      file.emplace(to);
    }
    file->add(piece);
  });
  bool const is_taken = found && file && file->end();
  if (file && !is_taken) unlink(to.c_str());
  return is_taken;
}

bool CacheDirectory::link_file(std::string const &key, std::string const &to) {
  std::optional<std::string> const found = find_file(key, [](std::string_view) {});
  if (!found) return false;
  std::error_code error;
  fs::create_hard_link(*found, to, error);
  if (error) fs::create_symlink(fs::absolute(*found), to, error); // a hard link fails across disks
  return !error;
}

void CacheDirectory::keep_file(std::string const &key, std::string const &file) {
  if (!exists()) return;
  std::string const made = temporary();
  NewFile copy(made);
  FileId id;
  Read const read = read_entry(file, [&](std::string_view piece) {
    id.add(piece);
    copy.add(piece);
  });
  if (place(made, copy.end() && read.is_whole, entry(id.result(), file_kind))) keep(key, id.result());
}

CacheDirectory::~CacheDirectory() {
  std::error_code error;
  if (added_ == 0 || !fs::is_directory(path_, error)) return;
  // A named pipe in place of this file would block llvm::pruneCache.
  fs::file_status const stamp = fs::symlink_status(path_ + "/llvmcache.timestamp", error);
  if (fs::exists(stamp) && !fs::is_regular_file(stamp)) return;
  llvm::CachePruningPolicy policy;
  policy.Interval = std::chrono::minutes(1); // pruning visits each entry, which takes longer than a link step
  policy.Expiration = std::chrono::hours(24 * 30);
  policy.MaxSizePercentageOfAvailableSpace = 10;
  policy.MaxSizeBytes = most_bytes_;
  llvm::pruneCache(path_, policy);
}

std::string usual_cache_directory() {
  llvm::SmallString<128> directory;
  if (!llvm::sys::path::cache_directory(directory)) return {};
  llvm::sys::path::append(directory, "symreal");
  return std::string(directory);
}

namespace {

template <class Use> CacheContents for_each_entry(std::string const &directory, Use use) {
  CacheContents contents;
  std::error_code error;
  if (directory.empty() || !fs::is_directory(directory, error)) return contents;
  for (fs::directory_entry const &entry : fs::directory_iterator(directory)) {
    if (!entry.path().filename().string().starts_with(prefix)) continue;
    bool const is_file = entry.is_regular_file(error) && !entry.is_symlink(error);
    std::uint64_t const size = is_file ? entry.file_size(error) : 0;
    if (error || !use(entry.path())) continue; // another run has removed it
    if (is_file) ++(entry.path().extension() == file_kind ? contents.files : contents.texts);
    contents.bytes += size;
  }
  return contents;
}

} // namespace

CacheContents cache_contents(std::string const &directory) {
  return for_each_entry(directory, [](fs::path const &) { return true; });
}

CacheContents clear_cache(std::string const &directory) {
  return for_each_entry(directory, [](fs::path const &path) {
    std::error_code error;
    return fs::remove_all(path, error) != 0;
  });
}

} // namespace symreal::program
