#include "emit/print/integers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string_view>

namespace symreal {

namespace {

constexpr std::string_view keep = "keep_integer", kept = "kept_integer";

struct Function {
  std::string_view type, name, parameters, body;
};

constexpr std::array functions = {
#define INTEGER_FUNCTION(type, name, parameters, ...) Function{#type, #name, #parameters, #__VA_ARGS__},
#include <symreal/integer_functions.def>
#undef INTEGER_FUNCTION
};

bool is_integer_type_used(OperationInfo const &operation) {
  return operation.form == Form::local || operation.has(flag::WIDE | flag::TAKES_WIDE) ||
         (operation.form == Form::cast && operation.c.find("int") != operation.c.npos);
}

// What a live node is spelled with.
template <class Test> bool any_live(Graph const &graph, Test test) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id] && !is_leaf(graph.nodes[id].op) && test(info(graph.nodes[id].op))) return true;
  return false;
}

// Integers that may stand in an array of doubles: those of 64 bits.
bool has_wide(Graph const &graph) {
  return any_live(graph, [](OperationInfo const &operation) { return operation.has(flag::WIDE); });
}

// Whether a text of C calls the function.
bool calls(std::string_view text, std::string_view function) {
  std::string const call = std::string(function) + "(";
  for (std::size_t at = text.find(call); at != text.npos; at = text.find(call, at + 1)) {
    char const before = at == 0 ? ' ' : text[at - 1];
    if (!std::isalnum(static_cast<unsigned char>(before)) && before != '_') return true;
  }
  return false;
}

// One statement a line.
std::string text_of(Function const &function) {
  std::string text = fmt::format("static {} {}{} {{\n", function.type, function.name, function.parameters);
  std::string_view body = function.body;
  while (!body.empty()) {
    std::size_t const end = body.find(';') + 1;
    text += fmt::format("  {}\n", body.substr(0, end));
    body.remove_prefix(std::min(body.size(), body.find_first_not_of(' ', end)));
  }
  return text + "}\n";
}

} // namespace

std::string c_integer_includes(Graph const &graph) {
  std::string text;
  if (any_live(graph, is_integer_type_used)) text += "#include <stdint.h>\n";
  if (has_wide(graph)) text += "#include <string.h>\n";
  return text;
}

std::string c_integer_functions(std::string const &printed) {
  std::array<bool, functions.size()> wanted{};
  for (std::size_t k = functions.size(); k-- > 0;) {
    wanted[k] = calls(printed, functions[k].name);
    for (std::size_t user = k + 1; user < functions.size(); ++user)
      wanted[k] = wanted[k] || (wanted[user] && calls(functions[user].body, functions[k].name));
  }
  std::string text;
  for (std::size_t k = 0; k < functions.size(); ++k)
    if (wanted[k]) text += text_of(functions[k]);
  if (calls(printed, keep))
    text += fmt::format("static void {}(double *element, uint64_t x) {{\n  memcpy(element, &x, sizeof x);\n}}\n", keep);
  if (calls(printed, kept))
    text +=
        fmt::format("static uint64_t {}(double const *element) {{\n  uint64_t x;\n  memcpy(&x, element, sizeof x);\n"
                    "  return x;\n}}\n",
                    kept);
  return text.empty() ? text : "/* Integers, as gcc has them on x86-64. */\n" + text + "\n";
}

std::string c_integer_constant(std::uint64_t value) {
  return value <= 0x7FFFFFFFu ? fmt::format("{}u", value) : fmt::format("UINT64_C({})", value);
}

std::string c_kept_integer(std::string const &element) { return fmt::format("{}(&{})", kept, element); }
std::string c_keep_integer(std::string const &element, std::string const &value) {
  return fmt::format("{}(&{}, {});", keep, element, value);
}

} // namespace symreal
