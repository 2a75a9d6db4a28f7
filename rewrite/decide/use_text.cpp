#include "rewrite/decide/use_text.h"

#include "rewrite/text/source_text.h"

namespace symreal::rewrite {
namespace {

std::string with_payload(std::string_view text, std::string const &payload) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] != '%')
      result += text[at];
    else if (text.substr(at).starts_with("%q")) {
      result += in_quotes(payload);
      ++at;
    } else
      result += payload;
  return result;
}

} // namespace

Rewording rewording(Wrap const &wrap, bool is_shared) {
  bool const by_context = is_shared && (wrap.use == Use::conversion || wrap.use == Use::cast);
  internal_check(info(wrap.use).payload != Payload::none || wrap.detail.empty());
  UseInfo const &row = info(by_context ? Use::fit : wrap.use);
  std::size_t const expression = row.text.find('$');
  return {wrap.span.begin,
          wrap.span.end,
          with_payload(row.text.substr(0, expression), wrap.detail),
          with_payload(row.text.substr(expression + 1), wrap.detail),
          false,
          row.has(trait::OUTERMOST) ? depth::outermost : static_cast<int>(wrap.use)};
}

} // namespace symreal::rewrite
