// What lies in the memory that outlives a kernel, at one moment: the objects of static storage duration of the program,
// the blocks of its heap, and the stack of the functions that called the kernel's. Compared with what lies there later
// it tells what the kernel has left behind, by whatever means it was written: numbers, integers, pointers, text.
#pragma once

#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/static_objects.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace symreal::memory {

enum class Region : unsigned char { static_object, heap_block, stack };

// Bytes of one object that are no longer what they were.
struct Change {
  Region region;
  std::string name;       // of a static object, as the linker knows it
  char *object;           // where it begins; on the stack: where the change begins
  std::size_t size;       // of the object
  std::size_t first, end; // the bytes from the first that differs to behind the last
};

// Bytes whose change is known or does not matter.
struct Known {
  char const *begin;
  std::size_t size;
};

class KnownBytes {
public:
  explicit KnownBytes(std::vector<Known> known);
  // The first byte from the address on that is not known.
  char const *skip(char const *address) const;
  bool has(char const *address) const { return skip(address) != address; }
  // How many bytes from the address on are not known, but at most so many.
  std::size_t room(char const *address, std::size_t most) const;

private:
  std::vector<Known> parts_; // by address, disjoint
};

class MemoryImage {
public:
  // `frame`: of the function in which the kernel begins (__builtin_frame_address(0)); null: no stack.
  static MemoryImage capture(void const *frame);

  // What lies there now counts as if it had lain there then.
  void update(void const *begin, std::size_t size);
  // The same of a block of the heap that was not there then.
  void add(HeapBlock const &block);

  // What has changed since, but for what is known. What the heap has given back, and objects that were initialised, are
  // left out.
  std::vector<Change> changes(std::vector<Known> known) const;
  // All objects of the image, by address, as if each had changed as a whole.
  std::vector<Change> objects() const;
  // Whether the object there still exists: a block of the heap may have been given back.
  bool outlives(std::vector<HeapBlock> const &blocks, void const *address) const;

  // The static objects of functions that were initialised since, on their first use, and the temporaries that those
  // that are references keep alive.
  std::vector<Change> initialised() const;
  // The objects of these that the compiler guards with this one.
  std::vector<Change> guarded(void const *guard) const;

  // The bytes that lay there, of an address within the image; else null.
  char const *before(void const *address) const;

  // In which part of the image the address lies; nullopt outside of it.
  std::optional<Region> region_of(void const *address) const;
  // The object there.
  std::optional<Change> object_at(void const *address) const;
  // The linker's name of the static object there; empty elsewhere.
  std::string static_name(void const *address) const;

  // All that can be reached from these bytes: the blocks of the heap that they point into, what those point into, and
  // so on. For an object that owns others, in whatever way. `blocks`: those that there are now, if they count as well.
  std::vector<Known> owned(Known object, std::vector<HeapBlock> const &blocks = {}) const;

private:
  struct Part {
    Region region;
    std::string name;
    char *begin;
    std::size_t size, saved; // where in bytes_
    std::uint64_t serial;    // of a block
  };
  void save(Part part);
  std::vector<Change> named(std::set<std::string> const &names) const;
  Part const *part_at(void const *address) const;
  void compare(Part const &part, KnownBytes const &known, std::vector<Change> &changes) const;
  bool has_changed(Part const &part) const;

  std::vector<Part> parts_; // by address
  std::vector<char> bytes_;
};

} // namespace symreal::memory
