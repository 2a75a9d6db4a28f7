#include "tool/options/source_options.h"

#include "engine/diagnostics/diagnostic.h"
#include "program/build/object_cache.h"
#include "program/build/process.h"
#include "program/build/read_files.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <set>
#include <thread>

namespace symreal::tool {
namespace {

// Notes the sources as read and recovers interrupted edits in their directories and the current one.
void begin_reading(std::vector<std::string> const &sources) {
  std::set<std::string> directories = {"."};
  for (std::string const &source : sources) {
    program::note_read(source);
    std::string const directory = std::filesystem::path(source).parent_path().string();
    if (!directory.empty()) directories.insert(directory);
  }
  for (std::string const &directory : directories) recover(directory);
}

// Adds the build's other sources. Excluded ones belong to no program unless they are named.
void add_others(rewrite::Request &request, std::string const &build) {
  for (rewrite::Compilation &one : rewrite::read_compile_commands(build, {})) {
    std::string const real = rewrite::real_source(one);
    bool const is_named = std::find(request.begin.begin(), request.begin.end(), real) != request.begin.end();
    if (!is_named && !request.exclude.matches(real)) request.compilations.push_back(std::move(one));
  }
}

// Reports damaged cache entries, once a run.
void tell_damaged(std::string const &entry) {
  static std::atomic<bool> is_told = false;
  if (is_told.exchange(true)) return;
  print(std::cerr, {DiagnosticId::damaged_cache, {entry}, "this entry of the cache is damaged; it is made again"});
}

} // namespace

program::Recovery recover(std::string const &directory) {
  program::Recovery const recovery = program::recover_tree(directory);
  auto const say = [&](char const *message) {
    print(std::cerr, {DiagnosticId::interrupted_edit, {directory}, message});
  };
  switch (recovery) {
  case program::Recovery::nothing: break;
  case program::Recovery::completed: say("a rewrite that was interrupted was completed"); break;
  case program::Recovery::taken_back: say("a rewrite that was interrupted was taken back"); break;
  case program::Recovery::undone: say("an undo that was interrupted was completed"); break;
  case program::Recovery::not_undone: say("an undo that was interrupted was taken back"); break;
  }
  return recovery;
}

void ProjectOptions::add_to(CLI::App &app) {
  app.add_option("sources", request.sources, "C and C++ sources; with -p by default all of them");
  add_build_to(app);
}

void ProjectOptions::add_build_to(CLI::App &app) {
  app.add_option("--root", request.roots,
                 "A further directory whose files may be rewritten, besides the sources' own (repeatable)")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("DIR");
  app.add_option("-p", build, "Directory of the compile_commands.json that says how the sources are compiled")
      ->type_name("DIR");
  app.add_option("-j", request.jobs, "Number of sources read in parallel; by default one per processor")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  app.add_option("--type-name", request.type_name,
                 "Name of the number type in rewritten sources; by default REAL, or SYMREAL_REAL if taken");
  app.add_flag("--no-cache", no_cache, "Ignore the cache of earlier runs: read and compile everything");
  app.add_option("--config", configuration,
                 "The project's configuration; by default the .symreal.yaml in the directory of the first source or "
                 "the nearest above it")
      ->type_name("FILE");
}

std::shared_ptr<program::CacheDirectory> ProjectOptions::cache() const {
  return std::make_shared<program::CacheDirectory>(no_cache ? "" : program::usual_cache_directory(), tell_damaged);
}

std::filesystem::path ProjectOptions::configuration_start() const {
  std::filesystem::path const start = request.sources.empty()
                                          ? std::filesystem::path(build.empty() ? "." : build)
                                          : std::filesystem::path(request.sources.front()).parent_path();
  return start.empty() ? "." : start;
}

std::string ProjectOptions::configuration_file(bool or_new) const {
  if (!configuration.empty()) return configuration;
  std::filesystem::path const start = configuration_start();
  std::string const found = find_configuration(start.string());
  return found.empty() && or_new ? (start / ".symreal.yaml").lexically_normal().string() : found;
}

std::vector<std::string> ProjectOptions::absent_configurations() const {
  if (!configuration.empty()) return {};
  std::vector<std::string> absent;
  std::error_code error;
  std::filesystem::path at = std::filesystem::weakly_canonical(configuration_start(), error);
  for (std::filesystem::path file; !error; at = at.parent_path()) {
    file = at / ".symreal.yaml";
    if (std::filesystem::is_regular_file(file)) break;
    absent.push_back(file.string());
    if (!at.has_relative_path()) break;
  }
  return absent;
}

void ProjectOptions::configure(CLI::App &command, ConfiguredOptions &given) {
  for (std::string const &source : request.sources) program::note_read(source);
  std::string const file = configuration_file();
  if (file.empty()) return;
  Configuration read = read_configuration(file);
  set_options(read, command, given);
  request.roots.insert(request.roots.end(), read.roots.begin(), read.roots.end());
  request.exclude = std::move(read.exclude);
  if (request.type_name.empty()) request.type_name = read.type_name;
  request.kernels = std::move(read.kernels);
  calls = std::move(read.calls);
  request.externals = std::move(read.externals);
}

rewrite::Request ProjectOptions::complete(CompilerFlags const &flags) const {
  rewrite::Request complete = request;
  if (complete.jobs == 0) complete.jobs = std::max(1U, std::thread::hardware_concurrency());
  if (build.empty() && complete.sources.empty())
    fail(DiagnosticId::bad_option, {}, "name the sources, or a build directory with -p");
  complete.flags = flags;
  for (std::string const &flag : flags)
    if (flag.starts_with('@')) program::note_read(flag.substr(1)); // response file with more flags
  if (std::shared_ptr<program::CacheDirectory> kept = cache(); kept->exists()) complete.kept = std::move(kept);
  if (complete.reachable) {
    std::vector<std::string> named = complete.sources;
    if (build.empty()) named.resize(1);
    for (std::string const &source : named) complete.begin.push_back(rewrite::real_source({source, {}, {}}));
  }
  if (build.empty()) {
    begin_reading(complete.sources);
    return complete;
  }
  program::note_read((std::filesystem::path(build) / "compile_commands.json").string());
  if (!complete.reachable || !request.sources.empty())
    complete.compilations = rewrite::read_compile_commands(build, request.sources);
  if (complete.reachable) add_others(complete, build);
  complete.sources.clear();
  for (rewrite::Compilation &one : complete.compilations) {
    one.flags.insert(one.flags.end(), flags.begin(), flags.end());
    complete.sources.push_back(one.source);
  }
  std::vector<std::string> paths;
  for (rewrite::Compilation const &one : complete.compilations)
    paths.push_back((std::filesystem::path(one.directory) / one.source).string());
  begin_reading(paths);
  return complete;
}

rewrite::Request only_rewritten(rewrite::Request request) {
  rewrite::Exclusion const &exclude = request.exclude;
  std::erase_if(request.compilations,
                [&](rewrite::Compilation const &one) { return exclude.matches(rewrite::real_source(one)); });
  std::erase_if(request.sources, [&](std::string const &source) {
    return request.compilations.empty() && exclude.matches(rewrite::real_source({source, {}, {}}));
  });
  if (!request.compilations.empty()) {
    request.sources.clear();
    for (rewrite::Compilation const &one : request.compilations) request.sources.push_back(one.source);
  }
  if (request.sources.empty()) fail(DiagnosticId::bad_option, {}, "the configuration excludes all of the sources");
  return request;
}

void SourceOptions::add_to(CLI::App &app) {
  project.add_build_to(app);
  app.add_option("--cxx", front.build.compiler, "Compiler of the rewritten program")->capture_default_str();
  app.add_option("--link", link, "Linker flags of the rewritten program, such as '-L. -lfoo'");
  app.add_option("--run-args", run_arguments, "Program arguments, quoted as in a shell");
  app.add_option("--stdin", front.run.standard_input, "File that the program reads as standard input")
      ->type_name("FILE");
  app.add_option("--cwd", front.run.directory, "Working directory of the program")->type_name("DIR");
  app.add_option("--timeout", front.run.time_limit, "Time limit of the program, in seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--reachable", project.request.reachable,
               "Rewrite and build only the sources reachable from main, or from the called function");
  app.add_flag("--run-on", front.run.run_on, "Let the program run to its end after the last kernel");
  app.add_flag("--keep", front.keep, "Keep the build directory and print its path");
  app.add_option("--kernel", front.kernel,
                 "Select kernels by name, or call a function without a program: 'f(x[0:3]=0.5, n=3) -> y[0:3]'")
      ->type_name("NAMES|CALL");
}

program::FrontRequest SourceOptions::request(CompilerFlags const &flags) const {
  program::FrontRequest request = front;
  request.source = project.complete(flags);
  if (!front.run.standard_input.empty()) program::note_read(front.run.standard_input);
  request.source.defines = program::reference_defines();
  request.build.link = program::split_words(link);
  request.build.cache = std::make_shared<program::ObjectCache>(project.cache());
  request.run.arguments = program::split_words(run_arguments);
  return request;
}

} // namespace symreal::tool
