#include "rewrite/configurations.h"
#include "rewrite/configured.h"
#include "rewrite/decide.h"
#include "rewrite/kept_facts.h"
#include "rewrite/merge.h"
#include "rewrite/source_map.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace symreal::rewrite {
namespace {

Scope scope_of(Request const &request, std::vector<Compilation> const &sources) {
  Scope scope{{}, request.exclude};
  std::vector<std::string> &roots = scope.roots;
  for (std::string const &root : request.roots) roots.push_back(real_path(root));
  for (Compilation const &source : sources) roots.push_back(llvm::sys::path::parent_path(real_source(source)).str());
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return scope;
}

// The number's name goes to compilers as a word of the command line.
void require_type_name(std::string const &name) {
  if (name.empty()) return;
  clang::LangOptions language;
  language.CPlusPlus = language.CPlusPlus11 = language.CPlusPlus20 = language.Bool = true;
  clang::IdentifierTable words(language);
  if (!clang::isValidAsciiIdentifier(name) || words.get(name).isKeyword(language))
    fail(DiagnosticId::bad_option, {}, "the number's type cannot be called '" + name + "'");
}

// Sources are read in any order and merged in theirs.
class Reading {
public:
  Reading(Request const &request, std::vector<Compilation> const &sources)
      : request_(request),
        sources_(sources),
        scope_(scope_of(request, sources)),
        recorder_(request, scope_) {}

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

  KeptFacts const &recorder() const { return recorder_; }

  std::vector<std::string> left_out;

private:
  void work() {
    for (std::size_t mine = next_++; mine < sources_.size(); mine = next_++) {
      Facts found;
      std::exception_ptr problem;
      try {
        found = recorder_.record(sources_[mine]);
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
    // A tree that the compiler gave up on agrees with no other.
    if (sources_.size() > 1 && !found.broken) configurations_.add(source.source, found);
    merge(facts_, std::move(found));
  }

  Request const &request_;
  std::vector<Compilation> const &sources_;
  Scope const scope_;
  KeptFacts recorder_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::condition_variable turn_;
  std::size_t merged_ = 0;
  Facts facts_;
  Configurations configurations_;
  std::exception_ptr failure_;
};

} // namespace

std::vector<Compilation> compilations_of(Request const &request) {
  if (!request.compilations.empty()) return request.compilations;
  std::vector<Compilation> result;
  for (std::string const &source : request.sources) result.push_back({source, {}, request.flags});
  return result;
}

std::string real_source(Compilation const &compilation) {
  llvm::SmallString<256> path(compilation.source);
  if (!compilation.directory.empty()) llvm::sys::fs::make_absolute(compilation.directory, path);
  return real_path(path.str().str());
}

Result run(Request const &request) {
  require_type_name(request.type_name);
  std::vector<Compilation> sources = compilations_of(request);
  std::erase_if(sources, [&](Compilation const &one) { return request.exclude.matches(real_source(one)); });
  Reading reading(request, sources);
  Facts facts = reading.all();
  if (!facts.broken) report_configured(request, facts);
  // Other errors may follow from a name that was not found.
  std::stable_partition(facts.diagnostics.begin(), facts.diagnostics.end(),
                        [](symreal::Diagnostic const &one) { return one.id == DiagnosticId::configured_function; });
  Result result = decide(std::move(facts), request);
  result.left_out = std::move(reading.left_out);
  result.sources_read = reading.recorder().read();
  result.sources_kept = reading.recorder().kept();
  return result;
}

} // namespace symreal::rewrite
