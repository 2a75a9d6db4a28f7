#include "engine/emit/c/parts.h"
#include "engine/graph/external.h"
#include "engine/graph/graph.h"
#include "engine/graph/implicit.h"

#include <fmt/format.h>
#include <set>

namespace symreal {

namespace {

using Kind = ExternalValue::Kind;

std::string type_of(ExternalValue const &value) {
  switch (value.kind) {
  case Kind::none: return "void";
  case Kind::number: return "double";
  case Kind::integer: return value.type;
  case Kind::input: return "double const *";
  case Kind::output:
  case Kind::updated: return "double *";
  case Kind::object: break;
  }
  return fmt::format("struct numbers_{}", value.count);
}

std::string prototype(External const &external) {
  std::string parameters;
  for (ExternalValue const &parameter : external.parameters)
    parameters += (parameters.empty() ? "" : ", ") + type_of(parameter);
  return fmt::format("{} {}({});\n", type_of(external.returned), external.name,
                     parameters.empty() ? "void" : parameters);
}

// Wrappers of complex functions. Building a number from its parts by arithmetic would change infinities and zeros;
// <complex.h> is avoided, since its macros clash with names of programs.
std::string complex_definitions(Graph const &graph, std::set<std::size_t> const &functions) {
  std::string declarations, definitions;
  for (std::size_t number : functions) {
    std::optional<ComplexFunction> const function = find_complex_function(graph.externals[number]);
    if (!function) continue;
    auto const [name, arity, is_infix, c, has_cut] = info(*function);
    bool const binary = arity == 2;
    std::string const call = is_infix ? fmt::format("x.number {} y.number", c)
                                      : fmt::format("{}(x.number{})", c, binary ? ", y.number" : "");
    if (!is_infix)
      declarations += fmt::format("double _Complex {}(double _Complex{});\n", c, binary ? ", double _Complex" : "");
    definitions += fmt::format("static void {0}(double a, double b, {1}double *result) {{\n"
                               "  union complex_number const x = {{{{a, b}}}}{2};\n"
                               "  union complex_number z;\n"
                               "  z.number = {3};\n"
                               "  result[0] = z.part[0];\n"
                               "  result[1] = z.part[1];\n}}\n",
                               name, binary ? "double c, double d, " : "", binary ? ", y = {{c, d}}" : "", call);
  }
  if (definitions.empty()) return {};
  return "/* Functions of complex numbers, of the C library and the compiler. */\n"
         "union complex_number {\n  double part[2];\n  double _Complex number;\n};\n" +
         declarations + definitions;
}

std::string prototypes(Graph const &graph, std::set<std::size_t> const &functions) {
  std::set<std::uint32_t> objects;
  std::set<std::string> declared; // one function may take arrays of several sizes
  std::string text;
  for (std::size_t number : functions) {
    External const &external = graph.externals[number];
    if (find_complex_function(external) || is_implicit(external)) continue;
    for (ExternalValue const &parameter : external.parameters)
      if (parameter.kind == Kind::object) objects.insert(parameter.count);
    if (external.returned.kind == Kind::object) objects.insert(external.returned.count);
    if (std::string const line = prototype(external); declared.insert(line).second) text += line;
  }
  std::string structs;
  for (std::uint32_t count : objects) structs += fmt::format("struct numbers_{0} {{\n  double m[{0}];\n}};\n", count);
  if (!text.empty())
    text = "/* Functions of the program's libraries, with structs as what they consist of. */\n" + structs + text;
  std::string const complex = complex_definitions(graph, functions);
  return text + (text.empty() || complex.empty() ? "" : "\n") + complex;
}

std::string as_integer(std::string const &type, std::string const &argument) {
  bool const is_literal = argument.find_first_not_of("-0123456789") == std::string::npos;
  return is_literal ? argument : "(" + type + ")(" + argument + ")";
}

} // namespace

std::string c_external_declarations(Emission const &emission) {
  std::string const text = prototypes(emission.graph(), emission.uses.externals);
  return text.empty() ? text : text + "\n";
}

std::vector<std::string> c_call(ExternalCall const &call) {
  auto const &[external, label, arguments, array, first, is_wanted] = call;
  std::vector<std::string> statements;
  std::size_t argument = 0, result = first;
  std::string passed;
  auto list = [&](std::uint32_t count) {
    std::string text;
    for (std::uint32_t k = 0; k < count; ++k) text += (k == 0 ? "" : ", ") + arguments[argument++];
    return text;
  };
  auto element = [&](std::size_t at) { return fmt::format("{}[{}]", array, at); };
  if (external.returned.kind != Kind::none) result += external.returned.count;
  for (std::size_t p = 0; p < external.parameters.size(); ++p) {
    ExternalValue const &parameter = external.parameters[p];
    if (p > 0) passed += ", ";
    std::string const name = fmt::format("a{}_{}", label, p);
    switch (parameter.kind) {
    case Kind::none: break;
    case Kind::number: passed += list(1); break;
    case Kind::integer: passed += as_integer(parameter.type, list(1)); break;
    case Kind::input:
      statements.push_back(fmt::format("double const {}[{}] = {{{}}};", name, parameter.count, list(parameter.count)));
      passed += name;
      break;
    case Kind::object:
      statements.push_back(
          fmt::format("struct numbers_{0} const {1} = {{{{{2}}}}};", parameter.count, name, list(parameter.count)));
      passed += name;
      break;
    case Kind::updated:
      for (std::uint32_t k = 0; k < parameter.count; ++k)
        statements.push_back(fmt::format("{} = {};", element(result + k), arguments[argument++]));
      [[fallthrough]];
    case Kind::output:
      passed += "&" + element(result);
      result += parameter.count;
      break;
    }
  }
  std::string const made = fmt::format("{}({});", external.name, passed);
  if (external.returned.kind == Kind::none)
    statements.push_back(made);
  else if (!is_wanted)
    statements.push_back("(void)" + made);
  else if (external.returned.kind == Kind::object) {
    statements.push_back(fmt::format("struct numbers_{} const s{} = {}", external.returned.count, label, made));
    for (std::uint32_t k = 0; k < external.returned.count; ++k)
      statements.push_back(fmt::format("{} = s{}.m[{}];", element(first + k), label, k));
  } else
    statements.push_back(
        fmt::format("{} = {}{}", element(first), external.returned.kind == Kind::integer ? "(double)" : "", made));
  return statements;
}

std::string c_external_calls(Graph const &graph) {
  std::set<std::size_t> all;
  for (std::size_t number = 0; number < graph.externals.size(); ++number)
    if (!is_implicit(graph.externals[number])) all.insert(number);
  std::string text = prototypes(graph, all);
  for (std::size_t number : all) {
    External const &external = graph.externals[number];
    std::vector<std::string> arguments;
    for (std::size_t k = 0; k < external.argument_count(); ++k) arguments.push_back(fmt::format("argument[{}]", k));
    text += fmt::format("void symreal_call_{}(double const *argument, double *result) {{\n", number);
    for (std::string const &statement : c_call({external, "", std::move(arguments), "result"}))
      text += "  " + statement + "\n";
    text += "  (void)argument;\n  (void)result;\n}\n";
  }
  return text;
}

} // namespace symreal
