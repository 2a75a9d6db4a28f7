// A kernel as the words of --kernel say it: 'f(x[0:3]=0.5, n=3) -> y[0:3]'.
#include "tool/calls/call_spec.h"
#include "fuzzer.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  fuzz::takes([&] { tool::parse_call_spec({std::string(fuzz::text_of(data, size)), {}}); });
  return 0;
}
