// cycle_shapes.h — blocks of the program that are the shape along which a cycle works.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Blocks of the program that are the shape along which a cycle works.
class CycleShapes {
  public:
    explicit CycleShapes(Channel& channel);
    CycleShapes(const CycleShapes&) = delete;
    CycleShapes& operator=(const CycleShapes&) = delete;

    /// The blocks behind the call, up to its last one, are the shape.
    void begin_shape(const nc::Block& block, const ModalCycle& call);
    /// The block is one that the shape can have.
    Done require_shape_block(const nc::Block& block);
    /// Behind a block of the shape: was it the last one?
    void end_shape_block(const nc::Block& block);
    bool keeps_shape() const { return shape_ && !shape_->is_followed; }

  private:
    bool is_behind_shape(const nc::Block& block) const;
    void finish_shape();
    void return_from_shape();
    CycleShape shape_of(const ShapeRun& run) const;

    Channel& channel_;
    const nc::Dialect& dialect_;
    Reporter& reporter_;
    Modal& modal_;
    const control::Frames& frames_;
    const AxisData& axes_;
    const CycleRun& cycle_;
    std::optional<ShapeRun>& shape_;
};

}  // namespace kadr::interp
