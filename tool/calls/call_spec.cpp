#include "tool/calls/call_spec.h"

#include "rewrite/facts/tables.h"
#include "rewrite/text/source_text.h"

#include <algorithm>
#include <cctype>

namespace symreal::tool {
namespace {

using rewrite::ConfiguredText;
using rewrite::is_word;

[[noreturn]] void refuse(Place const &place, std::string const &message) {
  fail(DiagnosticId::call_specification, place, message);
}

// A part of the text, with its place.
struct PlacedText {
  std::string_view text;
  Place place;

  PlacedText from(std::size_t begin, std::size_t end = std::string_view::npos) const {
    PlacedText part{text.substr(begin, end == std::string_view::npos ? end : end - begin), place};
    part.place.column += static_cast<unsigned>(begin);
    return part.trimmed();
  }
  PlacedText trimmed() const {
    PlacedText part = *this;
    while (!part.text.empty() && std::isspace(static_cast<unsigned char>(part.text.front()))) {
      part.text.remove_prefix(1);
      ++part.place.column;
    }
    while (!part.text.empty() && std::isspace(static_cast<unsigned char>(part.text.back()))) part.text.remove_suffix(1);
    return part;
  }
  std::string string() const { return std::string(text); }
};

// Visits the offsets outside brackets and literals; brackets must match.
template <class Visit> void each_outside(PlacedText const &part, Visit visit) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < part.text.size(); ++i) {
    char const c = part.text[i];
    if (c == '"' || c == '\'') {
      std::size_t end = i + 1;
      while (end < part.text.size() && part.text[end] != c) end += part.text[end] == '\\' ? 2 : 1;
      if (end >= part.text.size()) refuse(part.from(i, i + 1).place, "this quote is not closed");
      i = end;
    } else if (c == '(' || c == '[' || c == '{') {
      if (open.empty()) visit(i);
      open.push_back(i);
    } else if (c == ')' || c == ']' || c == '}') {
      constexpr std::string_view pairs = "()[]{}";
      if (open.empty() || pairs[pairs.find(part.text[open.back()]) + 1] != c)
        refuse(part.from(i, i + 1).place, std::string("this '") + c + "' has no counterpart");
      open.pop_back();
      if (open.empty()) visit(i);
    } else if (open.empty())
      visit(i);
  }
  if (!open.empty())
    refuse(part.from(open.back(), open.back() + 1).place,
           std::string("this '") + part.text[open.back()] + "' is not closed");
}

std::vector<PlacedText> split(PlacedText const &part, char separator) {
  std::vector<PlacedText> parts;
  std::size_t begin = 0;
  each_outside(part, [&](std::size_t i) {
    if (part.text[i] != separator) return;
    parts.push_back(part.from(begin, i));
    begin = i + 1;
  });
  parts.push_back(part.from(begin));
  return parts;
}

// Offset of the bracket that the last character closes.
std::size_t opening(PlacedText const &part) {
  std::size_t open = 0;
  each_outside(part, [&](std::size_t i) {
    if (part.text[i] == '(') open = i;
  });
  return open;
}

// Parses an item as in a pragma, with sections [low:length].
void read_item(PlacedText const &part, CallSpec::Item &item) {
  if (part.text.empty()) refuse(part.place, "an item is missing here");
  item.text = {part.string(), part.place};
  std::size_t at = part.text.find_first_not_of("*&( ");
  if (at == part.text.npos || !is_word(part.text[at]) || std::isdigit(static_cast<unsigned char>(part.text[at])))
    refuse(part.place, "'" + part.string() + "' is not an item: an item is an argument, as in q[0:6] or state->x");
  std::size_t end = at;
  while (end < part.text.size() && (is_word(part.text[end]) || part.text.substr(end, 2) == "::"))
    end += part.text[end] == ':' ? 2 : 1;
  item.base = part.text.substr(at, end - at);
  item.path = item.text.text;
  std::size_t begin = 0;
  for (std::size_t open = part.text.find('[', end); open < part.text.size(); open = part.text.find('[', open)) {
    std::size_t close = open + 1, colon = part.text.npos;
    for (int depth = 1; close < part.text.size(); ++close) {
      depth +=
          (part.text[close] == '[' || part.text[close] == '(') - (part.text[close] == ']' || part.text[close] == ')');
      if (part.text[close] == ':' && depth == 1) colon = close;
      if (depth == 0) break;
    }
    if (close == part.text.size()) refuse(part.from(open, open + 1).place, "this '[' is not closed");
    if (colon == part.text.npos && (close + 1 < part.text.size() || open != end)) { // an index within a member path
      open = close + 1;
      continue;
    }
    if (colon == part.text.npos) {
      std::string const inside = part.from(open + 1, close).string();
      refuse(part.from(open, open + 1).place, "'" + part.string() + "' gives no range of elements: write " + item.base +
                                                  "[" + inside + ":1] for one element, [0:" + inside +
                                                  "] for that many");
    }
    if (item.sections.empty()) item.path = part.text.substr(0, open);
    std::string const low = part.from(open + 1, colon).string();
    std::string const length = part.from(colon + 1, close).string();
    if (length.empty()) refuse(part.from(colon, colon + 1).place, "how many elements these are is missing");
    if (!item.sections.empty()) item.behind.back() = part.text.substr(begin, open - begin);
    item.sections.push_back({low.empty() ? "0" : low, length});
    item.behind.emplace_back(part.text.substr(close + 1));
    begin = open = close + 1;
  }
}

void require_finite(PlacedText const &value) {
  if (rewrite::is_not_finite(value.string()))
    refuse(value.place, "'" + value.string() + "' is not finite, and a kernel is recorded at finite numbers");
}

void read_value(PlacedText const &part, CallSpec::Item &item) {
  if (part.text.empty())
    refuse(part.place, "the value of '" + item.text.text + "' is missing: write " + item.text.text + "=0.5");
  std::size_t dots = part.text.npos;
  each_outside(part, [&](std::size_t i) {
    if (part.text.substr(i, 2) == ".." && dots == part.text.npos) dots = i;
  });
  if (dots != part.text.npos) {
    PlacedText const low = part.from(0, dots), high = part.from(dots + 2);
    item.range.emplace(ConfiguredText{low.string(), low.place}, ConfiguredText{high.string(), high.place});
    if (low.text.empty() || high.text.empty()) refuse(part.place, "a range has two ends, as in -1..1");
    if (std::string const wrong = rewrite::wrong_range(low.string(), high.string()); !wrong.empty())
      fail(DiagnosticId::bad_range, part.place, wrong);
    if (item.kind != "input")
      refuse(part.place, "a range is where the inputs of 'verify' lie; '" + item.text.text + "' is not an input");
  } else if (item.is_list = part.text.front() == '{'; item.is_list) {
    PlacedText const inner = part.from(1, part.text.size() - 1);
    item.value = inner.string();
    for (PlacedText const &one : split(inner, ',')) require_finite(one);
  } else {
    item.value = part.string();
    require_finite(part);
  }
}

CallSpec::Item read_argument(PlacedText part) {
  CallSpec::Item item{
      .kind = "input", .text = {}, .base = {}, .path = {}, .sections = {}, .behind = {}, .value = {}, .range = {}};
  for (auto const &[clause, word, where, traits, key] : rewrite::clause_table())
    if ((traits & (rewrite::trait::GIVEN | rewrite::trait::KEPT)) != 0 && part.text.starts_with(word) &&
        part.text.size() > word.size() && part.text[word.size()] == ' ') {
      item.kind = word;
      part = part.from(word.size());
    }
  std::size_t equal = part.text.npos;
  each_outside(part, [&](std::size_t i) {
    if (part.text[i] == '=' && equal == part.text.npos) equal = i;
  });
  read_item(part.from(0, equal), item);
  if (equal != part.text.npos) read_value(part.from(equal + 1), item);
  return item;
}

// Begin of an operator function's name, without scopes; npos for other functions.
std::size_t operator_word(std::string_view text) {
  constexpr std::string_view word = "operator";
  for (std::size_t at = text.rfind(word); at != text.npos && text.size() > word.size();
       at = at == 0 ? text.npos : text.rfind(word, at - 1)) {
    char const behind = at + word.size() < text.size() ? text[at + word.size()] : ' ';
    if ((at == 0 || !is_word(text[at - 1])) && (!is_word(behind) || behind == ' ')) return at;
  }
  return text.npos;
}

// End of an operator function's name: behind its symbols or conversion type.
std::size_t operator_end(std::string_view text, std::size_t word) {
  std::size_t at = word + std::string_view("operator").size();
  while (at < text.size() && text[at] == ' ') ++at;
  for (std::string_view const brackets : {"()", "[]"})
    if (text.substr(at, 2) == brackets) return at + 2;
  constexpr std::string_view symbols = "+-*/%^&|~!=<>,";
  if (at < text.size() && symbols.find(text[at]) != symbols.npos)
    return std::min(text.find_first_not_of(symbols, at), text.size());
  return std::min(text.find('(', at), text.size());
}

// Begin of the scoped name that ends at `end`, including template arguments.
std::size_t scopes_begin(std::string_view text, std::size_t end) {
  std::size_t begin = end;
  for (int depth = 0; begin > 0; --begin) {
    char const c = text[begin - 1];
    depth += (c == '>') - (c == '<');
    if (depth < 0 || (depth == 0 && !is_word(c) && c != ':' && c != '<')) break;
  }
  return begin;
}

[[noreturn]] void refuse_name(PlacedText const &part) {
  refuse(part.place, "'" + part.string() +
                         "' is not the name of a function: write FUNCTION(ARGUMENTS) -> OUTPUTS, as in " +
                         "f(x[0:3]=0.5, n=3) -> y[0:3]");
}

// Parses name[<arguments>]; the name may have scopes.
void read_name(PlacedText part, CallSpec &spec) {
  if (std::size_t const word = operator_word(part.text); word != part.text.npos) {
    if (scopes_begin(part.text, word) != 0) refuse_name(part);
    std::string name = part.string();
    std::size_t const symbol = name.find_first_not_of(' ', word + std::string_view("operator").size());
    if (symbol != name.npos && !is_word(name[symbol])) std::erase(name, ' ');
    spec.function = {name, part.place};
    return;
  }
  PlacedText name = part;
  if (part.text.ends_with('>')) {
    std::size_t open = part.text.size(); // begin of the last brackets
    int depth = 0;
    do {
      --open;
      depth += (part.text[open] == '>') - (part.text[open] == '<');
    } while (open > 0 && depth > 0);
    if (depth != 0) refuse(part.place, "this '>' has no counterpart");
    spec.template_arguments = part.from(open).string();
    name = part.from(0, open);
  }
  if (name.text.empty() || std::isdigit(static_cast<unsigned char>(name.text[0])) ||
      scopes_begin(name.text, name.text.size()) != 0)
    refuse_name(part);
  spec.function = {name.string(), name.place};
}

// Parses [object.]name[(types)], or an object that is called.
void read_callee(PlacedText part, CallSpec &spec) {
  std::size_t const word = operator_word(part.text);
  std::size_t const end = word == part.text.npos ? part.text.npos : operator_end(part.text, word);
  if (part.text.ends_with(')') && end != part.text.size()) {
    std::size_t const open = opening(part);
    spec.types = part.from(open).string();
    spec.called_object = part.string();
    part = part.from(0, open);
  }
  if (part.text.ends_with('}')) { // T{a}(x)
    spec.object = part.string();
    spec.function = {"operator()", part.place};
    return;
  }
  std::size_t dot = part.text.npos;
  each_outside(part, [&](std::size_t i) {
    if (part.text[i] == '.' && i < word) dot = i;
  });
  if (dot != part.text.npos) {
    spec.object = part.from(0, dot).string();
    if (spec.object->empty()) refuse(part.place, "the object before '.' is missing");
    part = part.from(dot + 1);
  }
  read_name(part, spec);
}

// Refuses a name that occurs twice among the arguments, or twice among the outputs.
void refuse_repetitions(CallSpec const &spec) {
  for (std::size_t k = 0; k < spec.items.size(); ++k)
    for (std::size_t j = 0; j < k; ++j) {
      CallSpec::Item const &one = spec.items[j], &other = spec.items[k];
      bool const are_outputs = other.kind == "output";
      if (one.text.text == other.text.text && (one.kind == "output") == are_outputs)
        refuse(other.text.place, "'" + other.text.text + "' is " + (are_outputs ? "an output" : "given") + " twice");
    }
}

} // namespace

bool is_call_spec(std::string const &text) { return text.find('(') != text.npos || text.find("->") != text.npos; }

CallSpec parse_call_spec(ConfiguredText const &text) {
  PlacedText const all = PlacedText{text.text, text.place}.trimmed();
  CallSpec spec;
  std::size_t arrow = all.text.npos;
  each_outside(all, [&](std::size_t i) { // the arrow of body->x follows no call
    bool const follows_call = all.text.substr(i, 2) == "->" && all.from(0, i).text.ends_with(')');
    if (follows_call && arrow == all.text.npos) arrow = i;
  });
  spec.end = all.place;
  spec.end.column += static_cast<unsigned>(all.text.size());
  PlacedText const call = all.from(0, arrow);
  if (!call.text.ends_with(')'))
    refuse(call.place, "'" + call.string() + "' has no arguments: write FUNCTION(ARGUMENTS) -> OUTPUTS, as in " +
                           "f(x[0:3]=0.5, n=3) -> y[0:3]");
  std::size_t const open = opening(call);
  read_callee(call.from(0, open), spec);
  PlacedText const arguments = call.from(open + 1, call.text.size() - 1);
  if (!arguments.text.empty())
    for (PlacedText const &one : split(arguments, ',')) spec.items.push_back(read_argument(one));
  if (arrow == all.text.npos)
    refuse(spec.end, "the outputs of '" + spec.function.text + "' are missing: add -> and the outputs, as in " +
                         "-> y[0:3], or -> return");
  for (PlacedText const &one : split(all.from(arrow + 2), ',')) {
    CallSpec::Item item{
        .kind = "output", .text = {}, .base = {}, .path = {}, .sections = {}, .behind = {}, .value = {}, .range = {}};
    read_item(one, item);
    spec.items.push_back(std::move(item));
  }
  refuse_repetitions(spec);
  return spec;
}

} // namespace symreal::tool
