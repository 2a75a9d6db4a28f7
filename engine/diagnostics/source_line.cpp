#include "engine/diagnostics/source_line.h"

#include <fstream>

namespace symreal {
namespace {

constexpr std::size_t longest = 300;

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

} // namespace

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

} // namespace symreal
