// Parts of a C source file around the functions.
#include "engine/emit/c/parts.h"
#include "engine/emit/language/words.h"

#include <algorithm>
#include <fmt/format.h>
#include <unordered_set>

namespace symreal {

namespace {

bool has_sine_and_cosine_of_one(Plan const &plan) {
  Nodes const &nodes = plan.graph->nodes;
  auto const angles_of = [&](Op op) {
    std::unordered_set<NodeId> angles;
    for (NodeId id = 0; id < nodes.size(); ++id)
      if (nodes[id].op == op && !plan.element(id)) angles.insert(nodes[id].operand[0]);
    return angles;
  };
  std::unordered_set<NodeId> const of_sines = angles_of(Op::sin), of_cosines = angles_of(Op::cos);
  return std::ranges::any_of(of_sines, [&](NodeId angle) { return of_cosines.contains(angle); });
}

// Pragmas that forbid fusion of multiplications and additions under any flags: gcc's SLP vectoriser fuses even with
// -ffp-contract=off, where sums and differences alternate; its loop vectoriser only as reroll::is_side_by_side says.
std::string no_fusion(Emission const &emission) {
  if (!emission.forbids_fusion()) return {};
  std::string text = "#if defined(__clang__)\n"
                     "#pragma STDC FP_CONTRACT OFF\n"
                     "#elif defined(__GNUC__)\n"
                     "#pragma GCC optimize(\"fp-contract=off\", \"no-tree-slp-vectorize\"" +
                     std::string(emission.plan.has_loops() ? ", \"no-tree-vectorize\"" : "") + ")\n";
  if (!emission.uses.side_by_side) return text + "#endif\n";
  return text + "#define SYMREAL_SIDE_BY_SIDE __attribute__((optimize(\"tree-loop-vectorize\")))\n"
                "#endif\n"
                "#ifndef SYMREAL_SIDE_BY_SIDE\n"
                "#define SYMREAL_SIDE_BY_SIDE\n"
                "#endif\n";
}

// Vectors are used only if the compiler has them and the target processor is requested: otherwise scalars are faster.
std::string vectors(Emission const &emission) {
  if (!emission.plan.vectors()) return {};
  lanes::LaneFunction const &function = *emission.plan.vectors();
  std::size_t const width = function.width, bytes = width * (emission.language.is_single ? 4 : 8);
  bool const loads = std::ranges::any_of(
      function.vectors, [](lanes::Vector const &vector) { return vector.form == lanes::Vector::Form::load; });
  std::string_view const processor = bytes <= 16   ? ""
                                     : bytes <= 32 ? " && defined(__AVX__)"
                                                   : " && defined(__AVX512F__)";
  std::string_view const real = emission.language.number.name;
  std::string const type = fmt::format("{}_{}", real, width);
  std::string text = fmt::format("#if defined(__has_builtin){}\n"
                                 "#if __has_builtin(__builtin_shufflevector)\n"
                                 "#define SYMREAL_VECTORS\n"
                                 "typedef {} {} __attribute__((vector_size({})));\n",
                                 processor, real, type, bytes);
  if (loads)
    text += fmt::format("static inline {0} load_{1}({2} const *from) {{\n"
                        "  {0} x;\n"
                        "  __builtin_memcpy(&x, from, sizeof x);\n"
                        "  return x;\n"
                        "}}\n",
                        type, width, real);
  if (!function.stores.empty())
    text += fmt::format("static inline void store_{1}({2} *to, {0} x) {{ __builtin_memcpy(to, &x, sizeof x); }}\n",
                        type, width, real);
  return text + "#endif\n#endif\n";
}

// Inlined into one function again, the parts would take the compiler superlinear time.
std::string apart(Emission const &emission) {
  if (!emission.uses.apart) return {};
  return "#if defined(__GNUC__)\n"
         "#define SYMREAL_APART __attribute__((noinline))\n"
         "#else\n"
         "#define SYMREAL_APART\n"
         "#endif\n";
}

// A compiler merges the sine and cosine of one angle into one call if it knows that they do not set errno, which
// generated code never reads. The results of glibc's merged call are bitwise those of the two.
std::string sine_and_cosine(Emission const &emission) {
  if (!has_sine_and_cosine_of_one(emission.plan)) return {};
  bool const is_cxx = emission.language.has_namespace, is_single = emission.language.is_single;
  std::string const number(emission.language.number.name);
  std::string text = "/* Nobody reads the errno of these: a compiler makes one call of both. */\n"
                     "#if defined(__GLIBC__) && defined(__GNUC__)\n";
  for (Op op : {Op::sin, Op::cos})
    text += fmt::format("{0}{1} {2}{3}({1}){4} __attribute__((const));\n", is_cxx ? "extern \"C\" " : "", number,
                        info(op).c, is_single ? "f" : "", is_cxx ? " noexcept" : "");
  return text + "#endif\n";
}

std::string value_checks(Emission const &emission) {
  if (!emission.uses.value_checks) return {};
  return "#include <stdio.h>\n\n"
         "static int all_finite;\n\n"
         "static void report_value(" +
         std::string(emission.language.number.name) +
         " value, char const *what) {\n"
         "  if (all_finite) fprintf(stderr, \"not finite: %s is %g\\n\", what, value);\n"
         "  all_finite = 0;\n"
         "}\n";
}

// Silences warnings about unknown pragmas: without OpenMP one thread computes all.
std::string quiet_pragmas(Emission const &emission) {
  if (emission.plan.threads == 1) return {};
  return "#if defined(__GNUC__) && !defined(_OPENMP)\n"
         "#pragma GCC diagnostic ignored \"-Wunknown-pragmas\"\n"
         "#endif\n";
}

} // namespace

std::string c_preamble(Emission const &emission) {
  return c_integer_includes(emission) + sine_and_cosine(emission) + value_checks(emission) + no_fusion(emission) +
         apart(emission) + quiet_pragmas(emission) + vectors(emission) + "\n";
}

std::string c_begin(Emission const &emission) {
  return fmt::format("#include \"{}.h\"\n\n#include <math.h>\n{}{}", emission.options.base_name,
                     emission.uses.truths ? "#include <stdbool.h>\n" : "", c_preamble(emission));
}

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

// A C string literal; escapes successive question marks, which could begin a trigraph.
static std::string c_string(std::string_view text) {
  std::string result = "\"";
  for (char const c : printable(text)) {
    if (c == '"' || c == '\\' || (c == '?' && result.back() == '?')) result += '\\';
    result += c;
  }
  return result + '"';
}

std::string c_guard_text(Emission const &emission) {
  Graph const &graph = emission.graph();
  if (graph.guards.empty()) return {};
  std::string list;
  for (Guard const &guard : graph.guards) list += "      " + c_string(guard_text(graph, guard)) + ",\n";
  return fmt::format("\nchar const *{}(int guard) {{\n  static char const *const text[] = {{\n{}  }};\n"
                     "  return guard > 0 && guard <= {} ? text[guard - 1] : \"\";\n}}\n",
                     emission.name("guard_text"), list, graph.guards.size());
}

std::string c_end(Emission const &emission) { return c_matrix_lists(emission) + c_guard_text(emission); }

} // namespace symreal
