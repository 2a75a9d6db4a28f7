#include "engine/diagnostics/diagnostic.h"
#include "engine/emit/origins/origins.h"
#include "engine/graph/names.h"
#include "engine/support/files.h"
#include "engine/support/number.h"
#include "program/build/read_files.h"
#include "program/wrapper/baked_values.h"
#include "program/wrapper/wrapped_original.h"
#include "rewrite/text/source_text.h"
#include "tool/calls/driver_program.h"
#include "tool/commands/subcommands.h"
#include "tool/options/option_table.h"
#include "tool/options/recording_options.h"
#include "tool/output/outputs.h"
#include "tool/report/certificate.h"
#include "tool/report/console.h"
#include "tool/report/verification_record.h"
#include "tool/report/verify_report.h"
#include "verify/bisection.h"
#include "verify/generated_header.h"
#include "verify/numeric_identity.h"
#include "verify/verification.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

struct Options {
  SourceOptions source;
  std::vector<std::string> files; // sources, then generated files
  program::VerificationOptions verification;
  CLI::Option *tolerance = nullptr;
  std::string c_compiler, shard, replay, certificate, check, paths_met;
  bool json = false, bisect = false, merge = false, numeric = false;
};

// Parses "K/N"; K counts from 1.
program::Shard parse_shard(std::string const &text) {
  std::size_t const slash = text.find('/');
  auto const number = [&](std::string const &digits) -> std::size_t {
    bool const is_number =
        !digits.empty() && digits.size() < 10 && digits.find_first_not_of("0123456789") == digits.npos;
    return is_number ? std::stoul(digits) : 0;
  };
  std::size_t const k = number(text.substr(0, slash)), n = slash == text.npos ? 0 : number(text.substr(slash + 1));
  if (k == 0 || k > n)
    fail(DiagnosticId::bad_option, {}, "--shard takes K/N with K from 1 to N, such as 2/8, and not '" + text + "'");
  return {k - 1, n};
}

// Refuses options of the command line that have no effect in this mode.
void require_only(std::set<std::string> const &known, char const *mode, CLI::App const &command,
                  Session const &session) {
  for (CLI::Option const *one : command.get_options())
    if (one->count() != 0 && !known.contains(one->get_name()) && !session.configured.contains(one->get_name()))
      fail(DiagnosticId::option_without_effect, {}, one->get_name() + " has no effect with " + mode);
}

void print_json(nlohmann::ordered_json const &kernels) {
  std::cout << (kernels.size() == 1 ? kernels.front() : nlohmann::ordered_json{{"kernels", kernels}}).dump(2) << "\n";
}

// Joins the results of all shards of a verification. Returns the exit status.
int merge(CLI::App const &command, Options const &options, Session const &session) {
  require_only({"files", "--merge", "--json"}, "--merge", command, session);
  refuse_flags(session);
  if (options.files.empty())
    fail(DiagnosticId::bad_option, {}, "--merge takes results of verify --json, a file a shard");
  std::vector<VerificationRecord> joined;
  for (std::string const &file : options.files)
    for (VerificationRecord const &record : read_records(file)) {
      auto const found = std::ranges::find_if(joined, [&](VerificationRecord const &one) {
        return one.graph.kernel == record.graph.kernel && one.file == record.file;
      });
      if (found == joined.end())
        joined.push_back(record);
      else
        join(*found, record, file);
    }
  int status = clean;
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (VerificationRecord &record : joined) {
    std::size_t const count = record.options.shard.count;
    if (record.shards.size() != count)
      fail(DiagnosticId::verification_file, {options.files.back()},
           "kernel '" + record.graph.kernel + "' was verified in " + std::to_string(count) +
               " shards, and the files have " + std::to_string(record.shards.size()) + " of them");
    record.options.shard = {};
    record.shards = {0};
    print_verification(std::cerr, record.graph, record.verification);
    results.push_back(to_json(record));
    if (auto failure = verification_failure(record.graph, record.verification, record.options, record.file)) {
      print(std::cerr, *failure);
      status = verification_failed;
    }
  }
  if (options.json) print_json(results);
  return status;
}

// Compares object code before and after rewriting. Returns the exit status.
int compare_numeric(CLI::App &command, Options &options, Session &session) {
  ProjectOptions &project = options.source.project;
  project.request.sources = options.files;
  project.configure(command, session.configured);
  require_only({"files", "--root", "--cxx", "--cc", "--numeric", "-p", "-j", "--config", "--type-name", "--keep"},
               "--numeric", command, session);
  rewrite::Request request = only_rewritten(project.complete(session.flags));
  request.leave_out_broken = true;
  std::vector<rewrite::Compilation> sources = rewrite::compilations_of(request);
  std::size_t const asked = sources.size();
  rewrite::Result const rewritten = rewrite::run(request);
  // Obstacles to the symbolic program, such as functions defined elsewhere, do not affect the numeric one.
  std::size_t obstacles = 0;
  for (Diagnostic const &diagnostic : rewritten.diagnostics) {
    bool const is_obstacle = diagnostic.severity == Severity::error && diagnostic.id != DiagnosticId::source_error;
    obstacles += is_obstacle ? 1 : 0;
    if (!is_obstacle) print(std::cerr, diagnostic);
  }
  if (obstacles != 0)
    std::cerr << "note: " << obstacles << " obstacles to the symbolic program do not count here; `symreal scan` lists "
              << "them\n";
  for (std::string const &source : rewritten.left_out) std::cerr << "left out, does not compile: " << source << "\n";
  std::erase_if(sources, [&](rewrite::Compilation const &one) {
    return std::ranges::find(rewritten.left_out, one.source) != rewritten.left_out.end();
  });
  bool const keep = options.source.front.keep;
  program::Workspace const workspace(keep);
  if (keep) std::cerr << "the objects and the rewritten sources are in " << workspace.path() << "\n";
  bool const names_compiler = command.get_option("--cxx")->count() != 0;
  program::ObjectComparison const result = program::compare_object_code(
      sources, rewritten, {options.c_compiler, names_compiler ? options.source.front.build.compiler : ""}, request.jobs,
      workspace);
  for (Diagnostic const &diagnostic : result.diagnostics) print(std::cerr, diagnostic);
  std::cout << result.identical << " of " << asked << " translation units have identical object code\n";
  if (result.identical != result.compared) return verification_failed;
  return result.compared == asked ? clean : error;
}

// Takes the generated files from the end of the list, the last one in any case: errors in it are reported later.
std::vector<std::string> take_generated(std::vector<std::string> &files) {
  auto first = files.end();
  while (first != files.begin() && program::is_generated(*(first - 1))) --first;
  if (first == files.end() && first != files.begin()) --first;
  std::vector<std::string> generated(first, files.end());
  files.erase(first, files.end());
  return generated;
}

// Builds and records the programs under the options of the generated file's banner.
// `kernels`: of all generated files.
std::optional<program::Front> make_front(Options const &options, Session &session, program::Banner const &banner,
                                         std::vector<std::string> const &kernels, program::RunOptions &run,
                                         Console &console) {
  program::FrontRequest request = options.source.request(session.flags);
  if (!options.c_compiler.empty()) request.build.c_compiler = options.c_compiler;
  request.verified = kernels;
  request.replay = true;
  request.branches = options.verification.branches;
  request.run.decisions = banner.decisions;
  request.run.paths_met = options.paths_met;
  request.run.floating_point = to_string(banner.mode);
  request.run.from_instructions = banner.from_instructions;
  request.run.places = true;
  run = request.run;
  std::optional<program::Front> front;
  with_driver(request, options.source.project.calls, console.talk(), console,
              [&](program::FrontRequest const &called, program::Talk const &talk) { front = run_front(called, talk); });
  if (front && request.keep) console.note("the build directory is " + front->workspace->path());
  return front;
}

// Is this a copy of the function's file in which the function calls generated code with this prefix?
bool is_copy_with(fs::path const &path, rewrite::Redefinition const &function, std::string const &prefix) {
  if (!fs::is_regular_file(path) || path.extension() != fs::path(function.file).extension()) return false;
  std::string const text = read_file(path.string()), name = fs::path(function.file).filename().string();
  return text.starts_with("/* Generated by Symreal: a copy of " + name + ", ") &&
         text.find(" " + prefix + "_compute(double const *") != text.npos;
}

// Path of the wrapper beside the generated file: a file, or a directory of copies. One that several kernels share has
// the name of the first.
std::optional<std::string> find_wrapper(std::string const &generated, std::string const &prefix,
                                        rewrite::Kernel const &kernel) {
  fs::path const stem = fs::path(generated).replace_extension().string() + "_wrapper";
  rewrite::Redefinition const &function = kernel.signature.redefinition;
  for (std::string const &suffix :
       {std::string(".c"), std::string(".cpp"), fs::path(kernel.source).extension().string()})
    if (std::string const path = stem.string() + suffix; fs::is_regular_file(path)) return path;
  if (fs::is_directory(stem))
    for (fs::directory_entry const &one : fs::recursive_directory_iterator(stem))
      if (one.is_regular_file() && one.path().filename() == fs::path(function.file).filename())
        return one.path().string();
  if (prefix.empty()) return {};
  fs::path const directory = fs::path(generated).parent_path();
  for (fs::directory_entry const &beside : fs::directory_iterator(directory.empty() ? "." : directory)) {
    if (!beside.path().stem().string().ends_with("_wrapper")) continue;
    if (is_copy_with(beside.path(), function, prefix)) return beside.path().string();
    if (!beside.is_directory()) continue;
    for (fs::directory_entry const &one : fs::recursive_directory_iterator(beside.path()))
      if (is_copy_with(one.path(), function, prefix)) return one.path().string();
  }
  return {};
}

// Does the wrapper's file replace the kernel's function by code with this prefix? In a copy, line directives end what
// is inserted for each function.
bool is_wrapper_of(std::string const &text, std::string const &prefix, program::Recorded const &recorded) {
  if (prefix.empty()) return program::is_wrapper_of(text, recorded);
  std::string const called = prefix + "_compute(symreal_input", directive = "\n#line ";
  for (std::size_t at = text.find(called); at != text.npos; at = text.find(called, at + 1)) {
    if (at != 0 && rewrite::is_word(text[at - 1])) continue; // of a longer prefix
    std::size_t const before = text.rfind(directive, at), begin = before == text.npos ? 0 : before;
    if (program::is_wrapper_of(text.substr(begin, text.find(directive, at) - begin), recorded)) return true;
  }
  return false;
}

// Is there a wrapper of this kernel? Throws for one of another kernel.
bool has_wrapper(program::Front &front, program::RunOptions const &run, std::string const &generated,
                 std::string const &prefix, program::Recorded const &recorded) {
  if (!recorded.kernel.is_function || program::is_generated_cpp(generated)) return false;
  std::optional<std::string> const path = find_wrapper(generated, prefix, recorded.kernel);
  if (!path) return false;
  for (program::Recorded &one : front.kernels)
    if (&one == &recorded) program::add_baked_values(front, run, one);
  if (!is_wrapper_of(read_file(*path), prefix, recorded))
    fail(DiagnosticId::foreign_file, {*path, 1, 1},
         "this wrapper was generated for another form of kernel '" + recorded.kernel.name + "'");
  return true;
}

// Describes the pass that makes the difference.
std::string bisected(program::Recorded const &recorded, program::Banner const &banner,
                     program::Verification const &verification, program::VerificationOptions const &options) {
  auto const output = std::ranges::find_if(verification.outputs, [](auto const &one) { return one.different != 0; });
  if (output == verification.outputs.end()) return "bisection: no output differs in a single call";
  Graph const &graph = recorded.graph;
  if (!graph.externals.empty() || banner.is_single)
    return "bisection: a graph of code in single precision, or that calls functions, cannot be evaluated pass by pass";
  std::optional<program::Culprit> const culprit =
      program::find_culprit(graph, program::default_pipeline(banner.mode), PassSettings(banner.mode), options.tolerance,
                            verification.named.at(output->worst_sample));
  if (!culprit)
    return "bisection: no pass of the usual ones changes an output there: the difference comes with the recording, "
           "with the emitted code or with its compilation";
  std::vector<std::string> const names = identifiers(graph.outputs);
  std::string text;
  for (std::size_t i = 0; i < graph.outputs.size(); ++i)
    if (Object const &object = graph.outputs[i]; culprit->output - object.first < object.count)
      text = fmt::format("bisection: pass {} is the first to change an output: {} from {} to {}", culprit->pass,
                         element_name(names[i], object, static_cast<std::uint32_t>(culprit->output - object.first)),
                         shortest(culprit->before), shortest(culprit->after));
  if (culprit->rewrites == 0) return text;
  text += fmt::format("; its rewrite number {} does it: {}", culprit->rewrites, culprit->rule);
  std::string const place = culprit->location == no_location ? "" : describe_locations(graph, {culprit->location});
  return place.empty() ? text : text + ", of what stands at " + place;
}

void note_other_mathematics(std::string const &made, std::string const &before, std::string const &now,
                            Console &console) {
  if (std::string const other = other_mathematics(made, before, now); !other.empty()) console.note(other);
}

// Does the run confirm the certificate?
bool confirms(std::string const &path, nlohmann::ordered_json const &wanted, nlohmann::ordered_json const &run,
              Console &console) {
  std::vector<std::string> const found = differences(wanted, run);
  note_other_mathematics("the certificate was written", wanted.value("mathematics", ""), run.value("mathematics", ""),
                         console);
  if (found.empty()) {
    console.note("certificate " + path + " holds");
    return true;
  }
  Diagnostic refused{DiagnosticId::certificate_refused, {path}, "this certificate does not hold: " + found.front()};
  for (std::size_t k = 1; k < found.size(); ++k) refused.notes.push_back({{}, found[k]});
  console.report(refused);
  return false;
}

// Requires the sample table of code with --paths-met, which the same samples must record again.
void require_table(std::string const &table, std::vector<std::string> const &generated,
                   std::vector<program::Banner> const &banners) {
  bool is_used = false;
  for (std::size_t k = 0; k < generated.size(); ++k) {
    std::optional<program::ExploreBounds> const bounds = program::explore_bounds(banners[k].decisions);
    if (!bounds || bounds->met.empty()) continue;
    is_used = true;
    if (table.empty())
      fail(DiagnosticId::bad_option, {generated[k], 1, 1},
           "this file was generated with --paths-met: give verify the same table of samples");
    if (met_hash(table) != bounds->met)
      fail(DiagnosticId::paths_met_file, {table, 1, 1},
           "'" + generated[k] + "' was generated with another table of samples");
  }
  if (!table.empty() && !is_used)
    fail(DiagnosticId::option_without_effect, {}, "--paths-met has no effect: no generated file had it");
}

int run(CLI::App &command, Options &options, Session &session) {
  require_compatible(command);
  if (!options.shard.empty()) options.verification.shard = parse_shard(options.shard);
  std::optional<nlohmann::ordered_json> wanted;
  if (!options.check.empty()) {
    wanted = read_certificate(options.check);
    program::VerificationOptions const certified = options_of(*wanted, options.check);
    options.verification.samples = certified.samples;
    options.verification.min_samples = certified.min_samples;
    options.verification.seed = certified.seed;
    options.verification.tolerance = certified.tolerance;
    options.verification.branches = certified.branches;
    options.verification.exact_bits = certified.exact_bits;
  }
  std::vector<std::string> sources = options.files;
  std::vector<std::string> const generated = take_generated(sources);
  if (!sources.empty()) options.source.project.request.sources = sources;
  options.source.project.configure(command, session.configured);
  if (generated.empty() || (sources.empty() && options.source.project.build.empty()))
    fail(DiagnosticId::bad_option, {}, "verify takes sources and generated files in C or C++");
  std::vector<program::Banner> banners;
  std::vector<std::string> kernels;
  for (std::string const &path : generated) {
    banners.push_back(program::read_banner(path));
    kernels.push_back(banners.back().kernel);
    if (options.tolerance->count() != 0 && banners.back().mode != FloatingPoint::fast && !banners.back().is_single)
      fail(DiagnosticId::option_without_effect, {},
           "--tol is for code of mode fast and for single precision; this is of mode " +
               std::string(to_string(banners.back().mode)));
    if (options.verification.exact_bits != 0 && !banners.back().has_values)
      fail(DiagnosticId::option_without_effect, {},
           "--exact compares values, and '" + path + "' has derivatives alone");
  }

  require_table(options.paths_met, generated, banners);

  for (std::string const &path : generated) program::note_read(path);
  require_writable(std::vector{options.certificate});

  Console console;
  std::optional<program::Front> front;
  program::RunOptions as;
  int status = clean;
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::vector<VerificationRecord> records;
  for (std::size_t k = 0; k < generated.size(); ++k) {
    program::Banner const &banner = banners[k];
    if (!front || banner.decisions != as.decisions || banner.from_instructions != as.from_instructions ||
        to_string(banner.mode) != as.floating_point) {
      front.reset();
      front = make_front(options, session, banner, kernels, as, console);
      if (!front) return error;
    }
    console.stage("verifying");
    program::Recorded const &recorded = program::require_match(front->kernels, banner, generated[k]);
    if (!program::require_header(generated[k], banner, recorded.graph))
      console.note("there is no " + program::header_of(generated[k]) + ": what it declares was not checked");
    program::VerificationOptions asked = options.verification;
    asked.wrapper = !banner.is_single && banner.derivatives.empty() &&
                    has_wrapper(*front, as, generated[k], banner.prefix, recorded);
    if (banner.is_single && options.tolerance->count() == 0 && !wanted) asked.tolerance = program::single_tolerance;
    if (!options.paths_met.empty()) asked.given = program::read_sample_table(options.paths_met, recorded.graph);
    if (!options.replay.empty()) asked.replayed = read_samples(options.replay, recorded.graph);
    program::Verification const verification = program::verify(*front, as, recorded, generated[k], banner, asked);
    console.clear();
    print_verification(std::cerr, recorded.graph, verification);
    note_other_mathematics("'" + generated[k] + "' was generated", banner.mathematics, verification.mathematics,
                           console);
    records.push_back(record_of(recorded.graph, generated[k], verification, asked));
    if (options.json) json.push_back(to_json(records.back()));
    if (auto failure = verification_failure(recorded.graph, verification, asked, generated[k])) {
      if (options.bisect) failure->notes.push_back({{}, bisected(recorded, banner, verification, asked)});
      console.report(*failure);
      status = verification_failed;
    }
  }
  if (options.json) print_json(json);
  if (!wanted && (options.certificate.empty() || status != clean)) return status;
  std::string const from = wanted ? made_from(*wanted, options.check) : ".";
  nlohmann::ordered_json made = certificate({&*front, session.flags, generated}, records, from);
  if (wanted && !confirms(options.check, *wanted, made, console)) return verification_failed;
  if (!options.certificate.empty()) {
    finish_certificate(made, options.certificate);
    write_outputs({{{options.certificate, made.dump(2) + "\n"}}});
    console.note("wrote " + options.certificate);
  }
  return status;
}

} // namespace

void add_verify(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("verify", "Compare the generated code with the original on many inputs");
  auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "The sources of the program, then generated files in C or C++");
  command->add_flag("--numeric", options->numeric,
                    "Compare only the object code of all sources before and after rewriting, without the switch");
  command->add_option("--cc", options->c_compiler,
                      "Compiler of sources that end in .c; by default cc, with --numeric that of their build");
  options->source.add_to(*command);
  program::VerificationOptions &verification = options->verification;
  command->add_option("--samples", verification.samples, "Number of samples")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--min-samples", verification.min_samples, "Minimum number of samples meeting the mode's premises")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--seed", verification.seed, "Seed of the sequence of samples")->capture_default_str();
  options->tolerance = command
                           ->add_option("--tol", verification.tolerance,
                                        "Largest relative error in mode fast; in single precision 0.001 unless given")
                           ->capture_default_str();
  command->add_flag("--json", options->json, "Print the result as JSON to standard output");
  command->add_option("--shard", options->shard, "Try only each Nth sample, from the Kth on")->type_name("K/N");
  command->add_flag("--merge", options->merge, "Merge the --json results of all shards instead of verifying");
  command
      ->add_option("--replay", options->replay, "Replay the worst samples of a --json result, or a sample of your own")
      ->type_name("FILE");
  command->add_flag("--bisect", options->bisect, "Find the pass and the rewrite that make an output differ");
  command
      ->add_option("--paths-met", options->paths_met, "Table of samples given to generate --paths-met, to be tried too")
      ->type_name("FILE");
  command->add_flag("--branches", verification.branches,
                    "Also list branches of the original that all samples take the same way");
  command
      ->add_option("--exact", verification.exact_bits,
                   "Also report the error of both against exact values, computed with BITS bits, such as 256")
      ->type_name("BITS")
      ->check(CLI::Range(program::least_exact_bits, program::most_exact_bits));
  command->add_option("--certificate", options->certificate, "Write a certificate of the verification")
      ->type_name("FILE");
  command->add_option("--check", options->check, "Repeat a certificate's verification and compare")->type_name("FILE");
  command->callback([options, command, &session] {
    session.status = options->merge     ? merge(*command, *options, session)
                     : options->numeric ? compare_numeric(*command, *options, session)
                                        : run(*command, *options, session);
  });
}

} // namespace symreal::tool
