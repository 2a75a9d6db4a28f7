#include "tool/commands/verify_modes.h"

#include "engine/diagnostics/diagnostic.h"
#include "tool/options/option_table.h"
#include "tool/report/verification_record.h"
#include "tool/report/verify_report.h"
#include "verify/numeric_identity.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

namespace symreal::tool {
namespace {

// Refuses options of the command line that have no effect in this mode.
void require_only(std::set<std::string> const &known, char const *mode, CLI::App const &command,
                  Session const &session) {
  for (CLI::Option const *one : command.get_options())
    if (one->count() != 0 && !known.contains(one->get_name()) && !session.configured.contains(one->get_name()))
      fail(DiagnosticId::option_without_effect, {}, one->get_name() + " has no effect with " + mode);
}

} // namespace

void print_json(nlohmann::ordered_json const &kernels) {
  std::cout << (kernels.size() == 1 ? kernels.front() : nlohmann::ordered_json{{"kernels", kernels}}).dump(2) << "\n";
}

int merge_shards(std::vector<std::string> const &files, bool as_json, CLI::App const &command, Session const &session) {
  require_only({"files", "--merge", "--json"}, "--merge", command, session);
  refuse_flags(session);
  if (files.empty()) fail(DiagnosticId::bad_option, {}, "--merge takes results of verify --json, a file a shard");
  std::vector<VerificationRecord> joined;
  for (std::string const &file : files)
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
      fail(DiagnosticId::verification_file, {files.back()},
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
  if (as_json) print_json(results);
  return status;
}

int compare_numeric(std::vector<std::string> const &files, std::string const &c_compiler, SourceOptions &source,
                    CLI::App &command, Session &session) {
  ProjectOptions &project = source.project;
  project.request.sources = files;
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
  for (std::string const &left : rewritten.left_out) std::cerr << "left out, does not compile: " << left << "\n";
  std::erase_if(sources, [&](rewrite::Compilation const &one) {
    return std::ranges::find(rewritten.left_out, one.source) != rewritten.left_out.end();
  });
  bool const keep = source.front.keep;
  program::Workspace const workspace(keep);
  if (keep) std::cerr << "the objects and the rewritten sources are in " << workspace.path() << "\n";
  bool const names_compiler = command.get_option("--cxx")->count() != 0;
  program::ObjectComparison const result = program::compare_object_code(
      sources, rewritten, {c_compiler, names_compiler ? source.front.build.compiler : ""}, request.jobs, workspace);
  for (Diagnostic const &diagnostic : result.diagnostics) print(std::cerr, diagnostic);
  std::cout << result.identical << " of " << asked << " translation units have identical object code\n";
  if (result.identical != result.compared) return verification_failed;
  return result.compared == asked ? clean : error;
}

} // namespace symreal::tool
