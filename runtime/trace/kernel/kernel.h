// The life of a kernel, shared by symbolic, replay and original programs.
//
//   region:    none ──first input──▶ region ──generate──▶ none
//   function:  none ──call──▶ entering ──inputs met──▶ inside ──return──▶ leaving ──outputs met──▶ none
//
// A kernel is recorded once. In a later pass over the same pragmas, in a recursive call, and inside another kernel they
// are inert. A kernel that the request leaves out begins and ends as if it was recorded, so that the others are
// recorded in the same calls, but its annotations have no effect.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/memory/static_objects.h"
#include "runtime/trace/parts/parts.h"

#include <symreal/annotate.h>

#include <csetjmp>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace symreal::trace {

// Receiver of a kernel's annotations: records the kernel, or runs it again on other inputs.
class Sink {
public:
  virtual ~Sink() = default;
  // `frame`: of the function in which the kernel begins.
  virtual void begin(std::string const &name, void const *frame) = 0;
  virtual void begin_object(Kind kind, std::string const &label, Place const &place) = 0;
  virtual void element(void *number, bool is_temporary) = 0;
  // A scalar of an annotated structure.
  virtual void scalar(ScalarObject) {}
  // The elements of a structure are those of its members.
  virtual void begin_members() {}
  virtual void begin_member(std::string const &) {}
  virtual void end_member(std::vector<std::size_t> const &) {}
  virtual void end_members() {}
  // The bytes of a constant or scratch object whose numbers are not listed one by one.
  virtual void bytes(void const *, std::size_t) {}
  // An object that holds annotated numbers, maybe elsewhere.
  virtual void holder(void const *, std::size_t) {}
  // A returned object, as a whole.
  virtual void handed_over(void const *, std::size_t) {}
  // An object of the kernel's own, though it lies with its caller.
  virtual void own(void const *, std::size_t) {}
  // An argument that the caller may choose as it likes.
  virtual void chosen(void const *, std::size_t) {}
  virtual void end_object(std::vector<std::size_t> extents) = 0;
  // The program's static variables.
  virtual std::vector<memory::StaticObject> static_objects() const { return memory::find_static_objects(); }
  // The elements that follow were found by a solver, or are a residual. Returns whether they are wanted.
  virtual bool begin_implicit(std::string const &, Place const &) { return false; }
  virtual void end_implicit() {}
  virtual void set_range(double low, double high) = 0;
  virtual void set_state(StatePair const &) {}
  virtual void differentiate(DerivativeWish const &) {}
  // `place`: where the kernel ends, or a function kernel's pragma.
  virtual void end(std::string const &name, std::string const &output_file, Place const &place) = 0;
  // Abandons the kernel in its middle: the recording is handed over without outputs, and the program ends.
  virtual void cut_off() {}
  // The objects annotated so far, for descriptions.
  virtual Graph const &interface() const = 0;
};

using MakeSink = std::unique_ptr<Sink> (*)();

class Kernel {
public:
  bool begin_object(MakeSink make_sink, Kind kind, char const *label, SourcePlace place);
  bool begin_function(MakeSink make_sink, char const *name, SourcePlace place, unsigned call);
  void accept_annotations() { muted_ = false, phase_ = phase_ == Phase::entering ? Phase::inside : phase_; }
  void begin_outputs() { phase_ = Phase::leaving; }
  void end_function();
  // Runs the function of the kernel that has ended once more within the same call of it: jumps back to its beginning if
  // the function has set the target (<symreal/original.h>); else returns. The function's own objects are then as at the
  // first time, objects that outlive it as it has left them.
  void run_again();
  struct Beginning {
    std::jmp_buf point;
    char *frame_at = nullptr;
    std::vector<char> frame; // the bytes of the function's frame there
    bool is_kept = false;    // the function has run again, and finds the first state
  };
  Beginning &beginning() { return beginning_; }
  void end_region(char const *file_name, SourcePlace place);

  bool begin_implicit(std::string const &label, Place const &place) {
    return is_recording() && sink_->begin_implicit(label, place);
  }
  // The annotation whose items are evaluated from now on.
  void annotate(char const *label, SourcePlace place) { label_ = label, place_ = place; }
  // Reports an element of the annotation's item that does not exist.
  [[noreturn]] void refuse_element(std::string const &object, std::int64_t count) const;
  // Fails if no sample lies between the two.
  void set_range(double low, double high);
  void set_state(StatePair const &state) {
    if (takes_clauses()) sink_->set_state(state);
  }
  void differentiate(DerivativeWish const &wish) {
    if (takes_clauses()) sink_->differentiate(wish);
  }

  // False in an inert call, where the kernel may have no sink yet.
  bool is_recording() const { return phase_ != Phase::none && !muted_ && !inert_region_ && !is_plain_; }
  bool is_entering_function() const { return phase_ == Phase::entering && !is_plain_; }
  Sink &sink() { return *sink_; }
  // The objects that are annotated so far.
  Graph const &interface() const {
    static Graph const none;
    return sink_ ? sink_->interface() : none;
  }

private:
  enum class Phase { none, region, entering, inside, leaving };
  bool takes_clauses() const {
    return !muted_ && !inert_region_ && !is_plain_ && (phase_ == Phase::region || phase_ == Phase::entering);
  }
  // Identity of an annotation: its place.
  using Where = std::pair<std::string, std::pair<unsigned, unsigned>>;
  static Where where(SourcePlace place) { return {place.file, {place.line, place.column}}; }

  void begin(MakeSink make_sink, std::string const &name, SourcePlace place);
  bool end(); // whether it was recorded

  Phase phase_ = Phase::none;
  bool muted_ = false;        // the next annotations belong to an inert call
  bool inert_region_ = false; // until its generate
  bool is_plain_ = false;     // the request leaves out the kernel that has begun
  std::string name_;
  char const *label_ = ""; // of the last annotation
  SourcePlace place_{};
  Where begun_at_;
  std::set<Where> recorded_;
  std::map<Where, unsigned> calls_;
  std::unique_ptr<Sink> sink_;
  Beginning beginning_;
};

} // namespace symreal::trace
