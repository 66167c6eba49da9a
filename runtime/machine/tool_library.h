// tool_library.h — the tools of a shop as one file has them: what they are called, how large they
// are, how they cut.
//
// Programs, machines, checks and the set-up sheet share it. What is not given is not zero: a size
// that the file leaves out is nothing here. XML is read here, CSV where tables are
// (sema/tool_table.h); both go through the same checks.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"
#include "machine/described.h"

namespace kadr::machine {

struct Machine;

enum class ToolKind : std::uint8_t {
    EndMill,
    BallMill,
    BullNose,
    FaceMill,
    ChamferMill,
    ThreadMill,
    Drill,
    CentreDrill,
    Tap,
    Reamer,
    Boring,
    Turning,
    Grooving,
    Threading,
    Probe,
};

/// As files and programs spell them, in the order of ToolKind.
inline constexpr std::array<std::string_view, 15> kToolKinds = {
    "end mill",    "ball",    "bull nose",    "face mill", "chamfer mill",
    "thread mill", "drill",   "centre drill", "tap",       "reamer",
    "boring",      "turning", "grooving",     "threading", "probe"};

inline std::string_view tool_kind_name(ToolKind kind) {
    return kToolKinds[static_cast<std::size_t>(kind)];
}
/// Its size is the radius of a nose, not a diameter.
bool is_turned_with(ToolKind kind);

/// How a tool cuts one material.
struct CuttingData {
    std::string material;                  // as the shop calls it; empty: the only one
    std::optional<double> cutting_speed;   // mm/s, > 0
    std::optional<double> feed_per_tooth;  // mm, > 0
    std::optional<double> feed_per_turn;   // mm/rev, > 0
};

struct LibraryTool {
    std::int64_t number = 0;
    std::string name;
    ToolKind kind = ToolKind::EndMill;
    std::optional<double> diameter;       // mm, > 0
    std::optional<double> corner_radius;  // mm, ≥ 0; of a turning tool its nose
    std::optional<double> length;         // mm, as it is measured from the spindle nose
    std::optional<std::int64_t> flutes;   // > 0
    std::optional<double> tip_angle;      // deg, > 0, at most 180
    std::optional<double> pitch;          // mm, > 0, of a tap
    std::string holder;                   // empty: not said
    std::vector<CuttingData> cutting;     // in the order of the file
    SourceRange range;                    // where the file has it

    /// What the machine's table has of it: cutter radius, or radius of the nose; 0: not known.
    double offset_radius() const;
};

struct ToolLibrary {
    std::string file;
    std::vector<LibraryTool> tools;  // in the order of the file

    const LibraryTool* find(std::string_view name) const;
    const LibraryTool* find(std::int64_t number) const;
};

/// A tool as a file says it, before it has been checked.
struct ToolEntry {
    LibraryTool tool;
    std::optional<std::int64_t> number;
    std::string kind;
    /// Where the file says it; not valid: it does not.
    SourceRange number_at, name_at, kind_at, diameter_at, corner_at, flutes_at, tip_at;
};

/// Takes tools one by one and holds them against each other.
class ToolLibraryBuilder {
  public:
    explicit ToolLibraryBuilder(DiagnosticSink& sink) : sink_(sink), described_(sink) {}

    /// A tool that has no mistake becomes one of the library; every mistake is reported.
    void add(ToolEntry entry);
    /// Cutting data of the tool that was named last.
    void add_cutting(CuttingData cutting, const SourceRange& at);
    ToolLibrary take(std::string file);

  private:
    Done require_name(const ToolEntry& entry);
    Done require_sizes(const ToolEntry& entry);

    DiagnosticSink& sink_;
    Described described_;
    ToolLibrary library_;
    bool last_is_good_ = false;
};

/// Reads the XML file of a library. Every mistake is reported with its location; nothing is
/// returned then. The schema: machines/tools.xsd.
std::optional<ToolLibrary> load_tool_library(FileId file, const Sources& sources,
                                             DiagnosticSink& sink);

/// The machine with the tools of the library, as an operator would enter them: those that its file
/// has keep their measures and get names. A radius that differs is warned of.
void add_tools(Machine& machine, const ToolLibrary& library, DiagnosticSink& sink);

}  // namespace kadr::machine
