#include "program/wrapper/wrapper_text.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/mutation/is_dropped.h"
#include "engine/support/text.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace symreal::program {

std::string once(std::string const &macro, std::string const &text) {
  return fmt::format("#ifndef {0}\n#define {0}\n{1}#endif\n", macro, text);
}

bool is_c(rewrite::Kernel const &kernel) { return kernel.source.ends_with(".c"); }
namespace {

// Do templates walk the elements behind the sections? Not in C, which has only arrays there, nor if members have names.
bool is_walked(rewrite::Kernel const &kernel, rewrite::Annotation const &annotation, Object const &object) {
  return !is_c(kernel) && object.members.empty() && object.extents.size() > annotation.sections.size();
}

// An object or member: an lvalue in the source, and the slot of its first number in the flat array.
struct Lvalue {
  std::string element, slot;
  std::vector<std::size_t> extents;
  std::vector<Member> const &members;
  std::size_t inner = 1; // numbers that one statement walks by itself
};

// Loops over a part's numbers, around a statement on an `element` and its `slot`. `depth`: number of enclosing loops.
template <class Statement> std::string for_elements(Lvalue part, std::vector<rewrite::Section> const &sections,
                                                    Statement const &statement, std::string indent = "  ",
                                                    std::size_t depth = 0) {
  std::string text, at;
  for (std::size_t dimension = 0; dimension < part.extents.size(); ++dimension) {
    std::string index = fmt::format("symreal_{}", depth++);
    text += fmt::format("{0}for (int {1} = 0; {1} < {2}; ++{1})\n", indent, index, part.extents[dimension]);
    indent += "  ";
    bool section = dimension < sections.size();
    part.element += section ? fmt::format("[({}) + {}]", sections[dimension].low, index) : "[" + index + "]";
    at = at.empty() ? index : fmt::format("({}) * {} + {}", at, part.extents[dimension], index);
  }
  std::size_t const each = number_count({}, part.members) * part.inner;
  if (each != 1 && !at.empty()) at = fmt::format("({}) * {}", at, each);
  if (!at.empty()) part.slot += " + " + at;
  if (part.members.empty()) return text + indent + statement(part.element, part.slot) + "\n";
  if (!part.extents.empty()) text.back() = ' ', text += "{\n";
  std::size_t first = 0;
  for (Member const &member : part.members) {
    std::string const slot = first == 0 ? part.slot : fmt::format("{} + {}", part.slot, first);
    text += for_elements({part.element + "." + member.name, slot, member.extents, member.members}, {}, statement,
                         indent, depth);
    first += number_count(member.extents, member.members);
  }
  if (!part.extents.empty()) text += indent.substr(2) + "}\n";
  return text;
}

// Loops over the first dimensions of an object.
template <class Statement> std::string for_elements(rewrite::Annotation const &annotation, Object const &object,
                                                    std::size_t dimensions, Statement const &statement) {
  auto const inner = object.extents.begin() + static_cast<std::ptrdiff_t>(dimensions);
  std::size_t const walked = number_count({inner, object.extents.end()}, {});
  return for_elements({"(" + annotation.expression + ")",
                       std::to_string(object.first),
                       {object.extents.begin(), inner},
                       object.members,
                       walked},
                      annotation.sections, statement);
}

// Annotation of an object of the graph, whose order may differ from the pragma's: a returned value comes first.
rewrite::Annotation const &annotation_of(rewrite::Kernel const &kernel, std::string_view kind, Object const &object) {
  auto found = std::find_if(kernel.annotations.begin(), kernel.annotations.end(), [&](auto const &annotation) {
    return annotation.kind == kind && annotation.label == object.label;
  });
  internal_check(found != kernel.annotations.end());
  return *found;
}

template <class Visit> void for_objects(rewrite::Kernel const &kernel, Graph const &graph, Visit visit) {
  for (Object const &object : graph.inputs) visit(annotation_of(kernel, "input", object), object);
  for (Object const &object : graph.parameters) visit(annotation_of(kernel, "parameter", object), object);
  for (Object const &object : graph.outputs) {
    rewrite::Annotation const &annotation = annotation_of(kernel, "output", object);
    if (annotation.expression != "return") visit(annotation, object);
  }
}

bool names_any(std::string const &text, std::vector<std::string> const &names) {
  auto const is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && is_word(text[end])) ++end;
    if (std::find(names.begin(), names.end(), text.substr(begin, end - begin)) != names.end()) return true;
    begin = std::max(end, begin + 1);
  }
  return false;
}

// Templates that visit an object's numbers, row by row, in the order of symreal/annotate.h. Names begin with symreal_,
// since macros of the program are expanded here.
constexpr char const *templates = R"(namespace {
template <int symreal_n> struct symreal_choice : symreal_choice<symreal_n - 1> {};
template <> struct symreal_choice<0> {};
template <class symreal_T> struct symreal_number {
  typedef double symreal_type;
};
template <class symreal_T> struct symreal_number<symreal_T const> {
  typedef double const symreal_type;
};
template <class symreal_T, class symreal_Visit>
void symreal_each(symreal_T &&symreal_object, symreal_Visit &symreal_visit);
template <class symreal_Visit>
void symreal_look(double &symreal_number, symreal_Visit &symreal_visit, symreal_choice<4>) {
  symreal_visit(symreal_number);
}
template <class symreal_Visit>
void symreal_look(double const &symreal_number, symreal_Visit &symreal_visit, symreal_choice<4>) {
  symreal_visit(symreal_number);
}
template <class symreal_T, __SIZE_TYPE__ symreal_n, class symreal_Visit>
void symreal_look(symreal_T (&symreal_array)[symreal_n], symreal_Visit &symreal_visit, symreal_choice<3>) {
  for (__SIZE_TYPE__ symreal_i = 0; symreal_i < symreal_n; ++symreal_i)
    symreal_each(symreal_array[symreal_i], symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_look(symreal_T &symreal_object, symreal_Visit &symreal_visit, symreal_choice<2>)
    -> decltype(symreal_object.rows(), symreal_object.cols(), static_cast<void>(symreal_object(0, 0))) {
  for (decltype(symreal_object.rows() + 0) symreal_i = 0; symreal_i < symreal_object.rows(); ++symreal_i)
    for (decltype(symreal_object.cols() + 0) symreal_j = 0; symreal_j < symreal_object.cols(); ++symreal_j)
      symreal_each(symreal_object(symreal_i, symreal_j), symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_look(symreal_T &symreal_object, symreal_Visit &symreal_visit, symreal_choice<1>)
    -> decltype(symreal_object.size(), static_cast<void>(symreal_object[0])) {
  for (decltype(symreal_object.size() + 0) symreal_i = 0; symreal_i < symreal_object.size(); ++symreal_i)
    symreal_each(symreal_object[symreal_i], symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_look(symreal_T &symreal_object, symreal_Visit &symreal_visit, symreal_choice<0>)
    -> decltype(symreal_object.real(), static_cast<void>(symreal_object.imag())) {
  for (int symreal_part = 0; symreal_part < 2; ++symreal_part)
    symreal_each(reinterpret_cast<typename symreal_number<symreal_T>::symreal_type *>(&symreal_object)[symreal_part],
                 symreal_visit);
}
template <class symreal_T, class symreal_Visit>
void symreal_each(symreal_T &&symreal_object, symreal_Visit &symreal_visit) {
  symreal_look(symreal_object, symreal_visit, symreal_choice<4>());
}
struct symreal_counter {
  __SIZE_TYPE__ symreal_count;
  void operator()(double const &) { ++symreal_count; }
};
struct symreal_reader {
  double *symreal_at;
  void operator()(double const &symreal_number) { *symreal_at++ = symreal_number; }
};
struct symreal_writer {
  double const *symreal_at;
  void operator()(double &symreal_number) { symreal_number = *symreal_at++; }
};
template <class symreal_T> inline __SIZE_TYPE__ symreal_count(symreal_T &symreal_object) {
  symreal_counter symreal_counter = {0};
  symreal_each(symreal_object, symreal_counter);
  return symreal_counter.symreal_count;
}
template <class symreal_T> inline void symreal_pack(symreal_T &symreal_object, double *symreal_at) {
  symreal_reader symreal_reader = {symreal_at};
  symreal_each(symreal_object, symreal_reader);
}
template <class symreal_T> inline void symreal_unpack(symreal_T &symreal_object, double const *symreal_at) {
  symreal_writer symreal_writer = {symreal_at};
  symreal_each(symreal_object, symreal_writer);
}
}
)";

// Templates that resize an object to its recorded size and fill it, in the same order.
constexpr char const *fill_templates = R"(namespace {
template <class symreal_T>
void symreal_size(symreal_T &symreal_object, __SIZE_TYPE__ symreal_rows, __SIZE_TYPE__ symreal_columns);
template <class symreal_T>
auto symreal_resize(symreal_T &symreal_object, __SIZE_TYPE__ symreal_rows, __SIZE_TYPE__ symreal_columns, symreal_choice<2>)
    -> decltype(static_cast<void>(symreal_T::RowsAtCompileTime), symreal_object.resize(1, 1)) {
  bool const symreal_is_row = symreal_T::RowsAtCompileTime == 1;
  bool const symreal_is_known = symreal_T::RowsAtCompileTime >= 0 || symreal_T::ColsAtCompileTime >= 0;
  if (symreal_columns == 0 && !symreal_is_known) __builtin_trap();
  if (symreal_columns == 0)
    symreal_object.resize(symreal_is_row ? 1 : static_cast<int>(symreal_rows), symreal_is_row ? static_cast<int>(symreal_rows) : 1);
  else
    symreal_object.resize(static_cast<int>(symreal_rows), static_cast<int>(symreal_columns));
}
template <class symreal_T>
auto symreal_resize(symreal_T &symreal_object, __SIZE_TYPE__ symreal_rows, __SIZE_TYPE__ symreal_columns, symreal_choice<1>)
    -> decltype(symreal_object.resize(symreal_rows), static_cast<void>(symreal_object[0])) {
  symreal_object.resize(symreal_rows);
  if (symreal_columns != 0)
    for (__SIZE_TYPE__ symreal_i = 0; symreal_i < symreal_rows; ++symreal_i)
      symreal_size(symreal_object[symreal_i], symreal_columns, 0);
}
template <class symreal_T>
void symreal_resize(symreal_T &, __SIZE_TYPE__, __SIZE_TYPE__, symreal_choice<0>) {}
template <class symreal_T>
void symreal_size(symreal_T &symreal_object, __SIZE_TYPE__ symreal_rows, __SIZE_TYPE__ symreal_columns) {
  symreal_resize(symreal_object, symreal_rows, symreal_columns, symreal_choice<2>());
}
template <class symreal_T>
inline void symreal_fill(symreal_T &symreal_object, double const *symreal_at, __SIZE_TYPE__ symreal_numbers,
                         __SIZE_TYPE__ symreal_rows, __SIZE_TYPE__ symreal_columns) {
  symreal_size(symreal_object, symreal_rows, symreal_columns);
  if (symreal_count(symreal_object) != symreal_numbers) __builtin_trap();
  symreal_unpack(symreal_object, symreal_at);
}
template <class symreal_T> union symreal_room {
  char symreal_none;
  symreal_T symreal_object;
  symreal_room() : symreal_none(0) {}
  ~symreal_room() {}
};
}
)";

using Form = rewrite::ReturnedObject::Form;

std::string fill(std::string const &element, std::vector<std::size_t> const &extents, std::size_t slot) {
  return fmt::format("symreal_fill({}, symreal_output + {}, {}, {}, {});", element, slot, number_count(extents, {}),
                     extents.empty() ? 1 : extents[0], extents.size() > 1 ? extents[1] : 0);
}

// Fills members of a structure; in C++ one may be a container.
std::string fill_members(std::string const &element, std::vector<Member> const &members, std::size_t slot) {
  std::string text;
  for (Member const &member : members) {
    std::string const path = element + "." + member.name;
    std::size_t const count = number_count(member.extents, member.members);
    if (member.extents.empty() && member.members.empty())
      text += fmt::format("  {} = symreal_output[{}];\n", path, slot);
    else if (member.members.empty())
      text += "  " + fill(path, member.extents, slot) + "\n";
    else {
      std::size_t const each = number_count({}, member.members);
      std::size_t const elements = number_count(member.extents, {});
      if (!member.extents.empty())
        text += fmt::format("  symreal_size({}, {}, {});\n", path, member.extents[0],
                            member.extents.size() > 1 ? member.extents[1] : 0);
      for (std::size_t k = 0; k < elements; ++k) {
        std::string at;
        std::size_t rest = k;
        for (std::size_t d = member.extents.size(); d-- > 0; rest /= member.extents[d])
          at.insert(0, fmt::format("[{}]", rest % member.extents[d]));
        text += fill_members(path + at, member.members, slot + k * each);
      }
    }
    slot += count;
  }
  return text;
}

// Adds the offsets of a structure's numbers, by its layout (symreal/object_layout.h). Returns its size.
std::size_t add_offsets(std::string_view &layout, std::size_t begin, std::vector<std::size_t> &offsets,
                        bool &is_plain) {
  auto const take_number = [&layout] {
    std::size_t value = 0;
    for (; !layout.empty() && std::isdigit(static_cast<unsigned char>(layout.front())); layout.remove_prefix(1))
      value = value * 10 + static_cast<std::size_t>(layout.front() - '0');
    return value;
  };
  if (layout.starts_with('[')) {
    layout.remove_prefix(1);
    std::size_t const count = take_number();
    layout.remove_prefix(1);
    std::vector<std::size_t> one;
    std::size_t const size = add_offsets(layout, 0, one, is_plain);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t const offset : one) offsets.push_back(begin + k * size + offset);
    return count * size;
  }
  char const kind = layout.front();
  layout.remove_prefix(1);
  if (kind == 'd') return offsets.push_back(begin), sizeof(double);
  if (kind == '{') {
    while (!layout.starts_with('}')) {
      layout.remove_prefix(layout.find('+') + 1);
      std::size_t const offset = take_number();
      layout.remove_prefix(1);
      (void)add_offsets(layout, begin + offset, offsets, is_plain);
      layout.remove_prefix(1);
    }
    layout.remove_prefix(1);
    return take_number();
  }
  is_plain = is_plain && kind != '@';
  std::size_t const size = take_number();
  if (kind == '@') layout = {};
  return size;
}

// Constructs the returned object, symreal_result, of the function's own type; `value` is the expression to return.
std::string make_returned(rewrite::Kernel const &kernel, rewrite::Annotation const &annotation, Object const &object,
                          std::string &value) {
  rewrite::ReturnedObject const &result = kernel.signature.redefinition.result;
  if (!result.obstacle.empty() && !is_dropped("SYM095"))
    fail(DiagnosticId::no_wrapper, kernel.place,
         fmt::format("--wrapper cannot take the place of '{}': {}", kernel.name, result.obstacle));
  value = fmt::format("symreal_output[{}]", object.first);
  if (result.form == Form::integer) value = fmt::format("({}){}", result.type, value);
  Form form = result.form;
  if (form == Form::number && !object.members.empty()) form = Form::members; // a template's return type
  if (form == Form::number && !object.extents.empty()) form = Form::walked;
  if (form == Form::number || form == Form::integer) return "";
  value = "symreal_result";
  if (form == Form::walked)
    return fmt::format("  {} symreal_result;\n  {}\n", result.type,
                       fill("symreal_result", object.extents, object.first));
  if (is_c(kernel))
    return fmt::format("  {} symreal_result;\n", result.type) +
           for_elements({"symreal_result", std::to_string(object.first), {}, object.members}, {},
                        [](auto const &element, auto const &slot) {
                          return fmt::format("{} = symreal_output[{}];", element, slot);
                        });
  if (form == Form::members)
    return fmt::format("  {} symreal_result;\n", result.type) +
           fill_members("symreal_result", object.members, object.first);
  std::vector<std::size_t> offsets;
  bool is_plain = !annotation.layout.text.empty();
  std::string_view layout = annotation.layout.text;
  if (is_plain) (void)add_offsets(layout, 0, offsets, is_plain);
  if (!is_plain || offsets.size() != object.count)
    fail(DiagnosticId::no_wrapper, kernel.place,
         fmt::format("--wrapper cannot take the place of '{}': what it returns has private containers", kernel.name));
  std::string text = fmt::format("  symreal_room<{}> symreal_result;\n", result.type);
  for (std::size_t k = 0; k < offsets.size(); ++k)
    text += fmt::format("  __builtin_memcpy((char *)&symreal_result + {}, symreal_output + {}, sizeof(double));\n",
                        offsets[k], object.first + k);
  value = "symreal_result.symreal_object";
  return text;
}

} // namespace

std::string refusal_of(std::string const &label) { return "symreal_refuse(" + in_quotes(label) + ");"; }

std::string wrapper_arrays(Graph const &graph) {
  auto const array = [](std::string_view name, std::size_t count) {
    return fmt::format("  double symreal_{}[{}];\n", name, std::max<std::size_t>(count, 1));
  };
  return array("input", graph.input_count()) +
         (graph.parameter_count() == 0 ? "" : array("parameters", graph.parameter_count())) +
         array("output", graph.output_count());
}

std::string wrapper_pack(rewrite::Kernel const &kernel, std::string_view kind, std::vector<Object> const &objects,
                         std::string_view array) {
  std::string text;
  for (Object const &object : objects) {
    rewrite::Annotation const &annotation = annotation_of(kernel, kind, object);
    bool const walked = is_walked(kernel, annotation, object);
    text += for_elements(annotation, object, walked ? annotation.sections.size() : object.extents.size(),
                         [&](auto const &element, auto const &slot) {
                           return walked ? fmt::format("symreal_pack({}, {} + {});", element, array, slot)
                                         : fmt::format("{}[{}] = {};", array, slot, element);
                         });
  }
  return text;
}

std::string wrapper_unpack(rewrite::Kernel const &kernel, std::vector<Object> const &objects,
                           ReturnStatement const &returned) {
  std::string text, last;
  for (Object const &object : objects) {
    rewrite::Annotation const &annotation = annotation_of(kernel, "output", object);
    if (annotation.expression == "return") {
      std::string value;
      last = make_returned(kernel, annotation, object, value);
      last += "  " + returned(value) + "\n";
    } else {
      bool const walked = is_walked(kernel, annotation, object);
      text += for_elements(annotation, object, walked ? annotation.sections.size() : object.extents.size(),
                           [walked](auto const &element, auto const &slot) {
                             return walked ? fmt::format("symreal_unpack({}, symreal_output + {});", element, slot)
                                           : fmt::format("{} = symreal_output[{}];", element, slot);
                           });
    }
  }
  return text + last;
}

std::vector<ExtentCheck> wrapper_extents(rewrite::Kernel const &kernel, Graph const &graph) {
  std::vector<ExtentCheck> checks;
  if (is_dropped("extents")) return checks;
  auto const add = [&](std::string differs, std::string const &label) {
    bool const is_known =
        std::any_of(checks.begin(), checks.end(), [&](ExtentCheck const &one) { return one.differs == differs; });
    if (!is_known) checks.push_back({std::move(differs), label});
  };
  for_objects(kernel, graph, [&](rewrite::Annotation const &annotation, Object const &object) {
    for (std::size_t k = 0; k < annotation.sections.size(); ++k)
      if (names_any(annotation.sections[k].length, kernel.signature.redefinition.varying))
        add(fmt::format("({}) != {}", annotation.sections[k].length, object.extents[k]), annotation.label);
    if (annotation.sections.empty() && is_walked(kernel, annotation, object))
      add(fmt::format("symreal_count({}) != {}", annotation.expression, object.count), annotation.label);
  });
  return checks;
}

std::string wrapper_place(rewrite::Kernel const &kernel, Graph const &graph, std::string const &label, bool in_rows) {
  std::string text;
  for_objects(kernel, graph, [&](rewrite::Annotation const &annotation, Object const &object) {
    if (!text.empty() || annotation.label != label || object.count == 0) return;
    bool const walked = is_walked(kernel, annotation, object);
    std::string first = "(" + annotation.expression + ")", last = first;
    for (std::size_t k = 0; k < (walked ? annotation.sections.size() : object.extents.size()); ++k) {
      std::string const low = k < annotation.sections.size() ? "(" + annotation.sections[k].low + ") + " : "";
      bool const is_one_row = in_rows && k + 1 < annotation.sections.size();
      first += fmt::format("[{}0]", low);
      last += fmt::format("[{}{}]", low, is_one_row ? 0 : object.extents[k] - 1);
    }
    text = is_c(kernel) ? fmt::format("&{}, &{} + 1", first, last)
                        : fmt::format("symreal_low({}), symreal_high({})", first, last);
  });
  return text;
}

std::vector<std::string> wrapper_containers(rewrite::Kernel const &kernel, Graph const &graph) {
  std::vector<std::string> found;
  for_objects(kernel, graph, [&](rewrite::Annotation const &annotation, Object const &object) {
    bool const is_known = std::ranges::find(found, annotation.expression) != found.end();
    if (!is_known && annotation.sections.empty() && is_walked(kernel, annotation, object))
      found.push_back(annotation.expression);
  });
  return found;
}

std::vector<std::string> wrapper_templates(rewrite::Kernel const &kernel, Graph const &graph) {
  bool is_used = false;
  for_objects(kernel, graph, [&](rewrite::Annotation const &annotation, Object const &object) {
    is_used |= is_walked(kernel, annotation, object);
  });
  bool const makes_object = !is_c(kernel) && std::ranges::any_of(graph.outputs, [&](Object const &object) {
    return annotation_of(kernel, "output", object).expression == "return" &&
           (!object.extents.empty() || !object.members.empty());
  });
  if (makes_object) return {templates, fill_templates};
  return is_used ? std::vector<std::string>{templates} : std::vector<std::string>();
}

} // namespace symreal::program
