// What libFuzzer calls, and what every fuzzer of this directory does with it: whatever stands in a file, the reader
// takes it or throws a diagnostic.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <sstream>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size);

namespace symreal::fuzz {

inline std::string_view text_of(std::uint8_t const *data, std::size_t size) {
  return {reinterpret_cast<char const *>(data), size};
}

// Whether the input was taken.
template <class Read> bool takes(Read const &read) {
  try {
    read();
    return true;
  } catch (DiagnosticError const &) {
    return false;
  } catch (std::bad_alloc const &) { // a file may say that more follows than there is memory
    return false;
  }
}

// What is written of a value is read again, and then the same is written.
template <class Value, class Write, class Read>
void check_round_trip(Value const &value, Write const &write, Read const &read) {
  std::ostringstream once, again;
  write(once, value);
  write(again, read(once.str()));
  internal_check(once.str() == again.str());
}

} // namespace symreal::fuzz
