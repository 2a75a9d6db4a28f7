/* The switch. A rewritten source spells `double` as SYMREAL_REAL, or by a shorter name for that (real.h), and its
   pragmas as the macros below; this header, force-included before the first line, says what they mean:

     (nothing)        numeric: SYMREAL_REAL is double and every macro vanishes or leaves the original tokens; object
                      code is the original's, in C and in C++
     -DMBD_SYMBOLIC   symbolic: SYMREAL_REAL is symreal::RealNumber and the program records itself
     -DMBD_REPLAY     replay: SYMREAL_REAL is double, annotations live; verification feeds and reads them

   SYMREAL_REAL is a macro rather than a typedef, since a typedef shows in __PRETTY_FUNCTION__ and in mangled names.

   Macros of the program are expanded in what these expand to. So a macro names, besides words of the language, what
   begins with symreal_, Symreal or SYMREAL_ alone (macro_names.h), and pastes what it gets: symreal_##how. */
#ifndef SYMREAL_MACROS_H
#define SYMREAL_MACROS_H

#if !defined(MBD_SYMBOLIC) && !defined(MBD_REPLAY)

#define SYMREAL_REAL double
#define SYMREAL_REAL_C(...) __VA_ARGS__
#define SYMREAL_REAL_DEDUCED(...) __VA_ARGS__
#define SYMREAL_REAL_CONSTANT(...) __VA_ARGS__
#define SYMREAL_REAL_PLAIN_OBJECT(...) __VA_ARGS__
#define SYMREAL_REAL_VALUE(...) __VA_ARGS__
#define SYMREAL_REAL_TO(type, ...) __VA_ARGS__
#define SYMREAL_REAL_FIT(...) __VA_ARGS__
#define SYMREAL_REAL_ARGUMENT(type, ...) __VA_ARGS__
#define SYMREAL_REAL_ERASED(...) __VA_ARGS__
#define SYMREAL_REAL_TRUTH(...) __VA_ARGS__
#define SYMREAL_REAL_LATER(...) __VA_ARGS__
#define SYMREAL_REAL_NOW(...) __VA_ARGS__
#define SYMREAL_REAL_PROMOTED(...) __VA_ARGS__
#define SYMREAL_REAL_ENUM(...) __VA_ARGS__
#define SYMREAL_REAL_OF_C(type, ...) __VA_ARGS__
#define SYMREAL_REAL_COUNTED(...) __VA_ARGS__
#define SYMREAL_REAL_WIDTH(bits, is_signed, ...) __VA_ARGS__
#define SYMREAL_REAL_COMPOUND(type, ...) type __VA_ARGS__
#define SYMREAL_REAL_STATE(object, place) object
#define SYMREAL_REAL_LOCAL_STATE(object, place) object
#define SYMREAL_REAL_SCRATCH_STATE(object, place) object
#define SYMREAL_REAL_EXTERNAL(function, ...) function
#define SYMREAL_REAL_FUNCTION(type, ...) __VA_ARGS__
#define SYMREAL_REAL_LINKAGE(...) __VA_ARGS__
#define SYMREAL_REAL_INT(...) __VA_ARGS__
#define SYMREAL_REAL_TABLE(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_READ(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_DECIDES(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_AT_RUN(...) __VA_ARGS__
#define SYMREAL_REAL_LEADS(...) __VA_ARGS__
#define SYMREAL_REAL_REFERS(holder, ...) __VA_ARGS__
#define SYMREAL_REAL_WRITTEN(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_CHANGED(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_TARGET(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_FIRST(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_LAST(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_FILL_FIRST(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_FILL_LAST(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_BITS(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_VIEW(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_PART(how, first, count, name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_BYTES(how, name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_ENVIRONMENT(what, name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_FORMAT(how, is_used, place, ...) __VA_ARGS__
#define SYMREAL_REAL_SHOWS(...) __VA_ARGS__
#define SYMREAL_REAL_TEXT(name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_NAMED(place, ...) __VA_ARGS__
#define SYMREAL_REAL_PASTED(text, ...) __VA_ARGS__
#define SYMREAL_REAL_EITHER(original, ...) SYMREAL_ORIGINAL original
#define SYMREAL_ORIGINAL(...) __VA_ARGS__
#define SYMREAL_REAL_ONLY(...)
#define SYMREAL_REAL_BUILTIN(name) __builtin_##name
#define SYMREAL_REAL_NAME(name) name
#define SYMREAL_REAL_TYPE(name, ...) name
#define SYMREAL_REAL_PROTOTYPE(parameters, ...) __VA_ARGS__
#define SYMREAL_REAL_MEMBERS(...)
#define SYMREAL_REAL_LAYOUT(...)
#define SYMREAL_REAL_PADDING(...)
#define SYMREAL_AROUND(...)
#define SYMREAL_PARAMETER(...)
#define SYMREAL_LEADS(...)
#define SYMREAL_OBJECT(...)
#define SYMREAL_DECLARE(...)
#define SYMREAL_DECLARE_SECTION(...)
#define SYMREAL_FILE(...)
#define SYMREAL_SECTION(...)
#define SYMREAL_LAYOUT(...)
#define SYMREAL_LAYOUT_SECTION(...)
#define SYMREAL_RANGE(...)
#define SYMREAL_STATE(...)
#define SYMREAL_DIFFERENTIATE(...)
#define SYMREAL_TABLE(...)
#define SYMREAL_IMPLICIT(...)
#define SYMREAL_IMPLICIT_SECTION(...)
#define SYMREAL_REBIND(...)
#define SYMREAL_REBIND_END(...)
#define SYMREAL_FUNCTION(...)
#define SYMREAL_TRY_BEGIN
#define SYMREAL_TRY_END
#define SYMREAL_ARGUMENT(...)
#define SYMREAL_OUTPUTS_BEGIN
#define SYMREAL_OUTPUTS_END
#define SYMREAL_RETURN(label, file, line, column, ...) __VA_ARGS__
#define SYMREAL_RETURN_AS(label, file, line, column, type, ...) __VA_ARGS__
#define SYMREAL_RETURN_LAYOUT_AS(label, file, line, column, layout, types, type, ...) __VA_ARGS__
#define SYMREAL_RETURN_WHOLE(type, ...) __VA_ARGS__
#define SYMREAL_RETURN_INTEGER(label, file, line, column, type, ...) __VA_ARGS__
#define SYMREAL_RETURN_LAYOUT(label, file, line, column, layout, types, ...) __VA_ARGS__
#define SYMREAL_GENERATE(...)

#else

/* Macros of the program, from its command line or from before this point, are not seen within our headers. */
#include <symreal/names_hide.h>

#include <symreal/allocator.h>
#include <symreal/annotate.h>
#include <symreal/enumerators.h>
#include <symreal/fit.h>
#include <symreal/library_conversions.h>
#include <symreal/macro_names.h>
#include <symreal/object_layout.h>
#ifdef MBD_SYMBOLIC
#include <symreal/type_names.h>
#endif
#ifdef SYMREAL_SOURCE_OF_C /* a header may be included by C and by C++ */
#include <symreal/of_c.h>
#endif

#include <symreal/names_show.h>

/* A type of C, whose sources are compiled as C++ here. */
#ifndef _Bool
#define _Bool bool
#endif

#ifdef MBD_SYMBOLIC
#define SYMREAL_REAL ::symreal::SymrealReal
#define SYMREAL_REAL_C(...) (static_cast<::symreal::SymrealReal>(__VA_ARGS__)) /* T(A(b)) may be a type */
#define SYMREAL_REAL_DEDUCED(...) (::symreal::symreal_deduced(__VA_ARGS__))
#define SYMREAL_REAL_CONSTANT(...) (::symreal::symreal_constant<(__VA_ARGS__)>.symreal_object)
#define SYMREAL_REAL_PLAIN_OBJECT(...) (::symreal::symreal_plain_object(__VA_ARGS__))
#define SYMREAL_REAL_VALUE(...) (::symreal::symreal_value(__VA_ARGS__))
#define SYMREAL_REAL_TO(type, ...) (static_cast<type>(__VA_ARGS__))
/* An argument in a template: converts as a double does to the parameter of the overload chosen for double. */
#define SYMREAL_REAL_ARGUMENT(type, ...) (::symreal::symreal_argument_as<type>(__VA_ARGS__))
/* A value whose type is observed: a comparison becomes bool. */
#define SYMREAL_REAL_ERASED(...) (::symreal::symreal_erased(__VA_ARGS__))
#define SYMREAL_REAL_TRUTH(...) (::symreal::symreal_of_type<::symreal::symreal_plain_type<decltype(__VA_ARGS__)>>())
/* The order in which a compiler evaluates operands that change what the other reads: it is another one for the
   operators of a class than for those of the language, and an argument that is a class is read late
   (<symreal/order.h>). */
#define SYMREAL_REAL_LATER(...)                                                                                        \
  (::symreal::symreal_later([&]() -> decltype(auto) { return ::symreal::symreal_later_value((__VA_ARGS__)); }))
#define SYMREAL_REAL_NOW(...) (::symreal::symreal_now(__VA_ARGS__))
#define SYMREAL_REAL_STATE(object, place) (::symreal::symreal_state(object, #object, place))
#define SYMREAL_REAL_LOCAL_STATE(object, place) (::symreal::symreal_local_state(object, #object, place))
#define SYMREAL_REAL_SCRATCH_STATE(object, place) (::symreal::symreal_scratch_state(object, #object, place))
#define SYMREAL_REAL_EXTERNAL(function, ...) (::symreal::symreal_external(function, {__VA_ARGS__}))
#define SYMREAL_REAL_INT(...) ::symreal::SymrealInt<__VA_ARGS__>
#define SYMREAL_REAL_TABLE(name, place, ...) (::symreal::symreal_table(__VA_ARGS__, name, place))
#define SYMREAL_REAL_READ(name, place, ...) (::symreal::symreal_read(__VA_ARGS__, name, place))
#define SYMREAL_REAL_AT_RUN(...) (::symreal::symreal_at_run(__VA_ARGS__))
#define SYMREAL_REAL_LEADS(...) (::symreal::symreal_leads(__VA_ARGS__))
#define SYMREAL_REAL_REFERS(holder, ...) (::symreal::symreal_refers(holder, __VA_ARGS__))
#define SYMREAL_REAL_DECIDES(name, place, ...) (::symreal::symreal_decides(__VA_ARGS__, name, place))
#define SYMREAL_REAL_WRITTEN(name, place, ...) (::symreal::symreal_written(__VA_ARGS__, name, place))
#define SYMREAL_REAL_CHANGED(name, place, ...) (::symreal::symreal_changed(__VA_ARGS__, name, place))
#define SYMREAL_REAL_TARGET(name, place, ...) (::symreal::symreal_target(__VA_ARGS__, name, place))
#define SYMREAL_REAL_FIRST(name, place, ...) (::symreal::symreal_range_begin(__VA_ARGS__, name, place))
#define SYMREAL_REAL_LAST(name, place, ...) (::symreal::symreal_range_end(__VA_ARGS__, name, place))
#define SYMREAL_REAL_FILL_FIRST(name, place, ...) (::symreal::symreal_fill_begin(__VA_ARGS__, name, place))
#define SYMREAL_REAL_FILL_LAST(name, place, ...) (::symreal::symreal_fill_end(__VA_ARGS__, name, place))
#define SYMREAL_REAL_BITS(name, place, ...) (::symreal::symreal_bits(__VA_ARGS__, name, place))
#define SYMREAL_REAL_VIEW(name, place, ...) (::symreal::symreal_view(__VA_ARGS__, name, place))
/* Bits of an object that numbers share; a count of 0 stands for all of them. */
#define SYMREAL_REAL_PART(how, first, count, name, place, ...)                                                         \
  (::symreal::symreal_part_##how(__VA_ARGS__, first, count, name, place))
/* Replaces memmove (and memcpy) or memset. */
#define SYMREAL_REAL_BYTES(how, name, place, ...) ::symreal::SymrealBytes(name, place).symreal_##how
#define SYMREAL_REAL_ENVIRONMENT(what, name, place, ...) (::symreal::symreal_##what(name, place), __VA_ARGS__)
/* Replaces a function that makes or moves text. */
#define SYMREAL_REAL_FORMAT(how, is_used, place, ...)                                                                  \
  ::symreal::SymrealFormat(is_used, place, SYMREAL_SHOWN_FIRST).symreal_##how
#ifdef SYMREAL_ARGUMENTS_FIRST
#define SYMREAL_SHOWN_FIRST true
#else
#define SYMREAL_SHOWN_FIRST false
#endif
/* A call that passes carried values to a function of the program. */
#define SYMREAL_REAL_SHOWS(...) (::symreal::SymrealShows(SYMREAL_SHOWN_FIRST), __VA_ARGS__)
#define SYMREAL_REAL_TEXT(name, place, ...) (::symreal::symreal_text(__VA_ARGS__, name, place))
/* Names of types (<symreal/type_names.h>). */
#define SYMREAL_REAL_NAMED(place, ...) (::symreal::symreal_named(__VA_ARGS__, place))
#define SYMREAL_SIGNATURE                                                                                              \
  (::symreal::symreal_signature<::symreal::SymrealSignature(__PRETTY_FUNCTION__)>.symreal_letters)
#define SYMREAL_AROUND(name, place, ...) ::symreal::symreal_around(__VA_ARGS__, name, place);
#define SYMREAL_PARAMETER(name, place, ...) ::symreal::symreal_parameter(__VA_ARGS__, name, place);
#define SYMREAL_LEADS(...) ::symreal::symreal_argument_leads(__VA_ARGS__);
/* Member functions that describe a class: `access` is the access specifier of the members that follow. */
#define SYMREAL_REAL_MEMBERS(access, ...)                                                                              \
public:                                                                                                                \
  void symreal_members(::symreal::SymrealNumbers &symreal_numbers) const {                                             \
    symreal_numbers.symreal_visit(__VA_ARGS__);                                                                        \
  }                                                                                                                    \
  access:
/* Asserts the size and the offsets of the original. */
#define SYMREAL_REAL_LAYOUT(access, ...)                                                                               \
public:                                                                                                                \
  void symreal_layout() const {                                                                                        \
    using symreal_class = ::symreal::symreal_class_of<decltype(*this)>;                                                \
    static_assert((__VA_ARGS__), "this class has another layout with REAL than with double [SYM132]");                 \
  }                                                                                                                    \
  access:
/* Padding: a derived class may reuse the tail padding after a member of class type such as REAL, not after a double. */
#define SYMREAL_REAL_PADDING(bytes) long long : 8 * (bytes);
#else
#define SYMREAL_REAL double
#define SYMREAL_REAL_C(...) (__VA_ARGS__)
#define SYMREAL_REAL_DEDUCED(...) (__VA_ARGS__)
#define SYMREAL_REAL_CONSTANT(...) (__VA_ARGS__)
#define SYMREAL_REAL_PLAIN_OBJECT(...) (__VA_ARGS__)
#define SYMREAL_REAL_VALUE(...) (__VA_ARGS__)
#define SYMREAL_REAL_TO(type, ...) (static_cast<type>(__VA_ARGS__))
#define SYMREAL_REAL_ARGUMENT(type, ...) __VA_ARGS__
#define SYMREAL_REAL_ERASED(...) (__VA_ARGS__)
#define SYMREAL_REAL_TRUTH(...) __VA_ARGS__
#define SYMREAL_REAL_LATER(...) (__VA_ARGS__)
#define SYMREAL_REAL_NOW(...) (__VA_ARGS__)
#define SYMREAL_REAL_STATE(object, place) (object)
#define SYMREAL_REAL_LOCAL_STATE(object, place) (object)
#define SYMREAL_REAL_SCRATCH_STATE(object, place) (object)
#define SYMREAL_REAL_EXTERNAL(function, ...) (function)
#define SYMREAL_REAL_INT(...) __VA_ARGS__
#define SYMREAL_REAL_TABLE(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_READ(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_DECIDES(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_AT_RUN(...) (__VA_ARGS__)
#define SYMREAL_REAL_LEADS(...) (__VA_ARGS__)
#define SYMREAL_REAL_REFERS(holder, ...) (__VA_ARGS__)
#define SYMREAL_REAL_WRITTEN(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_CHANGED(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_TARGET(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_FIRST(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_LAST(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_FILL_FIRST(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_FILL_LAST(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_BITS(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_VIEW(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_PART(how, first, count, name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_BYTES(how, name, place, ...) __VA_ARGS__
#define SYMREAL_REAL_ENVIRONMENT(what, name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_FORMAT(how, is_used, place, ...) __VA_ARGS__
#define SYMREAL_REAL_SHOWS(...) (__VA_ARGS__)
#define SYMREAL_REAL_TEXT(name, place, ...) (__VA_ARGS__)
#define SYMREAL_REAL_NAMED(place, ...) (__VA_ARGS__)
#define SYMREAL_SIGNATURE __PRETTY_FUNCTION__
#define SYMREAL_REAL_MEMBERS(...)
#define SYMREAL_REAL_LAYOUT(...)
#define SYMREAL_REAL_PADDING(...)
#define SYMREAL_AROUND(...)
#define SYMREAL_PARAMETER(...)
#define SYMREAL_LEADS(...)
#endif
/* The overload of the given type, of a function for which C++ has several and C one. Its address is unique, as that of
   C's function. */
#define SYMREAL_REAL_FUNCTION(type, ...) (*static_cast<::symreal::symreal_pointer_to<type>>(__VA_ARGS__))
/* A conversion to the type that the context expects; an enumerator becomes C's integer. */
#define SYMREAL_REAL_FIT(...) (::symreal::symreal_fit(__VA_ARGS__))
#define SYMREAL_REAL_ENUM(...) (::symreal::symreal_enumeration(__VA_ARGS__))
/* C's semantics for expressions to which C++ gives another type (<symreal/of_c.h>). */
#ifdef SYMREAL_SOURCE_OF_C
#define SYMREAL_REAL_PROMOTED(...) (::symreal::symreal_promoted(__VA_ARGS__))
#define SYMREAL_REAL_OF_C(type, ...) (::symreal::symreal_of_c<type>((__VA_ARGS__)))
#define SYMREAL_REAL_COUNTED(...) (::symreal::symreal_counted((__VA_ARGS__)))
#define SYMREAL_REAL_COMPOUND(type, ...)                                                                               \
  (symreal_literals.symreal_make<SYMREAL_TYPE_IN type, decltype([] {})>(__VA_ARGS__))
#define SYMREAL_TYPE_IN(...) __typeof__(__VA_ARGS__)
#ifdef __clang__ /* computes in the declared type, in C as well */
#define SYMREAL_REAL_WIDTH(bits, is_signed, ...) (__VA_ARGS__)
#else
#define SYMREAL_REAL_WIDTH(bits, is_signed, ...) (::symreal::symreal_width<bits, is_signed>((__VA_ARGS__)))
#endif
#else
#define SYMREAL_REAL_PROMOTED(...) (__VA_ARGS__)
#define SYMREAL_REAL_OF_C(type, ...) (__VA_ARGS__)
#define SYMREAL_REAL_COUNTED(...) (__VA_ARGS__)
#define SYMREAL_REAL_COMPOUND(type, ...) type __VA_ARGS__
#define SYMREAL_REAL_WIDTH(bits, is_signed, ...) (__VA_ARGS__)
#endif
/* Text that a macro derives from the spelling `double`, which the rewritten source lacks. */
#define SYMREAL_REAL_PASTED(text, ...) SYMREAL_UNPACKED text
#define SYMREAL_UNPACKED(...) __VA_ARGS__
/* C sources are compiled as C++ here: identifiers that are keywords of C++ are renamed, and C names of a library are
   kept. */
#define SYMREAL_REAL_NAME(name) symreal_##name
#define SYMREAL_REAL_EITHER(original, ...) __VA_ARGS__
/* Constructs that C++ needs and C lacks. */
#define SYMREAL_REAL_ONLY(...) __VA_ARGS__
#define SYMREAL_REAL_BUILTIN(name) ::std::name
#define SYMREAL_REAL_TYPE(name, ...) __VA_ARGS__
#define SYMREAL_REAL_PROTOTYPE(parameters, ...) parameters
#define SYMREAL_REAL_LINKAGE(...)                                                                                      \
  extern "C" {                                                                                                         \
  __VA_ARGS__;                                                                                                         \
  }
/* Place of an annotation's pragma. The frame delimits the kernel's own stack. */
#define SYMREAL_PLACE(file, line, column) {file, line, column, __builtin_frame_address(0)}

#define SYMREAL_OBJECT(kind, label, file, line, column, ...)                                                           \
  ::symreal::symreal_annotate(::symreal::symreal_kind_##kind, label, SYMREAL_PLACE(file, line, column), __VA_ARGS__);
#define SYMREAL_DECLARE(kind, label, file, line, column, ...)                                                          \
  ::symreal::symreal_declare<::symreal::symreal_kind_##kind>(label, SYMREAL_PLACE(file, line, column), __VA_ARGS__);
#define SYMREAL_FILE(label, file, line, column)                                                                        \
  ::symreal::symreal_declare_file(label, SYMREAL_PLACE(file, line, column));
#define SYMREAL_SECTION(kind, label, file, line, column, extents, ...)                                                 \
  ::symreal::symreal_annotate_section(::symreal::symreal_kind_##kind, label, SYMREAL_PLACE(file, line, column),        \
                                      extents, [&](__SIZE_TYPE__ const *symreal_i) -> decltype(auto) {                 \
                                        (void)symreal_i;                                                               \
                                        return (__VA_ARGS__);                                                          \
                                      });
#define SYMREAL_DECLARE_SECTION(kind, label, file, line, column, extents, ...)                                         \
  ::symreal::symreal_declare_section<::symreal::symreal_kind_##kind>(                                                  \
      label, SYMREAL_PLACE(file, line, column), extents, [&](__SIZE_TYPE__ const *symreal_i) -> decltype(auto) {       \
        (void)symreal_i;                                                                                               \
        return (__VA_ARGS__);                                                                                          \
      });
/* Indexed object of an annotation's item: `name` is its spelling. */
#define SYMREAL_INDEX(count, name, ...) (::symreal::symreal_index(count, name, __VA_ARGS__))
#define SYMREAL_ELEMENT(name, index, ...) (::symreal::symreal_element(name, index, __VA_ARGS__))
/* Structures: `types` lists the types of their containers, in parentheses. */
#define SYMREAL_LAYOUT(kind, label, file, line, column, layout, types, ...)                                            \
  ::symreal::symreal_annotate_layout<SYMREAL_WORDS types>(::symreal::symreal_kind_##kind, label,                       \
                                                          SYMREAL_PLACE(file, line, column), layout,                   \
                                                          __builtin_addressof(__VA_ARGS__));
#define SYMREAL_LAYOUT_SECTION(kind, label, file, line, column, extents, layout, types, ...)                           \
  ::symreal::symreal_annotate_layout_section<SYMREAL_WORDS types>(                                                     \
      ::symreal::symreal_kind_##kind, label, SYMREAL_PLACE(file, line, column), extents,                               \
      layout, [&](__SIZE_TYPE__ const *symreal_i) -> void const volatile * {                                           \
        (void)symreal_i;                                                                                               \
        return __builtin_addressof(__VA_ARGS__);                                                                       \
      });
#define SYMREAL_WORDS(...) __VA_ARGS__
#define SYMREAL_RANGE(low, high) ::symreal::symreal_set_range(low, high);
#define SYMREAL_STATE(state, file, line, column, derivative)                                                           \
  ::symreal::symreal_set_state(state, derivative, SYMREAL_PLACE(file, line, column));
#define SYMREAL_DIFFERENTIATE(wish, file, line, column)                                                                \
  ::symreal::symreal_differentiate(wish, SYMREAL_PLACE(file, line, column));
#ifdef MBD_SYMBOLIC
#define SYMREAL_TABLE(pointer, ...) ::symreal::symreal_declare_table(pointer, static_cast<__SIZE_TYPE__>(__VA_ARGS__));
#define SYMREAL_IMPLICIT(label, file, line, column, ...)                                                               \
  ::symreal::symreal_implicit(label, SYMREAL_PLACE(file, line, column), __VA_ARGS__);
#define SYMREAL_IMPLICIT_SECTION(label, file, line, column, extents, ...)                                              \
  ::symreal::symreal_implicit_section(label, SYMREAL_PLACE(file, line, column), extents,                               \
                                      [&](__SIZE_TYPE__ const *symreal_i) -> decltype(auto) {                          \
                                        (void)symreal_i;                                                               \
                                        return (__VA_ARGS__);                                                          \
                                      });
#else
#define SYMREAL_TABLE(...)
#define SYMREAL_IMPLICIT(...)
#define SYMREAL_IMPLICIT_SECTION(...)
#endif
#define SYMREAL_REBIND(pointer, low, count) pointer = ::symreal::symreal_rebind(pointer, low, count);
#define SYMREAL_REBIND_END(pointer) ::symreal::symreal_rebind_end(pointer);
/* The optional last argument is the call to record, counted from 1. */
#define SYMREAL_FUNCTION(name, file, line, column, ...)                                                                \
  ::symreal::SymrealFunctionKernel symreal_kernel(name, SYMREAL_PLACE(file, line, column), ##__VA_ARGS__);
/* The block around a function-try-block, in which its handlers return as well. */
#define SYMREAL_TRY_BEGIN {
#define SYMREAL_TRY_END }
/* An argument that is passed by value. */
#define SYMREAL_ARGUMENT(name, place, ...) symreal_kernel.symreal_argument(name, place, __VA_ARGS__);
#define SYMREAL_OUTPUTS_BEGIN auto symreal_outputs = symreal_kernel.symreal_on_return([&] {
#define SYMREAL_OUTPUTS_END                                                                                            \
  });
#define SYMREAL_RETURN(label, file, line, column, ...)                                                                 \
  (symreal_kernel.symreal_returned(label, SYMREAL_PLACE(file, line, column), __VA_ARGS__))
/* The function's result, converted from the expression as by `return`. */
#define SYMREAL_RETURNED_AS(type, ...) [&]() -> SYMREAL_WORDS type { return __VA_ARGS__; }()
#define SYMREAL_RETURN_AS(label, file, line, column, type, ...)                                                        \
  SYMREAL_RETURN(label, file, line, column, SYMREAL_RETURNED_AS(type, __VA_ARGS__))
#define SYMREAL_RETURN_WHOLE(type, ...) (symreal_kernel.symreal_handed_over(SYMREAL_RETURNED_AS(type, __VA_ARGS__)))
#define SYMREAL_BOOL bool
#define SYMREAL_RETURN_INTEGER(label, file, line, column, type, ...)                                                   \
  (symreal_kernel.symreal_returned_integer<SYMREAL_WORDS type>(label, SYMREAL_PLACE(file, line, column), __VA_ARGS__))
#define SYMREAL_RETURN_LAYOUT(label, file, line, column, layout, types, ...)                                           \
  (symreal_kernel.symreal_returned_layout<SYMREAL_WORDS types>(label, SYMREAL_PLACE(file, line, column), layout,       \
                                                               __VA_ARGS__))
#define SYMREAL_RETURN_LAYOUT_AS(label, file, line, column, layout, types, type, ...)                                  \
  SYMREAL_RETURN_LAYOUT(label, file, line, column, layout, types, SYMREAL_RETURNED_AS(type, __VA_ARGS__))
#define SYMREAL_GENERATE(name, file, line, column) ::symreal::symreal_generate(name, SYMREAL_PLACE(file, line, column));

#endif

#ifdef MBD_SYMBOLIC

/* Both arms are executed, one after the other, and each target is selected (<symreal/branch.h>). */
#define SYMREAL_TARGETS(targets) [&](::symreal::SymrealTargets &symreal_targets) { (void)(symreal_targets targets); }
#define SYMREAL_REAL_IF(targets, ...)                                                                                  \
  for (::symreal::SymrealBranch symreal_branch((__VA_ARGS__), SYMREAL_TARGETS(targets));                               \
       symreal_branch.symreal_more();)                                                                                 \
    if (symreal_branch.symreal_arm())
#define SYMREAL_REAL_RETURN_IF(targets, ...)                                                                           \
  for (::symreal::SymrealBranch symreal_branch((__VA_ARGS__), SYMREAL_TARGETS(targets), &symreal_returns);             \
       symreal_branch.symreal_more();)                                                                                 \
    if (symreal_branch.symreal_arm())
#define SYMREAL_REAL_COND(...) ::symreal::symreal_choose((__VA_ARGS__), [&] { return (
#define SYMREAL_REAL_THEN
#define SYMREAL_REAL_ELSE );                                                                                           \
  }                                                                                                                    \
  , [&] { return (
#define SYMREAL_REAL_END );                                                                                            \
  })
#define SYMREAL_REAL_AND &
#define SYMREAL_REAL_OR |
#define SYMREAL_REAL_PLAIN(...) (__VA_ARGS__)
#define SYMREAL_REAL_LOOP(limit, targets)                                                                              \
  if (::symreal::SymrealLoop symreal_loop(limit, SYMREAL_TARGETS(targets)); true)
#define SYMREAL_REAL_LATE_LOOP(limit, targets)                                                                         \
  if (::symreal::SymrealLoop symreal_loop(limit, SYMREAL_TARGETS(targets), true); true)
#define SYMREAL_REAL_TEST(...) symreal_loop.symreal_test([&] { return ::symreal::symreal_truth(__VA_ARGS__); })
#define SYMREAL_REAL_BREAK(...) if (symreal_loop.symreal_breaks((__VA_ARGS__)))
#define SYMREAL_REAL_RETURN(...)                                                                                       \
  while (symreal_returns.symreal_leaves((__VA_ARGS__))) return symreal_returns.symreal_result()
#define SYMREAL_REAL_DECISIONS(policy)                                                                                 \
  if (::symreal::SymrealDecisionScope symreal_decisions(::symreal::symreal_decisions_##policy); true)
#define SYMREAL_DECISIONS(policy)                                                                                      \
  ::symreal::SymrealDecisionScope symreal_decisions(::symreal::symreal_decisions_##policy);
#define SYMREAL_REAL_EXACT if (::symreal::SymrealExactScope symreal_exact; true)
#define SYMREAL_EXACT ::symreal::SymrealExactScope symreal_exact;
#define SYMREAL_RETURNS ::symreal::SymrealReturns symreal_returns;
#define SYMREAL_RETURNS_OF(kernel) ::symreal::SymrealReturns symreal_returns(kernel);
#define SYMREAL_RETURNS_END return symreal_returns.symreal_last();

#else

/* Decisions, in every mode but the symbolic one: the original tokens. */
#define SYMREAL_REAL_IF(targets, ...) if (__VA_ARGS__)
#define SYMREAL_REAL_RETURN_IF(targets, ...) if (__VA_ARGS__)
#define SYMREAL_REAL_COND(...) __VA_ARGS__
#define SYMREAL_REAL_THEN ?
#define SYMREAL_REAL_ELSE :
#define SYMREAL_REAL_END
#define SYMREAL_REAL_AND &&
#define SYMREAL_REAL_OR ||
#define SYMREAL_REAL_PLAIN(...) __VA_ARGS__
#define SYMREAL_REAL_LOOP(limit, targets)
#define SYMREAL_REAL_LATE_LOOP(limit, targets)
#define SYMREAL_REAL_TEST(...) __VA_ARGS__
#define SYMREAL_REAL_BREAK(...) if (__VA_ARGS__)
#define SYMREAL_REAL_RETURN(...) return __VA_ARGS__
#define SYMREAL_REAL_DECISIONS(policy)
#define SYMREAL_DECISIONS(policy)
#define SYMREAL_REAL_EXACT
#define SYMREAL_EXACT
#define SYMREAL_RETURNS
#define SYMREAL_RETURNS_OF(kernel)
#define SYMREAL_RETURNS_END

#endif
#endif
