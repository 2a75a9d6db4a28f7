#include "rewrite/configurations.h"
#include "rewrite/decide.h"
#include "rewrite/merge.h"
#include "rewrite/record_source.h"
#include "rewrite/source_map.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace symreal::rewrite {
namespace {

std::vector<Compilation> compilations(Request const &request) {
  if (!request.compilations.empty()) return request.compilations;
  std::vector<Compilation> result;
  for (std::string const &source : request.sources) result.push_back({source, {}, request.flags});
  return result;
}

std::string absolute(Compilation const &compilation) {
  llvm::SmallString<256> path(compilation.source);
  if (!compilation.directory.empty()) llvm::sys::fs::make_absolute(compilation.directory, path);
  return path.str().str();
}

std::vector<std::string> real_roots(Request const &request, std::vector<Compilation> const &sources) {
  std::vector<std::string> roots;
  for (std::string const &root : request.roots) roots.push_back(real_path(root));
  for (Compilation const &source : sources)
    roots.push_back(llvm::sys::path::parent_path(real_path(absolute(source))).str());
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return roots;
}

// Sources are read in any order and merged in theirs.
class Reading {
public:
  Reading(Request const &request, std::vector<Compilation> const &sources)
      : request_(request),
        sources_(sources),
        roots_(real_roots(request, sources)) {}

  Facts all() {
    std::size_t const threads = std::min<std::size_t>(std::max(1U, request_.jobs), sources_.size());
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back([this] { work(); });
    work();
    for (std::thread &helper : helpers) helper.join();
    if (failure_) std::rethrow_exception(failure_);
    configurations_.report(facts_);
    return std::move(facts_);
  }

  std::vector<std::string> left_out;

private:
  void work() {
    for (std::size_t mine = next_++; mine < sources_.size(); mine = next_++) {
      Facts found;
      std::exception_ptr problem;
      try {
        found = record_source(sources_[mine], roots_);
      } catch (DiagnosticError const &error) {
        if (request_.leave_out_broken) {
          found.broken = true;
          found.diagnostics.push_back(error.diagnostic());
        } else
          problem = std::current_exception();
      } catch (...) {
        problem = std::current_exception();
      }
      // Waits for those before it, so that few facts are held at a time.
      std::unique_lock lock(mutex_);
      turn_.wait(lock, [&] { return merged_ == mine; });
      if (problem && !failure_) failure_ = problem;
      if (!failure_) add(sources_[mine], std::move(found));
      ++merged_;
      turn_.notify_all();
    }
  }

  void add(Compilation const &source, Facts &&found) {
    if (found.broken && request_.leave_out_broken) {
      left_out.push_back(source.source);
      for (symreal::Diagnostic const &one : found.diagnostics) add_diagnostic(facts_, one);
      return;
    }
    if (sources_.size() > 1) configurations_.add(source.source, found);
    merge(facts_, std::move(found));
  }

  Request const &request_;
  std::vector<Compilation> const &sources_;
  std::vector<std::string> const roots_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::condition_variable turn_;
  std::size_t merged_ = 0;
  Facts facts_;
  Configurations configurations_;
  std::exception_ptr failure_;
};

} // namespace

Result run(Request const &request) {
  std::vector<Compilation> const sources = compilations(request);
  Reading reading(request, sources);
  Result result = decide(reading.all());
  result.left_out = std::move(reading.left_out);
  return result;
}

} // namespace symreal::rewrite
