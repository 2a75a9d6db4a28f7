// Hidden state of a recording: objects that outlive the kernel and that it reads or changes. Their values are baked in,
// or lost, unless annotated. <symreal/state.h> describes the notes and their order.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/memory/memory_image.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/nodes/torn_numbers.h"
#include "runtime/trace/parts/parts.h"
#include "runtime/trace/state/shadow.h"

#include <symreal/state.h>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace symreal::trace {

// A fact about the state that one process has learned, for another that goes on for both.
struct StateNote {
  enum class Kind { named, read, read_scalar, written, written_scalar, changed, taken_back, kept } kind;
  void const *object;
  std::size_t size = 0;
  Site site = {};
  ScalarObject scalar = {};
  detail::Visit visit = nullptr;
  double value = 0;
};

class State {
public:
  // Starts the journal of learned facts.
  void begin_journal();
  std::vector<StateNote> const &journal() const { return journal_; }
  // Whether notes can express all that was learned.
  bool is_journal_complete() const { return !has_met_outside_; }
  // Applies the notes of another process. False if they contradict this one's.
  bool learn(std::vector<StateNote> const &notes);

  // `frame`: of the function in which the kernel begins; its locals are the kernel's own.
  void begin(void const *frame);

  // A reference to an object of static storage duration: its numbers go by this name from here on.
  void named(void const *object, std::size_t size, detail::Scope scope, char const *name, char const *place);
  // A local of the function around the kernel, or a parameter of its own.
  void local(void const *object, std::size_t size, detail::Scope scope, char const *name, char const *place);
  bool is_around(void const *address) const { return site_of(address, "", "").scope == detail::Scope::around; }
  void read(RealNumber const *number, char const *name, char const *place);
  void read(ScalarObject scalar, char const *name, char const *place);
  void read_pointer(void const *pointer, detail::Behind what, char const *name, char const *place);
  void chosen(void const *begin, std::size_t size);
  void written(ScalarObject scalar, char const *name, char const *place);
  void written(void const *begin, std::size_t size, char const *name, char const *place);
  void changed(void const *object, detail::Visit visit, char const *name, char const *place);
  bool counted(void const *object, detail::Visit visit);
  void check_bits(TornNumbers::Bits bits, char const *name, char const *place);
  void const *other_range_end(void const *end, bool is_last, char const *place);
  void constant(void const *begin, std::size_t size);
  void constant_with_owned(void const *begin, std::size_t size); // and the blocks of the heap behind it
  // A scalar of an annotated structure: it is knowingly baked in.
  void member(ScalarObject scalar, std::string const &label, Place const &place);
  void input(RealNumber const *number, std::string const &label, Place const &place);
  // Whether the number is an input or known to be written by the kernel. If not, it still holds its old value.
  bool output(RealNumber const *number);
  void scratch(void const *object, std::size_t size, detail::Visit visit);
  // An object that the kernel hands over as a whole: its own bytes may change.
  void handed_over(void const *object, std::size_t size) {
    handed_over_.push_back({static_cast<char const *>(object), size});
  }
  void scratch_file(char const *file) { scratch_files_.insert(file); }
  // For arms that are both executed (<symreal/branch.h>): whether the number outlives the kernel and was not met yet.
  bool is_foreign(RealNumber const *number);
  bool take_written(RealNumber const *number);
  void was_written(RealNumber const *number) { shadow_.add(number, sizeof *number, mark::noted | mark::written); }
  // Makes the number's value before the write part of the result.
  void keep(RealNumber const *number, double value);

  // Values of a function that come from outside of the program (outside_hooks.cpp).
  void outside(std::string const &name, std::vector<double> const &values);

  // Called by the compiler's guards (initialisation_hooks.cpp): a function-local static variable is initialised.
  void begin_initialisation(void const *guard) { initialisations_.push_back({guard}); }
  void end_initialisation(void const *guard);
  void give_up_initialisation(void const *guard);
  // The path depends on a symbolic value, and so do initialisations on it.
  void decided();

  // Called by the heap (heap_hooks.cpp).
  void allocated(void *block, std::size_t size);
  void released(void *block, std::size_t size);
  void moved(void *block, std::size_t size, void *to, std::size_t new_size);

  // Returns the state that is baked in, reports written state that is not an output, and makes its numbers plain.
  // `kernel`: its place. `has_guards`: other inputs may take another path through the program than this one.
  std::vector<Frozen> end(Place const &kernel = {}, bool has_guards = false);
  // Ends the kernel of a program without notes on reads and writes: makes the numbers in all changed memory plain and
  // reports nothing.
  void end_untold();

private:
  struct Static {
    std::size_t size;
    Site site;
  };
  struct Read {
    std::vector<RealNumber const *> numbers;
    std::vector<double> values;
    std::vector<std::optional<double>> scalars; // that are frozen, known when the kernel ends
    std::vector<std::optional<double>> members; // those of them that belong to annotated structures
    std::vector<std::uintptr_t> stack;          // of the first
  };
  struct Written {
    void const *begin;
    std::size_t size;
    Site site;
  };
  struct Input {
    RealNumber const *number;
    std::uint64_t bits;
    std::string const *label;
    Place place;
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
  struct Initialisation {
    void const *guard;
    bool depends_on_input = false;
    std::vector<memory::Change> objects = {}; // once it has ended
  };
  struct RangeEnd {
    void const *end;
    bool is_last;
    char const *place;
  };

  bool is_constant(void const *address) const;
  bool is_chosen(void const *address) const;
  bool outlives(void const *address);
  bool learn(StateNote const &note);
  void note(StateNote const &note) {
    if (keeps_journal_) journal_.push_back(note);
  }
  Site site_of(void const *address, char const *name, char const *place) const;
  Read &read_at(Site const &site);
  void add_read(RealNumber const *number, double value, Site const &site);
  // Marks the bytes as written; whether they outlive the kernel and were not marked before.
  bool is_first_write(void const *address, std::size_t size);
  bool may_be_left(void const *address) { return (shadow_.at(address) & mark::may_be_left) != 0; }
  void make_plain(RealNumber const *number);
  void report_lost(Site const &site);
  void mark_scratch();
  void leave(memory::Known object, std::vector<memory::HeapBlock> const &blocks);
  void judge_inputs();
  void judge_reads(std::vector<Frozen> &frozen);
  void judge_writes();
  std::vector<memory::Known> known_changes();
  bool has_changed(RealNumber const *number) const;
  void judge_memory(Place const &kernel);
  void judge_initialised(Place const &kernel);
  void report_initialised(memory::Change const &object, Place const &kernel);
  std::string name_of(memory::Change const &change) const;
  bool holds_input(memory::Known object) const;
  bool was_written_by_kernel(RealNumber const *number, double value) const;
  // Whether the object is the kernel's own, though it may lie with its caller: its final contents do not matter.
  static bool is_private(Site const &site) {
    return site.scope == detail::Scope::around || site.scope == detail::Scope::parameter;
  }
  void judge_scalars(bool has_guards);
  bool vouches(void const *container);
  void tell_clauses(std::vector<Frozen> const &frozen, Place const &kernel) const;

  Shadow shadow_;
  bool heap_is_known_ = false;
  std::vector<MemoryRange> constant_memory_;          // of the program and its libraries
  std::vector<MemoryRange> chosen_;                   // those parts of it that the kernel's caller has chosen
  std::map<void const *, Static, std::less<>> names_; // by address
  std::map<Site, Read> reads_;
  Scalars scalars_;
  std::vector<Written> written_;
  std::vector<Input> inputs_;
  std::vector<RealNumber const *> outputs_;
  std::optional<memory::MemoryImage> image_; // from when the kernel began
  std::set<std::string> labels_;             // of inputs
  std::set<void const *> members_;           // scalars of annotated structures
  std::map<std::string, Frozen> copies_;     // those that lie in the kernel's own arguments, by name
  std::vector<Changed> changed_;
  std::map<void const *, detail::Visit> counted_; // containers, by address
  std::vector<Scratch> scratch_;
  std::vector<memory::Known> handed_over_;
  std::set<std::string> scratch_files_;
  std::vector<Initialisation> initialisations_, initialised_; // that go on, the innermost last; that have ended
  std::vector<RangeEnd> range_ends_;
  std::map<std::pair<std::string, std::vector<std::uintptr_t>>, std::vector<double>> outside_; // by name and stack
  std::set<Site> reported_;
  std::set<std::string const *> reported_inputs_;
  std::set<std::string> reported_bits_; // by place
  std::vector<StateNote> journal_;
  bool keeps_journal_ = false, has_met_outside_ = false;
  bool overlooked_ = false; // something could not be judged
};

// Whether a recording of instructions judges the reads and writes of memory other than annotated objects, like a
// rewritten text's notes: if the driver wants code from this recording, not a comparison.
bool watches_memory();

} // namespace symreal::trace
