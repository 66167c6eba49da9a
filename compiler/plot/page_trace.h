// page_trace.h — what a page that plays a machine needs of a run: positions thinned to what the eye
// can tell apart, and which block acts when.
//
// Bounded memory whatever the length of the run. Knows nothing of HTML or JSON; page.h writes them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/axes.h"
#include "machine/machine.h"
#include "motion/pipeline.h"

namespace kadr::plot {

/// A location in one of the texts of a page; line 0: nowhere.
struct PageLocation {
    std::int32_t text = -1;  // index into the page's texts
    std::uint32_t line = 0;  // from 1
    friend bool operator==(const PageLocation&, const PageLocation&) = default;
};

/// From this moment on, until the next one.
struct PageBlock {
    double time = 0;  // s
    motion::SegmentKind kind = motion::SegmentKind::Rapid;
    std::uint32_t tool = 0;  // index into PageTrace::tools
    PageLocation iso;        // of the ISO-7bit text
    PageLocation source;     // of the Kadr program, if there is one

    bool is_same(const PageBlock& other) const {
        return kind == other.kind && tool == other.tool && iso == other.iso &&
               source == other.source;
    }
};

class PageTrace {
  public:
    /// A setpoint that is kept. Between two of them everything goes evenly in time.
    struct Sample {
        double time = 0;
        std::array<double, kAxes> axis{};  // mm or deg, in the order of Machine::axes
        double feed = 0;                   // mm/min
    };

    /// `most_samples`, `most_blocks`: what is kept at most, both at least 4.
    PageTrace(const machine::Machine& machine, std::size_t most_samples, std::size_t most_blocks);

    /// Setpoints and pieces of motion, each in their order; from two threads, if the caller likes.
    void add(const motion::Setpoint& setpoint);
    /// `segment` is the piece with which the block begins to act.
    void add(PageBlock block, const motion::Segment& segment);
    /// To be called behind the last setpoint.
    void finish();

    const std::vector<Sample>& samples() const { return samples_; }
    const std::vector<PageBlock>& blocks() const { return blocks_; }
    /// From the tip to the end of the zero tool at base position, mm: each tool that was used.
    const std::vector<path::Vec3>& tools() const { return tools_; }
    /// No position is farther than this from where the axis was, mm or deg.
    double tolerance() const { return tolerance_; }
    const machine::Machine& machine() const { return machine_; }

  private:
    static constexpr std::size_t kColumns = kAxes + 1;
    using Slopes = std::array<double, kColumns>;

    void take(const Sample& sample);
    bool reaches(const Sample& sample) const;
    void narrow(const Sample& sample);
    void open_cone();
    void thin();
    void thin_blocks();
    bool becomes_feed(const PageBlock& block) const;
    std::uint32_t tool_of(const motion::Segment& segment);
    double column(const Sample& sample, std::size_t i) const {
        return i < kAxes ? sample.axis[i] : sample.feed;
    }
    double column_tolerance(const Sample& sample, std::size_t i) const;

    const machine::Machine& machine_;
    std::size_t most_samples_;
    std::size_t most_blocks_;
    std::vector<Sample> samples_;  // the last one is where the cone begins
    Sample pending_;               // the latest that the line from there reaches
    bool has_pending_ = false;
    Slopes lower_{};  // of lines from there that pass all setpoints since within the tolerance
    Slopes upper_{};
    double step_;           // tolerance of this pass, mm or deg
    double tolerance_ = 0;  // of all passes together
    std::vector<PageBlock> blocks_;
    double shortest_block_ = 0;  // s; shorter ones are joined to their neighbours
    bool begins_anew_ = true;    // the piece before was the last one of its command
    std::vector<path::Vec3> tools_;
};

}  // namespace kadr::plot
