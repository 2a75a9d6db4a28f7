#include "program/build/compiled_from.h"

#include "engine/support/files.h"
#include "program/build/inclusion_lookups.h"
#include "rewrite/facts/bytes.h"

#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/xxhash.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace symreal::program {

template <class Take> void visit(Take &take, CompiledFrom &object) {
  auto &[files, directories, names, absent] = object;
  take(files, directories, names, absent);
}

namespace {

namespace fs = std::filesystem;

std::string shortened(std::string const &path, std::string const &workspace) {
  return path.starts_with(workspace) ? "@" + path.substr(workspace.size()) : path;
}
std::string lengthened(std::string const &path, std::string const &workspace) {
  return path.starts_with('@') ? workspace + path.substr(1) : path;
}

std::optional<std::string> text_of(std::string const &path) {
  auto const buffer = llvm::MemoryBuffer::getFile(path);
  return buffer ? std::optional((*buffer)->getBuffer().str()) : std::nullopt;
}

// Numbers texts in order of first occurrence.
class Numbered {
public:
  explicit Numbered(std::vector<std::string> &all) : all_(all) {}
  std::size_t operator()(std::string const &text) {
    auto const [at, is_new] = numbers_.try_emplace(text, all_.size());
    if (is_new) all_.push_back(text);
    return at->second;
  }

private:
  std::vector<std::string> &all_;
  std::map<std::string, std::size_t> numbers_;
};

// Records where a compiler looks for a name: beside the including text, if quoted, and in all search directories, since
// #include_next continues past the first match.
class Search {
public:
  Search(CompiledFrom &result, std::string const &base, std::vector<std::string> const &directories,
         std::string const &workspace)
      : result_(result),
        base_(base),
        workspace_(workspace),
        directory_(result.directories),
        name_(result.names),
        directories_(directories) {}

  void look(Inclusion const &inclusion, std::string const &beside) {
    if (inclusion.name.starts_with('/')) return look_in("", inclusion.name);
    if (inclusion.quoted) look_in(beside, inclusion.name);
    if (!looked_for_.insert(inclusion.name).second) return;
    for (std::string const &directory : directories_) look_in(directory, inclusion.name);
  }

private:
  void look_in(std::string const &directory, std::string const &name) {
    fs::path const path = fs::path(base_) / directory / name;
    std::error_code error;
    if (fs::exists(path, error)) return;
    std::string const full = directory.empty() ? "" : (fs::path(base_) / directory).string();
    std::pair const place{directory_(shortened(full, workspace_)), name_(name)};
    if (known_.insert(place).second) result_.absent.push_back(place);
  }

  CompiledFrom &result_;
  std::string const &base_, &workspace_;
  Numbered directory_, name_;
  std::vector<std::string> const &directories_;
  std::set<std::string> looked_for_;
  std::set<std::pair<std::size_t, std::size_t>> known_;
};

} // namespace

std::string content_id(std::string_view text) {
  llvm::XXH128_hash_t const hash = llvm::xxh3_128bits(llvm::arrayRefFromStringRef(llvm::StringRef(text)));
  return llvm::utohexstr(hash.high64, /*LowerCase=*/true, 16) + llvm::utohexstr(hash.low64, /*LowerCase=*/true, 16);
}

std::string const &FilesNow::content_id(std::string const &path) {
  {
    std::lock_guard const lock(mutex_);
    if (auto const known = ids_.find(path); known != ids_.end()) return known->second;
  }
  std::optional<std::string> const text = text_of(path);
  std::string id = text ? program::content_id(*text) : "";
  std::lock_guard const lock(mutex_);
  return ids_.try_emplace(path, std::move(id)).first->second;
}

bool FilesNow::exists(std::string const &path) {
  std::lock_guard const lock(mutex_);
  auto const [at, is_new] = exist_.try_emplace(path);
  std::error_code error;
  if (is_new) at->second = fs::exists(path, error);
  return at->second;
}

bool CompiledFrom::still_holds(FilesNow &now, std::string const &workspace) const {
  return std::all_of(files.begin(), files.end(),
                     [&](auto const &one) { return now.content_id(lengthened(one.first, workspace)) == one.second; }) &&
         std::none_of(absent.begin(), absent.end(), [&](auto const &place) {
           return now.exists(lengthened(directories[place.first], workspace) + "/" + names[place.second]);
         });
}

std::optional<CompiledFrom> compiled_from(Command const &compilation, std::vector<std::string> const &files,
                                          std::string_view messages, std::string const &workspace) {
  std::string const base = compilation.directory.empty() ? fs::current_path().string() : compilation.directory;
  std::vector<std::string> const directories = searched_directories(messages);
  if (directories.empty()) return {};
  CompiledFrom result;
  Search search(result, base, directories, workspace);
  std::vector<std::string> const &words = compilation.arguments;
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == "-include" || words[i] == "-imacros") search.look({words[i + 1], true}, ".");
  std::vector<std::string> texts;
  std::set<std::string> macros;
  for (std::string const &file : files) {
    std::string const path = (fs::path(base) / file).string();
    std::optional<std::string> text = text_of(path);
    if (!text) return {};
    if (!result.files.try_emplace(shortened(path, workspace), program::content_id(*text)).second) continue;
    auto const inclusions = inclusions_of(*text);
    if (!inclusions) return {};
    for (Inclusion const &one : inclusions->names) search.look(one, fs::path(file).parent_path().string());
    macros.insert(inclusions->macros.begin(), inclusions->macros.end());
    texts.push_back(std::move(*text));
  }
  // An inclusion by a macro is ignored if nothing defines the macro.
  for (std::string const &macro : macros) {
    auto const names_it = [&](std::string const &word) { return word.find(macro) != word.npos; };
    auto const defines_it = [&](std::string const &text) { return defines(text, macro); };
    if (std::any_of(words.begin(), words.end(), names_it) || std::any_of(texts.begin(), texts.end(), defines_it))
      return {};
  }
  return result;
}

std::string to_bytes(CompiledFrom from, std::string object) {
  rewrite::Write write;
  write(from, object);
  return write.result();
}

std::optional<std::pair<CompiledFrom, std::string>> compiled_from_bytes(std::string_view bytes) {
  rewrite::Read read(bytes);
  std::pair<CompiledFrom, std::string> both;
  read(both.first, both.second);
  auto const &[from, object] = both;
  bool const good = read.is_complete() && std::all_of(from.absent.begin(), from.absent.end(), [&](auto const &place) {
                      return place.first < from.directories.size() && place.second < from.names.size();
                    });
  return good ? std::optional(std::move(both)) : std::nullopt;
}

} // namespace symreal::program
