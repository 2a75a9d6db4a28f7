#include "rewrite/request/driver_options.h"

#include <algorithm>
#include <clang/Driver/Options.h>
#include <iterator>
#include <llvm/Option/ArgList.h>
#include <llvm/Option/OptTable.h>
#include <string_view>

namespace symreal::rewrite {
namespace {

namespace options = clang::driver::options;

// The first row that an option or one of its groups matches counts.
struct OptionMeaning {
  unsigned option;
  About about;
};
constexpr OptionMeaning rows[] = {
    {options::OPT_INPUT, About::input},
    {options::OPT_o, About::output},
    {options::OPT_M, About::question},
    {options::OPT_MM, About::question},
    {options::OPT_M_Group, About::dependencies},
    {options::OPT__version, About::question},
    {options::OPT_help, About::question},
    {options::OPT__HASH_HASH_HASH, About::question},
    {options::OPT_dumpversion, About::question},
    {options::OPT_dumpmachine, About::question},
    {options::OPT_dumpspecs, About::question},
    {options::OPT_Action_Group, About::action},
    {options::OPT_x, About::language},
    {options::OPT_std_EQ, About::standard},
    {options::OPT_ansi, About::standard},
    {options::OPT_O_Group, About::numbers},
    {options::OPT_ffast_math, About::numbers},
    {options::OPT_funsafe_math_optimizations, About::numbers},
    {options::OPT_fassociative_math, About::numbers},
    {options::OPT_freciprocal_math, About::numbers},
    {options::OPT_ffinite_math_only, About::numbers},
    {options::OPT_fno_signed_zeros, About::numbers},
    {options::OPT_fno_trapping_math, About::numbers},
    {options::OPT_ffp_exception_behavior_EQ, About::numbers},
    {options::OPT_ffp_model_EQ, About::numbers},
    {options::OPT_ffp_contract, About::numbers},
    {options::OPT_fcx_limited_range, About::numbers},
    {options::OPT_fcx_fortran_rules, About::numbers},
    {options::OPT_fcomplex_arithmetic_EQ, About::numbers},
    {options::OPT_fbuiltin, About::numbers},
    {options::OPT_iquote, About::directories},
    {options::OPT_isystem, About::directories},
    {options::OPT_idirafter, About::directories},
    {options::OPT_I, About::directories},
    {options::OPT_include, About::headers},
    {options::OPT_imacros, About::headers},
    {options::OPT_Wa_COMMA, About::other},
    {options::OPT_Wp_COMMA, About::other},
    {options::OPT_Wl_COMMA, About::linking},
    {options::OPT_l, About::linking},
    {options::OPT_L, About::linking},
    {options::OPT_pthread, About::linking},
    {options::OPT_W_Group, About::warnings},
    {options::OPT_pedantic_Group, About::warnings},
};

// Option prefixes that Clang's table lacks, or splits into many options.
struct Beginning {
  std::string_view text;
  About about;
};
constexpr Beginning beginnings[] = {
    {"-fopenmp", About::openmp},        {"-flto", About::link_time},
    {"-fsanitize", About::sanitizers},  {"-m", About::machine},
    {"-fcx-", About::numbers},          {"-print-", About::question},
    {"--print-", About::question},      {"--help=", About::question},
    {"--target-help", About::question}, {"-dumpfullversion", About::question},
};
constexpr std::string_view with_operand[] = {"-aux-info", "-wrapper", "-dumpbase", "-dumpbase-ext", "-soname"};

About about(llvm::opt::Arg const &argument, std::string_view word) {
  llvm::opt::Option const option = argument.getOption();
  // -mllvm and its like have operands of their own and are not about the machine.
  bool const is_of_clang = option.matches(options::OPT_mllvm);
  for (Beginning const &row : beginnings)
    if (word.starts_with(row.text) && !is_of_clang) return row.about;
  for (OptionMeaning const &row : rows)
    if (option.matches(row.option)) return row.about;
  return About::other;
}

} // namespace

std::vector<DriverOption> driver_options(std::span<std::string const> words) {
  std::vector<char const *> pointers;
  for (std::string const &word : words) pointers.push_back(word.c_str());
  unsigned missing_at = 0, missing = 0;
  llvm::opt::InputArgList const read = clang::driver::getDriverOptTable().ParseArgs(
      pointers, missing_at, missing, llvm::opt::Visibility(options::ClangOption));
  std::vector<DriverOption> found;
  for (llvm::opt::Arg const *argument : read) {
    std::size_t const at = argument->getIndex();
    if (!found.empty() && at < found.back().word + found.back().length) continue; // an operand that Clang does not know
    DriverOption option{about(*argument, words[at]), "", "", at, 1};
    bool const is_known = !argument->getOption().matches(options::OPT_UNKNOWN);
    if (option.about != About::input)
      option.name = is_known ? argument->getOption().getPrefixedName().str() : words[at];
    if (argument->getNumValues() > 0 && (is_known || option.about == About::input))
      option.value = argument->getValue(0);
    if (is_known && option.about != About::input)
      for (char const *value : argument->getValues()) // in a word of its own, or joined to the name
        option.length += at + option.length < words.size() && value == pointers[at + option.length];
    if (!is_known && std::ranges::find(with_operand, words[at]) != std::end(with_operand) && at + 1 < words.size()) {
      option.value = words[at + 1];
      option.length = 2;
    }
    found.push_back(std::move(option));
  }
  if (missing > 0) found.push_back({About::other, words[missing_at], "", missing_at, words.size() - missing_at});
  return found;
}

void append(std::vector<std::string> &to, DriverOption const &option, std::span<std::string const> words) {
  for (std::string const &word : words.subspan(option.word, option.length)) to.push_back(word);
}

std::vector<std::string> without(std::vector<std::string> const &words, std::initializer_list<About> left_out) {
  std::vector<std::string> kept;
  for (DriverOption const &option : driver_options(words))
    if (std::ranges::find(left_out, option.about) == left_out.end()) append(kept, option, words);
  return kept;
}

} // namespace symreal::rewrite
