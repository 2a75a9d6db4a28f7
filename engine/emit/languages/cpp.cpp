#include "engine/emit/cpp/parts.h"
#include "engine/emit/languages/languages.h"

namespace symreal {

static constexpr Companion beside[] = {{".hpp", cpp_header}, {"_main.cpp", cpp_mainline, "mainline"}};

// As C, but for the names of the library, the namespace, and what stands around the functions.
Language language_cpp() {
  Language cpp = language_c();
  cpp.has_namespace = true;
  cpp.expressions.call_prefix = "std::";
  cpp.single.call_suffix = ""; // they are overloaded
  cpp.statements.value_check = "if (!std::isfinite($name)) report_value($name, \"$text\");";
  cpp.functions.local_output = "$real *__restrict $name"; // no standard C++, but every compiler has it
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
