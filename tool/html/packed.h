// Numbers by the million as text: base64 of bytes, and of numbers that take a byte for each seven bits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace symreal::tool {

std::string base64(std::string_view bytes);

class PackedNumbers {
public:
  void add(std::uint64_t number); // seven bits a byte, the lowest first; the top bit: more follow
  std::string text() const { return base64(bytes_); }

private:
  std::string bytes_;
};

} // namespace symreal::tool
