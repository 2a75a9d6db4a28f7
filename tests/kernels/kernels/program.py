"""The source of a batch of kernels, and the program around the original text that lets the harness call it."""
import re

HEADERS = {
    "c": ["math.h", "stdbool.h", "stddef.h", "stdint.h", "stdio.h", "stdlib.h", "string.h"],
    "cxx": ["algorithm", "array", "cmath", "complex", "cstddef", "cstdint", "cstdio", "cstdlib", "cstring", "functional", "map",
            "math.h", "memory", "numeric", "optional", "stdint.h", "stdio.h", "stdlib.h", "string", "tuple", "utility", "vector"],
}


def source(kernels, language):
    """The program, and for each kernel the lines that are its own: 1-based, the last one included."""
    lines = [f"#include <{name}>" for name in HEADERS[language]]
    places = {}
    for kernel in kernels:
        lines.append("")
        first = len(lines) + 1
        lines += kernel.text.splitlines()
        places[kernel.name] = [(first, len(lines))]
    lines += ["", "#ifdef KERNEL_CALLS", "#include KERNEL_CALLS", "#else", "int main(void) {"]
    for kernel in kernels:
        first = len(lines) + 1
        lines += ["  {"] + ["    " + line for line in recorded_call(kernel)] + ["  }"]
        places[kernel.name].append((first, len(lines)))
    lines += ["  return 0;", "}", "#endif"]
    return "\n".join(lines) + "\n", places


def locals_first(kernel):
    """Elements of objects of the caller, then those of state: the inputs in their order."""
    interface = kernel.interface
    return [e for _, elements in interface.inputs + interface.values for e in elements]


def recorded_call(kernel):
    interface = kernel.interface
    lines = [f"static {o}" if not o.startswith("std::") and not o.startswith("double") else o for o in interface.objects]
    lines += [f"{element} = {value!r};" for element, value in zip(locals_first(kernel), kernel.recorded)]
    lines.append(f"{'(void)' if interface.result != 'void' else ''}{kernel.name}({', '.join(interface.arguments)});")
    return lines


def output_elements(kernel):
    return [e for _, elements in kernel.interface.outputs for e in elements]


def probe(path, kernels, language):
    """Includes the original as it is, and calls it."""
    lines = ["#define main original_main", f'#include "{path}"', "#undef main", '#include "harness.h"', ""]
    lines.append('#ifdef __cplusplus\nextern "C" {\n#endif')
    lines += [f"int {kernel.name}_generated(double const *in, double *out);" for kernel in kernels]
    lines.append("#ifdef __cplusplus\n}\n#endif")
    return "\n".join(lines) + "\n" + calls(kernels, lambda kernel: f"{kernel.name}_generated")


def calls(kernels, generated):
    """For each kernel a call on flat arrays, with what is baked in as it is chosen, and the state that it keeps without a name. Through a
    pointer, so that no compiler sees what is called."""
    lines = []
    for kernel in kernels:
        interface = kernel.interface
        lines += [f"static __typeof__({kernel.name}) *volatile {kernel.name}_called = {kernel.name};",
                  f"static void {kernel.name}_original(double const *from, double *into) {{"]
        lines += ["  " + o for o in interface.objects]
        for k, plain in enumerate(interface.plains):
            lines += [f"  if (chosen[{k}] == {j}) {plain.element} = {value};" for j, value in enumerate(plain.values) if j > 0]
        outputs = output_elements(kernel)
        lines += [f"  {e} = into[{k}];" for k, e in enumerate(outputs) if "result" not in e]
        lines += [f"  {e} = from[{k}];" for k, e in enumerate(locals_first(kernel))]
        call = f"{kernel.name}_called({', '.join(interface.arguments)});"
        lines.append(f"  {f'{interface.result} result = ' if interface.result != 'void' else ''}{call}")
        lines += [f"  into[{k}] = {e};" for k, e in enumerate(outputs)]
        lines += ["}"]
        lines += [f"static void {kernel.name}_hidden(double *out) {{", "  (void)out;"]
        lines += [f"  out[{k}] = (double){e};" for k, e in enumerate(interface.hidden)]
        lines += ["}"]
    for kernel in kernels:
        lines.append(f"static double const {kernel.name}_recorded[] = {{{', '.join(map(repr, kernel.recorded))}}};")
    lines.append("struct kernel const kernels[] = {")
    for kernel in kernels:
        interface = kernel.interface
        outputs = output_elements(kernel)
        state = [(k, locals_first(kernel).index(e)) for k, e in enumerate(outputs) if e in locals_first(kernel)]
        fields = [f'"{kernel.name}"', f"{len(locals_first(kernel))}", f"{len(outputs)}", f"{len(interface.hidden)}",
                  f"{int(interface.tame)}", repr(interface.low), repr(interface.high), f"{kernel.name}_recorded",
                  f"{kernel.name}_original", generated(kernel), f"{kernel.name}_hidden",
                  "{" + ", ".join(str(dict(state).get(k, -1)) for k in range(len(outputs))) + "}"]
        lines.append("  {" + ", ".join(fields) + "},")
    lines += ["};", f"int const kernel_count = {len(kernels)};"]
    return "\n".join(lines) + "\n"


def beside_others(name, path, own=(), before=()):
    """Lines that include generated code, which lies at `path`, in a file with that of others: its helpers and what is its `own` begin
    with the kernel's name there, also in the lines `before`."""
    with open(path) as file:
        helpers = re.findall(r"^(?:static [\w ]*?(?=\w+[(\[])|union |struct )(\w+)", file.read(), flags=re.M)
    renamed = list(dict.fromkeys([*own, *helpers]))
    return [*(f"#define {one} {name}_{one}" for one in renamed), *before, f'#include "{path}"', *(f"#undef {one}" for one in renamed)]


def glue(kernel, path, banner):
    """The generated code of one kernel as a function of flat arrays."""
    name = kernel.name
    lines = beside_others(name, path, ["compute", "preprocess", "guard_text"], [f"#define {name.upper()}_H", declarations(banner)])
    lines += [f"int {name}_generated(double const *in, double *out);",
              f"int {name}_generated(double const *from, double *into) {{",
              f"  double constants[{banner['constants'] + 1}] = {{0}};",
              f"  {name}_preprocess(from + {banner['inputs']}, constants);" if banner["constants"] else "",
              f"  return {name}_compute(from, constants, into);" if banner.get("guards") else
              f"  {name}_compute(from, constants, into);\n  return 0;",
              "}"]
    return "\n".join(lines) + "\n"


def declarations(banner):
    kind = "int" if banner.get("guards") else "void"
    return ("void preprocess(double const *parameters, double *constants);\n"
            f"{kind} compute(double const *input, double const *constants, double *output);\n"
            "char const *guard_text(int guard);")
