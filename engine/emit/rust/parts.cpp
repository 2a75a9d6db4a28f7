#include "engine/emit/rust/parts.h"

#include "engine/emit/print/banner.h"
#include "engine/emit/print/code_text.h"
#include "engine/emit/print/module.h"
#include "engine/graph/names.h"
#include "engine/support/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <set>
#include <string_view>

namespace symreal {

namespace {

std::string upper(std::string name) {
  for (char &c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string size(Emission const &emission, std::string const &name, std::size_t value) {
  return fmt::format("pub const {}: usize = {};\n", upper(emission.name(name)), value);
}

// Offsets of the objects, in a module of their own, since their names are the user's.
std::string places(Emission const &emission, std::string const &role, std::vector<Object> const &objects) {
  NameRules const rules{emission.language.names.keywords, /*ignores_case=*/true}; // names are converted to capitals
  std::vector<std::string> const names = identifiers(objects, rules);
  std::string text;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].count != 0)
      text += fmt::format("    pub const {}: usize = {};\n", upper(names[i]), objects[i].first);
  if (text.empty()) return {};
  return fmt::format("/// The index of the first number of each {0}.\npub mod {1} {{\n{2}}}\n\n", role,
                     emission.name(role + "_at"), text);
}

std::string matrices(Emission const &emission) {
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission)) {
    text += matrix_remark(emission, matrix);
    for (auto const &[name, value] : matrix.sizes()) text += size(emission, matrix.name + "_" + name, value);
    for (IndexList const &list : matrix.lists)
      text += fmt::format("pub static {}: [usize; {}] = [{}];\n",
                          upper(emission.name(matrix.name + "_" + std::string(list.name))), list.values.size(),
                          lines_of(emission.language, list.texts()));
    text += "\n";
  }
  return text;
}

// C's functions, for bitwise agreement with the other languages that call them. They are hidden, since a compiler would
// replace powers with constant exponents by products that round differently.
std::string library(Emission const &emission) {
  std::span<OperationSpelling const> const exceptions = emission.language.expressions.operations;
  std::string const real(emission.language.number.name);
  std::string declarations, functions;
  for (OperationInfo const &operation : operations()) {
    if (operation.form != Form::call || !emission.uses.operations[static_cast<std::size_t>(operation.op)]) continue;
    if (std::ranges::find(exceptions, operation.op, &OperationSpelling::op) != exceptions.end()) continue;
    std::string parameters, arguments;
    for (unsigned i = 0; i < operation.arity; ++i) {
      std::string const name(1, "xyz"[i]), separator = i == 0 ? "" : ", ";
      parameters += separator + name + ": " + real;
      arguments += separator + (operation.op == Op::pow ? "std::ptr::read_volatile(&" + name + ")" : name);
    }
    declarations += fmt::format("        #[link_name = \"{0}{2}\"]\n        fn c_{0}({1}) -> {3};\n", operation.c,
                                parameters, emission.language.is_single ? "f" : "", real);
    functions +=
        fmt::format("\n    #[inline]\n    pub fn {0}({1}) -> {3} {{\n        unsafe {{ c_{0}({2}) }}\n    }}\n",
                    operation.c, parameters, arguments, real);
  }
  if (functions.empty()) return {};
  return "/// The mathematical library of C.\nmod libm {\n    #[link(name = \"m\")]\n    extern \"C\" {\n" +
         declarations + "    }\n" + functions + "}\n\n";
}

} // namespace

std::string rust_begin(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::string text = "#![allow(dead_code, non_snake_case, non_upper_case_globals, unused_assignments, unused_parens)]\n"
                     "#![allow(clippy::all)]\n\n";
  text += size(emission, "input_count", graph.input_count());
  text += size(emission, "parameter_count", graph.parameter_count());
  text += size(emission, "constant_count", emission.plan.constant_count);
  text += size(emission, "output_count", graph.output_count());
  if (!graph.guards.empty()) text += size(emission, "guard_count", graph.guards.size());
  text += "\n" + places(emission, "input", graph.inputs) + places(emission, "parameter", graph.parameters) +
          places(emission, "output", graph.outputs);
  text += matrices(emission) + frozen_remark(emission);
  if (!graph.guards.empty()) text += guard_remark(emission) + "\n";
  return text + library(emission);
}

namespace {

// The functions of integer_functions.def in Rust, in the same order.
struct RustFunction {
  std::string_view name, head, body;
  bool calls_wide_int = false;
};
constexpr std::array functions = {
    RustFunction{"to_int32", "(x: $real) -> $real",
                 "if x > -2147483649.0 && x < 2147483648.0 { x as i32 as $real } else { -2147483648.0 }"},
    RustFunction{"to_int64", "(x: $real) -> $real",
                 "if x >= -9223372036854775808.0 && x < 9223372036854775808.0 { x as i64 as $real } else { "
                 "-9223372036854775808.0 }"},
    RustFunction{"wide_int", "(x: $real) -> u64",
                 "if x >= -9223372036854775808.0 && x < 9223372036854775808.0 { x as i64 as u64 } else { 1 << 63 }"},
    RustFunction{
        "wide_uint", "(x: $real) -> u64",
        "if x >= 9223372036854775808.0 { wide_int(x - 9223372036854775808.0) ^ (1 << 63) } else { wide_int(x) }", true},
    RustFunction{"wide", "(high: $real, low: $real) -> u64", "(wide_int(high) << 32) | (wide_int(low) & 0xFFFF_FFFF)",
                 true},
    RustFunction{"int_div", "(x: $real, y: $real) -> $real", "(x / y).trunc() + 0.0"},
    RustFunction{"int_neg", "(x: $real) -> $real", "if x == 0.0 { 0.0 } else { -x }"},
    RustFunction{"mul_uint32", "(x: $real, y: $real) -> $real",
                 "f64::from((wide_int(x) as u32).wrapping_mul(wide_int(y) as u32))", true},
    RustFunction{"wide_div", "(x: u64, y: u64) -> u64",
                 "if y == 0 { 0 } else { (x as i64).wrapping_div(y as i64) as u64 }"},
    RustFunction{"wide_rem", "(x: u64, y: u64) -> u64",
                 "if y == 0 { 0 } else { (x as i64).wrapping_rem(y as i64) as u64 }"},
    RustFunction{"wide_udiv", "(x: u64, y: u64) -> u64", "if y == 0 { 0 } else { x / y }"},
    RustFunction{"wide_urem", "(x: u64, y: u64) -> u64", "if y == 0 { 0 } else { x % y }"},
    RustFunction{"wide_and", "(x: u64, y: u64) -> u64", "x & y"},
    RustFunction{"wide_or", "(x: u64, y: u64) -> u64", "x | y"},
    RustFunction{"wide_xor", "(x: u64, y: u64) -> u64", "x ^ y"},
    RustFunction{"wide_shl", "(x: u64, n: u64) -> u64", "x << (n & 63)"},
    RustFunction{"wide_shr", "(x: u64, n: u64) -> u64", "((x as i64) >> (n & 63)) as u64"},
    RustFunction{"wide_ushr", "(x: u64, n: u64) -> u64", "x >> (n & 63)"},
    RustFunction{"wide_less", "(x: u64, y: u64) -> bool", "(x as i64) < (y as i64)"},
};

constexpr std::array names = {
#define INTEGER_FUNCTION(type, name, parameters, ...) std::string_view(#name),
#include <symreal/integer_functions.def>
#undef INTEGER_FUNCTION
};
constexpr bool are_complete() {
  if (names.size() != functions.size()) return false;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] != functions[k].name) return false;
  return true;
}
static_assert(are_complete());

} // namespace

std::string rust_integer_functions(Emission const &emission) {
  std::set<std::string_view> wanted = emission.uses.integer_functions;
  for (RustFunction const &function : functions)
    if (function.calls_wide_int && wanted.contains(function.name)) wanted.insert("wide_int");
  std::string text;
  for (RustFunction const &function : functions)
    if (wanted.contains(function.name))
      text += with_words(emission.language, fmt::format("#[inline]\nfn {}{} {{\n    {}\n}}\n", function.name,
                                                        function.head, function.body));
  return text.empty() ? text : "// Integers, as gcc has them on x86-64.\n" + text + "\n";
}

namespace {

std::string array(std::string const &name, std::string_view type, std::vector<std::string> const &values) {
  std::string list;
  for (std::string const &value : values) list += (list.empty() ? "" : ", ") + value;
  return fmt::format("    let {}: [{}; {}] = [{}];\n", name, type, values.size(), list);
}

} // namespace

std::string rust_end(Emission const &emission) {
  Graph const &graph = emission.graph();
  if (graph.guards.empty()) return {};
  std::string list;
  for (Guard const &guard : graph.guards) {
    list += "        " + in_quotes(printable(guard_text(graph, guard))) + ",\n";
  }
  return fmt::format(
      "\n/// The condition of a guard and its places in the source.\npub fn {0}(guard: i32) -> &'static str {{\n"
      "    const TEXT: [&str; {1}] = [\n{2}    ];\n"
      "    if guard > 0 && guard <= {1} {{ TEXT[guard as usize - 1] }} else {{ \"\" }}\n}}\n",
      emission.name("guard_text"), graph.guards.size(), list);
}

std::string rust_mainline(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::string const real(emission.language.number.name);
  bool const is_single = emission.language.is_single;
  char const *const read = is_single ? "strtof" : "strtod";
  std::vector<std::string> labels = output_names(emission);
  for (std::string &label : labels) label = '"' + escaped(label) + "\\0\"";
  std::string const guards = graph.guards.empty()
                                 ? "    kernel::" + emission.name("compute") + "(&input, &constants, &mut output);\n"
                                 : fmt::format("    let guard = kernel::{}(&input, &constants, &mut output);\n"
                                               "    if guard != 0 {{\n"
                                               "        eprintln!(\"guard {{}} does not hold: {{}}\", guard, "
                                               "kernel::{}(guard));\n"
                                               "        std::process::exit(1);\n    }}\n",
                                               emission.name("compute"), emission.name("guard_text"));
  return banner(emission) +
         fmt::format(
             "#[path = \"{0}.rs\"]\nmod kernel;\n\n"
             "extern \"C\" {{\n    fn printf(format: *const u8, ...) -> i32;\n    fn fflush(file: *mut u8) -> i32;\n"
             "    fn {1}(text: *const u8, end: *mut u8) -> {2};\n}}\n\n"
             "// Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then\n"
             "// the parameters.\nfn main() {{\n",
             emission.options.base_name, read, real) +
         array("mut input", real, constants(emission.language, graph.input_values)) +
         array("mut parameters", real, constants(emission.language, graph.parameter_values)) +
         array("name", "&str", labels) +
         fmt::format("    let mut constants = [0.0_{3}; {0}];\n    let mut output = [0.0_{3}; {1}];\n"
                     "    for (i, argument) in std::env::args().skip(1).enumerate() {{\n"
                     "        let value = unsafe {{ {4}((argument + \"\\0\").as_ptr(), std::ptr::null_mut()) }};\n"
                     "        if i < input.len() {{\n            input[i] = value;\n"
                     "        }} else if i < input.len() + parameters.len() {{\n"
                     "            parameters[i - input.len()] = value;\n        }}\n    }}\n"
                     "    kernel::{2}(&parameters, &mut constants);\n",
                     emission.plan.constant_count, graph.output_count(), emission.name("preprocess"), real, read) +
         guards + "    for i in 0..output.len() {\n" +
         fmt::format("        unsafe {{ printf(\"%s = %.{}g\\n\\0\".as_ptr(), name[i].as_ptr(), {}) }};\n    }}\n",
                     is_single ? 9 : 17, is_single ? "f64::from(output[i])" : "output[i]") +
         "    unsafe { fflush(std::ptr::null_mut()) };\n}\n";
}

} // namespace symreal
