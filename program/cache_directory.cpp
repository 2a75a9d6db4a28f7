#include "program/cache_directory.h"

#include <llvm/ADT/SmallString.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/CachePruning.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/xxhash.h>

#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "llvmcache-"; // what llvm::pruneCache takes for an entry
constexpr char const *file_kind = ".o", *text_kind = ".t";
constexpr std::size_t checksum_size = 16;

std::string checksum(std::string_view text) {
  return llvm::utohexstr(llvm::xxh3_64bits(llvm::StringRef(text)), /*LowerCase=*/true, checksum_size);
}

void mark_used(std::string const &entry) { utimensat(AT_FDCWD, entry.c_str(), nullptr, 0); }

} // namespace

std::string CacheDirectory::entry(std::string const &key, char const *kind) const {
  return fmt::format("{}/{}{}{}", path_, prefix, key, kind);
}

// A cache that cannot be written is none.
template <class Write> void CacheDirectory::add(std::string const &entry, Write write) {
  std::error_code error;
  fs::create_directories(path_, error);
  std::string const temporary = fmt::format("{}.{}.{}", entry, getpid(), added_++);
  if (!error) write(temporary, error);
  if (!error) fs::rename(temporary, entry, error);
  if (error) fs::remove(temporary, error);
}

std::optional<std::string> CacheDirectory::find(std::string const &key) {
  if (!exists()) return {};
  std::string const path = entry(key, text_kind);
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.size() < checksum_size) return {};
  std::string_view const rest = std::string_view(text).substr(checksum_size);
  if (checksum(rest) != std::string_view(text).substr(0, checksum_size)) return {};
  mark_used(path);
  return text.erase(0, checksum_size);
}

void CacheDirectory::keep(std::string const &key, std::string const &text) {
  if (!exists()) return;
  add(entry(key, text_kind), [&](std::string const &path, std::error_code &error) {
    std::ofstream file(path, std::ios::binary);
    if (!(file << checksum(text) << text).flush()) error = std::make_error_code(std::errc::io_error);
  });
}

bool CacheDirectory::take_file(std::string const &key, std::string const &to) const {
  if (!exists()) return false;
  std::string const path = entry(key, file_kind);
  std::error_code error;
  if (!fs::copy_file(path, to, fs::copy_options::overwrite_existing, error)) return false;
  mark_used(path);
  return true;
}

bool CacheDirectory::link_file(std::string const &key, std::string const &to) const {
  if (!exists()) return false;
  std::string const path = entry(key, file_kind);
  std::error_code error;
  fs::create_hard_link(path, to, error);
  if (error) return take_file(key, to); // as on another disk
  mark_used(path);
  return true;
}

void CacheDirectory::keep_file(std::string const &key, std::string const &file) {
  if (!exists()) return;
  add(entry(key, file_kind), [&](std::string const &path, std::error_code &error) {
    fs::copy_file(file, path, fs::copy_options::overwrite_existing, error);
  });
}

CacheDirectory::~CacheDirectory() {
  std::error_code error;
  if (added_ == 0 || !fs::is_directory(path_, error)) return;
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
    std::uint64_t const size = entry.file_size(error);
    if (error || !use(entry.path())) continue; // another run has removed it
    ++(entry.path().extension() == file_kind ? contents.files : contents.texts);
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
    return fs::remove(path, error);
  });
}

} // namespace symreal::program
