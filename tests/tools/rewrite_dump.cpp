// Prints what the rewriter makes of its arguments: rewrite_dump [--diff | --text | --refusals] [--root DIR]...
// SOURCE...
// [-- FLAG...]; with --facts what it has collected (--children-first: in that order of visits), and with --decide FILE
// what it makes of such facts. A tool of the tests: the library's result without a driver around it. Exits 1 when there
// is an error.
#include "engine/support/files.h"
#include "rewrite/collected.h"
#include "rewrite/decide/decide.h"
#include "rewrite/facts/facts.h"
#include "rewrite/rewrite.h"
#include "rewrite/text/exports.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

using namespace symreal;

static void print_kernel(rewrite::Kernel const &kernel) {
  std::cout << "kernel " << kernel.name << (kernel.is_function ? " function" : " region") << " at "
            << to_string(kernel.place) << " file '" << kernel.output_file << "' signature '"
            << kernel.signature.declaration << "'\n";
  for (rewrite::Annotation const &one : kernel.annotations) {
    std::cout << "  " << one.kind << " '" << one.label << "' at " << to_string(one.place) << " " << one.expression;
    for (rewrite::Section const &section : one.sections)
      std::cout << " from " << section.low << " for " << section.length;
    std::cout << "\n";
  }
}

// The text without the lines that hold what a test expects: they would match themselves.
static std::string without_checks(std::string const &text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    std::string const line = text.substr(begin, end - begin);
    if (line.find("CHECK") == std::string::npos) result += line;
    begin = end;
  }
  return result;
}

int main(int argc, char **argv) {
  rewrite::Request request;
  bool refusals = false, diff = false, after = false, bare = false, facts = false;
  std::string out, facts_file;
  for (int i = 1; i < argc; ++i) {
    std::string const word = argv[i];
    if (after)
      request.flags.push_back(word);
    else if (word == "--")
      after = true;
    else if (word == "--diff")
      diff = true;
    else if (word == "--refusals")
      refusals = true;
    else if (word == "--facts")
      facts = true;
    else if (word == "--children-first")
      request.children_first = true;
    else if (word == "--decide" && i + 1 < argc)
      facts_file = argv[++i];
    else if (word == "--text")
      bare = true;
    else if (word == "--root" && i + 1 < argc)
      request.roots.push_back(argv[++i]);
    else if (word == "--out-root" && i + 1 < argc)
      out = argv[++i];
    else
      request.sources.push_back(word);
  }
  try {
    if (facts) {
      std::cout << to_text(rewrite::collect(request).facts);
      return 0;
    }
    rewrite::Result const result = facts_file.empty()
                                       ? rewrite::run(request)
                                       : rewrite::decide(rewrite::facts_of_text(read_file(facts_file)), request);
    bool failed = false;
    for (Diagnostic const &diagnostic : result.diagnostics) {
      print(std::cerr, diagnostic);
      failed = failed || diagnostic.severity == Severity::error;
    }
    if (failed) return 1;
    if (!out.empty()) {
      for (auto const &[path, text] : mirror(result.files, out)) {
        std::filesystem::create_directories(std::filesystem::path(path).parent_path());
        write_if_changed(path, text);
        std::cout << path << "\n";
      }
      return 0;
    }
    for (rewrite::Refusal const &one : result.refusals)
      if (refusals)
        std::cout << to_string(one.condition) << " to line " << one.last_line << ": " << words(one.reason) << " at "
                  << to_string(one.token) << "\n";
    if (refusals) return 0;
    for (rewrite::File const &file : result.files)
      std::cout << (diff   ? unified_diff(file.display_path, file.original, file.text)
                    : bare ? without_checks(file.text)
                           : "==== " + file.display_path + "\n" + file.text);
    if (!bare && !diff)
      for (rewrite::Kernel const &kernel : result.kernels) print_kernel(kernel);
  } catch (DiagnosticError const &error) {
    print(std::cerr, error.diagnostic());
    return 1;
  } catch (std::invalid_argument const &error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
