#include "tool/commands/verify_merge.h"

#include "tool/report/verification_record.h"
#include "tool/report/verify_report.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

namespace symreal::tool {

int verify_merge(CLI::App const &command, std::vector<std::string> const &files, bool json, Session const &session) {
  static std::set<std::string> const known = {"files", "--merge", "--json"};
  for (CLI::Option const *one : command.get_options())
    if (one->count() != 0 && !known.contains(one->get_name()) && !session.configured.contains(one->get_name()))
      fail(DiagnosticId::option_without_effect, {}, one->get_name() + " has no effect with --merge");
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
  if (json)
    std::cout << (results.size() == 1 ? results.front() : nlohmann::ordered_json{{"kernels", results}}).dump(2) << "\n";
  return status;
}

} // namespace symreal::tool
