// known_values.h — what the program tells of feed, spindle, tool and length, and of the cutter
// radius compensation. For the room expand only.
#pragma once

#include <array>
#include <optional>

#include "base/source.h"
#include "nc/vocabulary.h"

namespace kadr::expand {

/// What acts in each modal group, and since which statement.
class ActiveGroups {
  public:
    /// None: not known.
    nc::Function operator[](nc::Group group) const { return member_[place(group)]; }
    SourceId by(nc::Group group) const { return by_[place(group)]; }

    /// A member that acts without a statement that programs it.
    void assume(nc::Group group, nc::Function member) { member_[place(group)] = member; }
    void set(nc::Group group, nc::Function member, SourceId by) {
        member_[place(group)] = member;
        by_[place(group)] = by;
    }
    void forget_all() { member_.fill(nc::Function::None); }

  private:
    static std::size_t place(nc::Group group) { return static_cast<std::size_t>(group); }

    std::array<nc::Function, nc::kGroups> member_{};
    std::array<SourceId, nc::kGroups> by_{};
};

/// F, as in a block.
class KnownFeed {
  public:
    bool is_known() const { return is_known_; }
    double value() const { return value_; }
    SourceId by() const { return by_; }
    /// It was given, and then the feed mode changed.
    bool is_lost() const { return is_lost_; }
    /// A feed mode of a source whose control does that has deleted it.
    bool is_deleted() const { return is_deleted_; }

    void take(double value, SourceId by) {
        value_ = value;
        is_known_ = true;
        is_lost_ = is_deleted_ = false;
        by_ = by;
    }
    /// What acts where the program begins; 0: none.
    void begin_with(double value) {
        value_ = value;
        is_known_ = value > 0;
    }
    void change_mode() {
        is_lost_ |= is_known_;
        is_known_ = false;
    }
    void forget() { is_known_ = false; }
    /// … and none was taken away by a mode either: nobody knows.
    void forget_all() { is_known_ = is_lost_ = false; }
    void delete_by_mode() { is_deleted_ = true; }

    bool operator==(const KnownFeed& other) const {
        return is_known_ == other.is_known_ && value_ == other.value_;
    }

  private:
    bool is_known_ = false;
    bool is_lost_ = false;
    bool is_deleted_ = false;
    double value_ = 0;
    SourceId by_;
};

/// S of the master spindle, as in a block, and which spindle that is.
class KnownSpeed {
  public:
    bool is_known() const { return is_known_; }
    double value() const { return value_; }
    SourceId by() const { return by_; }
    /// No S was programmed, and no text of unknown meaning stood there.
    bool is_missing() const { return is_missing_; }
    /// S has been programmed under constant cutting speed.
    bool was_of_cutting() const { return was_of_cutting_; }
    /// The spindle whose sense M3, M4 and M5 are; 0: nobody knows.
    double master() const { return master_; }
    /// Whether it turns is the operator's choice.
    bool is_turning_in_doubt() const { return is_turning_in_doubt_; }

    void take(double value, bool is_of_cutting, SourceId by) {
        value_ = value;
        is_known_ = true;
        is_missing_ = false;
        was_of_cutting_ |= is_of_cutting;
        by_ = by;
    }
    /// What acts where the program begins; 0: none.
    void begin_with(double value) {
        value_ = value;
        is_known_ = value > 0;
    }
    void forget() { is_known_ = false; }
    void forget_all() {
        is_known_ = is_missing_ = is_turning_in_doubt_ = false;
        master_ = 0;
    }
    void make_master(double spindle) { master_ = spindle; }
    void doubt_turning(bool is_in_doubt) { is_turning_in_doubt_ = is_in_doubt; }

    bool operator==(const KnownSpeed& other) const {
        return is_known_ == other.is_known_ && value_ == other.value_;
    }

  private:
    bool is_known_ = false;
    bool is_missing_ = true;
    bool was_of_cutting_ = false;
    bool is_turning_in_doubt_ = false;
    double value_ = 0;
    double master_ = 1;
    SourceId by_;
};

/// The tools of the program by their numbers.
class KnownTool {
  public:
    /// That was called last; nothing: nobody knows.
    std::optional<double> called() const { return called_; }
    /// That was changed in last.
    std::optional<double> in() const { return in_; }
    /// None was called, and no text of unknown meaning stood there.
    bool is_missing() const { return is_missing_; }

    void call(double number) { called_ = number; }
    void change() {
        is_missing_ = false;
        in_ = called_;
    }
    void forget_all() {
        called_.reset();
        in_.reset();
        is_missing_ = false;
    }
    /// Known is what both agree on.
    void join(const KnownTool& other) {
        if (called_ != other.called_) called_.reset();
        if (in_ != other.in_) in_.reset();
    }

  private:
    std::optional<double> called_;
    std::optional<double> in_;
    bool is_missing_ = true;
};

/// What is known of the tool's length beside the member of its group.
class KnownLength {
  public:
    /// Of LengthCompOn, where it has one.
    std::optional<double> offset() const { return offset_; }
    /// Its axis is at a point of the machine that no length shifts.
    bool is_away() const { return is_away_; }
    /// `D0` of a source that counts edges is in the text.
    bool has_ended() const { return has_ended_; }
    /// `D0` of a source that counts edges: no tool length.
    bool is_edge_off() const { return is_edge_off_; }

    void take_offset(std::optional<double> number) { offset_ = number; }
    void go_away() { is_away_ = true; }
    void come_back() { is_away_ = false; }
    void end() { has_ended_ = true; }
    void begin_again() { has_ended_ = false; }
    void choose_edge(bool is_off) { is_edge_off_ = is_off; }
    void change_tool() { is_edge_off_ = has_ended_ = false; }
    void forget() { offset_.reset(); }
    void join(const KnownLength& other) {
        if (offset_ != other.offset_) offset_.reset();
    }

  private:
    std::optional<double> offset_;
    bool is_away_ = false;
    bool has_ended_ = false;
    bool is_edge_off_ = false;
};

/// Cutter radius compensation beside the member of its group. Whether it compensates at all may be
/// the operator's choice: then it depends on the level of the blocks that he may leave out, and
/// what acts if he does is followed, too.
class CompensationInUse {
  public:
    static constexpr int kNoChoice = -1;
    static constexpr int kSeveralLevels = -2;

    /// Under which the tool moved in the plane last; None: not known.
    nc::Function moved_under() const { return moved_under_; }
    int choice() const { return choice_; }
    bool is_choice() const { return choice_ != kNoChoice; }
    SourceId by() const { return by_; }

    void move_under(nc::Function side) { moved_under_ = side; }
    /// A block programs the compensation or its end.
    ///
    /// skip_level   of the block; -1: none
    void choose(nc::Function side, int skip_level, SourceId source);
    void forget_choice() { choice_ = kNoChoice; }

  private:
    nc::Function moved_under_ = nc::Function::RadiusCompOff;
    nc::Function without_ = nc::Function::RadiusCompOff;
    int choice_ = kNoChoice;
    SourceId by_;
};

}  // namespace kadr::expand
