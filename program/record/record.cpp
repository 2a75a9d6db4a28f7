#include "program/record/record.h"

#include "engine/graph/graph_binary.h"
#include "engine/support/files.h"
#include "program/build/process.h"
#include "program/record/explain_met.h"
#include "program/record/symbolize.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <llvm/ADT/StringExtras.h>
#include <set>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace symreal::program {
namespace {

using wire::Entry;

// A file in memory with a path in the file system.
//
// A graph of a hundred million nodes takes two gigabytes; a disk file would be written out although it is read at once.
class MemoryFile {
public:
  // Other processes of the same user open it by this path. Without system support nothing is created, and opening the
  // path for writing creates an ordinary file.
  explicit MemoryFile(std::string path) : path_(std::move(path)), descriptor_(memfd_create("symreal", MFD_CLOEXEC)) {
    if (descriptor_ < 0) return;
    std::string const opened = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(descriptor_);
    std::error_code problem;
    std::filesystem::create_symlink(opened, path_, problem);
  }
  // The file vanishes with its last descriptor.
  ~MemoryFile() {
    if (descriptor_ < 0) return;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    close(descriptor_);
  }
  MemoryFile(MemoryFile &&other) noexcept
      : path_(std::move(other.path_)),
        descriptor_(std::exchange(other.descriptor_, -1)) {}
  MemoryFile(MemoryFile const &) = delete;

private:
  std::string path_;
  int descriptor_;
};

// Command that makes the program record into the directory.
// `inert`: kernels to leave out, as the request has them.
Command recording_command(std::string const &executable, RunOptions const &options, std::string const &inert,
                          std::string const &directory) {
  Command command{.arguments = {executable},
                  .directory = options.directory,
                  .standard_input = options.standard_input,
                  .time_limit = options.time_limit};
  command.arguments.insert(command.arguments.end(), options.arguments.begin(), options.arguments.end());
  std::optional<ExploreBounds> const bounds = explore_bounds(options.decisions);
  command.notes_opened = true;
  command.at_fixed_addresses = bounds.has_value();
  std::string const policy = !bounds ? options.decisions : bounds->selects ? "auto" : "explore";
  command.request.set(Entry::record, directory);
  command.request.set(Entry::decisions, policy);
  command.request.set(Entry::fp, options.floating_point);
  command.request.set(Entry::places, options.places ? "1" : "0");
  if (options.from_instructions) command.request.set(Entry::watch, "1");
  if (!inert.empty()) command.request.set(Entry::inert, inert);
  return command;
}

// Does the K-th kernel have decisions to explore, by the first run, which had the first kernel on a path?
bool is_to_explore(Events const &first_run, std::size_t kernel) {
  return kernel == 0
             ? !first_run.decided.empty()
             : std::find(first_run.undecided.begin(), first_run.undecided.end(), kernel) != first_run.undecided.end();
}

// Time limit in seconds, given the time of the first run. A path against the program's values may loop for ever.
double path_time_limit(double first_run, RunOptions const &options) {
  double const generous = 20 * first_run + 5;
  return options.time_limit > 0 ? std::min(options.time_limit, generous) : generous;
}

// Runs the program along this path of the K-th kernel, where it ends. Leaves `directory` to the next run.
PathRun run_along(std::string const &path, std::size_t kernel, std::string const &executable, RunOptions const &options,
                  std::string const &inert, std::string const &directory) {
  std::string const graph = directory + "/" + std::to_string(kernel) + ".graph", taken = directory + "/taken";
  for (std::string const &old : {graph, taken, directory + "/events"}) std::filesystem::remove(old);
  Command program = recording_command(executable, options, inert, directory);
  program.request.set(Entry::path, path);
  program.request.set(Entry::kernels, std::to_string(kernel + 1));
  Outcome const end = run(program, [](std::string_view) {}); // discards the output, which belongs to another path
  PathRun result{read_events(directory + "/events")};
  result.is_late = end.ending == Ending::timed_out;
  result.seconds = end.seconds;
  if (std::filesystem::exists(graph)) result.graph = read_binary_graph(graph);
  if (std::filesystem::exists(taken)) result.taken = read_file(taken);
  return result;
}

// Names under which a kernel begins: a function's own, or the place of a block's first annotation.
std::set<std::string> beginnings(std::vector<rewrite::Kernel> const &kernels) {
  std::set<std::string> names;
  for (rewrite::Kernel const &kernel : kernels) {
    if (kernel.is_function)
      names.insert(kernel.name);
    else
      for (rewrite::Annotation const &one : kernel.annotations) names.insert(to_string(one.place));
  }
  return names;
}

// The kernels of the program that are not wanted, which the program runs as plain code.
std::string inert_kernels(std::vector<rewrite::Kernel> const &all, std::vector<rewrite::Kernel> const &wanted) {
  if (wanted.empty()) return "";
  std::set<std::string> const recorded = beginnings(wanted);
  std::string inert;
  for (std::string const &name : beginnings(all))
    if (!recorded.contains(name)) inert += name + "\n";
  return inert;
}

bool is_recording_of(RecordedKernel const &recorded, rewrite::Kernel const &kernel) {
  return recorded.name == kernel.name || (!kernel.output_file.empty() && recorded.output_file == kernel.output_file);
}

bool is_begun(rewrite::Kernel const &kernel, std::vector<std::string> const &started) {
  return std::any_of(started.begin(), started.end(), [&](std::string const &name) {
    return name == kernel.name || (!kernel.annotations.empty() && name == to_string(kernel.annotations.front().place));
  });
}

// Notes on where the state was first read, with the call path.
std::vector<Note> read_notes(Frozen const &state, FrozenRead const &read, Symbolizer &symbolizer) {
  constexpr std::size_t most = 4;
  std::vector<Note> notes;
  std::vector<Frame> frames = symbolizer.frames(read.stack);
  auto frame = std::find_if(frames.begin(), frames.end(), [](Frame const &one) { return one.rewritten; });
  for (bool innermost = true; frame != frames.end() && notes.size() < most; ++frame, innermost = false) {
    bool const same = innermost && frame->place.file == state.place.file && frame->place.line == state.place.line;
    if (frame->rewritten && !same)
      notes.push_back({frame->place, (innermost ? "first read in " : "called from ") + frame->function});
  }
  return notes;
}

std::optional<Place> own_place(std::vector<std::uint64_t> const &addresses, Symbolizer &symbolizer) {
  for (Frame const &frame : symbolizer.frames(addresses))
    if (frame.rewritten) return frame.place;
  return std::nullopt;
}

void locate_frozen(Recorded &recorded, std::vector<FrozenRead> const &reads, Symbolizer &symbolizer) {
  std::set<FrozenRead const *> met;
  for (Frozen &state : recorded.graph.frozen) {
    auto read = std::find_if(reads.begin(), reads.end(), [&](FrozenRead const &one) {
      return one.kernel == recorded.graph.kernel && one.name == state.name && one.place == to_string(state.place) &&
             !met.contains(&one);
    });
    if (read != reads.end()) met.insert(&*read);
    // State from outside the program gets the place of the program's call.
    if (read != reads.end() && state.place.file.empty())
      state.place = own_place(read->stack, symbolizer).value_or(Place());
    recorded.frozen_reads.push_back(read == reads.end() ? std::vector<Note>() : read_notes(state, *read, symbolizer));
  }
}

// Explains, by how the program ended, why a requested kernel is missing.
Diagnostic explain_missing(rewrite::Kernel const &kernel, bool begun, Outcome const &outcome) {
  Diagnostic diagnostic{DiagnosticId::kernel_not_reached, kernel.place, ""};
  if (!kernel.annotations.empty()) diagnostic.place = kernel.annotations.front().place;
  std::string waited_for = kernel.name.empty()  ? std::string(begun ? "the end of a kernel" : "a kernel")
                           : begun              ? fmt::format("the end of kernel '{}'", kernel.name)
                           : kernel.is_function ? fmt::format("a call of function '{}'", kernel.name)
                                                : fmt::format("the annotations of kernel '{}'", kernel.name);
  switch (outcome.ending) {
  case Ending::not_started:
    diagnostic = {DiagnosticId::program_not_started, {}, "the program cannot be started: "};
    diagnostic.message += std::strerror(outcome.status);
    break;
  case Ending::timed_out:
    diagnostic.id = DiagnosticId::program_timed_out;
    diagnostic.message = fmt::format("after {:.0f} s the program had not reached {}", outcome.seconds, waited_for);
    break;
  case Ending::signalled:
    diagnostic.id = DiagnosticId::program_crashed;
    diagnostic.message = fmt::format("signal {} ({}) ended the program before it reached {}", outcome.status,
                                     strsignal(outcome.status), waited_for);
    if (outcome.status == SIGKILL) diagnostic.message += "; the system does that when memory runs out";
    break;
  case Ending::over_limit: // unreachable: the program has no such limit, and runs until it is told to end
  case Ending::stopped:
  case Ending::exited:
    diagnostic.message =
        fmt::format("the program ended with status {} and never reached {}", outcome.status, waited_for);
    break;
  }
  return diagnostic;
}

bool has_error(std::vector<Diagnostic> const &diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](Diagnostic const &diagnostic) { return diagnostic.severity == Severity::error; });
}

// Adds the lacking clauses to the last diagnostic about state that the kernel leaves.
void add_clauses(Recorded const &recorded, std::vector<Diagnostic> &diagnostics) {
  bool const leaves = std::any_of(recorded.clauses.begin(), recorded.clauses.end(),
                                  [](auto const &one) { return one.first != "input" && one.first != "constant"; });
  if (!leaves) return; // --frozen handles state that is only read
  auto const last = std::find_if(diagnostics.rbegin(), diagnostics.rend(),
                                 [](Diagnostic const &one) { return one.id == DiagnosticId::state_not_output; });
  if (last == diagnostics.rend()) return;
  auto const found = recorded.clauses.find("elsewhere");
  if (recorded.clauses.size() > (found != recorded.clauses.end()))
    last->notes.push_back(clause_note(recorded.kernel, recorded.clauses));
  if (found != recorded.clauses.end())
    last->notes.push_back(
        {recorded.kernel.place, "only a kernel in their own file can name these static variables: " + found->second});
}

// Kernels of a program whose sources are unavailable.
std::vector<rewrite::Kernel> kernels_of(Events const &events) {
  std::vector<rewrite::Kernel> kernels;
  for (RecordedKernel const &recorded : events.kernels) {
    kernels.emplace_back().name = recorded.name;
    kernels.back().output_file = recorded.output_file;
  }
  return kernels;
}

// Sets the decided places under policy auto, also for a kernel that needed no exploration.
void tell_places(Graph const &graph, Symbolizer &symbolizer, std::optional<Exploration> &exploration) {
  if (!exploration) exploration.emplace().paths = 1;
  exploration->guards = graph.guards.size();
  auto const places = [&](std::vector<std::vector<std::uint64_t>> const &all) {
    std::vector<Place> found;
    for (std::vector<std::uint64_t> const &addresses : all)
      if (std::optional<Place> const place = own_place(addresses, symbolizer)) found.push_back(*place);
    return found;
  };
  exploration->places = decided_places(graph, places(exploration->explored), places(exploration->joined_at));
}

bool is_same_place(Diagnostic const &a, Diagnostic const &b) {
  return a.id == b.id && to_string(a.place) == to_string(b.place);
}

// Adds the diagnostics that no earlier run gave.
void add_news(std::vector<Diagnostic> news, std::vector<Diagnostic> &all) {
  for (Diagnostic &one : news)
    if (std::none_of(all.begin(), all.end(), [&](Diagnostic const &known) { return is_same_place(known, one); }))
      all.push_back(std::move(one));
}

void add_news(std::vector<FrozenRead> const &news, std::vector<FrozenRead> &all) {
  for (FrozenRead const &one : news) {
    auto const is_same = [&](FrozenRead const &known) {
      return known.kernel == one.kernel && known.name == one.name && known.place == one.place;
    };
    if (std::none_of(all.begin(), all.end(), is_same)) all.push_back(one);
  }
}

} // namespace

// Phrases the clauses as the kernel was requested: by a pragma, a call, or a configuration entry, which may be either.
Note clause_note(rewrite::Kernel const &kernel, Clauses const &clauses, std::string const &behind) {
  std::string pragma, entry, items, outputs;
  for (std::string const clause : {"input", "output", "constant", "scratch"}) {
    auto const found = clauses.find(clause);
    if (found == clauses.end()) continue;
    std::string const before = clause == "input" ? ", " : ", " + clause + " ";
    pragma += " " + clause + "(" + found->second + ")";
    entry += (entry.empty() ? "" : ", ") + clause + (clause.ends_with("put") ? "s: [" : ": [") + found->second + "]";
    if (clause == "output") {
      outputs = " -> ..., " + found->second;
      continue;
    }
    llvm::SmallVector<llvm::StringRef> names;
    llvm::StringRef(found->second).split(names, ", ");
    items += before + llvm::join(names, before);
  }
  std::string const call = kernel.name + "(..." + items + ")" + outputs;
  std::string text = "#pragma symreal" + std::string(kernel.is_function ? " function ..." : "") + pragma;
  if (kernel.place.file == "--kernel") text = call;
  if (kernel.place.file.ends_with(".yaml")) text = entry + "; in a call: " + call;
  return {kernel.place, "all of them at once: " + text + behind};
}

Recording record(std::string const &executable, RunOptions const &options, rewrite::Result const &rewritten,
                 std::vector<rewrite::Kernel> const &wanted, Overlay const &overlay, Workspace const &workspace,
                 LineSink const &sink) {
  std::string directory = workspace.directory("recording");
  std::optional<ExploreBounds> const bounds = explore_bounds(options.decisions);
  FloatingPoint const mode = parse_floating_point(options.floating_point).value_or(FloatingPoint::finite);
  std::string const inert = inert_kernels(rewritten.kernels, wanted);
  Command program = recording_command(executable, options, inert, directory);
  if (bounds) program.request.set(Entry::path, path_text(0, {}, false, *bounds, 0));
  if (!options.run_on && !wanted.empty()) program.request.set(Entry::kernels, std::to_string(wanted.size()));
  std::vector<MemoryFile> files; // named as the program will name them
  for (std::size_t k = 0; k < std::max<std::size_t>(wanted.size(), 1); ++k)
    files.emplace_back(directory + "/" + std::to_string(k) + ".graph");
  Outcome outcome = run(program, sink);

  Recording recording;
  recording.seconds = outcome.seconds;
  Events events = read_events(directory + "/events");
  recording.diagnostics = events.diagnostics;
  Symbolizer symbolizer(executable, overlay);
  DecidingTexts const texts(rewritten.deciding);
  for (Diagnostic &one : explain_met(events, symbolizer, texts)) recording.diagnostics.push_back(std::move(one));
  bool explained = has_error(recording.diagnostics);
  // Runs along a path of a kernel; nullopt after an error.
  auto run_path = [&](std::size_t kernel, std::string const &path, RunOptions const &along) -> std::optional<PathRun> {
    PathRun one = run_along(path, kernel, executable, along, inert, workspace.directory("path"));
    add_news(one.events.diagnostics, recording.diagnostics);
    add_news(explain_met(one.events, symbolizer, texts), recording.diagnostics);
    add_news(one.events.frozen, events.frozen);
    explained = has_error(recording.diagnostics);
    return explained ? std::nullopt : std::optional<PathRun>(std::move(one));
  };
  auto missing = [&](rewrite::Kernel const &kernel, bool begun) {
    recording.diagnostics.push_back(explain_missing(kernel, begun, outcome));
    if (outcome.ending == Ending::signalled)
      explain_crash(recording.diagnostics.back(), read_crash(directory + "/crash"), symbolizer);
  };
  std::vector<rewrite::Kernel> const kernels = wanted.empty() ? kernels_of(events) : wanted;
  if (kernels.empty() && !explained) missing({}, !events.started.empty());
  for (rewrite::Kernel const &kernel : kernels) {
    auto found = std::find_if(events.kernels.begin(), events.kernels.end(),
                              [&](RecordedKernel const &recorded) { return is_recording_of(recorded, kernel); });
    if (found != events.kernels.end()) {
      Graph graph = read_binary_graph(directory + "/" + found->graph_file);
      if (kernels.size() == 1) files.clear(); // frees memory for the next steps
      std::optional<Exploration> exploration;
      auto const number = static_cast<std::size_t>(found - events.kernels.begin());
      if (bounds && !explained && is_to_explore(events, number)) {
        RunOptions along = options;
        auto const run = [&, is_first = true](std::string const &path) mutable {
          std::optional<PathRun> one = run_path(number, path, along);
          if (is_first && one) along.time_limit = path_time_limit(std::max(outcome.seconds, one->seconds), options);
          is_first = false;
          return one;
        };
        std::optional<MetPaths> met;
        auto const choose = [&](Graph const &interface) {
          if (!options.paths_met.empty()) met.emplace(options.paths_met, interface);
          return met;
        };
        std::optional<Graph> whole = explore(number, kernel.place, *bounds, run, choose, exploration.emplace());
        if (!whole) continue;
        graph = std::move(*whole);
        if (met) met->require_inside(graph, mode, kernel.place);
        add_news(open_branches(kernel, *exploration, *bounds), recording.diagnostics);
      }
      resolve(graph, symbolizer);
      if (bounds && bounds->selects) tell_places(graph, symbolizer, exploration);
      say_in_words_of_source(graph, texts);
      graph.decisions = options.decisions;
      graph.from_instructions = options.from_instructions;
      name_nodes(graph, rewritten.names);
      recording.kernels.push_back({std::move(graph), kernel, found->output_file, found->begun_as});
      recording.kernels.back().scratch = found->scratch;
      recording.kernels.back().clauses = found->clauses;
      recording.kernels.back().exploration = exploration;
      add_clauses(recording.kernels.back(), recording.diagnostics);
      if (!events.frozen.empty()) locate_frozen(recording.kernels.back(), events.frozen, symbolizer);
    } else if (!explained) {
      bool begun = is_begun(kernel, events.started);
      missing(kernel, begun);
    }
  }
  return recording;
}

} // namespace symreal::program
