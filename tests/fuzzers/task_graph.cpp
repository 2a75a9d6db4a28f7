// A task graph in the format of the Standard Task Graph set. One that is taken is written and read again.
#include "analysis/tasks/stg.h"
#include "fuzzer.h"

#include <sstream>

using namespace symreal;

static std::string written(StgTasks const &read) {
  std::ostringstream text;
  write_stg(text, read.tasks, read.id);
  return text.str();
}

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  StgTasks read;
  if (!fuzz::takes([&] { read = read_stg(fuzz::text_of(data, size), "input"); })) return 0;
  std::string const text = written(read);
  internal_check(written(read_stg(text, "written")) == text);
  return 0;
}
