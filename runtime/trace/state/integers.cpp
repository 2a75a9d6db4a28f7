#include "trace/state/integers.h"

#include <cstring>

namespace symreal::trace {

namespace {

// Calls `visit` with each word that the bytes touch, and a bit for each byte of it that is among them.
template <class Visit> void each_word(void const *begin, std::size_t size, Visit visit) {
  auto const at = reinterpret_cast<std::uintptr_t>(begin), end = at + size;
  for (std::uintptr_t word = at / 8; word * 8 < end; ++word) {
    std::uintptr_t const from = word * 8 < at ? at % 8 : 0, to = (word + 1) * 8 > end ? end - word * 8 : 8;
    visit(word, static_cast<std::uint8_t>((1u << to) - (1u << from)));
  }
}

void const *moved(void const *address, void const *from, void const *to) {
  return static_cast<char const *>(to) + (static_cast<char const *>(address) - static_cast<char const *>(from));
}

bool is_within(void const *address, void const *begin, std::size_t size) {
  return reinterpret_cast<std::uintptr_t>(address) - reinterpret_cast<std::uintptr_t>(begin) < size;
}

} // namespace

std::uint64_t Integers::bits(IntegerObject integer) {
  std::uint64_t bits = 0; // little-endian
  std::memcpy(&bits, integer.address, integer.size);
  return bits;
}

double Integers::Noted::value() const {
  unsigned const unused = 64 - 8 * integer.size;
  if (!integer.is_signed) return static_cast<double>(before);
  return static_cast<double>(static_cast<std::int64_t>(before << unused) >> unused);
}

void Integers::note(IntegerObject integer, Site const &site, First first) {
  index_.emplace(integer.address, noted_.size());
  noted_.push_back({integer, site, bits(integer), first == First::read});
}

void Integers::change(void const *address) {
  if (auto const found = index_.find(address); found != index_.end()) noted_[found->second].is_written = true;
}

void Integers::annotate(void const *begin, std::size_t size) {
  each_word(begin, size, [this](std::uintptr_t word, std::uint8_t bytes) { annotated_bytes_[word] |= bytes; });
}

bool Integers::is_annotated(IntegerObject integer) const {
  bool all = true;
  each_word(integer.address, integer.size, [&](std::uintptr_t word, std::uint8_t bytes) {
    auto const found = annotated_bytes_.find(word);
    all = all && found != annotated_bytes_.end() && (found->second & bytes) == bytes;
  });
  return all;
}

void Integers::forget(void const *begin, std::size_t size) {
  for (Noted &one : noted_)
    if (is_within(one.integer.address, begin, size)) one.is_scratch = true;
}

void Integers::forget(IntegerObject integer) {
  if (auto const found = index_.find(integer.address); found != index_.end()) noted_[found->second].is_scratch = true;
}

void Integers::move(void const *block, std::size_t size, void const *to) {
  std::vector<Noted> const before = noted_;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (!is_within(before[k].integer.address, block, size)) continue;
    index_.erase(before[k].integer.address);
    noted_[k].integer.address = moved(before[k].integer.address, block, to);
  }
  for (std::size_t k = 0; k < noted_.size(); ++k)
    if (noted_[k].integer.address != before[k].integer.address) index_[noted_[k].integer.address] = k;
}

} // namespace symreal::trace
