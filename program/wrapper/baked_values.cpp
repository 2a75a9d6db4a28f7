#include "program/wrapper/baked_values.h"

#include "engine/graph/names.h"
#include "engine/support/files.h"
#include "engine/support/mutation/is_dropped.h"
#include "engine/support/text.h"
#include "program/wrapper/baked_patterns.h"
#include "program/wrapper/baked_shape.h"
#include "program/wrapper/wrapped_original.h"
#include "program/wrapper/wrapper_text.h"
#include "rewrite/text/source_text.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <sstream>

namespace symreal::program {
namespace {

using rewrite::Baked;

// Last name: `mode` of `p->mode`, `index` of `s.index[i]`.
std::string last_word(std::string text) {
  while (text.ends_with(']')) text.erase(std::min(text.rfind('['), text.size()));
  std::size_t begin = text.size();
  while (begin > 0 && rewrite::is_word(text[begin - 1])) --begin;
  return text.substr(begin);
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

bool has_kind(std::vector<BakedObject> const &all, char kind) {
  return std::ranges::any_of(all, [kind](BakedObject const &one) {
    bool found = false;
    BakedShape shape = shape_of(one.what);
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
    BakedShape shape = shape_of(one.what);
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
    BakedShape shape = shape_of(one.what);
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
  std::string text = fmt::format("if ({} && SYMREAL_ORIGINAL_IS_ACTIVE) {{ int const symreal_file = "
                                 "symreal_create(symreal_requested(\"baked\"), 0600); ",
                                 is_run_of(recorded));
  for (BakedObject const &one : recorded.baked) {
    std::vector<std::string> lengths;
    for (rewrite::Section const &section : one.what.sections) {
      lengths.push_back("(unsigned long)(" + section.length + ")");
      text += fmt::format("symreal_print(symreal_file, \"%lu\\n\", {}); ", lengths.back());
    }
    text += baked_statements(one.what, lengths,
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

Insertion teller(Recorded const &recorded) {
  bool const c = is_c(recorded.kernel);
  std::vector<std::string> blocks = {c ? patterns::tellers_in_c
                                       : fmt::format("extern \"C\" {{{}}}", patterns::tellers_in_c)};
  for (std::string &block : baked_helpers(recorded)) blocks.push_back(std::move(block));
  if (has_walked(recorded.baked)) blocks.emplace_back(patterns::tellers_in_cxx);
  return {&recorded.kernel, tell(recorded), "", std::move(blocks), compares_classes(recorded)};
}

// Fills in which values there are; returns whether there are any. Throws no_wrapper for one that cannot be compared.
bool find_baked(Recorded &recorded) {
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
  return !recorded.baked.empty();
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

Refusals add_baked_values(Front const &front, RunOptions const &run, std::span<Recorded *const> kernels) {
  Refusals refused;
  auto const without_refused = [&](std::span<Recorded *const> all, auto const &add) {
    std::vector<Recorded *> rest;
    for (Recorded *one : all) try {
        if (add(*one)) rest.push_back(one);
      } catch (DiagnosticError const &error) {
        if (error.diagnostic().id != DiagnosticId::no_wrapper) throw;
        refused.emplace(one, error.diagnostic());
      }
    return rest;
  };
  std::vector<Recorded *> const told = without_refused(kernels, [](Recorded &one) { return find_baked(one); });
  if (told.empty()) return refused;
  std::vector<Insertion> insertions;
  for (Recorded const *one : told) insertions.push_back(teller(*one));
  std::string const program = build_with(front, insertions, "annotated-baked");
  without_refused(told, [&](Recorded &one) {
    std::string const path = front.workspace->directory("baked") + "/" + identifier(one.kernel.name);
    Command command{.arguments = {program},
                    .directory = run.directory,
                    .standard_input = run.standard_input,
                    .time_limit = run.time_limit};
    command.arguments.insert(command.arguments.end(), run.arguments.begin(), run.arguments.end());
    command.request.set(wire::Entry::baked, path);
    command.request.set(wire::Entry::replay_kernel, one.begun_as);
    (void)program::run(command, [](std::string_view) {});
    read_values(one, path);
    return true;
  });
  return refused;
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
            baked_statements(one.what, lengths,
                             [&](std::string const &element, char kind) {
                               return is_walked(kind)
                                          ? fmt::format("if (symreal_is_other({}, {}, symreal_known, symreal_at)) {}",
                                                        element, kind == '@', other)
                                          : fmt::format("if ({} != symreal_known[symreal_at++]) {}",
                                                        value_of(element, kind), other);
                             }) +
            "\n  }\n";
  }
  return text;
}

std::vector<std::string> baked_helpers(Recorded const &recorded) {
  if (recorded.baked.empty()) return {};
  std::vector<std::string> blocks = {patterns::hashes};
  if (has_kind(recorded.baked, 'o')) blocks.push_back(patterns::apart);
  if (has_kind(recorded.baked, 'o') && !is_c(recorded.kernel)) blocks.push_back(patterns::ranges);
  if (has_walked(recorded.baked)) blocks.push_back(patterns::visits);
  return blocks;
}

bool compares_classes(Recorded const &recorded) { return has_kind(recorded.baked, 't'); }

std::string overlap_label(rewrite::Overlap const &overlap) {
  return fmt::format("where '{}' and '{}' lie", overlap.first, overlap.second);
}

std::string baked_statements(BakedObject const &object, BakedLeaf const &leaf) {
  std::vector<std::string> lengths;
  for (std::size_t const length : object.lengths) lengths.push_back(std::to_string(length) + "u");
  return baked_statements(object.what, lengths, leaf);
}

} // namespace symreal::program
