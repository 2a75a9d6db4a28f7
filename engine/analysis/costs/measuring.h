// How the costs of operations are measured on a machine: a C program made from the table of operations, and the reading
// of what it prints.
//
// Method: latency is a chain in which each operation waits for the one before; throughput is many such chains at once.
// An operation cannot feed itself: e^e^x overflows. So each link goes back to the sample, x = s + z * f(x, y), where z
// is 0 and the compiler does not know; what the link takes without f is subtracted. Medians over rounds in which all
// operations take turns, so that a slow second of the machine spoils a round of each and not all rounds of one.
#pragma once

#include "engine/analysis/costs/costs.h"

#include <string>
#include <string_view>

namespace symreal {

// C99. It takes the number of rounds as its argument and prints a line for each operation that it measures.
std::string measuring_program();
// What it is compiled with: one operation after the other, as generated code is.
inline constexpr std::string_view measuring_flags = "-O1 -std=c99 -ffp-contract=off -fno-builtin-pow";

// From its output the file that read_costs reads. What cannot be measured, as calls of the user's functions, costs what
// the table says against a measured addition. Nothing if the output is not that of the program.
std::string cost_file_text(std::string_view output, std::string const &compiler,
                           std::optional<ThreadCosts> const &threads = {});

} // namespace symreal
