// line_reader.h — one line of ISO-7bit text → Block, under the modal state that the lines before it
// have left.
//
// Where lines come from, and in which order, is not known here: reader.h reads a text from its head
// to its end, interp runs a program with jumps. For the rooms of nc and for interp.
#pragma once

#include <bitset>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "base/done.h"
#include "nc/control_line.h"
#include "nc/lexer.h"
#include "nc/number_text.h"
#include "nc/point_watch.h"

namespace kadr::nc {

/// How a letter is treated on the fast way; made once a reader.
struct FastLetter {
    enum class Kind : std::uint8_t { None, Slot, Code, Number };
    Kind kind = Kind::None;
    Slot slot = Slot::X;
    AddressId address = kNoAddress;
    Dimension dimension = Dimension::Number;
    const NumberFormat* format = nullptr;
    bool is_position = false;  // where a number without a point counts in increments
    bool is_literal = false;   // a number means what it says, and the control takes every one
};

/// A word of several letters that the fast way reads, `CR=5`.
struct FastName {
    std::string_view name;
    FastLetter word;
};

/// What a computed value of a line has come to; in the order of ControlLine::computed.
struct WordValue {
    enum class Kind : std::uint8_t { Number, Text, Vacant };
    Kind kind = Kind::Number;
    double number = 0;
    std::string_view text;
};

/// What was found of the words of a line when it ran first, for the next time. Holds as long as the
/// modal functions are the same, and if no computed value says what the block does.
struct MatchedLine {
    bool is_valid = false;
    ModalFunctions before{};
    std::vector<Claim> claims;
    std::vector<FormId> forms;
    Block shape;  // functions and modes, without values
};

/// The text that lines stand in, and how far a program in it is read.
struct TextState {
    std::string name;          // shown in messages
    std::string program;       // as the head names it
    bool has_content = false;  // blocks or statements were read
    bool has_ended = false;    // the end mark, or the head of another program
};

class LineReader {
  public:
    /// `name` is shown in messages. A mistake is reported as the control's alarm.
    LineReader(const Dialect& dialect, std::string name, DiagnosticSink& sink);

    /// What a line is before its words are looked at.
    enum class LineKind : std::uint8_t { Nothing, Words, Misplaced, WrongNumber };

    enum class Makes : std::uint8_t { Block, Nothing };

    /// The meaning of a line of words and numbers. Where it makes nothing, what is wrong has been
    /// reported, and `failed()` says so.
    Makes read(std::string_view line, std::uint64_t number, Block& block);

    // The same in steps, for who knows more kinds of lines.
    void begin(std::uint64_t number) {
        line_number_ = number;
        lexed_ = nullptr;  // of a line before, which may be gone
    }
    /// The line with blanks in place of a program's head that words stand behind: `O0001 G20`. Any
    /// other line as it is. The text lives until the next head.
    std::string_view without_head(std::string_view line);
    /// Plain codes and numbers behind letters: nearly every block. The block is empty before. Gives
    /// up, without a word, on anything that needs a second look.
    bool read_plain(std::string_view line, Block& block);
    /// What kind of line it is; reports what stands in a wrong place.
    LineKind check_kind(std::string_view line);
    /// A line of the control's own language that the dialect knows by its letters.
    bool read_known(std::string_view line, Block& block);
    /// Whether it is one; the block is empty before and after.
    bool knows(std::string_view line, Block& block) const {
        const bool is_known = read_verbatim(line, block);
        block.reset();
        return is_known;
    }
    /// The words of a compiled line with the values that were computed for it.
    ///
    /// known  what an earlier run of the line has found; null: nobody keeps it
    Done read_words(std::string_view line, ControlLine& compiled, std::span<const WordValue> values,
                    Block& block, MatchedLine* known = nullptr);
    /// The decimals to which the control rounds a value of the line.
    int value_decimals(const ControlLine& line, std::size_t computed) const;
    /// The line is not written as the control wants it.
    void report_fault(std::string_view line, const LineFault& fault) { report(line, fault); }
    /// What came up while the line was executed; how it is written is right. Notes of who asks may
    /// be added.
    DiagnosticBuilder report_event(std::string_view line, const LineFault& fault) {
        return report(line, fault, FaultOf::Execution);
    }
    void report_too_long(std::string_view line, std::uint64_t number);
    /// An alarm that somebody else has reported came up in this line.
    void note_fault() {
        failed_ = true;
        if (first_fault_ == 0) first_fault_ = line_number_;
    }
    /// What was wrong in a line was told, and the lines behind count as before.
    void forget_fault() {
        failed_ = false;
        first_fault_ = 0;
    }
    /// The end mark of the program was read.
    bool has_ended() const { return text_->has_ended; }
    /// The lines that follow stand in this text, which outlives its use.
    void enter(TextState& text) { text_ = &text; }
    const TextState& text() const { return *text_; }
    /// Something that is no block was executed; a head of a program behind it begins another one.
    void note_content() { text_->has_content = true; }
    /// Adds to each message what is to be said about the place of the line.
    void add_notes(std::function<void(DiagnosticBuilder&)> notes) { notes_ = std::move(notes); }
    void write_notes(DiagnosticBuilder& message) const {
        if (notes_) notes_(message);
    }
    /// Goes back to modal functions of before: adds to the block what restores them, as if words
    /// had said it, and follows it.
    void restore(const ModalFunctions& wanted, Block& block);

    /// The program is at its end: positions that all have no decimal point are told.
    void finish_points();

    /// Each word of a line that has no effect here is said once.
    void say_passed(const LexedLine& words, std::string_view line);

    bool failed() const { return failed_; }
    std::uint64_t first_fault() const { return first_fault_; }
    const TextUnits& units() const { return units_; }
    const ModalFunctions& modal() const { return modal_; }
    /// The form that said something for a group of the dialect last; kNoForm.
    FormId last_form(std::size_t group) const { return last_forms_[group]; }
    /// The form that called a cycle last; kNoForm.
    FormId last_cycle() const { return last_cycle_; }
    /// The number of the last M function; 0: none was said.
    double machine_code() const { return machine_code_; }
    TextLocation place(std::string_view line, std::uint64_t number, const Span& span) const {
        return place(text_->name, shown(line, number), number, span);
    }
    /// The line as it stands in the text: what without_head gives has blanks for the head.
    std::string_view shown(std::string_view line, std::uint64_t number) const {
        return number == head_number_ && line == head_line_ ? head_text_ : line;
    }
    static TextLocation place(const std::string& file, std::string_view line, std::uint64_t number,
                              const Span& span);
    const DialectTables& tables() const { return tables_; }

  private:
    const PassedWord* passed_beside(const MatchFault& fault) const;
    void pass(const MatchFault& fault, const PassedWord& found, std::string_view line);
    void watch_point(const Claim& claim, std::string_view line);
    bool is_place(const Claim& claim) const;
    /// Whether a number without a point is a thousandth of what it looks like.
    static bool counts_increments(const Address& address) {
        return address.format.increment > 0 && address.format.increment < 1;
    }
    /// Whether the word says a place: an end, a centre or a radius.
    static bool is_place(Slot slot) {
        return ((kTargetSlots | kCenterSlots | bit(Slot::Radius)) & bit(slot)) != 0;
    }
    Done read_slow(std::string_view line, Block& block);
    bool read_fast(std::string_view line, Block& block);
    bool match_verbatim(const Form& form, std::string_view text, Block& block) const;
    bool read_verbatim(std::string_view line, Block& block) const;
    Done fill(std::string_view line, Block& block, MatchedLine* known = nullptr,
              const ControlLine* compiled = nullptr);
    void recall(const MatchedLine& known, Block& block);
    void remember(const ControlLine& compiled, const Block& block, MatchedLine& known) const;
    void set_values(ControlLine& compiled, std::span<const WordValue> values);
    double whole_if_needed(AddressId id, double value) const;
    bool has_decimal_codes(AddressId id) const;
    double rounded(double value, const NumberFormat& format, Dimension dimension) const;
    Done apply(Block& block, std::string_view line);
    Done apply_claim(const Claim& claim, Block& block, std::string_view line);
    Done apply_whole(const Claim& claim, Block& block, std::string_view line);
    bool is_pitch(const Claim& claim, const Block& block) const;
    void note_form(FormId id, std::string_view line);
    void note_machine_code(std::string_view line);
    bool name_spindles(LexedLine& words) const;
    Done check_code_points(std::string_view line);
    Span span_of_form(const Form& form, std::string_view line) const;
    LineKind kind_of(std::string_view line);
    void note_program(std::string_view line);
    bool has_wrong_number(std::string_view line) const;
    bool are_of_motions(const Address& address);
    void prepare(std::size_t letter);
    void prepare_names();
    FastLetter fast_word(AddressId id);
    const FastLetter* fast_name(const char*& p, const char* end) const;
    void follow(const Block& block);
    void follow_units();
    enum class FaultOf : std::uint8_t { Writing, Execution };
    DiagnosticBuilder report(std::string_view line, const LineFault& fault,
                             FaultOf of = FaultOf::Writing);
    bool is_in_cycle() const;
    void report(std::string_view line, const MatchFault& fault);
    bool is_polynomial(FormId form) const;
    void take_argument_fault(const MatchFault& fault, LineFault& out) const;
    void take_other_plane(const MatchFault& fault, LineFault& out) const;
    std::string word_text(std::string_view line, std::size_t word) const;

    const Dialect& dialect_;
    const DialectTables& tables_;
    TextState own_text_;
    TextState* text_ = &own_text_;
    DiagnosticSink& sink_;
    std::function<void(DiagnosticBuilder&)> notes_;
    std::array<FastLetter, 128> letters_;
    std::vector<FastName> names_;  // by name
    ModalFunctions modal_{};
    std::bitset<kFunctions> closely_read_;  // modes under which words have other meanings
    TextUnits units_;
    std::array<double, static_cast<std::size_t>(Dimension::Text) + 1> slot_scales_{};
    bool feed_stays_metric_ = false;
    bool feed_is_time_ = false;                      // … of a block, s
    bool feed_is_pitch_ = false;                     // of threads, with the digits of a pitch
    std::string head_line_;                          // what without_head gives …
    std::string head_text_;                          // … of this line …
    std::uint64_t head_number_ = ~std::uint64_t{0};  // … and its number
    std::uint64_t line_number_ = 0;
    bool failed_ = false;
    std::uint64_t first_fault_ = 0;
    LexedLine* lexed_ = nullptr;  // of the line that is read, once it is
    LexedLine own_lexed_;
    Match match_;
    PointWatch points_;
    std::vector<FormId> last_forms_;  // of each group of the dialect
    FormId last_cycle_ = kNoForm;
    double machine_code_ = 0;
    bool knows_masters_ = false;     // the program has chosen a master spindle
    bool has_other_master_ = false;  // … which is not the first one
    std::vector<FormId> passed_;     // forms of which was said that they are passed over
    std::set<const PassedWord*> said_passed_;
};

}  // namespace kadr::nc
