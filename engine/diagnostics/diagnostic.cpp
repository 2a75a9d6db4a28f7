#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <ostream>

namespace symreal {

std::vector<DiagnosticInfo> const &diagnostic_table() {
  static std::vector<DiagnosticInfo> const table = {
#define DIAGNOSTIC(name, number, severity, summary, explanation, help)                                                 \
  {DiagnosticId::name, #name, Severity::severity, summary, explanation, help},
#include "engine/diagnostics/diagnostics.def"
#undef DIAGNOSTIC
  };
  return table;
}

DiagnosticInfo const &info(DiagnosticId id) {
  auto const &table = diagnostic_table();
  return *std::find_if(table.begin(), table.end(), [id](DiagnosticInfo const &row) { return row.id == id; });
}

Severity usual_severity(DiagnosticId id) {
  return id == DiagnosticId{} ? Severity::error : info(id).severity; // no id yet: it is read from an archive
}

bool report_all(std::vector<Diagnostic> const &diagnostics, Report const &report) {
  bool is_clean = true;
  for (Diagnostic const &diagnostic : diagnostics) {
    report(diagnostic);
    is_clean &= diagnostic.severity != Severity::error;
  }
  return is_clean;
}

DiagnosticInfo const *find_diagnostic(std::string_view wanted) {
  for (DiagnosticInfo const &row : diagnostic_table())
    if (code(row.id) == wanted) return &row;
  return nullptr;
}

std::string code(DiagnosticId id) {
  std::string digits = std::to_string(static_cast<int>(id));
  return "SYM" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

std::string to_string(Place const &place) {
  std::string text = place.file;
  if (place.line != 0) text += ":" + std::to_string(place.line);
  if (place.line != 0 && place.column != 0) text += ":" + std::to_string(place.column);
  return text;
}

std::string beyond_message(std::string const &item, std::string const &object, std::int64_t count) {
  bool const has_rows = object.find(':') != object.npos && object.find('[') != object.npos;
  std::string text = "'" + item + "' reaches beyond " + (has_rows ? "the rows '" : "'") + object + "', which ";
  if (count == 0) return text + (has_rows ? "are empty" : "is empty");
  text += (has_rows ? "have " : "has ") + std::to_string(count) + (count == 1 ? " element" : " elements");
  return text + (has_rows ? " each" : "");
}

namespace {

std::string_view spelling(Severity severity) {
  switch (severity) {
  case Severity::error: return "error";
  case Severity::warning: return "warning";
  case Severity::remark: return "remark";
  }
  return "";
}

constexpr std::size_t longest = 300; // line that is shown

// White space as wide as the text on screen: tabs stay, and a UTF-8 character has one column.
std::string blanks(std::string const &text) {
  std::string result;
  for (char c : text)
    if (c == '\t')
      result += c;
    else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80)
      result += ' ';
  return result;
}

// Masks control characters, which the terminal would interpret.
std::string printable(std::string text) {
  for (char &c : text)
    if ((static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7F') c = '?';
  return text;
}

// Source line of a message, with a mark below the column:
//    12 |   return (int)x;
//       |               ^
// Empty if the file is unreadable, lacks the line, or the line is too long to show.
std::string marked_line(Place const &place) {
  if (place.line == 0) return {};
  std::ifstream file(place.file);
  std::string line;
  for (unsigned i = 0; i < place.line; ++i)
    if (!std::getline(file, line)) return {};
  if (!line.empty() && line.back() == '\r') line.pop_back();
  if (line.empty() || line.size() > longest) return {};
  std::string const number = std::to_string(place.line);
  std::string text = " " + number + " | " + printable(line) + "\n";
  if (place.column != 0 && place.column <= line.size() + 1)
    text += std::string(number.size() + 1, ' ') + " | " + blanks(line.substr(0, place.column - 1)) + "^\n";
  return text;
}

} // namespace

void print(std::ostream &out, Diagnostic const &diagnostic) {
  auto prefix = [](Place const &place) { return place.file.empty() ? std::string("symreal") : to_string(place); };
  out << prefix(diagnostic.place) << ": " << spelling(diagnostic.severity) << ": " << diagnostic.message << " ["
      << code(diagnostic.id) << "]\n"
      << marked_line(diagnostic.place);
  for (Note const &note : diagnostic.notes) out << prefix(note.place) << ": note: " << note.message << "\n";
  out << "  help: " << info(diagnostic.id).help << "\n";
}

DiagnosticError::DiagnosticError(Diagnostic diagnostic)
    : std::runtime_error(diagnostic.message),
      diagnostic_(std::move(diagnostic)) {}

void fail(DiagnosticId id, Place place, std::string message, std::vector<Note> notes) {
  throw DiagnosticError({id, std::move(place), std::move(message), std::move(notes)});
}

void internal_failure(char const *condition, char const *file, int line) {
  std::fprintf(stderr, "symreal: internal error: %s does not hold (%s:%d)\n", condition, file, line);
  std::abort();
}

} // namespace symreal
