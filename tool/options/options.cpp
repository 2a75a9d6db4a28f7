#include "tool/options/options.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/names.h"
#include "engine/optimise/passes/pass.h"
#include "engine/optimise/passes/snap.h"
#include "engine/support/number.h"
#include "program/build/object_cache.h"
#include "program/build/process.h"
#include "program/build/read_files.h"
#include "tool/options/cost_option.h"

namespace symreal::tool {

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
                 "Select a kernel by name, or call a function without a program: 'f(x[0:3]=0.5, n=3) -> y[0:3]'")
      ->type_name("NAME|CALL");
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

void PassOptions::add_to(CLI::App &app) {
  app.add_option("--fp", mode, "Floating-point mode: finite, strict or fast")->capture_default_str();
  std::string names;
  for (PassInfo const &pass : pass_table()) names += std::string(names.empty() ? "" : ", ") + std::string(pass.name);
  passes_option =
      app.add_option("--passes", passes, "Passes, separated by commas, or default or none; available: " + names)
          ->capture_default_str();
  effort_option =
      app.add_option("--effort", effort, "Effort of structure recovery, 0 (none) to 3 (minutes); mode fast only")
          ->capture_default_str();
  app.add_option("--target-cost", target_cost,
                 "Operation costs on the target, which guide the passes: unit (1 each), table (the table of "
                 "operations), or a file written by symreal measure-costs")
      ->type_name("unit|table|FILE")
      ->capture_default_str();
  app.add_flag("--snap{" + shortest(usual_snap) + "}", snap,
               "Round computed constants within this distance of 0, 1, -1, 1/2 or -1/2 to these numbers (mode fast)");
  tolerance_option =
      app.add_option("--tol", tolerance, "Largest relative change of an output due to --snap")->capture_default_str();
}

std::optional<double> PassOptions::snap_distance() const {
  if (tolerance_option && tolerance_option->count() != 0 && snap.empty())
    fail(DiagnosticId::option_without_effect, {}, "--tol has no effect without --snap");
  if (snap.empty()) return std::nullopt;
  if (floating_point() != FloatingPoint::fast)
    fail(DiagnosticId::option_without_effect, {}, "--snap has no effect without --fp=fast");
  std::optional<double> const distance = parse_number(snap);
  if (!distance || !(*distance > 0 && *distance <= largest_snap))
    fail(DiagnosticId::bad_option, {},
         "--snap takes a distance above 0 and up to " + shortest(largest_snap) + ", not '" + snap + "'");
  return distance;
}

PassSettings PassOptions::settings() const {
  if (effort < algebra::least_effort || effort > algebra::most_effort)
    fail(DiagnosticId::bad_option, {}, "--effort takes 0, 1, 2 or 3, not " + std::to_string(effort));
  if (effort_option && effort_option->count() != 0 && floating_point() != FloatingPoint::fast)
    fail(DiagnosticId::option_without_effect, {}, "--effort has no effect without --fp=fast");
  (void)snap_distance();
  return {floating_point(), effort, cost_model(costs_named(target_cost))};
}

FloatingPoint PassOptions::floating_point() const {
  auto parsed = parse_floating_point(mode);
  if (!parsed) fail(DiagnosticId::bad_option, {}, "--fp takes finite, strict or fast, not '" + mode + "'");
  return *parsed;
}

std::vector<std::string> PassOptions::names() const { return parse_passes(passes); }

void EmitterOptions::add_to(CLI::App &app) {
  app.add_option("--prefix", prefix, "Prefix of every external name of the generated code: P gives P_compute")
      ->each([](std::string const &given) {
        if (!given.empty() && identifier(given) != given)
          fail(DiagnosticId::bad_option, {}, "--prefix takes a name of C and C++, not '" + given + "'");
      });
  app.add_option("--real", real, "Number type of the generated code: double, or float for single precision")
      ->capture_default_str();
  app.add_option("--sines", sines,
                 "Compute sines and cosines of inputs 'side-by-side' in a loop (default) or each by the 'library' (C "
                 "and C++, mode fast)")
      ->type_name("WORD");
  auto const add_extra = [&](std::string const &name, std::string const &doc) {
    app.add_flag_callback("--" + name, [this, name] { extras.insert(name); }, doc);
  };
  add_extra("mainline", "Also emit a program that runs the generated code");
  add_extra("mex", "Also emit a MEX gateway to the C code, for MATLAB and Octave");
  add_extra("simulink", "Also emit an S-function that calls the C code, for Simulink");
  app.add_flag("--trace-comments", trace_comments, "Annotate each statement with its source lines");
  app.add_option("--map", map_file, "Also write a map from generated lines to source lines, as JSON")
      ->type_name("FILE");
  app.add_flag("--check-values", check_values,
               "Emit debug code that reports the first NaN or infinity with its source line");
}

bool EmitterOptions::is_single() const {
  require_one_of("--real", real, "double|float");
  return real == "float";
}

bool EmitterOptions::has_angles(FloatingPoint mode) const {
  if (!sines.empty()) require_one_of("--sines", sines, "side-by-side|library");
  bool const can = mode == FloatingPoint::fast && !is_single();
  if (sines == "side-by-side" && !can)
    fail(DiagnosticId::bad_option, {},
         is_single() ? "--sines=side-by-side computes with doubles: leave --real=float or this out"
                     : "--sines=side-by-side does not give the bits of the library, which only --fp=fast permits");
  return can && sines != "library";
}

void require_no_source_options(CLI::App &command, std::string const &instead) {
  for (char const *const name : {"-o", "--lang", "--wrapper", "--mainline", "--mex", "--simulink", "--real", "--map",
                                 "--parallel", "--reroll", "--vector"}) {
    CLI::Option const *const option = command.get_option_no_throw(name);
    if (option && option->count() != 0)
      fail(DiagnosticId::option_without_effect, {},
           std::string(name) + " has no effect with " + instead + ", which writes sources of its own");
  }
}

void require_one_of(std::string const &option, std::string const &value, std::string_view words) {
  for (std::string_view rest = words; !rest.empty();) {
    std::size_t end = rest.find('|');
    if (rest.substr(0, end) == value) return;
    rest = end == rest.npos ? "" : rest.substr(end + 1);
  }
  fail(DiagnosticId::bad_option, {}, option + " takes " + std::string(words) + ", not '" + value + "'");
}

} // namespace symreal::tool
