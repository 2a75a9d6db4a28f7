#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "program/build/read_files.h"
#include "tool/calls/driver_program.h"
#include "tool/commands/subcommands.h"
#include "tool/commands/verify_modes.h"
#include "tool/options/option_table.h"
#include "tool/options/recording_options.h"
#include "tool/output/find_wrapper.h"
#include "tool/output/outputs.h"
#include "tool/report/bisection_report.h"
#include "tool/report/certificate.h"
#include "tool/report/console.h"
#include "tool/report/verification_record.h"
#include "tool/report/verify_report.h"
#include "verify/generated_header.h"
#include "verify/verification.h"

#include <algorithm>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace symreal::tool {
namespace {

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

// Takes the generated files from the end of the list, the last one in any case: errors in it are reported later.
std::vector<std::string> take_generated(std::vector<std::string> &files) {
  auto first = files.end();
  while (first != files.begin() && program::is_generated(*(first - 1))) --first;
  if (first == files.end() && first != files.begin()) --first;
  std::vector<std::string> generated(first, files.end());
  files.erase(first, files.end());
  return generated;
}

// Takes the options that a certificate fixes.
void take_options(program::VerificationOptions const &certified, program::VerificationOptions &options) {
  options.samples = certified.samples;
  options.min_samples = certified.min_samples;
  options.seed = certified.seed;
  options.tolerance = certified.tolerance;
  options.branches = certified.branches;
  options.exact_bits = certified.exact_bits;
}

nlohmann::ordered_json to_json(std::vector<VerificationRecord> const &records) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (VerificationRecord const &one : records) json.push_back(to_json(one));
  return json;
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

// The generated files, with their banners.
struct Generated {
  std::vector<std::string> paths, kernels;
  std::vector<program::Banner> banners;
};

// Takes the generated files from the command line, and the project's configuration with the rest.
Generated read_generated(CLI::App &command, Options &options, Session &session) {
  std::vector<std::string> sources = options.files;
  Generated generated{take_generated(sources), {}, {}};
  if (!sources.empty()) options.source.project.request.sources = sources;
  options.source.project.configure(command, session.configured);
  if (generated.paths.empty() || (sources.empty() && options.source.project.build.empty()))
    fail(DiagnosticId::bad_option, {}, "verify takes sources and generated files in C or C++");
  for (std::string const &path : generated.paths) {
    program::Banner const &banner = generated.banners.emplace_back(program::read_banner(path));
    generated.kernels.push_back(banner.kernel);
    if (options.tolerance->count() != 0 && banner.mode != FloatingPoint::fast && !banner.is_single)
      fail(DiagnosticId::option_without_effect, {},
           "--tol is for code of mode fast and for single precision; this is of mode " +
               std::string(to_string(banner.mode)));
    if (options.verification.exact_bits != 0 && !banner.has_values)
      fail(DiagnosticId::option_without_effect, {},
           "--exact compares values, and '" + path + "' has derivatives alone");
  }
  require_table(options.paths_met, generated.paths, generated.banners);
  for (std::string const &path : generated.paths) program::note_read(path);
  return generated;
}

// The recorded programs, which generated files of the same options share.
class Fronts {
public:
  Fronts(Options const &options, Session &session, Generated const &generated, Console &console)
      : options_(options),
        session_(session),
        generated_(generated),
        console_(console) {}

  // The program of the banner's options; null after an error was reported.
  program::Front *of(program::Banner const &banner) {
    if (front_ && is_of(banner)) return &*front_;
    front_.reset();
    front_ = make_front(options_, session_, banner, generated_.kernels, run, console_);
    if (!front_) return nullptr;
    wrappers = find_wrappers(*front_, run, with_values());
    return &*front_;
  }
  program::Front *last() { return front_ ? &*front_ : nullptr; }

  program::RunOptions run; // of the program
  FoundWrappers wrappers;  // of its kernels

private:
  bool is_of(program::Banner const &banner) const {
    return banner.decisions == run.decisions && banner.from_instructions == run.from_instructions &&
           to_string(banner.mode) == run.floating_point;
  }

  // The program's generated files that a wrapper may call.
  std::vector<GeneratedKernel> with_values() {
    std::vector<GeneratedKernel> all;
    for (std::size_t k = 0; k < generated_.paths.size(); ++k) {
      program::Banner const &banner = generated_.banners[k];
      if (!is_of(banner) || banner.is_single || !banner.derivatives.empty()) continue;
      program::Recorded const &recorded = program::require_match(front_->kernels, banner, generated_.paths[k]);
      all.push_back({generated_.paths[k], banner.prefix,
                     &front_->kernels[static_cast<std::size_t>(&recorded - front_->kernels.data())]});
    }
    return all;
  }

  Options const &options_;
  Session &session_;
  Generated const &generated_;
  Console &console_;
  std::optional<program::Front> front_;
};

// The user's options, as this file and the kernel allow.
program::VerificationOptions options_for(Options const &options, FoundWrappers const &wrappers,
                                         program::Recorded const &recorded, std::string const &path,
                                         program::Banner const &banner) {
  program::VerificationOptions asked = options.verification;
  if (wrappers.of.contains(path)) asked.wrapper = wrappers.program;
  if (banner.is_single && options.tolerance->count() == 0 && options.check.empty())
    asked.tolerance = program::single_tolerance;
  if (!options.paths_met.empty()) asked.given = program::read_sample_table(options.paths_met, recorded.graph);
  if (!options.replay.empty()) asked.replayed = read_samples(options.replay, recorded.graph);
  return asked;
}

// Verifies one file, and reports. Returns the exit status.
int verify_file(Options const &options, Fronts &fronts, std::string const &path, program::Banner const &banner,
                Console &console, std::vector<VerificationRecord> &records) {
  program::Front *const front = fronts.of(banner);
  if (!front) return error;
  console.stage("verifying");
  program::Recorded const &recorded = program::require_match(front->kernels, banner, path);
  if (!program::require_header(path, banner, recorded.graph))
    console.note("there is no " + program::header_of(path) + ": what it declares was not checked");
  program::VerificationOptions const asked = options_for(options, fronts.wrappers, recorded, path, banner);
  program::Verification const verification = program::verify(*front, fronts.run, recorded, path, banner, asked);
  console.clear();
  print_verification(std::cerr, recorded.graph, verification);
  note_other_mathematics("'" + path + "' was generated", banner.mathematics, verification.mathematics, console);
  records.push_back(record_of(recorded.graph, path, verification, asked));
  std::optional<Diagnostic> failure = verification_failure(recorded.graph, verification, asked, path);
  if (!failure) return clean;
  if (options.bisect) failure->notes.push_back({{}, bisected(recorded, banner, verification, asked)});
  console.report(*failure);
  return verification_failed;
}

// Writes the certificate, or compares it with the given one. Returns the exit status.
int certify(Options const &options, std::optional<nlohmann::ordered_json> const &wanted, Verified const &verified,
            std::vector<VerificationRecord> const &records, Console &console) {
  std::string const from = wanted ? made_from(*wanted, options.check) : ".";
  nlohmann::ordered_json made = certificate(verified, records, from);
  if (wanted && !confirms(options.check, *wanted, made, console)) return verification_failed;
  if (options.certificate.empty()) return clean;
  finish_certificate(made, options.certificate);
  write_outputs({{{options.certificate, made.dump(2) + "\n"}}});
  console.note("wrote " + options.certificate);
  return clean;
}

int run(CLI::App &command, Options &options, Session &session) {
  require_compatible(command);
  if (!options.shard.empty()) options.verification.shard = parse_shard(options.shard);
  std::optional<nlohmann::ordered_json> wanted;
  if (!options.check.empty()) {
    wanted = read_certificate(options.check);
    take_options(options_of(*wanted, options.check), options.verification);
  }
  Generated const generated = read_generated(command, options, session);
  require_writable(std::vector{options.certificate});
  Console console;
  Fronts fronts(options, session, generated, console);
  std::vector<VerificationRecord> records;
  int status = clean;
  for (std::size_t k = 0; k < generated.paths.size(); ++k) {
    int const found = verify_file(options, fronts, generated.paths[k], generated.banners[k], console, records);
    if (found == error) return error;
    if (found != clean) status = found;
  }
  if (options.json) print_json(to_json(records));
  if (!wanted && (options.certificate.empty() || status != clean)) return status;
  int const certified = certify(options, wanted, {fronts.last(), session.flags, generated.paths}, records, console);
  return certified == clean ? status : certified;
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
  command->add_flag("--fork-each", verification.fork_each, "Run each sample in a process of its own");
  command
      ->add_option("--exact", verification.exact_bits,
                   "Also report the error of both against exact values, computed with BITS bits, such as 256")
      ->type_name("BITS")
      ->check(CLI::Range(program::least_exact_bits, program::most_exact_bits));
  command->add_option("--certificate", options->certificate, "Write a certificate of the verification")
      ->type_name("FILE");
  command->add_option("--check", options->check, "Repeat a certificate's verification and compare")->type_name("FILE");
  command->callback([options, command, &session] {
    session.status = options->merge ? merge_shards(options->files, options->json, *command, session)
                     : options->numeric
                         ? compare_numeric(options->files, options->c_compiler, options->source, *command, session)
                         : run(*command, *options, session);
  });
}

} // namespace symreal::tool
