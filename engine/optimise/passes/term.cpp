#include "engine/optimise/passes/term.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/number.h"

namespace symreal {

namespace {
class TermParser {
public:
  explicit TermParser(std::string_view text) : rest_(text) {}

  Term parse() {
    skip_blanks();
    internal_check(!rest_.empty());
    if (rest_.front() != '(') return atom(word());
    rest_.remove_prefix(1);
    auto op = find_operation(word());
    internal_check(op);
    Term term{.kind = Term::Kind::operation, .op = *op};
    for (unsigned i = 0; i < arity(*op); ++i) term.operands.push_back(parse());
    skip_blanks();
    internal_check(!rest_.empty() && rest_.front() == ')');
    rest_.remove_prefix(1);
    return term;
  }
  void expect_end() {
    skip_blanks();
    internal_check(rest_.empty());
  }

private:
  static Term atom(std::string_view text) {
    if (text.size() == 1 && text[0] >= 'a' && text[0] <= 'z')
      return {.kind = Term::Kind::variable, .variable = text[0]};
    auto value = parse_number(text);
    internal_check(value);
    return {.kind = Term::Kind::number, .number = *value};
  }
  void skip_blanks() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }
  std::string_view word() {
    std::string_view text = rest_.substr(0, rest_.find_first_of(" ()"));
    rest_.remove_prefix(text.size());
    return text;
  }
  std::string_view rest_;
};
} // namespace

Term parse_term(std::string_view text) {
  TermParser parser(text);
  Term term = parser.parse();
  parser.expect_end();
  return term;
}

double evaluate(Term const &term, std::function<double(char)> const &variable) {
  switch (term.kind) {
  case Term::Kind::variable: return variable(term.variable);
  case Term::Kind::number: return term.number;
  case Term::Kind::operation: break;
  }
  double values[3] = {0, 0, 0};
  for (std::size_t i = 0; i < term.operands.size(); ++i) values[i] = evaluate(term.operands[i], variable);
  return evaluate(term.op, values[0], values[1], values[2]);
}

} // namespace symreal
