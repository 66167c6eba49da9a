// generated_text.h — a checked program as ISO-7bit text, piece by piece.
//
// The half of the road that a compiler is: evaluate → write. `kadr expand` copies the pieces to a
// file, `kadr run` feeds them to the reader.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/done.h"
#include "driver/call_map.h"
#include "driver/deadline.h"
#include "driver/line_map.h"
#include "driver/output.h"
#include "driver/program.h"
#include "expand/expander.h"
#include "nc/phrases.h"
#include "nc/reader.h"
#include "write/cycle_groups.h"
#include "write/writer.h"

namespace kadr::driver {

/// What is evaluated, and how it is set going.
struct Entry {
    std::string name;  // of the ISO-7bit program
    bool is_inch = false;
    SourceRange range;                             // of the name
    const sema::FunctionCode* function = nullptr;  // that begins; null: not known
    /// Called again if an error of the writer asks for the calls that led to it.
    std::function<Done(expand::Expander&)> start;
};

/// What goes on beside the making of a text.
struct TextAside {
    Output* map = nullptr;     // gets a line for every block; null: no source map
    bool keeps_calls = false;  // for GeneratedText::calls_behind
    /// Is shown every statement, if the code has names: the text is then made block by block, and
    /// nothing of it before somebody has asked for the block in front.
    expand::StatementWatch* watch = nullptr;
    /// The text is only looked at, beside one that is executed: values are shown to nobody, and an
    /// evaluation that makes no block for long is given up.
    bool is_only_looked_at = false;
};

class GeneratedText final : public nc::TextSource, public nc::PhraseText {
  public:
    /// All references outlive the text.
    GeneratedText(Session& session, const KadrProgram& program, const nc::Dialect& target,
                  const TextAside& aside = {});
    /// The same with its messages to a sink of its own.
    GeneratedText(Session& session, const KadrProgram& program, const nc::Dialect& target,
                  const TextAside& aside, DiagnosticSink& sink);
    ~GeneratedText() override;

    /// Chooses the program and sets its parameters.
    Done start();
    Done start(const Entry& entry);

    /// The text is not run: what the interpreter would warn of is looked for here.
    /// `messages` silences what the source allows, and outlives the text.
    void warn_of_cuts(const Messages& messages);

    std::string_view next() override;
    /// Of a text that is made block by block: the rest of what is made at once otherwise.
    void finish_piece();
    bool is_phrase(std::uint64_t line) const override;

    /// Gets every piece of the text as it is made. To be set before `start`.
    using Tap = std::function<void(std::string_view)>;
    void set_tap(Tap tap) { tap_ = std::move(tap); }
    /// Lines up to the program's last block: what follows is the frame's end (`%`). Complete when
    /// the text is.
    std::uint32_t body_lines() const { return body_lines_; }

    /// Whether evaluating or writing came to an error.
    bool failed() const;
    const LineMap& lines() const { return *line_map_; }
    /// The calls that led to a line; null if there are none, or they are forgotten or not kept.
    const expand::BlockOrigin* calls_behind(std::uint32_t line) const {
        return call_map_ ? call_map_->find(line) : nullptr;
    }
    /// A message about a line that is still known comes to the statement that wrote it, or where
    /// the library was called that did; the line becomes a note.
    void move_to_statement(Diagnostic& diagnostic) const;
    std::uint64_t blocks() const { return made_.taken; }
    /// Lines that were made so far.
    std::uint32_t made_lines() const { return writer_.lines(); }
    /// Whether the lines with which a program begins are among them.
    bool has_started() const { return writer_.has_started(); }
    /// What evaluates the program, for TextAside::watch.
    const expand::Expander& expander() const { return expander_; }
    /// Lines so far that a statement of the program made.
    std::uint64_t statement_lines() const { return statement_lines_; }

  private:
    Done require_units(const Entry& entry);
    /// Where errors of the writer go: to each the calls that led to the block are added, and what
    /// a statement of the library cannot write is an error where the library was called.
    class WriterMessages final : public DiagnosticSink {
      public:
        WriterMessages(const GeneratedText& text, DiagnosticSink& sink)
            : text_(text), sink_(sink) {}
        void take(Diagnostic diagnostic) override;

      private:
        const GeneratedText& text_;
        DiagnosticSink& sink_;
        SourceRange last_call_;  // of the library, about which something was reported, …
        const DiagnosticRow* last_row_ = nullptr;  // … and what
    };

    /// Where errors of evaluating go, and warnings of the library's authors: what a function of the
    /// library finds is reported where the library was called.
    class ExpanderMessages final : public DiagnosticSink {
      public:
        ExpanderMessages(const GeneratedText& text, DiagnosticSink& sink)
            : text_(text), sink_(sink) {}
        void take(Diagnostic diagnostic) override;

      private:
        const GeneratedText& text_;
        DiagnosticSink& sink_;
    };

    expand::ExpandOptions expand_options(const TextAside& aside) const;
    void write_batch();
    void make_block();
    void make_piece();
    std::vector<Diagnostic::Note> calls_of_block(std::uint64_t number) const;
    bool is_in_library(const SourceRange& range) const;
    bool move_to_call(Diagnostic& diagnostic, std::vector<Diagnostic::Note>& calls,
                      const char* words) const;
    void write_block(const nc::Block& block, std::uint64_t number);
    bool keeps_origins() const;
    const expand::BlockOrigin& origin_of(std::uint64_t number) const;
    void keep_origins_of_held();
    void map_block(std::uint64_t number, std::uint32_t line);
    SourceRange last_statement() const;

    Session& session_;
    const KadrProgram& program_;
    const nc::Dialect& target_;
    std::function<Done(expand::Expander&)> start_;
    ExpanderMessages expander_messages_;
    expand::Expander expander_;
    WriterMessages writer_messages_;
    write::Writer writer_;
    TextAside aside_;
    std::unique_ptr<LineMap> line_map_;
    std::unique_ptr<CallMap> call_map_;  // null: nobody asks
    std::vector<nc::Block> batch_;
    std::string text_;
    std::string entry_;
    struct MadeBlocks {
        std::uint64_t taken = 0;        // blocks of the expander so far
        std::uint64_t batch_begin = 0;  // … before this batch
        std::uint64_t writing = 0;      // number of the one that is being written
    } made_;
    std::optional<write::CycleGroups> groups_;  // nothing: calls stay as they are
    struct HeldOrigin {
        std::uint64_t number;
        expand::BlockOrigin origin;
    };
    std::vector<HeldOrigin> held_origins_;  // of blocks that wait in groups_
    std::optional<std::size_t> sound_;      // length of the text before the first error in it
    std::vector<std::uint32_t> phrases_;    // lines, rising; few programs have any
    Deadline deadline_;
    bool is_late_ = false;
    SourceId last_source_;
    std::uint64_t statement_lines_ = 0;
    bool is_at_end_ = false;
    bool has_given_head_ = false;  // of a text that is made block by block …
    std::size_t piece_bytes_ = 0;  // … how much of what would be a piece otherwise
    Tap tap_;
    std::uint32_t body_lines_ = 0;
};

/// The program of the file that is run: the one with this name, or the only one if none is asked
/// for. Null if there is none.
const sema::FunctionCode* chosen_program(const sema::Code& code, std::string_view name);

}  // namespace kadr::driver
