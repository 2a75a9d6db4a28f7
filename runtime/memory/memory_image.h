// Snapshot of the memory that outlives a kernel: the program's objects of static storage duration, its heap blocks, and
// the stack of the kernel's callers. A later comparison yields all that the kernel has left behind, by whatever means
// it was written: numbers, integers, pointers, text.
#pragma once

#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/static_objects.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace symreal::memory {

enum class Region : unsigned char { static_object, heap_block, stack };

// Bytes of one object that differ from the snapshot.
struct Change {
  Region region;
  std::string name;       // linker name of a static object
  char *object;           // begin of the object; on the stack: begin of the change
  std::size_t size;       // of the object
  std::size_t first, end; // from the first byte that differs to behind the last
};

// Bytes whose change is known or does not matter.
struct Known {
  char const *begin;
  std::size_t size;
};

class KnownBytes {
public:
  explicit KnownBytes(std::vector<Known> known);
  // The first byte at or after the address that is not known.
  char const *skip(char const *address) const;
  bool has(char const *address) const { return skip(address) != address; }
  // Number of bytes from the address on that are not known, at most `most`.
  std::size_t room(char const *address, std::size_t most) const;

private:
  std::vector<Known> parts_; // by address, disjoint
};

class MemoryImage {
public:
  // `frame`: of the function in which the kernel begins (__builtin_frame_address(0)); null leaves the stack out.
  static MemoryImage capture(void const *frame);

  // Replaces the snapshot of these bytes by their present contents.
  void update(void const *begin, std::size_t size);
  // Adds a heap block that was allocated after the snapshot, with its present contents.
  void add(HeapBlock const &block);

  // Changes since the snapshot, except in `known`. Freed heap blocks and objects initialised since are left out.
  std::vector<Change> changes(std::vector<Known> known) const;
  // All objects of the image, by address, each as one change of all its bytes.
  std::vector<Change> objects() const;
  // Whether the object at the address still exists: a heap block may have been freed.
  bool outlives(std::vector<HeapBlock> const &blocks, void const *address) const;

  // Function-local static objects that were initialised since, and the temporaries whose life those that are references
  // extend.
  std::vector<Change> initialised() const;
  // The initialised objects that this compiler guard protects.
  std::vector<Change> guarded(void const *guard) const;

  // Saved bytes of the address; null outside of the image.
  char const *before(void const *address) const;

  // Region of the address; nullopt outside of the image.
  std::optional<Region> region_of(void const *address) const;
  // Object at the address.
  std::optional<Change> object_at(void const *address) const;
  // Linker name of the static object at the address; empty elsewhere.
  std::string static_name(void const *address) const;

  // Heap blocks reachable from these bytes, transitively: all that an object owns, however it does so. `blocks`: the
  // live heap blocks, if they count as well.
  std::vector<Known> owned(Known object, std::vector<HeapBlock> const &blocks = {}) const;

private:
  struct SavedObject {
    Region region;
    std::string name;
    char *begin;
    std::size_t size, saved; // offset in bytes_
    std::uint64_t serial;    // of a block
  };
  void save(SavedObject part);
  std::vector<Change> named(std::set<std::string> const &names) const;
  void compare(SavedObject const &part, KnownBytes const &known, std::vector<Change> &changes) const;
  bool has_changed(SavedObject const &part) const;

  std::vector<SavedObject> parts_; // by address
  std::vector<char> bytes_;
};

} // namespace symreal::memory
