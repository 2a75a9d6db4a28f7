#include "program/overlay.h"

#include "support/files.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

std::string real_path(std::string const &path) {
  std::error_code error;
  fs::path real = fs::weakly_canonical(path, error);
  return error ? path : real.string();
}

// A name as it stands between the quotes of a #line directive.
std::string quoted(std::string const &name) {
  std::string text = "\"";
  for (char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

std::size_t line_start(std::string const &text, unsigned line) {
  std::size_t start = 0;
  for (; line > 1 && start != text.npos; --line) {
    start = text.find('\n', start);
    if (start != text.npos) ++start;
  }
  return start;
}

// The offset in the original of what stands at `offset` of the rewritten text.
std::size_t original_offset(std::vector<rewrite::Edit> const &edits, std::size_t offset) {
  std::size_t original = offset, written = 0, read = 0;
  for (rewrite::Edit const &edit : edits) {
    std::size_t begin = written + (edit.offset - read); // of the replacement, in the rewritten text
    if (offset < begin) break;
    if (offset < begin + edit.text.size()) return edit.offset + std::min(offset - begin, edit.length);
    written = begin + edit.text.size();
    read = edit.offset + edit.length;
    original = read + (offset - written);
  }
  return original;
}

} // namespace

Overlay::Overlay(rewrite::Result const &rewritten, std::string directory)
    : directory_(std::move(directory)),
      files_(rewritten.files),
      include_dirs_(rewritten.include_dirs) {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    rewrite::File const &file = files_[i];
    std::string path = directory_ + file.path;
    std::error_code ignored; // a directory that cannot be made shows when the file is written
    fs::create_directories(fs::path(path).parent_path(), ignored);
    // A byte order mark is one only at the very beginning.
    std::size_t const mark = file.text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    write_if_changed(path, file.text.substr(0, mark) + "#line 1 " + quoted(file.display_path) + "\n" +
                               file.text.substr(mark));
    by_name_[file.path] = i;
    by_name_[file.display_path] = i;
    by_name_[fs::path(file.display_path).lexically_normal().string()] = i;
  }
}

std::string Overlay::compiled_path(std::string const &source) const { return directory_ + real_path(source); }

std::vector<std::string> Overlay::include_flags() const {
  std::set<std::string> mirrored; // every directory that holds a mirrored file somewhere below it
  for (rewrite::File const &file : files_)
    for (fs::path at = fs::path(file.path).parent_path(); mirrored.insert(at.string()).second; at = at.parent_path()) {
    }

  std::vector<std::string> flags;
  for (std::string const &directory : include_dirs_) {
    std::string real = real_path(directory);
    if (mirrored.contains(real)) flags.insert(flags.end(), {"-I", directory_ + real});
  }
  // A rewritten file may include a file beside it that is outside the roots; last, since it is an exception.
  std::set<std::string> own;
  for (rewrite::File const &file : files_)
    if (own.insert(fs::path(file.path).parent_path().string()).second)
      flags.insert(flags.end(), {"-idirafter", fs::path(file.path).parent_path().string()});
  return flags;
}

rewrite::File const *Overlay::find(std::string const &file) const {
  auto at = by_name_.find(file);
  if (at == by_name_.end()) at = by_name_.find(fs::path(file).lexically_normal().string());
  // Debug information may name a file by its full path.
  if (at == by_name_.end() && file.starts_with('/')) at = by_name_.find(real_path(file));
  if (at == by_name_.end() && file.starts_with(directory_)) at = by_name_.find(file.substr(directory_.size()));
  return at == by_name_.end() ? nullptr : &files_[at->second];
}

Place Overlay::original(Place place) const {
  rewrite::File const *file = find(place.file);
  if (!file) return place;
  place.file = file->display_path;
  std::size_t start = line_start(file->text, place.line);
  std::size_t original_start = line_start(file->original, place.line);
  if (place.line == 0 || place.column == 0 || start == std::string::npos || original_start == std::string::npos)
    return place;
  std::size_t offset = original_offset(file->edits, start + place.column - 1);
  place.column = offset >= original_start ? static_cast<unsigned>(offset - original_start + 1) : 0;
  return place;
}

} // namespace symreal::program
