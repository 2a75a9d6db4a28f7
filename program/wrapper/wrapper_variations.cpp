#include "program/wrapper/wrapper_variations.h"

#include "program/wrapper/baked_values.h"
#include "program/wrapper/wrapper_text.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::program {
namespace {

constexpr int extents = 0, inner_extents = 1, element = 2; // change that symreal_vary makes to a container
constexpr int changes[] = {extents, inner_extents, element};

constexpr char const *helpers_in_cxx = R"(namespace {
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

std::string text(std::string const &pointer, char const *value) {
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
    add([words](std::string const &value, char kind) { return kind == 's' ? text(value, words) : std::string(); });
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

std::string variation_helpers(Recorded const &recorded) { return is_c(recorded.kernel) ? "" : helpers_in_cxx; }

} // namespace symreal::program
