// Hidden state: objects that a kernel reads or changes through members, pointers, references and names of static
// storage. The rewriter wraps such uses; while a kernel is recorded each address is judged once.
//
// An address is the kernel's own if it lies on the stack below the frame in which the kernel began or in a heap block
// that was allocated since, or if the kernel wrote it before reading it. Any other number or scalar that it reads is
// baked in, unless it is annotated; any other number that it leaves with a node in it, and any other scalar that it
// changes, is state missing from the outputs.
#pragma once

#include <symreal/annotate.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

namespace symreal {

namespace detail {

extern __thread bool recording;
// Bounds of the kernel's own stack.
extern __thread std::uintptr_t own_stack, own_stack_size;

inline bool on_own_stack(void const *address) noexcept {
  return reinterpret_cast<std::uintptr_t>(address) - own_stack < own_stack_size;
}

// Locals of the function around a block kernel; empty otherwise. They lie on this stack and outlive the kernel.
extern __thread std::uintptr_t around_begin, around_size;
bool is_around(void const *address) noexcept;

inline bool is_own(void const *address) noexcept {
  bool const may_be_around = reinterpret_cast<std::uintptr_t>(address) - around_begin < around_size;
  return on_own_stack(address) && !(may_be_around && is_around(address));
}

// Functions that can name an object: any; one; one that writes it before it reads it on every path; the one around a
// block kernel, whose locals may change; the kernel itself, whose parameters may lie in the caller's frame.
enum class Scope { any, function, scratch, around, parameter };
void note_static(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept;
void note_local(void const *object, std::size_t size, Scope scope, char const *name, char const *place) noexcept;
// Notes a read of a pointer, which is state if it is null or points to constant memory. Its target is judged by itself,
// unless it is text.
enum class Behind { text, objects };
void note_pointer_read(void const *pointer, Behind what, char const *name, char const *place) noexcept;
// Notes that code outside the kernel chose the pointers in these bytes: reads of constants behind them count as state,
// as in other memory.
void note_chosen(void const *begin, std::size_t size) noexcept;
void note_scalar_written(ScalarObject scalar, char const *name, char const *place) noexcept;
void note_written(void const *begin, std::size_t size, char const *name, char const *place) noexcept;
// Notes a change to an object: if it still exists when the kernel ends, its numbers are judged again.
void note_changed(void const *object, Visit visit, char const *name, char const *place) noexcept;
// Notes a use of the number of the object's elements, for which annotated elements vouch. False if the kernel has made
// them itself.
bool note_counted(void const *object, Visit visit) noexcept;
// Bytes used as a type other than a number: reports an error if they contain a node.
void check_bits(void const *begin, std::size_t size, char const *name, char const *place) noexcept;
// As above, for all memory that a pointer may reach.
void check_view(void const *begin, char const *name, char const *place) noexcept;
// Notes a store to bits of an object. If it overwrites part of a symbolic number, a use of the torn number is an error;
// in an object that holds only a number the store itself is one.
enum class Holds { anything, number };
void note_bits_stored(void const *begin, std::size_t first, std::size_t count, Holds holds, char const *name,
                      char const *place) noexcept;
// True if torn numbers exist; and the note of a use of one.
extern __thread bool any_torn;
void note_number_used(void const *begin, std::size_t size, char const *name, char const *place) noexcept;
// As check_bits, for a range of bits.
void check_part(void const *begin, std::size_t first, std::size_t count, char const *name, char const *place) noexcept;
// Pairs the ends of a range, which come in either order: the second call returns the other end, the first null.
void const *other_range_end(void const *end, bool is_last, char const *place) noexcept;

inline void const *bytes_of(void const volatile *object) noexcept { return const_cast<void const *>(object); }

// Visitor that notes a read of each part of an object.
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

// Visitor that finds the first number of an object, or its first scalar if it holds only scalars.
struct FirstPart {
  void const *number = nullptr, *scalar = nullptr;
  void operator()(RealNumber const *found) noexcept { number = number ? number : found; }
  void operator()(ScalarObject found) noexcept { scalar = scalar ? scalar : found.address; }
  void const *address() const noexcept { return number ? number : scalar; }
};

// Notes that control flow depends on the object itself: its text, a pointer's target, the number of its elements.
// Annotated elements vouch for their number.
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

// Containers, whose number of elements may change. Like an object without known parts, they may have been assigned
// their former value, which a comparison of bytes misses.
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

// Size of T; 1, for its first byte, if T is incomplete in this source.
template <class T> constexpr std::size_t size_here() noexcept {
  if constexpr (requires { sizeof(T); })
    return sizeof(T);
  else
    return 1;
}

} // namespace detail

// A reference to an object of static storage duration: diagnostics of later reads use its name.
template <class T> constexpr T &symreal_state(T &object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::note_static(detail::bytes_of(&object), detail::size_here<T>(), detail::Scope::any, name, place);
  return object;
}

// As above, for an object declared in a function: other functions cannot read its final value.
template <class T> constexpr T &symreal_local_state(T &object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::note_static(detail::bytes_of(&object), detail::size_here<T>(), detail::Scope::function, name, place);
  return object;
}

// As above, for an object that the function writes before it reads it, on every path.
template <class T> constexpr T &symreal_scratch_state(T &object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording)
    detail::note_static(detail::bytes_of(&object), detail::size_here<T>(), detail::Scope::scratch, name, place);
  return object;
}

// A local of the function around a block kernel. A scalar local is read: the rewriter has checked that.
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

// Notes that the caller, or the code before a block kernel, chooses the target of this pointer, or of those in it.
template <class T> void symreal_argument_leads(T const &object) noexcept {
  if (!detail::recording) return;
  if constexpr (std::is_pointer_v<T>)
    detail::note_chosen(detail::bytes_of(&object), sizeof object);
  else if constexpr (detail::is_class<T> || std::is_class_v<T> || std::is_union_v<T>)
    detail::note_chosen(detail::bytes_of(&reinterpret_cast<char const volatile &>(object)), sizeof object);
}

// As above, for a library object that the kernel has not made itself, and for a reference member.
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

// Not a constant expression, so that notes within it are made when the program runs.
template <class T> T &&symreal_at_run(T &&object) noexcept { return static_cast<T &&>(object); }

// Notes a use of the object's value. Objects without numbers, and other expansions of the same macro text, pass.
template <class T> constexpr T &&symreal_read(T &&object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::read_object(object, name, place);
  return static_cast<T &&>(object);
}

// Notes that the kernel's control flow depends on the object.
template <class T> constexpr T &&symreal_decides(T &&object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::decided_by(object, name, place);
  return static_cast<T &&>(object);
}

// Notes a write to the object.
template <class T> constexpr T &&symreal_written(T &&object, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording) detail::write_object(object, name, place);
  return static_cast<T &&>(object);
}

// Notes a change by code that is not rewritten, such as push_back.
template <class T> T &symreal_changed(T &object, char const *name, char const *place) noexcept {
  if (detail::recording && !detail::is_own(&object))
    if constexpr (Numbers::may_hold<T>) detail::note_changed_object(object, name, place);
  return object;
}

// Notes that a library writes text, a scalar or an object to the target. Other checks cover numbers.
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

// The ends of a range that code outside the rewriter reads.
template <class T> T *symreal_range_begin(T *begin, char const *name, char const *place) noexcept {
  if (detail::recording)
    detail::begin_range(begin, place, [=](T &object) { detail::read_object(object, name, place); });
  return begin;
}
template <class T> T *symreal_range_end(T *end, char const *name, char const *place) noexcept {
  if (detail::recording) detail::end_range(end, place, [=](T &object) { detail::read_object(object, name, place); });
  return end;
}
// As above, for a range that such code only writes.
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

// Accesses to part of an object that shares its bytes with numbers, or of a pointer's target: `count` bits from `first`
// on, or the whole object if `count` is 0.
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
// Notes a use of the part as a number.
template <class T>
constexpr T &&symreal_part_used(T &&object, std::size_t, std::size_t, char const *name, char const *place) noexcept {
  if (!__builtin_is_constant_evaluated() && detail::recording && detail::any_torn)
    detail::note_number_used(detail::bytes_of(&object), sizeof object, name, place);
  return static_cast<T &&>(object);
}

// Numbers accessed as another type: those of an array, or those behind a pointer.
template <class T> constexpr T &&symreal_view(T &&object, char const *name, char const *place) noexcept {
  if constexpr (!std::is_pointer_v<std::remove_cvref_t<T>>)
    return symreal_bits(static_cast<T &&>(object), name, place);
  else {
    if (!__builtin_is_constant_evaluated() && detail::recording && object)
      detail::check_view(detail::bytes_of(object), name, place);
    return static_cast<T &&>(object);
  }
}

// memcpy, memmove, memset, memcmp, fread and fwrite: notes their reads and writes, as far as the types tell.
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
  // Moves bytes into an object without numbers.
  template <class To, class From> void *symreal_into(To *to, From *from, std::size_t size) const noexcept {
    if (detail::recording) detail::check_bits(from, size, name_, place_);
    return symreal_move(to, from, size);
  }
  // Moves bytes into a number or a part of one.
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
  // Moves or sets numbers through pointers of another type.
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
  // Checks the numbers at either end that are moved only in part.
  void check_ends(void const volatile *from, std::size_t size) const noexcept {
    auto const *begin = static_cast<char const *>(detail::bytes_of(from));
    std::size_t const before = (0 - reinterpret_cast<std::uintptr_t>(begin)) % sizeof(RealNumber);
    if (before != 0) detail::check_part(begin, 0, 8 * (before < size ? before : size), name_, place_);
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
