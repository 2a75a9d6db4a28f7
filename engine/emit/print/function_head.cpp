#include "engine/emit/print/function_head.h"

#include "engine/emit/language/pattern.h"

namespace symreal {

std::string print_head(Language const &language, std::string_view pattern, FunctionHead const &head) {
  FunctionSyntax const &syntax = language.functions;
  return Filling()
      .set("result", std::string(head.may_fail ? syntax.status : syntax.no_result))
      .set_name("name", head.name)
      .set("target", head.target)
      .set("pure", std::string(head.is_pure ? syntax.pure : ""))
      .set("apart", std::string(head.is_apart ? syntax.apart : ""))
      .set("beside", std::string(head.is_side_by_side ? syntax.beside : ""))
      .set("parameters", head.parameters)(with_words(language, pattern));
}

} // namespace symreal
