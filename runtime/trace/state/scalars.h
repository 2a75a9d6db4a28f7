// Scalars in the hidden state of a recording (symreal/numbers.h). Generated code does not compute with them: values
// that the kernel reads are baked in, its changes are lost.
//
// Several may share a word of memory, so their marks are kept here rather than in the Shadow.
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

// Source name of an object: literals of the program, or the name and place of a static object.
struct Site {
  std::string_view name, place;
  detail::Scope scope = detail::Scope::any;
  auto operator<=>(Site const &) const = default;
};

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
