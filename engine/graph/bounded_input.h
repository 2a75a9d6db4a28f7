// Bounded reader of cereal's binary archives: never allocates more than the rest of the file can fill, since a
// truncated or corrupted file may claim any list length.
#pragma once

#include <cereal/archives/binary.hpp>
#include <cereal/cereal.hpp>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <type_traits>

namespace symreal {

class BoundedInput : public cereal::InputArchive<BoundedInput, cereal::AllowEmptyClassElision> {
public:
  // `size`: remaining bytes of the stream.
  BoundedInput(std::istream &stream, std::uint64_t size) : InputArchive(this), stream_(stream), left_(size) {}

  void read(void *data, std::size_t size) {
    require(size);
    if (stream_.rdbuf()->sgetn(static_cast<char *>(data), static_cast<std::streamsize>(size)) !=
        static_cast<std::streamsize>(size))
      throw cereal::Exception("it ends early");
    left_ -= size;
  }
  // Throws unless `count` elements of at least a byte each can follow.
  void require(std::uint64_t count) const {
    if (count > left_) throw cereal::Exception("a list is longer than the file");
  }

private:
  std::istream &stream_;
  std::uint64_t left_;
};

template <class T> std::enable_if_t<std::is_arithmetic_v<T>> load(BoundedInput &file, T &value) {
  if constexpr (std::is_same_v<T, bool>) {
    unsigned char byte = 0;
    file.read(&byte, 1);
    value = byte != 0;
  } else {
    file.read(std::addressof(value), sizeof value);
  }
}
template <class T> void load(BoundedInput &file, cereal::BinaryData<T> &bytes) { file.read(bytes.data, bytes.size); }
template <class T> void serialize(BoundedInput &file, cereal::SizeTag<T> &tag) {
  file(tag.size);
  file.require(tag.size);
}
template <class T> void serialize(BoundedInput &file, cereal::NameValuePair<T> &pair) { file(pair.value); }

} // namespace symreal

namespace cereal {
namespace traits::detail {
template <> struct get_output_from_input<symreal::BoundedInput> {
  using type = BinaryOutputArchive;
};
} // namespace traits::detail
} // namespace cereal
