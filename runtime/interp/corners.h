// corners.h — chamfers and roundings: commands of the programmed contour in, commands with the
// corners cut out, a motion later.
//
// What a chamfer or a rounding is, is path/contour_corner.h; here is the order of things in a
// program: a motion waits for the next one in the plane, and what stands between them waits too.
// The cutter radius compensation comes behind it and sees the inserted elements as blocks of the
// contour.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "interp/compensation.h"
#include "interp/compensation_3d.h"
#include "path/command.h"
#include "path/contour_corner.h"
#include "path/frame.h"

namespace kadr::interp {

/// The corner that a block wants at its end.
struct CornerWish {
    enum class Kind : std::uint8_t { None, Length, Width, Round };  // Length, Width: of a chamfer
    Kind kind = Kind::None;
    double size = 0;         // mm in the base system
    double feed = 0;         // of the inserted element; 0: that of a neighbour
    bool is_modal = false;   // nothing is reported where there is no corner
    bool is_open = false;    // no corner so far: a block behind this one may wish for it
    bool is_square = false;  // along `next` the contour goes on, in the direction of `sign`
    Axis next = Axis::X;
    double sign = 1;
    path::Mat3 lie = path::Mat3::Identity();  // of the plane: into the base system
};

struct CornerSettings {
    bool is_strict = false;
    bool feed_of_next = true;
    int empty_blocks = 3;
};

/// Where a message about a corner points to.
struct CornerSource {
    SourceId source;
    std::uint32_t line = 0;
};

struct CornerMessage {
    const DiagnosticRow* row = nullptr;
    CornerSource source;
    double made = 0;  // CornerReduced: what was made, and what was wanted
    double wanted = 0;
};

/// A change of the compensation, at its position among the commands.
struct CompChange {
    enum class Kind : std::uint8_t {
        Leave,
        Begin,
        Set,
        KeepVector,
        RoundCorner,
        Pause,
        Resume,
        LetGo,
        Again
    };
    Kind kind = Kind::Set;
    CompSettings settings;
    path::Plane plane = path::Plane::Xy;
    double distance = 0;
    AxisValues here{};                         // where the tool is, Begin
    std::optional<path::Vec2> direction = {};  // Leave, RoundCorner
    path::Command motion = {};                 // RoundCorner
    path::Vec2 aside = path::Vec2::Zero();     // Begin, Set: see Compensation::set_aside
    std::optional<Comp3dSettings> space = {};  // Begin, Set: 3D compensation
};

class Corners {
  public:
    /// What comes out, in order.
    struct Item {
        enum class Kind : std::uint8_t { Command, Comp, EndOfBlock };
        Kind kind = Kind::Command;
        path::Command command;
        CompChange change;
        AxisValues here{};    // EndOfBlock: where the tool is behind the block
        CornerSource source;  // EndOfBlock: the block
    };

    explicit Corners(const CornerSettings& settings) : settings_(settings) {}

    /// Whether commands go through here: from a block with a wish to the corner's other side.
    bool is_active() const { return is_active_; }
    /// Whether a corner waits in a plane that lies otherwise.
    bool waits_elsewhere(const path::Mat3& lie) const { return is_active_ && lie != lie_; }
    /// The block that begins now wants a corner. `here` is where the tool is.
    void wish(const CornerWish& wish, const AxisValues& here, const CornerSource& source);

    /// The block that begins now wants a corner at the end of the motion before it. Null: it will
    /// be made as any other; else why there can be none.
    const DiagnosticRow* wish_behind(const CornerWish& wish, const CornerSource& source);

    /// Where the executor puts a command while corners are active.
    path::Command& next();
    void change(const CompChange& change);
    /// Takes what a block has put. `here` is where the tool is behind it.
    std::optional<CornerMessage> end_block(const AxisValues& here, const CornerSource& source);
    /// Nothing follows that could be the other side of a corner; `why` is reported if one waits
    /// that was wished for.
    std::optional<CornerMessage> leave(const DiagnosticRow& why);
    /// Items that are settled, in the base system.
    std::vector<Item> take_settled();
    /// Calls `see` for every command that waits, in order.
    template <typename See>
    void look_at_waiting(See see) const {
        for (const auto* items : {&held_, &fresh_}) {
            for (const Item& item : *items)
                if (item.kind == Item::Kind::Command)
                    see(items == &held_ ? in_base(item).command : item.command);
        }
    }
    /// Warnings; the caller clears them.
    std::vector<CornerMessage>& warnings() { return warnings_; }

  private:
    using Fault = const DiagnosticRow*;  // null: none

    Item in_base(Item item) const;
    void turn_item(const path::Mat3& by, Item& item) const;
    Fault take(Item& item);
    Fault take_motion(Item& item);
    Fault take_other_motion(Item& item);
    Fault join(path::Command& next);
    void wait(Item item, const AxisValues& from);
    std::optional<path::CornerCut> cut(const path::Element& a, const path::Element& b,
                                       Fault& fault);
    Fault check_sides(const path::Motion& next, const path::Element& a,
                      const path::Element& b) const;
    void shorten(const path::CornerCut& cut);
    void insert(const path::CornerCut& cut, const path::Command& first, path::Command& next);
    void stand_tool(path::Motion& motion) const;
    void insert_arc(path::Command inserted, const path::Element& piece);
    void insert_rapid_arc(path::Command part, const path::Element& arc);
    void release();
    void pass(Item item);
    bool is_in_plane(const path::Motion& motion) const;
    bool is_taken(const path::Motion& motion, const AxisValues& from) const;
    path::Element element_of(const path::Motion& motion, const AxisValues& from) const;
    AxisValues between(const AxisValues& from, const AxisValues& to, double share,
                       const path::Vec2& at) const;
    void set_in_plane(AxisValues& values, const path::Vec2& at) const;
    path::Vec2 in_plane(const AxisValues& values) const;
    CornerMessage end_with(const DiagnosticRow& row);

    CornerSettings settings_;
    path::Mat3 lie_ = path::Mat3::Identity();  // what is taken lies in the plane so
    bool is_active_ = false;
    bool waits_ = false;  // the first of `held_` is the motion before the corner
    CornerWish wish_;     // of the block that is being taken
    CornerWish held_wish_;
    CornerSource source_;                    // of the block that wished
    CornerSource block_source_;              // of the block that is being taken
    AxisValues held_from_{};                 // start of the motion that waits
    AxisValues at_{};                        // end of the latest motion …
    path::Vec3 tool_ = path::Vec3::UnitZ();  // … and how the tool stands there
    path::Plane plane_ = path::Plane::Xy;
    path::PlaneAxes axes_;
    int empty_blocks_ = 0;
    std::size_t motions_ = 0;  // in the plane, so far
    std::vector<Item> fresh_;
    std::vector<Item> held_;
    std::vector<Item> settled_;
    std::vector<CornerMessage> warnings_;
};

}  // namespace kadr::interp
