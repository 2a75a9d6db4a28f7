#include "tool/output/outputs.h"

#include "diagnostics/diagnostic.h"
#include "emit/emit.h"
#include "emit/language/banner.h"
#include "schedule/angles.h"
#include "support/diff.h"
#include "support/files.h"
#include "tool/output/line_map.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
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
                         !options.map_file.empty()};
  std::vector<OutputFile> files;
  for (Language const *language : languages)
    for (EmittedFile &file : symreal::emit(plan, *language, emit, loops, lanes)) {
      files.push_back({(fs::path(path).parent_path() / file.name).string(), std::move(file.text)});
      if (!options.map_file.empty() && files.size() == 1)
        files.push_back({options.map_file, line_map(file, *plan.graph)});
    }
  return files;
}

void require_writable(std::string const &path) {
  fs::path directory = fs::path(path).parent_path();
  if (directory.empty()) directory = ".";
  std::error_code ignored;
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    fail(DiagnosticId::unwritable_output, {path},
         "'" + path + "' cannot be written: " + std::string(std::strerror(errno)));
  if (!fs::is_directory(directory, ignored))
    fail(DiagnosticId::unwritable_output, {path}, "'" + path + "' cannot be written: its directory is a file");
  if (fs::is_directory(path, ignored))
    fail(DiagnosticId::unwritable_output, {path}, "'" + path + "' cannot be written: a directory has this name");
}

void require_writable(std::vector<OutputFile const *> const &files) {
  std::set<fs::path> paths;
  for (OutputFile const *file : files) {
    require_writable(file->path);
    require_ours(file->path, file->text);
    if (!paths.insert(fs::path(file->path).lexically_normal()).second)
      fail(DiagnosticId::output_collision, {file->path}, "two results would be written to this file");
  }
}

void require_writable(std::vector<OutputFile> const &files) {
  std::vector<OutputFile const *> all;
  for (OutputFile const &file : files) all.push_back(&file);
  require_writable(all);
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
    std::string const there = exists ? read_file(file.path) : "";
    if (exists && there == file.text) continue;
    current = false;
    bool const is_text = file.text.find('\0') == std::string::npos;
    if (is_text) std::cout << unified_diff(file.path, there, file.text) << std::flush;
    print(std::cerr,
          {DiagnosticId::out_of_date, {file.path}, exists ? "this file is out of date" : "this file does not exist"});
  }
  return current;
}

std::vector<std::string> write_files(std::vector<OutputFile> const &files) {
  std::vector<std::string> paths;
  for (OutputFile const &file : files) {
    write_if_changed(file.path, file.text);
    paths.push_back(file.path);
  }
  return paths;
}

} // namespace symreal::tool
