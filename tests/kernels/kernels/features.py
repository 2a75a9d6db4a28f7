"""What a kernel may be made of. Each kernel draws its own set: a fault shows more often where it is not one of many things."""

# Feature: the probability that a kernel has it.
COMMON = {
    "integers": 0.8, "unsigned": 0.5, "small_integers": 0.4, "wide_integers": 0.3, "bits": 0.4, "casts": 0.5,
    "symbolic_integers": 0.35, "implicit_conversions": 0.2, "truth_values": 0.3, "sizeof": 0.2, "sizeof_truth": 0.1,
    "characters": 0.15, "math": 0.8, "math_integers": 0.3, "wild": 0.4, "float": 0.05, "conditional": 0.4,
    "bare_conditions": 0.2, "arrays": 0.5, "computed_indices": 0.6, "symbolic_index_writes": 0.05, "pointers": 0.3,
    "branches": 0.6, "switch": 0.2, "loops": 0.5, "computed_bounds": 0.5, "symbolic_bounds": 0.15, "exits": 0.2, "returns": 0.25,
    "helpers": 0.5, "integer_arguments": 0.5, "tables": 0.4, "enumerations": 0.25, "structs": 0.4, "bit_fields": 0.4,
    "wide_bit_fields": 0.2, "state": 0.25, "undeclared_state": 0.08, "text": 0.1, "text_read_back": 0.05, "parameters": 0.3,
    "unwritten_outputs": 0.05,
}
C = {}
CXX = {"templates": 0.35, "overloads": 0.3, "lambdas": 0.3, "complex": 0.15, "containers": 0.3, "operators": 0.3, "classes": 0.3,
       "algorithms": 0.3, "references": 0.3, "order": 0.05}


def features(language):
    return COMMON | (C if language == "c" else CXX)


def drawn(random, language, excluded):
    return {name for name, probability in features(language).items() if random.random() < probability} - set(excluded)

# What is known to be wrong and not repaired yet: `run.py --open` includes it.
OPEN = {
    "complex": "division, abs and functions of std::complex differ in the last digits",
    "enumerations": "C's enumerations are of an unsigned type",
    "math_integers": "C's mathematical functions of integers are folded by the compiler of C++",
    "order": "the order in which two calls of one expression are made",
    "overloads": "overloads chosen by integers and by numbers in templates",
    "sizeof_truth": "sizeof of what is a truth value or a character in C",
    "symbolic_integers": "integers made of numbers do not wrap",
    "templates": "overloads chosen by integers and by numbers in templates",
    "text_read_back": "numbers that come back from text",
    "undeclared_state": "constants that are left in state that nobody declared",
    "unwritten_outputs": "outputs that are not written on every path",
    "wide_bit_fields": "C's bit-fields that are wider than int",
}
