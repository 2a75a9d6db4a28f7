(* Helpers of Mathematica, and the code around functions, for mathematica.toml. Marks: language_file.h. *)

(* @helper real *)
real[x_Complex] := Indeterminate
real[x_] := x

(* @helper exact *)
(* The number as a fraction. *)
exact[x_] := Block[{f = FractionalPart[x]*2.0`^537},
  IntegerPart[x] + (IntegerPart[f] + IntegerPart[FractionalPart[f]*2.0`^537]/2^537)/2^537]

(* @helper nearest *)
(* The integer next to a fraction, the even one of two. *)
nearest[fraction_] := Block[{n = Floor[fraction + 1/2]}, If[n - fraction == 1/2 && OddQ[n], n - 1, n]]

(* @helpers *)
exponent[fraction_] := IntegerLength[IntegerPart[Abs[fraction]*2^1074], 2] - 1075
fma[x_, y_, z_] := N[exact[x]*exact[y] + exact[z]]
cbrt[x_] := Block[{r = CubeRoot[x]}, If[r == 0, r, r - (r - Divide[x, r*r])/3]]

(* @helper hypot *)
hypot[x_, y_] := Block[{a = Max[Abs[x], Abs[y]], b = Min[Abs[x], Abs[y]]},
  If[a == 0, a, a*Sqrt[1 + (b/a)^2]]]

(* @helpers *)
fdim[x_, y_] := If[x - y <= 0, 0.0`, x - y]

(* @helper fmod *)
fmod[x_, y_] := If[y == 0, Indeterminate,
  Block[{a = exact[x], b = exact[y]}, N[a - b*IntegerPart[a/b]]]]

(* @helper remainder *)
remainder[x_, y_] := If[y == 0, Indeterminate,
  Block[{a = exact[x], b = exact[y]}, N[a - b*nearest[a/b]]]]

(* @helpers *)
round[x_] := Block[{t = IntegerPart[x]}, N[If[Abs[x - t] >= 0.5`, t + Sign[x], t]]]
copysign[x_, y_] := If[y < 0, -Abs[x], Abs[x]]

(* @helper nextafter *)
nextafter[x_, y_] := Block[{a = exact[x], s = Sign[y - x], e},
  e = exponent[a];
  If[s*a < 0 && Abs[a] == 2^e, e = e - 1];
  If[s == 0, y, N[a + s*2^Max[e - 52, -1074]]]]

(* @helpers *)
logb[x_] := If[x == 0, -Infinity, N[exponent[exact[x]]]]

(* @helper single *)
single[x_] := Block[{a = exact[x], u},
  u = 2^(Max[exponent[a], -126] - 23);
  a = nearest[a/u]*u;
  If[Abs[a] < 2^128, N[a], Sign[a]*Infinity]]

(* @helpers *)
atan2[y_, x_] := Which[x == 0 && y == 0, 0.0`, Abs[x] < Abs[y]*2.0`^-60, N[Sign[y]*Pi/2], True, ArcTan[x, y]]
expm1[x_] := If[Abs[x] < 1, 2*Exp[x/2]*Sinh[x/2], Exp[x] - 1]
log1p[x_] := real[If[Abs[x] < 0.5`, 2*ArcTanh[x/(2 + x)], Log[1 + x]]]
pow[x_, y_] := If[x - 1 == 0 || y == 0, 1.0`, real[Power[x, y]]]

(* @helper tableIndex *)
(* An index outside of its table reads the nearest element. *)
tableIndex[index_, extent_] := If[TrueQ[index > 0], Min[IntegerPart[index], extent - 1], 0]

(* @helpers *)
signed[x_] := If[x >= 2^63, x - 2^64, x]
toInt32[x_] := N[If[TrueQ[x > -2147483649 && x < 2147483648], IntegerPart[x], -2^31]]
whole[x_] := If[TrueQ[x >= -2^63 && x < 2^63], IntegerPart[x], -2^63]
toInt64[x_] := N[whole[x]]
lowBits[x_, width_] := N[Mod[whole[x], 2^width]]

(* @helper wrapped *)
wrapped[x_, width_] := Block[{low = Mod[whole[x], 2^width]},
  N[If[low >= 2^(width - 1), low - 2^width, low]]]

(* @helpers *)
wideInt[x_] := Mod[whole[x], 2^64]
wideUint[x_] := If[TrueQ[x >= 2^63 && x < 2^64], IntegerPart[x], wideInt[x]]
wide[high_, low_] := Mod[whole[high]*2^32, 2^64] + Mod[whole[low], 2^32]
intDiv[x_, y_] := If[y == 0, Indeterminate, N[IntegerPart[exact[x]/exact[y]]]]
intNeg[x_] := -x
mulUint32[x_, y_] := N[Mod[whole[x]*whole[y], 2^32]]
quotient[x_, y_] := If[y == 0, 0, IntegerPart[x/y]]
rest[x_, y_] := If[y == 0, 0, x - y*IntegerPart[x/y]]
wideDiv[x_, y_] := Mod[quotient[signed[x], signed[y]], 2^64]
wideRem[x_, y_] := Mod[rest[signed[x], signed[y]], 2^64]
wideUdiv[x_, y_] := quotient[x, y]
wideUrem[x_, y_] := rest[x, y]
wideAnd[x_, y_] := BitAnd[x, y]
wideOr[x_, y_] := BitOr[x, y]
wideXor[x_, y_] := BitXor[x, y]
wideShl[x_, n_] := Mod[x*2^Mod[n, 64], 2^64]
wideShr[x_, n_] := Mod[Floor[signed[x]/2^Mod[n, 64]], 2^64]
wideUshr[x_, n_] := Floor[x/2^Mod[n, 64]]
wideLess[x_, y_] := signed[x] < signed[y]

(* @helper guard *)
guard[False, number_] := Null
guard[condition_, number_] := Throw[number, failedGuard]

(* @text module.functions *)

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


(* @text module.main *)

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
