// A schedule as text. One that is taken is written and read again.
#include "fuzzer.h"
#include "schedule/schedule_text.h"

#include <sstream>

using namespace symreal;

static std::string written(Schedule const &plan) {
  std::ostringstream text;
  write_schedule(text, plan);
  return text.str();
}

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  ReadSchedule read;
  if (!fuzz::takes([&] { read = read_schedule(fuzz::text_of(data, size), "input"); })) return 0;
  std::string const text = written(read.plan);
  internal_check(written(read_schedule(text, "written").plan) == text);
  return 0;
}
