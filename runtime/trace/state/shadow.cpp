#include "runtime/trace/state/shadow.h"

#include "engine/diagnostics/diagnostic.h"
#include "runtime/memory/own_memory.h"

#include <bit>
#include <cstring>

namespace symreal::trace {

Shadow::Page &Shadow::find(std::uintptr_t number) {
  internal_check(!detail::recording);
  return pages_[number];
}

std::vector<Marks> Shadow::copy(void const *begin, std::size_t size) {
  std::vector<Marks> marks;
  each(begin, size, [&marks](Marks here) { marks.push_back(here); });
  return marks;
}

void Shadow::paste(void const *begin, std::vector<Marks> const &marks) {
  std::size_t next = 0;
  each(begin, marks.size() * 8, [&](Marks &here) { here = marks[next++]; });
}

void Shadow::clear() {
  pages_.clear();
  last_ = nullptr;
}

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

Scalars::Bits Scalars::bits(ScalarObject scalar) {
  Bits bits = {}; // little-endian
  std::memcpy(&bits, scalar.address, scalar.size);
  return bits;
}

std::optional<double> Scalars::Noted::value() const {
  unsigned const unused = 64 - 8 * scalar.size;
  switch (scalar.kind) {
  case ScalarObject::Kind::natural: return static_cast<double>(before[0]);
  case ScalarObject::Kind::integer:
    return static_cast<double>(static_cast<std::int64_t>(before[0] << unused) >> unused);
  case ScalarObject::Kind::floating:
    if (scalar.size == sizeof(float)) return std::bit_cast<float>(static_cast<std::uint32_t>(before[0]));
    if (scalar.size <= sizeof(long double)) {
      long double value;
      std::memcpy(&value, &before, sizeof value);
      return static_cast<double>(value);
    }
    return {};
  case ScalarObject::Kind::pointer:
  case ScalarObject::Kind::object:
  case ScalarObject::Kind::text:
  case ScalarObject::Kind::target: return {};
  }
  return {};
}

void Scalars::note(ScalarObject scalar, Site const &site, First first) {
  index_.emplace(scalar.address, noted_.size());
  noted_.push_back({scalar, site, bits(scalar), first == First::read});
}

void Scalars::change(void const *address) {
  if (auto const found = index_.find(address); found != index_.end()) noted_[found->second].is_written = true;
}

void Scalars::annotate(void const *begin, std::size_t size) {
  each_word(begin, size, [this](std::uintptr_t word, std::uint8_t bytes) { annotated_bytes_[word] |= bytes; });
}

bool Scalars::is_annotated(ScalarObject scalar) const {
  bool all = true;
  each_word(scalar.address, scalar.size, [&](std::uintptr_t word, std::uint8_t bytes) {
    auto const found = annotated_bytes_.find(word);
    all = all && found != annotated_bytes_.end() && (found->second & bytes) == bytes;
  });
  return all;
}

void Scalars::forget(void const *begin, std::size_t size) {
  for (Noted &one : noted_)
    if (is_within(one.scalar.address, begin, size)) one.is_scratch = true;
}

void Scalars::forget(ScalarObject scalar) {
  if (auto const found = index_.find(scalar.address); found != index_.end()) noted_[found->second].is_scratch = true;
}

void Scalars::move(void const *block, std::size_t size, void const *to) {
  std::vector<Noted> const before = noted_;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (!is_within(before[k].scalar.address, block, size)) continue;
    index_.erase(before[k].scalar.address);
    noted_[k].scalar.address = moved(before[k].scalar.address, block, to);
  }
  for (std::size_t k = 0; k < noted_.size(); ++k)
    if (noted_[k].scalar.address != before[k].scalar.address) index_[noted_[k].scalar.address] = k;
}

} // namespace symreal::trace
