// Declarations of the variables that a call passes.
#include "tool/calls/call_items.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::tool {
namespace {

using rewrite::CallParameter;
using Kind = CallParameter::Kind;

bool is_literal(std::string const &text) {
  return !text.empty() && text.find_first_not_of("0123456789.eE+-") == text.npos;
}

class ArgumentDeclarations : CallItems {
public:
  using CallItems::CallItems;

  DeclaredArguments run() {
    for (CallParameter const &one : function_.parameters)
      if (one.kind == Kind::integer) declare(one);
    for (CallParameter const &one : function_.parameters)
      if (one.kind != Kind::integer) declare(one);
    return std::move(declared_);
  }

private:
  std::string list_or(Item const &item) const { return item.is_list ? "{" + item.value + "}" : item.value; }

  void declare(CallParameter const &one) {
    Item const *item = item_of(one);
    Place const place = item ? item->text.place : spec_.end;
    std::string const shown = one.name.empty() ? "the argument of type " + one.type : "'" + one.name + "'";
    if (one.name.empty() && one.kind != Kind::object)
      return problem(place,
                     shown + " has no name in the definition of '" + function_.qualified + "': give it one there");
    switch (one.kind) {
    case Kind::number: return declare_number(one, item, place);
    case Kind::integer: return declare_integer(one, place);
    case Kind::pointer: return declare_pointer(one, item, place);
    case Kind::container: return declare_container(one, place);
    case Kind::matrix: return declare_matrix(one, place);
    case Kind::object: return declare_object(one, place);
    case Kind::other: return declare_other(one, place);
    }
  }

  void declare_number(CallParameter const &one, Item const *item, Place const &place) {
    if (!item)
      return problem(
          place,
          fmt::format("'{0}' is missing: write {0}=0.5 (an input), parameter {0}=0.5 or constant {0}=0.5", one.name));
    for (Item const &other : spec_.items)
      if (other.base == one.name && !is_whole(other))
        problem(other.text.place, fmt::format("'{}' is one number: write {}", one.name, one.name));
    add(place, "static " + with(one.variable, "$", one.name) + ";");
  }

  void declare_integer(CallParameter const &one, Place const &place) {
    Item const *item = value_of(one);
    if (!item || item->value.empty() || item->is_list)
      return problem(place,
                     fmt::format("'{0}' has no value, and a value of type {1} is part of the result: write {0}=1",
                                 one.name, one.type));
    if (function_.is_c && one.is_integral)
      add(place, fmt::format("enum {{ {} = ({}) }};", one.name, item->value));
    else if (function_.is_c)
      add(place, fmt::format("{} = ({});", with(one.variable, "$", one.name), item->value));
    else
      add(place,
          fmt::format("{}{} = ({});", one.is_changed ? "" : "const ", with(one.variable, "$", one.name), item->value));
  }

  void declare_pointer(CallParameter const &one, Item const *item, Place const &place) {
    std::string most = count(one, 0);
    Item const *value = value_of(one);
    bool const is_address = most.empty() && value && !value->value.empty() && !value->is_list;
    bool const is_number = is_address && is_literal(value->value) && value->value != "0";
    if (is_address && !is_number)
      return add(place, fmt::format("{} = {};", with(one.variable, "$", one.name), value->value));
    bool const is_one = item && std::any_of(spec_.items.begin(), spec_.items.end(), [&](Item const &other) {
                          return other.base == one.name && (other.text.text.starts_with("*") || !one.points_to_numbers);
                        });
    if (most.empty() && is_one) most = "1";
    if (most.empty() || is_number)
      return problem(place, fmt::format("'{0}' is a pointer and needs an extent: write {0}[0:6]=0.5 with its "
                                        "number of elements, or {0}={1} for none",
                                        one.name, function_.is_c ? "0" : "nullptr"));
    if (!one.default_constructible)
      return problem(place, fmt::format("what '{}' points to cannot be made without arguments: write {}=EXPRESSION",
                                        one.name, one.name));
    std::string const inner = one.rows.empty() ? "" : count(one, 1);
    if (!one.rows.empty() && inner.empty())
      return problem(
          place, fmt::format("'{0}' points to pointers: write {0}[0:3][0:3] with both numbers of elements", one.name));
    std::string const initial = value && value->is_list && most == "1" ? " = {{" + value->value + "}}" : "";
    if (!one.rows.empty()) {
      std::string const rows = "symreal_rows_of_" + one.name;
      std::string declaration = with(one.rows, "$", rows);
      declaration.replace(declaration.find('#'), 1, most);
      add(place, "static " + with(declaration, "#", inner) + ";");
      add(place, fmt::format("static {};", with(with(one.pointee, "$", one.name), "#", most)));
      add(place,
          fmt::format(
              "{{ int symreal_0; for (symreal_0 = 0; symreal_0 < {}; ++symreal_0) {}[symreal_0] = {}[symreal_0]; }}",
              most, one.name, rows));
    } else
      add(place, fmt::format("static {}{};", with(with(one.pointee, "$", one.name), "#", most), initial));
  }

  bool declare_by_value(CallParameter const &one, Place const &place) {
    Item const *value = value_of(one);
    if (!value || value->value.empty() || !value->sections.empty()) return false;
    if (is_literal(value->value) && !value->is_list) return false; // the value is for each element
    if (function_.is_c && !value->is_list) {
      add(place, "static " + with(one.variable, "$", one.name) + ";");
      add(place, fmt::format("{} = {};", one.name, value->value));
    } else
      add(place, fmt::format("static {} = {};", with(one.variable, "$", one.name), list_or(*value)));
    declared_.given.push_back(one.name);
    return true;
  }

  void declare_container(CallParameter const &one, Place const &place) {
    if (declare_by_value(one, place)) return;
    std::string const most = count(one, 0);
    if (most.empty())
      return problem(place,
                     fmt::format("'{0}' is of no known size: write {0}[0:6] with its number of elements", one.name));
    add(place, fmt::format("static {};", with(one.variable, "$", one.name + "(" + most + ")")));
    if (std::string const inner = count(one, 1); !inner.empty())
      add(place, fmt::format("for (auto &symreal_row : {}) symreal_row.resize({});", one.name, inner));
  }

  void declare_matrix(CallParameter const &one, Place const &place) {
    if (declare_by_value(one, place)) return;
    std::string const rows = count(one, 0), columns = count(one, 1);
    if (rows.empty() || columns.empty())
      return problem(
          place,
          fmt::format("'{0}' is a matrix of no known size: write {0}[0:3][0:3] with its rows and columns", one.name));
    add(place, fmt::format("static {};", with(one.variable, "$", fmt::format("{}({}, {})", one.name, rows, columns))));
  }

  void declare_object(CallParameter const &one, Place const &place) {
    if (declare_by_value(one, place)) return;
    if (!one.default_constructible)
      return problem(
          place,
          fmt::format("'{0}' cannot be made without arguments: write {0}={1}(...), or constant {0}={1}(...) where its "
                      "numbers stay as they are",
                      one.name, with(one.variable, " $", "")));
    std::string const name = one.name.empty() ? fmt::format("symreal_unnamed_{}", declared_.unnamed.size()) : one.name;
    add(place, "static " + with(one.variable, "$", name) + ";");
    if (one.name.empty()) declared_.unnamed.push_back(name);
  }

  void declare_other(CallParameter const &one, Place const &place) {
    Item const *value = value_of(one);
    if (!value || value->value.empty())
      return problem(
          place, fmt::format("'{0}' has no value: write {0}=EXPRESSION for what a {1} is to be", one.name, one.type));
    add(place, fmt::format("{} = {};", with(one.variable, "$", one.name), list_or(*value)));
  }

  DeclaredArguments declared_;
};

} // namespace

DeclaredArguments declare_arguments(CallSpec const &spec, rewrite::Callable const &function, CallBinding &binding) {
  return ArgumentDeclarations(spec, function, binding).run();
}

} // namespace symreal::tool
