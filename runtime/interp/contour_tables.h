// contour_tables.h — blocks of the program that become a table of contour elements.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Blocks of the program that become a table of contour elements.
class ContourTables {
  public:
    explicit ContourTables(Channel& channel);
    ContourTables(const ContourTables&) = delete;
    ContourTables& operator=(const ContourTables&) = delete;

    /// Empty: from here on blocks become a table; else what hinders it.
    std::string_view begin_contour();
    /// The elements; nothing: one was reported.
    std::optional<ContourElements> end_contour();
    /// The block is one that a contour can have.
    Done require_contour_block(const nc::Block& block);
    /// What acted in a block that was executed, for the elements that come of it.
    void note_contour_block(const nc::Block& block);

  private:
    std::optional<ContourElements> contour_of(const ContourRun& run);

    Channel& channel_;
    Reporter& reporter_;
    const Modal& modal_;
    const control::Frames& frames_;
    const ProgrammedSpindle& spindle_;
    const Corners& corners_;
    const ProgrammedUnits& units_;
    const ModalCycles& modal_cycles_;
    const std::optional<ShapeRun>& shape_;
    std::optional<ContourRun>& contour_;
    const std::vector<PatternRun>& patterns_;
};

}  // namespace kadr::interp
