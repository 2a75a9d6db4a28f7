#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

// Names begin with small letters, which excludes those of the system.
static constexpr auto keywords =
    std::to_array<std::string_view>({"exact", "exponent", "failedGuard", "guard", "inputAt", "outputAt", "pack",
                                     "parameterAt", "real", "return", "shape", "unpack"});
static_assert(std::ranges::is_sorted(keywords));

// Mathematica's comparisons treat nearly equal numbers as equal, except with 0. Results that are not real numbers are
// Indeterminate, for which every condition fails.
static constexpr OperationSpelling spellings[] = {
    {Op::abs, "Abs[$x]"},
    {Op::sqrt, "real[Sqrt[$x]]"},
    {Op::div, "Divide[$x, $y]"},
    {Op::fmin, "Min[$x, $y]"},
    {Op::fmax, "Max[$x, $y]"},
    {Op::floor, "N[Floor[$x]]"},
    {Op::ceil, "N[Ceiling[$x]]"},
    {Op::trunc, "N[IntegerPart[$x]]"},
    {Op::rint, "N[Round[$x]]"},
    {Op::f32, "single[$x]"},
    {Op::wrap_int8, "wrapped[$x, 8]"},
    {Op::wrap_int16, "wrapped[$x, 16]"},
    {Op::wrap_int32, "wrapped[$x, 32]"},
    {Op::wrap_uint8, "lowBits[$x, 8]"},
    {Op::wrap_uint16, "lowBits[$x, 16]"},
    {Op::wrap_uint32, "lowBits[$x, 32]"},
    {Op::wide_add, "Mod[$x + $y, 2^64]"},
    {Op::wide_sub, "Mod[$x - $y:13, 2^64]"},
    {Op::wide_mul, "Mod[$x:13*$y:14, 2^64]"},
    {Op::wide_select, "If[TrueQ[$x], $y, $z]"},
    {Op::wide_value, "N[signed[$x]]"},
    {Op::wide_uvalue, "N[$x]"},
    {Op::wide_low, "N[Mod[$x, 2^32]]"},
    {Op::sin, "Sin[$x]"},
    {Op::cos, "Cos[$x]"},
    {Op::tan, "Tan[$x]"},
    {Op::asin, "real[ArcSin[$x]]"},
    {Op::acos, "real[ArcCos[$x]]"},
    {Op::atan, "ArcTan[$x]"},
    {Op::sinh, "Sinh[$x]"},
    {Op::cosh, "Cosh[$x]"},
    {Op::tanh, "Tanh[$x]"},
    {Op::asinh, "ArcSinh[$x]"},
    {Op::acosh, "real[ArcCosh[$x]]"},
    {Op::atanh, "real[ArcTanh[$x]]"},
    {Op::exp, "Exp[$x]"},
    {Op::exp2, "Power[2.0`, $x]"},
    {Op::log, "real[Log[$x]]"},
    {Op::log2, "real[Log2[$x]]"},
    {Op::log10, "real[Log10[$x]]"},
    {Op::erf, "Erf[$x]"},
    {Op::erfc, "Erfc[$x]"},
    {Op::tgamma, "Gamma[$x]"},
    {Op::lgamma, "Re[LogGamma[$x]]"},
    {Op::lt, "$x:12 - $y:13 < 0", 10},
    {Op::le, "$x:12 - $y:13 <= 0", 10},
    {Op::gt, "$x:12 - $y:13 > 0", 10},
    {Op::ge, "$x:12 - $y:13 >= 0", 10},
    {Op::eq, "$x:12 - $y:13 == 0", 10},
    {Op::ne, "$x:12 - $y:13 != 0", 10},
    {Op::select, "If[TrueQ[$x], $y, $z]"},
};

static constexpr Helper helpers[] = {
    {"real", "real[x_Complex] := Indeterminate\nreal[x_] := x\n"},
    {"exact", R"((* The number as a fraction. *)
exact[x_] := Block[{f = FractionalPart[x]*2.0`^537},
  IntegerPart[x] + (IntegerPart[f] + IntegerPart[FractionalPart[f]*2.0`^537]/2^537)/2^537]
)"},
    {"nearest", R"((* The integer next to a fraction, the even one of two. *)
nearest[fraction_] := Block[{n = Floor[fraction + 1/2]}, If[n - fraction == 1/2 && OddQ[n], n - 1, n]]
)"},
    {"exponent", "exponent[fraction_] := IntegerLength[IntegerPart[Abs[fraction]*2^1074], 2] - 1075\n"},
    {"fma", "fma[x_, y_, z_] := N[exact[x]*exact[y] + exact[z]]\n"},
    {"cbrt", R"(cbrt[x_] := Block[{r = CubeRoot[x]}, If[r == 0, r, r - (r - Divide[x, r*r])/3]]
)"},
    {"hypot", R"(hypot[x_, y_] := Block[{a = Max[Abs[x], Abs[y]], b = Min[Abs[x], Abs[y]]},
  If[a == 0, a, a*Sqrt[1 + (b/a)^2]]]
)"},
    {"fdim", "fdim[x_, y_] := If[x - y <= 0, 0.0`, x - y]\n"},
    {"fmod", R"(fmod[x_, y_] := If[y == 0, Indeterminate,
  Block[{a = exact[x], b = exact[y]}, N[a - b*IntegerPart[a/b]]]]
)"},
    {"remainder", R"(remainder[x_, y_] := If[y == 0, Indeterminate,
  Block[{a = exact[x], b = exact[y]}, N[a - b*nearest[a/b]]]]
)"},
    {"round", R"(round[x_] := Block[{t = IntegerPart[x]}, N[If[Abs[x - t] >= 0.5`, t + Sign[x], t]]]
)"},
    {"copysign", "copysign[x_, y_] := If[y < 0, -Abs[x], Abs[x]]\n"},
    {"nextafter", R"(nextafter[x_, y_] := Block[{a = exact[x], s = Sign[y - x], e},
  e = exponent[a];
  If[s*a < 0 && Abs[a] == 2^e, e = e - 1];
  If[s == 0, y, N[a + s*2^Max[e - 52, -1074]]]]
)"},
    {"logb", "logb[x_] := If[x == 0, -Infinity, N[exponent[exact[x]]]]\n"},
    {"single", R"(single[x_] := Block[{a = exact[x], u},
  u = 2^(Max[exponent[a], -126] - 23);
  a = nearest[a/u]*u;
  If[Abs[a] < 2^128, N[a], Sign[a]*Infinity]]
)"},
    {"atan2",
     R"(atan2[y_, x_] := Which[x == 0 && y == 0, 0.0`, Abs[x] < Abs[y]*2.0`^-60, N[Sign[y]*Pi/2], True, ArcTan[x, y]]
)"},
    {"expm1", "expm1[x_] := If[Abs[x] < 1, 2*Exp[x/2]*Sinh[x/2], Exp[x] - 1]\n"},
    {"log1p", "log1p[x_] := real[If[Abs[x] < 0.5`, 2*ArcTanh[x/(2 + x)], Log[1 + x]]]\n"},
    {"pow", "pow[x_, y_] := If[x - 1 == 0 || y == 0, 1.0`, real[Power[x, y]]]\n"},
    {"tableIndex", R"((* An index outside of its table reads the nearest element. *)
tableIndex[index_, extent_] := If[TrueQ[index > 0], Min[IntegerPart[index], extent - 1], 0]
)"},
    {"signed", "signed[x_] := If[x >= 2^63, x - 2^64, x]\n"},
    {"toInt32", R"(toInt32[x_] := N[If[TrueQ[x > -2147483649 && x < 2147483648], IntegerPart[x], -2^31]]
)"},
    {"whole", "whole[x_] := If[TrueQ[x >= -2^63 && x < 2^63], IntegerPart[x], -2^63]\n"},
    {"toInt64", "toInt64[x_] := N[whole[x]]\n"},
    {"lowBits", "lowBits[x_, width_] := N[Mod[whole[x], 2^width]]\n"},
    {"wrapped", R"(wrapped[x_, width_] := Block[{low = Mod[whole[x], 2^width]},
  N[If[low >= 2^(width - 1), low - 2^width, low]]]
)"},
    {"wideInt", "wideInt[x_] := Mod[whole[x], 2^64]\n"},
    {"wideUint", "wideUint[x_] := If[TrueQ[x >= 2^63 && x < 2^64], IntegerPart[x], wideInt[x]]\n"},
    {"wide", "wide[high_, low_] := Mod[whole[high]*2^32, 2^64] + Mod[whole[low], 2^32]\n"},
    {"intDiv", "intDiv[x_, y_] := If[y == 0, Indeterminate, N[IntegerPart[exact[x]/exact[y]]]]\n"},
    {"intNeg", "intNeg[x_] := -x\n"},
    {"mulUint32", "mulUint32[x_, y_] := N[Mod[whole[x]*whole[y], 2^32]]\n"},
    {"quotient", "quotient[x_, y_] := If[y == 0, 0, IntegerPart[x/y]]\n"},
    {"rest", "rest[x_, y_] := If[y == 0, 0, x - y*IntegerPart[x/y]]\n"},
    {"wideDiv", "wideDiv[x_, y_] := Mod[quotient[signed[x], signed[y]], 2^64]\n"},
    {"wideRem", "wideRem[x_, y_] := Mod[rest[signed[x], signed[y]], 2^64]\n"},
    {"wideUdiv", "wideUdiv[x_, y_] := quotient[x, y]\n"},
    {"wideUrem", "wideUrem[x_, y_] := rest[x, y]\n"},
    {"wideAnd", "wideAnd[x_, y_] := BitAnd[x, y]\n"},
    {"wideOr", "wideOr[x_, y_] := BitOr[x, y]\n"},
    {"wideXor", "wideXor[x_, y_] := BitXor[x, y]\n"},
    {"wideShl", "wideShl[x_, n_] := Mod[x*2^Mod[n, 64], 2^64]\n"},
    {"wideShr", "wideShr[x_, n_] := Mod[Floor[signed[x]/2^Mod[n, 64]], 2^64]\n"},
    {"wideUshr", "wideUshr[x_, n_] := Floor[x/2^Mod[n, 64]]\n"},
    {"wideLess", "wideLess[x_, y_] := signed[x] < signed[y]\n"},
    {"guard", "guard[False, number_] := Null\nguard[condition_, number_] := Throw[number, failedGuard]\n"},
};

static constexpr Companion beside[] = {{"_main.wl", module_main, "mainline"}};

Language language_mathematica() {
  Language table;
  table.names = {.keywords = keywords, .has_underscores = false};
  table.has_namespace = true;
  table.comment = {"(* ", "   ", " *)"};
  table.lines = {.width = 100, .least = 60};
  table.numbers = {"Indeterminate", "Indeterminate", "Infinity", "-Infinity", "`*^", "`"};
  table.number = {"", "0.0`"};
  table.truth = {"", "False"};
  table.wide = {"", "0"};
  table.expressions = {
      .call_open = "[",
      .call_close = "]",
      .operations = spellings,
      .element = "$array[[$index]]",
      .first_index = 1,
      .yes = "True",
      .truth_as_number = "N[Boole[$x]]",
      .small_integer = "$value",
      .large_integer = "$value",
      .kept_integer = "$element",
      .table_index = "tableIndex[$index, $extent]",
  };
  table.statements = {
      .variable = "$name = $value;",
      .constant = "$name = $value;",
      .set = "$name = $value;",
      .keep_integer = "$element = $value;",
      .array = "$name = Table[0.0`, {$count}];",
      .zero_array = "$name = Table[0.0`, {$count}];",
      .open = "If[TrueQ[$condition],",
      .otherwise = ",",
      .close = "];",
      .check = "guard[$condition, $number];",
  };
  table.functions = {
      .head = "${name}Values[$parameters] := Module[",
      .local_head = "SetAttributes[$name, HoldAll]; $name[$parameters] := Module[",
      .end = "]\n",
      .input = "${name}_",
      .local_output = "${name}_",
      .locals = "{$names},",
      .no_locals = "{},",
      .results = "$name = Table[0.0`, {$count}];",
      .finish = "$name",
      .call = "$name[$arguments];",
      .checked_call = "$name[$arguments];",
  };
  table.tables = {.begin = "$name = {", .end = "};"};
  table.files = {
      .extension = ".wl",
      .kept_when = ", but for functions\nof Mathematica's own, signs of zeros, and values that are not finite",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  table.module = {
      .begin = "\nBeginPackage[\"${module}`\"];\n\n",
      .size = "$name = $value;\n",
      .index_list = "$name = {$values};\n",
      .places = {.begin = "\n(* The index of the first number of each $role, and its extents. *)\n${role}At = <|\n",
                 .end = "\n|>;\n",
                 .object = "  \"$name\" -> {$first, {$extents}}",
                 .separator = ",\n"},
      .functions = R"(
$preprocess::usage = "$preprocess[parameters] gives the constants of $compute for a list of $parameters parameters.";
$compute::usage = "$compute[input, constants] gives the list of $outputs outputs for a list of $inputs inputs.";
pack::usage = "pack[<|\"q\" -> {1, 2}, ...|>, inputAt] gives the list of the numbers of objects.";
unpack::usage = "unpack[numbers, outputAt] gives the objects of a list of numbers.";
pack::count = "`1` has `2` numbers, not `3`.";

Begin["`Private`"];

$preprocess[parameters_List: {}] := result[${preprocess}Values[N[parameters]]]
$compute[input_List] := $compute[input, $preprocess[]]
$compute[input_List, constants_List] := result[${compute}Values[N[input], constants]]

(* A guard that does not hold gives a Failure, with its number and its text. *)
SetAttributes[result, HoldFirst];
result[values_] := Catch[values, failedGuard, failure[#]&]
failure[number_] := Failure["Guard", <|"MessageTemplate" -> "guard `1` does not hold: `2`",
  "MessageParameters" -> {number, $guard_text[number]}, "Number" -> number|>]

pack[objects_, at_] := Catch[Flatten[Map[numbers[objects, at, #]&, Keys[at]]], pack]
numbers[objects_, at_, name_] := Block[{values = Flatten[{objects[name]}], count = Apply[Times, at[name][[2]]]},
  If[Length[values] != count, Message[pack::count, name, Length[values], count]; Throw[$$Failed, pack]];
  N[values]]

unpack[values_, at_] := Association[Map[# -> shape[values, at[#]]&, Keys[at]]]
shape[values_, {first_, {}}] := values[[first]]
shape[values_, {first_, extents_}] := Fold[Partition, Take[values, {first, first + Apply[Times, extents] - 1}],
  Reverse[Rest[extents]]]

)",
      .guards_begin = "(* The condition of a guard and its places in the source. *)\n$guard_text[number_] := {\n",
      .guard = "  $text,\n",
      .guards_end = "  \"\"}[[number]]\n\n",
      .end = "End[];\n\nEndPackage[];\n",
      .main = R"(
(* Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
   Where onlyDefines is True, it is read for its function run, of a list of numbers. *)
Get[FileNameJoin[{DirectoryName[$$InputFileName], "$base.wl"}]];

recorded = {$all_values};
labels = {$labels};

number[text_] := Which[text == "inf", Infinity, text == "-inf", -Infinity, text == "nan", Indeterminate, True,
  With[{parts = StringSplit[text, "e"]},
    N[ToExpression[First[parts] <> "`" <> If[Length[parts] > 1, "*^" <> StringReplace[parts[[2]], "+" -> ""], ""]]]]]

show[x_Real] := StringReplace[ToString[x, InputForm], {"`" -> "", "*^" -> "e"}]
show[x_] := Which[IntegerQ[x], ToString[x], x === Infinity, "inf", x === -Infinity, "-inf", True, "nan"]

run[given_] := Block[{values, output},
  values = Join[given, Drop[recorded, Length[given]]];
  output = Quiet[$module`$compute[Take[values, $inputs], $module`$preprocess[Drop[values, $inputs]]]];
  If[ListQ[output],
    MapThread[Print[#1 <> " = " <> show[#2]]&, {labels, output}]; 0,
    WriteString["stderr", "guard ", ToString[output[[2]]["Number"]], " does not hold: ",
      output[[2]]["MessageParameters"][[2]], "\n"]; 1]]

If[!TrueQ[onlyDefines] && run[Map[number, If[$$ScriptCommandLine === {}, {}, Rest[$$ScriptCommandLine]]]] != 0, Exit[1]]
)",
      .call = "",
      .checked_call = "",
  };
  return table;
}

} // namespace symreal
