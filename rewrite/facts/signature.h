// Interface of a kernel's function, for other files that call it or define it in its place.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace symreal::rewrite {

// One dimension of an array section [low:length], in the source's own words.
struct Section {
  std::string low;
  std::string length;
};

// An #include of the file that defines the function.
struct Include {
  std::string name;   // as spelled, with its quotes or angle brackets
  std::string beside; // the real path of a header found beside the file; else empty
  bool operator==(Include const &) const = default;
};

// Values that a recording bakes in, and that may differ in another call: a wrapper compares them.
struct Baked {
  std::string label;
  std::string expression; // without its sections
  std::vector<Section> sections;
  std::string shape;      // of each element (rewrite/model/baked_values.h)
  bool is_object = false; // the non-numeric part of an annotated object: it counts if the kernel has read it
  Place place;
};

// Two items, by their labels, that may alias in another call.
struct Overlap {
  std::string first, second;
  bool first_in_rows = false, second_in_rows = false; // each row may alias on its own
  // Statements, one of which suffices, that make one alias the other when the function begins; empty if neither can.
  // `calls`: the function calls itself so, once.
  std::string first_there, second_there;
  bool calls = false;
};

// Return value of a function, as an object that a wrapper fills.
struct ReturnedObject {
  enum class Form { number, integer, members, walked, bytes };
  Form form = Form::number;
  std::string type;
  std::string obstacle; // why no wrapper can make one; else empty
  std::string begin;    // of the macro that annotates it, up to the value
  // Its members that are not numbers, for the program that tries a wrapper: { what "+" offset ";" } with
  //   what := "b" size   bytes: integers, truth values, enumerators, float
  //         | "p"        a pointer: whether it is null
  //         | "t"        a pointer to text that a null character ends
  //         | "s"        a std::string
  std::string others;
};

// Text that a file of its own needs to define the function instead of the original.
struct Redefinition {
  std::string obstacle;                  // why no other file can define it; else empty
  std::string qualified;                 // its name, with all scopes
  std::string head;                      // of the definition, behind these:
  std::vector<Include> includes;         // in the order of the source
  std::vector<std::string> declarations; // of variables without a declaration in a header
  std::vector<std::string>
      namespaces;                   // to reopen for a function without a declaration in a header, the outermost first
  std::vector<std::string> missing; // names visible in the original's file only
  std::vector<std::string> varying; // names in its items that may have another value in each call
  std::string mangled;
  // Arguments that pass its parameters on, and parameters of a function of C linkage, `symreal_self` for `this` first.
  std::string arguments, parameters, returned;
  bool has_this = false;
  // Always set: the begin of its body, behind the brace, in the file with this real path.
  std::string file;
  std::size_t body = 0;
  bool is_template = false;
  std::vector<Baked> baked;
  std::vector<Overlap> overlaps;
  ReturnedObject result;
};

struct Signature {
  std::string declaration; // without its `;`
  // Arguments that pass its parameters on; nullopt unless it can be declared under another name (plain_declaration.h).
  std::optional<std::string> arguments;
  bool returns_value = false;
  Redefinition redefinition = {};
};

} // namespace symreal::rewrite
