#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto greek = std::to_array<std::string_view>(
    {"Delta", "Gamma", "Lambda", "Omega",   "Phi",   "Pi",    "Psi",   "Sigma",   "Theta",  "Upsilon", "Xi", "alpha",
     "beta",  "chi",   "delta",  "epsilon", "eta",   "gamma", "iota",  "kappa",   "lambda", "mu",      "nu", "omega",
     "phi",   "pi",    "psi",    "rho",     "sigma", "tau",   "theta", "upsilon", "xi",     "zeta"});
static_assert(std::ranges::is_sorted(greek));

// theta$2 becomes a theta with the index 2, and t12 a t with 12.
static std::string variable(std::string const &name) {
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

static constexpr OperationSpelling spellings[] = {
    {Op::mul, R"($x:13 \, $y:14)", 13},
    {Op::div, R"(\frac{$x}{$y})"},
    {Op::abs, R"(\lvert $x \rvert)"},
    {Op::sqrt, R"(\sqrt{$x})"},
    {Op::cbrt, R"(\sqrt[3]{$x})"},
    {Op::fma, R"($x:13 \, $y:14 + $z:13)", 12},
    {Op::fmin, R"(\min(\,$x, $y))"},
    {Op::fmax, R"(\max(\,$x, $y))"},
    {Op::floor, R"(\lfloor $x \rfloor)"},
    {Op::ceil, R"(\lceil $x \rceil)"},
    {Op::f32, R"(\operatorname{single}($x))"},
    {Op::wrap_int8, R"(\operatorname{wrapped}_{8}($x))"},
    {Op::wrap_int16, R"(\operatorname{wrapped}_{16}($x))"},
    {Op::wrap_int32, R"(\operatorname{wrapped}_{32}($x))"},
    {Op::wrap_uint8, R"($x:14 \bmod 2^{8})", 13},
    {Op::wrap_uint16, R"($x:14 \bmod 2^{16})", 13},
    {Op::wrap_uint32, R"($x:14 \bmod 2^{32})", 13},
    {Op::wide_mul, R"($x:13 \, $y:14)", 13},
    {Op::wide_equal, R"($x:12 = $y:12)", 9},
    {Op::wide_select, R"(\begin{cases} $y & \text{if } $x \\ $z & \text{otherwise} \end{cases})"},
    {Op::wide_value, R"(\operatorname{signed}($x))"},
    {Op::wide_uvalue, "($x)"},
    {Op::wide_low, R"($x:14 \bmod 2^{32})", 13},
    {Op::exp, R"(e^{$x})"},
    {Op::exp2, R"(2^{$x})"},
    {Op::log, R"(\ln($x))"},
    {Op::log2, R"(\log_{2}($x))"},
    {Op::log10, R"(\log_{10}($x))"},
    {Op::pow, R"({$x:15}^{$y})"},
    {Op::tgamma, R"(\Gamma($x))"},
    {Op::lgamma, R"(\ln\lvert\Gamma($x)\rvert)"},
    {Op::le, R"($x:12 \le $y:12)", 10},
    {Op::ge, R"($x:12 \ge $y:12)", 10},
    {Op::eq, "$x:12 = $y:12", 9},
    {Op::ne, R"($x:12 \ne $y:12)", 9},
    {Op::logical_and, R"($x:12 \land $y:12)", 5},
    {Op::logical_or, R"($x:12 \lor $y:12)", 4},
    {Op::logical_not, R"(\lnot $x:15)", 14},
    {Op::select, R"(\begin{cases} $y & \text{if } $x \\ $z & \text{otherwise} \end{cases})"},
};

Language language_latex() {
  Language latex;
  latex.names = {.keywords = {}, .has_underscores = false};
  latex.comment = {"% ", "% ", ""};
  latex.lines = {.width = 100, .least = 60};
  latex.numbers = {.nan = R"(\text{NaN})",
                   .negative_nan = R"(\text{NaN})",
                   .infinity = R"(\infty)",
                   .negative_infinity = R"(-\infty)",
                   .exponent = R"(\text{e})",
                   .sign_binding = 11};
  latex.expressions = {
      .call_prefix = R"(\operatorname{)",
      .call_open = "}(",
      .local_prefix = R"(\operatorname{)",
      .variable = variable,
      .operations = spellings,
      .element = R"(\mathit{$array}_{$index})",
      .yes = R"(\text{true})",
      .truth_as_number = R"([$x])",
      .small_integer = "$value",
      .large_integer = "$value",
      .kept_integer = "$element",
      .table_index = R"(\operatorname{nearest}_{$extent}($index))",
  };
  latex.statements = {
      .constant = R"(\begin{dmath*} $name = $value \end{dmath*})",
      .set = R"(\begin{dmath*} $name = $value \end{dmath*})",
      .keep_integer = R"(\begin{dmath*} $element = $value \end{dmath*})",
      .check = R"(\begin{dmath*} \text{guard $number fails if } $condition \end{dmath*})",
  };
  latex.functions = {
      .head = R"(\paragraph{$name})",
      .local_head = R"(\paragraph{$name})",
      .input = "$name",
      .output = "$name",
      .call = R"(\noindent Here stands the part $name.)",
      .checked_call = R"(\noindent Here stands the part $name.)",
      .most_statements = 100000,
  };
  latex.tables = {.begin = R"(\begin{dmath*} \mathit{$name} = ()", .end = R"() \end{dmath*})"};
  latex.files = {
      .extension = ".tex",
      .begin = module_begin,
      .integer_functions = [](Emission const &) { return std::string(); },
      .end = module_end,
  };
  latex.has_blocks = false;
  latex.module = {
      .begin = "\n% To be read by \\input, with \\usepackage{amsmath, breqn} before the document.\n\n",
  };
  return latex;
}

} // namespace symreal
