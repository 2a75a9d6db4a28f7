// Shadow memory of a recording: marks for every eight bytes that were met, in pages made on demand; and the scalars
// that were met. Several of these may share a word of memory, so their marks are kept beside the Shadow.
#pragma once

#include <symreal/state.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace symreal::trace {

using Marks = std::uint16_t;
namespace mark {
constexpr Marks own = 1;        // the kernel's own memory, or known to be constant
constexpr Marks input = 2;      // input or parameter
constexpr Marks constant = 4;   // declared to be baked in
constexpr Marks output = 8;     // from its annotation on
constexpr Marks scratch = 16;   // its final contents do not matter; known when the kernel ends
constexpr Marks noted = 32;     // read or written by the kernel, and outlives it
constexpr Marks read = 64;      // ... read before it was written
constexpr Marks written = 128;  // ... written
constexpr Marks freed = 256;    // freed since the kernel began
constexpr Marks named = 512;    // the first word of a static object whose name is known
constexpr Marks changed = 1024; // ... of an object that is checked again when the kernel ends
constexpr Marks is_judged = own | input | output | noted; // the meaning of a read is known
constexpr Marks may_be_read = is_judged | constant;
constexpr Marks vouches = input | constant | output | scratch; // for the number of elements around it
constexpr Marks may_be_left = output | scratch | freed;
} // namespace mark

// Use it only within a Pause: a page allocated while the kernel is recorded would be noted as the kernel's, in this
// same Shadow, in the middle of an insertion.
class Shadow {
public:
  Marks at(void const *address) { return page(word(address) / page_words)[word(address) % page_words]; }
  void add(void const *begin, std::size_t size, Marks marks) {
    each(begin, size, [marks](Marks &here) { here |= marks; });
  }
  void remove(void const *begin, std::size_t size, Marks marks) {
    each(begin, size, [marks](Marks &here) { here &= static_cast<Marks>(~marks); });
  }
  void set(void const *begin, std::size_t size, Marks marks) {
    each(begin, size, [marks](Marks &here) { here = marks; });
  }
  // Memory that moves takes its marks along.
  std::vector<Marks> copy(void const *begin, std::size_t size);
  void paste(void const *begin, std::vector<Marks> const &marks);
  void clear();

private:
  static constexpr std::uintptr_t page_words = 512;
  using Page = std::array<Marks, page_words>;

  static std::uintptr_t word(void const *address) { return reinterpret_cast<std::uintptr_t>(address) / 8; }
  Page &page(std::uintptr_t number) {
    if (number != last_number_ || !last_) last_ = &find(number), last_number_ = number;
    return *last_;
  }
  Page &find(std::uintptr_t number);
  template <class Change> void each(void const *begin, std::size_t size, Change change) {
    std::uintptr_t const end = (reinterpret_cast<std::uintptr_t>(begin) + size + 7) / 8;
    for (std::uintptr_t at = word(begin); at < end;) {
      Page &here = page(at / page_words);
      for (std::uintptr_t k = at % page_words; k < page_words && at < end; ++k, ++at) change(here[k]);
    }
  }

  std::unordered_map<std::uintptr_t, Page> pages_;
  std::uintptr_t last_number_ = 0;
  Page *last_ = nullptr;
};

// Source name of an object: literals of the program, or the name and place of a static object.
struct Site {
  std::string_view name, place;
  detail::Scope scope = detail::Scope::any;
  auto operator<=>(Site const &) const = default;
};

// Scalars in the hidden state of a recording (symreal/numbers.h). Generated code does not compute with them: values
// that the kernel reads are baked in, its changes are lost.
class Scalars {
public:
  using Bits = std::array<std::uint64_t, 2>;
  struct Noted {
    ScalarObject scalar;
    Site site;
    Bits before;  // when it was noted
    bool is_read; // before the kernel wrote it
    bool is_written = false;
    bool is_scratch = false;

    std::optional<double> value() const; // when it was noted, if representable as a number
    bool is_lost() const { return (is_written || bits(scalar) != before) && !is_scratch; }
  };
  enum class First { read, written };

  static std::optional<double> value_of(ScalarObject scalar) { return Noted{scalar, {}, bits(scalar), false}.value(); }
  bool is_noted(void const *address) const { return index_.contains(address); }
  void note(ScalarObject scalar, Site const &site, First first);
  void change(void const *address);
  // Marks bytes that share a word with others; whole words are marked in the Shadow.
  void annotate(void const *begin, std::size_t size);
  bool is_annotated(ScalarObject scalar) const;
  // Marks these bytes as scratch: their final contents do not matter.
  void forget(void const *begin, std::size_t size);
  void forget(ScalarObject scalar);
  void move(void const *block, std::size_t size, void const *to);

  // Scalars in the order in which the kernel met them.
  std::vector<Noted> const &noted() const { return noted_; }

private:
  static Bits bits(ScalarObject scalar);

  std::vector<Noted> noted_;
  std::unordered_map<void const *, std::size_t> index_;              // by address
  std::unordered_map<std::uintptr_t, std::uint8_t> annotated_bytes_; // a bit for each byte, by word
};

} // namespace symreal::trace
