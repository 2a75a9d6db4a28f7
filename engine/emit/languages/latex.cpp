#include "engine/emit/languages/drawn.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace symreal {

static constexpr auto greek = std::to_array<std::string_view>(
    {"Delta", "Gamma", "Lambda", "Omega",   "Phi",   "Pi",    "Psi",   "Sigma",   "Theta",  "Upsilon", "Xi", "alpha",
     "beta",  "chi",   "delta",  "epsilon", "eta",   "gamma", "iota",  "kappa",   "lambda", "mu",      "nu", "omega",
     "phi",   "pi",    "psi",    "rho",     "sigma", "tau",   "theta", "upsilon", "xi",     "zeta"});
static_assert(std::ranges::is_sorted(greek));

// theta$2 becomes a theta with the index 2, and t12 a t with 12.
std::string latex_variable(std::string const &name) {
  std::size_t const end = name.find_last_not_of("0123456789") + 1;
  std::string const index = name.substr(end);
  std::string base = name.substr(0, end);
  while (base.ends_with('$')) base.pop_back();
  std::erase(base, '$');
  if (std::ranges::binary_search(greek, base))
    base = "\\" + base;
  else if (base.size() > 1)
    base = "\\mathit{" + base + "}";
  return index.empty() ? base : base + "_{" + index + "}";
}

} // namespace symreal
