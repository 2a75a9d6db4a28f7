#include "engine/emit/c/parts.h"

#include <algorithm>
#include <fmt/format.h>
#include <unordered_set>

namespace symreal {
namespace {

bool has_sine_and_cosine_of_one(Schedule const &plan) {
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

} // namespace

// Fusion of multiplications and additions is forbidden under any flags: gcc's SLP vectoriser fuses even with
// -ffp-contract=off, where sums and differences alternate; its loop vectoriser only as reroll/side_by_side.h says.
std::string c_no_fusion(Emission const &emission) {
  if (!emission.forbids_fusion()) return {};
  std::string text = "#if defined(__clang__)\n"
                     "#pragma STDC FP_CONTRACT OFF\n"
                     "#elif defined(__GNUC__)\n"
                     "#pragma GCC optimize(\"fp-contract=off\", \"no-tree-slp-vectorize\"" +
                     std::string(emission.loops ? ", \"no-tree-vectorize\"" : "") + ")\n";
  if (!emission.uses.side_by_side) return text + "#endif\n";
  return text + "#define SYMREAL_SIDE_BY_SIDE __attribute__((optimize(\"tree-loop-vectorize\")))\n"
                "#endif\n"
                "#ifndef SYMREAL_SIDE_BY_SIDE\n"
                "#define SYMREAL_SIDE_BY_SIDE\n"
                "#endif\n";
}

// Vectors are used only if the compiler has them and the target processor is requested: otherwise scalars are faster.
std::string c_vectors(Emission const &emission) {
  if (!emission.lanes || !emission.lanes->compute) return {};
  lanes::LaneFunction const &function = *emission.lanes->compute;
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
std::string c_apart(Emission const &emission) {
  if (!emission.uses.apart) return {};
  return "#if defined(__GNUC__)\n"
         "#define SYMREAL_APART __attribute__((noinline))\n"
         "#else\n"
         "#define SYMREAL_APART\n"
         "#endif\n";
}

// A compiler merges the sine and cosine of one angle into one call if it knows that they do not set errno, which
// generated code never reads. The results of glibc's merged call are bitwise those of the two.
std::string c_sine_and_cosine(Emission const &emission) {
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

std::string c_value_checks(Emission const &emission) {
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
std::string c_quiet_pragmas(Emission const &emission) {
  if (emission.plan.threads == 1) return {};
  return "#if defined(__GNUC__) && !defined(_OPENMP)\n"
         "#pragma GCC diagnostic ignored \"-Wunknown-pragmas\"\n"
         "#endif\n";
}

std::string c_begin(Emission const &emission) {
  return fmt::format("#include \"{}.h\"\n\n#include <math.h>\n{}{}{}{}{}{}{}{}\n", emission.options.base_name,
                     emission.uses.truths ? "#include <stdbool.h>\n" : "", c_integer_includes(emission),
                     c_sine_and_cosine(emission), c_value_checks(emission), c_no_fusion(emission), c_apart(emission),
                     c_quiet_pragmas(emission), c_vectors(emission));
}

} // namespace symreal
