// line_uses.h — what a compiled line declares and names. Internal to macro.
#pragma once

#include <string>
#include <string_view>

#include "macro/replaced_text.h"
#include "macro/scanned_text.h"

namespace kadr::macro {

/// A line as it was compiled, and as it stands in its text.
struct ReadLine {
    std::string_view text;  // that was compiled
    ProgramLine place;
    std::uint64_t begin = 0;                 // byte of the text at which the line begins
    const ReplacedText* numbered = nullptr;  // its names stand for numbers; null: it has none
    const ReplacedText* expanded = nullptr;  // … then its words for text; null: it has none

    TextRange range(nc::Span span) const;
};

/// The variable as lines that use it see it; how many elements it has nobody knows.
nc::ControlSymbol symbol_of(const TextDeclaration& declaration);

class LineUses {
  public:
    /// References outlive it.
    LineUses(const nc::DialectTables& tables, ScannedText& out) : tables_(tables), out_(out) {}

    /// names  of the program, which is the last one of the text so far; get those that it declares
    void take(const ReadLine& line, const nc::ControlLine& code, NamesOfProgram& names);
    /// The shape along which the cycle works that the block of the line calls: blocks by their
    /// numbers, a program, or what stands between two labels.
    void take_shape(const ReadLine& line, const nc::ControlLine& code, const nc::Block& block,
                    const nc::CycleInfo& cycle);

  private:
    using Kind = TextUse::Kind;

    void take(const nc::ControlStatement& statement);
    void take_call(const nc::ControlStatement& statement);
    void take_call_by_text(const nc::ControlStatement& statement);
    void take_start(const nc::Call& call, std::uint32_t program);
    void take_return(const nc::ControlStatement& statement);
    void take_repeat(const nc::ControlStatement& statement);
    void take_section(const nc::ControlStatement& statement);
    void take_head(const nc::ControlStatement& statement);
    void take_macro(const nc::ControlStatement& statement);
    void declare(const nc::Declaration& declaration, const nc::ControlStatement& statement);
    void declare(const nc::ProcedureParameter& parameter);
    void declare(TextDeclaration declaration);
    void take_arguments(const nc::Call& call, std::uint32_t program);
    void take_variables();
    bool take_variable(Kind kind, const nc::Span& span);
    void take_words();

    std::uint32_t take_shape_block(const nc::Block& block, int parameter);
    std::uint32_t name_label(std::uint32_t program, std::uint32_t first, const nc::Span& span,
                             const std::string& label);
    nc::Span span_of_parameter(const nc::Block& block, int parameter) const;

    TextUse& add_use(Kind kind, const nc::Span& span, std::string name = {});
    OpenUse& open(const TextUse& use, OpenUse::Rule rule);
    std::uint32_t aim(Kind kind, OpenUse::Rule rule, const nc::JumpTarget& target);
    std::uint32_t aim_at_number(Kind kind, OpenUse::Rule rule, const nc::CallValue& value);
    std::uint32_t aim(Kind kind, OpenUse::Rule rule, const nc::Span& span,
                      const std::optional<LineTarget>& target);
    std::uint32_t call_program(Kind kind, const nc::Span& span, const std::string& name,
                               const std::string& kind_of_program);
    nc::Span span_of_number(const nc::CallValue& value, const std::string& digits) const;
    nc::Span span_of_name(const nc::Span& span, std::string_view name) const;

    const nc::DialectTables& tables_;
    ScannedText& out_;
    const ReadLine* line_ = nullptr;
    const nc::ControlLine* code_ = nullptr;
    NamesOfProgram* names_ = nullptr;
};

}  // namespace kadr::macro
