// tree.h — ANTLR's parse tree → Ast.
#pragma once

#include <span>
#include <vector>

#include "syntax/complain.h"

namespace kadr::syntax {

/// Fills an Ast from the parse tree. Parts that a syntax error spoiled become Invalid nodes.
class TreeBuilder {
  public:
    TreeBuilder(const SourceFile& file, Ast& ast) : file_(file), ast_(ast) {}

    void build(KadrParser::FileContext& file);

  private:
    using Rule = antlr4::ParserRuleContext;
    using Node = antlr4::tree::ParseTree;

    // tree.cpp: declarations
    DeclId declaration(KadrParser::DeclarationContext& context);
    void simple_declaration(Decl& decl, KadrParser::DeclarationContext& context);
    void members(Decl& decl, KadrParser::DeclarationContext& context);
    void callable(Decl& decl, KadrParser::DeclarationContext& context);
    void curve(Decl& decl, KadrParser::CurveDeclarationContext& context);
    DeclId variable(KadrParser::VariableContext& context, bool is_const);
    DeclId contour(Rule& context, antlr4::tree::TerminalNode* name, KadrParser::BlockContext& body);
    List parameters(KadrParser::ParametersContext& context);
    List preserved(KadrParser::PreservesContext* context);
    TypeId type(KadrParser::TypeContext& context);
    TextId plain_text(KadrParser::TextContext& context);
    TextId documentation(std::uint32_t begin);
    TextId units(antlr4::tree::TerminalNode* name);
    void name(Decl& decl, antlr4::tree::TerminalNode* name);

    // tree_statements.cpp
    StmtId statement(KadrParser::StatementContext& context);
    StmtId block(KadrParser::BlockContext& context);
    void if_statement(Stmt& stmt, KadrParser::IfStatementContext& context);
    void for_statement(Stmt& stmt, KadrParser::ForStatementContext& context);
    StmtId for_start(KadrParser::ForStartContext& context);
    void switch_statement(Stmt& stmt, KadrParser::SwitchStatementContext& context);
    void words_statement(Stmt& stmt, KadrParser::WordsStatementContext& context);
    void with_statement(Stmt& stmt, KadrParser::WithStatementContext& context);
    void raw_statement(Stmt& stmt, KadrParser::RawStatementContext& context);
    void simple_statement(Stmt& stmt, KadrParser::StatementContext& context);
    List statements(std::span<KadrParser::StatementContext* const> contexts);
    Word word(KadrParser::WordContext& context);
    Word literal(const Lexeme& lexeme);

    // tree_expressions.cpp
    ExprId expression(KadrParser::ExpressionContext& context);
    ExprId assignment(KadrParser::AssignmentContext& context);
    ExprId condition(KadrParser::ConditionContext& context);
    ExprId range(KadrParser::RangeContext& context);
    ExprId operand(KadrParser::OperandContext& context);
    ExprId primary(KadrParser::PrimaryContext& context);
    ExprId suffix(ExprId base, KadrParser::SuffixContext& context);
    ExprId point(KadrParser::PointContext& context);
    std::int8_t skip_level(KadrParser::SkipContext& context);
    ExprId number(const Lexeme& lexeme);
    ExprId name(const Lexeme& lexeme);
    ExprId text(KadrParser::TextContext& context);
    ExprId braces(Rule& context, std::span<KadrParser::ArgumentContext* const> values);
    /// Operators and operands behind the first operand, up to the end or a `?`, by precedence.
    ExprId by_precedence(ExprId first, std::span<Node* const> rest);
    List arguments(KadrParser::ArgumentsContext* context);
    ExprId binary(Operator op, ExprId left, ExprId right);
    ExprId unary(Operator op, ExprId value, const SourceRange& range);

    ExprId add(const Expr& expr);
    StmtId add(const Stmt& stmt);
    DeclId add(const Decl& decl);
    List list(std::span<const ExprId> ids);
    List list(std::span<const StmtId> ids);
    List list(std::span<const DeclId> ids);
    List list(std::span<const Word> words);

    SourceRange range_of(const Rule& context) const;
    static const Lexeme& lexeme(antlr4::Token* token) {
        return static_cast<LexemeToken*>(token)->lexeme();
    }
    static const Lexeme& lexeme(Node* terminal) {
        return lexeme(static_cast<antlr4::tree::TerminalNode*>(terminal)->getSymbol());
    }
    static Token token_at(const Rule& context) { return lexeme(context.start).token; }

    const SourceFile& file_;
    Ast& ast_;
    std::vector<std::uint16_t> depths_;  // of each expression
    bool has_complained_of_depth_ = false;
};

}  // namespace kadr::syntax
