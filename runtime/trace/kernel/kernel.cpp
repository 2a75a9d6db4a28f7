#include "runtime/trace/kernel/kernel.h"

#include "engine/support/mutation/is_dropped.h"
#include "engine/support/number.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/report/events.h"
#include "runtime/wire/request.h"

#include <symreal/original.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

namespace symreal::trace {

// Is the kernel left out of the recording? `name`: under which it begins.
static bool is_inert(std::string_view name) {
  static char const *const inert = wire::requested(wire::Entry::inert);
  for (std::string_view rest = inert ? inert : ""; !rest.empty();) {
    std::string_view const line = rest.substr(0, rest.find('\n'));
    if (line == name) return true;
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
  }
  return false;
}

void Kernel::begin(MakeSink make_sink, std::string const &name, SourcePlace place) {
  memory::OwnWork const own;
  name_ = name;
  begun_at_ = where(place);
  is_plain_ = is_inert(name);
  if (is_plain_) return;
  watch_for_crashes();
  if (!sink_) sink_ = make_sink();
  sink_->begin(name, place.frame);
}

bool Kernel::end() {
  memory::OwnWork const own; // the sink may never return
  phase_ = Phase::none;
  recorded_.insert(begun_at_);
  return !std::exchange(is_plain_, false);
}

bool Kernel::begin_object(MakeSink make_sink, Kind kind, char const *label, SourcePlace place) {
  annotate(label, place);
  if (muted_ || inert_region_ || phase_ == Phase::inside) return false;
  if (phase_ == Phase::none) {
    Place const at{place.file, place.line, place.column};
    if (kind == Kind::output) {
      report({DiagnosticId::annotation_outside_kernel, at,
              "the program reaches output '" + std::string(label) + "' before any input of its kernel"});
      give_up();
    }
    if (recorded_.contains(where(place))) {
      inert_region_ = true;
      return false;
    }
    begin(make_sink, to_string(at), place);
    phase_ = Phase::region;
  }
  if (is_plain_) return false;
  sink_->begin_object(kind, label, {place.file, place.line, place.column});
  return true;
}

void Kernel::refuse_element(std::string const &object, std::int64_t count) const {
  report(
      {DiagnosticId::section_beyond, {place_.file, place_.line, place_.column}, beyond_message(label_, object, count)});
  give_up();
}

void Kernel::set_range(double low, double high) {
  if (!takes_clauses()) return;
  std::vector<Object> const &inputs = interface().inputs;
  bool const is_range = std::isfinite(low) && std::isfinite(high) && low <= high;
  if (!is_range && !inputs.empty() && !is_dropped("SYM204")) {
    report({DiagnosticId::bad_range, inputs.back().place,
            "the range of '" + inputs.back().label + "' goes from " + shortest(low) + " to " + shortest(high)});
    give_up();
  }
  sink_->set_range(low, high);
}

// Number of calls by which the kernel begins later than in the recorded run.
static unsigned later_call() {
  static char const *const later = wire::requested(wire::Entry::later_call);
  return later ? static_cast<unsigned>(std::atoi(later)) : 0;
}

bool Kernel::begin_function(MakeSink make_sink, char const *name, SourcePlace place, unsigned call) {
  muted_ = true;
  if (call == 0 || phase_ != Phase::none || recorded_.contains(where(place))) return false;
  if (++calls_[where(place)] != call + later_call()) return false;
  muted_ = false;
  begin(make_sink, name, place);
  phase_ = Phase::entering;
  return true;
}

void Kernel::end_function() {
  if (end()) sink_->end(name_, "", {begun_at_.first, begun_at_.second.first, begun_at_.second.second});
}

void Kernel::end_region(char const *file_name, SourcePlace place) {
  if (inert_region_) {
    inert_region_ = false;
    return;
  }
  if (muted_ || phase_ == Phase::inside || phase_ == Phase::entering || phase_ == Phase::leaving) return;
  if (phase_ == Phase::none) {
    report({DiagnosticId::annotation_outside_kernel,
            {place.file, place.line, place.column},
            "the program reaches generate before any input of its kernel"});
    give_up();
  }
  if (!end()) return;
  sink_->end(std::filesystem::path(file_name).stem().string(), file_name, {place.file, place.line, place.column});
}

} // namespace symreal::trace

#ifdef __x86_64__

void symreal::trace::Kernel::run_again() {
  muted_ = false;
  phase_ = Phase::entering;
  if (!beginning_.frame_at) return;
  // The function's frame lies above this one.
  beginning_.is_kept = true;
  std::memcpy(beginning_.frame_at, beginning_.frame.data(), beginning_.frame.size());
  std::longjmp(beginning_.point, 1);
}

void *symreal_original_point() { return symreal::trace::session().kernel.beginning().point; }

void symreal_original_keep(void const *frame) {
  symreal::trace::Kernel::Beginning &beginning = symreal::trace::session().kernel.beginning();
  if (beginning.is_kept) return; // only the first state is kept
  symreal::memory::OwnWork const own;
  // The bytes from the end of the function's stack, where this frame begins, to its saved registers.
  beginning.frame_at = static_cast<char *>(__builtin_frame_address(0)) + 2 * sizeof(void *);
  beginning.frame.assign(beginning.frame_at, static_cast<char *>(const_cast<void *>(frame)));
}

#else

void symreal::trace::Kernel::run_again() {}

#endif
