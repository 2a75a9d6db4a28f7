#include "program/cache_directory.h"

#include "program/compiled_from.h"
#include "support/files.h"
#include "support/mutation/is_dropped.h"

#include <llvm/ADT/SmallString.h>
#include <llvm/Support/CachePruning.h>
#include <llvm/Support/Path.h>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "llvmcache-"; // what llvm::pruneCache takes for an entry
constexpr char const *file_kind = ".file", *text_kind = ".text";

void mark_used(std::string const &entry) { utimensat(AT_FDCWD, entry.c_str(), nullptr, 0); }

// The head of an entry. The key counts, since an entry under another name is as wrong as another content.
std::string hash_of(std::string_view key, std::string_view text) {
  return content_id(std::string(key) + '\0' + std::string(text));
}

struct Read {
  bool exists = true;
  std::optional<std::string> text; // of a file that can be taken
};

// Opens nothing else than a file of this user, and waits for nothing.
Read read_entry(std::string const &path) {
  int const descriptor = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return {errno != ENOENT && errno != ENOTDIR, {}};
  struct stat status{};
  bool good = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid();
  std::string text(good ? static_cast<std::size_t>(status.st_size) : 0, '\0');
  for (std::size_t at = 0; good && at < text.size();) {
    ssize_t const got = read(descriptor, text.data() + at, text.size() - at);
    good = got > 0 || (got < 0 && errno == EINTR);
    if (got > 0) at += static_cast<std::size_t>(got);
  }
  close(descriptor);
  return {true, good ? std::optional(std::move(text)) : std::nullopt};
}

bool write_entry(std::string const &path, std::string_view start, std::string_view text) {
  int const descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) return false;
  bool const good =
      write_whole(descriptor, start.data(), start.size()) && write_whole(descriptor, text.data(), text.size());
  return close(descriptor) == 0 && good;
}

} // namespace

std::string CacheDirectory::entry(std::string const &key, char const *kind) const {
  return fmt::format("{}/{}{}{}", path_, prefix, key, kind);
}

void CacheDirectory::tell_damaged(std::string const &entry) const {
  if (damaged_) damaged_(entry);
}

// A cache that cannot be written is none.
bool CacheDirectory::add(std::string const &entry, std::string_view start, std::string_view text) {
  std::error_code error;
  fs::create_directories(path_, error);
  std::string const temporary = fmt::format("{}.{}.{}", entry, getpid(), added_++);
  if (!error && !write_entry(temporary, start, text)) error = std::make_error_code(std::errc::io_error);
  if (fs::is_directory(fs::symlink_status(entry, error))) rmdir(entry.c_str());
  error.clear();
  fs::rename(temporary, entry, error);
  if (error) unlink(temporary.c_str());
  return !error;
}

std::optional<std::string> CacheDirectory::find(std::string const &key) {
  if (!exists()) return {};
  std::string const path = entry(key, text_kind);
  auto [is_there, text] = read_entry(path);
  if (!is_there) return {};
  std::size_t const size = hash_of({}, {}).size();
  bool const is_whole = text && text->size() >= size;
  if (!is_whole ||
      (hash_of(key, std::string_view(*text).substr(size)) != text->substr(0, size) && !is_dropped("SYM189"))) {
    tell_damaged(path);
    return {};
  }
  mark_used(path);
  return text->erase(0, size);
}

void CacheDirectory::keep(std::string const &key, std::string const &text) {
  if (exists()) add(entry(key, text_kind), hash_of(key, text), text);
}

// The hash of a file is the name of its entry, and a text under the key says it.
std::optional<CacheDirectory::Found> CacheDirectory::find_file(std::string const &key) {
  std::optional<std::string> const hash = find(key);
  if (!hash) return {};
  std::string const path = entry(*hash, file_kind);
  auto [is_there, bytes] = read_entry(path);
  if (!is_there) return {};
  if (!bytes || (content_id(*bytes) != *hash && !is_dropped("SYM189"))) {
    tell_damaged(path);
    return {};
  }
  mark_used(path);
  return Found{path, std::move(*bytes)};
}

bool CacheDirectory::take_file(std::string const &key, std::string const &to) {
  std::optional<Found> const found = find_file(key);
  if (!found) return false;
  unlink(to.c_str());
  return write_entry(to, {}, found->bytes);
}

bool CacheDirectory::link_file(std::string const &key, std::string const &to) {
  std::optional<Found> const found = find_file(key);
  if (!found) return false;
  std::error_code error;
  fs::create_hard_link(found->path, to, error);
  return !error || write_entry(to, {}, found->bytes); // as on another disk
}

void CacheDirectory::keep_file(std::string const &key, std::string const &file) {
  if (!exists()) return;
  std::optional<std::string> const bytes = read_entry(file).text;
  if (!bytes) return;
  std::string const hash = content_id(*bytes);
  if (add(entry(hash, file_kind), {}, *bytes)) keep(key, hash);
}

CacheDirectory::~CacheDirectory() {
  std::error_code error;
  if (added_ == 0 || !fs::is_directory(path_, error)) return;
  // llvm::pruneCache would wait for a pipe of this name.
  fs::file_status const stamp = fs::symlink_status(path_ + "/llvmcache.timestamp", error);
  if (fs::exists(stamp) && !fs::is_regular_file(stamp)) return;
  llvm::CachePruningPolicy policy;
  policy.Interval = std::chrono::seconds(0);
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
