// The text of a list of arguments in which symbolic values stand for numbers: a function of the library would print the
// bytes of their nodes.
#include "engine/support/mutation/is_dropped.h"

#include <symreal/standard_library.h>
#include <symreal/text.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <cwchar>
#include <optional>
#include <string>
#include <vector>

namespace symreal::detail {

namespace {

enum class Kind {
  none,
  integer,
  long_integer,
  long_long,
  size,
  difference,
  maximum,
  wide,
  number,
  long_number,
  pointer
};

struct Argument {
  Kind kind = Kind::none;
  long long integer = 0;
  RealNumber number;
  long double long_number = 0;
  void *pointer = nullptr;
};

// `%` with all that belongs to it. Positions count from 0.
struct Directive {
  std::string before; // text in front of it
  std::string flags;
  std::string size; // hh, l, ...
  std::string width, precision;
  bool has_precision = false;
  std::optional<std::size_t> width_at, precision_at, argument_at;
  char conversion = 0; // 0: the end of the text
};

Kind kind_of(Directive const &directive) {
  switch (directive.conversion) {
  case 'd':
  case 'i':
  case 'o':
  case 'u':
  case 'x':
  case 'X':
  case 'b':
  case 'B':
    if (directive.size == "l") return Kind::long_integer;
    if (directive.size == "ll" || directive.size == "q" || directive.size == "L") return Kind::long_long;
    if (directive.size == "z") return Kind::size;
    if (directive.size == "t") return Kind::difference;
    if (directive.size == "j") return Kind::maximum;
    return Kind::integer;
  case 'c': return directive.size == "l" ? Kind::wide : Kind::integer;
  case 'C': return Kind::wide;
  case 'a':
  case 'A':
  case 'e':
  case 'E':
  case 'f':
  case 'F':
  case 'g':
  case 'G': return directive.size == "L" ? Kind::long_number : Kind::number;
  case 's':
  case 'S':
  case 'p':
  case 'n': return Kind::pointer;
  default: return Kind::none; // % and m take no argument
  }
}

class Parser {
public:
  explicit Parser(char const *format) : at_(format) {}

  std::vector<Argument> arguments; // of the kinds that the format asks for
  std::vector<Directive> directives;

  // False: the format has something in it that is not known here.
  bool parse() {
    while (directives.empty() || directives.back().conversion)
      if (!directive()) return false;
    return true;
  }

private:
  bool directive() {
    Directive &one = directives.emplace_back();
    for (; *at_ && *at_ != '%'; ++at_) one.before += *at_;
    if (!*at_) return true;
    ++at_;
    std::optional<std::size_t> const position = positioned();
    for (; *at_ && std::strchr("-+ #0'I", *at_); ++at_) one.flags += *at_;
    one.width_at = number(one.width);
    if (*at_ == '.') {
      ++at_;
      one.has_precision = true;
      one.precision_at = number(one.precision);
    }
    for (; *at_ && std::strchr("hlLqjzt", *at_); ++at_) one.size += *at_;
    one.conversion = *at_;
    if (!*at_ || !std::strchr("diouxXbBcCaAeEfFgGsSpnm%", *at_)) return false;
    ++at_;
    if (Kind const kind = kind_of(one); kind != Kind::none) one.argument_at = argument(kind, position);
    return true;
  }

  // `2$`
  std::optional<std::size_t> positioned() {
    char *end = nullptr;
    unsigned long const position = *at_ >= '1' && *at_ <= '9' ? std::strtoul(at_, &end, 10) : 0;
    if (position == 0 || *end != '$') return std::nullopt;
    at_ = end + 1;
    return position - 1;
  }
  // A width or precision: its digits, or the argument that has it.
  std::optional<std::size_t> number(std::string &digits) {
    if (*at_ == '*') {
      ++at_;
      return argument(Kind::integer, positioned());
    }
    for (; *at_ >= '0' && *at_ <= '9'; ++at_) digits += *at_;
    return std::nullopt;
  }
  std::size_t argument(Kind kind, std::optional<std::size_t> position) {
    std::size_t const at = position ? *position : next_++;
    if (arguments.size() <= at) arguments.resize(at + 1);
    arguments[at].kind = kind;
    return at;
  }

  char const *at_;
  std::size_t next_ = 0;
};

void read(Argument &argument, std::va_list &list) {
  switch (argument.kind) {
  case Kind::none:
  case Kind::integer: argument.integer = va_arg(list, int); break;
  case Kind::long_integer: argument.integer = va_arg(list, long); break;
  case Kind::long_long: argument.integer = va_arg(list, long long); break;
  case Kind::size: argument.integer = static_cast<long long>(va_arg(list, std::size_t)); break;
  case Kind::difference: argument.integer = va_arg(list, std::ptrdiff_t); break;
  case Kind::maximum: argument.integer = va_arg(list, std::intmax_t); break;
  case Kind::wide: argument.integer = va_arg(list, std::wint_t); break;
  case Kind::number: argument.number = va_arg(list, RealNumber); break;
  case Kind::long_number: argument.long_number = va_arg(list, long double); break;
  case Kind::pointer: argument.pointer = va_arg(list, void *); break;
  }
}

class Printer {
public:
  Printer(Parser const &format, std::string &text) : format_(format), text_(text), error_(errno) {}

  void print() {
    for (Directive const &one : format_.directives) {
      text_ += one.before;
      if (one.conversion == '%')
        text_ += '%';
      else if (one.conversion)
        print(one);
    }
  }

private:
  void print(Directive const &one) {
    std::string specification = "%" + one.flags + (one.width_at ? decimal(*one.width_at) : one.width);
    bool const is_left_out = one.precision_at && integer(*one.precision_at) < 0;
    if (one.has_precision && !is_left_out)
      specification += "." + (one.precision_at ? decimal(*one.precision_at) : one.precision);
    specification += one.size + one.conversion;
    char const *const words = specification.c_str();
    if (!one.argument_at) {
      errno = error_;
      return add(words, 0); // %m
    }
    Argument const &argument = format_.arguments[*one.argument_at];
    if (one.conversion == 'n') return count(one.size, argument.pointer);
    switch (argument.kind) {
    case Kind::none:
    case Kind::integer: return add(words, static_cast<int>(argument.integer));
    case Kind::long_integer: return add(words, static_cast<long>(argument.integer));
    case Kind::long_long: return add(words, argument.integer);
    case Kind::size: return add(words, static_cast<std::size_t>(argument.integer));
    case Kind::difference: return add(words, static_cast<std::ptrdiff_t>(argument.integer));
    case Kind::maximum: return add(words, static_cast<std::intmax_t>(argument.integer));
    case Kind::wide: return add(words, static_cast<std::wint_t>(argument.integer));
    case Kind::number: {
      RealNumber const number = argument.number;
      return add(words, number.is_node() ? shown_value(number) : number.plain());
    }
    case Kind::long_number: return add(words, argument.long_number);
    case Kind::pointer: return add(words, argument.pointer);
    }
  }

  int integer(std::size_t at) const { return static_cast<int>(format_.arguments[at].integer); }
  std::string decimal(std::size_t at) const { return std::to_string(integer(at)); }

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
#pragma GCC diagnostic ignored "-Wformat-security"
  template <class T> void add(char const *specification, T value) {
    int const length = std::snprintf(nullptr, 0, specification, value);
    if (length < 0) return;
    std::size_t const before = text_.size();
    text_.resize(before + static_cast<std::size_t>(length) + 1);
    std::snprintf(text_.data() + before, static_cast<std::size_t>(length) + 1, specification, value);
    text_.pop_back();
  }
#pragma GCC diagnostic pop

  void count(std::string const &size, void *to) const {
    if (size == "hh")
      *static_cast<signed char *>(to) = static_cast<signed char>(text_.size());
    else if (size == "h")
      *static_cast<short *>(to) = static_cast<short>(text_.size());
    else if (size.empty())
      *static_cast<int *>(to) = static_cast<int>(text_.size());
    else
      *static_cast<long *>(to) = static_cast<long>(text_.size());
  }

  Parser const &format_;
  std::string &text_;
  int const error_;
};

} // namespace

void ListText::print(char const *format, std::va_list list) {
  Parser parser(format);
  if (!parser.parse() || is_dropped("list_text")) return;
  std::va_list copy;
  va_copy(copy, list);
  for (Argument &argument : parser.arguments) read(argument, copy);
  va_end(copy);
  for (Argument const &argument : parser.arguments)
    if (argument.number.is_node() && value_.number == 0) value_.number = argument.number.to_bits();
  if (value_.number == 0) return;
  std::string text;
  Printer(parser, text).print();
  size_ = text.size();
  text_ = static_cast<char *>(::operator new(size_ + 1));
  std::memcpy(text_, text.c_str(), size_ + 1);
}

} // namespace symreal::detail
