// Hidden state: what a kernel reads or changes through members, pointers, references and names of static storage. The
// rewriter wraps such uses; while a kernel is recorded each address is judged once.
//
// An address is the kernel's own if it lies on the stack below the frame in which the kernel began or in a heap block
// that was allocated since, or if the kernel wrote it before reading it. Any other number or scalar that it reads is
// baked in, unless it is annotated; any other number that it leaves with a node in it, and any other scalar that it
// changes, is state that is no output.
#pragma once

#include <symreal/annotate.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

namespace symreal {

namespace detail {

extern __thread bool recording;
// The stack of the kernel itself.
extern __thread std::uintptr_t own_stack, own_stack_size;

inline bool on_own_stack(void const *address) noexcept {
  return reinterpret_cast<std::uintptr_t>(address) - own_stack < own_stack_size;
}

// The locals of the function in which a block kernel begins, or none: they lie on this stack and outlive the kernel.
extern __thread std::uintptr_t around_begin, around_size;
bool is_around(void const *address) noexcept;

inline bool is_own(void const *address) noexcept {
  bool const may_be_around = reinterpret_cast<std::uintptr_t>(address) - around_begin < around_size;
  return on_own_stack(address) && !(may_be_around && is_around(address));
}

// Who can name the object: anybody; one function; one that writes it before it reads it on every path; the one around a
// block kernel, whose locals may be changed; the kernel itself, of its parameters, which may lie with the caller.
enum class Scope { any, function, scratch, around, parameter };
void note_static(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept;
void note_local(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept;
// A pointer to an object: state where it leads nowhere, or to constant memory. What lies behind it is looked at itself,
// unless it is text.
enum class Behind { text, objects };
void note_pointer_read(void const *pointer, Behind what, char const *name, char const *place) noexcept;
// The pointers in these bytes were chosen by others than the kernel: constants behind them are read like what lies in
// other memory.
void note_chosen(void const *begin, std::size_t size) noexcept;
void note_scalar_written(ScalarObject scalar, char const *name, char const *place) noexcept;
void note_written(void const *begin, std::size_t size, char const *name, char const *place) noexcept;
// The object outlives this statement: if it still exists when the kernel ends, its numbers are looked at again.
void note_changed(void const *object, Visit visit, char const *name, char const *place) noexcept;
// The number of the object's elements is used, for which elements that are annotated vouch. False where the kernel has
// made them itself.
bool note_counted(void const *object, Visit visit) noexcept;
// Bytes that are used as something else than numbers: an error where a node is among them.
void check_bits(void const *begin, std::size_t size, char const *name, char const *place) noexcept;
// The same, for all that may lie behind a pointer.
void check_view(void const *begin, char const *name, char const *place) noexcept;
// Bits of an object are about to get new values. If they are not all of a symbolic number, what is left of that is an
// error where it is used, and in an object that holds a number and nothing else in any case.
enum class Holds { anything, number };
void note_bits_stored(void const *begin, std::size_t first, std::size_t count, Holds holds, char const *name,
                      char const *place) noexcept;
// Whether there are any such numbers, and that they are used.
extern __thread bool any_torn;
void note_number_used(void const *begin, std::size_t size, char const *name, char const *place) noexcept;
// Bits that are used as something else than numbers.
void check_part(void const *begin, std::size_t first, std::size_t count, char const *name, char const *place) noexcept;
// The ends of a range come in any order; the second to come gets the other.
void const *other_range_end(void const *end, bool is_last, char const *place) noexcept;

inline void const *bytes_of(void const volatile *object) noexcept { return const_cast<void const *>(object); }

// What to do with each part of an object that is read.
struct ReadParts {
  char const *name, *place;
  void operator()(RealNumber const *number) const noexcept {
    if (!is_own(number)) note_read(number, name, place);
  }
  void operator()(ScalarObject scalar) const noexcept {
    if (scalar.kind == ScalarObject::Kind::text || is_own(scalar.address)) return;
    if (scalar.kind == ScalarObject::Kind::target)
      note_chosen(scalar.address, scalar.size);
    else
      note_scalar_read(scalar, name, place);
  }
};
// A container of pointers, or a map to some.
template <class T>
concept HoldsPointers =
    requires { typename T::value_type; } && (std::is_pointer_v<typename T::value_type> ||
                                             requires(typename T::value_type const &pair) { pair.first, pair.second; });
struct Pointers {
  void operator()(RealNumber const *) const noexcept {}
  void operator()(ScalarObject scalar) const noexcept {
    if (scalar.kind == ScalarObject::Kind::target && !is_own(scalar.address)) note_chosen(scalar.address, scalar.size);
  }
};
struct WrittenParts {
  char const *name, *place;
  void operator()(RealNumber const *number) const noexcept {
    if (!is_own(number)) note_written(number, sizeof *number, name, place);
  }
  void operator()(ScalarObject scalar) const noexcept {
    if (!is_own(scalar.address)) note_scalar_written(scalar, name, place);
  }
};

template <class T> void read_object(T &object, char const *name, char const *place) noexcept {
  using Plain = std::remove_cv_t<T>;
  if constexpr (std::is_same_v<Plain, RealNumber>) {
    ReadParts{name, place}(const_cast<Plain const *>(&object));
  } else if constexpr (is_scalar<Plain>) {
    ReadParts{name, place}(ScalarObject::of(object));
  } else if constexpr (std::is_pointer_v<Plain>) {
    constexpr bool to_text = is_text<std::remove_cv_t<std::remove_pointer_t<Plain>>>;
    if (!is_own(bytes_of(&object)))
      note_pointer_read(bytes_of(&object), to_text ? Behind::text : Behind::objects, name, place);
  } else if constexpr (is_smart_pointer<Plain>) {
    if (!is_own(bytes_of(&object))) note_pointer_read(bytes_of(&object), Behind::objects, name, place);
    auto read = [=](RealNumber const *number) { ReadParts{name, place}(number); };
    Numbers(read).visit(object);
  } else if constexpr (requires {
                         typename Plain::type;
                         object.get();
                       }) { // std::reference_wrapper
    if constexpr (!std::is_function_v<typename Plain::type>) read_object(object.get(), name, place);
  } else if constexpr (Numbers::may_hold<Plain>) {
    if constexpr (!std::is_same_v<std::remove_cv_t<std::remove_all_extents_t<Plain>>, RealNumber>)
      if (!is_own(&object)) note_chosen(&object, sizeof object); // a copy leads there as well
    ReadParts parts{name, place};
    Numbers(parts).visit(object);
    if constexpr (!std::is_const_v<T>)
      if (!is_own(&object)) note_changed(&object, visit<Plain>, name, place);
  }
}

// The first number or, if it has none, the first scalar that an object holds.
struct FirstPart {
  void const *number = nullptr, *scalar = nullptr;
  void operator()(RealNumber const *found) noexcept { number = number ? number : found; }
  void operator()(ScalarObject found) noexcept { scalar = scalar ? scalar : found.address; }
  void const *address() const noexcept { return number ? number : scalar; }
};

// What decides is the object itself: the text that it is, the object that a pointer leads to, how many elements there
// are. Elements that are annotated vouch for their number.
template <class T> void decided_by(T &object, char const *name, char const *place) noexcept {
  using Plain = std::remove_cv_t<T>;
  if (is_own(bytes_of(&object))) return;
  if constexpr (std::is_pointer_v<Plain> || is_smart_pointer<Plain>) {
    note_scalar_read({bytes_of(&object), sizeof(void *), ScalarObject::Kind::target}, name, place);
  } else {
    if constexpr (Numbers::may_hold<T> && !has_value_of_its_own<Plain>() && !std::is_array_v<Plain>)
      if (!note_counted(bytes_of(&object), visit<Plain>)) return;
    note_scalar_read({bytes_of(&object), 1, ScalarObject::Kind::object}, name, place);
  }
}

// A container's number of elements, and an object of which no part is known, may have got the same value as before: no
// byte shows that.
template <class T>
concept Counted = requires(T &object) { object.clear(), object.size(), object.begin(); } && !has_value_of_its_own<T>();
template <class T> void note_changed_object(T &object, char const *name, char const *place) noexcept {
  note_changed(&object, visit<T>, name, place);
  FirstPart first;
  if constexpr (!Counted<T>) Numbers(first).visit(object);
  if (!first.address()) note_scalar_written({&object, 1, ScalarObject::Kind::object}, name, place);
}

template <class T> void write_object(T &object, char const *name, char const *place) noexcept {
  using Plain = std::remove_cv_t<T>;
  if constexpr (std::is_same_v<Plain, RealNumber>) {
    WrittenParts{name, place}(const_cast<Plain *>(&object));
  } else if constexpr (is_scalar<Plain>) {
    WrittenParts{name, place}(ScalarObject::of(object));
  } else if constexpr (std::is_pointer_v<Plain>) {
    WrittenParts{name, place}({bytes_of(&object), sizeof(void *), ScalarObject::Kind::pointer});
  } else if constexpr (Numbers::may_hold<T>) {
    WrittenParts parts{name, place};
    Numbers(parts).visit(object);
    if (!is_own(&object)) note_changed_object(object, name, place);
  }
}

// Of a class that this source does not know yet, or never, only where it begins.
template <class T> constexpr std::size_t size_here() noexcept {
  if constexpr (requires { sizeof(T); })
    return sizeof(T);
  else
    return 1;
}

} // namespace detail

// A reference to an object of static storage duration: what is read of it later is called by its name.
template <class T> constexpr T &symreal_state(T &object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::note_static(detail::bytes_of(&object), detail::size_here<T>(), detail::Scope::any, name, place);
  return object;
}

// The same for one that is declared in a function: nobody else can read what is left in it.
template <class T> constexpr T &symreal_local_state(T &object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::note_static(detail::bytes_of(&object), detail::size_here<T>(), detail::Scope::function, name, place);
  return object;
}

// The same for one that the function writes before it reads it, on every path.
template <class T> constexpr T &symreal_scratch_state(T &object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::note_static(detail::bytes_of(&object), detail::size_here<T>(), detail::Scope::scratch, name, place);
  return object;
}

// A local of the function around a block kernel. A scalar among them was looked at by the rewriter: it is read.
template <class T> void symreal_around(T const &object, char const *name, char const *place) noexcept {
  if (!detail::recording) return;
  detail::note_local(detail::bytes_of(&object), sizeof object, detail::Scope::around, name, place);
  if constexpr (detail::is_scalar<T>) detail::note_scalar_read(ScalarObject::of(object), name, place);
}

// A parameter of the kernel, by value.
template <class T> void symreal_parameter(T const &object, char const *name, char const *place) noexcept {
  if (detail::recording)
    detail::note_local(detail::bytes_of(&reinterpret_cast<char const volatile &>(object)), sizeof object,
                       detail::Scope::parameter, name, place);
}

// The caller, or the code before a block kernel, chooses what this pointer leads to, or the pointers in this object.
template <class T> void symreal_argument_leads(T const &object) noexcept {
  if (!detail::recording) return;
  if constexpr (std::is_pointer_v<T>)
    detail::note_chosen(detail::bytes_of(&object), sizeof object);
  else if constexpr (detail::is_class<T> || std::is_class_v<T> || std::is_union_v<T>)
    detail::note_chosen(detail::bytes_of(&reinterpret_cast<char const volatile &>(object)), sizeof object);
}

// The same of an object of a library that the kernel has not made itself, and of a member that is a reference.
template <class T> constexpr T &&symreal_leads(T &&object) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) {
    void const *const at = detail::bytes_of(&reinterpret_cast<char const volatile &>(object));
    if (!detail::is_own(at)) detail::note_chosen(at, sizeof object);
    if constexpr (detail::HoldsPointers<std::remove_cvref_t<T>>) {
      detail::Pointers pointers;
      Numbers(pointers).visit(object);
    }
  }
  return static_cast<T &&>(object);
}
template <class T> constexpr T &&symreal_refers(void const volatile *holder, T &&object) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording && !detail::is_own(detail::bytes_of(holder))) {
    void const *const at = detail::bytes_of(&reinterpret_cast<char const volatile &>(object));
    detail::note_chosen(&at, sizeof at);
  }
  return static_cast<T &&>(object);
}

// No constant expression, so that what is noted within it is noted when the program runs.
template <class T> T &&symreal_at_run(T &&object) noexcept { return static_cast<T &&>(object); }

// The value of the object is used. What holds no number, and what a macro makes of the same words elsewhere, passes.
template <class T> constexpr T &&symreal_read(T &&object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::read_object(object, name, place);
  return static_cast<T &&>(object);
}

// What the kernel does next depends on it.
template <class T> constexpr T &&symreal_decides(T &&object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::decided_by(object, name, place);
  return static_cast<T &&>(object);
}

// The object gets a new value.
template <class T> constexpr T &&symreal_written(T &&object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::write_object(object, name, place);
  return static_cast<T &&>(object);
}

// Code that is not rewritten changes the object, as push_back does.
template <class T> T &symreal_changed(T &object, char const *name, char const *place) noexcept {
  if (detail::recording && !detail::is_own(&object))
    if constexpr (Numbers::may_hold<T>) detail::note_changed_object(object, name, place);
  return object;
}

// A library writes text, a scalar or an object there. Numbers are looked at otherwise.
template <class T> constexpr T &&symreal_target(T &&pointer, char const *name, char const *place) noexcept {
  if (__builtin_is_constant_evaluated() || !detail::recording) return static_cast<T &&>(pointer);
  auto *const target = &pointer[0];
  if (!pointer || detail::is_own(target)) return static_cast<T &&>(pointer);
  if constexpr (detail::is_text<std::remove_pointer_t<decltype(&pointer[0])>>)
    detail::note_scalar_written({target, 1, ScalarObject::Kind::text}, name, place);
  else
    detail::write_object(*target, name, place);
  return static_cast<T &&>(pointer);
}

namespace detail {

// Calls `note` with each object of a range, once both of its ends are known.
template <class T, class Note> void begin_range(T *begin, char const *place, Note note) noexcept {
  if (auto const *end = static_cast<T *>(const_cast<void *>(other_range_end(begin, false, place))))
    for (T *each = begin; each < end; ++each) note(*each);
}
template <class T, class Note> void end_range(T *end, char const *place, Note note) noexcept {
  if (auto *begin = static_cast<T *>(const_cast<void *>(other_range_end(end, true, place))))
    for (T *each = begin; each < end; ++each) note(*each);
}

} // namespace detail

// The ends of a range that is handed to code that is not rewritten.
template <class T> T *symreal_range_begin(T *begin, char const *name, char const *place) noexcept {
  if (detail::recording)
    detail::begin_range(begin, place, [=](T &object) { detail::read_object(object, name, place); });
  return begin;
}
template <class T> T *symreal_range_end(T *end, char const *name, char const *place) noexcept {
  if (detail::recording) detail::end_range(end, place, [=](T &object) { detail::read_object(object, name, place); });
  return end;
}
// The same of a range that such code writes without reading it.
template <class T> T *symreal_fill_begin(T *begin, char const *name, char const *place) noexcept {
  if (detail::recording)
    detail::begin_range(begin, place, [=](T &object) { detail::write_object(object, name, place); });
  return begin;
}
template <class T> T *symreal_fill_end(T *end, char const *name, char const *place) noexcept {
  if (detail::recording) detail::end_range(end, place, [=](T &object) { detail::write_object(object, name, place); });
  return end;
}

// An object that shares its bytes with numbers, or a pointer whose type says nothing about numbers.
template <class T> constexpr T &&symreal_bits(T &&object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) {
    using Pointee = std::remove_pointer_t<std::remove_reference_t<T>>;
    if constexpr (!std::is_pointer_v<std::remove_reference_t<T>>)
      detail::check_bits(detail::bytes_of(&object), sizeof object, name, place);
    else if constexpr (detail::is_class<Pointee>)
      detail::check_bits(detail::bytes_of(object), detail::size_here<Pointee>(), name, place);
    else if (object)
      detail::check_bits(detail::bytes_of(object), 1, name, place);
  }
  return static_cast<T &&>(object);
}

// Of an object that shares its bytes with numbers, or that a pointer leads to: `count` bits from `first` on. Where no
// count is given, all of the object itself.
namespace detail {
template <class T> void const *begin_of_part(T &object, std::size_t count) noexcept {
  if constexpr (std::is_pointer_v<T>)
    if (count != 0) return bytes_of(object);
  return bytes_of(&object);
}
} // namespace detail
template <class T> constexpr T &&symreal_part_stored(T &&object, std::size_t first, std::size_t count, char const *name,
                                                     char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording &&
      (detail::any_torn || count % 64 != 0 || sizeof object % 8 != 0))
    detail::note_bits_stored(detail::begin_of_part(object, count), first, count == 0 ? 8 * sizeof object : count,
                             detail::Holds::anything, name, place);
  return static_cast<T &&>(object);
}
template <class T> constexpr T &&symreal_part_replaced(T &&object, std::size_t first, std::size_t count,
                                                       char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::note_bits_stored(detail::begin_of_part(object, count), first, count == 0 ? 8 * sizeof object : count,
                             detail::Holds::number, name, place);
  return static_cast<T &&>(object);
}
template <class T> constexpr T &&symreal_part_read(T &&object, std::size_t first, std::size_t count, char const *name,
                                                   char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::check_part(detail::begin_of_part(object, count), first, count == 0 ? 8 * sizeof object : count, name,
                       place);
  return static_cast<T &&>(object);
}
// As numbers.
template <class T>
constexpr T &&symreal_part_used(T &&object, std::size_t, std::size_t, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording && detail::any_torn)
    detail::note_number_used(detail::bytes_of(&object), sizeof object, name, place);
  return static_cast<T &&>(object);
}

// Numbers that are looked at as something else: an array, or those that a pointer leads to.
template <class T> constexpr T &&symreal_view(T &&object, char const *name, char const *place) noexcept {
  if constexpr (!std::is_pointer_v<std::remove_cvref_t<T>>)
    return symreal_bits(static_cast<T &&>(object), name, place);
  else {
    if (!__builtin_is_constant_evaluated() && detail::recording && object)
      detail::check_view(detail::bytes_of(object), name, place);
    return static_cast<T &&>(object);
  }
}

// memcpy, memmove, memset, memcmp, fread and fwrite: what they read and write, where the types tell.
class Bytes {
public:
  constexpr Bytes(char const *name, char const *place) noexcept : name_(name), place_(place) {}

  template <class To, class From> void *symreal_move(To *to, From *from, std::size_t size) const noexcept {
    if (detail::recording) {
      check_ends(from, size);
      store(to, size, detail::Holds::anything);
      if constexpr ((std::is_arithmetic_v<To> && !detail::is_class<To>) || std::is_enum_v<To>)
        detail::check_bits(from, size, name_, place_);
      each(from, size, [this](auto &object) { detail::read_object(std::as_const(object), name_, place_); });
      each(to, size, [this](auto &object) { detail::write_object(object, name_, place_); });
    }
    return std::memmove(to, from, size);
  }
  // To an object that has no numbers in it.
  template <class To, class From> void *symreal_into(To *to, From *from, std::size_t size) const noexcept {
    if (detail::recording) detail::check_bits(from, size, name_, place_);
    return symreal_move(to, from, size);
  }
  // To one number, of which it may be a part.
  template <class To, class From> void *symreal_move_number(To *to, From *from, std::size_t size) const noexcept {
    if (detail::recording) store(to, size, detail::Holds::number);
    if constexpr (std::is_same_v<To, RealNumber>) return symreal_move(to, from, size);
    return symreal_move_bytes(to, from, size);
  }
  template <class To> void *symreal_set_number(To *to, int byte, std::size_t size) const noexcept {
    if (detail::recording) store(to, size, detail::Holds::number);
    if constexpr (std::is_same_v<To, RealNumber>) return symreal_set(to, byte, size);
    return symreal_set_bytes(to, byte, size);
  }
  // Of numbers, by pointers whose types do not say so.
  void *symreal_move_bytes(void *to, void const *from, std::size_t size) const noexcept {
    if (detail::recording) {
      check_ends(from, size);
      store(to, size, detail::Holds::anything);
      if (!detail::is_own(from)) detail::note_chosen(from, size);
    }
    return std::memmove(to, from, size);
  }
  void *symreal_set_bytes(void *to, int byte, std::size_t size) const noexcept {
    if (detail::recording) store(to, size, detail::Holds::anything);
    return std::memset(to, byte, size);
  }
  template <class To> void *symreal_set(To *to, int byte, std::size_t size) const noexcept {
    if (detail::recording) store(to, size, detail::Holds::anything);
    if (detail::recording) each(to, size, [this](auto &object) { detail::write_object(object, name_, place_); });
    return std::memset(to, byte, size);
  }
  template <class One, class Other> int symreal_compare(One *one, Other *other, std::size_t size) const noexcept {
    if (detail::recording) {
      look_at(one, size);
      look_at(other, size);
    }
    return std::memcmp(one, other, size);
  }
  template <class To>
  std::size_t symreal_read(To *to, std::size_t size, std::size_t count, std::FILE *file) const noexcept {
    if (detail::recording) {
      store(to, size * count, detail::Holds::anything);
      each(to, size * count, [this](auto &object) { detail::write_object(object, name_, place_); });
    }
    return std::fread(to, size, count, file);
  }
  template <class From>
  std::size_t symreal_write(From *from, std::size_t size, std::size_t count, std::FILE *file) const noexcept {
    if (detail::recording) look_at(from, size * count);
    return std::fwrite(from, size, count, file);
  }

private:
  void store(void const volatile *to, std::size_t size, detail::Holds holds) const noexcept {
    bool const is_whole =
        reinterpret_cast<std::uintptr_t>(to) % sizeof(RealNumber) == 0 && size % sizeof(RealNumber) == 0;
    if (!is_whole || detail::any_torn)
      detail::note_bits_stored(detail::bytes_of(to), 0, 8 * size, holds, name_, place_);
  }
  // A number of which a part is moved.
  void check_ends(void const volatile *from, std::size_t size) const noexcept {
    auto const *begin = static_cast<char const *>(detail::bytes_of(from));
    std::size_t const before = (0 - reinterpret_cast<std::uintptr_t>(begin)) % sizeof(RealNumber);
    if (before != 0) detail::check_part(begin, 0, 8 * std::min(before, size), name_, place_);
    if (before >= size) return;
    std::size_t const behind = (size - before) % sizeof(RealNumber);
    if (behind != 0) detail::check_part(begin + size - behind, 0, 8 * behind, name_, place_);
  }
  template <class T> void look_at(T *objects, std::size_t size) const noexcept {
    detail::check_bits(objects, size, name_, place_);
    each(objects, size, [this](auto &object) { detail::read_object(std::as_const(object), name_, place_); });
  }
  template <class T, class Note> static void each(T *objects, std::size_t size, Note note) {
    if constexpr (!std::is_void_v<T>)
      for (std::size_t k = 0; k < size / sizeof(T); ++k) note(objects[k]);
  }

  char const *name_, *place_;
};

} // namespace symreal
