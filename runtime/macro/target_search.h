// target_search.h — where the names of a text lead, once all of it was looked through. Internal to
// macro.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "macro/program_units.h"
#include "macro/scanned_text.h"

namespace kadr::macro {

/// What other texts declare, each once.
class OutsideNames {
  public:
    explicit OutsideNames(References& out) : out_(out) {}
    /// Its index.
    std::uint32_t add(NamedPlace declaration);

  private:
    References& out_;
    std::map<std::pair<std::string, std::uint64_t>, std::uint32_t> known_;  // by file and byte
};

class TargetSearch {
  public:
    /// References outlive it.
    ///
    /// text  that was scanned, one of `units`
    TargetSearch(const nc::DialectTables& tables, ProgramUnits& units, ProgramText& text,
                 ScannedText& scanned, OutsideNames& outside);

    /// Gives every open use its outcome.
    void run();

  private:
    using Outcome = TextUse::Outcome;
    /// What became of an open use, for those that depend on it.
    struct Found {
        ProgramUnit* unit = nullptr;            // of a Program
        std::uint32_t place = OpenUse::kNone;   // … in this text; index into `programs`
        std::optional<ProgramLine> line;        // of a target, in the program …
        std::uint32_t called = OpenUse::kNone;  // … that this open use calls; none: the own one
    };

    void settle(std::uint32_t open);
    void settle_program(const OpenUse& open, Found& found);
    void settle_in_text(const OpenUse& open, const TargetIndex::Hit* hit, Found& found);
    void settle_called(const OpenUse& open, std::uint32_t called, const ProgramLine& from,
                       Found& found);
    void settle_behind(const OpenUse& open, Found& found);
    void settle_counted(const OpenUse& open, Found& found);
    void settle_return(const OpenUse& open);
    void settle_arguments();
    const TargetIndex::Hit* first_in(std::uint32_t place, const LineTarget& target) const;
    const TargetIndex::Hit* around(const OpenUse& open) const;
    ProgramUnit* unit_of(const std::string& name, const std::string& kind);
    std::uint32_t place_of(const ProgramUnit& unit) const;
    NamedPlace declaration_of(const ProgramUnit& unit) const;
    NamedPlace declaration_of(const ProgramUnit& unit, const ProgramLine& line,
                              const LineTarget& target) const;

    const nc::DialectTables& tables_;
    ProgramUnits& units_;
    ProgramText& text_;
    ScannedText& scanned_;
    OutsideNames& outside_;
    std::vector<Found> found_;                       // of ScannedText::open
    std::map<std::uint64_t, std::uint32_t> places_;  // by the position of the head, or of the text
    std::map<std::pair<std::string, std::string>, ProgramUnit*> programs_;  // null: there is none
    std::map<std::uint32_t, std::set<std::uint32_t>> callers_;  // of programs of the text, places
};

}  // namespace kadr::macro
