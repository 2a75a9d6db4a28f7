// What is known of a kernel's function, so that another file can call it or define it in its place.
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
  std::string name;   // as it is written, with its quotes or angle brackets
  std::string beside; // the real path of the header, where it was found beside the file; else empty
  bool operator==(Include const &) const = default;
};

// Values that a recording bakes in, and that another call may find changed: a wrapper compares them.
struct Baked {
  std::string label;
  std::string expression; // without its sections
  std::vector<Section> sections;
  std::string shape;      // of each element (rewrite/model/baked_values.h)
  bool is_object = false; // what is no number of an annotated object: it counts where the kernel has read it
  Place place;
};

// Two items that may lie in one place in another call, by their labels.
struct Overlap {
  std::string first, second;
  bool first_in_rows = false, second_in_rows = false; // each row elsewhere
  // Statements that bring one to where the other is, when the function begins, of which one is enough; empty where
  // there is no such way. `calls`: the function calls itself so, once.
  std::string first_there, second_there;
  bool calls = false;
};

// What a function returns, as an object that a wrapper fills.
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

// What a file of its own needs to define the function instead of the original.
struct Redefinition {
  std::string obstacle;                  // why no other file can define it; else empty
  std::string qualified;                 // its name, with all scopes
  std::string head;                      // of the definition, behind these:
  std::vector<Include> includes;         // in the order of the source
  std::vector<std::string> declarations; // of variables that no header declares
  std::vector<std::string> namespaces;   // to be opened, where no header declares it, the outermost first
  std::vector<std::string> missing;      // names that only the file of the original has
  std::vector<std::string> varying;      // names in its items that may have another value in each call
  std::string mangled;
  // What passes its parameters on, and how a function of C linkage takes them, `symreal_self` for `this` first.
  std::string arguments, parameters, returned;
  bool has_this = false;
  // In every case: where its body begins, behind the brace, in the file with this real path.
  std::string file;
  std::size_t body = 0;
  bool is_template = false;
  std::vector<Baked> baked;
  std::vector<Overlap> overlaps;
  ReturnedObject result;
};

struct Signature {
  std::string declaration; // without its `;`
  // What passes its parameters on, where it can be declared again under another name (plain_declaration.h).
  std::optional<std::string> arguments;
  bool returns_value = false;
  Redefinition redefinition = {};
};

} // namespace symreal::rewrite
