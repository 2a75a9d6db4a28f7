#include "program/build/object_cache.h"

#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "program/build/make_rule.h"
#include "program/build/read_files.h"

#include <llvm/Support/Program.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <sstream>
#include <sys/stat.h>
#include <utility>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Does the argument make the output depend on more than arguments and text?
bool reads_more(std::string_view word) {
  for (std::string_view start : {"-fplugin", "-fprofile", "-fauto-profile", "-specs", "--specs", "-save-temps", "@"})
    if (word.starts_with(start)) return true;
  return false;
}

// Path, size and time of a file, or of a program looked up in PATH.
std::string file_stamp(std::string const &path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return path;
  return fmt::format("{}.{} {} {}", status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size, path);
}

std::string program_stamp(std::string const &name) {
  llvm::ErrorOr<std::string> const path = llvm::sys::findProgramByName(name);
  return file_stamp(path ? *path : name);
}

// Hash accumulator that leaves out the path of the workspace.
class Key {
public:
  explicit Key(std::string_view workspace) : workspace_(workspace) {}
  void add(std::string_view text) {
    for (std::size_t at; (at = text.find(workspace_)) != text.npos; text.remove_prefix(at + workspace_.size()))
      all_ += text.substr(0, at);
    all_ += text;
    all_ += '\0';
  }
  std::string result() const { return rewrite::content_id(all_); }

private:
  std::string_view workspace_;
  std::string all_;
};

// Does gcc read the precompiled header beside the included text in its place?
bool reads_precompiled(Words const &words) {
  std::size_t const header = position_after(words, "-include");
  return header != 0 && fs::exists(words[header] + ".gch");
}

// Adds the common part of both keys: compiler, arguments and environment.
void add_compilation(Key &key, Command const &compilation) {
  key.add(version);
  key.add(compilation.directory.empty() ? fs::current_path().string() : compilation.directory);
  key.add(program_stamp(compilation.arguments.front()));
  for (std::string const &word : compilation.arguments) {
    key.add(word);
    constexpr std::string_view plugin = "-fpass-plugin="; // plugins count as parts of the compiler
    if (word.starts_with(plugin)) key.add(program_stamp(std::string(word.substr(plugin.size()))));
  }
  for (char const *name : {"COMPILER_PATH", "GCC_EXEC_PREFIX", "SOURCE_DATE_EPOCH", "NIX_CFLAGS_COMPILE", "CPATH",
                           "C_INCLUDE_PATH", "CPLUS_INCLUDE_PATH", "CCC_OVERRIDE_OPTIONS"})
    if (char const *value = std::getenv(name)) key.add(fmt::format("{}={}", name, value));
}

// Notes a file of the user's that the compiler read: the rewriter sees neither headers of the symbolic program alone
// nor those of sources that are left unchanged. The workspace links to such sources.
void note_compiled(std::string const &path, std::string const &workspace) {
  std::error_code error;
  std::string const real = fs::canonical(path, error).string();
  // Skips the tool's own headers: the result depends on the tool as a whole.
  std::error_code is_other;
  bool const is_own =
      fs::canonical(runtime_include() + "/symreal/" + fs::path(real).filename().string(), is_other) == real;
  if (!error && !real.starts_with(workspace) && !real.starts_with("/usr/") && !is_own) note_read(real);
}

std::string key_of_words(Command const &compilation, std::string const &workspace) {
  Key key(workspace);
  key.add("read");
  add_compilation(key, compilation);
  return key.result();
}

bool has_embedded_file(std::string const &text) { return text.find(".incbin") != text.npos; }

// Inputs of a compilation, and the key of its object.
struct Inputs {
  std::string key;
  std::optional<CompiledFrom> from;
};

// Files that a make rule names.
Words files_read(std::string const &rule) {
  Words files = read_make_rule(text_of_file(rule).value_or(""));
  std::erase_if(files, [](std::string const &file) { return file.ends_with(".gch"); }); // identified by an argument
  return files;
}

std::string key_of(Command const &compilation, CompiledFrom const &from, std::string const &workspace) {
  Key key(workspace);
  add_compilation(key, compilation);
  key.add(to_bytes(from, ""));
  return key.result();
}

// Inputs determined by preprocessing. Nullopt if arguments and text do not determine the compilation, or preprocessing
// fails.
std::optional<Inputs> preprocess(Command const &compilation, std::string const &object, std::string const &workspace) {
  Command preprocessing = compilation;
  preprocessing.processor_limit = {};
  Words &words = preprocessing.arguments;
  std::string const text = object + ".i", rule = object + ".d";
  words[position_after(words, "-o")] = text;
  std::replace(words.begin(), words.end(), std::string("-c"), std::string("-E"));
  words.insert(words.end(), {"-MD", "-MF", rule, "-v"});
  if (reads_precompiled(words)) words.emplace_back("-fpch-preprocess"); // emits its name instead of its text
  Captured const run = capture(preprocessing);
  if (!run.outcome.success()) return {};

  Key key(workspace);
  add_compilation(key, compilation);
  std::string const preprocessed = read_file(text);
  if (has_embedded_file(preprocessed)) return {};
  key.add(preprocessed);
  Words const files = files_read(rule);
  for (std::string const &file : files) {
    std::string const path = (fs::path(compilation.directory) / file).string();
    if (!fs::is_regular_file(path)) return {};
    note_compiled(path, workspace);
    key.add(file);
    key.add(text_of_file(path).value_or(""));
  }
  fs::remove(text);
  fs::remove(rule);
  std::optional<CompiledFrom> from = compiled_from(compilation, files, run.output, workspace);
  std::string const by_files = from ? key_of(compilation, *from, workspace) : key.result();
  return Inputs{by_files, std::move(from)};
}

// Was the file changed since `begun`, as far as the clocks agree? Files of the workspace belong to the tool.
bool is_changed_since(std::string const &path, timespec const &begun, std::string const &workspace) {
  std::error_code error;
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return true;
  timespec const &changed = status.st_ctim;
  bool const is_earlier = std::pair(changed.tv_sec, changed.tv_nsec) < std::pair(begun.tv_sec, begun.tv_nsec);
  return !is_earlier && !fs::canonical(path, error).string().starts_with(workspace);
}

// Inputs reported by a compilation that started at `begun`. Nullopt if it cannot be cached.
std::optional<Inputs> told(Command const &compilation, std::string const &rule, std::string const &messages,
                           timespec const &begun, std::string const &workspace) {
  Words const files = files_read(rule);
  bool is_kept = !files.empty();
  for (std::string const &file : files) {
    std::string const path = (fs::path(compilation.directory) / file).string();
    note_compiled(path, workspace);
    if (!fs::is_regular_file(path) || has_embedded_file(text_of_file(path).value_or("")) ||
        is_changed_since(path, begun, workspace))
      is_kept = false;
  }
  if (!is_kept) return {};
  std::optional<CompiledFrom> from = compiled_from(compilation, files, messages, workspace);
  std::string const by_files = from ? key_of(compilation, *from, workspace) : "";
  return Inputs{by_files, std::move(from)};
}

// Runs a compilation that is not cached.
Captured compiled_with_notes(Command compilation, std::string const &object, std::string const &workspace) {
  std::string const rule = object + ".d";
  Words &words = compilation.arguments;
  words.insert(words.end(), {"-MMD", "-MF", rule});
  Captured result = capture(compilation);
  for (std::string const &file : read_make_rule(text_of_file(rule).value_or("")))
    note_compiled((fs::path(compilation.directory) / file).string(), workspace);
  return result;
}

constexpr std::uintmax_t most_kept = std::uintmax_t{8} << 20; // bytes of a cached program

bool has_gold() {
  static bool const has = bool(llvm::sys::findProgramByName("ld.gold"));
  return has;
}

} // namespace

std::optional<ObjectCache::Kept> ObjectCache::kept(std::optional<std::string> const &bytes,
                                                   std::string const &workspace, FilesNow &files) {
  std::optional<Kept> before = bytes ? compiled_from_bytes(*bytes) : std::nullopt;
  return before && before->first.still_holds(files, workspace) ? std::move(before) : std::nullopt;
}

struct ObjectCache::Search {
  std::string object, by_words; // `by_words` is empty if nothing may be cached
  bool is_first = false;        // no entry exists under the arguments' key
  std::optional<Inputs> found;
  bool taken = false;
};

ObjectCache::Search ObjectCache::search_by_words(Command const &compilation, std::string const &workspace,
                                                 FilesNow &files) {
  Words const &words = compilation.arguments;
  Search search;
  search.object = words[position_after(words, "-o")];
  if (!directory_->exists() || std::any_of(words.begin(), words.end(), reads_more)) return search;
  search.by_words = key_of_words(compilation, workspace);
  std::optional<std::string> const bytes = directory_->find(search.by_words);
  search.is_first = !bytes;
  auto const before = kept(bytes, workspace, files);
  search.taken = before && directory_->take_file(before->second, search.object);
  if (search.taken)
    for (auto const &[path, id] : before->first.files)
      note_compiled(path.starts_with('@') ? workspace + path.substr(1) : path, workspace);
  return search;
}

void ObjectCache::search_by_text(Search &search, Command const &compilation, std::string const &workspace) {
  if (search.taken || search.by_words.empty()) return;
  search.found = preprocess(compilation, search.object, workspace);
  search.taken = search.found && directory_->take_file(search.found->key, search.object);
  if (search.taken) keep(search, workspace);
}

void ObjectCache::keep(Search const &search, std::string const &workspace) {
  if (!search.found) return;
  std::string const &key = search.found->key;
  // If the inclusions cannot be determined, makes the next run use the preprocessed text.
  if (search.is_first && !search.found->from) return directory_->keep(search.by_words, "by its text");
  if (!search.taken) directory_->keep_file(key, search.object);
  // A file edited meanwhile was compiled either before or after the edit: not cached.
  FilesNow now;
  if (search.found->from && search.found->from->still_holds(now, workspace))
    directory_->keep(search.by_words, to_bytes(*search.found->from, key));
}

Captured ObjectCache::compile(Command const &compilation, std::string const &workspace, FilesNow &files,
                              Quicker const &quicker) {
  Search search = search_by_words(compilation, workspace, files);
  std::optional<Quick> quick = search.taken ? std::nullopt : quicker(compilation);
  if (quick) {
    Search quick_search = search_by_words(quick->command, workspace, files);
    if (quick_search.taken || quick->ready())
      search = std::move(quick_search);
    else
      quick.reset();
  }
  Command const &command = quick ? quick->command : compilation;
  bool const tells_itself = search.is_first && !search.taken;
  if (!tells_itself) search_by_text(search, command, workspace);
  if (search.taken) return ++reused_, Captured{{Ending::exited, 0, 0}, {}};
  ++compiled_;
  Captured result = tells_itself   ? compile_first(search, command, workspace)
                    : search.found ? capture(command)
                                   : compiled_with_notes(command, search.object, workspace);
  if (result.outcome.success())
    keep(search, workspace);
  else if ((quick || tells_itself) && result.outcome.ending != Ending::over_limit)
    return capture(compilation); // reports messages without the precompiled header
  return result;
}

// Compiles without preprocessing first: no cached object has these arguments, so no lookup by text can succeed, and the
// compiler reports its inputs anyway.
Captured ObjectCache::compile_first(Search &search, Command const &compilation, std::string const &workspace) {
  timespec begun = {};
  clock_gettime(CLOCK_REALTIME_COARSE, &begun); // the clock of file times
  std::string const rule = search.object + ".d";
  Command telling = compilation;
  telling.arguments.insert(telling.arguments.end(), {"-MD", "-MF", rule, "-v"});
  Captured result = capture(telling);
  if (!result.outcome.success()) return result;
  search.found = told(compilation, rule, result.output, begun, workspace);
  result.output.clear();
  return result;
}

std::optional<ObjectCache::Kept> ObjectCache::known(Command const &compilation, std::string const &workspace,
                                                    FilesNow &files) {
  if (!directory_->exists()) return {};
  return kept(directory_->find(key_of_words(compilation, workspace)), workspace, files);
}

std::optional<ObjectCache::Kept> ObjectCache::make(Command const &compilation, std::string const &workspace,
                                                   FilesNow &files) {
  Search search = search_by_words(compilation, workspace, files);
  search_by_text(search, compilation, workspace);
  if (!search.taken && !capture(compilation).outcome.success()) return {};
  if (!search.taken) keep(search, workspace);
  return kept(directory_->find(search.by_words), workspace, files);
}

std::size_t position_after(Words const &words, std::string_view option) {
  auto const found = std::find(words.begin(), words.end(), option);
  return found == words.end() || found + 1 == words.end() ? 0 : static_cast<std::size_t>(found - words.begin()) + 1;
}

std::string Linking::key(Command const &command) {
  std::string key = fmt::format("linked {}\n{}\n", version, program_stamp("ld.gold"));
  for (char const *name : {"COMPILER_PATH", "GCC_EXEC_PREFIX", "LIBRARY_PATH", "LD_RUN_PATH", "CCC_OVERRIDE_OPTIONS"})
    if (char const *value = std::getenv(name)) key += fmt::format("{}={}\n", name, value);
  key += program_stamp(command.arguments.front()) + "\n";
  for (std::string const &word : command.arguments)
    if (!word.starts_with(workspace_))
      key += (fs::is_regular_file(word) ? file_stamp(word) : word) + "\n";
    else if (fs::is_regular_file(word))
      key += files_.content_id(word) + "\n";
  return rewrite::content_id(key);
}

// An entry holds the program's content id and the stamps of the linker's further inputs.
bool Linking::take(std::string const &key, std::string const &program) {
  std::optional<std::string> const kept = directory_.find(key);
  if (!kept) return false;
  std::istringstream lines(*kept);
  std::string id, one;
  std::getline(lines, id);
  while (std::getline(lines, one)) {
    std::size_t const path = one.find(' ', one.find(' ') + 1);
    if (path == one.npos || file_stamp(one.substr(path + 1)) != one) return false;
  }
  if (!directory_.take_file(id, program)) return false;
  std::error_code error;
  fs::permissions(program, fs::perms::owner_all, error);
  return !error;
}

void Linking::keep(std::string const &key, std::string const &program, std::string const &rule) {
  std::error_code error;
  Words const read = read_make_rule(text_of_file(rule).value_or(""));
  if (read.empty() || fs::file_size(program, error) > most_kept || error) return;
  std::string const id = rewrite::content_id("program " + key);
  std::string text = id + "\n";
  for (std::string const &path : read)
    if (!path.starts_with(workspace_)) text += file_stamp(path) + "\n";
  directory_.keep_file(id, program);
  directory_.keep(key, text);
}

// gold takes a third of the time. If it fails, the compiler's own linker links, or reports the error.
Captured Linking::link(Command const &command) {
  bool const is_chosen =
      std::ranges::any_of(command.arguments, [](auto const &word) { return word.starts_with("-fuse-ld="); });
  if (!has_gold() || is_chosen) return capture(command);
  std::string const &program = command.arguments[position_after(command.arguments, "-o")], rule = program + ".d";
  std::string const by_words = may_keep_ ? key(command) : "";
  if (may_keep_ && take(by_words, program)) return {{Ending::exited, 0, 0}, {}};
  Command quick = command;
  quick.arguments.emplace_back("-fuse-ld=gold");
  if (may_keep_) quick.arguments.push_back("-Wl,--dependency-file=" + rule);
  Captured linked = capture(quick);
  if (!linked.outcome.success()) return capture(command);
  if (may_keep_) keep(by_words, program, rule);
  return linked;
}

} // namespace symreal::program
