// Names of the functions and variables of the C library's headers (glibc's, with all that g++ makes them declare). The
// program's own names are compared with these: symbolic mode includes more headers than the program does.
#include "rewrite/model/library_names.h"

namespace symreal::rewrite {
namespace {

constexpr llvm::StringLiteral names =
#include "rewrite/model/library_names.def"
    ;

} // namespace

bool is_library_name(llvm::StringRef name) {
  static llvm::StringSet<> const known = [] {
    llvm::SmallVector<llvm::StringRef> words;
    names.split(words, ' ', /*MaxSplit=*/-1, /*KeepEmpty=*/false);
    llvm::StringSet<> set;
    set.insert(words.begin(), words.end());
    return set;
  }();
  return known.contains(name);
}

} // namespace symreal::rewrite
