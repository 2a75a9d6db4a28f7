"""The rules of the rewriter that are dropped in turn: for each a program of Inputs that needs it, and tests that look at it."""
from dataclasses import dataclass


@dataclass
class Rule:
    name: str            # as SYMREAL_DROP_RULE has it (rewrite/decide/mutation/drop_rule.cpp)
    what: str            # what the rewriter does
    program: str         # in Inputs
    tests: str           # a regular expression for lit
    refused: str = ""    # the id with which the program is refused, where that is what the rule is for
    options: tuple = ()  # of generate
    flags: tuple = ()    # of the compiler


RULES = [
    # Numbers and what they are given to.
    Rule("returned", "marks the returned value that is an output", "returned.c", "rewrite/pragma_function"),
    Rule("literal", "makes a literal a REAL, so that it chooses the overload of a double", "literal.cpp", "pitfalls/overloads.cpp"),
    Rule("conversion", "writes out a conversion of a REAL", "conversion.cpp", "rewrite/conversions"),
    Rule("cast", "writes out conversions of pointers and enumerations, which C makes by itself", "cast.c", "rewrite/c_source"),
    Rule("shared", "converts by the context where text is compiled with several types", "shared.c", "pitfalls/shared_text"),
    Rule("value", "passes the value through `...`", "value.cpp", "pitfalls/arguments_of_printf"),
    Rule("number_readers", "but not to a function that reads REALs there", "number_readers.cpp", "rewrite/variadic"),
    Rule("function", "makes a function of `<cmath>` one of REALs, as a value", "function.cpp", "pitfalls/functions_as_values"),
    Rule("argument", "converts an argument in a template as a double is converted", "argument.cpp", "pitfalls/overloads_in_templates"),
    Rule("truth", "gives `sizeof` and `decltype` the type of a comparison", "truth.cpp", "pitfalls/types_of_comparisons"),
    Rule("later", "keeps the order of operands", "later.cpp", "pitfalls/operand_order"),
    Rule("now", "keeps the order of arguments", "now.cpp", "pitfalls/operand_order"),
    # Integers and decisions.
    Rule("integer", "lets an integer that is made of a number stay symbolic", "integer.cpp", "pitfalls/unsigned_integers"),
    Rule("table", "looks an element up where the code runs", "table.cpp", "tool/tables"),
    Rule("selects", "makes a select of a decision", "selects.cpp", "tool/selects.cpp", options=("--decisions=select",)),
    # Layouts.
    Rule("padding", "keeps members out of the padding of a base", "padding.cpp", "pitfalls/base_padding"),
    Rule("layouts", "the same, and checks the layout", "padding.cpp", "pitfalls/base_padding"),
    # C.
    Rule("promoted", "makes an argument of a function of C the double that C makes of it", "promoted.c", "pitfalls/functions_of_c"),
    Rule("of_c", "gives an expression the type that it has in C", "of_c.c", "c/sizes"),
    Rule("counted", "computes with an enumeration as C does", "counted.c", "c/enumerations"),
    Rule("width", "computes in the width of a bit-field", "width.c", "c/bit_fields"),
    Rule("enumeration", "lets an operator of assignment change an enumeration", "enumeration.c", "rewrite/c_enumerations"),
    Rule("division", "parts `//` before C99", "division.c", "c/standards", flags=("-std=c89",)),
    Rule("declared", "declares a variable that C defines several times", "declared.c", "rewrite/tentative_definitions"),
    Rule("prototype", "tells the parameters of a function that is declared as before C89", "prototype.c", "rewrite/before_c89"),
    Rule("name", "renames what is a keyword of C++", "name.c", "rewrite/keyword_names"),
    Rule("pasted", "keeps what a macro makes of the spelling `double`", "pasted.c", "rewrite/pasted_types"),
    Rule("quoted", "leaves alone what a macro turns into text", "quoted.cpp", "rewrite/macros"),
    Rule("text_calls", "copies the call of such a macro for symbolic mode", "text_calls.cpp", "rewrite/text_calls"),
    # Libraries.
    Rule("external", "records a call of an external function", "external.c", "tool/external.c"),
    Rule("linkage", "gives an external function of a C source the linkage of C", "external.c", "rewrite/external.c"),
    Rule("boundaries", "reports a function that no source defines", "boundaries.cpp", "rewrite/boundary", refused="SYM030"),
    Rule("SYM031", "reports a REAL that reaches assembly or a library", "boundary_call.cpp", "pitfalls/assembly.cpp", refused="SYM031"),
    # State.
    Rule("read", "notes numbers and integers that are read", "read.cpp", "bad_input/hidden_", refused="SYM017"),
    Rule("range", "notes ranges that a library reads", "range.cpp", "bad_input/hidden_heap", refused="SYM017"),
    Rule("state", "notes uses of static objects", "state.cpp", "bad_input/undeclared_global", refused="SYM017"),
    Rule("local_state", "knows statics of one function that are written before they are read", "local_state.cpp",
         "bad_input/kept_integers"),
    Rule("written", "notes what is written", "written.cpp", "bad_input/kept_constants", refused="SYM053"),
    Rule("changed", "notes what a library changes", "changed.cpp", "bad_input/kept_state", refused="SYM053"),
    Rule("members", "lets a class tell its members", "members.cpp", "tool/constant_objects"),
    # Bytes, text and the environment.
    Rule("bits", "asks in the run whether bytes are those of a REAL", "bits.cpp", "bad_input/bytes_at_run", refused="SYM035"),
    Rule("bytes", "the same where bytes are moved", "bytes.cpp", "bad_input/bytes_at_run", refused="SYM035"),
    Rule("SYM035", "reports bytes of a REAL that the source takes for something else", "reinterpretation.cpp", "bad_input/bytes.cpp",
         refused="SYM035"),
    Rule("formatting", "notes text that is made of REALs", "text.c", "bad_input/text_read_back", refused="SYM143"),
    Rule("text", "notes text that is read", "text.c", "bad_input/text_read_back", refused="SYM143"),
    Rule("environment", "notes errno and the floating-point environment", "environment.c", "bad_input/floating_environment",
         refused="SYM144"),
    # What is only reported.
    Rule("SYM034", "reports a bit-field that a REAL changes", "narrowing.c", "rewrite/boundary", refused="SYM034"),
    Rule("SYM037", "reports what C++ takes for something else", "c_source.c", "c/names", refused="SYM037"),
    Rule("SYM132", "reports layouts that cannot be kept", "class_layout.cpp", "bad_input/class_layout", refused="SYM132"),
    Rule("SYM133", "reports orders that cannot be kept", "evaluation_order.cpp", "bad_input/evaluation_order", refused="SYM133"),
    Rule("SYM146", "reports a pragma that sets the rounding", "fenv_round.cpp", "bad_input/fenv_round", refused="SYM146"),
]
