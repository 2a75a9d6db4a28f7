#include "program/build/make_rule.h"

#include <algorithm>

namespace symreal::program {

std::string make_escaped(std::string const &name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    char const c = name[i];
    if (c == ' ' || c == '\t') {
      for (std::size_t back = i; back > 0 && name[back - 1] == '\\'; --back) text += '\\';
      text += '\\';
    } else if (c == '#') {
      text += '\\';
    } else if (c == '$') {
      text += '$';
    }
    text += c;
  }
  return text;
}

namespace {

// Words of a rule, broken into lines.
class Line {
public:
  void add(std::string const &word) {
    constexpr std::size_t most = 72;
    if (column_ != 0 && column_ + word.size() > most) {
      text += " \\\n ";
      column_ = 1;
    } else if (column_ != 0) {
      text += ' ';
      ++column_;
    }
    text += word;
    column_ += word.size();
  }
  void end_targets() {
    text += ':';
    ++column_;
  }
  std::string text;

private:
  std::size_t column_ = 0;
};

} // namespace

std::string make_rule(std::vector<std::string> const &targets, std::vector<std::string> const &names, Phony phony) {
  Line line;
  for (std::string const &target : targets) line.add(target);
  line.end_targets();
  for (std::string const &name : names) line.add(make_escaped(name));
  line.text += '\n';
  if (phony != Phony::none)
    for (std::size_t i = phony == Phony::all ? 0 : 1; i < names.size(); ++i)
      line.text += make_escaped(names[i]) + ":\n";
  return line.text;
}

std::vector<std::string> read_make_rule(std::string const &text) {
  std::vector<std::string> names;
  std::string name;
  auto finish = [&] {
    if (!name.empty()) names.push_back(std::move(name));
    name.clear();
  };
  // Starts after the target, which has no blanks.
  std::size_t i = text.find(": ");
  for (i = i == text.npos ? text.size() : i + 1; i < text.size(); ++i) {
    char const c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (c == '\\' && next != '\n') {
      // Backslashes are literal, except the last one before '#' and every second one before a blank.
      std::size_t const end = std::min(text.find_first_not_of('\\', i), text.size()), count = end - i;
      char const after = end < text.size() ? text[end] : '\0';
      bool const is_blank = after == ' ' || after == '\t', keeps = after == '#' || (is_blank && count % 2 == 1);
      name.append(after == '#' ? count - 1 : is_blank ? count / 2 : count, '\\');
      if (keeps) name += after;
      i = keeps ? end : end - 1;
    } else if (c == '\\' && next == '\n') {
      ++i;
      finish();
    } else if (c == '$' && next == '$') {
      name += text[++i];
    } else if (c == '\n') {
      break;
    } else if (c == ' ' || c == '\t') {
      finish();
    } else {
      name += c;
    }
  }
  finish();
  return names;
}

} // namespace symreal::program
