// Diagnostics for the user: one table of ids (diagnostics.def) and one printer.
//
// There are two kinds of failure: a Diagnostic tells the user which input is wrong, where, and how to mend it;
// `internal_check` asserts an invariant of the tool, which no input can violate.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

enum class DiagnosticId {
#define DIAGNOSTIC(name, number, severity, summary, explanation, help) name = number,
#include "engine/diagnostics/diagnostics.def"
#undef DIAGNOSTIC
};

enum class Severity { error, warning, remark };

struct DiagnosticInfo {
  DiagnosticId id;
  std::string_view name;
  Severity severity; // the default
  std::string_view summary;
  std::string_view explanation;
  std::string_view help;
};

// A place in the user's source. Line 0: the whole file; an empty file name: unknown.
struct Place {
  std::string file;
  unsigned line = 0;
  unsigned column = 0;
};
std::string to_string(Place const &place);

struct Note {
  Place place;
  std::string message;
};

std::vector<DiagnosticInfo> const &diagnostic_table();
DiagnosticInfo const &info(DiagnosticId id);
Severity usual_severity(DiagnosticId id);

struct Diagnostic {
  DiagnosticId id = {};
  Place place = {};
  std::string message = {};
  std::vector<Note> notes = {};
  Severity severity = usual_severity(id);
};

// Message for a section or index beyond the `count` elements of `object`. The rewriter and the recorded program share
// its wording.
std::string beyond_message(std::string const &item, std::string const &object, std::int64_t count);

// Receiver of reported diagnostics.
using Report = std::function<void(Diagnostic const &)>;

// Reports all diagnostics; true if none of them is an error.
bool report_all(std::vector<Diagnostic> const &diagnostics, Report const &report);

// Row of the table for a code ("SYM012"), or null.
DiagnosticInfo const *find_diagnostic(std::string_view code);
// The code, such as "SYM012".
std::string code(DiagnosticId id);

// Prints file:line:col: error: text [SYM012], then a line per note, then the help.
void print(std::ostream &out, Diagnostic const &diagnostic);

class DiagnosticError : public std::runtime_error {
public:
  explicit DiagnosticError(Diagnostic diagnostic);
  Diagnostic const &diagnostic() const { return diagnostic_; }

private:
  Diagnostic diagnostic_;
};

[[noreturn]] void fail(DiagnosticId id, Place place, std::string message, std::vector<Note> notes = {});

[[noreturn]] void internal_failure(char const *condition, char const *file, int line);

} // namespace symreal

// Asserts an internal invariant. Active in every build: it is cheap where it is used, and a wrong proof is expensive.
#define internal_check(condition) ((condition) ? void() : ::symreal::internal_failure(#condition, __FILE__, __LINE__))
