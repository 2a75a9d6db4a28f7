#include "engine/emit/print/source.h"

#include "engine/emit/print/bridges.h"
#include "engine/emit/print/function.h"
#include "engine/emit/print/helpers.h"
#include "engine/emit/print/module.h"
#include "engine/emit/print/tables.h"

namespace symreal {

EmittedFile print_source(Emission &emission) {
  FileSyntax const &files = emission.language.files;
  std::string const name = emission.options.base_name + std::string(files.extension);
  if (files.whole) return {name, files.whole(emission)};
  CodeText functions = print_function(emission, FunctionKind::preprocess);
  for (FunctionKind const kind : {FunctionKind::computed_angles, FunctionKind::compute}) {
    if (kind == FunctionKind::computed_angles && emission.plan.angles.computed.results.empty()) continue;
    functions.lines("\n");
    functions.append(print_function(emission, kind));
  }
  auto const part = [&](Part write) { return write ? write(emission) : std::string(); };
  CodeText text(emission.language);
  text.lines(banner(emission));
  text.lines(part(files.begin));
  text.lines(part(emission.language.externals.declarations));
  text.lines(print_bridge_declarations(emission));
  text.lines(part(files.open));
  text.lines(indented(emission.language, print_tables(emission)));
  text.lines(part(files.integer_functions));
  if (emission.uses.hidden) text.lines(with_words(emission.language, files.hide_helper));
  text.lines(part(emission.language.angles.helper));
  text.lines(indented(emission.language, print_helpers(emission, true)));
  text.lines(emission.language.module.contains);
  text.lines(indented(emission.language, print_helpers(emission, false)));
  text.lines(print_bridges(emission));
  text.append(std::move(functions));
  text.lines(part(files.end));
  return {name, text.take_text(), text.take_origins()};
}

} // namespace symreal
