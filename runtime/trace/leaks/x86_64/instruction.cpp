#include "runtime/trace/leaks/x86_64/instruction.h"

#include <bit>
#include <cstring>

namespace symreal::trace::x86_64 {
namespace {

// Instructions of SSE, AVX and AVX-512 that raise FE_INVALID, with their operands.
//
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
constexpr unsigned pd = 1 << p66, sd = 1 << pF2, pd_sd = pd | sd, floats = 0;
constexpr Row rows[] = {
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

enum class Encoding { legacy, vex, evex };
// Prefixes of an instruction, in any of the three encodings.
struct Head {
  Encoding encoding = Encoding::legacy;
  unsigned map = 1; // 1: 0F, 2: 0F 38, 3: 0F 3A
  Prefix prefix = none;
  bool wide = false;                                    // W
  unsigned reg_high = 0, index_high = 0, base_high = 0; // bits above the three of ModRM and SIB, in place
  unsigned first = 0;                                   // vvvv
  unsigned vector_bytes = 16;
  bool broadcast = false; // EVEX: one element in memory for all lanes
  bool thread_segment = false, short_address = false;
};

Row const *find_row(unsigned map, unsigned opcode) {
  for (Row const &row : rows)
    if (row.map == map && row.first_opcode <= opcode && opcode <= row.last_opcode) return &row;
  return nullptr;
}

class Decoder {
public:
  Decoder(std::uint8_t const *code, AddressRegisters const &registers)
      : at_(code),
        begin_(code),
        registers_(registers) {}

  std::optional<Instruction> decode() {
    if (!read_head()) return std::nullopt;
    unsigned const opcode = next();
    Row const *row = find_row(head_.map, opcode);
    if (!row) return std::nullopt;
    bool const has_immediate = head_.map == 3 || (head_.map == 1 && opcode == 0xC2);
    bool const is_wide_enough = !row->double_if_wide || head_.wide || head_.prefix == pF2;
    bool const is_double = is_wide_enough && (row->double_prefixes >> head_.prefix & 1) != 0;
    unsigned const lanes = count_lanes(*row, opcode);
    unsigned const modrm = next(), reg = (modrm >> 3 & 7) | head_.reg_high;
    Operand const rm = read_rm(modrm, lanes, has_immediate);
    Instruction instruction{static_cast<unsigned>(at_ - begin_) + has_immediate, {}, {}};
    bool const writes_mask = head_.encoding == Encoding::evex && opcode == 0xC2;
    bool const writes_other =
        row->writes == Writes::other || (row->writes == Writes::other_if_F2 && head_.prefix == pF2) || writes_mask;
    if (!writes_other) instruction.destination = reg;
    if (!is_double) return instruction;
    Operand const from_reg{false, reg, 0, lanes}, from_first{false, head_.first, 0, lanes};
    switch (row->reads) {
    case Reads::rm: instruction.sources = {rm}; break;
    case Reads::reg_and_rm: instruction.sources = {from_reg, rm}; break;
    case Reads::all_three: instruction.sources = {from_reg, from_first, rm}; break;
    case Reads::first_and_rm:
      instruction.sources = {head_.encoding == Encoding::legacy ? from_reg : from_first, rm};
      break;
    }
    return instruction;
  }

private:
  unsigned next() { return *at_++; }

  unsigned count_lanes(Row const &row, unsigned opcode) const {
    bool one = false;
    switch (row.lanes) {
    case Lanes::by_prefix: one = head_.prefix == pF2; break;
    case Lanes::one: one = true; break;
    case Lanes::all: break;
    case Lanes::one_if_odd: one = (opcode & 1) != 0; break;
    case Lanes::fused: one = (opcode & 9) == 9; break;
    }
    return one ? 1 : head_.vector_bytes / 8;
  }

  bool read_head() {
    bool has_66 = false, has_F2 = false, has_F3 = false;
    unsigned byte = next();
    for (;; byte = next()) {
      if (at_ - begin_ > 14) return false; // no instruction is longer
      if (byte == 0x66)
        has_66 = true;
      else if (byte == 0xF2 || byte == 0xF3)
        has_F2 = byte == 0xF2, has_F3 = byte == 0xF3;
      else if (byte == 0x64)
        head_.thread_segment = true;
      else if (byte == 0x67)
        head_.short_address = true;
      else if (byte != 0x2E && byte != 0x36 && byte != 0x3E && byte != 0x26)
        break;
    }
    head_.prefix = has_F2 ? pF2 : has_F3 ? pF3 : has_66 ? p66 : none;
    if (byte == 0xC4 || byte == 0xC5 || byte == 0x62) return read_vex(byte);
    if (byte >> 4 == 4) { // REX
      set_rex(byte);
      byte = next();
    }
    if (byte != 0x0F) return false;
    if (*at_ == 0x38 || *at_ == 0x3A) head_.map = next() == 0x38 ? 2 : 3;
    return true;
  }

  // 0WRXB in the low bits.
  void set_rex(unsigned rex) {
    head_.wide = (rex & 8) != 0;
    head_.reg_high = (rex & 4) << 1, head_.index_high = (rex & 2) << 2, head_.base_high = (rex & 1) << 3;
  }

  bool read_vex(unsigned byte) {
    head_.encoding = byte == 0x62 ? Encoding::evex : Encoding::vex;
    unsigned const first = next();
    if (byte == 0xC5) {
      set_rex(~first >> 5 & 4);
      set_vector(first);
      head_.vector_bytes = (first & 4) != 0 ? 32 : 16;
      return true;
    }
    unsigned const second = next();
    set_rex((~first >> 5 & 7) | (second >> 4 & 8));
    set_vector(second);
    head_.map = first & (byte == 0x62 ? 7 : 31);
    if (byte == 0xC4) {
      head_.vector_bytes = (second & 4) != 0 ? 32 : 16;
    } else {
      unsigned const third = next();
      head_.reg_high |= ~first & 0x10;
      head_.first |= ~third << 1 & 0x10;
      head_.broadcast = (third & 0x10) != 0;
      if ((third >> 5 & 3) == 3) return false; // a rounding mode, which comes with exceptions suppressed
      head_.vector_bytes = 16u << (third >> 5 & 3);
    }
    return true;
  }
  void set_vector(unsigned byte) {
    head_.first = ~byte >> 3 & 15;
    head_.prefix = static_cast<Prefix>(byte & 3);
  }

  Operand read_rm(unsigned modrm, unsigned lanes, bool has_immediate) {
    unsigned const mod = modrm >> 6, rm = modrm & 7;
    if (mod == 3) {
      unsigned const high = head_.encoding == Encoding::evex ? head_.index_high << 1 : 0;
      return {false, rm | head_.base_high | high, 0, lanes};
    }
    // EVEX: a displacement of one byte counts in units of the memory operand.
    if (head_.broadcast) lanes = 1;
    std::uint64_t const unit = head_.encoding == Encoding::evex ? lanes * 8 : 1;
    std::uint64_t address = 0;
    bool long_displacement = mod == 2;
    if (rm == 4) {
      unsigned const sib = next();
      unsigned const index = (sib >> 3 & 7) | head_.index_high, base = sib & 7;
      if (index != 4) address += registers_.general[index] << (sib >> 6);
      if (base == 5 && mod == 0)
        long_displacement = true;
      else
        address += registers_.general[base | head_.base_high];
    } else if (rm == 5 && mod == 0) {
      std::uint64_t const end = static_cast<std::uint64_t>(at_ - begin_) + 4 + has_immediate;
      address = registers_.instruction + end;
      long_displacement = true;
    } else {
      address = registers_.general[rm | head_.base_high];
    }
    if (long_displacement) {
      std::int32_t displacement;
      std::memcpy(&displacement, at_, sizeof displacement);
      at_ += sizeof displacement;
      address += static_cast<std::uint64_t>(std::int64_t{displacement});
    } else if (mod == 1) {
      address += static_cast<std::uint64_t>(std::int64_t{std::bit_cast<std::int8_t>(*at_++)}) * unit;
    }
    if (head_.short_address) address &= 0xFFFF'FFFFu;
    if (head_.thread_segment) address += registers_.thread;
    return {true, 0, address, lanes};
  }

  std::uint8_t const *at_, *begin_;
  AddressRegisters const &registers_;
  Head head_;
};

} // namespace

std::optional<Instruction> decode(std::uint8_t const *code, AddressRegisters const &registers) {
  return Decoder(code, registers).decode();
}

} // namespace symreal::trace::x86_64
