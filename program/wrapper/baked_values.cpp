#include "program/wrapper/baked_values.h"

#include "engine/graph/names.h"
#include "engine/support/files.h"
#include "engine/support/mutation/is_dropped.h"
#include "engine/support/text.h"
#include "program/wrapper/wrapped_original.h"
#include "program/wrapper/wrapper_text.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <sstream>

namespace symreal::program {
namespace {

using rewrite::Baked;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// A parsed shape of rewrite/model/signature.h.
struct Shape {
  std::vector<std::size_t> extents;
  char kind = 0;    // '{' if it has members
  std::string name; // member name
  std::vector<Shape> members;
};

Shape read_shape(std::string_view &text) {
  Shape shape;
  while (text.starts_with('[')) {
    std::size_t const end = text.find(']');
    shape.extents.push_back(std::stoul(std::string(text.substr(1, end - 1))));
    text.remove_prefix(end + 1);
  }
  shape.kind = text.front();
  text.remove_prefix(1);
  if (shape.kind != '{') return shape;
  while (!text.starts_with('}')) {
    std::size_t const colon = text.find(':');
    std::string name(text.substr(0, colon));
    text.remove_prefix(colon + 1);
    shape.members.push_back(read_shape(text));
    shape.members.back().name = std::move(name);
    text.remove_prefix(1); // skips the semicolon
  }
  text.remove_prefix(1);
  return shape;
}

Shape shape_of(Baked const &baked) {
  std::string_view text = baked.shape;
  return read_shape(text);
}

std::string written(Shape const &shape) {
  std::string text;
  for (std::size_t const extent : shape.extents) text += fmt::format("[{}]", extent);
  text += shape.kind;
  if (shape.kind != '{') return text;
  for (Shape const &inner : shape.members) text += inner.name + ":" + written(inner) + ";";
  return text + "}";
}

// Calls `visit` with each leaf member; removes members for which it returns false.
bool keep_members(Shape &shape, std::string const &name, std::function<bool(std::string const &, char)> const &visit) {
  if (shape.kind != '{') return visit(name, shape.kind);
  std::erase_if(shape.members, [&](Shape &member) { return !keep_members(member, member.name, visit); });
  return !shape.members.empty();
}

// Last name: `mode` of `p->mode`, `index` of `s.index[i]`.
std::string last_word(std::string text) {
  while (text.ends_with(']')) text.erase(std::min(text.rfind('['), text.size()));
  std::size_t begin = text.size();
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  return text.substr(begin);
}

// Loops over an object's values, around the statement that `leaf` gives for each.
using Leaf = BakedLeaf;

std::string loop(std::size_t depth, std::string const &count, std::string const &inner) {
  return fmt::format("{{ unsigned long symreal_{0}; for (symreal_{0} = 0; symreal_{0} < {1}; ++symreal_{0}) {2} }}",
                     depth, count, inner);
}

std::string statements(Shape const &shape, std::string element, std::size_t depth, Leaf const &leaf) {
  for (std::size_t k = 0; k < shape.extents.size(); ++k) element += fmt::format("[symreal_{}]", depth + k);
  std::size_t const inside = depth + shape.extents.size();
  std::string text;
  if (shape.kind == '{') {
    for (Shape const &inner : shape.members) text += statements(inner, element + "." + inner.name, inside, leaf) + " ";
    if (!text.empty()) text = "{ " + text + "}";
  } else
    text = leaf(element, shape.kind);
  if (text.empty()) return "";
  for (std::size_t k = shape.extents.size(); k-- > 0;)
    text = loop(depth + k, std::to_string(shape.extents[k]) + "u", text);
  return text;
}

std::string statements(Baked const &baked, std::vector<std::string> const &lengths, Leaf const &leaf) {
  Shape const shape = shape_of(baked);
  std::string element = "(" + baked.expression + ")";
  for (std::size_t k = 0; k < baked.sections.size(); ++k)
    element += fmt::format("[({}) + symreal_{}]", baked.sections[k].low, k);
  std::string text = statements(shape, element, baked.sections.size(), leaf);
  if (text.empty()) return "";
  for (std::size_t k = baked.sections.size(); k-- > 0;) text = loop(k, lengths[k], text);
  return text;
}

// Value of an element as 64 bits.
std::string value_of(std::string const &element, char kind) {
  switch (kind) {
  case 'd': return fmt::format("symreal_bits({})", element);
  case 'l': return fmt::format("symreal_wide({})", element);
  case 's': return fmt::format("symreal_text({})", element);
  case 'o': return element;
  case 't': return fmt::format("symreal_text(typeid({}).name())", element);
  case 'p':
  case 'c':
  case 'f': return fmt::format("(unsigned long long)!!({})", element);
  default: return fmt::format("(unsigned long long)({})", element);
  }
}

constexpr char const *hashes = R"(static __inline__ unsigned long long symreal_bits(double symreal_number) {
  unsigned long long symreal_result;
  __builtin_memcpy(&symreal_result, &symreal_number, sizeof symreal_result);
  return symreal_result;
}
/* The bits of both doubles that it is the sum of. */
static __inline__ unsigned long long symreal_wide(long double symreal_number) {
  double const symreal_high = (double)symreal_number;
  return symreal_bits(symreal_high) * 1099511628211ull + symreal_bits((double)(symreal_number - symreal_high));
}
static __inline__ unsigned long long symreal_text(char const *symreal_string) {
  unsigned long long symreal_hash = 14695981039346656037ull;
  if (!symreal_string) return 0;
  for (; *symreal_string; ++symreal_string) symreal_hash = (symreal_hash ^ (unsigned char)*symreal_string) * 1099511628211ull;
  return symreal_hash;
}
)";

// Relative position of two ranges: the distance of their begins if they overlap.
constexpr char const *apart =
    R"(static __inline__ unsigned long long symreal_apart(void const volatile *symreal_a, void const volatile *symreal_a_end, void const volatile *symreal_b, void const volatile *symreal_b_end) {
  __UINTPTR_TYPE__ const symreal_first = (__UINTPTR_TYPE__)symreal_a, symreal_second = (__UINTPTR_TYPE__)symreal_b;
  int const symreal_meet = symreal_first < (__UINTPTR_TYPE__)symreal_b_end && symreal_second < (__UINTPTR_TYPE__)symreal_a_end;
  return symreal_meet ? (unsigned long long)(symreal_second - symreal_first) : 1ull << 63;
}
)";

// In C++, address range of an object's numbers: its own, or those that it refers to.
constexpr char const *ranges = R"(namespace {
template <int symreal_n> struct symreal_order : symreal_order<symreal_n - 1> {};
template <> struct symreal_order<0> {};
template <class symreal_T> void const volatile *symreal_address(symreal_T const &symreal_object) {
  return &reinterpret_cast<char const volatile &>(symreal_object);
}
template <class symreal_T>
auto symreal_begin(symreal_T const &symreal_object, symreal_order<2>)
    -> decltype(symreal_object.rowStride(), symreal_object.colStride(), static_cast<void const volatile *>(symreal_object.data())) {
  return symreal_object.data();
}
template <class symreal_T>
auto symreal_begin(symreal_T const &symreal_object, symreal_order<1>)
    -> decltype(symreal_object.size(), static_cast<void const volatile *>(static_cast<double const volatile *>(symreal_object.data()))) {
  return symreal_object.data();
}
template <class symreal_T> void const volatile *symreal_begin(symreal_T const &symreal_object, symreal_order<0>) {
  return symreal_address(symreal_object);
}
template <class symreal_T>
auto symreal_end(symreal_T const &symreal_object, symreal_order<2>)
    -> decltype(symreal_object.rowStride(), symreal_object.colStride(), static_cast<void const volatile *>(symreal_object.data())) {
  return symreal_object.size() == 0 ? symreal_object.data()
                                    : symreal_object.data() + (symreal_object.rows() - 1) * symreal_object.rowStride() +
                                          (symreal_object.cols() - 1) * symreal_object.colStride() + 1;
}
template <class symreal_T>
auto symreal_end(symreal_T const &symreal_object, symreal_order<1>)
    -> decltype(symreal_object.size(), static_cast<void const volatile *>(static_cast<double const volatile *>(symreal_object.data()))) {
  return symreal_object.data() + symreal_object.size();
}
template <class symreal_T> void const volatile *symreal_end(symreal_T const &symreal_object, symreal_order<0>) {
  return &reinterpret_cast<char const volatile &>(symreal_object) + sizeof symreal_object;
}
template <class symreal_T> void const volatile *symreal_low(symreal_T const &symreal_object) {
  return symreal_begin(symreal_object, symreal_order<2>());
}
template <class symreal_T> void const volatile *symreal_high(symreal_T const &symreal_object) {
  return symreal_end(symreal_object, symreal_order<2>());
}
}
)";

// Visits extents and numbers of any container, as 64 bits each.
constexpr char const *visits = R"(namespace {
template <int symreal_n> struct symreal_rank : symreal_rank<symreal_n - 1> {};
template <> struct symreal_rank<0> {};
inline unsigned long long symreal_scalar(double symreal_number) { return symreal_bits(symreal_number); }
inline unsigned long long symreal_scalar(float symreal_number) { return symreal_bits(symreal_number); }
inline unsigned long long symreal_scalar(long double symreal_number) { return symreal_wide(symreal_number); }
template <class symreal_T> unsigned long long symreal_scalar(symreal_T const &symreal_object) {
  return static_cast<unsigned long long>(symreal_object);
}
template <class symreal_T, class symreal_Visit>
void symreal_all(symreal_T const &symreal_object, symreal_Visit &symreal_visit);
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<4>)
    -> decltype(static_cast<void>(static_cast<unsigned long long>(symreal_object))) {
  symreal_visit(symreal_scalar(symreal_object));
}
template <class symreal_T, __SIZE_TYPE__ symreal_n, class symreal_Visit>
void symreal_enter(symreal_T const (&symreal_array)[symreal_n], symreal_Visit &symreal_visit, symreal_rank<3>) {
  for (__SIZE_TYPE__ symreal_i = 0; symreal_i < symreal_n; ++symreal_i) symreal_all(symreal_array[symreal_i], symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<2>)
    -> decltype(symreal_object.rows(), symreal_object.cols(), static_cast<void>(symreal_object(0, 0))) {
  symreal_visit.symreal_extent(static_cast<unsigned long long>(symreal_object.rows()));
  symreal_visit.symreal_extent(static_cast<unsigned long long>(symreal_object.cols()));
  for (decltype(symreal_object.rows() + 0) symreal_i = 0; symreal_i < symreal_object.rows(); ++symreal_i)
    for (decltype(symreal_object.cols() + 0) symreal_j = 0; symreal_j < symreal_object.cols(); ++symreal_j)
      symreal_all(symreal_object(symreal_i, symreal_j), symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<1>)
    -> decltype(symreal_object.size(), static_cast<void>(symreal_object[0])) {
  symreal_visit.symreal_extent(static_cast<unsigned long long>(symreal_object.size()));
  for (decltype(symreal_object.size() + 0) symreal_i = 0; symreal_i < symreal_object.size(); ++symreal_i)
    symreal_all(symreal_object[symreal_i], symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<0>)
    -> decltype(symreal_object.real(), static_cast<void>(symreal_object.imag())) {
  symreal_all(symreal_object.real(), symreal_visit);
  symreal_all(symreal_object.imag(), symreal_visit);
}
template <class symreal_T, class symreal_Visit>
void symreal_all(symreal_T const &symreal_object, symreal_Visit &symreal_visit) {
  symreal_enter(symreal_object, symreal_visit, symreal_rank<4>());
}
struct symreal_comparer {
  unsigned long long const *symreal_known;
  unsigned long long symreal_met;
  bool symreal_differs;
  void operator()(unsigned long long symreal_value) {
    symreal_differs = symreal_differs || symreal_met >= symreal_known[0] || symreal_known[symreal_met + 1] != symreal_value;
    ++symreal_met;
  }
  void symreal_extent(unsigned long long symreal_value) { (*this)(symreal_value); }
};
template <class symreal_Visit> struct symreal_extents_alone {
  symreal_Visit &symreal_visit;
  void operator()(unsigned long long) {}
  void symreal_extent(unsigned long long symreal_value) { symreal_visit(symreal_value); }
};
template <class symreal_T, class symreal_Visit>
void symreal_each_of(symreal_T const &symreal_object, bool symreal_is_whole, symreal_Visit &symreal_visit) {
  symreal_extents_alone<symreal_Visit> symreal_alone = {symreal_visit};
  if (symreal_is_whole)
    symreal_all(symreal_object, symreal_visit);
  else
    symreal_all(symreal_object, symreal_alone);
}
template <class symreal_T>
bool symreal_is_other(symreal_T const &symreal_object, bool symreal_is_whole, unsigned long long const *symreal_known, unsigned long &symreal_at) {
  symreal_comparer symreal_visit = {symreal_known + symreal_at, 0, false};
  symreal_each_of(symreal_object, symreal_is_whole, symreal_visit);
  bool const symreal_result = symreal_visit.symreal_differs || symreal_visit.symreal_met != symreal_known[symreal_at];
  symreal_at += 1 + symreal_known[symreal_at];
  return symreal_result;
}
}
)";

// Helpers of the program that prints the values.
constexpr char const *tellers_in_c = R"(
char const *symreal_requested(char const *);
int symreal_create(char const *, unsigned) __asm__("creat");
int symreal_print(int, char const *, ...) __asm__("dprintf");
void symreal_quit(int) __asm__("_exit");
)";
constexpr char const *tellers_in_cxx = R"(namespace {
struct symreal_counter_of_all {
  unsigned long long symreal_count;
  void operator()(unsigned long long) { ++symreal_count; }
  void symreal_extent(unsigned long long symreal_value) { (*this)(symreal_value); }
};
struct symreal_teller {
  int symreal_file;
  void operator()(unsigned long long symreal_value) { symreal_print(symreal_file, "%llu\n", symreal_value); }
  void symreal_extent(unsigned long long symreal_value) { (*this)(symreal_value); }
};
template <class symreal_T> void symreal_tell(int symreal_file, symreal_T const &symreal_object, bool symreal_is_whole) {
  symreal_counter_of_all symreal_counter = {0};
  symreal_each_of(symreal_object, symreal_is_whole, symreal_counter);
  symreal_teller symreal_visit = {symreal_file};
  symreal_visit(symreal_counter.symreal_count);
  symreal_each_of(symreal_object, symreal_is_whole, symreal_visit);
}
}
)";

bool has_kind(std::vector<BakedObject> const &all, char kind) {
  return std::ranges::any_of(all, [kind](BakedObject const &one) {
    bool found = false;
    Shape shape = shape_of(one.what);
    (void)keep_members(shape, "", [&](std::string const &, char what) { return found |= what == kind, true; });
    return found;
  });
}

// Is the kind compared by templates of C++?
bool is_walked(char kind) { return kind == '@' || kind == 'z'; }
bool has_walked(std::vector<BakedObject> const &all) { return has_kind(all, '@') || has_kind(all, 'z'); }

// Adds the relative positions of items that may overlap in another call.
void add_overlaps(Recorded &recorded) {
  rewrite::Kernel const &kernel = recorded.kernel;
  for (rewrite::Overlap const &one : kernel.signature.redefinition.overlaps) {
    std::string const first = wrapper_place(kernel, recorded.graph, one.first, one.first_in_rows),
                      second = wrapper_place(kernel, recorded.graph, one.second, one.second_in_rows);
    if (first.empty() || second.empty()) continue;
    std::string const label = overlap_label(one);
    recorded.baked.push_back(
        {{label, fmt::format("symreal_apart({}, {})", first, second), {}, "o", false, kernel.place}, {}, {}});
  }
}

bool is_number(std::string const &text) { return text.find_first_not_of("0123456789") == text.npos; }

// Keeps, of the non-numeric parts of annotated objects, only those that the kernel has read.
void keep_read(std::vector<BakedObject> &all, std::vector<Frozen> const &frozen) {
  std::vector<std::string> members, labels;
  for (BakedObject &one : all) {
    if (!one.what.is_object) continue;
    labels.push_back(one.what.label);
    Shape shape = shape_of(one.what);
    (void)keep_members(shape, last_word(one.what.label),
                       [&](std::string const &name, char) { return members.push_back(name), true; });
  }
  bool counts_all = false;
  std::vector<std::string> read;
  for (Frozen const &one : frozen) {
    if (!one.is_member) continue;
    read.push_back(last_word(one.name));
    bool const is_object = std::ranges::find(labels, one.name) != labels.end();
    counts_all |= !is_object && std::ranges::find(members, read.back()) == members.end();
  }
  std::erase_if(all, [&](BakedObject &one) {
    if (!one.what.is_object) return false;
    bool const is_copied =
        std::ranges::any_of(frozen, [&](Frozen const &each) { return each.is_member && each.name == one.what.label; });
    Shape shape = shape_of(one.what);
    bool const any = keep_members(shape, last_word(one.what.label), [&](std::string const &name, char kind) {
      bool const is_integer = kind == 'i' || kind == 'b' || kind == 'x' || kind == '@';
      return !is_integer || counts_all || is_copied || std::ranges::find(read, name) != read.end();
    });
    one.what.shape = written(shape);
    return !any;
  });
}

// Requires that a clause names all frozen state: other state cannot be compared.
void require_named(Recorded const &recorded) {
  for (Frozen const &one : recorded.graph.frozen) {
    bool const is_compared = std::ranges::any_of(
        recorded.baked, [&](BakedObject const &baked) { return baked.what.expression == one.name; });
    if (!one.is_member && !one.is_around && !is_compared)
      fail(DiagnosticId::no_wrapper, one.place.file.empty() ? recorded.kernel.place : one.place,
           fmt::format("--wrapper cannot compare '{}', which is baked in and may be another in the next call: name it "
                       "in input, parameter or constant",
                       one.name));
  }
}

[[noreturn]] void refuse(Recorded const &recorded, Baked const &baked, std::string const &reason) {
  fail(DiagnosticId::no_wrapper, baked.place,
       fmt::format("--wrapper cannot compare '{}' of '{}', which is baked in: {}", baked.label, recorded.kernel.name,
                   reason));
}

// Statements that print the values. The request gives the file's name, since objects are cached across runs.
std::string tell(Recorded const &recorded) {
  std::string text = "if (SYMREAL_ORIGINAL_IS_ACTIVE) { int const symreal_file = "
                     "symreal_create(symreal_requested(\"baked\"), 0600); ";
  for (BakedObject const &one : recorded.baked) {
    std::vector<std::string> lengths;
    for (rewrite::Section const &section : one.what.sections) {
      lengths.push_back("(unsigned long)(" + section.length + ")");
      text += fmt::format("symreal_print(symreal_file, \"%lu\\n\", {}); ", lengths.back());
    }
    text += statements(one.what, lengths,
                       [](std::string const &element, char kind) {
                         return is_walked(kind)
                                    ? fmt::format("symreal_tell(symreal_file, {}, {});", element, kind == '@')
                                    : fmt::format("symreal_print(symreal_file, \"{}%llu\\n\", {});",
                                                  kind == 'f' ? "called " : "", value_of(element, kind));
                       }) +
            " symreal_print(symreal_file, \"end\\n\"); ";
  }
  return text + "symreal_quit(0); }";
}

void read_values(Recorded &recorded, std::string const &path) {
  std::istringstream file(std::filesystem::exists(path) ? read_file(path) : "");
  std::string word;
  for (BakedObject &one : recorded.baked) {
    bool is_called = false;
    while (file >> word && word != "end") {
      if (word == "called") {
        is_called = true;
        continue;
      }
      if (is_called && word != "0")
        refuse(recorded, one.what, "a function that is called through it is part of the recording");
      is_called = false;
      if (one.lengths.size() < one.what.sections.size())
        one.lengths.push_back(std::stoull(word));
      else
        one.values.push_back(std::stoull(word));
    }
    if (word != "end")
      fail(DiagnosticId::kernel_not_reached, recorded.kernel.place,
           "the original did not reach '" + recorded.kernel.name + "' as the recorded program did");
  }
}

} // namespace

void add_baked_values(Front const &front, RunOptions const &run, Recorded &recorded) {
  recorded.baked.clear();
  for (Baked const &one : recorded.kernel.signature.redefinition.baked) {
    if (one.shape.starts_with('?')) refuse(recorded, one, one.shape.substr(1));
    recorded.baked.push_back({one, {}, {}});
  }
  keep_read(recorded.baked, recorded.graph.frozen);
  add_overlaps(recorded);
  for (BakedObject const &one : recorded.baked)
    if (has_kind({one}, 'x')) refuse(recorded, one.what, "the kernel reads a private member of it");
  require_named(recorded);
  if (recorded.baked.empty()) return;
  rewrite::Result telling =
      front.annotated.files.empty() ? rewrite::annotated_original(front.rewritten) : front.annotated;
  std::string const path = front.workspace->directory("baked") + "/" + identifier(recorded.kernel.name);
  std::string top = is_c(recorded.kernel) ? "" : "extern \"C\" {";
  top += tellers_in_c;
  top += is_c(recorded.kernel) ? "" : "}\n";
  for (std::string const &block : baked_helpers(recorded)) top += block;
  if (has_walked(recorded.baked)) top += tellers_in_cxx;
  insert_in_wrapper_place(telling, recorded.kernel, tell(recorded), top, compares_classes(recorded));
  Overlay const text(telling, front.workspace->directory("annotated-baked"));
  constexpr std::array variants = {Variant::wrapped};
  std::string const program = build_variants(front.build, variants, *front.overlay, text, *front.workspace).front();
  Command command{.arguments = {program},
                  .directory = run.directory,
                  .standard_input = run.standard_input,
                  .time_limit = run.time_limit};
  command.arguments.insert(command.arguments.end(), run.arguments.begin(), run.arguments.end());
  command.request.set(wire::Entry::baked, path);
  (void)program::run(command, [](std::string_view) {});
  read_values(recorded, path);
}

// Compares pointers first: a null pointer must not be followed.
std::string baked_checks(Recorded const &recorded, Otherwise otherwise) {
  std::string text;
  if (is_dropped("baked")) return text;
  bool const is_remembered = otherwise == Otherwise::remember;
  std::string const still = is_remembered ? "symreal_same && " : "";
  std::vector<BakedObject> all = recorded.baked;
  auto const rank = [](BakedObject const &one) {
    return one.what.shape == "p" ? one.what.expression.size() : std::string::npos;
  };
  std::ranges::stable_sort(all, {}, rank);
  for (BakedObject const &one : all) {
    if (is_dropped("extents") && one.what.shape == "z") continue;
    if (is_dropped("overlaps") && one.what.shape == "o") continue;
    std::string const other = is_remembered ? "symreal_same = 0;" : refusal_of(one.what.label);
    std::vector<std::string> lengths;
    for (std::size_t k = 0; k < one.lengths.size(); ++k) {
      lengths.push_back(std::to_string(one.lengths[k]) + "u");
      if (!is_number(one.what.sections[k].length))
        text += fmt::format("  if ({}({}) != {}) {}\n", still, one.what.sections[k].length, one.lengths[k], other);
    }
    bool const is_single = one.what.sections.empty() && one.what.shape.size() == 1 && !is_walked(one.what.shape[0]);
    if (is_single) {
      char const kind = one.what.shape[0];
      std::string const element = "(" + one.what.expression + ")";
      auto const value = static_cast<long long>(one.values.front());
      bool const is_least = value == std::numeric_limits<long long>::min();
      text += kind == 'i' && !is_least
                  ? fmt::format("  if ({}(long long){} != {}ll) {}\n", still, element, value, other)
                  : fmt::format("  if ({}{} != {}ull) {}\n", still, value_of(element, kind), one.values.front(), other);
      continue;
    }
    text += is_remembered ? "  if (symreal_same) {\n" : "  {\n";
    text += "    static unsigned long long const symreal_known[] = {";
    for (std::size_t k = 0; k < one.values.size(); ++k) text += fmt::format("{}{}ull", k ? ", " : "", one.values[k]);
    text += one.values.empty() ? "0" : "";
    text += "};\n    unsigned long symreal_at = 0;\n    " +
            statements(one.what, lengths,
                       [&](std::string const &element, char kind) {
                         return is_walked(kind)
                                    ? fmt::format("if (symreal_is_other({}, {}, symreal_known, symreal_at)) {}",
                                                  element, kind == '@', other)
                                    : fmt::format("if ({} != symreal_known[symreal_at++]) {}", value_of(element, kind),
                                                  other);
                       }) +
            "\n  }\n";
  }
  return text;
}

std::vector<std::string> baked_helpers(Recorded const &recorded) {
  if (recorded.baked.empty()) return {};
  std::vector<std::string> blocks = {hashes};
  if (has_kind(recorded.baked, 'o')) blocks.push_back(apart);
  if (has_kind(recorded.baked, 'o') && !is_c(recorded.kernel)) blocks.push_back(ranges);
  if (has_walked(recorded.baked)) blocks.push_back(visits);
  return blocks;
}

bool compares_classes(Recorded const &recorded) { return has_kind(recorded.baked, 't'); }

std::string overlap_label(rewrite::Overlap const &overlap) {
  return fmt::format("where '{}' and '{}' lie", overlap.first, overlap.second);
}

std::string baked_statements(BakedObject const &object, BakedLeaf const &leaf) {
  std::vector<std::string> lengths;
  for (std::size_t const length : object.lengths) lengths.push_back(std::to_string(length) + "u");
  return statements(object.what, lengths, leaf);
}

} // namespace symreal::program
