"""What a kernel may be made of. Each kernel draws its own set: a fault shows more often where it is not one of many things."""

# Feature: the probability that a kernel has it.
COMMON = {
    "integers": 0.8, "unsigned": 0.5, "small_integers": 0.4, "wide_integers": 0.3, "bits": 0.4, "casts": 0.5,
    "symbolic_integers": 0.35, "implicit_conversions": 0.2, "truth_values": 0.3, "sizeof": 0.2, "sizeof_truth": 0.1,
    "characters": 0.15, "math": 0.8, "math_integers": 0.3, "wild": 0.4, "conditional": 0.4,
    "bare_conditions": 0.2, "arrays": 0.5, "computed_indices": 0.6, "symbolic_index_writes": 0.05, "pointers": 0.3,
    "branches": 0.6, "switch": 0.2, "loops": 0.5, "computed_bounds": 0.5, "symbolic_bounds": 0.15, "exits": 0.2, "returns": 0.25,
    "helpers": 0.5, "integer_arguments": 0.5, "tables": 0.4, "enumerations": 0.25, "structs": 0.4, "bit_fields": 0.4,
    "wide_bit_fields": 0.2, "state": 0.25, "text": 0.1, "parameters": 0.3, "statics": 0.2, "library_memory": 0.2, "whole_objects": 0.5,
    "function_values": 0.2, "parts": 0.2, "plain_arguments": 0.15, "returned_objects": 0.2,
}
C = {}
CXX = {"templates": 0.35, "overloads": 0.3, "lambdas": 0.3, "complex": 0.15, "containers": 0.3, "operators": 0.3, "classes": 0.3,
       "algorithms": 0.3, "references": 0.3}

# What the tool refuses, by its design, nearly always; "decisions" under the policy error. A refusal costs all kernels of its
# program another compilation, so only some kernels in a row may have these, more often then.
REFUSED = {"decisions": 0.4, "undeclared_state": 0.3, "text_read_back": 0.25, "unwritten_outputs": 0.25,
           "float": 0.2, "statics_of_inputs": 0.25, "undeclared_memory": 0.25, "parts_written": 0.25}
REFUSED_CXX = {"order": 0.2}
# The generator knows the diagnostic of each, and a kernel that is taken is a fault.
MUST_BE_REFUSED = {"statics_of_inputs", "undeclared_memory", "parts_written"}
REFUSED_IN = range(900, 1000)  # of each thousand


def features(language):
    return COMMON | (C if language == "c" else CXX) | refused(language)


def refused(language):
    return REFUSED if language == "c" else REFUSED | REFUSED_CXX


def drawn(random, language, index, excluded, often=()):
    left_out = set(excluded) | (set() if index % 1000 in REFUSED_IN else set(refused(language)))
    return {name for name, probability in features(language).items() if random.random() < (0.7 if name in often else probability)} - left_out


# What is known to be wrong and not repaired yet: `run.py --open` includes it.
OPEN = {}
# The same with `--record=instructions`.
OPEN_INSTRUCTIONS = {
    "returned_objects": "a structure of C that is returned through a hidden pointer counts as state of the caller: SYM053",
}
