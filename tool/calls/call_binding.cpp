#include "tool/calls/call_binding.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal::tool {
namespace {

using rewrite::Callable;
using rewrite::CallParameter;
using rewrite::ConfiguredText;
using rewrite::Section;
using Kind = CallParameter::Kind;
using Item = CallSpec::Item;

std::string with(std::string text, std::string const &mark, std::string const &value) {
  for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + value.size()))
    text.replace(at, mark.size(), value);
  return text;
}

bool is_count(std::string const &text) {
  return !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == text.npos;
}

bool is_literal(std::string const &text) {
  return !text.empty() && text.find_first_not_of("0123456789.eE+-") == text.npos;
}

// Expression for the index behind a section's last element.
std::string end_of(Section const &section) {
  return section.low == "0" ? section.length : "(" + section.low + ") + (" + section.length + ")";
}

std::string larger(std::string const &one, std::string const &other) {
  return fmt::format("({0} > {1} ? {0} : {1})", one, other);
}

class Binder {
public:
  Binder(CallSpec const &spec, Callable const &function) : spec_(spec), function_(function) {}

  CallBinding bind() {
    require_object();
    for (CallParameter const &one : function_.parameters) // integers first, as sizes may depend on them
      if (one.kind == Kind::integer) declare(one);
    for (CallParameter const &one : function_.parameters)
      if (one.kind != Kind::integer) declare(one);
    for (Item const &item : spec_.items) make_room(item);
    for (Item const &item : spec_.items) fill(item);
    call();
    make_kernel();
    return std::move(binding_);
  }

private:
  void problem(Place const &place, std::string message) {
    binding_.problems.push_back(
        {DiagnosticId::call_specification, place, std::move(message), {{function_.place, function_.declaration}}});
  }
  void add(Place const &place, std::string text) { binding_.statements.push_back({std::move(text), place}); }

  CallParameter const *parameter(std::string const &name) const {
    for (CallParameter const &one : function_.parameters)
      if (one.name == name) return &one;
    return nullptr;
  }
  bool is_whole(Item const &item) const { return item.text.text == item.base; }

  void require_object() {
    if (spec_.object && !function_.has_this)
      problem(spec_.function.place,
              "'" + function_.qualified + "' is called without an object: leave '" + *spec_.object + ".' out");
    if (!function_.is_accessible)
      problem(spec_.function.place,
              "'" + function_.qualified + "' is private or protected, so a program cannot call it");
    if (!spec_.object && function_.has_this && !function_.object_default_constructible)
      problem(spec_.function.place,
              fmt::format("'{0}' cannot be made without arguments: name the object, as in {0}(...).{1}(...)",
                          function_.object, function_.name));
  }

  // Sections of an item, or else the extents of the array that a pointer is declared as.
  std::vector<Section> sections(Item const &item) const {
    CallParameter const *of = parameter(item.base);
    std::vector<Section> all = item.sections;
    if (of && of->kind == Kind::pointer && all.empty() && is_whole(item))
      for (std::string const &extent : of->extents) all.push_back({"0", extent});
    return all;
  }

  // Number of elements that an argument needs to cover all its items; empty if no item determines it.
  std::string count(CallParameter const &of, std::size_t dimension) const {
    std::vector<std::string> counts;
    for (Item const &item : spec_.items) {
      std::string const index = item.base + "[";
      if (dimension == 0 && item.base == of.name && item.path.starts_with(index))
        counts.push_back("(" + item.path.substr(index.size(), item.path.find(']') - index.size()) + ") + 1");
      bool const is_base = item.base == of.name && item.path == item.base;
      std::vector<Section> const all = sections(item);
      if (!is_base || dimension >= all.size()) continue;
      std::string const needed = end_of(all[dimension]);
      if (std::find(counts.begin(), counts.end(), needed) == counts.end()) counts.push_back(needed);
    }
    std::string most;
    for (std::string const &one : counts) most = most.empty() ? one : larger(most, one);
    return most;
  }

  // The pointer, container or integer member that an item names: `.next` of "*a->next[0:2]".
  CallParameter::Member const *other_member(Item const &item) const {
    CallParameter const *of = parameter(item.base);
    if (!of) return nullptr;
    std::size_t const begin = item.path.find(item.base) + item.base.size();
    std::string path = with(item.path.substr(begin), "->", ".");
    for (CallParameter::Member const &one : of->other_members)
      if (one.path == path) return &one;
    return nullptr;
  }
  bool is_integer(Item const &item) const {
    CallParameter::Member const *member = other_member(item);
    return member && member->kind == CallParameter::Member::Kind::integer && item.sections.empty();
  }

  // Gives a pointer member an array of its own, and a container member the elements that are named.
  void make_room(Item const &item) {
    CallParameter::Member const *member = other_member(item);
    if (!member || member->kind == CallParameter::Member::Kind::integer) return;
    std::string most = item.path.starts_with('*') ? "1" : "";
    for (Item const &other : spec_.items)
      if (other.path == item.path && !other.sections.empty()) {
        std::string const needed = end_of(other.sections[0]);
        most = most.empty() || most == needed ? needed : larger(most, needed);
      }
    std::string const path = item.path.starts_with('*') ? item.path.substr(1) : item.path;
    if (most.empty() || std::find(given_.begin(), given_.end(), path) != given_.end()) return;
    given_.push_back(path);
    if (member->kind == CallParameter::Member::Kind::container)
      return add(item.text.place, fmt::format("{}.resize({});", path, most));
    std::string const room = fmt::format("symreal_room_{}", given_.size());
    add(item.text.place, fmt::format("static {};", with(with(member->pointee, "$", room), "#", most)));
    add(item.text.place, fmt::format("{} = {};", path, room));
  }

  Item const *item_of(CallParameter const &one) const {
    for (Item const &item : spec_.items)
      if (item.base == one.name) return &item;
    return nullptr;
  }
  // The item that gives a value to the whole argument.
  Item const *value_of(CallParameter const &one) const {
    for (Item const &item : spec_.items)
      if (item.base == one.name && is_whole(item) && item.kind != "output") return &item;
    return nullptr;
  }

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
    given_.push_back(one.name);
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
    std::string const name = one.name.empty() ? fmt::format("symreal_unnamed_{}", unnamed_++) : one.name;
    add(place, "static " + with(one.variable, "$", name) + ";");
    if (one.name.empty()) unnamed_names_.push_back(name);
  }

  void declare_other(CallParameter const &one, Place const &place) {
    Item const *value = value_of(one);
    if (!value || value->value.empty())
      return problem(
          place, fmt::format("'{0}' has no value: write {0}=EXPRESSION for what a {1} is to be", one.name, one.type));
    add(place, fmt::format("{} = {};", with(one.variable, "$", one.name), list_or(*value)));
  }

  // Initial value of every number of an item.
  std::string value_text(Item const &item) {
    if (item.range)
      return fmt::format("(({0}) + (({1}) - ({0})) * symreal_default())", item.range->first.text,
                         item.range->second.text);
    if (!item.value.empty()) return "(" + item.value + ")";
    binding_.unvalued.push_back(item.text.text);
    return "symreal_default()";
  }

  void fill(Item const &item) {
    if (item.kind == "output" || item.kind == "scratch") {
      if (item.has_value()) problem(item.text.place, "'" + item.text.text + "' is " + item.kind + " and has no value");
      return;
    }
    CallParameter const *of = parameter(item.base);
    if (!of) return fill_other(item);
    if (of->kind == Kind::integer || of->kind == Kind::other) {
      if (!is_whole(item)) problem(item.text.place, "'" + item.base + "' has no elements: it is " + of->type);
      return;
    }
    if (std::find(given_.begin(), given_.end(), of->name) != given_.end() && is_whole(item)) return;
    if (is_integer(item)) return fill_integer(item);
    std::vector<Section> const all = sections(item);
    if (of->kind == Kind::pointer && all.empty() && is_whole(item)) return; // a plain address, or a single object
    if (item.kind == "constant" && !item.has_value())
      return problem(item.text.place,
                     fmt::format("'{0}' is to be constant and has no value: write constant {0}=0.5", item.text.text));
    fill_elements(item, all, of->is_matrix);
  }

  void fill_integer(Item const &item) {
    if (item.value.empty() || item.is_list)
      return problem(item.text.place, fmt::format("'{0}' is an integer and has no value, which is part of the result: "
                                                  "write {0}=1",
                                                  item.text.text));
    add(item.text.place, fmt::format("{} = {};", item.path, item.value));
  }

  // Fills a file-scope variable if it is given a value; otherwise it keeps its own.
  void fill_other(Item const &item) {
    if (!item.has_value()) return;
    if (function_.has_this)
      return problem(item.text.place, "'" + item.base + "' is not an argument of '" + function_.qualified +
                                          "'; a member has the value that the object is made with");
    fill_elements(item, item.sections, false);
  }

  void fill_elements(Item const &item, std::vector<Section> const &all, bool is_matrix) {
    if (item.is_list && !list_fits(item, all)) return;
    std::string text, element = item.path, close, flat;
    for (std::size_t k = 0; k < all.size(); ++k) {
      text += fmt::format("{{ int symreal_{0}; for (symreal_{0} = 0; symreal_{0} < ({1}); ++symreal_{0}) ", k,
                          all[k].length);
      std::string const index = fmt::format("({}) + symreal_{}", all[k].low, k);
      element += !is_matrix ? "[" + index + "]" : (k == 0 ? "(" : ", ") + index + (k + 1 == all.size() ? ")" : "");
      if (!is_matrix && k < item.behind.size()) element += item.behind[k];
      flat =
          flat.empty() ? fmt::format("symreal_{}", k) : fmt::format("({}) * ({}) + symreal_{}", flat, all[k].length, k);
      close += " }";
    }
    std::string value;
    if (item.is_list) {
      text = fmt::format("{{ static double const symreal_values[] = {{{}}}; ", item.value) + text;
      close += " }";
      value = "symreal_values[" + (flat.empty() ? "0" : flat) + "]";
    } else
      value = value_text(item);
    std::vector<std::string> objects = {element};
    if (CallParameter const *of = structure(item)) {
      objects.clear();
      for (std::string const &member : of->members) objects.push_back("(" + element + ")" + member);
    }
    text += "{ ";
    for (std::string const &one : objects)
      text += function_.is_c ? fmt::format("{} = {}; ", one, value)
                             : fmt::format("symreal_fill({}, [&] {{ return {}; }}); ", one, value);
    add(item.text.place, text + "}" + close);
  }

  // The structure argument, or array of structures, that the item denotes.
  CallParameter const *structure(Item const &item) const {
    CallParameter const *of = parameter(item.base);
    bool const is_whole_one = item.path == item.base || item.path == "*" + item.base;
    bool const has_rest =
        std::any_of(item.behind.begin(), item.behind.end(), [](std::string const &one) { return !one.empty(); });
    return of && !item.is_list && is_whole_one && !has_rest && !of->members.empty() ? of : nullptr;
  }

  bool list_fits(Item const &item, std::vector<Section> const &all) {
    std::size_t wanted = 1, depth = 0, given = 1;
    for (Section const &one : all) {
      if (!is_count(one.length)) return true;
      wanted *= std::stoul(one.length);
    }
    for (char c : item.value) {
      depth += c == '(' || c == '{' || c == '[';
      depth -= c == ')' || c == '}' || c == ']';
      given += c == ',' && depth == 0;
    }
    if (given == wanted) return true;
    problem(item.text.place,
            all.empty()
                ? fmt::format("'{0}' says no elements: write {0}[0:{1}]={{{2}}}", item.text.text, given, item.value)
                : fmt::format("'{}' has {} elements, and {} values are given", item.text.text, wanted, given));
    return false;
  }

  void call() {
    std::vector<std::string> arguments;
    std::size_t unnamed = 0;
    for (CallParameter const &one : function_.parameters) {
      std::string const name = !one.name.empty()                 ? one.name
                               : unnamed < unnamed_names_.size() ? unnamed_names_[unnamed++]
                                                                 : "0";
      arguments.push_back(one.moved.empty() ? name : "static_cast<" + one.moved + ">(" + name + ")");
    }
    std::string const list = fmt::format("({});", fmt::join(arguments, ", "));
    Place const &place = spec_.function.place;
    if (function_.is_c && parameter(function_.name)) { // the argument shadows the function
      binding_.before = fmt::format("static __typeof__(&{0}) const symreal_{0} = {0};", function_.name);
      return add(place, fmt::format("(void)symreal_{}{}", function_.name, list));
    }
    if (!function_.has_this && spec_.template_arguments.empty() && spec_.function.text.find('<') == std::string::npos)
      return add(place, (function_.is_c ? "(void)" : "(void)::") + function_.qualified + list);
    if (!function_.has_this) return add(place, "(void)::" + spec_.function.text + spec_.template_arguments + list);
    std::string const object = spec_.object ? *spec_.object : function_.object + "()";
    add(place, "auto &&symreal_object = " + object + ";");
    add(place, "(void)symreal_object." + function_.name + spec_.template_arguments + list);
  }

  void clause(std::string const &name, Place const &place, std::vector<ConfiguredText> items) {
    binding_.kernel.clauses.push_back({{name, place}, std::move(items)});
  }

  bool is_extent(std::string const &name) const {
    return std::any_of(spec_.items.begin(), spec_.items.end(), [&](Item const &item) {
      return std::any_of(item.sections.begin(), item.sections.end(),
                         [&](Section const &one) { return one.length == name; });
    });
  }

  void make_kernel() {
    binding_.kernel.function = {function_.key, spec_.function.place};
    binding_.kernel.file = function_.file;
    bool names_members = false;
    for (Item const &item : spec_.items) {
      CallParameter const *of = parameter(item.base);
      ConfiguredText text = item.text;
      if (of && of->is_matrix) text.text = item.path;
      if (!of && item.base != "return") binding_.unknown.push_back(item.base);
      names_members = names_members || (!of && item.base != "return");
      bool const is_value =
          of && (of->kind == Kind::integer || of->kind == Kind::other ||
                 (of->kind == Kind::pointer && is_whole(item) && item.has_value() && sections(item).empty()));
      if (is_value && item.kind != "output") {
        if (of->holds_scalar && of->kind == Kind::integer && !is_extent(of->name))
          clause("constant", text.place, {text});
        continue;
      }
      // Integer inputs become constants; integer parameters stay, since preprocess takes any number.
      clause(item.kind == "input" && is_integer(item) ? "constant" : item.kind, text.place, {text});
      if (item.range) clause("range", text.place, {item.range->first, item.range->second});
    }
    if (function_.has_this && spec_.object && !names_members)
      clause("constant", spec_.function.place, {{"*this", spec_.function.place}});
  }

  CallSpec const &spec_;
  Callable const &function_;
  CallBinding binding_;
  std::vector<std::string> given_; // arguments declared with their value
  std::vector<std::string> unnamed_names_;
  std::size_t unnamed_ = 0;
};

} // namespace

CallBinding bind_call(CallSpec const &spec, Callable const &function) { return Binder(spec, function).bind(); }

std::string binding_helpers(bool is_c) {
  std::string value = "static double symreal_default(void) {\n"
                      "  static int symreal_last = 0;\n"
                      "  symreal_last = (symreal_last + 61) % 97;\n"
                      "  return (symreal_last + 1) / 100.0;\n"
                      "}\n";
  if (is_c) return value;
  return "#include <iterator>\n" + value + R"(namespace {
template <int symreal_n> struct symreal_rank : symreal_rank<symreal_n - 1> {};
template <> struct symreal_rank<0> {};
template <class symreal_T, class symreal_Value>
void symreal_fill(symreal_T &&symreal_object, symreal_Value symreal_value);
template <class symreal_Value> void symreal_put(double &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_Value> void symreal_put(float &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_Value> void symreal_put(bool &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_Value> void symreal_put(char &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_Value> void symreal_put(int &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_Value>
void symreal_put(unsigned &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_Value> void symreal_put(long &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_Value>
void symreal_put(unsigned long &symreal_object, symreal_Value symreal_value, symreal_rank<3>) {
  symreal_object = symreal_value();
}
template <class symreal_T, class symreal_Value>
auto symreal_put(symreal_T &symreal_object, symreal_Value symreal_value, symreal_rank<2>)
    -> decltype(symreal_object.rows(), symreal_object.cols(), static_cast<void>(symreal_object(0, 0))) {
  for (decltype(symreal_object.rows() + 0) symreal_i = 0; symreal_i < symreal_object.rows(); ++symreal_i)
    for (decltype(symreal_object.cols() + 0) symreal_j = 0; symreal_j < symreal_object.cols(); ++symreal_j)
      symreal_fill(symreal_object(symreal_i, symreal_j), symreal_value);
}
template <class symreal_T, class symreal_Value>
auto symreal_put(symreal_T &symreal_object, symreal_Value symreal_value, symreal_rank<1>)
    -> decltype(symreal_object.real(), static_cast<void>(symreal_object.imag())) {
  symreal_object = symreal_T(symreal_value(), symreal_value());
}
template <class symreal_T, class symreal_Value>
auto symreal_put(symreal_T &symreal_object, symreal_Value symreal_value, symreal_rank<0>)
    -> decltype(static_cast<void>(*std::begin(symreal_object))) {
  for (auto &symreal_part : symreal_object) symreal_fill(symreal_part, symreal_value);
}
template <class symreal_T, class symreal_Value>
void symreal_fill(symreal_T &&symreal_object, symreal_Value symreal_value) {
  symreal_put(symreal_object, symreal_value, symreal_rank<3>());
}
}
)";
}

} // namespace symreal::tool
