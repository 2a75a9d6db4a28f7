#include "program/compile.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace symreal::program {
namespace {

enum class Why {
  numbers,  // it changes the numbers: not in the reference build
  serial,   // a kernel is recorded by one thread, and its objects are compiled one by one
  warnings, // rewritten text is not what warnings are for
  outputs,  // the outputs are ours
};

// Flags that are left out, with the number of words that follow each. One that ends in '*' stands for all that begin
// so.
struct Dropped {
  std::string_view flag;
  Why why;
  int operands = 0;
};
constexpr Dropped dropped[] = {
    {"-O*", Why::numbers},
    {"-ffast-math", Why::numbers},
    {"-funsafe-math-optimizations", Why::numbers},
    {"-fassociative-math", Why::numbers},
    {"-freciprocal-math", Why::numbers},
    {"-ffinite-math-only", Why::numbers},
    {"-fno-signed-zeros", Why::numbers},
    {"-fno-trapping-math", Why::numbers},
    {"-ffp-exception-behavior*", Why::numbers},
    {"-ffp-model*", Why::numbers},
    {"-ffp-contract*", Why::numbers},
    {"-fcx-*", Why::numbers},
    {"-fcomplex-arithmetic*", Why::numbers},
    {"-fbuiltin", Why::numbers},
    {"-fopenmp*", Why::serial},
    {"-flto*", Why::serial},
    {"-W*", Why::warnings}, // -Wl, and its like are kept below
    {"-pedantic*", Why::warnings},
    {"-c", Why::outputs},
    {"-S", Why::outputs},
    {"-E", Why::outputs},
    {"-o", Why::outputs, 1},
    {"-MF", Why::outputs, 1},
    {"-MT", Why::outputs, 1},
    {"-MQ", Why::outputs, 1},
    {"-M*", Why::outputs},
};

bool matches(Dropped const &row, std::string_view flag) {
  return row.flag.ends_with('*') ? flag.starts_with(row.flag.substr(0, row.flag.size() - 1)) : flag == row.flag;
}

bool is_passed_through(std::string_view flag) {
  return flag.starts_with("-Wl,") || flag.starts_with("-Wp,") || flag.starts_with("-Wa,");
}

Dropped const *find_dropped(std::string_view flag) {
  if (is_passed_through(flag)) return nullptr;
  auto at =
      std::find_if(std::begin(dropped), std::end(dropped), [flag](Dropped const &row) { return matches(row, flag); });
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

// The annotations need C++11.
std::string with_annotations(std::string const &flag) {
  bool const old = flag.ends_with("++98") || flag.ends_with("++03");
  return old ? flag.substr(0, flag.size() - 2) + "11" : flag;
}

} // namespace

std::vector<std::string> flags_of_numbers(std::vector<std::string> const &flags) {
  std::vector<std::string> found;
  std::copy_if(flags.begin(), flags.end(), std::back_inserter(found), [](std::string const &flag) {
    Dropped const *row = find_dropped(flag);
    return (row && row->why == Why::numbers) || flag.starts_with("-m");
  });
  return found;
}

std::vector<std::string> unchanged_flags(std::vector<std::string> const &flags) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    Dropped const *row = find_dropped(flags[i]);
    if (!row || row->why == Why::numbers)
      kept.push_back(flags[i]);
    else
      i += static_cast<std::size_t>(row->operands);
  }
  return kept;
}

static bool is_standard(std::string const &flag) {
  return flag.starts_with("-std=") || flag.starts_with("--std=") || flag == "-ansi";
}

std::vector<std::string> adapted_flags(std::vector<std::string> const &flags) {
  std::vector<std::string> adapted = original_flags(flags, Variant::replay);
  bool has_standard = false;
  for (std::string &flag : adapted) {
    if (!is_standard(flag)) continue;
    has_standard = true;
    flag = standard(flag);
  }
  if (!has_standard) adapted.push_back("-std=c++20");
  return adapted;
}

std::vector<std::string> original_flags(std::vector<std::string> const &flags, Variant variant) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    std::string const &flag = flags[i];
    Dropped const *row = find_dropped(flag);
    if (row && !(row->why == Why::numbers && variant == Variant::own_flags))
      i += static_cast<std::size_t>(row->operands);
    else
      kept.push_back(is_standard(flag) ? with_annotations(flag) : flag);
  }
  return kept;
}

} // namespace symreal::program
