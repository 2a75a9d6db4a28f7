// Names of types and enumerators for macros (macros.h) and rewritten sources. The text of a macro is expanded again, by
// the macros of the program: so all that stands there begins with symreal_, SYMREAL_ or Symreal, and no macro of a
// program may have such a name. Functions and members have theirs where they are declared.
#pragma once

// Macros of the program, from its command line or from before this point, are not seen within our headers.
#include <symreal/names_hide.h>

#include <symreal/allocator.h>
#include <symreal/annotate.h>
#include <symreal/enumerators.h>
#include <symreal/fit.h>
#include <symreal/library_conversions.h>
#include <symreal/object_layout.h>
#ifdef MBD_SYMBOLIC
#include <symreal/symbolic.h>
#include <symreal/type_names.h>
#endif
#ifdef SYMREAL_SOURCE_OF_C // a header may be included by C and by C++
#include <symreal/of_c.h>
#endif

#include <type_traits>

namespace symreal {

using SymrealFunctionKernel = FunctionKernel;
inline constexpr Kind symreal_kind_input = Kind::input;
inline constexpr Kind symreal_kind_parameter = Kind::parameter;
inline constexpr Kind symreal_kind_constant = Kind::constant;
inline constexpr Kind symreal_kind_scratch = Kind::scratch;
inline constexpr Kind symreal_kind_output = Kind::output;

template <class T> using symreal_pointer_to = T *;

#ifdef MBD_SYMBOLIC
using SymrealReal = RealNumber;
template <class T> using SymrealInt = SymbolicInt<T>;
template <class T> using symreal_class_of = std::remove_cvref_t<T>;
using SymrealNumbers = Numbers;
using SymrealBytes = Bytes;
using SymrealFormat = Format;
using SymrealShows = Shows;
using SymrealTargets = Targets;
using SymrealBranch = Branch;
using SymrealLoop = Loop;
using SymrealReturns = Returns;
using SymrealDecisionScope = DecisionScope;
using SymrealExactScope = ExactScope;
inline constexpr Decisions symreal_decisions_error = Decisions::error;
inline constexpr Decisions symreal_decisions_guard = Decisions::guard;
inline constexpr Decisions symreal_decisions_select = Decisions::select;
inline constexpr Decisions symreal_decisions_carry = Decisions::carry;
#ifdef SYMREAL_ARGUMENTS_FIRST
constexpr bool symreal_shown_first = true;
#else
constexpr bool symreal_shown_first = false;
#endif
#endif

} // namespace symreal

#include <symreal/names_show.h>

// A type of C, whose sources are compiled as C++ here.
#ifndef _Bool
#define _Bool bool
#endif
