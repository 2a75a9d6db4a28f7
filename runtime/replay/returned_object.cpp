#include "runtime/replay/returned_object.h"

#include <charconv>
#include <cstddef>
#include <cstring>

namespace symreal::replay {
namespace {

std::size_t take_number(std::string_view &text) {
  std::size_t value = 0;
  auto const end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

template <class T> T read(char const *from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

constexpr std::size_t longest_text = 256; // further characters are ignored

std::string_view bytes_of(char what, char const *at, std::size_t size) {
  switch (what) {
  case 'p': return read<void const *>(at) ? "one" : "none";
  case 't': {
    auto const *text = read<char const *>(at);
    return text ? std::string_view(text, strnlen(text, longest_text)) : std::string_view("\0", 1);
  }
  case 's': return {read<char const *>(at), read<std::size_t>(at + sizeof(char const *))};
  default: return {at, size};
  }
}

} // namespace

std::uint64_t hash_of_others(char const *object, std::string_view others) {
  std::uint64_t hash = 14695981039346656037u;
  auto const add = [&hash](unsigned char byte) { hash = (hash ^ byte) * 1099511628211u; };
  while (!others.empty()) {
    char const what = others.front();
    others.remove_prefix(1);
    std::size_t const size = take_number(others);
    others.remove_prefix(1); // the sign
    std::size_t const offset = take_number(others);
    others.remove_prefix(1); // the semicolon
    for (char const one : bytes_of(what, object + offset, size)) add(static_cast<unsigned char>(one));
    add(0);
  }
  return hash;
}

} // namespace symreal::replay
