// A task graph in the format of the Standard Task Graph set. One that is taken is written and read again.
#include "engine/analysis/tasks/stg.h"
#include "fuzzer.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  StgTasks read;
  if (!fuzz::takes([&] { read = read_stg(fuzz::text_of(data, size), "input"); })) return 0;
  fuzz::check_round_trip(
      read, [](std::ostream &out, StgTasks const &one) { write_stg(out, one.tasks, one.id); },
      [](std::string const &text) { return read_stg(text, "written"); });
  return 0;
}
