#include "program/wrapper/wrapped_original.h"

#include "program/wrapper/baked_values.h"
#include "program/wrapper/wrapper_text.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <set>

namespace symreal::program {
namespace {

constexpr int extents = 0, inner_extents = 1, element = 2; // change that symreal_vary makes to a container
constexpr int changes[] = {extents, inner_extents, element};

constexpr char const *variation_helpers = R"(namespace {
template <int symreal_n> struct symreal_turn : symreal_turn<symreal_n - 1> {};
template <> struct symreal_turn<0> {};
template <bool> struct symreal_when {};
template <> struct symreal_when<true> { typedef int symreal_type; };
template <class symreal_T> auto symreal_flip(symreal_T const &symreal_object, symreal_turn<1>)
    -> decltype(static_cast<void>(static_cast<unsigned long long>(symreal_object))) {
  bool const symreal_is_number = sizeof(symreal_T) > 2 && static_cast<double>(static_cast<symreal_T>(0.5)) != 0;
  reinterpret_cast<unsigned char *>(const_cast<symreal_T *>(&symreal_object))[symreal_is_number ? sizeof(symreal_T) - 2 : 0] ^= 1;
}
template <class symreal_T> void symreal_flip(symreal_T const &, symreal_turn<0>) {}
template <class symreal_T>
auto symreal_grow_or_shrink(symreal_T &symreal_object, symreal_turn<1>)
    -> decltype(symreal_object.push_back(symreal_object[0]), static_cast<void>(symreal_object[0].size())) {
  symreal_object.push_back(symreal_object[symreal_object.size() - 1]);
}
template <class symreal_T> void symreal_grow_or_shrink(symreal_T &symreal_object, symreal_turn<0>) { symreal_object.pop_back(); }
template <class symreal_T>
auto symreal_move(symreal_T &symreal_to, symreal_T &symreal_from, symreal_turn<1>)
    -> decltype(symreal_to.push_back(symreal_from[0]), symreal_from.pop_back()) {
  if (&symreal_to == &symreal_from || symreal_from.size() == 0) return;
  symreal_to.push_back(symreal_from[symreal_from.size() - 1]);
  symreal_from.pop_back();
}
template <class symreal_T> void symreal_move(symreal_T &, symreal_T &, symreal_turn<0>) {}
template <class symreal_T, typename symreal_when<symreal_T::SizeAtCompileTime == -1>::symreal_type = 0>
auto symreal_vary(symreal_T const &symreal_object, int symreal_what, symreal_turn<4>)
    -> decltype(const_cast<symreal_T &>(symreal_object).conservativeResize(1, 1), static_cast<void>(symreal_object.rows())) {
  symreal_T &symreal_other = const_cast<symreal_T &>(symreal_object);
  auto const symreal_rows = symreal_object.rows(), symreal_columns = symreal_object.cols();
  if (symreal_what == 1 && symreal_T::RowsAtCompileTime == -1 && symreal_T::ColsAtCompileTime == -1)
    symreal_other.resize(symreal_columns, symreal_rows);
  else if (symreal_what == 0 && symreal_T::RowsAtCompileTime == -1 && symreal_rows > 1)
    symreal_other.conservativeResize(symreal_rows - 1, symreal_columns);
  else if (symreal_what == 0 && symreal_T::ColsAtCompileTime == -1 && symreal_columns > 1)
    symreal_other.conservativeResize(symreal_rows, symreal_columns - 1);
  else if (symreal_what == 2 && symreal_object.size() != 0)
    symreal_flip(symreal_object(0, 0), symreal_turn<1>());
}
template <class symreal_T>
auto symreal_vary(symreal_T const &symreal_object, int symreal_what, symreal_turn<3>)
    -> decltype(const_cast<symreal_T &>(symreal_object).pop_back(), static_cast<void>(symreal_object[0]), static_cast<void>(symreal_object.size())) {
  if (symreal_object.size() == 0) return;
  symreal_T &symreal_other = const_cast<symreal_T &>(symreal_object);
  if (symreal_what == 0) symreal_grow_or_shrink(symreal_other, symreal_turn<1>());
  if (symreal_what == 1) symreal_move(symreal_other[0], symreal_other[symreal_other.size() - 1], symreal_turn<1>());
  if (symreal_what == 2) symreal_flip(symreal_object[0], symreal_turn<1>());
}
template <class symreal_T>
auto symreal_vary(symreal_T const &symreal_object, int symreal_what, symreal_turn<2>)
    -> decltype(static_cast<void>(const_cast<symreal_T &>(symreal_object) = symreal_object.first(1))) {
  if (symreal_what == 0 && symreal_object.size() != 0) const_cast<symreal_T &>(symreal_object) = symreal_object.first(symreal_object.size() - 1);
}
template <class symreal_T>
auto symreal_vary(symreal_T const &symreal_object, int symreal_what, symreal_turn<1>)
    -> decltype(const_cast<symreal_T &>(symreal_object).remove_suffix(1)) {
  if (symreal_what == 0 && symreal_object.size() != 0) const_cast<symreal_T &>(symreal_object).remove_suffix(1);
}
template <class symreal_T> void symreal_vary(symreal_T const &, int, symreal_turn<0>) {}
}
)";

std::string vary(std::string const &object, int what) {
  return fmt::format("symreal_vary({}, {}, symreal_turn<4>());", object, what);
}

std::string other_pointer(std::string const &pointer) {
  return fmt::format(
      "{{ static double symreal_zeroes[64]; void *symreal_other = ({0}) ? (void *)0 : (void *)symreal_zeroes; "
      "__builtin_memcpy((void *)&({0}), (void const *)&symreal_other, sizeof symreal_other); }}",
      pointer);
}

std::string other_text(std::string const &pointer, char const *value) {
  return fmt::format("{{ char const *symreal_other = \"{1}\"; __builtin_memcpy((void *)&({0}), (void const "
                     "*)&symreal_other, sizeof symreal_other); }}",
                     pointer, value);
}

void add_values(BakedObject const &one, std::vector<Variation> &all) {
  bool const is_name = one.what.expression == "__PRETTY_FUNCTION__"; // not a pointer
  auto const add = [&](auto const &leaf) {
    std::string const statement = is_name ? "" : baked_statements(one, leaf);
    if (!statement.empty())
      all.push_back({fmt::format("where '{}' has another value than in the recorded call", one.what.label), statement});
  };
  add([](std::string const &value, char kind) {
    return kind == 'd'                  ? fmt::format("((unsigned char *)&({0}))[sizeof({0}) - 2] ^= 1;", value)
           : kind == 'i' || kind == 'l' ? fmt::format("*(unsigned char *)&({}) ^= 1;", value)
                                        : std::string();
  });
  add([](std::string const &value, char kind) { return kind == 'p' ? other_pointer(value) : std::string(); });
  for (char const *words : {"", "symreal"})
    add([words](std::string const &value, char kind) {
      return kind == 's' ? other_text(value, words) : std::string();
    });
  for (int const what : changes)
    add([what](std::string const &value, char kind) {
      bool const is_container = kind == '@' || (kind == 'z' && what != element);
      return is_container ? vary(value, what) : std::string();
    });
}

void add_together(Recorded const &recorded, std::vector<Variation> &all) {
  auto const count = [&](std::string const &label) {
    std::size_t found = 0;
    for (std::vector<Object> const *objects :
         {&recorded.graph.inputs, &recorded.graph.parameters, &recorded.graph.outputs})
      for (Object const &object : *objects)
        if (object.label == label) found = object.count;
    return found;
  };
  for (rewrite::Overlap const &one : recorded.kernel.signature.redefinition.overlaps) {
    std::string const &statement = count(one.first) < count(one.second) ? one.first_there : one.second_there;
    if (statement.empty()) continue;
    std::string const once = one.calls ? "static int symreal_is_inner = 0; symreal_is_inner = !symreal_is_inner; "
                                         "if (symreal_is_inner) " +
                                             statement
                                       : statement;
    all.push_back({fmt::format("where '{}' and '{}' lie in one place", one.first, one.second), "", once});
  }
}

// Joins the lines, so that line numbers stay.
std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string squeezed(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

std::string packing(Recorded const &recorded) {
  return wrapper_pack(recorded.kernel, "input", recorded.graph.inputs, "symreal_input") +
         wrapper_pack(recorded.kernel, "parameter", recorded.graph.parameters, "symreal_parameters");
}

std::string checks(Recorded const &recorded) {
  std::string text = baked_checks(recorded, Otherwise::remember);
  for (ExtentCheck const &one : wrapper_extents(recorded.kernel, recorded.graph))
    text += fmt::format("if ({}) symreal_same = 0; ", one.differs);
  return text;
}

// Statements that apply the chosen variation. `member`: where in the function.
std::string variations(std::vector<Variation> const &all, std::string Variation::*member) {
  if (all.empty()) return "int const symreal_varied = 0; ";
  std::string text = "char const *const symreal_wish = symreal_requested(\"vary\"); "
                     "int const symreal_varied = symreal_wish ? symreal_integer(symreal_wish) : 0; ";
  for (std::size_t k = 0; k < all.size(); ++k)
    if (std::string const &statement = all[k].*member; !statement.empty())
      text += fmt::format("if (symreal_varied == {0} || symreal_varied == -{0}) {{ {1} }} ", k + 1, statement);
  return text;
}

// Statements at the function's begin.
std::string statements_before(Recorded const &recorded) {
  std::vector<Variation> const all = wrapper_variations(recorded);
  bool const any = std::ranges::any_of(all, [](Variation const &one) { return !one.before.empty(); });
  return any ? fmt::format("if ({}) {{ {} }} ", is_run_of(recorded), variations(all, &Variation::before)) : "";
}

std::string statements(Recorded const &recorded) {
  bool returns = false;
  std::string const unpacking = wrapper_unpack(recorded.kernel, recorded.graph.outputs, [&](std::string const &value) {
    returns = true;
    return "return " + recorded.kernel.signature.redefinition.result.begin + ", " + value + ");";
  });
  return fmt::format("if ({} && SYMREAL_ORIGINAL_IS_ACTIVE) {{ {} if (symreal_varied >= 0) {{ int symreal_same = 1; {} "
                     "if (symreal_same) {{ {} {} if (symreal_original_compute(symreal_input, {}, symreal_output) == 0) "
                     "{{ {} {} }} }} }} }}",
                     is_run_of(recorded), variations(wrapper_variations(recorded), &Variation::statement),
                     checks(recorded), wrapper_arrays(recorded.graph), packing(recorded),
                     recorded.graph.parameter_count() == 0 ? "0" : "symreal_parameters", unpacking,
                     returns ? "" : "return;");
}

constexpr char const *library = "char const *symreal_requested(char const *); "
                                "int symreal_integer(char const *) __asm__(\"atoi\"); ";

} // namespace

std::vector<Variation> wrapper_variations(Recorded const &recorded) {
  std::vector<Variation> all;
  for (BakedObject const &one : recorded.baked) add_values(one, all);
  for (std::string const &container : wrapper_containers(recorded.kernel, recorded.graph))
    for (int const what : {extents, inner_extents})
      all.push_back({fmt::format("where '{}' has other extents than in the recorded call", container),
                     vary("(" + container + ")", what)});
  add_together(recorded, all);
  return all;
}

std::string is_run_of(Recorded const &recorded) {
  return fmt::format("__builtin_strcmp(symreal_requested(\"replay_kernel\"), \"{}\") == 0", recorded.begun_as);
}

std::string build_with(Front const &front, std::vector<Insertion> const &insertions, std::string const &directory) {
  rewrite::Result text = front.annotated.files.empty() ? rewrite::annotated_original(front.rewritten) : front.annotated;
  std::vector<std::string> known; // blocks, which several files of one translation unit may need
  std::set<rewrite::Kernel const *> placed;
  for (rewrite::File &file : text.files) {
    std::string top;
    for (Insertion const &one : insertions) {
      std::string const place = rewrite::place_arguments(one.kernel->name, one.kernel->place),
                        mark = "SYMREAL_ORIGINAL_WRAPPER(" + place + ")";
      std::size_t const at = file.text.find(mark);
      if (at == file.text.npos) continue;
      file.text.replace(at, mark.size(), on_one_line(one.statements));
      std::size_t const begin = file.text.rfind("SYMREAL_ORIGINAL_FUNCTION(" + place, at);
      internal_check(begin != file.text.npos);
      file.text.insert(begin, on_one_line(one.before));
      placed.insert(one.kernel);
      if (one.with_classes) top += "#include <typeinfo>\n";
      for (std::string const &block : one.blocks) {
        auto const number = std::ranges::find(known, block) - known.begin();
        if (static_cast<std::size_t>(number) == known.size()) known.push_back(block);
        top += once(fmt::format("SYMREAL_BLOCK_{}", number), block + "\n");
      }
    }
    if (!top.empty()) file.text.insert(0, top + "#line 1\n");
  }
  internal_check(placed.size() == insertions.size());
  Overlay const overlay(text, front.workspace->directory(directory));
  constexpr std::array variants = {Variant::wrapped};
  return build_variants(front.build, variants, *front.overlay, overlay, *front.workspace).front();
}

bool is_wrapper_of(std::string const &text, Recorded const &recorded) {
  std::string const unpacking = wrapper_unpack(recorded.kernel, recorded.graph.outputs,
                                               [](std::string const &value) { return "return " + value + ";"; });
  std::string const all = squeezed(text);
  auto const has = [&](std::string const &part) { return all.find(squeezed(part)) != all.npos; };
  return has(packing(recorded)) && has(unpacking) &&
         (has(baked_checks(recorded, Otherwise::remember)) || has(baked_checks(recorded, Otherwise::refuse)));
}

std::string build_wrapped(Front const &front, std::span<Recorded const *const> kernels) {
  std::vector<Insertion> all;
  for (Recorded const *recorded : kernels) {
    bool const is_cxx = !is_c(recorded->kernel);
    std::vector<std::string> blocks = {is_cxx ? fmt::format("extern \"C\" {{ {} }} ", library) : library};
    for (auto const &more : {baked_helpers(*recorded), wrapper_templates(recorded->kernel, recorded->graph)})
      blocks.insert(blocks.end(), more.begin(), more.end());
    if (is_cxx) blocks.emplace_back(variation_helpers);
    all.push_back({&recorded->kernel, statements(*recorded), statements_before(*recorded), std::move(blocks),
                   compares_classes(*recorded)});
  }
  return build_with(front, all, "annotated-wrapper");
}

} // namespace symreal::program
