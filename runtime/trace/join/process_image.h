// What a program has in its memory at a place where it stands: its static objects, the blocks of its heap, and the
// stack, with the registers that lie there. Compared with that of another process which stands there as well: either
// they differ in nothing but real numbers, or the two go different ways from here.
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
  // Of a program whose kernel has ended: only its results matter. They count as lying at these addresses.
  static ProcessImage of_results(std::vector<RealNumber> const &results);
  static std::uint64_t *result_address(std::size_t k) {
    return reinterpret_cast<std::uint64_t *>(k * 8 + sizeof(Stand));
  }
  static std::size_t result_at(std::uint64_t const *address);

  // The words in which the two differ. At least one of the two is a node of this recording there, so that a real number
  // lies there: what is alive at one place of a program has one type. Nothing if anything else differs.
  std::optional<std::vector<std::uint64_t *>> differences(ProcessImage const &other) const;
  std::uint64_t word(std::uint64_t const *address) const;
  // Its nodes from the first on are these now: another process has other numbers for the same.
  void renumber(NodeId first, std::vector<NodeId> const &now);

  // None where a kernel has ended.
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
