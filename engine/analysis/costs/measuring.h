// Measurement of operation costs on a machine: a C program generated from the operation table, and the parser of its
// output.
//
// Method: latency is measured on a chain of dependent operations, throughput on many such chains at once. An operation
// cannot feed itself: e^e^x overflows. So each link returns to the sample, x = s + z * f(x, y), where z is a 0 that the
// compiler cannot see; the time of the link without f is subtracted. All operations take turns in each round, and the
// median over rounds counts, so that a slow phase of the machine spoils one round of each and not all rounds of one.
#pragma once

#include "engine/analysis/costs/costs.h"

#include <string>
#include <string_view>

namespace symreal {

// The C99 program takes the number of rounds as its argument and prints a line per measured operation.
std::string measuring_program();
// Compiler flags, which keep operations in sequence as in generated code.
inline constexpr std::string_view measuring_flags = "-O1 -std=c99 -ffp-contract=off -fno-builtin-pow";

// Cost file, as read by read_costs, from the program's output. An unmeasurable operation, such as a call of a user
// function, costs its table entry times a measured addition. Empty if the output is malformed.
std::string cost_file_text(std::string_view output, std::string const &compiler,
                           std::optional<ThreadCosts> const &threads = {});

} // namespace symreal
