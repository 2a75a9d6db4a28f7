#include "program/build/overlay.h"

#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "rewrite/request/driver_options.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>
#include <filesystem>
#include <llvm/ADT/SmallVector.h>
#include <llvm/ADT/StringRef.h>
#include <llvm/Support/Regex.h>
#include <set>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

std::string real_path(std::string const &path) {
  std::error_code error;
  fs::path real = fs::weakly_canonical(path, error);
  return error ? path : real.string();
}

std::size_t line_start(std::string const &text, unsigned line) {
  std::size_t start = 0;
  for (; line > 1 && start != text.npos; --line) {
    start = text.find('\n', start);
    if (start != text.npos) ++start;
  }
  return start;
}

// Original offset of a character of an edit's text: repeated original text before or behind the insertion keeps its
// place, all else maps to the beginning.
std::size_t original_offset(rewrite::Edit const &edit, std::string const &original, std::size_t within) {
  std::string const replaced = original.substr(edit.offset, edit.length);
  std::size_t const behind = edit.text.size() - std::min(edit.text.size(), replaced.size());
  if (edit.text.ends_with(replaced)) return edit.offset + (within < behind ? 0 : within - behind);
  if (edit.text.starts_with(replaced)) return edit.offset + std::min(within, edit.length - 1);
  return edit.offset;
}

// Original offset of the character at `offset` of the rewritten text.
std::size_t original_offset(rewrite::File const &file, std::size_t offset) {
  std::size_t original = offset, written = 0, read = 0;
  for (rewrite::Edit const &edit : file.edits) {
    std::size_t begin = written + (edit.offset - read); // begin of the replacement in the rewritten text
    if (offset < begin) break;
    if (offset < begin + edit.text.size()) return original_offset(edit, file.original, offset - begin);
    written = begin + edit.text.size();
    read = edit.offset + edit.length;
    original = read + (offset - written);
  }
  return original;
}

} // namespace

Overlay::Overlay(rewrite::Result const &rewritten, std::string directory, std::set<std::string> c_sources)
    : directory_(std::move(directory)),
      files_(rewritten.files),
      include_dirs_(rewritten.include_dirs),
      c_sources_(std::move(c_sources)) {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    rewrite::File const &file = files_[i];
    by_name_[file.path] = i;
    by_name_[file.compiled_name] = i;
    by_name_[file.display_path] = i;
    by_name_[fs::path(file.display_path).lexically_normal().string()] = i;
  }
  for (rewrite::File const &file : files_) write(file);
  link_neighbours(rewritten, directory_);
}

void Overlay::write(rewrite::File const &file) const {
  std::string const path = directory_ + file.path;
  std::error_code ignored; // a failure shows when the file is written
  fs::create_directories(fs::path(path).parent_path(), ignored);
  // Keeps a byte order mark at the very beginning.
  std::size_t const mark = file.text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  std::string const linkage = c_sources_.contains(file.path) ? "extern \"C\" {\n" : "";
  write_if_changed(path, file.text.substr(0, mark) + linkage + "#line 1 " + in_quotes(file.compiled_name) + "\n" +
                             redirected(file.text.substr(mark)) + (linkage.empty() ? "" : "\n}\n"));
  // Lets an including file find a symbolic link to the file beside itself.
  fs::path const named(file.compiled_name);
  std::string const link = directory_ + real_path(named.parent_path() / "") + "/" + named.filename().string();
  if (link == path || fs::exists(fs::symlink_status(link, ignored))) return;
  fs::create_directories(fs::path(link).parent_path(), ignored);
  fs::create_symlink(path, link, ignored);
}

// Redirects #includes with absolute paths to the overlay.
std::string Overlay::redirected(std::string const &text) const {
  llvm::Regex const include("^([ \t]*#[ \t]*include[ \t]*[\"<])(/[^\">\n]*)");
  if (text.find("\"/") == text.npos && text.find("</") == text.npos) return text;
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    std::string const line = text.substr(begin, end - begin);
    llvm::SmallVector<llvm::StringRef> found;
    rewrite::File const *file = nullptr;
    if (line.find("include") != line.npos && include.match(line, &found)) file = find(found[2].str());
    result += file ? found[1].str() + directory_ + file->path + line.substr(found[0].size()) : line;
    begin = end;
  }
  return result;
}

std::optional<std::string> Overlay::counterpart(std::string const &name) const {
  std::string const path = directory_ + real_path(name);
  std::error_code error;
  return fs::exists(path, error) ? std::optional(path) : std::nullopt;
}

std::string Overlay::compiled_path(std::string const &source) const { return directory_ + real_path(source); }

std::vector<std::string> Overlay::search_flags(std::vector<std::string> const &flags,
                                               std::string const &directory) const {
  std::vector<std::string> named;
  std::vector<std::string> words = program::search_flags(
      flags, [&](std::string const &name) { return counterpart(fs::path(directory) / name); }, named);
  std::set<std::string> searched; // a repeated directory would be searched only at its last position
  for (std::string const &one : named) searched.insert(real_path(fs::path(directory) / one));
  // Directories from the environment (CPATH) and the compiler follow -I; the originals come last, for files that are
  // not beside the rewritten ones.
  for (std::string const &one : include_dirs_)
    if (auto const found = counterpart(one); found && searched.insert(real_path(one)).second)
      words.insert(words.end(), {"-I", *found});
  for (rewrite::File const &file : files_)
    if (searched.insert(fs::path(file.path).parent_path().string()).second)
      words.insert(words.end(), {"-idirafter", fs::path(file.path).parent_path().string()});
  words.push_back("-ffile-prefix-map=" + directory_ + "=");
  return words;
}

bool Overlay::contains(std::string const &file) const {
  if (!directory_.empty()) return find(file) != nullptr;
  return !file.starts_with("/usr/") && !file.starts_with(runtime_include()) && file.find("/runtime/") == file.npos;
}

rewrite::File const *Overlay::find(std::string const &file) const {
  auto at = by_name_.find(file);
  if (at == by_name_.end()) at = by_name_.find(fs::path(file).lexically_normal().string());
  // Debug information may give a file's full path.
  if (at == by_name_.end() && file.starts_with('/')) at = by_name_.find(real_path(file));
  if (at == by_name_.end() && file.starts_with(directory_)) at = by_name_.find(file.substr(directory_.size()));
  return at == by_name_.end() ? nullptr : &files_[at->second];
}

Place Overlay::original(Place place) const {
  rewrite::File const *file = find(place.file);
  if (directory_.empty()) place.column = 0;
  if (!file) return place;
  place.file = file->display_path;
  return original_place(*file, std::move(place));
}

Place original_place(rewrite::File const &file, Place place) {
  std::size_t start = line_start(file.text, place.line);
  std::size_t original_start = line_start(file.original, place.line);
  if (place.line == 0 || place.column == 0 || start == std::string::npos || original_start == std::string::npos)
    return place;
  std::size_t offset = original_offset(file, start + place.column - 1);
  place.column = offset >= original_start ? static_cast<unsigned>(offset - original_start + 1) : 0;
  return place;
}

void link_neighbours(rewrite::Result const &rewritten, std::string const &top) {
  std::set<fs::path> directories;
  for (rewrite::File const &file : rewritten.files) directories.insert(fs::path(file.path).parent_path());
  for (fs::path const &directory : directories) {
    std::error_code unreadable, exists;
    for (fs::directory_entry const &one : fs::directory_iterator(directory, unreadable))
      fs::create_symlink(one.path(), top + one.path().string(), exists);
  }
}

std::vector<std::string>
search_flags(std::vector<std::string> const &flags,
             std::function<std::optional<std::string>(std::string const &name)> const &counterpart,
             std::vector<std::string> &searched) {
  std::vector<std::string> words;
  for (rewrite::DriverOption const &option : rewrite::driver_options(flags))
    if (option.about == rewrite::About::headers) {
      words.insert(words.end(), {option.name, counterpart(option.value).value_or(option.value)});
    } else if (option.about == rewrite::About::directories) {
      searched.push_back(option.value);
      if (auto const found = counterpart(option.value)) words.insert(words.end(), {option.name, *found});
      words.insert(words.end(), {option.name, option.value});
    } else
      rewrite::append(words, option, flags);
  return words;
}

} // namespace symreal::program
