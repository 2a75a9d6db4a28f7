// Instructions of SSE, AVX and AVX-512 that raise FE_INVALID, with their operands.
#pragma once

namespace symreal::trace::x86_64 {

// The mandatory prefix, numbered as VEX numbers it: none for packed float, 66 packed double, F3 float, F2 double.
enum Prefix : unsigned { none, p66, pF3, pF2 };

enum class Reads { rm, first_and_rm, reg_and_rm, all_three };
enum class Writes { vector, other, other_if_F2 };
// Number of lanes: by the prefix (F2: one), or by the opcode.
enum class Lanes { by_prefix, one, all, one_if_odd, fused };

struct Row {
  unsigned map, first_opcode, last_opcode;
  unsigned double_prefixes; // bit p: with prefix p the operands are doubles
  bool double_if_wide;      // and W must be set, but where the prefix is F2
  Reads reads;
  Writes writes;
  Lanes lanes;
};
inline constexpr unsigned pd = 1 << p66, sd = 1 << pF2, pd_sd = pd | sd, floats = 0;
inline constexpr Row rows[] = {
    {1, 0x2C, 0x2D, pd_sd, false, Reads::rm, Writes::other, Lanes::by_prefix},            // conversion to an integer
    {1, 0x2E, 0x2F, pd, false, Reads::reg_and_rm, Writes::other, Lanes::one},             // ucomisd, comisd
    {1, 0x51, 0x51, pd_sd, false, Reads::rm, Writes::vector, Lanes::by_prefix},           // sqrt
    {1, 0x58, 0x59, pd_sd, false, Reads::first_and_rm, Writes::vector, Lanes::by_prefix}, // add, mul
    {1, 0x5A, 0x5A, pd_sd, false, Reads::rm, Writes::vector, Lanes::by_prefix},           // double to float
    {1, 0x5B, 0x5B, floats, false, Reads::rm, Writes::vector, Lanes::all},                // floats to integers
    {1, 0x5C, 0x5F, pd_sd, false, Reads::first_and_rm, Writes::vector, Lanes::by_prefix}, // sub, min, div, max
    {1, 0x78, 0x79, pd_sd | 1 << none, true, Reads::rm, Writes::other_if_F2, Lanes::by_prefix}, // to unsigned
    {1, 0x7A, 0x7B, pd, true, Reads::rm, Writes::vector, Lanes::all},                           // to 64-bit integers
    {1, 0x7C, 0x7D, pd, false, Reads::first_and_rm, Writes::vector, Lanes::all},                // hadd, hsub
    {1, 0xC2, 0xC2, pd_sd, false, Reads::first_and_rm, Writes::vector, Lanes::by_prefix},       // cmp
    {1, 0xD0, 0xD0, pd, false, Reads::first_and_rm, Writes::vector, Lanes::all},                // addsub
    {1, 0xE6, 0xE6, pd_sd, false, Reads::rm, Writes::vector, Lanes::all},                       // doubles to integers
    {2, 0x13, 0x13, floats, false, Reads::rm, Writes::vector, Lanes::all},                      // half to float
    {2, 0x2C, 0x2D, pd, true, Reads::first_and_rm, Writes::vector, Lanes::one_if_odd},          // scalef
    {2, 0x42, 0x43, pd, true, Reads::rm, Writes::vector, Lanes::one_if_odd},                    // getexp
    {2, 0x96, 0x9F, pd, true, Reads::all_three, Writes::vector, Lanes::fused},                  // fma, 132
    {2, 0xA6, 0xAF, pd, true, Reads::all_three, Writes::vector, Lanes::fused},                  // 213
    {2, 0xB6, 0xBF, pd, true, Reads::all_three, Writes::vector, Lanes::fused},                  // 231
    {3, 0x08, 0x08, floats, false, Reads::rm, Writes::vector, Lanes::all},                      // round: four floats
    {3, 0x09, 0x09, pd, false, Reads::rm, Writes::vector, Lanes::all},                          // doubles
    {3, 0x0A, 0x0A, floats, false, Reads::rm, Writes::vector, Lanes::all},                      // a float
    {3, 0x0B, 0x0B, pd, false, Reads::rm, Writes::vector, Lanes::one},                          // a double
    {3, 0x1D, 0x1D, floats, false, Reads::rm, Writes::vector, Lanes::all},                      // float to half
    {3, 0x26, 0x27, pd, true, Reads::rm, Writes::vector, Lanes::one_if_odd},                    // getmant
    {3, 0x40, 0x40, floats, false, Reads::first_and_rm, Writes::vector, Lanes::all},            // dot product of floats
    {3, 0x41, 0x41, pd, false, Reads::first_and_rm, Writes::vector, Lanes::all},                // of doubles
    {3, 0x50, 0x51, pd, true, Reads::first_and_rm, Writes::vector, Lanes::one_if_odd},          // range
    {3, 0x54, 0x55, pd, true, Reads::first_and_rm, Writes::vector, Lanes::one_if_odd},          // fixupimm
    {3, 0x56, 0x57, pd, true, Reads::rm, Writes::vector, Lanes::one_if_odd},                    // reduce
};

} // namespace symreal::trace::x86_64
