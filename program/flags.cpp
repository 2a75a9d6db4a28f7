#include "program/compile.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace symreal::program {
namespace {

// Prefixes of flags that are left out, with the number of words each takes.
struct Dropped {
  std::string_view flag;
  bool whole; // the flag must equal the text, else it need only begin with it
  int operands;
};
constexpr Dropped dropped[] = {
    // They change the numbers, or what a trace sees of them.
    {"-O", false, 0},
    {"-ffast-math", true, 0},
    {"-funsafe-math-optimizations", true, 0},
    {"-fassociative-math", true, 0},
    {"-freciprocal-math", true, 0},
    {"-ffinite-math-only", true, 0},
    {"-fno-signed-zeros", true, 0},
    {"-fno-trapping-math", true, 0},
    {"-ffp-contract", false, 0},
    {"-fbuiltin", true, 0},
    {"-fopenmp", false, 0},
    {"-flto", false, 0},
    // Rewritten text is not what warnings are for.
    {"-W", false, 0}, // -Wl, and its like are kept below
    {"-pedantic", false, 0},
    // Outputs are ours.
    {"-c", true, 0},
    {"-S", true, 0},
    {"-E", true, 0},
    {"-o", true, 1},
    {"-MF", true, 1},
    {"-MT", true, 1},
    {"-MQ", true, 1},
    {"-M", false, 0},
};

bool is_passed_through(std::string_view flag) {
  return flag.starts_with("-Wl,") || flag.starts_with("-Wp,") || flag.starts_with("-Wa,");
}

Dropped const *find_dropped(std::string_view flag) {
  if (is_passed_through(flag)) return nullptr;
  auto matches = [flag](Dropped const &row) { return row.whole ? flag == row.flag : flag.starts_with(row.flag); };
  auto at = std::find_if(std::begin(dropped), std::end(dropped), matches);
  return at == std::end(dropped) ? nullptr : at;
}

// The headers of symbolic mode need C++20; older standards of the user give way.
std::string standard(std::string_view flag) {
  std::string_view value = flag.substr(flag.find('=') + 1);
  bool gnu = value.starts_with("gnu");
  for (std::string_view newer : {"++20", "++2a", "++23", "++2b", "++26", "++2c"})
    if (value.ends_with(newer)) return std::string(flag);
  return gnu ? "-std=gnu++20" : "-std=c++20";
}

} // namespace

std::vector<std::string> adapted_flags(std::vector<std::string> const &flags) {
  std::vector<std::string> adapted;
  bool has_standard = false;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    std::string const &flag = flags[i];
    if (Dropped const *row = find_dropped(flag)) {
      i += static_cast<std::size_t>(row->operands);
      continue;
    }
    bool is_standard = flag.starts_with("-std=") || flag.starts_with("--std=");
    has_standard |= is_standard;
    adapted.push_back(is_standard ? standard(flag) : flag);
  }
  if (!has_standard) adapted.push_back("-std=c++20");
  return adapted;
}

} // namespace symreal::program
