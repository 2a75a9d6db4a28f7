// Cache of facts from earlier runs, valid while reading the source would give the same facts.
//
// Facts depend on
// - the tool and Clang: the build identities of the program and of all that it is loaded with;
// - the compilation: the words of its command line, the directories of the compiler and of this process;
// - the environment variables that Clang's driver reads;
// - the files that may be rewritten (roots, exclusions), the number's name, the configuration's external functions.
//   All of these form the key of an entry;
// - all questions to the disk, those for missing files included (lookups.h);
// - the kernels of the configuration, as far as this source defines a function of that name.
//   These are kept with the facts, and must be the same as well.
// The texts of the files within the roots are not kept: they are read again, and are known to be the same by then.
// Facts that depend on the time of the day (__DATE__) are not kept.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/lookups.h"

#include <atomic>
#include <map>
#include <mutex>
#include <string>

namespace symreal::rewrite {

struct Scope;

class KeptFacts {
public:
  KeptFacts(Request const &request, Scope const &scope) : request_(request), scope_(scope) {}

  // Cached or fresh facts, as collect_source. Thread-safe.
  Facts collect(Compilation const &source);

  std::size_t read() const { return read_; }
  std::map<std::string, double> seconds() const { return seconds_; } // of reading, by the real path of the source
  std::size_t kept() const { return found_; }

private:
  std::string key(Compilation const &source) const;
  // Texts of the configured kernels that name one of these functions.
  std::string configured(std::set<std::string> const &functions) const;
  std::optional<Facts> find(std::string const &key);
  void keep(std::string const &key, Lookups const &lookups, Facts const &facts);

  Request const &request_;
  Scope const &scope_;
  DiskNow disk_;
  std::atomic<std::size_t> read_ = 0, found_ = 0;
  std::mutex mutex_;
  std::map<std::string, double> seconds_;
};

} // namespace symreal::rewrite
