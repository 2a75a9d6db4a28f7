// Measured costs of operations.
#include "engine/analysis/costs/costs.h"
#include "fuzzer.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  fuzz::takes([&] { cost_model(read_costs(fuzz::text_of(data, size), "input")); });
  return 0;
}
