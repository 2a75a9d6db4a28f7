#include "program/build/tree_edit.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "program/build/durable_files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Entry {
  std::string path, temporary, old_hash, new_hash;
};

struct Journal {
  unsigned number = 0;
  bool is_undo = false;
  std::vector<Entry> entries; // the original of entry i is N/i
};

Json to_json(Journal const &journal) {
  Json entries = Json::array();
  for (Entry const &one : journal.entries)
    entries.push_back({{"path", one.path}, {"temporary", one.temporary}, {"old", one.old_hash}, {"new", one.new_hash}});
  return {{"number", journal.number}, {"undo", journal.is_undo}, {"files", entries}};
}

Journal read_journal(std::string const &path) {
  try {
    Json const json = Json::parse(read_file(path));
    Journal journal{json.at("number"), json.at("undo"), {}};
    for (Json const &one : json.at("files"))
      journal.entries.push_back({one.at("path"), one.at("temporary"), one.at("old"), one.at("new")});
    return journal;
  } catch (Json::exception const &) {
    fail(DiagnosticId::undo_refused, {path}, "this file is not the journal of an edit");
  }
}

// Is the path now a link? Renaming would replace the link, not the file.
bool became_link(std::string const &path) {
  std::error_code error;
  fs::path const real = fs::canonical(path, error);
  return !error && real != path;
}

// The directory `.symreal`, locked by one process at a time.
class State {
public:
  explicit State(std::string directory) : directory_(std::move(directory)) {
    if (mkdir(directory_.c_str(), 0777) != 0 && errno != EEXIST)
      fail(DiagnosticId::unwritable_output, {directory_}, "cannot write '" + directory_ + "': " + std::strerror(errno));
    lock_ = open(file("lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock_ < 0)
      fail(DiagnosticId::unwritable_output, {directory_},
           "cannot write '" + file("lock") + "': " + std::strerror(errno));
    if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
      close(lock_);
      fail(DiagnosticId::undo_refused, {directory_}, "another process edits this tree");
    }
  }
  ~State() {
    if (lock_ >= 0) close(lock_);
  }
  State(State const &) = delete;
  State &operator=(State const &) = delete;

  std::string file(std::string const &name) const { return directory_ + "/" + name; }
  std::string manifest(unsigned number) const { return file(std::to_string(number) + ".json"); }
  std::string original(unsigned number, std::size_t index) const {
    return file(std::to_string(number)) + "/" + std::to_string(index);
  }
  // Number of the last edit; 0 before the first.
  unsigned last() const {
    unsigned number = 0;
    while (fs::exists(manifest(number + 1))) ++number;
    return number;
  }

  Recovery recover() {
    if (fs::exists(file("committed.json"))) {
      Journal const journal = read_journal(file("committed.json"));
      complete(journal);
      return journal.is_undo ? Recovery::undone : Recovery::completed;
    }
    if (!fs::exists(file("prepared.json"))) {
      remove_durably(file("new.json")); // leftover of a process that had changed nothing yet
      return Recovery::nothing;
    }
    Journal const journal = read_journal(file("prepared.json"));
    take_back(journal);
    return journal.is_undo ? Recovery::not_undone : Recovery::taken_back;
  }

  void carry_out(Journal const &journal, std::vector<Replacement> const &replacements) {
    write_durably(file("new.json"), to_json(journal).dump(1) + "\n", 0644);
    rename_durably(file("new.json"), file("prepared.json"));
    try {
      if (!journal.is_undo) fs::create_directory(file(std::to_string(journal.number)));
      for (std::size_t i = 0; i < replacements.size(); ++i) {
        struct stat status{};
        if (stat(replacements[i].path.c_str(), &status) != 0) status.st_mode = 0644;
        if (!journal.is_undo) write_durably(original(journal.number, i), replacements[i].original, 0644);
        write_durably(journal.entries[i].temporary, replacements[i].text, status.st_mode & 07777);
      }
      for (Entry const &one : journal.entries) require_content(one.path, one.old_hash);
    } catch (...) {
      take_back(journal);
      throw;
    }
    rename_durably(file("prepared.json"), file("committed.json"));
    complete(journal);
  }

  static void require_content(std::string const &path, std::string const &hash) {
    if (file_hash(path) != hash) fail(DiagnosticId::changed_file, {path}, "another process changed this file");
  }

  // Removes the directory if nothing is left to undo.
  void remove_if_empty() {
    if (last() != 0) return;
    remove_durably(file("lock"));
    std::error_code ignored; // the user may have put files there
    fs::remove(directory_, ignored);
  }

private:
  void complete(Journal const &journal) {
    for (Entry const &one : journal.entries)
      if (fs::exists(one.temporary)) {
        require_content(one.path, one.old_hash);
        if (became_link(one.path))
          fail(DiagnosticId::changed_file, {one.path}, "a link has taken the place of this file");
        rename_durably(one.temporary, one.path);
      }
    if (!journal.is_undo) {
      rename_durably(file("committed.json"), manifest(journal.number));
      return;
    }
    remove_durably(manifest(journal.number));
    fs::remove_all(file(std::to_string(journal.number)));
    remove_durably(file("committed.json"));
  }

  void take_back(Journal const &journal) {
    for (Entry const &one : journal.entries) remove_durably(one.temporary);
    if (!journal.is_undo) fs::remove_all(file(std::to_string(journal.number)));
    remove_durably(file("prepared.json"));
  }

  std::string directory_;
  int lock_ = -1;
};

std::string temporary_name(std::string const &path) {
  fs::path const file(path);
  return (file.parent_path() / ("." + file.filename().string() + ".symreal-new")).string();
}

void require_replaceable(Replacement const &one) {
  struct stat file{}, directory{};
  std::string const parent = fs::path(one.path).parent_path().string();
  if (stat(one.path.c_str(), &file) != 0 || stat(parent.c_str(), &directory) != 0)
    fail(DiagnosticId::changed_file, {one.path}, "this file no longer exists");
  // Respects read-only permissions, even for users whom they do not bind (root).
  bool const read_only = (file.st_mode & 0222) == 0 || (directory.st_mode & 0222) == 0;
  if (read_only || access(one.path.c_str(), W_OK) != 0 || access(parent.c_str(), W_OK) != 0)
    fail(DiagnosticId::unwritable_output, {one.path},
         "cannot write '" + one.path + "': it or its directory is read-only");
  if (file.st_nlink > 1)
    fail(DiagnosticId::hard_link, {one.path}, "this file has another name, a hard link, which would keep the old text");
  State::require_content(one.path, content_hash(one.original));
}

std::optional<std::string> find_state(std::string const &directory) {
  std::error_code ignored;
  for (fs::path at = fs::weakly_canonical(fs::absolute(directory), ignored);; at = at.parent_path()) {
    if (fs::is_directory(at / ".symreal", ignored)) return (at / ".symreal").string();
    if (!at.has_relative_path()) return std::nullopt;
  }
}

bool is_below(fs::path const &path, fs::path const &directory) {
  fs::path const relative = path.lexically_relative(directory);
  return !relative.empty() && *relative.begin() != "..";
}

// Directory for the state: the current one if all files are below it, else their deepest common directory.
std::string home(std::vector<Replacement> const &replacements) {
  std::error_code ignored;
  fs::path directory = fs::canonical(fs::current_path(), ignored);
  bool inside = true;
  for (Replacement const &one : replacements) inside &= is_below(one.path, directory);
  if (!inside) directory = fs::path(replacements.front().path).parent_path();
  for (Replacement const &one : replacements)
    while (!is_below(one.path, directory) && directory.has_relative_path()) directory = directory.parent_path();
  return directory.string();
}

} // namespace

std::string edit_tree(std::vector<Replacement> const &replacements) {
  if (replacements.empty()) return {};
  for (Replacement const &one : replacements) require_replaceable(one);
  std::string const directory = home(replacements);
  State state(directory + "/.symreal");
  state.recover();
  Journal journal{state.last() + 1, false, {}};
  for (Replacement const &one : replacements)
    journal.entries.push_back({one.path, temporary_name(one.path), content_hash(one.original), content_hash(one.text)});
  state.carry_out(journal, replacements);
  return directory;
}

Recovery recover_tree(std::string const &directory) {
  std::optional<std::string> const found = find_state(directory);
  if (!found) return Recovery::nothing;
  State state(*found);
  Recovery const recovery = state.recover();
  state.remove_if_empty();
  return recovery;
}

std::vector<std::string> undo_tree(std::string const &directory) {
  std::optional<std::string> const found = find_state(directory);
  unsigned number = 0;
  std::optional<State> state;
  if (found) number = state.emplace(*found).last();
  if (number == 0) fail(DiagnosticId::undo_refused, {directory}, "there is no edit to undo here or above");
  Journal const done = read_journal(state->manifest(number));
  Journal undo{number, true, {}};
  std::vector<Replacement> replacements;
  std::vector<std::string> files;
  for (std::size_t i = 0; i < done.entries.size(); ++i) {
    Entry const &one = done.entries[i];
    if (file_hash(one.path) != one.new_hash)
      fail(DiagnosticId::undo_refused, {one.path}, "this file changed since it was rewritten; nothing was undone");
    if (became_link(one.path))
      fail(DiagnosticId::undo_refused, {one.path},
           "a link has taken the place of this file, or of a directory above it; nothing was undone");
    std::string original = read_file(state->original(number, i));
    if (content_hash(original) != one.old_hash)
      fail(DiagnosticId::undo_refused, {state->original(number, i)}, "this copy of the original was changed");
    undo.entries.push_back({one.path, one.temporary, one.new_hash, one.old_hash});
    replacements.push_back({one.path, read_file(one.path), std::move(original)});
    require_replaceable(replacements.back());
    files.push_back(one.path);
  }
  state->carry_out(undo, replacements);
  state->remove_if_empty();
  return files;
}

} // namespace symreal::program
