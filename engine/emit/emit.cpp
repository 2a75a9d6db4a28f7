#include "engine/emit/emit.h"

#include "engine/emit/print/external_names.h"
#include "engine/emit/print/requirements.h"
#include "engine/emit/print/single_requirements.h"
#include "engine/emit/print/source.h"
#include "engine/plan/schedule/angles.h"

namespace symreal {

static std::vector<EmittedFile> print(Schedule const &plan, Language const &language, EmitOptions const &options,
                                      Rerolled const *loops, Laned const *lanes) {
  Emission emission{plan, language, options, loops, lanes};
  std::vector<EmittedFile> files;
  files.push_back(print_source(emission)); // an initializer list would copy the text
  for (Companion const &companion : language.files.companions)
    if (companion.option.empty() || options.extras.contains(companion.option))
      files.push_back({options.base_name + std::string(companion.suffix), companion.text(emission)});
  require_other_names(emission, files);
  return files;
}

std::vector<EmittedFile> emit(Schedule const &plan, Language const &language, EmitOptions const &options,
                              Rerolled const *loops, Laned const *lanes) {
  require_expressible(plan, language, options);
  if (loops && !language.loops.is_given())
    fail(DiagnosticId::bad_option, {},
         "--reroll needs loops, which --lang=" + std::string(language.name) + " does not have");
  if (lanes && !language.vectors.is_given())
    fail(DiagnosticId::bad_option, {},
         "--vector needs vectors, which --lang=" + std::string(language.name) + " does not have");
  if (options.is_single) require_single(*plan.graph, language, options);
  Language const wanted = options.is_single ? in_single_precision(language) : language;
  if (options.angles && wanted.angles.is_given()) return print(with_angles(plan), wanted, options, loops, lanes);
  if (wanted.has_blocks) return print(plan, wanted, options, loops, lanes);
  return print(schedule(*plan.graph, Nesting::bounded, Arms::computed), wanted, options, nullptr, nullptr);
}

} // namespace symreal
