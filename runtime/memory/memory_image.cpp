#include "runtime/memory/memory_image.h"

#include "runtime/memory/own_memory.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace symreal::memory {
namespace {

// The stack from `frame` to its far end.
Known callers_stack(void const *frame) {
  if (!frame) return {nullptr, 0};
  // A frame begins with saved registers: the frame pointer and the return address.
  char const *first = static_cast<char const *>(frame) + 2 * sizeof(void *);
  char const *end = Stack::of_this_thread().end;
  return first < end ? Known{first, static_cast<std::size_t>(end - first)} : Known{nullptr, 0};
}

bool begins_earlier(Known const &a, Known const &b) { return a.begin < b.begin; }

} // namespace

KnownBytes::KnownBytes(std::vector<Known> known) {
  std::sort(known.begin(), known.end(), begins_earlier);
  for (Known const &one : known) {
    if (parts_.empty() || parts_.back().begin + parts_.back().size < one.begin) {
      parts_.push_back(one);
      continue;
    }
    Known &last = parts_.back();
    last.size = std::max(last.size, static_cast<std::size_t>(one.begin + one.size - last.begin));
  }
}

char const *KnownBytes::skip(char const *address) const {
  Known const *known = object_around(parts_, address);
  return known ? known->begin + known->size : address;
}

std::size_t KnownBytes::room(char const *address, std::size_t most) const {
  if (has(address)) return 0;
  auto const next = std::upper_bound(parts_.begin(), parts_.end(), Known{address, 0}, begins_earlier);
  return next == parts_.end() ? most : std::min(most, static_cast<std::size_t>(next->begin - address));
}

void MemoryImage::save(SavedObject part) {
  part.saved = bytes_.size();
  bytes_.insert(bytes_.end(), part.begin, part.begin + part.size);
  parts_.push_back(std::move(part));
}

MemoryImage MemoryImage::capture(void const *frame) {
  OwnWork const own;
  MemoryImage image;
  for (StaticObject const &one : find_static_objects())
    image.save({Region::static_object, one.name, one.begin, one.size, 0, 0});
  for (HeapBlock const &one : heap_blocks()) image.save({Region::heap_block, {}, one.begin, one.size, 0, one.serial});
  if (Known const stack = callers_stack(frame); stack.begin)
    image.save({Region::stack, {}, const_cast<char *>(stack.begin), stack.size, 0, 0});
  std::sort(image.parts_.begin(), image.parts_.end(),
            [](SavedObject const &a, SavedObject const &b) { return a.begin < b.begin; });
  return image;
}

char const *MemoryImage::before(void const *address) const {
  SavedObject const *part = object_around(parts_, address);
  return part ? bytes_.data() + part->saved + (static_cast<char const *>(address) - part->begin) : nullptr;
}

std::optional<Region> MemoryImage::region_of(void const *address) const {
  SavedObject const *part = object_around(parts_, address);
  return part ? std::optional(part->region) : std::nullopt;
}

std::optional<Change> MemoryImage::object_at(void const *address) const {
  SavedObject const *part = object_around(parts_, address);
  if (!part) return std::nullopt;
  return Change{part->region, part->name, part->begin, part->size, 0, part->size};
}

std::string MemoryImage::static_name(void const *address) const {
  SavedObject const *part = object_around(parts_, address);
  return part ? part->name : "";
}

void MemoryImage::add(HeapBlock const &block) {
  OwnWork const own;
  auto const next = std::upper_bound(parts_.begin(), parts_.end(), block.begin,
                                     [](char const *begin, SavedObject const &part) { return begin < part.begin; });
  // A block in the place of a freed one has no bytes to compare with.
  if (next != parts_.begin() && block.begin < std::prev(next)->begin + std::prev(next)->size) return;
  if (next != parts_.end() && next->begin < block.begin + block.size) return;
  parts_.insert(next, {Region::heap_block, {}, block.begin, block.size, bytes_.size(), block.serial});
  bytes_.insert(bytes_.end(), block.begin, block.begin + block.size);
}

void MemoryImage::update(void const *begin, std::size_t size) {
  if (SavedObject const *part = object_around(parts_, begin)) {
    auto const offset = static_cast<std::size_t>(static_cast<char const *>(begin) - part->begin);
    std::memcpy(bytes_.data() + part->saved + offset, begin, std::min(size, part->size - offset));
  }
}

bool MemoryImage::has_changed(SavedObject const &part) const {
  return std::memcmp(part.begin, bytes_.data() + part.saved, part.size) != 0;
}

std::vector<Change> MemoryImage::initialised() const {
  std::set<std::string> names;
  for (SavedObject const &part : parts_)
    if (std::string object = guarded_by(part.name); !object.empty() && has_changed(part))
      names.insert(std::move(object));
  return named(names);
}

std::vector<Change> MemoryImage::guarded(void const *guard) const {
  OwnWork const own;
  std::string object = guarded_by(static_name(guard));
  return object.empty() ? std::vector<Change>() : named({std::move(object)});
}

// The objects of these names, and the temporaries that they keep alive.
std::vector<Change> MemoryImage::named(std::set<std::string> const &names) const {
  std::vector<Change> found;
  if (names.empty()) return found;
  for (SavedObject const &part : parts_)
    if (names.contains(part.name) ||
        std::ranges::any_of(names, [&](std::string const &name) { return is_kept_alive_by(part.name, name); }))
      found.push_back({part.region, part.name, part.begin, part.size, 0, part.size});
  return found;
}

void MemoryImage::compare(SavedObject const &part, KnownBytes const &known, std::vector<Change> &changes) const {
  char const *saved = bytes_.data() + part.saved;
  if (!has_changed(part)) return;
  Change change{part.region, part.name, part.begin, part.size, part.size, 0};
  for (std::size_t k = 0; k < part.size; ++k) {
    if (part.begin[k] == saved[k]) continue;
    if (char const *end = known.skip(part.begin + k); end != part.begin + k) {
      k = static_cast<std::size_t>(end - part.begin) - 1;
      continue;
    }
    change.first = std::min(change.first, k);
    change.end = k + 1;
  }
  if (change.end > change.first) changes.push_back(change);
}

bool MemoryImage::outlives(std::vector<HeapBlock> const &blocks, void const *address) const {
  SavedObject const *part = object_around(parts_, address);
  if (!part || part->region != Region::heap_block) return part != nullptr;
  auto const at = std::lower_bound(blocks.begin(), blocks.end(), part->begin,
                                   [](HeapBlock const &block, char *begin) { return block.begin < begin; });
  return at != blocks.end() && at->begin == part->begin && at->serial == part->serial;
}

std::vector<Change> MemoryImage::objects() const {
  std::vector<Change> all;
  for (SavedObject const &part : parts_) all.push_back({part.region, part.name, part.begin, part.size, 0, part.size});
  return all;
}

std::vector<Change> MemoryImage::changes(std::vector<Known> all_known) const {
  OwnWork const own;
  KnownBytes const known(std::move(all_known));
  std::vector<HeapBlock> const blocks = heap_blocks();
  std::vector<Change> found;
  for (SavedObject const &part : parts_)
    if (outlives(blocks, part.begin)) compare(part, known, found);
  std::set<char const *> made;
  for (Change const &object : initialised()) made.insert(object.object);
  std::erase_if(found,
                [&](Change const &change) { return made.contains(change.object) || !guarded_by(change.name).empty(); });
  return found;
}

std::vector<Known> MemoryImage::owned(Known object, std::vector<HeapBlock> const &blocks) const {
  std::vector<Known> result = {object};
  std::set<char const *> met;
  for (std::size_t next = 0; next < result.size(); ++next) {
    Known const one = result[next];
    auto const misaligned = reinterpret_cast<std::uintptr_t>(one.begin) % sizeof(void *);
    for (std::size_t k = (sizeof(void *) - misaligned) % sizeof(void *); k + sizeof(void *) <= one.size;
         k += sizeof(void *)) {
      char const *pointer = nullptr;
      // The pointer's old value counts as well: a container may have released its block.
      char const *old = before(one.begin + k);
      for (char const *from : {one.begin + k, old}) {
        if (!from) continue;
        std::memcpy(static_cast<void *>(&pointer), from, sizeof pointer);
        SavedObject const *part = object_around(parts_, pointer);
        if (part && part->region == Region::heap_block && met.insert(part->begin).second)
          result.push_back({part->begin, part->size});
        if (HeapBlock const *block = part ? nullptr : object_around(blocks, pointer);
            block && met.insert(block->begin).second)
          result.push_back({block->begin, block->size});
      }
    }
  }
  return result;
}

} // namespace symreal::memory
