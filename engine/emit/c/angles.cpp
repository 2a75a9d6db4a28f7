#include "engine/emit/c/parts.h"

#include <fmt/format.h>

namespace symreal {

// Method: Cody-Waite reduction (1980) subtracts a multiple of pi/2 in three parts of 33, 33 and 53 bits, so that the
// first two products and differences are exact; on -pi/4..pi/4 sine and cosine are minimax polynomials (Remez 1934),
// odd and even, with an error of 2^-58 for the sine and 2^-64 for the cosine. For angles within 1e5 results have an
// error below 2.5 units in the last place; tests/emit/angles.test measures it.
std::string c_sines_and_cosines(Emission const &emission) {
  if (emission.plan.angles.size() == 0) return {};
  std::string_view const prefix = emission.language.expressions.call_prefix;
  return fmt::format(
      R"(/* Sines and cosines of angles within 1e5, side by side. Their errors are below 2.5 units in the last place. */
static inline void sines_and_cosines_within(int count, double const *angle, double *{1} sine,
    double *{1} cosine) {{
  for (int k = 0; k < count; ++k) {{
    int const turn = (int)(angle[k]*0.6366197723675814 + 65536.5);
    double const n = turn - 65536;
    double const x =
        ((angle[k] - n*1.5707963267341256) - n*6.077100506303966e-11) - n*2.0222662487959506e-21;
    double const z = x*x;
    double const s = x + x*z*(-0.16666666666666632 + z*(0.008333333333322425 + z*(-0.0001984126982981695 +
        z*(2.7557313695226535e-06 + z*(-2.505075865327825e-08 + z*1.589682792960301e-10)))));
    double const c = 1.0 - z*(0.5 - z*(0.0416666666666666 + z*(-0.0013888888888874138 +
        z*(2.4801587289491837e-05 + z*(-2.7557314355244965e-07 + z*(2.0875723684855263e-09 -
        z*1.1359669889521284e-11))))));
    double const up = turn & 1 ? c : s, along = turn & 1 ? s : c;
    sine[k] = turn & 2 ? -up : up;
    cosine[k] = (turn + 1) & 2 ? -along : along;
  }}
}}

/* Other angles, and what is no number, are left to the library. */
static void sines_and_cosines(int count, double const *angle, double *{1} sine,
    double *{1} cosine) {{
  int far = 0;
  for (int k = 0; k < count; ++k) far |= !({0}fabs(angle[k]) <= 1e5);
  if (!far) {{
    sines_and_cosines_within(count, angle, sine, cosine);
    return;
  }}
  for (int k = 0; k < count; ++k) {{
    if ({0}fabs(angle[k]) <= 1e5) {{
      sines_and_cosines_within(1, angle + k, sine + k, cosine + k);
    }} else {{
      sine[k] = {0}sin(angle[k]);
      cosine[k] = {0}cos(angle[k]);
    }}
  }}
}}

)",
      prefix, emission.language.has_namespace ? "__restrict" : "restrict");
}

} // namespace symreal
