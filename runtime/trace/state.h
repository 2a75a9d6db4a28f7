// Hidden state of a recording: objects that live longer than the kernel and that it reads or changes. What they hold is
// baked in, or lost, unless annotated. <symreal/state.h> says what is told here, and when.
#pragma once

#include "graph/graph.h"
#include "trace/integers.h"
#include "trace/own_memory.h"
#include "trace/shadow.h"

#include <symreal/state.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::trace {

class State {
public:
  static State &current(); // one per thread

  // `frame`: of the function in which the kernel begins; its locals are the kernel's own.
  void begin(void const *frame);

  // A reference to an object of static storage duration: from here on its numbers go by this name.
  void named(void const *object, std::size_t size, detail::Scope scope, char const *name, char const *place);
  void read(RealNumber const *number, char const *name, char const *place);
  void read(IntegerObject integer, char const *name, char const *place);
  void written(IntegerObject integer, char const *name, char const *place);
  void written(void const *begin, std::size_t size, char const *name, char const *place);
  void changed(void const *object, detail::Visit visit, char const *name, char const *place);
  void check_bits(void const *begin, std::size_t size, char const *name, char const *place);
  void const *other_range_end(void const *end, bool is_last, char const *place);
  void annotated(void const *begin, std::size_t size);
  void scratch(void const *object, std::size_t size, detail::Visit visit);

  // Told by the heap (heap_hooks.cpp).
  void allocated(void *block, std::size_t size);
  void released(void *block, std::size_t size);
  void moved(void *block, std::size_t size, void *to, std::size_t new_size);

  // What is baked in. Reports state that was written and is no output, and makes its numbers ordinary again.
  std::vector<Frozen> end();

private:
  struct Static {
    std::size_t size;
    Site site;
  };
  struct Read {
    std::vector<RealNumber const *> numbers;
    std::vector<double> values;
    std::vector<double> integers;      // that are frozen, known when the kernel ends
    std::vector<std::uintptr_t> stack; // of the first
  };
  struct Written {
    void const *begin;
    std::size_t size;
    Site site;
  };
  struct Scratch {
    void const *object;
    std::size_t size;
    detail::Visit visit;
  };
  struct Changed {
    void const *object;
    detail::Visit visit;
    Site site;
  };
  struct RangeEnd {
    void const *end;
    bool is_last;
    char const *place;
  };

  bool outlives(void const *address);
  bool in_question(void const *address);
  Site site_of(void const *address, char const *name, char const *place) const;
  Read &read_at(Site const &site);
  bool is_lost(RealNumber const *number);
  void report_lost(Site const &site);
  void forget_scratch();
  void judge_integers();
  void warn_overlooked() const;

  Shadow shadow_;
  bool heap_is_known_ = false;
  std::vector<MemoryRange> constant_memory_;          // of the program and its libraries
  std::map<void const *, Static, std::less<>> names_; // by address
  std::map<Site, Read> reads_;
  Integers integers_;
  std::vector<Written> written_;
  std::vector<Changed> changed_;
  std::vector<Scratch> scratch_;
  std::vector<RangeEnd> range_ends_;
  std::set<Site> reported_;
  std::set<std::string> reported_bits_; // by place
  bool overlooked_ = false;             // something could not be judged
};

} // namespace symreal::trace
