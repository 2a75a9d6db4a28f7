// Memory image of a program that stands at a decision: its static objects, its heap blocks, and the stack with the
// saved registers. Compared with the image of another process at the same place: either they differ in real numbers
// only, or the two part from here. Messages carry images, and what else two processes tell each other.
#pragma once

#include "runtime/trace/nodes/pool.h"

#include <symreal/real_number.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace symreal::trace {

// Plain data as bytes, between processes of one program: pointers stay valid.
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

// Stack frame of a program that asks for the outcome of a decision, laid out by the entry (trace/decisions/stand.cpp).
// All that lives beyond the call lies from here to the far end of the stack, the callee-saved registers first. So the
// program can be stopped, compared with another process at the same place, given other numbers, and resumed.
struct Stand {
  std::uint64_t preserved[6];
  std::uint64_t condition;
  void const *caller;
};

class ProcessImage {
public:
  static ProcessImage capture(Stand *stand);
  // Image of a program whose kernel has ended: only its results matter. They count as lying at result_address.
  static ProcessImage of_results(std::vector<RealNumber> const &results);
  static std::uint64_t *result_address(std::size_t k) {
    return reinterpret_cast<std::uint64_t *>(k * 8 + sizeof(Stand));
  }
  static std::size_t result_at(std::uint64_t const *address);

  // The words in which the two differ. In each, at least one of the two holds a node of this recording, so that a real
  // number lies there: an object alive at one place of a program has one type. Nullopt if anything else differs.
  std::optional<std::vector<std::uint64_t *>> differences(ProcessImage const &other) const;
  std::uint64_t word(std::uint64_t const *address) const;
  // Replaces the node ids from the first on: another process numbers the same nodes differently.
  void renumber(NodeId first, std::vector<NodeId> const &now);

  // Null if the kernel has ended.
  Stand *stand() const { return stand_; }
  std::uint64_t *condition_at() const { return stand_ ? &stand_->condition : nullptr; }

  void write(MessageWriter &writer) const;
  static ProcessImage read(MessageReader &reader);

private:
  struct Part {
    char *begin;
    std::size_t size;
    bool operator==(Part const &) const = default;
  };
  void add(Part part);

  Stand *stand_ = nullptr;
  std::vector<Part> parts_;
  std::vector<char> bytes_;
};

} // namespace symreal::trace
