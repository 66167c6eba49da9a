// text_state.h — the one owner of what a text has written: its changes, each with a name.
//
// Words and blocks change it at once (text_state.cpp); what the functions of a block leave behind
// comes when its line is written (following.cpp). Nobody else writes to it.
#pragma once

#include <span>
#include <vector>

#include "write/text_view.h"

namespace kadr::write {

class TextState {
  public:
    explicit TextState(const Dialect& dialect);
    TextState(const TextState&) = delete;
    TextState& operator=(const TextState&) = delete;

    const TextView& view() const { return view_; }
    const WriterModal& modal() const { return modal_; }
    std::span<const Pending> pending() const { return pending_; }
    bool has_ended() const { return has_ended_; }  // the program ends itself

    /// The state in which every Kadr program begins; the start lines bring the control there.
    void begin(bool is_inch);
    /// Behind raw text nothing is known.
    void forget();
    /// Behind a block that the operator may leave out holds what is so with and without it.
    void join(const WriterModal& before);
    /// What the program knows of the axes behind a change of its frame, of which the text has
    /// nothing.
    void take_position(const Block& block);

    // What the program means
    void mean(const Block& block);
    void mean(const ModalFunctions& functions);
    void mean(Group group, Function function);
    /// The functions and numbers of a block, before its words are made.
    void mean_all(const Block& block);

    // What words write
    void say(const Form& form);
    /// As if a word programmed it, where none can.
    void assume(Function function);
    void say_feed(double number, bool is_other);
    void say_speed(double number);
    /// An argument that stays in force: of a shift.
    void say_shift(std::size_t argument, double value);
    /// A word of a start line with a shift that stays: from the beginning the axis has it.
    void start_shift(const Form& form, AddressId address, double value);
    /// A frame that no word of the text writes: until a shift replaces all of them.
    void refuse_frame();
    /// The angle of a frame, whose rounding the positions behind it pay for.
    void say_turn(const Block& block, const Invocation& invocation, double angle_deg, int places);

    // F beside its word
    void begin_lead(bool is_pitch);
    /// Behind a thread: the feed of the program, which the pitch in F is not.
    void end_lead(const NumberInForce& feed, bool is_other);
    /// The feed of a block that was written in parts, each with a time of its own.
    void mean_shared_feed(double feed);
    void doubt_feed();
    void doubt_speed();

    // Positions
    /// An axis goes to a coordinate or by a distance, in mm or degrees; returns where it stood in
    /// the text.
    double go(std::size_t axis, double value, bool is_distance);
    /// A straight move that the fast path writes.
    struct Arrival {
        std::size_t axis;
        double text;
    };
    void arrive(const Block& block, Function motion, std::span<const Arrival> arrivals);
    void lose(std::size_t axis);
    /// X means something else from here on: where the tool stands has another number.
    void change_diameter(Function before);
    /// Behind the blocks of a shape, which the control has passed over: the tool is where it was.
    void come_back(const WrittenPosition& position);
    /// Where the cycle has left the tool.
    void follow_back(const Block& block, const Invocation& cycle);

    // Cutting edges and held-back words
    /// The edge that waits acts again; 0 if none does.
    double call_waiting_edge();
    void edge_is_given(const WrittenPosition& position);
    void length_acts();
    /// A change of the length, which words of the block give that moves the axis next.
    ///
    /// deferred  what stands for the length with the number; null: it ends
    void hold_length(const Block& block, const Deferred* deferred, double number);
    void length_is_given(Function function);
    /// Edge 0 acts; returns the one before.
    NumberInForce drop_edge();
    void let_wait(double edge);
    void set_offset(std::size_t pending, double tool);
    void drop_pending(std::size_t pending);

    /// What the functions of the block leave behind, when its line is written.
    void follow(const Block& block);

  private:
    void stand_without_codes();
    void say(Function function, const Form& form);

    void follow_effect(const Block& block, const Effect& effect);
    void follow_shift(const FrameChange& change);
    void follow_shift_add(const FrameChange& change);
    void follow_scale(const FrameChange& change);
    void name_position(const FrameChange& change);
    void end_tilted_plane(const Block& block, const Effect& effect);
    void turn_axes(std::size_t axis);
    void call_tool(const Block& block, const Effect& effect);
    void call_edge(const Block& block, const Effect& effect);
    void change_length(const Block& block);
    void forget_words(const Block& block, const Effect& effect);
    void forget_unsaid(const Block& block);
    void forget_motion();
    void leave_changer();
    void defer_length(const Block& block, const Invocation& invocation);
    // A length that waits has words of its own in the program, for its axis.
    void drop_pending_length();

    const DialectTables& tables_;
    const Rules& rules_;
    const nc::Changer changer_;
    WriterModal modal_;
    FeedWord feed_word_;
    std::vector<Pending> pending_;
    bool has_ended_ = false;
    const TextView view_{tables_, modal_, feed_word_};
};

inline void TextState::arrive(const Block& block, Function motion,
                              std::span<const Arrival> arrivals) {
    modal_.meant[index_of(Group::Motion)] = motion;
    WrittenPosition& position = modal_.position;
    SlotMask named = 0;
    for (const Arrival& arrival : arrivals) {
        const auto slot = static_cast<Slot>(arrival.axis);
        position.meant[arrival.axis] = block.at(slot);
        position.text[arrival.axis] = arrival.text;
        named |= bit(slot);
    }
    position.known |= named;
    position.name(named);
    if (!block.has(Slot::Feed)) return;
    modal_.meant_feed = block.at(Slot::Feed);
    modal_.has_meant_feed = true;
}

}  // namespace kadr::write
