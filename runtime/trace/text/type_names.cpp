// Names of the runtime's classes: the texts that typeid returns are overwritten with the original's type names, so that
// all readers, libraries included, find these.
//
// Mangled names are parsed into nodes and printed again. Substitutions (S_, S0_, ...) count the components before them,
// so each component is a node with a key: its name in full.
#include "runtime/trace/text/type_names.h"

#include "runtime/memory/own_memory.h"
#include "runtime/trace/parts/parts.h"
#include "runtime/trace/report/events.h"

#include <symreal/environment.h>
#include <symreal/type_names.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <deque>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace symreal {

namespace trace {
namespace {

struct Node;
struct Piece {
  std::string text;
  Node const *node = nullptr; // behind the text
};
using Pieces = std::vector<Piece>;

struct Node {
  enum Kind { word, compound, name };
  Kind kind = word; // a word is never substituted
  Pieces pieces;    // of a name: behind its scope
  Node const *scope = nullptr;
  bool is_arguments = false; // the pieces are those of a template, which is the scope
  std::string key;
};

// Thrown where a name has a part that is not read.
struct Unread {};

class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  Node const *whole() {
    Node const *result = type();
    if (!text_.empty()) throw Unread();
    return result;
  }

private:
  char next(std::size_t at = 0) const { return at < text_.size() ? text_[at] : '\0'; }
  std::string take(std::size_t count) {
    if (count > text_.size()) throw Unread();
    std::string taken(text_.substr(0, count));
    text_.remove_prefix(count);
    return taken;
  }
  bool skip(std::string_view text) {
    if (!text_.starts_with(text)) return false;
    text_.remove_prefix(text.size());
    return true;
  }
  void expect(std::string_view text) {
    if (!skip(text)) throw Unread();
  }
  std::string take_while(std::string_view letters) {
    return take(std::min(text_.find_first_not_of(letters), text_.size()));
  }
  static constexpr std::string_view digits = "0123456789", digits_36 = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";

  static std::string key_of(Pieces const &pieces) {
    std::string key;
    for (Piece const &piece : pieces) key += piece.text + (piece.node ? piece.node->key : "");
    return key;
  }
  Node const *make(Node::Kind kind, Pieces pieces) {
    std::string key = key_of(pieces);
    return &nodes_.emplace_back(Node{kind, std::move(pieces), nullptr, false, std::move(key)});
  }
  Node const *word(std::string text) { return make(Node::word, {{std::move(text)}}); }
  Node const *noted(Node const *node) {
    if (node->kind != Node::word || is_replaced_) known_.push_back(node);
    is_replaced_ = false;
    return node;
  }

  // A name within a scope, or its counterpart in the original.
  Node const *within(Node const *scope, Pieces pieces, bool is_arguments) {
    std::string key = (scope ? scope->key + "|" : "") + key_of(pieces);
    is_replaced_ = true;
    if (key == "7symreal|5types|10RealNumber") return word("d");
    if (key == "7symreal|5types|12SymbolicBool") return word("b");
    if (is_arguments && scope->key == "7symreal|5types|11SymbolicInt" && pieces.size() > 1) return pieces[1].node;
    is_replaced_ = false;
    return &nodes_.emplace_back(Node{Node::name, std::move(pieces), scope, is_arguments, std::move(key)});
  }

  Node const *type() {
    char const first = next();
    if (first == '\0') throw Unread();
    if (std::string const qualifiers = take_while("rVK"); !qualifiers.empty()) {
      if (next() == 'F' || text_.starts_with("Do")) return noted(function(qualifiers));
      return noted(make(Node::compound, {{qualifiers, type()}}));
    }
    if (std::string_view("PROCG").find(first) != std::string_view::npos) {
      std::string const text = take(1);
      return noted(make(Node::compound, {{text, type()}}));
    }
    if (std::string_view("vwbcahstijlmxynofdegz").find(first) != std::string_view::npos) return word(take(1));
    if (first == 'F') return noted(function(""));
    if (first == 'A') return noted(array());
    if (first == 'M') {
      expect("M");
      Node const *of = type();
      return noted(make(Node::compound, {{"M", of}, {"", type()}}));
    }
    if (first == 'D') return of_d();
    if (first == 'S' && next(1) != 't') {
      Node const *known = substitution();
      return next() == 'I' ? noted(arguments(known)) : known;
    }
    if (first == 'T') {
      Node const *parameter = noted(make(Node::compound, {{numbered(1)}}));
      return next() == 'I' ? noted(arguments(parameter)) : parameter;
    }
    return noted(read_name());
  }

  Node const *of_d() {
    if (text_.starts_with("Do")) return noted(function(""));
    if (skip("Dp")) return noted(make(Node::compound, {{"Dp", type()}}));
    if (text_.starts_with("Dv")) {
      std::string const length = numbered(2);
      return noted(make(Node::compound, {{length, type()}}));
    }
    if (std::string_view("nacisuefdh").find(next(1)) == std::string_view::npos) throw Unread();
    return word(take(2));
  }
  // Parses so many letters, an optional number, and an underscore: T_, T0_, ...
  std::string numbered(std::size_t letters) {
    std::string text = take(letters);
    text += take_while(digits);
    expect("_");
    return text + "_";
  }
  Node const *function(std::string opening) {
    if (skip("Do")) opening += "Do";
    expect("F");
    opening += "F";
    if (skip("Y")) opening += "Y";
    Pieces pieces = {{opening}};
    while (next() != 'E' && !(next(1) == 'E' && (next() == 'R' || next() == 'O'))) pieces.push_back({"", type()});
    pieces.push_back({next() == 'E' ? take(1) : take(2)});
    return make(Node::compound, std::move(pieces));
  }
  Node const *array() {
    std::string const length = numbered(1);
    return make(Node::compound, {{length, type()}});
  }
  // S_, S0_, ...; Sa, Ss and their like
  Node const *substitution() {
    expect("S");
    if (std::islower(static_cast<unsigned char>(next()))) return word("S" + take(1));
    std::string const number = take_while(digits_36);
    expect("_");
    std::size_t index = 0;
    for (char const digit : number) index = index * digits_36.size() + digits_36.find(digit);
    if (!number.empty()) ++index;
    if (index >= known_.size()) throw Unread();
    return known_[index];
  }
  Node const *arguments(Node const *of) {
    expect("I");
    Pieces pieces = {{"I"}};
    for (unsigned depth = 1; depth > 0;) {
      if (skip("E")) {
        --depth;
        pieces.push_back({"E"});
      } else if (skip("J")) {
        ++depth;
        pieces.push_back({"J"});
      } else if (next() == 'L') {
        literal(pieces);
      } else if (skip("Xad")) { // an address
        pieces.push_back({"Xad"});
        literal(pieces);
        expect("E");
        pieces.push_back({"E"});
      } else {
        pieces.push_back({"", type()});
      }
    }
    return within(of, std::move(pieces), /*is_arguments=*/true);
  }
  void literal(Pieces &pieces) {
    expect("L");
    pieces.push_back({"L"});
    if (skip("_Z")) {
      pieces.push_back({"_Z"});
      encoding(pieces);
    } else {
      pieces.push_back({"", type()});
      pieces.push_back({take(std::min(text_.find('E'), text_.size()))});
    }
    expect("E");
    pieces.push_back({"E"});
  }

  // The name of a class, or of a function, which cannot be substituted by itself.
  Node const *read_name() {
    if (next() == 'N') return nested();
    if (next() == 'Z') return local();
    Node const *scope = skip("St") ? word("St") : nullptr;
    Node const *name = component(scope);
    return next() == 'I' ? arguments(noted(name)) : name;
  }
  Node const *nested() {
    expect("N");
    std::string const qualifiers = take_while("rVKRO");
    if (!qualifiers.empty() && !in_encoding_) throw Unread();
    Node const *name = nullptr;
    bool is_known = true; // or cannot be substituted
    while (next() != 'E') {
      if (name && !is_known) noted(name);
      is_known = false;
      if (next() == 'I' && name)
        name = arguments(name);
      else if (next() == 'S' && !name) {
        name = skip("St") ? word("St") : substitution();
        is_known = true;
      } else if (next() == 'T' && !name)
        name = make(Node::compound, {{numbered(1)}});
      else if (next() == 'Z' && !name)
        name = local();
      else
        name = component(name);
    }
    expect("E");
    if (!name || is_known) throw Unread();
    qualifiers_ = qualifiers;
    return name;
  }
  Node const *component(Node const *scope) {
    std::string text = take_while("L");
    if (text.size() > 1) throw Unread();
    Pieces pieces;
    if (std::isdigit(static_cast<unsigned char>(next()))) {
      text += source_name();
    } else if (skip("Ut")) {
      text += "Ut" + numbered(0);
    } else if (skip("cv")) {
      pieces.push_back({text + "cv", type()});
      text.clear();
    } else if (std::islower(static_cast<unsigned char>(next())) && std::isalpha(static_cast<unsigned char>(next(1)))) {
      text += take(2);
      if (text.ends_with("li")) text += source_name();
    } else if ((next() == 'C' || next() == 'D') && std::isdigit(static_cast<unsigned char>(next(1)))) {
      text += take(2);
    } else {
      throw Unread();
    }
    while (skip("B")) text += "B" + source_name();
    pieces.push_back({text});
    return within(scope, std::move(pieces), /*is_arguments=*/false);
  }
  std::string source_name() {
    std::string const length = take_while(digits);
    constexpr std::size_t most = 6;
    if (length.empty() || length.size() > most) throw Unread();
    std::string const name = take(std::stoul(length));
    if (name.starts_with('$')) throw Unread(); // clang's name of a lambda
    return length + name;
  }
  // An entity of a function: Z encoding E name, with a number where there are several.
  Node const *local() {
    expect("Z");
    Pieces pieces = {{"Z"}};
    encoding(pieces);
    expect("E");
    pieces.push_back({"E"});
    if (next() == 'N' || next() == 'Z') throw Unread(); // a class within the local one
    Node const *name = component(nullptr);
    if (next() == 'I') throw Unread();
    pieces.insert(pieces.end(), name->pieces.begin(), name->pieces.end());
    if (text_.starts_with("__"))
      pieces.push_back({numbered(2)});
    else if (next() == '_')
      pieces.push_back({take(2)});
    return make(Node::compound, std::move(pieces));
  }
  // The name of a function, and the types of its parameters.
  void encoding(Pieces &pieces) {
    bool const outer = std::exchange(in_encoding_, true);
    qualifiers_.clear();
    Node const *name = read_name();
    in_encoding_ = outer;
    if (name->kind == Node::name) // printed without being noted
      name = &nodes_.emplace_back(Node{Node::word, {{qualifiers_, name}}, nullptr, false, qualifiers_ + name->key});
    pieces.push_back({"", name});
    while (next() != 'E' && next() != '\0') pieces.push_back({"", type()});
  }

  std::string_view text_;
  std::deque<Node> nodes_;
  std::vector<Node const *> known_;
  bool is_replaced_ = false; // the last node
  bool in_encoding_ = false;
  std::string qualifiers_; // of a member function
};

class Printer {
public:
  std::string text;

  void type(Node const *node) {
    if (node->kind == Node::word) return word(node);
    if (substituted(node)) return;
    if (node->kind == Node::name) {
      bool const is_nested = needs_scope(node);
      if (is_nested) text += 'N';
      prefix(node);
      if (is_nested) text += 'E';
      return;
    }
    print(node->pieces);
    known_.push_back(node->key);
  }

private:
  void print(Pieces const &pieces) {
    for (Piece const &piece : pieces) {
      text += piece.text;
      if (piece.node) type(piece.node);
    }
  }
  void word(Node const *node) {
    Piece const &piece = node->pieces.front();
    if (!piece.node) return print(node->pieces);
    Node const *function = piece.node;
    bool const is_nested = needs_scope(function);
    if (is_nested) text += 'N' + piece.text;
    if (function->scope) prefix(function->scope);
    print(function->pieces);
    if (is_nested) text += 'E';
  }
  void prefix(Node const *node) {
    if (node->kind != Node::name) return type(node);
    if (substituted(node)) return;
    if (node->scope) prefix(node->scope);
    print(node->pieces);
    known_.push_back(node->key);
  }
  static bool needs_scope(Node const *name) {
    while (name->is_arguments && name->scope) name = name->scope;
    return name->kind == Node::name && name->scope && name->scope->key != "St";
  }
  bool substituted(Node const *node) {
    auto const at = std::find(known_.begin(), known_.end(), node->key);
    if (at == known_.end()) return false;
    text += 'S' + number(static_cast<std::size_t>(at - known_.begin())) + '_';
    return true;
  }
  // Sequence id of a substitution: empty for the first, else base 36.
  static std::string number(std::size_t index) {
    if (index == 0) return "";
    std::string digits;
    constexpr std::size_t base = 36;
    for (std::size_t rest = index - 1; digits.empty() || rest > 0; rest /= base)
      digits.insert(digits.begin(), "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"[rest % base]);
    return digits;
  }

  std::vector<std::string> known_;
};

bool is_of_numbers(char const *name) { return std::strstr(name, "7symreal5types") != nullptr; }

// Lambdas are numbered, and the symbolic program has more of them than the original. Clang has "$_0" as well.
bool is_of_lambda(char const *name) {
  return std::strstr(name, "EUl") || std::strstr(name, "_Ul") || std::strstr(name, "$_");
}

// The name is shorter than the one that stands there.
bool overwrite(char const *there, std::string const &name) {
  std::size_t const size = std::strlen(there) + 1;
  if (name.size() >= size || !make_writable(there, size)) return false;
  std::memcpy(const_cast<char *>(there), name.c_str(), name.size() + 1);
  return true;
}

} // namespace

std::optional<std::string> original_type_name(std::string_view mangled) {
  try {
    Reader reader(mangled);
    Printer printer;
    printer.type(reader.whole());
    return printer.text;
  } catch (Unread const &) {
    return std::nullopt;
  }
}

} // namespace trace

namespace detail {

using trace::Pause;

// `place`: of the request for its name, hash or order; null for a mere comparison.
void give_name(char const *mangled, char const *place) noexcept {
  bool const reports = place && recording, is_ours = trace::is_of_numbers(mangled);
  if (!is_ours && !(reports && trace::is_of_lambda(mangled))) return;
  Pause const pause;
  std::optional<std::string> const original = is_ours ? trace::original_type_name(mangled) : std::nullopt;
  if (original && trace::overwrite(mangled, *original)) return;
  if (reports && trace::session().type_names.reported.insert(place).second)
    trace::report({DiagnosticId::type_name, trace::written_place(place),
                   "the name, hash or order is asked for of a type that has another name in the original"});
}

std::type_info const &named(std::type_info const &type, char const *place) noexcept {
  give_name(type.name(), place);
  return type;
}

char const *named(char const *text) noexcept {
  if (!text || !std::strstr(text, "symreal::")) return text;
  Pause const pause;
  std::string name(text);
  name.resize(original_name(text, name.data()));
  return trace::session().type_names.texts.insert(name).first->c_str();
}

} // namespace detail

} // namespace symreal
