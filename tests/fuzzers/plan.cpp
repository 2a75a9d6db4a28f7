// A plan as text. One that is taken is written and read again.
#include "engine/plan/text/plan_text.h"
#include "fuzzer.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  ReadPlan read;
  if (!fuzz::takes([&] { read = read_plan(fuzz::text_of(data, size), "input"); })) return 0;
  fuzz::check_round_trip(
      read, [](std::ostream &out, ReadPlan const &one) { write_plan(out, one.plan); },
      [](std::string const &text) { return read_plan(text, "written"); });
  return 0;
}
