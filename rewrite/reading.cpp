#include "rewrite/reading.h"

#include "engine/support/parallel.h"
#include "engine/support/progress.h"
#include "rewrite/facts/merge.h"
#include "rewrite/unit/reachable_sources.h"

#include <numeric>

namespace symreal::rewrite {
namespace {

std::string text_of(Compilation const &source) {
  auto const buffer = llvm::MemoryBuffer::getFile(real_source(source));
  return buffer ? (*buffer)->getBuffer().str() : "";
}

} // namespace

Facts Reading::all() {
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
  if (request_.reachable) std::erase_if(facts_.uses, [this](auto const &use) { return !reached_.contains(use.first); });
  return std::move(facts_);
}

std::set<std::size_t> Reading::begin() const {
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

void Reading::choose_reachable() {
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

void Reading::read(std::size_t mine) {
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

void Reading::add(Compilation const &source, Facts &&found) {
  if (found.broken && request_.leave_out_broken) {
    left_out.push_back(source.source);
    for (symreal::Diagnostic const &one : found.diagnostics) add_diagnostic(facts_, one);
    return;
  }
  // A tree that the compiler gave up on agrees with no other.
  if (sources_.size() > 1 && !found.broken) configurations_.add(source.source, found);
  merge(facts_, std::move(found));
}

} // namespace symreal::rewrite
