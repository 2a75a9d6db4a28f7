// The functions of a program as a driver program calls them: what it must declare for each parameter.
//
// Declarations are texts with `$` for the name and, where how much is declared is open, `#` for that.
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
  std::string name; // empty where the definition gives none
  std::string type; // in words
  Kind kind = Kind::other;
  std::string variable;             // an object of the type, without const and reference: "double $"
  std::string pointee;              // pointer: an array of what it points to: "double $[#]"
  std::string rows;                 // pointer to pointers: what these point to: "double $[#][#]"
  bool is_matrix = false;           // its elements are m(i, j)
  std::vector<std::string> extents; // of a pointer that is declared as an array
  bool points_to_numbers = false;   // and not to a class
  // Of a class, or of what is pointed to: its members of numbers that a program can name, as ".pose.x" or ".v[2]".
  std::vector<std::string> members;
  // Its other members that a program can name.
  struct Member {
    enum class Kind {
      integer,   // what a pragma's `constant` takes
      pointer,   // to what can be declared
      container, // whose size can be set
    };
    std::string path; // ".next"
    Kind kind;
    std::string pointee; // pointer: an array of what it points to: "double $[#]"
  };
  std::vector<Member> other_members;
  bool default_constructible = true;
  bool is_changed = false;   // passed by a reference to what is not const
  bool is_integral = false;  // integer: an integer type, rather than a truth value, an enumeration or a float
  bool holds_scalar = false; // integer: what a pragma's `constant` takes
  std::string moved;         // an rvalue reference: what it is cast to
};

struct Callable {
  std::string name, qualified;
  std::string with_inline;    // qualified, inline namespaces included
  std::string key;            // its name with the types of its parameters, of a template's those of its definition
  std::string declared_types; // (double const *, int), as they are written
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

// The definitions of functions whose name, without scopes, is this. Sources that do not compile are passed over: what
// is wrong with them is told when they are rewritten.
std::vector<Callable> find_callables(Request const &request, std::string const &name);

// The instance of a template that the expression, the address of a function, takes in a source that has this word: at
// most one.
std::vector<Callable> find_instance(Request const &request, std::string const &word, std::string const &address);

} // namespace symreal::rewrite
