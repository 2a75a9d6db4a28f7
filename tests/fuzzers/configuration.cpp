// A project's .symreal.yaml.
#include "tool/configuration/configuration.h"
#include "fuzzer.h"
#include "temporary_file.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  fuzz::TemporaryFile const file(fuzz::text_of(data, size));
  fuzz::takes([&] { tool::read_configuration(file.path()); });
  return 0;
}
