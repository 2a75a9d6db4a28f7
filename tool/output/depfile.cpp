#include "tool/output/depfile.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "engine/support/mutation/is_dropped.h"
#include "program/build/cache_directory.h"
#include "program/build/compile.h"
#include "program/build/compiled_from.h"
#include "program/build/make_rule.h"
#include "program/build/read_files.h"
#include "rewrite/request/driver_options.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <vector>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

bool is_below(std::string const &path, std::string const &directory) {
  return !directory.empty() && path.starts_with(directory + "/");
}

// Is this a dependency: a file that may change, but is neither made by the run nor part of an installation?
bool counts(std::string const &path, program::Front const &front) {
  std::error_code error;
  return fs::is_regular_file(path, error) && !is_below(path, front.workspace->path()) &&
         !is_below(path, program::usual_cache_directory()) && !is_below(path, runtime_include());
}

std::vector<std::string> read_of(program::Front const &front, program::FrontRequest const &request) {
  std::set<std::string> all(front.read.begin(), front.read.end());
  for (std::string const &path : program::files_read().read)
    if (counts(path, front)) all.insert(path);
  std::error_code error;
  all.insert(fs::read_symlink("/proc/self/exe", error).string());
  all.insert(runtime_library());
  all.erase("");
  for (rewrite::TextSource const &one : request.source.texts) all.erase(rewrite::real_source({one.path, {}, {}}));
  return {all.begin(), all.end()};
}

// Directories that the compilations search before the system's.
std::vector<std::string> own_directories(program::FrontRequest const &request) {
  std::set<std::string> all;
  for (rewrite::Compilation const &one : rewrite::compilations_of(request.source))
    for (rewrite::DriverOption const &option : rewrite::driver_options(one.flags))
      if (option.about == rewrite::About::directories)
        all.insert(fs::absolute(fs::path(one.directory) / option.value).lexically_normal().string());
  return {all.begin(), all.end()};
}

std::vector<std::string> system_directories(program::FrontRequest const &request) {
  program::Captured const run =
      program::capture(program::compiler_run({request.build.compiler, "-E", "-v", "-x", "c++", "/dev/null"}));
  return program::searched_directories(run.output);
}

// Headers that __has_include finds absent.
std::vector<std::string> absent_headers(program::Front const &front, program::FrontRequest const &request) {
  std::vector<std::string> absent;
  std::vector<std::string> const own = own_directories(request);
  std::vector<std::string> system;
  for (std::string const &file : front.read)
    for (program::Inclusion const &one : program::questions_of(text_of_file(file).value_or(""))) {
      if (system.empty()) system = system_directories(request);
      auto const has_it = [&](std::string const &directory) { return fs::exists(fs::path(directory) / one.name); };
      if (std::ranges::any_of(system, has_it)) continue;
      std::vector<std::string> places = own;
      if (one.quoted) places.insert(places.begin(), fs::path(file).parent_path().string());
      for (std::string const &directory : places)
        if (!has_it(directory)) absent.push_back((fs::path(directory) / one.name).string());
    }
  return absent;
}

bool is_of_system(std::string const &path) {
  return std::ranges::any_of(std::vector<std::string>{"/usr", "/lib", "/lib64", "/etc", "/var"},
                             [&](std::string const &directory) { return is_below(path, directory); });
}

std::vector<std::string> absent_files(program::Front const &front, program::FrontRequest const &request) {
  std::vector<std::string> all = absent_headers(front, request);
  for (std::string const &path : program::files_read().absent)
    if (!is_of_system(path) && !is_below(path, front.workspace->path()) && !fs::exists(path)) all.push_back(path);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// The nearest existing parent, which changes when the file or its directory appears.
std::string watched_directory(fs::path path) {
  for (path = path.parent_path(); !fs::is_directory(path) && path.has_relative_path();) path = path.parent_path();
  return path.string();
}

std::string wildcards(std::string const &target, std::vector<std::string> const &absent) {
  std::string text;
  for (std::string const &path : absent) text += target + ": $(wildcard " + program::make_escaped(path) + ")\n";
  return text;
}

} // namespace

std::string dependencies(std::string const &depfile, std::string const &target, program::Front const &front,
                         program::FrontRequest const &request, ProjectOptions const &project) {
  std::vector<std::string> names = read_of(front, request);
  std::vector<std::string> absent = absent_files(front, request);
  std::string const escaped = program::make_escaped(target);
  if (!depfile.ends_with(".mk")) {
    for (std::string const &path : absent) names.push_back(watched_directory(path));
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return program::make_rule({escaped}, names, program::Phony::all);
  }
  for (std::string const &path : project.absent_configurations()) absent.push_back(path);
  return program::make_rule({escaped}, names, program::Phony::all) + wildcards(escaped, absent);
}

void warn_of_unseen(std::string const &depfile) {
  if (program::files_read().are_all || is_dropped("SYM197")) return;
  print(std::cerr, {DiagnosticId::unseen_files,
                    {depfile},
                    "this system does not tell which files the program opened; the rule lacks them"});
}

} // namespace symreal::tool
