#include "rewrite/facts/spans.h"

#include <algorithm>

namespace symreal::rewrite {

bool meets(std::set<Span> const &spans, Span const &span) {
  auto at = spans.upper_bound({span.file, span.end, 0});
  while (at != spans.begin()) {
    --at;
    if (at->file != span.file) return false;
    if (at->begin < span.end && at->end > span.begin) return true;
    if (at->end <= span.begin) return false;
  }
  return false;
}

bool is_quoted(Facts const &facts, Span const &expression) {
  Span const first{expression.file, expression.begin, expression.begin + 1};
  return meets(facts.quoted, first) || meets(facts.quoted, {expression.file, expression.end - 1, expression.end});
}

std::string text_of(Span const &span, Facts const &facts) {
  return facts.files.at(span.file).text.substr(span.begin, span.end - span.begin);
}

Place place_in(FileFact const &file, std::size_t offset) {
  auto const end = file.text.begin() + static_cast<std::ptrdiff_t>(offset);
  std::size_t const line_start = offset == 0 ? std::string::npos : file.text.rfind('\n', offset - 1);
  auto const line = static_cast<unsigned>(std::count(file.text.begin(), end, '\n')) + 1;
  return {file.display_path, line,
          static_cast<unsigned>(offset - (line_start == std::string::npos ? 0 : line_start + 1)) + 1};
}

} // namespace symreal::rewrite
