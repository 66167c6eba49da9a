// taken_ways.h — the ways that a program takes while it runs, held against what reading alone finds
// (macro/references.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "macro/line_watch.h"
#include "nc/dialect.h"

namespace kadr::interp {

/// A way with texts of its own; the text that was begun with has no name.
struct KeptWay {
    macro::WayTaken::Kind kind = macro::WayTaken::Kind::Jump;
    std::uint64_t line = 0;
    std::string file;
    std::uint64_t to_line = 0;
    std::string to_file;
    friend auto operator<=>(const KeptWay&, const KeptWay&) = default;
};

/// Looks on from the first line to the last one, as a trace does.
class WatchedWays final : public macro::LineWatch {
  public:
    bool comes_to(const macro::WatchedLine&) override { return true; }
    void takes(const macro::WayTaken& way) override;
    /// Each once, sorted.
    std::vector<KeptWay> ways() const;

  private:
    std::vector<KeptWay> ways_;
};

/// Expects that each way leads to where the references of its text say, and that what the control
/// has missed is missing in them. What a value decides is passed over.
///
/// called    where the programs stand that it calls
/// messages  of the run, in which the text is called `test`
/// returns   how many ways were compared
std::size_t expect_references(const nc::Dialect& dialect, const std::string& text,
                              const std::filesystem::path& called, const std::vector<KeptWay>& ways,
                              const std::vector<Diagnostic>& messages);

}  // namespace kadr::interp
