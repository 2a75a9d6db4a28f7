// The types and enumerators that macros (macros.h) and rewritten sources name. The text of a macro is expanded
// again, by the macros of the program: so all that stands there begins with symreal_, SYMREAL_ or Symreal, and no macro
// of a program may have such a name. Functions and members have theirs where they are declared.
#pragma once

#include <symreal/annotate.h>
#ifdef MBD_SYMBOLIC
#include <symreal/symbolic.h>
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
#endif

} // namespace symreal
