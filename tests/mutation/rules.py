"""The rules that are dropped in turn: for each a program of Inputs that needs it, and tests that look at it."""
from dataclasses import dataclass


@dataclass
class Rule:
    name: str            # as SYMREAL_DROP_RULE has it (rewrite/decide/mutation, runtime/support/mutation)
    what: str            # what the tool does
    program: str         # in Inputs
    tests: str           # a regular expression for lit
    refused: str = ""    # the id with which the program is refused, where that is what the rule is for; and by what, if not `generate`
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
    Rule("function", "makes a function of `<cmath>` one of REALs, as a value", "function.c", "pitfalls/function_addresses"),
    Rule("one_address", "gives it one address, wherever it is taken", "one_address.cpp", "pitfalls/function_addresses"),
    Rule("lists_handed_on", "keeps the numbers of a `va_list` that is handed on", "lists_handed_on.c", "pitfalls/argument_lists"),
    Rule("lists_that_leave", "reports a `va_list` of REALs that a library reads", "lists_that_leave.c", "bad_input/argument_list_leaves",
         refused="SYM031"),
    Rule("argument", "converts an argument in a template as a double is converted", "argument.cpp", "pitfalls/overloads_in_templates"),
    Rule("truth", "gives `sizeof` and `decltype` the type of a comparison", "truth.cpp", "pitfalls/types_of_comparisons"),
    Rule("named", "gives types the names of the original", "named.cpp", "pitfalls/names_of_types"),
    Rule("erased", "gives what is thrown, or kept in a std::any, the type of the original", "erased.cpp", "pitfalls/erased_types",
         options=("--decisions=guard",)),
    Rule("arithmetic", "leaves out what changes the arithmetic of a function", "arithmetic.c", "pitfalls/arithmetic_of_functions.c"),
    Rule("later", "keeps the order of operands", "later.cpp", "pitfalls/operand_order"),
    Rule("now", "keeps the order of arguments", "now.cpp", "pitfalls/operand_order"),
    Rule("SYM120", "compares what types choose in the symbolic program", "choices.cpp", "bad_input/types_asked", refused="SYM120"),
    # Arguments and returned values.
    Rule("SYM203", "reports a section beyond an object whose size is declared", "section.cpp", "bad_input/section_beyond.cpp",
         refused="SYM203"),
    Rule("SYM203", "reports a section beyond what a container has in the run", "section_at_run.cpp", "bad_input/section_beyond_at_run",
         refused="SYM203"),
    Rule("SYM204", "reports a range without samples", "ends.c", "tool/call_refusals", refused="SYM204"),
    Rule("returned_as", "makes what is returned in the type of the function first", "returned_as.cpp", "structures/returned_expressions"),
    Rule("returned_whole", "tells of a returned object that is no output", "handed_over.cpp", "structures/returned_expressions"),
    Rule("handed_over", "takes the room for a returned object for the caller's", "handed_over.cpp", "structures/returned_expressions"),
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
    Rule("asked", "gives an object the type of a comparison and keeps it symbolic", "asked.c", "c/types_asked", options=("--decisions=guard",)),
    Rule("generic", "gives the controlling expression of `_Generic` the type that it has in C", "generic.c", "c/types_asked"),
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
         "tool/scratch_of_one_path"),
    Rule("written", "notes what is written", "written.cpp", "bad_input/kept_constants", refused="SYM053"),
    Rule("changed", "notes what a library changes", "changed.cpp", "bad_input/kept_state", refused="SYM053"),
    Rule("members", "lets a class tell its members", "members.cpp", "tool/constant_objects"),
    Rule("SYM214", "reports a static variable that the first call makes of its inputs", "static_of_inputs.cpp",
         "pitfalls/statics_of_inputs", refused="SYM214"),
    Rule("memory", "reports what a library leaves in the memory of the callers", "left_by_library.cpp", "bad_input/kept_by_libraries",
         refused="SYM053"),
    Rule("scratch_state", "knows a static that every path writes before it reads it", "scratch_state.c",
         "bad_input/scratch_beyond_guards", options=("--decisions=guard",)),
    Rule("written_first", "but only where every path does", "written_first.c", "bad_input/scratch_beyond_guards", refused="SYM053",
         options=("--decisions=guard",)),
    Rule("beyond_guards", "and takes one that only this path writes first for state where a guard stands", "written_first.c",
         "bad_input/scratch_beyond_guards", refused="SYM053", options=("--decisions=guard",)),
    Rule("constant_changed", "looks whether a constant is what it was when the kernel ends", "constant_changed.cpp",
         "tool/call_refusals", refused="SYM053"),
    Rule("SYM215", "reports an effect outside of the program: the environment", "effects.c", "bad_input/effects_outside", refused="SYM215"),
    Rule("SYM215", "the same: the system calls", "system_calls.c", "bad_input/effects_outside", refused="SYM215"),
    Rule("ftell", "notes the result of a function from outside of the program", "position.c", "bad_input/effects_outside",
         refused="SYM017"),
    # Bytes, text and the environment.
    Rule("bits", "asks in the run whether bytes are those of a REAL", "bits.cpp", "bad_input/bytes_at_run", refused="SYM035"),
    Rule("bytes", "the same where bytes are moved", "bytes.cpp", "bad_input/bytes_at_run", refused="SYM035"),
    Rule("SYM035", "reports bytes of a REAL that the source takes for something else", "reinterpretation.cpp", "bad_input/bytes.cpp",
         refused="SYM035"),
    Rule("view", "asks whether numbers behind a pointer to bytes are symbolic", "view.c", "bad_input/bytes_looked_at", refused="SYM035"),
    Rule("part_read", "asks it of the bits that are read", "part_read.c", "bad_input/parts_of_numbers", refused="SYM035"),
    Rule("part_stored", "notes that a part of a number in a union is overwritten", "part_stored.c", "bad_input/parts_of_numbers",
         refused="SYM035"),
    Rule("part_used", "notes that such a number is used", "part_stored.c", "bad_input/parts_of_numbers", refused="SYM035"),
    Rule("part_replaced", "notes that a part of a number is overwritten through a pointer", "part_replaced.c",
         "bad_input/parts_of_numbers", refused="SYM035 SYM199"),
    Rule("bytes_set", "notes that memset overwrites a part of a number", "bytes_set.c", "bad_input/parts_of_numbers", refused="SYM035 SYM199"),
    Rule("bytes_moved", "the same of memcpy", "bytes_moved.c", "bad_input/parts_of_numbers", refused="SYM035 SYM199"),
    Rule("torn", "remembers numbers of which a part was overwritten", "part_stored.c", "bad_input/parts_of_numbers", refused="SYM035"),
    Rule("check_bits", "tells such a number by the check bits of the rest", "check_bits.cpp", "bad_input/torn_elsewhere", refused="SYM199"),
    Rule("list_text", "notes text that is made of a `va_list` of REALs", "list_text.c", "pitfalls/argument_lists", refused="SYM143"),
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
    # Files.
    Rule("baked", "lets a wrapper compare what is baked in", "baked.c", "tool/wrapper_baked.c",
         options=("--wrapper", "--decisions=guard")),
    Rule("SYM095", "reports a returned object that a wrapper cannot make", "more_than_numbers.cpp", "tool/wrapper_returned",
         refused="SYM095", options=("--wrapper",)),
    Rule("SYM187", "reports a result in the place of a file that is read", "returned.c", "tool/outputs_apart", refused="SYM187",
         options=("--graph=returned.c",)),
    Rule("SYM014", "reports two results in one file", "returned.c", "tool/outputs_apart", refused="SYM014", options=("--graph=k.c",)),
    Rule("SYM189", "passes a damaged entry of the cache over", "damaged.c", "tool/cache_damaged"),
    Rule("SYM188", "compares the header beside generated code", "header.c", "tool/verify_header", refused="verify: SYM188"),
    Rule("SYM197", "warns of a dependency file that may lack files", "returned.c", "tool/depfile_unseen", options=("--depfile=k.d",)),
]
