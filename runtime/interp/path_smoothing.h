// path_smoothing.h — exact stop, rounded corners, compressed lines.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Exact stop, rounded corners, compressed lines.
class PathSmoothing {
  public:
    explicit PathSmoothing(Channel& channel);
    PathSmoothing(const PathSmoothing&) = delete;
    PathSmoothing& operator=(const PathSmoothing&) = delete;

    path::Blending blending(path::Op op) const;
    bool stops_exactly(bool once = false) const;
    double compressing(path::Op op) const;
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
