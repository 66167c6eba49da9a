// messages.h — what the writer reports: each message once for a statement, at the word that it is
// about.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_set>

#include "write/names.h"

namespace kadr::write {

class BlockMessages {
  public:
    /// units  of the text, as they are when a message names a value
    BlockMessages(const DialectTables& tables, const TextUnits& units, DiagnosticSink& sink)
        : tables_(tables), units_(units), sink_(sink) {}

    void set_statements(std::span<const SourceRange> statements, const Sources* sources) {
        statements_ = statements;
        sources_ = sources;
    }
    bool failed() const { return failed_; }

    /// The statement of the block; nothing if it has none.
    SourceRange location(const Block& block) const { return location(block.source); }
    SourceRange location(SourceId source) const;

    DiagnosticBuilder report(const DiagnosticRow& row, const Block& block) {
        return sink_.report(row, location(block));
    }
    /// … at the word of the statement that sets the address.
    DiagnosticBuilder report_word(const DiagnosticRow& row, const Block& block,
                                  std::string_view address) {
        return sink_.report(row, word_location(block, address));
    }

    /// Whether the statement has not had this reported yet: a loop reports once.
    bool first_time(const Block& block, std::string_view what);
    /// … and the writing failed.
    bool fails_first_time(const Block& block, std::string_view what);
    /// Whether the frame that the statement programs has not been reported yet.
    bool first_time_of_frame(SourceId statement);
    /// The writing failed; what is reported of it every time is reported by the caller.
    void fail() { failed_ = true; }

    void cannot_express(const Block& block, const std::string& what);
    /// name  of the word that needs the positions of the axes
    void position_unknown(const Block& block, std::string_view name, SlotMask axes);
    void position_unknown(const Block& block, std::string_view name, std::size_t axis) {
        position_unknown(block, name, SlotMask{1} << axis);
    }
    /// value: in the unit of the text, before what a form makes of it.
    void number_fault(const Block& block, NumberFault fault, double value, Dimension dimension,
                      std::string_view name);
    void line_too_long(std::size_t length);

  private:
    SourceRange word_location(const Block& block, std::string_view address) const;

    const DialectTables& tables_;
    const TextUnits& units_;
    DiagnosticSink& sink_;
    std::span<const SourceRange> statements_;
    const Sources* sources_ = nullptr;            // of the statements; may be missing
    std::unordered_set<std::uint64_t> reported_;  // statement and message
    bool failed_ = false;
};

}  // namespace kadr::write
