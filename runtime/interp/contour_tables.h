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

    std::string_view begin_contour();
    std::optional<ContourElements> end_contour();
    Done require_contour_block(const nc::Block& block);
    void note_contour_block(const nc::Block& block);

  private:
    std::optional<ContourElements> contour_of(const ContourRun& run);

    Channel& channel_;
    Reporter& reporter_;
    const Modal& modal_;
    const control::Frames& frames_;
    const Spindle& spindle_;
    const Corners& corners_;
    const Units& units_;
    const ModalCycles& modal_cycles_;
    const std::optional<ShapeRun>& shape_;
    std::optional<ContourRun>& contour_;
    const std::vector<PatternRun>& patterns_;
};

}  // namespace kadr::interp
