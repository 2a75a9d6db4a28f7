// Text of symbolic values. It says what this run carries, so it may leave the program, and what is read back is an
// error at its place: characters, strings, files, lengths. The rewriter puts Format in the place of the functions that
// make text, and symreal_text(...) around what is read.
#pragma once

#include <symreal/real_number.h>
#include <symreal/standard_templates.h>

#ifndef SYMREAL_SOURCE_OF_C
#include <charconv>
#endif
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace symreal {

namespace detail {

extern __thread bool recording; // as in state.h
// True if the kernel has made text of a symbolic value that it could read back.
extern __thread bool has_text;

// The number whose carried value was last taken as text, 0 if none, and the stack address of that use.
struct Shown {
  std::uint64_t number = 0;
  std::uintptr_t frame = 0;
};
extern __thread Shown shown;

// Notes that text was made. `used_at`: the place that uses its length, or null.
void made_text(char const *text, std::size_t size, Shown value, char const *used_at) noexcept;
void made_file(std::FILE *file, Shown value) noexcept;
void made_length(Shown value, char const *used_at) noexcept;

// The text that a va_list prints with the carried values of its numbers, and the symbolic value among them.
class ListText {
public:
  ListText(char const *format, std::va_list list) {
    if (recording) print(format, list);
  }
  ListText(ListText const &) = delete;
  ListText &operator=(ListText const &) = delete;
  ~ListText() { ::operator delete(text_); }
  explicit operator bool() const noexcept { return value_.number != 0; }
  Shown value() const noexcept { return value_; }
  char const *text() const noexcept { return text_; }
  std::size_t size() const noexcept { return size_; }
  int length() const noexcept { return static_cast<int>(size_); }
  int copy(char *to, std::size_t size) const noexcept {
    if (size == 0) return length();
    std::size_t const copied = size_ < size ? size_ : size - 1;
    std::memcpy(to, text_, copied);
    to[copied] = '\0';
    return length();
  }

private:
  void print(char const *format, std::va_list list);

  char *text_ = nullptr;
  std::size_t size_ = 0;
  Shown value_;
};
// The symbolic value that the text, or a part of it, shows, if any.
Shown value_in(char const *text, std::size_t size) noexcept;

// Notes that text of x, if symbolic, went into a string or a stream.
void made_string(char const *text, std::size_t size, RealNumber x) noexcept;
void made_stream(std::ios const &stream, long long integer, RealNumber x) noexcept;
// Such text, as it is printed.
void made_printed(RealNumber x, char const *format, ...) noexcept;
void made_list(RealNumber x, char const *format, std::va_list list) noexcept;

void read_character(char const *character, char const *name, char const *place) noexcept;
void read_text(char const *text, std::size_t size, char const *name, char const *place) noexcept;
void read_file(std::FILE *file, char const *name, char const *place) noexcept;
void read_stream(std::ios const &stream, char const *name, char const *place) noexcept;

template <class T> inline constexpr bool is_text_character =
    std::is_integral_v<T> && sizeof(T) == 1 && !std::is_same_v<std::remove_cv_t<T>, bool>;

// The type is incomplete until the program includes <string_view>, or <string>; nothing converts to it then.
using StringView = std::basic_string_view<char, std::char_traits<char>>;
template <class T> inline constexpr bool is_string =
    std::is_class_v<T> && requires(T &text, void (&take)(StringView)) { take(text); };

template <class T> char const *characters(T *text) noexcept {
  return reinterpret_cast<char const *>(const_cast<std::remove_cv_t<T> *>(text));
}

template <class T> Shown value_of(T const &object) noexcept {
  if constexpr (std::is_pointer_v<T>)
    if constexpr (is_text_character<std::remove_pointer_t<T>>)
      if (has_text && object) return value_in(characters(object), std::strlen(characters(object)));
  return {};
}

template <class View> void read_view(View const view, char const *name, char const *place) noexcept {
  read_text(view.data(), view.size(), name, place);
}

template <class T> void look_at(T &object, char const *name, char const *place) noexcept {
  using Plain = std::remove_cv_t<T>;
  if constexpr (std::is_array_v<T>) {
    if constexpr (is_text_character<std::remove_extent_t<T>>)
      read_text(characters(&object[0]), std::strlen(characters(&object[0])), name, place);
  } else if constexpr (std::is_same_v<Plain, std::FILE *>) {
    if (object) read_file(object, name, place);
  } else if constexpr (std::is_pointer_v<Plain>) {
    using Pointee = std::remove_pointer_t<Plain>;
    if constexpr (is_text_character<Pointee>) {
      if (object) read_text(characters(object), std::strlen(characters(object)), name, place);
    } else if constexpr (is_string<Pointee> || std::is_convertible_v<Pointee *, std::ios const *>) {
      if (object) look_at(*object, name, place);
    }
  } else if constexpr (is_text_character<Plain>) {
    read_character(characters(&object), name, place);
  } else if constexpr (std::is_convertible_v<T &, std::ios const &>) {
    read_stream(object, name, place);
  } else if constexpr (is_string<T>) {
    read_view<StringView>(object, name, place);
  }
}

} // namespace detail

// Something is read that may hold text. Without a name: characters of it may be read later.
// A temporary string is returned by value, so that it outlives the loop that runs over it.
template <class T> constexpr std::conditional_t<detail::is_string<T>, T, T &&>
symreal_text(T &&object, char const *name, char const *place) {
  if (!__builtin_is_constant_evaluated() && detail::recording && detail::has_text) detail::look_at(object, name, place);
  return static_cast<T &&>(object);
}

// While a function is given carried values as text, until the end of the whole expression. `first`: the host compiler
// computes arguments before it looks at what is called, as in C, so that they have been taken already.
class Shows {
public:
  explicit Shows(bool first) noexcept : before_(detail::shown) {
    if (first && !is_outer())
      before_ = {};
    else
      detail::shown = {};
  }
  ~Shows() { detail::shown = before_; }
  Shows(Shows const &) = delete;
  Shows &operator=(Shows const &) = delete;

  // True if the values shown before are arguments of an enclosing call.
  bool is_outer() const noexcept { return before_.frame > reinterpret_cast<std::uintptr_t>(this); }
  detail::Shown before() const noexcept { return before_; }

private:
  detail::Shown before_;
};

// Replacements for functions that make or move text.
class Format {
public:
  Format(bool is_used, char const *place, bool first) noexcept : place_(is_used ? place : nullptr), shows_(first) {}

  template <class... T> int symreal_print_sprintf(char *to, char const *format, T... values) const {
    return made(to, std::sprintf(to, format, values...), value(values...));
  }
  template <class... T> int symreal_print_snprintf(char *to, std::size_t size, char const *format, T... values) const {
    return made(to, size, std::snprintf(to, size, format, values...), value(values...));
  }
  int symreal_print_vsprintf(char *to, char const *format, std::va_list list) const {
    if (detail::ListText const list_text(format, list); list_text)
      return made(to, list_text.copy(to, list_text.size() + 1), list_text.value());
    return made(to, std::vsprintf(to, format, list), listed());
  }
  int symreal_print_vsnprintf(char *to, std::size_t size, char const *format, std::va_list list) const {
    if (detail::ListText const list_text(format, list); list_text)
      return made(to, size, list_text.copy(to, size), list_text.value());
    return made(to, size, std::vsnprintf(to, size, format, list), listed());
  }
#ifdef __GLIBC__
  template <class... T> int symreal_print_asprintf(char **to, char const *format, T... values) const {
    int const length = ::asprintf(to, format, values...);
    return made(*to, length, value(values...));
  }
  int symreal_print_vasprintf(char **to, char const *format, std::va_list list) const {
    if (detail::ListText const list_text(format, list); list_text) {
      *to = static_cast<char *>(std::malloc(list_text.size() + 1));
      return *to ? made(*to, list_text.copy(*to, list_text.size() + 1), list_text.value()) : -1;
    }
    int const length = ::vasprintf(to, format, list);
    return made(*to, length, listed());
  }
  template <class... T> int symreal_print_dprintf(int file, char const *format, T... values) const {
    return written(said(value(values...), format, values...), ::dprintf(file, format, values...));
  }
  int symreal_print_vdprintf(int file, char const *format, std::va_list list) const {
    if (detail::ListText const list_text(format, list); list_text) {
      detail::made_string(list_text.text(), list_text.size(), RealNumber::from_bits(list_text.value().number));
      return written(list_text.value(), ::dprintf(file, "%s", list_text.text()));
    }
    said_list(format, list);
    return written(listed(), ::vdprintf(file, format, list));
  }
  char *symreal_print_gcvt(double number, int digits, char *to) const {
    ::gcvt(number, digits, to);
    return copied(to, to, detail::shown);
  }
#endif
#ifndef SYMREAL_SOURCE_OF_C
  template <class... T> std::to_chars_result symreal_print_to_chars(char *first, char *last, T... values) const {
    std::to_chars_result const result = std::to_chars(first, last, values...);
    made(first, static_cast<int>(result.ptr - first), detail::shown);
    return result;
  }
#endif

  template <class... T> int symreal_print_printf(char const *format, T... values) const {
    return written(value(values...), std::printf(format, values...));
  }
  int symreal_print_vprintf(char const *format, std::va_list list) const {
    if (detail::ListText const list_text(format, list); list_text) return put(list_text, stdout);
    return written(listed(), std::vprintf(format, list));
  }
  template <class... T> int symreal_print_fprintf(std::FILE *file, char const *format, T... values) const {
    if (is_file(file)) detail::made_file(file, said(value(values...), format, values...));
    return written(value(values...), std::fprintf(file, format, values...));
  }
  int symreal_print_vfprintf(std::FILE *file, char const *format, std::va_list list) const {
    if (detail::ListText const list_text(format, list); list_text) {
      if (is_file(file)) {
        detail::made_string(list_text.text(), list_text.size(), RealNumber::from_bits(list_text.value().number));
        detail::made_file(file, list_text.value());
      }
      return put(list_text, file);
    }
    if (is_file(file)) {
      said_list(format, list);
      detail::made_file(file, listed());
    }
    return written(listed(), std::vfprintf(file, format, list));
  }
  int symreal_print_fputs(char const *text, std::FILE *file) const {
    if (is_file(file)) detail::made_file(file, value(text));
    return std::fputs(text, file);
  }
  template <class T>
  std::size_t symreal_print_fwrite(T const *from, std::size_t size, std::size_t count, std::FILE *file) const {
    if constexpr (detail::is_text_character<T>)
      if (is_file(file) && detail::has_text)
        detail::made_file(file, detail::value_in(detail::characters(from), size * count));
    return std::fwrite(from, size, count, file);
  }

  char *symreal_print_strcpy(char *to, char const *from) const {
    return copied(std::strcpy(to, from), to, value(from));
  }
  char *symreal_print_strncpy(char *to, char const *from, std::size_t size) const {
    std::strncpy(to, from, size);
    if (detail::recording && value(from).number) detail::made_text(to, size, value(from), nullptr);
    return to;
  }
  char *symreal_print_strcat(char *to, char const *from) const {
    return copied(std::strcat(to, from), to, value(from));
  }
  char *symreal_print_strncat(char *to, char const *from, std::size_t size) const {
    return copied(std::strncat(to, from, size), to, value(from));
  }
#ifdef __GLIBC__
  char *symreal_print_stpcpy(char *to, char const *from) const {
    char *const end = ::stpcpy(to, from);
    copied(to, to, value(from));
    return end;
  }
  char *symreal_print_strdup(char const *from) const {
    char *const copy = ::strdup(from);
    return copy ? copied(copy, copy, value(from)) : copy;
  }
#endif

private:
  // The symbolic value among the arguments: a number taken as text, or text of one.
  template <class... T> static detail::Shown value(T... values) noexcept {
    detail::Shown found = detail::shown;
    if (detail::recording && detail::has_text) ((found = found.number ? found : detail::value_of(values)), ...);
    return found;
  }
  // The value shown before, if the arguments belong to an enclosing call.
  detail::Shown listed() const noexcept { return shows_.is_outer() ? shows_.before() : detail::Shown{}; }

  int made(char *to, int length, detail::Shown value) const noexcept {
    if (detail::recording && value.number && length >= 0)
      detail::made_text(to, static_cast<std::size_t>(length), value, place_);
    return length;
  }
  int made(char *to, std::size_t size, int length, detail::Shown value) const noexcept {
    if (!detail::recording || !value.number || length < 0) return length;
    if (to && size > 0)
      detail::made_text(to, std::strlen(to), value, place_);
    else
      detail::made_length(value, place_);
    return length;
  }
  char *copied(char *result, char const *to, detail::Shown value) const noexcept {
    if (detail::recording && value.number) detail::made_text(to, std::strlen(to), value, nullptr);
    return result;
  }
  int written(detail::Shown value, int length) const noexcept {
    if (detail::recording && value.number) detail::made_length(value, place_);
    return length;
  }

  int put(detail::ListText const &list, std::FILE *file) const {
    bool const is_all = std::fwrite(list.text(), 1, list.size(), file) == list.size();
    return written(list.value(), is_all ? list.length() : -1);
  }

  // True for text that goes to a file while recording: it may be read back by other means.
  static bool is_file(std::FILE *file) noexcept { return detail::recording && file != stdout && file != stderr; }
  template <class... T> static detail::Shown said(detail::Shown value, char const *format, T... values) {
    if (detail::recording && value.number) detail::made_printed(RealNumber::from_bits(value.number), format, values...);
    return value;
  }
  void said_list(char const *format, std::va_list list) const {
    if (detail::recording && listed().number) detail::made_list(RealNumber::from_bits(listed().number), format, list);
  }

  char const *place_; // place that uses the length
  Shows shows_;
};

} // namespace symreal
