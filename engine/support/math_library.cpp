#include "engine/support/math_library.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

namespace symreal {

namespace {

// Arguments at which the code with FMA differs from that without: found with glibc 2.36, with and without
// GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2.
constexpr std::array sine_at = {0x1.ed916872b020dp-3, 0x1.09374bc6a7efap-2, 0x1.9f3b645a1cac1p+0, 0x1.a2b020c49ba5fp+1};
constexpr std::array sine_fused = {0x1.e8cdd542d7eb5p-3, 0x1.0642c1d85096ep-2, 0x1.ff5436d5700d6p-1,
                                   -0x1.084983a158a59p-3};
constexpr std::array sine_plain = {0x1.e8cdd542d7eb4p-3, 0x1.0642c1d85096fp-2, 0x1.ff5436d5700d7p-1,
                                   -0x1.084983a158a58p-3};

// Hides a value from constant folding, which may round differently.
double opaque(double x) {
  double volatile hidden = x;
  return hidden;
}

std::string code_name() {
  bool is_fused = true, is_plain = true;
  for (std::size_t k = 0; k < sine_at.size(); ++k) {
    double const found = std::sin(opaque(sine_at[k]));
    is_fused &= found == sine_fused[k], is_plain &= found == sine_plain[k];
  }
  if (is_fused) return "code for processors with FMA";
  return is_plain ? "code for processors without FMA" : "code of another kind";
}

std::uint64_t digest() {
  std::uint64_t all = 0xcbf29ce484222325;
  auto const add = [&](double result) { all = (all ^ std::bit_cast<std::uint64_t>(result)) * 0x100000001b3; };
  for (int k = 1; k < 4000; ++k) {
    double const x = opaque(k / 1024.0 + 0.125); // exact
    for (double const result :
         {std::sin(x), std::cos(x), std::tan(x), std::exp(x), std::log(x), std::atan(x), std::sinh(x), std::tanh(x),
          std::pow(x, opaque(1.7)), std::atan2(x, opaque(1.7)), std::cbrt(x), std::tgamma(x)})
      add(result);
  }
  return all ^ all >> 32;
}

} // namespace

std::string math_library() {
#ifdef __GLIBC__
  std::string const library = std::string("glibc ") + gnu_get_libc_version();
#else
  std::string const library = "a library other than glibc";
#endif
  return fmt::format("{}, {} ({:08x})", library, code_name(), static_cast<std::uint32_t>(digest()));
}

} // namespace symreal
