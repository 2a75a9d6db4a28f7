#include "tool/output/outputs.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/emit/emit.h"
#include "engine/emit/language/banner.h"
#include "engine/plan/schedule/angles.h"
#include "engine/support/diff.h"
#include "engine/support/files.h"
#include "engine/support/mutation/is_dropped.h"
#include "program/build/durable_files.h"
#include "program/build/read_files.h"
#include "tool/output/folder.h"
#include "tool/output/line_map.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <unistd.h>

namespace symreal::tool {

namespace fs = std::filesystem;

Schedule as_emitted(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                    std::vector<Language const *> const &languages) {
  bool const any = std::ranges::any_of(languages, [](Language const *one) { return one->angles.is_given(); });
  return any && options.has_angles(mode) ? with_angles(plan) : plan;
}

std::vector<OutputFile> emitted_files(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                                      std::vector<Language const *> const &languages, std::string const &path,
                                      Rerolled const *loops, Laned const *lanes) {
  EmitOptions const emit{fs::path(path).stem().string(),
                         options.prefix,
                         mode,
                         options.extras,
                         options.trace_comments,
                         options.check_values,
                         options.is_single(),
                         options.has_angles(mode),
                         !options.map_file.empty(),
                         options.reference};
  std::vector<OutputFile> files;
  for (Language const *language : languages)
    for (EmittedFile &file : symreal::emit(plan, *language, emit, loops, lanes)) {
      files.push_back({(fs::path(path).parent_path() / file.name).string(), std::move(file.text)});
      if (!options.map_file.empty() && files.size() == 1)
        files.push_back({options.map_file, line_map(file, *plan.graph)});
    }
  return files;
}

namespace {

void require_unread(std::string const &path) {
  std::optional<std::string> const known = program::known_as(path);
  if (!known || is_dropped("SYM187")) return;
  bool const is_same = fs::absolute(path).lexically_normal() == *known;
  fail(DiagnosticId::output_is_read, {path},
       "this command, or a program that it runs, opens '" + path + "'" + (is_same ? "" : " as '" + *known + "'") +
           ", and a result would take its place");
}

// Paths of the results; fails if two denote one file.
class Places {
public:
  void add(std::string const &path) {
    if (!known_.insert(program::identity_of(path)).second && !is_dropped("SYM014"))
      fail(DiagnosticId::output_collision, {path}, "two results would be written to this file");
  }

private:
  std::set<std::string> known_;
};

void require_all(Outputs const &outputs) {
  Places places;
  for (OutputFile const &file : outputs.files) {
    require_writable(file.path);
    require_ours(file.path, file.text);
    places.add(file.path);
  }
  for (OutputFolder const &folder : outputs.folders) {
    require_folder(folder);
    for (OutputFile const &file : folder.files) {
      places.add(file.path);
      if (!fs::exists(fs::path(file.path).parent_path())) continue;
      require_writable(file.path);
      require_ours(file.path, file.text);
    }
  }
}

} // namespace

void require_writable(std::string const &path) {
  require_unread(path);
  fs::path directory = fs::path(path).parent_path();
  if (directory.empty()) directory = ".";
  std::error_code ignored;
  auto const refuse = [&](std::string const &why) {
    fail(DiagnosticId::unwritable_output, {path}, "'" + path + "' cannot be written: " + why);
  };
  if (access(directory.c_str(), W_OK | X_OK) != 0) refuse(std::strerror(errno));
  if (!fs::is_directory(directory, ignored)) refuse("its directory is a file");
  if (fs::is_directory(path, ignored)) refuse("a directory has this name");
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) refuse("this is a device or a pipe");
}

void require_writable(std::vector<std::string> const &paths) {
  Places places;
  for (std::string const &path : paths) {
    if (path.empty()) continue;
    require_writable(path);
    places.add(path);
  }
}

void make_directory(std::string const &path) {
  std::error_code problem;
  fs::create_directories(path, problem);
  if (problem) fail(DiagnosticId::unwritable_output, {path}, "the directory cannot be made: " + problem.message());
}

bool check_files(std::vector<OutputFile const *> const &files) {
  bool current = true;
  for (OutputFile const *one : files) {
    OutputFile const &file = *one;
    bool const exists = fs::exists(file.path);
    std::string const there = exists ? text_of_file(file.path).value_or("") : "";
    if (exists && without_reference(there) == without_reference(file.text)) continue;
    current = false;
    bool const is_text = file.text.find('\0') == std::string::npos;
    if (is_text) std::cout << unified_diff(file.path, there, file.text) << std::flush;
    print(std::cerr,
          {DiagnosticId::out_of_date, {file.path}, exists ? "this file is out of date" : "this file does not exist"});
  }
  return current;
}

std::vector<std::string> write_outputs(Outputs const &outputs) {
  program::StagedFiles staged;
  for (std::string const &directory : outputs.directories) staged.make_directory(directory);
  require_all(outputs);
  std::vector<std::string> paths;
  for (OutputFolder const &folder : outputs.folders) {
    stage_folder(folder, staged);
    for (OutputFile const &file : folder.files) paths.push_back(file.path);
  }
  for (OutputFile const &file : outputs.files) {
    staged.add(file.path, file.text);
    paths.push_back(file.path);
  }
  staged.commit();
  return paths;
}

} // namespace symreal::tool
