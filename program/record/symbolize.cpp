#include "program/record/symbolize.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <llvm/DebugInfo/Symbolize/Symbolize.h>
#pragma GCC diagnostic pop

namespace symreal::program {

struct Symbolizer::Engine {
  llvm::symbolize::LLVMSymbolizer symbolizer;

  static llvm::symbolize::LLVMSymbolizer::Options options() {
    llvm::symbolize::LLVMSymbolizer::Options options;
    // Paths as the overlay's #line directives spell them.
    options.PathStyle = llvm::DILineInfoSpecifier::FileLineInfoKind::RelativeFilePath;
    options.RelativeAddresses = true;
    options.UseSymbolTable = false;
    return options;
  }
  Engine() : symbolizer(options()) {}
};

Symbolizer::Symbolizer(std::string executable, Overlay const &overlay)
    : executable_(std::move(executable)),
      overlay_(overlay),
      engine_(std::make_unique<Engine>()) {}
Symbolizer::~Symbolizer() = default;

// Is this a frame of RealNumber or the recorder, which carries no information? Inlined functions have short names, so
// files count, too.
static bool is_runtime(llvm::DILineInfo const &info) {
  std::string_view const file = info.FileName;
  return info.FunctionName.starts_with("symreal::") || file.find("/runtime/trace/") != file.npos ||
         file.find("/include/symreal/") != file.npos;
}

// Name of the function in the user's program.
static std::string original_name(std::string function) {
  constexpr std::string_view real = "symreal::types::RealNumber";
  for (std::size_t at; (at = function.find(real)) != function.npos;) function.replace(at, real.size(), "double");
  constexpr std::string_view renamed = "symreal_"; // prefix of C names that are keywords of C++
  if (function.starts_with(renamed)) function.erase(0, renamed.size());
  return function;
}

std::vector<Frame> Symbolizer::frames(std::vector<std::uint64_t> const &return_addresses) {
  std::vector<Frame> frames;
  for (std::uint64_t address : return_addresses) {
    if (address == 0) continue;
    // The byte before the return address lies within the call.
    llvm::object::SectionedAddress call{address - 1, llvm::object::SectionedAddress::UndefSection};
    auto found = engine_->symbolizer.symbolizeInlinedCode(executable_, call);
    if (!found) {
      llvm::consumeError(found.takeError());
      continue;
    }
    for (unsigned i = 0; i < found->getNumberOfFrames(); ++i) {
      llvm::DILineInfo const &info = found->getFrame(i);
      if (info.FileName == llvm::DILineInfo::BadString || info.Line == 0) continue;
      if (is_runtime(info) && !overlay_.contains(info.FileName)) continue;
      if (info.FunctionName.find("::symreal_members(") != info.FunctionName.npos) continue;
      Place place{info.FileName, info.Line, info.Column};
      frames.push_back({original_name(info.FunctionName), overlay_.original(place), overlay_.contains(info.FileName)});
    }
  }
  return frames;
}

} // namespace symreal::program
