// Diagnostics for the user: one table of ids (diagnostics.def), one way to print them.
//
// Two functions of failure exist and are never mixed: a Diagnostic tells the user what is wrong with the input, where,
// and what to do; `internal_check` is an assertion for us, which no input can make fail.
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
  Severity severity; // the usual one
  std::string_view summary;
  std::string_view explanation;
  std::string_view help;
};

// A place in the user's source. Line 0: the whole file; an empty file: no place is known.
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

// Of a section or an index of a pragma's item: `object` is what it takes elements of, `count` how many it has. The
// rewriter and the recorded program say it in the same words.
std::string beyond_message(std::string const &item, std::string const &object, std::int64_t count);

// Who tells the user what is no error.
using Report = std::function<void(Diagnostic const &)>;

// True when no error is among them.
bool report_all(std::vector<Diagnostic> const &diagnostics, Report const &report);

// The row with this code ("SYM012"), or null.
DiagnosticInfo const *find_diagnostic(std::string_view code);
// "SYM012"
std::string code(DiagnosticId id);

// file:line:col: error: text [SYM012], then a line per note, then the help.
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

// An invariant of ours. Active in every build: it costs little where it stands, and a wrong proof costs more.
#define internal_check(condition) ((condition) ? void() : ::symreal::internal_failure(#condition, __FILE__, __LINE__))
