// Compact text encoding of many numbers: base64 of bytes, each number with seven bits a byte.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace symreal::tool {

std::string base64(std::string_view bytes);

class PackedNumbers {
public:
  void add(std::uint64_t number); // seven bits a byte, lowest first; the top bit: more bytes follow
  std::string text() const { return base64(bytes_); }

private:
  std::string bytes_;
};

} // namespace symreal::tool
