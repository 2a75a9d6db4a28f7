// Reads the sources of a request, several at a time, into the facts of one program.
#pragma once

#include "rewrite/decide/configurations.h"
#include "rewrite/unit/kept_facts.h"

#include <condition_variable>
#include <exception>
#include <mutex>

namespace symreal::rewrite {

// Sources are read in any order and merged in theirs.
class Reading {
public:
  Reading(Request const &request, std::vector<Compilation> const &sources, Scope const &scope)
      : request_(request),
        sources_(sources),
        collector_(request, scope) {}

  // Throws DiagnosticError where a source cannot be read.
  Facts all();

  KeptFacts const &collector() const { return collector_; }

  std::vector<std::string> left_out;  // sources that do not compile, if the request allows it
  std::vector<Compilation> unreached; // if it asks for those that are reached

private:
  void choose_reachable();
  std::set<std::size_t> begin() const;
  void read(std::size_t mine);
  void add(Compilation const &source, Facts &&found);

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

} // namespace symreal::rewrite
