#include "program/object_cache.h"

#include "program/make_rule.h"
#include "support/files.h"
#include "support/version.h"

#include <llvm/ADT/SmallString.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/CachePruning.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/Program.h>
#include <llvm/Support/SHA256.h>

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::string_view prefix = "llvmcache-"; // what llvm::pruneCache takes for an entry

// Its output depends on more than the words and the text.
bool reads_more(std::string_view word) {
  for (std::string_view start : {"-fplugin", "-fprofile", "-fauto-profile", "-specs", "--specs", "-save-temps", "@"})
    if (word.starts_with(start)) return true;
  return false;
}

std::size_t after(Words const &words, std::string_view option) {
  auto const found = std::find(words.begin(), words.end(), option);
  return found == words.end() || found + 1 == words.end() ? 0 : static_cast<std::size_t>(found - words.begin()) + 1;
}

// What is hashed, without the path of the workspace.
class Key {
public:
  explicit Key(std::string_view workspace) : workspace_(workspace) {}
  void add(std::string_view text) {
    for (std::size_t at; (at = text.find(workspace_)) != text.npos; text.remove_prefix(at + workspace_.size()))
      hash_.update(llvm::StringRef(text.data(), at));
    hash_.update(llvm::StringRef(text.data(), text.size()));
    hash_.update(llvm::StringRef("\0", 1));
  }
  std::string result() { return llvm::toHex(hash_.final(), /*LowerCase=*/true); }

private:
  std::string_view workspace_;
  llvm::SHA256 hash_;
};

// The compiler itself, by path, size and time.
void add_compiler(Key &key, std::string const &name) {
  llvm::ErrorOr<std::string> const path = llvm::sys::findProgramByName(name);
  struct stat status = {};
  if (!path || stat(path->c_str(), &status) != 0) return key.add(name);
  key.add(fmt::format("{} {} {}.{}", *path, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec));
}

// Nothing where the compilation cannot be told by its words and text, or does not begin well.
std::optional<std::string> key_of(Command const &compilation, std::string const &object, std::string const &workspace) {
  Command preprocessing = compilation;
  Words &words = preprocessing.arguments;
  if (std::any_of(words.begin(), words.end(), reads_more)) return {};
  std::string const text = object + ".i", rule = object + ".d";
  words[after(words, "-o")] = text;
  std::replace(words.begin(), words.end(), std::string("-c"), std::string("-E"));
  words.insert(words.end(), {"-MD", "-MF", rule});
  if (!capture(preprocessing).outcome.success()) return {};

  Key key(workspace);
  key.add(version);
  key.add(compilation.directory);
  add_compiler(key, words.front());
  for (std::string const &word : compilation.arguments) key.add(word);
  for (char const *name : {"COMPILER_PATH", "GCC_EXEC_PREFIX", "SOURCE_DATE_EPOCH", "NIX_CFLAGS_COMPILE"})
    if (char const *value = std::getenv(name)) key.add(fmt::format("{}={}", name, value));
  std::string const preprocessed = read_file(text);
  if (preprocessed.find(".incbin") != preprocessed.npos) return {};
  key.add(preprocessed);
  for (std::string const &file : read_make_rule(read_file(rule))) {
    std::string const path = (fs::path(compilation.directory) / file).string();
    if (!fs::is_regular_file(path)) return {};
    key.add(file);
    key.add(read_file(path));
  }
  fs::remove(text);
  fs::remove(rule);
  return key.result();
}

// A reader sees all of it or nothing.
void store(std::string const &object, std::string const &entry) {
  std::error_code error;
  fs::create_directories(fs::path(entry).parent_path(), error);
  std::string const temporary = fmt::format("{}.{}", entry, getpid());
  if (!error) fs::copy_file(object, temporary, fs::copy_options::overwrite_existing, error);
  if (!error) fs::rename(temporary, entry, error);
  if (error) fs::remove(temporary, error); // a cache that cannot be written is none
}

bool take(std::string const &entry, std::string const &object) {
  std::error_code error;
  if (!fs::copy_file(entry, object, fs::copy_options::overwrite_existing, error)) return false;
  utimensat(AT_FDCWD, entry.c_str(), nullptr, 0); // used now
  return true;
}

} // namespace

Captured ObjectCache::compile(Command const &compilation, std::string const &workspace) {
  std::string const &object = compilation.arguments[after(compilation.arguments, "-o")];
  std::optional<std::string> const key = directory_.empty() ? std::nullopt : key_of(compilation, object, workspace);
  std::string const entry = key ? fmt::format("{}/{}{}.o", directory_, prefix, *key) : "";
  if (key && take(entry, object)) {
    ++reused_;
    return {{Ending::exited, 0, 0}, {}};
  }
  Captured result = capture(compilation);
  ++compiled_;
  if (key && result.outcome.success()) store(object, entry);
  return result;
}

void ObjectCache::prune(std::uint64_t most_bytes) const {
  std::error_code error;
  if (compiled_ == 0 || directory_.empty() || !fs::is_directory(directory_, error)) return;
  llvm::CachePruningPolicy policy;
  policy.Interval = std::chrono::seconds(0);
  policy.Expiration = std::chrono::hours(24 * 30);
  policy.MaxSizePercentageOfAvailableSpace = 10;
  policy.MaxSizeBytes = most_bytes;
  llvm::pruneCache(directory_, policy);
}

std::string cache_directory() {
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
    ++contents.objects;
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
