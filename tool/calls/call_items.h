// Items of a call against the parameters of its function, and the statements and problems that come of them.
#pragma once

#include "tool/calls/call_binding.h"

#include <string>
#include <vector>

namespace symreal::tool {

// The text with every mark replaced.
std::string with(std::string text, std::string const &mark, std::string const &value);
// Expression for the index behind a section's last element.
std::string end_of(rewrite::Section const &section);
std::string larger(std::string const &one, std::string const &other);

class CallItems {
public:
  using Item = CallSpec::Item;
  using Parameter = rewrite::CallParameter;

  CallItems(CallSpec const &spec, rewrite::Callable const &function, CallBinding &binding)
      : spec_(spec),
        function_(function),
        binding_(binding) {}

protected:
  void problem(Place const &place, std::string message);
  void add(Place const &place, std::string text) { binding_.statements.push_back({std::move(text), place}); }

  Parameter const *parameter(std::string const &name) const;
  bool is_whole(Item const &item) const { return item.text.text == item.base; }
  // Sections of an item, or else the extents of the array that a pointer is declared as.
  std::vector<rewrite::Section> sections(Item const &item) const;
  // Number of elements that an argument needs to cover all its items; empty if no item determines it.
  std::string count(Parameter const &of, std::size_t dimension) const;
  // The pointer, container or integer member that an item names: `.next` of "*a->next[0:2]".
  Parameter::Member const *other_member(Item const &item) const;
  bool is_integer(Item const &item) const;
  Item const *item_of(Parameter const &one) const;
  // The item that gives a value to the whole argument.
  Item const *value_of(Parameter const &one) const;
  // The structure argument, or array of structures, that the item denotes.
  Parameter const *structure(Item const &item) const;
  bool is_extent(std::string const &name) const;

  CallSpec const &spec_;
  rewrite::Callable const &function_;
  CallBinding &binding_;
};

// Names of variables that stand for arguments.
struct DeclaredArguments {
  std::vector<std::string> given;   // arguments declared with their value
  std::vector<std::string> unnamed; // variables of arguments without a name
};

// Declares the argument variables: integers first, as sizes may depend on them.
DeclaredArguments declare_arguments(CallSpec const &spec, rewrite::Callable const &function, CallBinding &binding);

} // namespace symreal::tool
