#include "trace/kernel.h"

#include "memory/heap_blocks.h"
#include "trace/crash.h"
#include "trace/events.h"

#include <filesystem>

namespace symreal {

namespace trace {

Kernel &Kernel::current() {
  static constinit thread_local Kernel *kernel = nullptr;
  if (!kernel) kernel = new Kernel;
  return *kernel;
}

static std::unique_ptr<Sink> make_sink(detail::Program program) {
  switch (program) {
  case detail::Program::symbolic: return make_recorder();
  case detail::Program::replay: return make_replay();
  case detail::Program::original: return make_original();
  }
  internal_failure("a program has a sink", __FILE__, __LINE__);
}

void Kernel::begin(detail::Program program, std::string const &name, SourcePlace place) {
  watch_for_crashes();
  if (!sink_) sink_ = make_sink(program);
  name_ = name;
  begun_at_ = where(place);
  sink_->begin(name, place.frame);
}

bool Kernel::begin_object(detail::Program program, Kind kind, char const *label, SourcePlace place) {
  if (muted_ || inert_region_ || phase_ == Phase::inside) return false;
  if (phase_ == Phase::none) {
    Place const at{place.file, place.line, place.column};
    if (kind == Kind::output) {
      report({DiagnosticId::annotation_outside_kernel, Severity::error, at,
              "output '" + std::string(label) + "' is met before any input of its kernel"});
      give_up();
    }
    if (recorded_.contains(where(place))) {
      inert_region_ = true;
      return false;
    }
    begin(program, to_string(at), place);
    phase_ = Phase::region;
  }
  sink_->begin_object(kind, label, {place.file, place.line, place.column});
  return true;
}

bool Kernel::begin_function(detail::Program program, char const *name, SourcePlace place, unsigned call) {
  muted_ = true;
  if (phase_ != Phase::none || recorded_.contains(where(place)) || ++calls_[where(place)] != call) return false;
  muted_ = false;
  begin(program, name, place);
  phase_ = Phase::entering;
  return true;
}

void Kernel::end_function() {
  phase_ = Phase::none;
  {
    memory::OwnWork const own; // the sink may never return
    recorded_.insert(begun_at_);
  }
  sink_->end(name_, "", {begun_at_.first, begun_at_.second.first, begun_at_.second.second});
}

void Kernel::end_region(detail::Program, char const *file_name, SourcePlace place) {
  if (inert_region_) {
    inert_region_ = false;
    return;
  }
  if (muted_ || phase_ == Phase::inside || phase_ == Phase::entering || phase_ == Phase::leaving) return;
  if (phase_ == Phase::none) {
    report({DiagnosticId::annotation_outside_kernel,
            Severity::error,
            {place.file, place.line, place.column},
            "generate is met before any input of its kernel"});
    give_up();
  }
  phase_ = Phase::none;
  recorded_.insert(begun_at_);
  sink_->end(std::filesystem::path(file_name).stem().string(), file_name, {place.file, place.line, place.column});
}

} // namespace trace

using trace::Kernel;

bool detail::begin_object(Program compiled_as, Kind kind, char const *label, SourcePlace place) noexcept {
  return Kernel::current().begin_object(compiled_as, kind, label, place);
}

void detail::element(void *number, bool is_temporary) noexcept {
  Kernel::current().sink().element(number, is_temporary);
}

void detail::end_object(std::size_t const *extents, std::size_t rank) noexcept {
  Kernel::current().sink().end_object({extents, extents + rank});
}

bool detail::begin_function(Program compiled_as, char const *name, SourcePlace place, unsigned call) noexcept {
  return Kernel::current().begin_function(compiled_as, name, place, call);
}

void detail::end_function() noexcept { Kernel::current().end_function(); }

void detail::end_region(Program compiled_as, char const *file_name, SourcePlace place) noexcept {
  Kernel::current().end_region(compiled_as, file_name, place);
}

void symreal_set_range(double low, double high) noexcept { Kernel::current().set_range(low, high); }

void FunctionKernel::accept_annotations() noexcept { Kernel::current().accept_annotations(); }
void FunctionKernel::begin_outputs() noexcept { Kernel::current().begin_outputs(); }

} // namespace symreal
