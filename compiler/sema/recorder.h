// recorder.h — writes down what the checker finds out, unless it only tries something.
#pragma once

#include <utility>

#include "sema/checked.h"

namespace kadr::sema {

class Recorder {
  public:
    explicit Recorder(Checked& checked) : checked_(checked) {}

    /// Makes room for what is found out about a tree; the files come in the order of their numbers.
    void add_file(const syntax::Ast& ast, const nc::Dialect& dialect);
    void set_units(std::uint32_t file, Units units);
    void import(std::uint32_t file, const SourceRange& range, std::uint32_t imported);

    SymbolId declare(DeclaredSymbol symbol);
    void set_type(SymbolId symbol, Type type);
    /// Ends the scope of a local name at this byte of its file.
    void end_scope(SymbolId symbol, std::uint32_t end);

    // What follows is not recorded while something is only tried.
    void note_value(std::uint32_t file, syntax::ExprId id, const ConstantValue& constant);
    void note_type(std::uint32_t file, syntax::ExprId id, Type type);
    void note_use(std::uint32_t file, syntax::ExprId id, SymbolId symbol);
    void note_givenness(std::uint32_t file, syntax::ExprId id, Givenness givenness);
    void note_type_use(std::uint32_t file, syntax::TypeId id, SymbolId symbol);
    void note_word(std::uint32_t file, const SourceRange& range, SymbolId symbol);
    void note_plan(std::uint32_t file, syntax::StmtId id, std::uint32_t plan);

    /// While it lives, nothing is recorded: an expression is checked to see what it would be.
    class DryRun {
      public:
        explicit DryRun(Recorder& recorder) : recorder_(recorder) { ++recorder_.dry_runs_; }
        DryRun(const DryRun&) = delete;
        DryRun& operator=(const DryRun&) = delete;
        ~DryRun() { --recorder_.dry_runs_; }

      private:
        Recorder& recorder_;
    };

    /// While it lives, everything is recorded, whoever tries something around it: what a global
    /// variable is, is found out once, by the first who asks.
    class Finding {
      public:
        explicit Finding(Recorder& recorder)
            : recorder_(recorder), dry_runs_(std::exchange(recorder.dry_runs_, 0)) {}
        Finding(const Finding&) = delete;
        Finding& operator=(const Finding&) = delete;
        ~Finding() { recorder_.dry_runs_ = dry_runs_; }

      private:
        Recorder& recorder_;
        int dry_runs_;
    };

  private:
    ExpressionFacts* facts(std::uint32_t file, syntax::ExprId id);

    Checked& checked_;
    int dry_runs_ = 0;
};

}  // namespace kadr::sema
