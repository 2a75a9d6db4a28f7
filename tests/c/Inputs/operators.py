"""Writes a program in C that prints every operator's result, and its size, for pairs of operands of all integer types."""

# Name, how an operand of the type is written for a left and for a right side, with their values. `{}` declares one.
DECLARED = [
    ("_Bool", "_Bool {}", 1, 1),
    ("uchar", "unsigned char {}", 255, 3),
    ("ushort", "unsigned short {}", 65535, 3),
    ("int", "int {}", -7, 2),
    ("uint", "unsigned {}", 4294967295, 3),
    ("long", "long {}", -7, 3),
    ("ulong", "unsigned long {}", 18446744073709551615, 3),
    ("mode", "enum mode {}", 0, 2),
    ("sign", "enum sign {}", -1, 1),
    ("wide", "enum wide {}", 2147483648, 1),
]
MEMBERS = [
    ("u3", "unsigned {}:3", 7, 3),
    ("u32", "unsigned {}:32", 4294967295, 3),
    ("l20", "unsigned long {}:20", 1048575, 3),
    ("l33", "unsigned long {}:33", 8589934591, 3),
    ("b40", "unsigned long long {}:40", 1099511627775, 7),
    ("s40", "long long {}:40", -7, 3),
    ("m2", "enum mode {}:2", 0, 2),
    ("m32", "enum mode {}:32", 0, 2),
]
CONSTANTS = [("character", "'\\371'", "'\\3'"), ("truth", "(one == 2)", "(one == 1)"), ("enumerator", "OFF", "AUTO"),
             ("first_wide", "LOW", "ONE")]
# Right sides: one of each kind.
RIGHT = {"uchar", "int", "uint", "long", "mode", "wide", "u32", "b40", "s40", "character", "truth", "first_wide"}
RIGHT_OF_COMPOUND = {"int", "uint", "long", "mode", "s40", "first_wide"}
BINARY = ["+", "-", "*", "/", "%", "&", "|", "^", "<<", ">>", "<", "<=", "==", "!=", "&&", "||"]
UNARY = ["+", "-", "~", "!"]
COMPOUND = ["+=", "-=", "*=", "/=", "%=", "|=", ">>="]


def literal(value):
    return f"{value}UL" if value > 2**63 - 1 else f"{value}L"


def operands():
    for name, _, left, right in DECLARED:
        yield name, "left_" + name, "right_" + name, left, right
    for name, _, left, right in MEMBERS:
        yield name, "left." + name, "right." + name, left, right
    for name, left, right in CONSTANTS:
        yield name, left, right, left, right


def put(label, expression, sized=True):
    size = f"sizeof({expression})" if sized else "0"
    return f'    put("{label}", (double)({expression}), {size});'


def main():
    print("#include <stdio.h>")
    print("enum mode { OFF, ON, AUTO };\nenum sign { MINUS = -1, ZERO, PLUS };\nenum wide { LOW, ONE, HIGH = 0x80000000 };")
    print("struct fields {\n" + "".join(f"    {form.format(name)};\n" for name, form, _, _ in MEMBERS) + "};")
    print("static struct fields left, right;\nstatic int one = 1;")
    for name, form, left, right in DECLARED:
        print(f"static {form.format('left_' + name)}, right_{name};")
    print('static void put(char const *what, double value, unsigned long size)\n'
          '{\n    printf("%s: %.17g %lu\\n", what, value, size);\n}')
    functions = []

    def function(lines):
        functions.append(f"part_{len(functions)}")
        print(f"static void {functions[-1]}(void)\n{{\n" + "\n".join(lines) + "\n}")

    print("static void start(void)\n{")
    for name, left_text, right_text, left, right in operands():
        if isinstance(left, int):
            print(f"    {left_text} = {literal(left)};\n    {right_text} = {literal(right)};")
    print("}")
    all_operands = list(operands())
    for name, left, _, value, _ in all_operands:
        lines = []
        for other, _, right, _, right_value in all_operands:
            if other not in RIGHT:
                continue
            types = f"({name}, {other})"
            for operator in BINARY:
                shown = f"{value} {operator} {right_value} {types}".replace("\\", "\\\\").replace("%", "%%")
                lines.append(put(shown.replace("%%", "%"), f"{left} {operator} {right}"))
            lines.append(put(f"?: {types}", f"one ? {left} : {right}"))
            lines.append(put(f"comma {types}", f"({left}, {right} + 0)"))
        for operator in UNARY:
            lines.append(put(f"{operator} ({name})", f"{operator}{left}"))
        lines.append(put(f"of three ({name})", f"one ? {left} - 1 : 2 - {left} * 3"))
        lines.append(put(f"chain ({name})", f"({left} + 1) / 2 - {left} % 5 * 2 < 0"))
        function(lines)
    for name, left, _, value, _ in all_operands:
        # Not for bit-fields of an enumeration, which symbolic mode refuses to change so.
        if not isinstance(value, int) or name in ("m2", "m32"):
            continue
        lines = []
        for other, _, right, _, _ in all_operands:
            if other not in RIGHT_OF_COMPOUND:
                continue
            for operator in COMPOUND:
                lines += ["    start();", f"    {left} {operator} {right};",
                          put(f"{name} {operator} {other}", f"{left}", sized=False)]
        if name != "_Bool":  # C++ has no ++ for it
            for operator in ["++", "--"]:
                lines += ["    start();", f"    {left}{operator};", put(f"{name}{operator}", left, sized=False)]
        lines.append("    start();")
        function(lines)
    print("int main(void)\n{\n    start();")
    print("".join(f"    {name}();\n" for name in functions) + "    return 0;\n}")


main()
