// program_units.h — programs and the texts that they stand in: found by name, kept once read.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "macro/program_files.h"
#include "macro/program_map.h"
#include "nc/line_reader.h"

namespace kadr::macro {

/// A line that runs more than once.
struct CompiledLine {
    std::string text;
    std::string as_written;  // if names or words in it stood for other text
    ProgramLine program_line;
    enum class Kind : std::uint8_t {
        New,       // nobody has looked at it
        Plain,     // words and numbers: the reader handles them
        Known,     // the dialect knows it by its letters
        Compiled,  // `line` holds
        Nothing,   // nothing stands there
        End,       // the program ends here: an end mark, or the head of another one
    };
    Kind kind = Kind::New;
    nc::LineContext context;  // under which it was compiled
    nc::ControlLine line;
    nc::MatchedLine matched;
    CompiledLine* next = nullptr;  // the line behind it, if that one is kept as well
};

/// One text; several programs may stand in it.
struct ProgramText {
    ProgramText(nc::TextSource& text, std::string name, std::size_t kept, std::size_t longest);

    std::unique_ptr<nc::TextSource> own;  // of a file that a call has opened
    std::string name;                     // for messages
    nc::KeptText kept_text;
    bool is_kept;  // it cannot be read again by itself
    nc::LineSource source;
    std::vector<std::uint32_t> windows;  // of the ids of its lines; the main text needs none
    // Heads of programs that were seen in it, up to a position: by name, then by kind.
    std::map<std::string, std::map<std::string, LinePosition>> programs;
    LinePosition seen;
    bool is_seen_whole = false;
};

/// A program: what stands in a text from a position up to the next head of a program.
struct ProgramUnit {
    ProgramUnit(const nc::DialectTables& tables, ProgramText& text_, const LinePosition& begin_,
                std::string name_)
        : text(&text_),
          begin(begin_),
          name(std::move(name_)),
          map(tables, text_.source, begin_),
          frontier(begin_) {}

    ProgramText* text;
    LinePosition begin;
    std::string name;  // empty: of the main program
    ProgramMap map;
    LinePosition frontier;  // of the first line that was never executed
    std::unordered_map<std::uint64_t, std::unique_ptr<CompiledLine>> compiled;
    bool has_looked_for_head = false;
    std::optional<nc::ControlLine> head;  // with its statement, if it is a procedure
    LinePosition head_line;               // … where that stands
    bool has_wrong_head = false;  // … that has a fault, which is reported where it is executed

    const nc::ControlStatement* procedure() const { return head ? &head->statements[0] : nullptr; }
};

class ProgramUnits {
  public:
    /// files  may be null: then only programs of the main text are found
    ProgramUnits(const nc::Dialect& dialect, nc::TextSource& main, std::string name,
                 std::size_t kept, ProgramFiles* files);

    ProgramUnit& main() { return *main_; }
    /// Looks whether it is a procedure.
    void look_for_main_head() { look_for_head(*main_); }
    /// Looks where the main program begins; before anything is read.
    void settle_main();
    /// The program with this name, looked for in `near` first; nullptr: there is none.
    ///
    /// kind  of the program (nc::kind_of); empty: any, in the order in which the control looks
    ProgramUnit* find(const std::string& name, ProgramText& near, const std::string& kind = {});
    /// The program with definitions for all the others: one that stands in front of the main
    /// program in its text, or a file. nullptr: there is none. `settle_main` comes first.
    ProgramUnit* find_definitions(const std::string& name);
    /// A text that is executed in front of the main program.
    ProgramUnit& add(std::unique_ptr<nc::TextSource> text, std::string name);
    /// What a line is called in a block: one number for all texts, the line's own in the main one.
    std::uint32_t line_id(ProgramText& text, std::uint64_t line);
    struct Line {
        const ProgramText* text;
        std::uint64_t number;
    };
    Line line_of(std::uint32_t id) const;

  private:
    std::optional<LinePosition> find_in_file(const std::string& name, const std::string& kind,
                                             ProgramText*& text);
    ProgramUnit& keep(const std::string& name, const std::string& kind, ProgramText& text,
                      const LinePosition& begin);
    std::optional<LinePosition> find_in(ProgramText& text, const std::string& name,
                                        const std::string& kind) const;
    const LinePosition* first_of(const ProgramText& text, const std::string& name,
                                 const std::string& kind, bool is_whole) const;
    LinePosition main_begin() const;
    void look_for_head(ProgramUnit& unit) const;

    const nc::Dialect& dialect_;
    const nc::DialectTables& tables_;
    std::size_t kept_;
    ProgramFiles* files_;
    std::vector<std::unique_ptr<ProgramText>> texts_;
    std::unique_ptr<ProgramUnit> main_;
    std::vector<std::unique_ptr<ProgramUnit>> added_;
    // By name and kind, as they are asked for.
    std::map<std::pair<std::string, std::string>, std::unique_ptr<ProgramUnit>> units_;
    struct Window {
        ProgramText* text;
        std::uint64_t first;
    };
    std::vector<Window> windows_;
};

}  // namespace kadr::macro
