// The files that a run leaves: all of them or none.
#pragma once

#include "lanes/lanes.h"
#include "reroll/reroll.h"
#include "schedule/schedule.h"
#include "tool/options/language_option.h"
#include "tool/options/options.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct OutputFile {
  std::string path, text;
};

// The schedule as C and C++ print it, where that is among the languages: what loops and vectors are looked for in.
Schedule as_emitted(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                    std::vector<Language const *> const &languages);

// Generated code beside `path`, which gives it its name: of each language the source, its header and on request the
// mainline.
std::vector<OutputFile> emitted_files(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                                      std::vector<Language const *> const &languages, std::string const &path,
                                      Rerolled const *loops = nullptr, Laned const *lanes = nullptr);

// Fails when a file of this name cannot be written; before the work is done, so that it is not done in vain.
void require_writable(std::string const &path);
void require_writable(std::vector<OutputFile const *> const &files);
void require_writable(std::vector<OutputFile> const &files);

// Makes a directory for results where there is none.
void make_directory(std::string const &path);

// Does the disk hold these files? What differs is reported, and its difference printed to standard output.
bool check_files(std::vector<OutputFile const *> const &files);

// Returns the paths. Files that are up to date are left alone.
std::vector<std::string> write_files(std::vector<OutputFile> const &files);

} // namespace symreal::tool
