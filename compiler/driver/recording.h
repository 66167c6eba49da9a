// recording.h — what became of a call that a test executed: its moves, measured.
//
// Only what the call itself did counts: commands and pieces of motion whose statement is known. The
// set-up before it and the frame of the ISO-7bit text have none.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "expand/test_bench.h"
#include "motion/segment.h"
#include "path/command.h"
#include "sema/code.h"

namespace kadr::driver {

class Recording {
  public:
    /// Commands and pieces of motion, each in their order; they may come mixed.
    void add(const path::Command& command);
    void add(const motion::Segment& segment);
    /// To be called when the run is over, before anything is asked.
    void finish();

    expand::FigureAnswer ask(sema::Figure figure, std::span<const sema::Slot> arguments) const;

    std::string text;     // ISO-7bit
    std::string dialect;  // name
    std::uint64_t blocks = 0;
    std::size_t errors = 0;
    std::size_t alarms = 0;
    std::size_t warnings = 0;
    std::string message;  // the first error or alarm

  private:
    /// Where the tool can be is known of an axis from its first move on, and no more after a move
    /// in machine coordinates.
    struct Knowledge {
        std::uint32_t line = 0;
        AxisMask before = 0;
        AxisMask after = 0;
    };
    struct Move {
        path::Curve curve;
        bool is_rapid = false;
        AxisMask known_before = 0;  // of X, Y, Z
        AxisMask known_after = 0;
        SourceId source;

        path::Vec3 start() const { return path::start(curve); }
        path::Vec3 end() const { return path::end(curve); }
        bool is_known() const;
        bool is_in_plane() const;
    };
    struct Hole {
        path::Vec3 bottom;
    };
    /// Least and greatest coordinates; NaN where nothing is known.
    struct Extent {
        std::array<double, 3> lower;
        std::array<double, 3> upper;
    };

    Knowledge knowledge_at(std::uint32_t line) const;
    static Extent extent(const Move& move);
    Extent extent_of_all(bool with_rapids) const;
    std::array<double, 3> final_position() const;
    void find_holes();
    void find_levels();
    bool was_cut(std::size_t before, const path::Vec3& point) const;
    void answer_inside(std::span<const sema::Slot> arguments, expand::FigureAnswer& answer) const;
    void answer_rapids(bool blind, double height, expand::FigureAnswer& answer) const;

    std::vector<Knowledge> knowledge_;
    AxisMask known_ = 0;
    std::vector<motion::Segment> segments_;
    std::vector<Move> moves_;
    std::vector<Hole> holes_;
    std::vector<double> levels_;
    std::vector<double> tools_;
    double time_ = 0;
    double cutting_time_ = 0;
    double rapid_time_ = 0;
    double dwell_time_ = 0;
    double cutting_length_ = 0;
    double rapid_length_ = 0;
};

}  // namespace kadr::driver
