#include "engine/support/mutation/is_dropped.h"
#include "engine/support/parallel.h"
#include "engine/support/progress.h"
#include "rewrite/collected.h"
#include "rewrite/decide/configurations.h"
#include "rewrite/decide/decide.h"
#include "rewrite/pragma/configured.h"
#include "rewrite/rewrite.h"
#include "rewrite/source/source_map.h"
#include "rewrite/unit/choices.h"
#include "rewrite/unit/kept_facts.h"
#include "rewrite/unit/reachable_sources.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <numeric>

namespace symreal::rewrite {
namespace {

std::string text_of(Compilation const &source) {
  auto const buffer = llvm::MemoryBuffer::getFile(real_source(source));
  return buffer ? (*buffer)->getBuffer().str() : "";
}

// Sources are read in any order and merged in theirs.
class Reading {
public:
  Reading(Request const &request, std::vector<Compilation> const &sources, Scope const &scope)
      : request_(request),
        sources_(sources),
        collector_(request, scope) {}

  // Throws DiagnosticError where a source cannot be read.
  Facts all() {
    wanted_.resize(sources_.size());
    std::iota(wanted_.begin(), wanted_.end(), 0);
    if (request_.reachable) choose_reachable();
    Progress progress("sources", wanted_.size());
    in_parallel(wanted_.size(), request_.jobs, [&](std::size_t k) {
      read(k);
      progress.add();
    });
    if (failure_) std::rethrow_exception(failure_);
    configurations_.report(facts_);
    if (request_.reachable)
      std::erase_if(facts_.uses, [this](auto const &use) { return !reached_.contains(use.first); });
    return std::move(facts_);
  }

  KeptFacts const &collector() const { return collector_; }

  std::vector<std::string> left_out;  // sources that do not compile, if the request allows it
  std::vector<Compilation> unreached; // if it asks for those that are reached

private:
  void choose_reachable() {
    Candidates candidates;
    for (Compilation const &source : sources_) candidates.names.push_back(source.source);
    candidates.text = [this](std::size_t k) { return text_of(sources_[k]); };
    candidates.read = [this](std::vector<std::size_t> const &numbers) {
      std::vector<SourceLinks> links(numbers.size());
      in_parallel(numbers.size(), request_.jobs, [&](std::size_t k) {
        Facts facts = collector_.collect(sources_[numbers[k]]);
        links[k] = {std::exchange(facts.links, {}), std::exchange(facts.linked_words, {})};
        std::unique_lock const lock(mutex_);
        known_.emplace(numbers[k], std::move(facts));
      });
      return links;
    };
    ReachableSources found = reachable_sources(candidates, begin());
    wanted_.assign(found.sources.begin(), found.sources.end());
    reached_ = std::move(found.symbols);
    for (std::size_t k = 0; k < sources_.size(); ++k)
      if (!found.sources.contains(k)) unreached.push_back(sources_[k]);
  }

  std::set<std::size_t> begin() const {
    std::set<std::size_t> begin;
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      std::string const real = real_source(sources_[k]);
      bool const is_text = std::any_of(request_.texts.begin(), request_.texts.end(),
                                       [&](TextSource const &one) { return one.path == real; });
      bool const is_named = std::find(request_.begin.begin(), request_.begin.end(), real) != request_.begin.end();
      if (request_.texts.empty() ? is_named : is_text) begin.insert(k);
    }
    return begin;
  }

  void read(std::size_t mine) {
    Compilation const &source = sources_[wanted_[mine]];
    Facts found;
    std::exception_ptr problem;
    try {
      auto const known = known_.find(wanted_[mine]);
      found = known != known_.end() ? std::move(known->second) : collector_.collect(source);
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
    if (!problem && !failure_) {
      try {
        add(source, std::move(found));
      } catch (...) {
        problem = std::current_exception(); // those behind it wait
      }
    }
    if (problem && !failure_) failure_ = problem;
    ++merged_;
    turn_.notify_all();
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
  KeptFacts collector_;
  std::vector<std::size_t> wanted_;    // the numbers of the sources that are merged
  std::map<std::size_t, Facts> known_; // of some of them
  std::set<std::string> reached_;      // symbols
  std::mutex mutex_;
  std::condition_variable turn_;
  std::size_t merged_ = 0;
  Facts facts_;
  Configurations configurations_;
  std::exception_ptr failure_;
};

Scope scope_of(Request const &request, std::vector<Compilation> const &sources) {
  Scope scope{{}, request.exclude};
  std::vector<std::string> &roots = scope.roots;
  for (std::string const &root : request.roots) roots.push_back(real_path(root));
  for (Compilation const &source : sources) roots.push_back(llvm::sys::path::parent_path(real_source(source)).str());
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return scope;
}

std::vector<Compilation> sources_of(Request const &request) {
  std::vector<Compilation> sources = compilations_of(request);
  std::erase_if(sources, [&](Compilation const &one) { return request.exclude.matches(real_source(one)); });
  return sources;
}

bool has_errors(Result const &result) {
  return std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                     [](symreal::Diagnostic const &one) { return one.severity == Severity::error; });
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

} // namespace

Collected collect(Request const &request) {
  std::vector<Compilation> const sources = sources_of(request);
  Scope const scope = scope_of(request, sources);
  Reading reading(request, sources, scope);
  Facts facts = reading.all();
  if (!facts.broken) report_configured(request, facts);
  // Other errors may follow from a name that was not found.
  std::stable_partition(facts.diagnostics.begin(), facts.diagnostics.end(),
                        [](symreal::Diagnostic const &one) { return one.id == DiagnosticId::configured_function; });
  return {std::move(facts),           std::move(reading.left_out), std::move(reading.unreached),
          reading.collector().read(), reading.collector().kept(),  reading.collector().seconds()};
}

Result run(Request const &request) {
  require_type_name(request.type_name);
  Collected collected = collect(request);
  Choices const choices = std::exchange(collected.facts.choices, {});
  std::set<std::string> const asking = std::exchange(collected.facts.asking, {});
  Result result = decide(std::move(collected.facts), request);
  if (!request.annotations_only && !has_errors(result) && !is_dropped("SYM120")) {
    std::vector<Compilation> sources = sources_of(request);
    Scope const scope = scope_of(request, sources);
    std::erase_if(sources, [&](Compilation const &one) { return !asking.contains(real_source(one)); });
    compare_choices(choices, sources, scope, request, result);
  }
  result.left_out = std::move(collected.left_out);
  result.unreached = std::move(collected.unreached);
  result.sources_read = collected.read;
  result.sources_kept = collected.kept;
  result.reading_seconds = std::move(collected.reading_seconds);
  return result;
}

} // namespace symreal::rewrite
