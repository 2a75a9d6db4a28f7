// Memory image of a program that stands at a decision: its static objects, its heap blocks, and the stack with the
// saved registers. Compared with the image of another process at the same place: either they differ in real numbers
// only, or the two part from here.
#pragma once

#include "runtime/trace/join/message.h"
#include "runtime/trace/join/stand.h"
#include "runtime/trace/nodes/pool.h"

#include <symreal/real_number.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace symreal::trace {

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
