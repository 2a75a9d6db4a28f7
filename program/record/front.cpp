#include "program/record/front.h"

#include "engine/support/text.h"
#include "program/build/c_macros.h"
#include "program/build/read_files.h"
#include "program/record/explain_met.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <functional>
#include <llvm/Support/Program.h>
#include <map>
#include <set>
#include <utility>

namespace symreal::program {
namespace {

// Adds its lifetime in seconds to `seconds`.
class Stopwatch {
public:
  explicit Stopwatch(double &seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  Stopwatch(Stopwatch const &) = delete;
  Stopwatch &operator=(Stopwatch const &) = delete;

private:
  double &seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::vector<rewrite::Kernel> wanted_kernels(rewrite::Result const &rewritten, FrontRequest const &request) {
  std::vector<rewrite::Kernel> wanted = rewritten.kernels;
  if (!request.called.empty())
    std::erase_if(wanted, [&](rewrite::Kernel const &kernel) {
      return std::find(request.called.begin(), request.called.end(), kernel.name) == request.called.end();
    });
  if (wanted.empty())
    fail(DiagnosticId::no_kernel, {rewrite::compilations_of(request.source).front().source},
         "no pragma generates a kernel");
  std::set<std::string> names;
  std::string list;
  for (rewrite::Kernel const &kernel : wanted) {
    if (!names.insert(kernel.name).second)
      fail(DiagnosticId::output_collision, kernel.place, "a second kernel has the name '" + kernel.name + "'");
    list += (list.empty() ? "" : ", ") + kernel.name;
  }
  auto const is_verified = [&](rewrite::Kernel const &kernel) {
    return std::ranges::find(request.verified, kernel.name) != request.verified.end();
  };
  if (std::ranges::any_of(wanted, is_verified)) std::erase_if(wanted, std::not_fn(is_verified));
  if (request.kernel.empty()) return wanted;
  std::vector<std::string> const chosen = items_of(request.kernel);
  for (std::string const &name : chosen)
    if (std::ranges::find(wanted, name, &rewrite::Kernel::name) == wanted.end())
      fail(DiagnosticId::unknown_kernel, {}, "no kernel is named '" + name + "'; there are: " + list);
  std::erase_if(wanted,
                [&](rewrite::Kernel const &one) { return std::ranges::find(chosen, one.name) == chosen.end(); });
  return wanted;
}

// Flags that one entry for a source has and another lacks.
std::string words_apart(std::vector<std::string> const &one, std::vector<std::string> const &other) {
  std::string text;
  for (std::string const &word : one)
    if (std::ranges::find(other, word) == other.end()) text += (text.empty() ? "" : " ") + word;
  return text.empty() ? "no flags of its own" : "'" + text + "'";
}

// Build request for the rewritten and the excluded sources.
BuildRequest build_request(FrontRequest const &request, rewrite::Result const &rewritten) {
  BuildRequest build = request.build;
  build.type_name = rewritten.type_name;
  build.reachable = request.source.reachable;
  build.called_from_outside = rewritten.externals;
  build.reading_seconds = rewritten.reading_seconds;
  std::set<std::pair<std::string, std::vector<std::string>>> unreached;
  for (rewrite::Compilation const &one : rewritten.unreached) unreached.emplace(rewrite::real_source(one), one.flags);
  std::map<std::string, std::vector<std::string>> known; // sources with their flags
  for (rewrite::Compilation const &one : rewrite::compilations_of(request.source)) {
    std::string const real = rewrite::real_source(one);
    if (unreached.contains({real, one.flags})) continue;
    if (auto const [other, is_new] = known.try_emplace(real, one.flags); !is_new)
      fail(DiagnosticId::compile_commands, {one.source},
           fmt::format(
               "the build compiles this source twice, with {} and with {}, and a program can contain it only once",
               words_apart(other->second, one.flags), words_apart(one.flags, other->second)));
    (request.source.exclude.matches(real) ? build.unchanged : build.sources).push_back(one);
  }
  return build;
}

void note_unreached(rewrite::Result const &rewritten, std::size_t all, Talk const &talk) {
  constexpr std::size_t most = 8;
  std::vector<rewrite::Compilation> const &unreached = rewritten.unreached;
  if (unreached.empty()) return;
  std::string list;
  for (std::size_t k = 0; k < std::min(most, unreached.size()); ++k) list += (k ? ", " : "") + unreached[k].source;
  if (unreached.size() > most) list += fmt::format(" and {} more", unreached.size() - most);
  talk.note(fmt::format("the program reaches nothing in {} of {} sources; they are left out, with what they would do "
                        "when it starts: {}",
                        unreached.size(), all, list));
}

bool is_by_hand(rewrite::Result const &rewritten) {
  return std::any_of(rewritten.kernels.begin(), rewritten.kernels.end(),
                     [](rewrite::Kernel const &kernel) { return kernel.by_hand; });
}

// Does the text itself, apart from flags, change arithmetic?
bool has_own_arithmetic(rewrite::Result const &rewritten) {
  return std::ranges::any_of(rewritten.diagnostics,
                             [](Diagnostic const &one) { return one.id == DiagnosticId::arithmetic_left_out; });
}

void build(FrontRequest const &request, BuildRequest const &parts, Front &front) {
  bool const is_rewritten = !request.run.from_instructions;
  std::vector<std::pair<Variant, std::string Front::*>> wanted = {
      {is_rewritten ? Variant::symbolic : Variant::recorded, &Front::symbolic_program}};
  if (request.replay && is_rewritten) wanted.emplace_back(Variant::replay, &Front::replay_program);
  if (request.replay && !is_by_hand(front.rewritten)) {
    wanted.emplace_back(Variant::original, &Front::original_program);
    for (rewrite::Compilation const &one : parts.sources)
      for (std::string const &flag : flags_of_numbers(one.flags))
        if (std::find(front.own_flags.begin(), front.own_flags.end(), flag) == front.own_flags.end())
          front.own_flags.push_back(flag);
    if (!front.own_flags.empty() || has_own_arithmetic(front.rewritten))
      wanted.emplace_back(Variant::own_flags, &Front::own_flags_program);
  }
  Overlay annotated;
  front.build = parts;
  if (request.replay) {
    front.annotated = rewrite::annotated_original(front.rewritten);
    annotated = Overlay(front.annotated, front.workspace->directory("annotated"));
  }
  std::vector<Variant> variants;
  for (auto const &[variant, program] : wanted) variants.push_back(variant);
  std::vector<std::string> const executables =
      build_variants(parts, variants, *front.overlay, is_rewritten ? annotated : *front.overlay, *front.workspace);
  for (std::size_t k = 0; k < wanted.size(); ++k) front.*wanted[k].second = executables[k];
  if (!request.branches) return;
  if (is_by_hand(front.rewritten))
    front.covered.obstacle = "the program is written with REAL by hand, and has no original";
  else
    front.covered = build_covered(parts, *front.overlay, annotated, *front.workspace);
}

} // namespace

void require_instructions(rewrite::Result const &annotated) {
  if (!llvm::sys::findProgramByName(clang_compiler))
    fail(DiagnosticId::oracle_not_possible, {}, fmt::format("there is no {} on this machine", clang_compiler));
  for (rewrite::Kernel const &kernel : annotated.kernels)
    if (kernel.by_hand)
      fail(DiagnosticId::oracle_not_possible, kernel.place,
           "the program is written with REAL by hand: it is its own original");
}

bool rewrite_sources(FrontRequest const &request, Front &front, Talk const &talk) {
  talk.stage("rewriting");
  Stopwatch const watch(front.rewrite_seconds);
  rewrite::Request source = request.source;
  source.annotations_only = request.run.from_instructions;
  front.rewritten = rewrite::run(source);
  // Messages and debug information are read in this directory, wherever the compiler runs.
  for (rewrite::File &file : front.rewritten.files) file.compiled_name = file.display_path;
  if (!report_all(front.rewritten.diagnostics, talk.report)) return false;
  if (source.annotations_only) require_instructions(front.rewritten);
  note_unreached(front.rewritten, rewrite::compilations_of(request.source).size(), talk);
  front.read = front.rewritten.read;
  for (std::string const &file : front.read) note_read(file);
  for (rewrite::TextSource const &one : request.source.texts)
    std::erase(front.read, rewrite::real_source({one.path, {}, {}}));
  front.wanted = wanted_kernels(front.rewritten, request);
  for (rewrite::Kernel const &kernel : front.wanted)
    if (source.annotations_only && !kernel.is_function)
      talk.note(fmt::format(
          "--record=instructions does not see what kernel '{}' reads of the locals around its block: it is baked in",
          kernel.name));
  return true;
}

bool build_programs(FrontRequest const &request, Front &front, Talk const &talk) {
  talk.stage("building");
  Stopwatch const watch(front.build_seconds);
  front.workspace = std::make_unique<Workspace>(request.keep);
  BuildRequest parts = build_request(request, front.rewritten);
  CSources c; // C sources, compiled as C++
  if (!request.run.from_instructions)
    c = as_in_c(front.rewritten, parts.sources, {parts.compiler}, {parts.c_compiler}, parts.type_name,
                *front.workspace);
  parts.source_flags = std::move(c.flags);
  parts.note = talk.note;
  front.overlay =
      std::make_unique<Overlay>(front.rewritten, front.workspace->directory("overlay"), std::move(c.sources));
  build(request, parts, front);
  return true;
}

RunOptions run_of(Front const &front, RunOptions run) {
  run.run_on |= is_by_hand(front.rewritten) && front.wanted.size() < front.rewritten.kernels.size();
  return run;
}

bool record_kernels(FrontRequest const &request, Front &front, Talk const &talk) {
  talk.stage("recording");
  Stopwatch const watch(front.run_seconds);
  Recording recording = record(front.symbolic_program, run_of(front, request.run), front.rewritten, front.wanted,
                               *front.overlay, *front.workspace, talk.program_output);
  explain_refusals(recording.diagnostics, front.rewritten.refusals);
  if (!report_all(recording.diagnostics, talk.report)) {
    for (Recorded const &kernel : recording.kernels)
      if (talk.lacking && !kernel.clauses.empty()) talk.lacking(kernel);
    return false;
  }
  front.kernels = std::move(recording.kernels);
  return true;
}

std::optional<Front> run_front(FrontRequest const &request, Talk const &talk) {
  Front front;
  bool const is_recorded = rewrite_sources(request, front, talk) && build_programs(request, front, talk) &&
                           record_kernels(request, front, talk);
  return is_recorded ? std::optional<Front>(std::move(front)) : std::nullopt;
}

} // namespace symreal::program
