#include "program/build/branches.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <llvm/DebugInfo/Symbolize/Symbolize.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/ProfileData/Coverage/CoverageMappingReader.h>
#include <llvm/ProfileData/InstrProfReader.h>
#include <llvm/Support/Program.h>
#include <llvm/Support/VirtualFileSystem.h>
#pragma GCC diagnostic pop

namespace symreal::program {

using llvm::coverage::Counter;
using llvm::coverage::CounterMappingContext;
using llvm::coverage::CounterMappingRegion;
using llvm::coverage::CoverageMappingRecord;
using Counts = std::vector<std::uint64_t>;

std::size_t count_unseen(std::vector<BranchCount> const &branches) {
  std::size_t unseen = 0;
  for (BranchCount const &branch : branches) unseen += (branch.yes == 0) + (branch.no == 0);
  return unseen;
}

void add(std::vector<BranchCount> &all, std::vector<BranchCount> const &more) {
  std::map<std::array<std::string, 3>, std::size_t> known;
  auto const name = [](BranchCount const &one) { return std::array{one.place, one.condition, one.function}; };
  for (std::size_t k = 0; k < all.size(); ++k) known.try_emplace(name(all[k]), k);
  for (BranchCount const &one : more) {
    auto const [at, is_new] = known.try_emplace(name(one), all.size());
    if (is_new) {
      all.push_back(one);
    } else {
      all[at->second].yes += one.yes;
      all[at->second].no += one.no;
    }
  }
}

CoveredProgram build_covered(BuildRequest const &request, Overlay const &rewritten, Overlay const &annotated,
                             Workspace const &workspace) {
  if (!llvm::sys::findProgramByName(clang_compiler))
    return {{}, fmt::format("there is no {} on this machine", clang_compiler)};
  try {
    std::array const variants = {Variant::covered};
    return {build_variants(request, variants, rewritten, annotated, workspace).front(), {}};
  } catch (DiagnosticError const &error) {
    Diagnostic const &why = error.diagnostic();
    std::string const place = why.place.file.empty() ? "" : to_string(why.place) + ": ";
    return {{}, fmt::format("{} does not build the original: {}{}", clang_compiler, place, why.message)};
  }
}

namespace {

constexpr unsigned lines_before = 1; // line of the overlay's #line directive, which coverage ignores

// Linker name without the file prefix of a local function.
std::string linker_name(llvm::StringRef name) { return name.substr(name.find_last_of(":;") + 1).str(); }

using CountsByName = std::map<std::pair<std::string, std::uint64_t>, Counts>;

CountsByName read_counts(std::string const &profile) {
  CountsByName counts;
  auto reader = llvm::InstrProfReader::create(profile, *llvm::vfs::getRealFileSystem());
  if (!reader) return llvm::consumeError(reader.takeError()), counts;
  for (llvm::NamedInstrProfRecord const &record : **reader) counts[{record.Name.str(), record.Hash}] = record.Counts;
  return counts;
}

// Functions on the stack at the kernel's begin, innermost first.
std::vector<std::string> functions_at(std::string const &program, std::vector<std::uint64_t> const &stack) {
  llvm::symbolize::LLVMSymbolizer::Options options;
  options.PrintFunctions = llvm::DILineInfoSpecifier::FunctionNameKind::LinkageName;
  options.RelativeAddresses = true;
  options.Demangle = false;
  llvm::symbolize::LLVMSymbolizer symbolizer(options);
  std::vector<std::string> names;
  for (std::uint64_t const address : stack) {
    auto found = symbolizer.symbolizeCode(program, {address - 1, llvm::object::SectionedAddress::UndefSection});
    if (found)
      names.push_back(found->FunctionName);
    else
      llvm::consumeError(found.takeError());
  }
  return names;
}

// Lines between the annotations of a kernel in a block.
struct Lines {
  unsigned first, last;
  bool have(unsigned line) const { return first <= line && line <= last; }
};

Lines lines_of(rewrite::Kernel const &kernel) {
  Lines lines{kernel.place.line, kernel.place.line};
  for (rewrite::Annotation const &one : kernel.annotations) {
    lines.first = std::min(lines.first, one.place.line);
    lines.last = std::max(lines.last, one.place.line);
  }
  return lines;
}

// Source text on one line, cut off if it is long.
std::string shortened(std::string_view text) {
  constexpr std::size_t most = 60;
  std::string line;
  for (char const one : text) {
    bool const is_blank = one == ' ' || one == '\t' || one == '\n' || one == '\r';
    if (!is_blank)
      line += one;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  return line.size() > most ? line.substr(0, most - 3) + "..." : line;
}

std::size_t offset_of(std::string const &text, unsigned line, unsigned column) {
  std::size_t start = 0;
  for (; line > 1 && start < text.size(); --line) start = std::min(text.find('\n', start), text.size() - 1) + 1;
  return std::min(start + column - 1, text.size());
}

class Reader {
public:
  // `innermost`: the function that runs at the kernel's begin; `samples`: number of samples that have run.
  Reader(rewrite::Result const &annotated, rewrite::Kernel const &kernel, std::string innermost, std::uint64_t samples)
      : annotated_(annotated),
        kernel_(kernel),
        lines_(lines_of(kernel)),
        innermost_(std::move(innermost)),
        samples_(samples) {}

  void add(CoverageMappingRecord const &record, Counts counts) {
    if (record.MappingRegions.empty()) return;
    bool const holds_kernel = linker_name(record.FunctionName) == innermost_;
    if (holds_kernel) enter(record, counts);
    CounterMappingContext const context(record.Expressions, counts);
    CounterMappingRegion const &whole = record.MappingRegions.front();
    if (value(context, whole.Count) == 0) return;
    FunctionInstance &function =
        functions_[{record.Filenames[whole.FileID].str(), {whole.LineStart, whole.ColumnStart}}].emplace_back();
    function.name = llvm::demangle(linker_name(record.FunctionName));
    for (CounterMappingRegion const &region : record.MappingRegions) {
      bool const is_known = region.Count.isZero() && region.FalseCount.isZero(); // the compiler knows the outcome
      if (region.Kind != CounterMappingRegion::BranchRegion || is_known) continue;
      CounterMappingRegion const &seen = outermost(record, region);
      if (holds_kernel && !kernel_.is_function && !lines_.have(seen.LineStart - lines_before)) continue;
      if (auto branch = named(record.Filenames[seen.FileID].str(), seen)) {
        branch->yes = value(context, region.Count);
        branch->no = value(context, region.FalseCount);
        function.branches.push_back(*branch);
      }
    }
  }

  std::vector<BranchCount> result() {
    std::vector<BranchCount> all,
        once; // one branch may occur in several sources, or in several uses of a nested macro
    for (auto &[place, instances] : functions_)
      for (FunctionInstance const &function : instances)
        for (BranchCount branch : function.branches) {
          if (instances.size() > 1) branch.function = function.name;
          all.push_back(branch);
        }
    program::add(once, all);
    return once;
  }

private:
  struct FunctionInstance {
    std::string name;
    std::vector<BranchCount> branches;
  };

  // Adds one entry per sample to the counters of regions that were entered before the kernel began.
  void enter(CoverageMappingRecord const &record, Counts &counts) const {
    std::set<unsigned> entered;
    unsigned const line = lines_.first + lines_before;
    for (CounterMappingRegion const &region : record.MappingRegions) {
      bool const is_around = kernel_.is_function
                                 ? &region == &record.MappingRegions.front()
                                 : region.FileID == 0 && region.LineStart < line && line <= region.LineEnd;
      if (region.Kind == CounterMappingRegion::CodeRegion && is_around &&
          region.Count.getKind() == Counter::CounterValueReference)
        entered.insert(region.Count.getCounterID());
    }
    for (unsigned const one : entered)
      if (one < counts.size()) counts[one] += samples_;
  }

  static std::uint64_t value(CounterMappingContext const &context, Counter const &counter) {
    auto found = context.evaluate(counter);
    if (!found) return llvm::consumeError(found.takeError()), 0;
    return static_cast<std::uint64_t>(std::max<std::int64_t>(*found, 0));
  }

  // The region, or the use of the macro that contains it.
  static CounterMappingRegion const &outermost(CoverageMappingRecord const &record,
                                               CounterMappingRegion const &region) {
    CounterMappingRegion const *seen = &region;
    for (bool is_in_macro = true; is_in_macro;) {
      auto const use = std::ranges::find_if(record.MappingRegions, [seen](CounterMappingRegion const &one) {
        return one.Kind == CounterMappingRegion::ExpansionRegion && one.ExpandedFileID == seen->FileID;
      });
      is_in_macro = use != record.MappingRegions.end();
      if (is_in_macro) seen = &*use;
    }
    return *seen;
  }

  // The branch with its source text; nullopt outside the roots and in annotations.
  std::optional<BranchCount> named(std::string const &path, CounterMappingRegion const &region) const {
    auto const file = std::ranges::find(annotated_.files, path, &rewrite::File::path);
    if (file == annotated_.files.end() || region.LineStart <= lines_before) return {};
    unsigned const line = region.LineStart - lines_before, last = region.LineEnd - lines_before;
    std::size_t const begin = offset_of(file->text, line, region.ColumnStart);
    std::size_t const end = offset_of(file->text, last, region.ColumnEnd);
    Place place = original_place(*file, {file->display_path, line, region.ColumnStart});
    Place const behind = original_place(*file, {file->display_path, last, region.ColumnEnd});
    std::size_t const first = offset_of(file->original, line, place.column);
    std::string const text = file->text.substr(begin, end - begin);
    if (begin >= end || place.column == 0 || behind.column == 0 ||
        file->original.compare(first, offset_of(file->original, last, behind.column) - first, text) != 0)
      return {};
    return BranchCount{to_string(place), shortened(text), {}, 0, 0};
  }

  rewrite::Result const &annotated_;
  rewrite::Kernel const &kernel_;
  Lines const lines_;
  std::string const innermost_;
  std::uint64_t const samples_;
  std::map<std::pair<std::string, std::pair<unsigned, unsigned>>, std::vector<FunctionInstance>> functions_; // by place
};

} // namespace

BranchResult read_branches(CoveredRun const &run, rewrite::Result const &annotated, rewrite::Kernel const &kernel) {
  if (run.samples == 0) return {"no sample was compared", {}};
  CountsByName const counts = read_counts(run.profile);
  auto const object = llvm::MemoryBuffer::getFile(run.program);
  if (counts.empty() || !object) return {"the program has written no counts", {}};
  llvm::SmallVector<std::unique_ptr<llvm::MemoryBuffer>> buffers;
  std::vector<std::string> const running = functions_at(run.program, run.stack);
  std::size_t innermost = running.size();
  std::string failure;
  auto const for_each = [&](auto use) {
    auto readers = llvm::coverage::BinaryCoverageReader::create((*object)->getMemBufferRef(), "", buffers);
    if (!readers) return void(failure = llvm::toString(readers.takeError()));
    for (auto const &reader : *readers)
      for (auto record : *reader)
        if (record)
          use(*record);
        else
          failure = llvm::toString(record.takeError());
  };
  // Functions in other files, which annotations call, are skipped.
  for_each([&](CoverageMappingRecord const &record) {
    auto const found = std::ranges::find(running, linker_name(record.FunctionName));
    if (found == running.end() || record.Filenames.empty()) return;
    if (std::ranges::find(annotated.files, record.Filenames.front(), &rewrite::File::path) == annotated.files.end())
      return;
    innermost = std::min(innermost, static_cast<std::size_t>(found - running.begin()));
  });
  if (failure.empty() && innermost == running.size())
    failure = "the function that holds the kernel is not among those that are counted";
  if (!failure.empty()) return {failure, {}};
  Reader result(annotated, kernel, running[innermost], run.samples);
  for_each([&](CoverageMappingRecord const &record) {
    auto const found = counts.find({record.FunctionName.str(), record.FunctionHash});
    if (found != counts.end()) result.add(record, found->second);
  });
  return {{}, result.result()};
}

} // namespace symreal::program
