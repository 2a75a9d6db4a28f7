// The facts of several sources become those of one program.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Adds what another source tells. The order of the sources decides only what is said of a thing that several describe.
void merge(Facts &facts, Facts &&other);
void merge(Choices &choices, Choices &&others);

// Do both tell of the same bases and fields? They may still know differently what these hold.
bool same_members(ClassFact const &one, ClassFact const &other);

// A header that several sources include says the same each time.
void add_diagnostic(Facts &facts, Diagnostic const &diagnostic);

} // namespace symreal::rewrite
