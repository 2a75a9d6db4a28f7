#include "tool/calls/call_binding.h"

#include "tool/calls/call_items.h"

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

bool is_count(std::string const &text) {
  return !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == text.npos;
}

class Binder : CallItems {
public:
  using CallItems::CallItems;

  void bind() {
    require_object();
    declared_ = declare_arguments(spec_, function_, binding_);
    for (Item const &item : spec_.items) make_room(item);
    for (Item const &item : spec_.items) fill(item);
    call();
    make_kernel();
  }

private:
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
    if (most.empty() || std::find(declared_.given.begin(), declared_.given.end(), path) != declared_.given.end())
      return;
    declared_.given.push_back(path);
    if (member->kind == CallParameter::Member::Kind::container)
      return add(item.text.place, fmt::format("{}.resize({});", path, most));
    std::string const room = fmt::format("symreal_room_{}", declared_.given.size());
    add(item.text.place, fmt::format("static {};", with(with(member->pointee, "$", room), "#", most)));
    add(item.text.place, fmt::format("{} = {};", path, room));
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
    if (std::find(declared_.given.begin(), declared_.given.end(), of->name) != declared_.given.end() && is_whole(item))
      return;
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
      std::string const name = !one.name.empty()                    ? one.name
                               : unnamed < declared_.unnamed.size() ? declared_.unnamed[unnamed++]
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
        bool const is_number = of->holds_scalar && of->kind == Kind::integer && !is_extent(of->name);
        if (is_number || of->kind == Kind::pointer) clause("constant", text.place, {text});
        continue;
      }
      // Integer inputs become constants; integer parameters stay, since preprocess takes any number.
      clause(item.kind == "input" && is_integer(item) ? "constant" : item.kind, text.place, {text});
      if (item.range) clause("range", text.place, {item.range->first, item.range->second});
    }
    if (function_.has_this && spec_.object && !names_members)
      clause("constant", spec_.function.place, {{"*this", spec_.function.place}});
  }

  DeclaredArguments declared_;
};

} // namespace

CallBinding bind_call(CallSpec const &spec, Callable const &function) {
  CallBinding binding;
  Binder(spec, function, binding).bind();
  return binding;
}

} // namespace symreal::tool
