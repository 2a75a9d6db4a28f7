#include "runtime/trace/join/process_image.h"

#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/own_memory.h"
#include "runtime/memory/static_objects.h"

#include <cstring>

namespace symreal::trace {
namespace {

constexpr std::size_t word_size = sizeof(std::uint64_t);

std::uint64_t word_at(char const *bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

} // namespace

void ProcessImage::add(Part part) {
  parts_.push_back(part);
  bytes_.insert(bytes_.end(), part.begin, part.begin + part.size);
}

ProcessImage ProcessImage::capture(Stand *stand) {
  static std::vector<memory::StaticObject> const statics = memory::find_static_objects();
  static char *const stack_end = memory::Stack::of_this_thread().end;
  ProcessImage image;
  for (memory::StaticObject const &one : statics) image.add({one.begin, one.size});
  for (memory::HeapBlock const &one : memory::heap_blocks()) image.add({one.begin, one.size});
  image.stand_ = stand;
  auto *const begin = reinterpret_cast<char *>(stand);
  if (begin < stack_end) image.add({begin, static_cast<std::size_t>(stack_end - begin)});
  return image;
}

ProcessImage ProcessImage::of_results(std::vector<RealNumber> const &results) {
  ProcessImage image;
  auto const *begin = reinterpret_cast<char const *>(results.data());
  image.parts_ = {{reinterpret_cast<char *>(result_address(0)), results.size() * sizeof(RealNumber)}};
  image.bytes_.assign(begin, begin + results.size() * sizeof(RealNumber));
  return image;
}

std::size_t ProcessImage::result_at(std::uint64_t const *address) {
  return (reinterpret_cast<std::uintptr_t>(address) - sizeof(Stand)) / sizeof(std::uint64_t);
}

std::optional<std::vector<std::uint64_t *>> ProcessImage::differences(ProcessImage const &other) const {
  if (stand_ != other.stand_ || parts_ != other.parts_) return std::nullopt;
  std::vector<std::uint64_t *> found;
  Pool const &pool = session().pool;
  char const *here = bytes_.data(), *there = other.bytes_.data();
  for (Part const &part : parts_) {
    if (std::memcmp(here, there, part.size) != 0)
      for (std::size_t k = 0; k < part.size;) {
        char *const address = part.begin + k;
        bool const is_word = reinterpret_cast<std::uintptr_t>(address) % word_size == 0 && k + word_size <= part.size;
        if (!is_word) {
          if (here[k] != there[k]) return std::nullopt;
          ++k;
          continue;
        }
        std::uint64_t const a = word_at(here + k), b = word_at(there + k);
        if (a != b) {
          if (!pool.owns(RealNumber::from_bits(a)) && !pool.owns(RealNumber::from_bits(b))) return std::nullopt;
          found.push_back(reinterpret_cast<std::uint64_t *>(address));
        }
        k += word_size;
      }
    here += part.size;
    there += part.size;
  }
  return found;
}

void ProcessImage::renumber(NodeId first, std::vector<NodeId> const &now) {
  Pool &pool = session().pool;
  char *here = bytes_.data();
  for (Part const &part : parts_) {
    std::size_t const misaligned = reinterpret_cast<std::uintptr_t>(part.begin) % word_size;
    for (std::size_t k = (word_size - misaligned) % word_size; k + word_size <= part.size; k += word_size) {
      RealNumber const number = RealNumber::from_bits(word_at(here + k));
      if (!pool.owns(number)) continue;
      NodeId const id = payload::id_of(number.to_bits());
      if (id < first || id - first >= now.size()) continue;
      std::uint64_t const bits = pool.number(now[id - first]).to_bits();
      std::memcpy(here + k, &bits, sizeof bits);
    }
    here += part.size;
  }
}

std::uint64_t ProcessImage::word(std::uint64_t const *address) const {
  auto const *const at = reinterpret_cast<char const *>(address);
  char const *here = bytes_.data();
  for (Part const &part : parts_) {
    if (part.begin <= at && at < part.begin + part.size) return word_at(here + (at - part.begin));
    here += part.size;
  }
  return 0;
}

void ProcessImage::write(MessageWriter &writer) const {
  writer.put(stand_);
  writer.put_all(parts_);
  writer.put_all(bytes_);
}

ProcessImage ProcessImage::read(MessageReader &reader) {
  ProcessImage image;
  image.stand_ = reader.get<Stand *>();
  image.parts_ = reader.get_all<std::vector<Part>>();
  image.bytes_ = reader.get_all<std::vector<char>>();
  return image;
}

} // namespace symreal::trace
