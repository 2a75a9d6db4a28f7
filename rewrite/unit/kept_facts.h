// The facts of a source that an earlier run has read, if reading it would give the same now.
//
// What reading gives depends on
// - the tool and Clang: the build identities of the program and of all that it is loaded with;
// - the compilation: the words of its command line, the directories of the compiler and of this process;
// - the environment variables that Clang's driver reads;
// - what may be rewritten (roots, exclusions), the name of the number, the external functions of the configuration.
//   All of these are the key of what is kept;
// - everything that was asked of the disk, files that are not there included (lookups.h);
// - the kernels of the configuration, as far as this source defines a function of that name.
//   These are kept with the facts, and must be the same as well.
// The texts of the files within the roots are not kept: they are read again, and are known to be the same by then.
// What depends on the time of the day (__DATE__) is not kept.
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

  // As collect_source. Several threads.
  Facts collect(Compilation const &source);

  std::size_t read() const { return read_; }
  std::map<std::string, double> seconds() const { return seconds_; } // of reading, by the real path of the source
  std::size_t kept() const { return found_; }

private:
  std::string key(Compilation const &source) const;
  // The configured kernels that name one of these functions, in full.
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
