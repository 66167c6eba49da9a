// path_smoothing.h — exact stop, corner blending, compressed lines.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Exact stop, corner blending, compressed lines.
class PathSmoothing {
  public:
    explicit PathSmoothing(Channel& channel);
    PathSmoothing(const PathSmoothing&) = delete;
    PathSmoothing& operator=(const PathSmoothing&) = delete;

    /// How the corner behind a motion of this block is blended.
    path::Blending blending(path::Op op) const;
    /// Whether a motion ends at rest: by what is modal, or by a word of its block alone.
    bool stops_exactly(bool once = false) const;
    /// Within which tolerance a motion of this block may become a part of a curve; 0: not at all.
    /// The moves of cycles are what they are.
    double compressing(path::Op op) const;
    /// How far corners are blended and whether short lines become curves; mm.
    void choose_smoothing(const nc::Block& block, const nc::Invocation& invocation);

  private:
    void choose_high_speed(const nc::Block& block, const nc::Invocation& invocation);

    Channel& channel_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    Modal& modal_;
    const Orienting& orienting_;
    const Virtual& virtual_;
    const ProgrammedDynamics& dynamics_;
    Smoothing smoothing_;
};

}  // namespace kadr::interp
