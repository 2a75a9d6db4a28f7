#include "engine/emit/cpp/parts.h"
#include "engine/emit/languages/languages.h"

namespace symreal {

static constexpr Companion beside[] = {{".hpp", cpp_header}, {"_main.cpp", cpp_mainline, "mainline"}};

// C++ as C, except for library names, the namespace, and the code around functions.
Language language_cpp() {
  Language cpp = language_c();
  cpp.has_namespace = true;
  cpp.expressions.call_prefix = "std::";
  cpp.single.call_suffix = ""; // they are overloaded
  cpp.statements.value_check = "if (!std::isfinite($name)) report_value($name, \"$text\");";
  cpp.functions.local_output = "$real *__restrict $name"; // nonstandard, but supported by every compiler
  cpp.vectors.build = "${real}_$width{$values}";
  cpp.externals.declarations = cpp_external_declarations;
  cpp.files.extension = ".cpp";
  cpp.files.begin = cpp_begin;
  cpp.files.open = cpp_open;
  cpp.files.end = cpp_end;
  cpp.files.companions = beside;
  return cpp;
}

} // namespace symreal
