// Serialisation of plain structs: one function, `visit`, lists a struct's members for both directions.
//
// A number takes as many bytes as it needs, seven bits in each. A string that was written before is a number: facts
// repeat the paths of a few files.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace symreal::rewrite {

class ByteWriter {
public:
  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
    bytes_ += static_cast<char>(value);
  }
  void string(std::string const &text) {
    auto const [known, is_new] = known_.try_emplace(text, known_.size() + 1);
    if (!is_new) return number(known->second);
    number(0);
    number(text.size());
    bytes_ += text;
  }
  std::string result() { return std::move(bytes_); }

private:
  std::string bytes_;
  std::unordered_map<std::string, std::size_t> known_;
};

class ByteReader {
public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && !rest_.empty(); shift += 7) {
      auto const byte = static_cast<unsigned char>(rest_.front());
      rest_.remove_prefix(1);
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80) return value;
    }
    return fail();
  }
  std::string string() {
    std::uint64_t const known = number();
    if (known > known_.size()) return fail(), "";
    if (known != 0) return std::string(known_[known - 1]);
    std::string_view const text = rest_.substr(0, size());
    rest_.remove_prefix(text.size());
    known_.push_back(text);
    return std::string(text);
  }
  // Number of elements of a sequence, each of which takes a byte at least.
  std::size_t size() {
    std::uint64_t const count = number();
    return count > rest_.size() ? fail() : count;
  }
  // Whether all bytes were there, and none are left.
  bool is_complete() const { return good_ && rest_.empty(); }

private:
  std::size_t fail() {
    good_ = false;
    rest_ = {};
    return 0;
  }
  std::string_view rest_;
  std::vector<std::string_view> known_;
  bool good_ = true;
};

// Members of a struct are listed by `visit(take, object)`, found by its type, which calls take(member...) in an order
// of its own, the same in both directions. It names all members with `auto &[...]`, so that a new member does not
// compile until it is listed.

class Write {
public:
  template <class... T> void operator()(T &...values) { (value(values), ...); }
  template <class... T> void members(char const *, T &...values) { (value(values), ...); }
  std::string result() { return bytes_.result(); }

private:
  template <class T> void value(T &object) {
    if constexpr (std::integral<T> || std::is_enum_v<T>)
      bytes_.number(static_cast<std::uint64_t>(object));
    else
      visit(*this, object);
  }
  void value(std::string &text) { bytes_.string(text); }
  template <class T> void value(std::optional<T> &object) {
    bytes_.number(object.has_value());
    if (object) value(*object);
  }
  template <class A, class B> void value(std::pair<A, B> &pair) { (*this)(pair.first, pair.second); }
  template <class T> void value(std::vector<T> &all) { elements(all); }
  template <class T> void value(std::set<T> &all) { elements(all); }
  template <class K, class V> void value(std::map<K, V> &all) { elements(all); }
  void value(std::vector<bool> &bits) {
    bytes_.number(bits.size());
    for (std::size_t at = 0, run; at < bits.size(); at += run) { // run length: tokens are long
      run = 1;
      while (at + run < bits.size() && bits[at + run] == bits[at]) ++run;
      bytes_.number(2 * run + bits[at]);
    }
  }
  template <class All> void elements(All &all) {
    bytes_.number(all.size());
    for (auto &one : all) {
      if constexpr (requires { one.second; })
        (*this)(const_cast<std::remove_const_t<decltype(one.first)> &>(one.first), one.second);
      else
        value(const_cast<std::remove_const_t<std::remove_reference_t<decltype(one)>> &>(one));
    }
  }

  ByteWriter bytes_;
};

class Read {
public:
  explicit Read(std::string_view bytes) : bytes_(bytes) {}
  template <class... T> void operator()(T &...values) { (value(values), ...); }
  template <class... T> void members(char const *, T &...values) { (value(values), ...); }
  bool is_complete() const { return bytes_.is_complete(); }

private:
  template <class T> void value(T &object) {
    if constexpr (std::same_as<T, bool>)
      object = bytes_.number() != 0;
    else if constexpr (std::integral<T> || std::is_enum_v<T>)
      object =
          static_cast<T>(bytes_.number()); // NOLINT(clang-analyzer-optin.core.EnumCastOutOfRange): what Write wrote
    else
      visit(*this, object);
  }
  void value(std::string &text) { text = bytes_.string(); }
  template <class T> void value(std::optional<T> &object) {
    object.reset();
    if (bytes_.number() != 0) value(object.emplace());
  }
  template <class A, class B> void value(std::pair<A, B> &pair) { (*this)(pair.first, pair.second); }
  template <class T> void value(std::vector<T> &all) {
    for (std::size_t left = bytes_.size(); left != 0; --left) value(all.emplace_back());
  }
  template <class T> void value(std::set<T> &all) {
    for (std::size_t left = bytes_.size(); left != 0; --left) {
      T one{};
      value(one);
      all.insert(all.end(), std::move(one));
    }
  }
  template <class K, class V> void value(std::map<K, V> &all) {
    for (std::size_t left = bytes_.size(); left != 0; --left) {
      std::pair<K, V> one{};
      value(one);
      all.insert(all.end(), std::move(one));
    }
  }
  void value(std::vector<bool> &bits) {
    constexpr std::uint64_t most = std::uint64_t{1} << 32; // of a file's offsets
    std::uint64_t const size = std::min(bytes_.number(), most);
    while (bits.size() < size) {
      std::uint64_t const run = bytes_.number();
      if (run < 2 || run / 2 > size - bits.size()) break;
      bits.insert(bits.end(), static_cast<std::size_t>(run / 2), (run & 1) != 0);
    }
  }

  ByteReader bytes_;
};

} // namespace symreal::rewrite
