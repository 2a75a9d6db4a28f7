// Plain data as bytes, between processes of one program: pointers stay valid.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace symreal::trace {

class MessageWriter {
public:
  template <class T> void put(T const &value) {
    static_assert(std::is_trivially_copyable_v<T>);
    // NOLINTNEXTLINE(bugprone-sizeof-expression): a pointer is sent as it is, since the copies have the same addresses
    put_bytes(static_cast<void const *>(&value), sizeof(T));
  }
  void put_bytes(void const *begin, std::size_t size) {
    bytes_.insert(bytes_.end(), static_cast<char const *>(begin), static_cast<char const *>(begin) + size);
  }
  template <class Range> void put_all(Range const &range) {
    put(range.size());
    if (!range.empty()) put_bytes(&*range.begin(), range.size() * sizeof(*range.begin()));
  }
  std::vector<char> const &bytes() const { return bytes_; }

private:
  std::vector<char> bytes_;
};

class MessageReader {
public:
  explicit MessageReader(std::vector<char> const &bytes) : next_(bytes.data()) {}
  template <class T> T get() {
    T value;
    get_bytes(static_cast<void *>(&value), sizeof(T)); // NOLINT(bugprone-sizeof-expression): as above
    return value;
  }
  void get_bytes(void *to, std::size_t size) {
    if (size != 0) std::memcpy(to, next_, size);
    next_ += size;
  }
  template <class Range> Range get_all() {
    Range range;
    range.resize(get<std::size_t>());
    if (!range.empty()) get_bytes(&*range.begin(), range.size() * sizeof(*range.begin()));
    return range;
  }

private:
  char const *next_;
};

} // namespace symreal::trace
