// The facts of several sources become those of one program.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Adds the facts of another source. The order of the sources matters only for facts about the same thing.
void merge(Facts &facts, Facts &&other);
void merge(Choices &choices, Choices &&others);

// Whether both list the same bases and fields. Their knowledge of these may differ.
bool same_members(ClassFact const &one, ClassFact const &other);

// A header that several sources include says the same each time.
void add_diagnostic(Facts &facts, Diagnostic const &diagnostic);

} // namespace symreal::rewrite
