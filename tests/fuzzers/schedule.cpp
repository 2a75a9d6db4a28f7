// A schedule as text. One that is taken is written and read again.
#include "engine/plan/schedule/schedule_text.h"
#include "fuzzer.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  ReadSchedule read;
  if (!fuzz::takes([&] { read = read_schedule(fuzz::text_of(data, size), "input"); })) return 0;
  fuzz::check_round_trip(
      read, [](std::ostream &out, ReadSchedule const &one) { write_schedule(out, one.plan); },
      [](std::string const &text) { return read_schedule(text, "written"); });
  return 0;
}
