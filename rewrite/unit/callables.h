// Functions of a program as a driver program calls them, with the declarations that it needs for their parameters.
//
// Declarations are texts with `$` for the name and, if an extent is open, `#` for that.
#pragma once

#include "rewrite/request/request.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

struct CallParameter {
  enum class Kind {
    number,    // a double
    integer,   // any other arithmetic type, or an enumeration
    pointer,   // to something that can be declared
    container, // of numbers, sized by its constructor
    matrix,    // likewise, by rows and columns
    object,    // a class, or a container or matrix of fixed size
    other      // a pointer to a function or to nothing known
  };
  std::string name; // empty if the definition gives none
  std::string type; // as text
  Kind kind = Kind::other;
  std::string variable;             // an object of the type, without const and reference: "double $"
  std::string pointee;              // pointer: an array of what it points to: "double $[#]"
  std::string rows;                 // pointer to pointers: what these point to: "double $[#][#]"
  bool is_matrix = false;           // its elements are m(i, j)
  std::vector<std::string> extents; // of a pointer declared as an array
  bool points_to_numbers = false;   // and not to a class
  // Numeric members of a class or pointee that a program can name, as ".pose.x" or ".v[2]".
  std::vector<std::string> members;
  // Its other members that a program can name.
  struct Member {
    enum class Kind {
      integer,   // valid in a pragma's `constant`
      pointer,   // to a type that can be declared
      container, // whose size can be set
    };
    std::string path; // ".next"
    Kind kind;
    std::string pointee; // pointer: an array of what it points to: "double $[#]"
  };
  std::vector<Member> other_members;
  bool default_constructible = true;
  bool is_changed = false;   // passed by a reference to non-const
  bool is_integral = false;  // integer: an integer type, rather than a truth value, an enumeration or a float
  bool holds_scalar = false; // integer: valid in a pragma's `constant`
  std::string moved;         // type to cast an rvalue reference's argument to
};

struct Callable {
  std::string name, qualified;
  std::string with_inline;    // qualified, inline namespaces included
  std::string key;            // its name with the types of its parameters, for a template those of its definition
  std::string declared_types; // (double const *, int), as spelled
  std::string declaration;
  Place place;
  std::string file;   // the real path of the file that defines it
  std::size_t source; // the first of the compilations that reads the definition
  bool is_c = false;
  bool has_this = false;
  std::string object; // has_this: its class
  bool object_default_constructible = true;
  bool is_accessible = true;
  std::vector<CallParameter> parameters;
};

// Definitions of functions with this unqualified name. Sources that do not compile are skipped: their errors are
// reported when they are rewritten.
std::vector<Callable> find_callables(Request const &request, std::string const &name);

// The instance of a template whose address the expression takes, in a source that contains this word: at most one.
std::vector<Callable> find_instance(Request const &request, std::string const &word, std::string const &address);

} // namespace symreal::rewrite
