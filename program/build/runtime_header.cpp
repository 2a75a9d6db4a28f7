#include "program/build/runtime_header.h"

#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "rewrite/request/driver_options.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <utility>

namespace symreal::program {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t worth_making = 3; // compilations that must ask for it

bool is_clang(Command const &compilation) { return compilation.arguments.front().find("clang") != std::string::npos; }

// Position of the runtime header among the arguments, if it is the only -include; else 0.
std::size_t header_position(Words const &words) {
  std::size_t const at = position_after(words, "-include");
  auto const includes = [](rewrite::DriverOption const &option) { return option.about == rewrite::About::headers; };
  bool const is_ours = at != 0 && words[at].starts_with("symreal/");
  return is_ours && std::ranges::count_if(rewrite::driver_options(words), includes) == 1 ? at : 0;
}

// Is this a directory of the user's that a precompiled header may ignore? clang accepts only directories searched after
// the system's, gcc also those before.
bool is_searched_for(rewrite::DriverOption const &option, bool by_clang) {
  bool const is_last = option.name == "-idirafter", is_before = option.name == "-I" || option.name == "-isystem";
  return option.about == rewrite::About::directories && option.value != runtime_include() &&
         (is_last || (is_before && !by_clang));
}

// The arguments without directories that the header does not need, which go to `searched`.
Words without_directories(Words const &words, bool by_clang, Words &searched) {
  Words kept;
  for (rewrite::DriverOption const &option : rewrite::driver_options(words))
    if (is_searched_for(option, by_clang))
      searched.push_back(option.value);
    else
      rewrite::append(kept, option, words);
  return kept;
}

// The arguments without the program's macros, except those that the header or the library tests. gcc takes a
// precompiled header nevertheless, unless it uses the name of such a macro; then gcc reads the text.
Words without_macros(Words const &words) {
  Words kept;
  for (rewrite::DriverOption const &option : rewrite::driver_options(words)) {
    bool const is_macro = option.name == "-D" || option.name == "-U";
    bool const is_looked_at = std::ranges::any_of(std::initializer_list<std::string_view>{"_", "MBD_", "SYMREAL_"},
                                                  [&](auto begin) { return option.value.starts_with(begin); });
    if (!is_macro || is_looked_at) rewrite::append(kept, option, words);
  }
  return kept;
}

// May an argument name a file relative to the compiler's directory?
bool depends_on_directory(Words const &words) {
  return std::ranges::any_of(rewrite::driver_options(words), [](rewrite::DriverOption const &option) {
    bool const may = option.about == rewrite::About::directories || option.about == rewrite::About::other;
    return may && option.value.find_first_of("./") != option.value.npos && !option.value.starts_with('/');
  });
}

// Command that compiles the header to this file.
Command header_compilation(Command compilation, std::string const &to) {
  compilation.processor_limit = {};
  Words &words = compilation.arguments;
  std::size_t const header = header_position(words);
  std::size_t const source = position_after(words, "-c"); // the arguments have "-x c++ -c SOURCE"
  words[source - 2] = "c++-header";
  words[source] = runtime_include() + "/" + words[header];
  words[position_after(words, "-o")] = to;
  words.erase(words.begin() + static_cast<std::ptrdiff_t>(header) - 1,
              words.begin() + static_cast<std::ptrdiff_t>(header) + 1);
  return compilation;
}

} // namespace

void RuntimeHeader::make(One &one, Command const &compilation, std::string const &key, FilesNow &files) {
  std::string const &header = compilation.arguments[header_position(compilation.arguments)];
  std::string const all = workspace_ + "/precompiled/", directory = all + rewrite::content_id(key);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) return;
  Command const precompilation = header_compilation(compilation, directory + "/header.h.gch");
  ++one.asked;
  auto kept = one.asked == 1 ? objects_.known(precompilation, workspace_, files) : std::nullopt;
  one.is_laid = false;
  if (!kept) {
    std::string const count_key = rewrite::content_id("asked for " + key);
    std::string const before = directory_.find(count_key).value_or("");
    bool const is_worth_it = before.size() + 1 >= worth_making;
    one.tried = is_worth_it;
    if (is_worth_it)
      kept = objects_.make(precompilation, workspace_, files);
    else
      directory_.keep(count_key, before + "+");
    one.is_laid = kept.has_value();
  }
  if (!kept) return;
  // Lays it at a path derived from its inputs, so that the path identifies it among arguments.
  std::string const place = all + kept->second, path = place + "/header.h";
  std::filesystem::create_directories(place, error);
  if (!error && one.is_laid) std::filesystem::rename(directory + "/header.h.gch", path + ".gch", error);
  if (error) return;
  // Writes the text that gcc reads if it rejects the precompiled header beside it.
  write_if_changed(path, "#include <" + header + ">\n");
  one.path = path;
  one.object = kept->second;
  one.names = std::move(kept->first.names);
  one.names.push_back(header);
}

// Links the header from the cache; makes it again if the entry is damaged.
bool RuntimeHeader::lay(One &one, Command const &compilation, std::string const &key, FilesNow &files) {
  std::scoped_lock const lock(one.mutex);
  if (one.path.empty()) return false;
  if (!one.is_laid) one.is_laid = objects_.lay(one.object, one.path + ".gch");
  if (one.is_laid) return true;
  std::string const path = std::exchange(one.path, "");
  make(one, compilation, key, files);
  return one.is_laid && one.path == path;
}

// Does one of the directories have a file of a name that the header includes?
bool RuntimeHeader::may_read(One const &one, Words const &directories, std::string const &base, FilesNow &files) {
  return std::ranges::any_of(directories, [&](std::string const &directory) {
    std::filesystem::path const path = std::filesystem::path(base) / directory;
    return std::ranges::any_of(one.names,
                               [&](std::string const &name) { return files.exists((path / name).string()); });
  });
}

std::optional<ObjectCache::Quick> RuntimeHeader::use(Command const &compilation, FilesNow &files) {
  std::size_t const header = header_position(compilation.arguments);
  if (header == 0 || !directory_.exists()) return {};
  Words searched;
  Command common = compilation;
  common.arguments = without_directories(compilation.arguments, is_clang(compilation), searched);
  if (!is_clang(compilation)) common.arguments = without_macros(common.arguments);
  if (!depends_on_directory(common.arguments)) common.directory = "/";
  Command const precompilation = header_compilation(common, "");
  std::string key = precompilation.directory;
  for (std::string const &word : precompilation.arguments) {
    std::string shown = word;
    if (std::size_t const at = shown.find(workspace_); at != shown.npos) shown.replace(at, workspace_.size(), "@");
    key += '\0' + shown;
  }
  std::unique_lock lock(mutex_);
  One &one = all_[key];
  lock.unlock();
  std::unique_lock const mine(one.mutex, std::try_to_lock); // others compile without the header while it is being made
  if (!mine) return {};
  if (one.path.empty() && !one.tried) make(one, common, key, files);
  if (one.path.empty() || may_read(one, searched, compilation.directory, files)) return {};
  Command with = compilation;
  with.arguments[header] = is_clang(compilation) ? one.path + ".gch" : one.path;
  if (is_clang(compilation)) with.arguments[header - 1] = "-include-pch";
  return ObjectCache::Quick{with, [this, &one, common, key, &files] { return lay(one, common, key, files); }};
}

} // namespace symreal::program
