// setup_sheet.h — what a person at the machine needs before a program runs: tools, offsets,
// parameters, times, travel, pictures. One page as HTML or Markdown.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "machine/tool_library.h"
#include "motion/pipeline.h"

namespace kadr::driver {

/// What a tool does, for how long.
struct SheetWork {
    std::string name;  // "drill_peck"
    double time = 0;   // s
};

struct SheetTool {
    std::int64_t number = 0;  // 0: before the first call
    std::string name;         // empty: nobody has named it
    const machine::LibraryTool* library =
        nullptr;        // null: the library has it not, or there is none
    double radius = 0;  // mm, of the machine's table; 0: not known
    double length = 0;  // mm, likewise
    double cutting = 0, rapid = 0, change = 0, other = 0;  // s
    std::optional<double> lowest;                          // mm, Z of the tip at feed
    std::vector<SheetWork> work;                           // in the order of their beginning
    std::string picture;                                   // SVG; empty: it has not moved

    double time() const { return cutting + rapid + change + other; }
};

struct SheetOffset {
    std::string word;      // "G54"
    std::string position;  // "X 100 Y 20"; empty: all zero
};

struct SheetParameter {
    std::string name;
    std::string value;     // as the command line or the source has it
    std::string standard;  // its default; empty: it has none
    bool differs() const { return value != standard; }
};

struct SheetAxis {
    std::string name;
    bool is_rotary = false;
    double least = 0, most = 0;          // mm or deg, of the run
    std::optional<double> lower, upper;  // of the machine; nothing: no limit
};

struct SetupSheet {
    std::string title;             // "bracket.kadr"
    std::string subtitle;          // control and machine
    std::string warning;           // empty: the run is whole
    std::string library;           // its file; empty: none
    std::vector<SheetTool> tools;  // in the order of use
    std::vector<SheetOffset> offsets;
    std::vector<SheetParameter> parameters;
    std::vector<SheetAxis> axes;
    double time = 0;  // s
};

/// The sheet as one file that needs no other, for paper and for screens, bright or dark.
std::string setup_sheet_html(const SetupSheet& sheet);
/// The same as tables of Markdown, without pictures.
std::string setup_sheet_markdown(const SetupSheet& sheet);

}  // namespace kadr::driver
