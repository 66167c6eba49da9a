// feed_characteristics.h — how the feed of motions comes to F: evenly, by a polynomial, by a
// spline.
//
// Behind everything that makes commands: a block may have become several motions, which have its
// feed characteristic together, and a spline runs over blocks that have to be known first. Motions
// without such a word go through as they are.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/stream.h"
#include "path/command.h"

namespace kadr::interp {

class FeedCharacteristics {
  public:
    /// Asked whether a command with a feed characteristic may be among those that were pulled.
    using Asks = std::function<bool()>;
    /// Informed of a motion whose feed would fall to this, 0 or less, in the unit of F; an alarm.
    using Reports = std::function<void(const path::Command&, double)>;

    /// All outlive this.
    FeedCharacteristics(Stream<path::Command>& commands, Asks has_varying_feed, Reports report)
        : commands_(commands),
          has_varying_feed_(std::move(has_varying_feed)),
          report_(std::move(report)) {}

    /// Commands whose feed law gives the feed along each of them.
    ///
    /// source  SINUMERIK reference 3.2; splines: complete_spline.h, without curvature at their ends
    std::size_t pull(std::span<path::Command> out);

  private:
    /// The motions of one block.
    struct BlockMotions {
        std::size_t first = 0;  // in what is held; its last motion is before `end`
        std::size_t end = 0;
        double length = 0;
    };
    struct Reached {
        double feed = 0;  // at the end of the latest motion
        path::FeedMode mode = path::FeedMode::PerMinute;
        double slope = 0;  // … of a polynomial: by the path
        bool is_tangent = false;
    };
    bool read();
    void settle();
    BlockMotions run_from(std::size_t first);
    void note(const path::Command& command);
    void settle_block(const BlockMotions& run);
    void settle_spline(const BlockMotions& first);
    [[nodiscard]] bool lay(const BlockMotions& run, const path::FeedPolynomial& feed);
    path::FeedPolynomial polynomial_of(const BlockMotions& run, double from) const;
    double length_of(const path::Motion& motion, const AxisValues& from) const;
    bool continues(const path::Command& command, const path::Command& next) const;

    Stream<path::Command>& commands_;
    Asks has_varying_feed_;
    Reports report_;
    std::vector<path::Command> batch_;
    std::vector<path::Command> held_;
    std::size_t taken_ = 0;  // of those held, that are out
    std::size_t ready_ = 0;  // … that may go out
    bool is_drained_ = false;
    AxisValues at_{};
    std::optional<Reached> reached_;
};

}  // namespace kadr::interp
