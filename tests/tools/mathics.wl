(* What Mathics lacks of Mathematica. *)
bits[operation_, x_, y_] := Block[{n = Max[IntegerLength[x, 2], IntegerLength[y, 2], 1]},
  FromDigits[MapThread[operation, {IntegerDigits[x, 2, n], IntegerDigits[y, 2, n]}], 2]]
System`BitAnd[x_, y_] := bits[Times, x, y]
System`BitOr[x_, y_] := bits[Max, x, y]
System`BitXor[x_, y_] := bits[Abs[#1 - #2]&, x, y]
