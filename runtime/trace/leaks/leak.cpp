#include "runtime/trace/leaks/leak.h"

#include "runtime/trace/describe/describe.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <bit>
#include <cmath>
#include <dlfcn.h>

namespace symreal::trace {

// " in libx.so", where an instruction does not belong to the program itself.
static std::string in_library(std::uintptr_t instruction) {
  Dl_info file{}, own{};
  bool const known = dladdr(reinterpret_cast<void *>(instruction), &file) != 0 &&
                     dladdr(reinterpret_cast<void *>(&in_library), &own) != 0;
  if (!known || file.dli_fbase == own.dli_fbase) return "";
  std::string const path = file.dli_fname;
  return " in " + path.substr(path.rfind('/') + 1);
}

bool Leak::meet(std::uint64_t bits) {
  is_torn_ |= Pool::is_torn(RealNumber::from_bits(bits));
  if (!Pool::is_tagged(bits)) return false;
  RealNumber const node = Pool::underlying(bits);
  if (!Pool::current().owns(node)) {
    is_stale_ = true;
    return false;
  }
  std::string const text = describe(node);
  if (values_.find(text) == values_.npos) values_ += (values_.empty() ? "" : " and ") + text;
  return true;
}

void Leak::report(std::uintptr_t instruction, std::uintptr_t delayed) const {
  if (!is_any()) return;
  std::string const computes = "code that was not rewritten" + in_library(instruction) + " computes with ";
  if (values_.empty() && is_torn_)
    report_interrupted(DiagnosticId::torn_number, computes + "a number of which a part was overwritten", delayed);
  else if (values_.empty())
    report_interrupted(DiagnosticId::stale_value, computes + "a value of another kernel or thread", delayed);
  else
    report_interrupted(DiagnosticId::leak, computes + values_, delayed);
}

std::uint64_t Leak::value(std::uint64_t bits) {
  double const value = Pool::current().final_value(Pool::underlying(bits));
  // A missing sign bit means fabs or a negation; fabs comes before comparisons, which decide the path.
  return std::bit_cast<std::uint64_t>(bits >> 63 != 0 ? value : std::fabs(value));
}

} // namespace symreal::trace
