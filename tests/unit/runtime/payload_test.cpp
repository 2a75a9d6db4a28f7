#include "runtime/trace/nodes/payload.h"

#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/nodes/torn_numbers.h"

#include <symreal/symbolic.h>

#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

using namespace symreal;
using trace::Pool;
namespace payload = trace::payload;

namespace {

constexpr double most_taken = 1e-5; // of torn numbers

std::uint64_t number(NodeId id, std::uint32_t generation) {
  return payload::bits_of(id, payload::offset_of(generation));
}
bool is_valid(std::uint64_t bits, std::uint32_t generation) { return bits == number(payload::id_of(bits), generation); }

struct Count {
  std::uint64_t torn = 0, taken = 0;
  void meet(std::uint64_t whole, std::uint64_t bits, std::uint32_t generation) {
    if (bits == whole) return;
    ++torn;
    taken += is_valid(bits, generation);
  }
  double share() const { return static_cast<double>(taken) / static_cast<double>(torn); }
};

std::uint64_t bytes_of_mask(unsigned mask) {
  std::uint64_t bits = 0;
  for (unsigned byte = 0; byte < 8; ++byte)
    if ((mask >> byte & 1) != 0) bits |= std::uint64_t{0xFF} << 8 * byte;
  return bits;
}

// Small ids, as in most recordings, and some of all sizes.
std::vector<NodeId> ids() {
  std::vector<NodeId> all;
  for (NodeId id = 0; id < 6000; ++id) all.push_back(id);
  std::mt19937 random(7);
  for (int k = 0; k < 6000; ++k) all.push_back(static_cast<NodeId>(random()) >> (k % 24));
  return all;
}

} // namespace

TEST(Payload, TellsGenerations) {
  for (NodeId id : {0u, 1u, 77u, 0xFFFFFFu, 0xFFFFFFFEu})
    for (std::uint32_t generation = 1; generation < 256; ++generation) {
      EXPECT_EQ(payload::generation_of(number(id, generation)), generation);
      EXPECT_TRUE(RealNumber::from_bits(number(id, generation)).is_node());
      EXPECT_FALSE(is_valid(number(id, generation), generation % 255 + 1));
    }
}

TEST(Payload, OrdinaryNumbersAreNoNodes) {
  using Limits = std::numeric_limits<double>;
  for (double plain : {0.0, 1.0, Limits::infinity(), Limits::quiet_NaN(), Limits::max()})
    for (std::uint64_t sign : {std::uint64_t{0}, std::uint64_t{1} << 63})
      EXPECT_FALSE(RealNumber::from_bits(detail::bits(plain) ^ sign).is_node()) << plain;
}

// Any of the bytes are overwritten, with the same byte or with anything.
TEST(Payload, TornNumbersAreNoNodes) {
  Count zeros, ones, random_bytes, low_zero, one_zero;
  std::mt19937_64 random(11);
  for (std::uint32_t generation : {1u, 2u, 255u})
    for (NodeId id : ids())
      for (unsigned mask = 1; mask < 255; ++mask) {
        std::uint64_t const whole = number(id, generation), stored = bytes_of_mask(mask), rest = whole & ~stored;
        zeros.meet(whole, rest, generation);
        ones.meet(whole, rest | stored, generation);
        random_bytes.meet(whole, rest | (random() & stored), generation);
        if (mask == 0x0F) low_zero.meet(whole, rest, generation);
        if ((mask & (mask - 1)) == 0) one_zero.meet(whole, rest, generation);
      }
  EXPECT_LT(zeros.share(), most_taken) << zeros.taken;
  EXPECT_LT(ones.share(), most_taken) << ones.taken;
  EXPECT_LT(random_bytes.share(), most_taken) << random_bytes.taken;
  EXPECT_LE(low_zero.taken, 1u);
  EXPECT_LE(one_zero.taken, 2u);
}

// Halves, quarters and bytes of one number in another.
TEST(Payload, NumbersThatAreMixedAreNoNodes) {
  Count halves, quarters, bytes, words_of_neighbours;
  std::mt19937_64 random(13);
  std::vector<NodeId> const all = ids();
  for (NodeId id : all)
    for (int k = 0; k < 200; ++k) {
      std::uint64_t const whole = number(id, 1), other = number(all[random() % all.size()], 1);
      auto const mixed = [&](std::uint64_t stored) { return (whole & ~stored) | (other & stored); };
      halves.meet(whole, mixed(0xFFFF'FFFFu), 1);
      for (unsigned at = 0; at < 64; at += 16) quarters.meet(whole, mixed(std::uint64_t{0xFFFF} << at), 1);
      for (unsigned at = 0; at < 64; at += 8) bytes.meet(whole, mixed(std::uint64_t{0xFF} << at), 1);
      std::uint64_t const neighbour = number(id + 1 + static_cast<NodeId>(k), 1);
      words_of_neighbours.meet(whole, (whole & ~std::uint64_t{0xFFFF'FFFF}) | (neighbour & 0xFFFF'FFFFu), 1);
    }
  EXPECT_LT(halves.share(), most_taken) << halves.taken;
  EXPECT_LT(quarters.share(), most_taken) << quarters.taken;
  EXPECT_LT(bytes.share(), most_taken) << bytes.taken;
  EXPECT_LT(words_of_neighbours.share(), most_taken) << words_of_neighbours.taken;
}

class TornNumber : public testing::Test {
protected:
  void SetUp() override {
    trace::session().pool.begin();
    x = trace::session().pool.leaf(Node::input(0), 0.5);
  }
  void TearDown() override { trace::session().pool.end(); }

  // With these bytes of its own, and zeros.
  RealNumber torn(std::uint64_t kept) const { return RealNumber::from_bits((x * x).to_bits() & kept); }

  RealNumber x;
};

TEST_F(TornNumber, IsRefused) {
  RealNumber const low_lost = torn(~std::uint64_t{0xFFFF'FFFF}), byte_lost = torn(~std::uint64_t{0xFF});
  EXPECT_TRUE(Pool::is_torn(low_lost));
  EXPECT_FALSE(Pool::is_torn(x));
  EXPECT_FALSE(Pool::is_tagged(low_lost.to_bits()));
  EXPECT_FALSE(trace::session().pool.owns(byte_lost));
  EXPECT_EXIT((void)(low_lost + x), testing::ExitedWithCode(1), "a part was overwritten.*\\[SYM199\\]");
  EXPECT_EXIT((void)(byte_lost * 2.0), testing::ExitedWithCode(1), "a part was overwritten.*\\[SYM199\\]");
  EXPECT_EXIT((void)static_cast<bool>(low_lost < x), testing::ExitedWithCode(1),
              "a part was overwritten.*\\[SYM199\\]");
  EXPECT_EXIT((void)symreal_value(low_lost), testing::ExitedWithCode(1), "a part was overwritten.*\\[SYM199\\]");
}

TEST_F(TornNumber, IsNotTheNegativeOfASignalingNaN) {
  RealNumber const signaling = RealNumber::from_bits(payload::signaling);
  EXPECT_EQ(payload::signaling, detail::bits(std::numeric_limits<double>::signaling_NaN()) | std::uint64_t{1} << 63);
  EXPECT_FALSE(Pool::is_torn(signaling));
  EXPECT_TRUE((signaling * x).is_node());
}

TEST_F(TornNumber, KeepsItsBytesWhenOthersBecomePlain) {
  RealNumber numbers[2] = {torn(~std::uint64_t{0xFF}), x};
  std::uint64_t const before = numbers[0].to_bits();
  trace::session().pool.make_plain(numbers, sizeof numbers);
  EXPECT_EQ(numbers[0].to_bits(), before);
  EXPECT_EQ(numbers[1].plain(), 0.5);
}

TEST_F(TornNumber, IsKnownByItsPlace) {
  auto &torn_numbers = trace::session().torn_numbers;
  torn_numbers.begin();
  RealNumber number = x * x;
  auto const store = [&](std::size_t first, std::size_t count, std::uint64_t value) {
    torn_numbers.store({&number, first, count}, /*is_number=*/false, {"u.low", "a.c:3:5"});
    std::uint64_t bits = number.to_bits();
    std::uint64_t const mask = ((std::uint64_t{1} << count) - 1) << first;
    bits = (bits & ~mask) | (value << first & mask);
    std::memcpy(&number, &bits, sizeof bits);
  };
  store(0, 32, 0);
  EXPECT_EQ(torn_numbers.place_of(number), "a.c:3:5");
  EXPECT_FALSE(torn_numbers.is_symbolic({&number, 0, 32}));
  EXPECT_TRUE(torn_numbers.is_symbolic({&number, 32, 32}));
  EXPECT_TRUE(Pool::is_torn(number));
  store(32, 31, 0x3FF00000);
  EXPECT_TRUE(torn_numbers.is_symbolic({&number, 0, 64}));
  store(63, 1, 0);
  EXPECT_FALSE(torn_numbers.is_symbolic({&number, 0, 64}));
  EXPECT_EQ(number.plain(), 1.0);

  // What is stored is what was there.
  number = x;
  store(0, 32, number.to_bits() & 0xFFFF'FFFFu);
  EXPECT_TRUE(Pool::is_torn(number));

  // Another number has come there since.
  number = x * 3.0;
  store(32, 32, 0x40000000);
  number = x;
  EXPECT_EQ(torn_numbers.place_of(number), "");
  number = 4.0;
  EXPECT_FALSE(torn_numbers.is_symbolic({&number, 0, 64}));
  torn_numbers.end();
}

// short three[3] on the stack, where a number lay before.
TEST_F(TornNumber, AreNotBytesBelowAMark) {
  auto &torn_numbers = trace::session().torn_numbers;
  torn_numbers.begin();
  std::uint64_t const whole = (x * x).to_bits(), three = 7 | std::uint64_t{1} << 16 | std::uint64_t{2} << 32;
  std::uint64_t word = (whole >> 48 << 48) | three;
  EXPECT_FALSE(torn_numbers.is_symbolic({&word, 0, 48}));
  EXPECT_TRUE(torn_numbers.is_symbolic({&word, 0, 64}));
  word = whole;
  EXPECT_TRUE(torn_numbers.is_symbolic({&word, 0, 48}));
  torn_numbers.end();
}
