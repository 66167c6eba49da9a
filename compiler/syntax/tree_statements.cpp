#include "base/diagnostics/syntax.h"
#include "syntax/tree.h"

namespace kadr::syntax {

StmtId TreeBuilder::add(const Stmt& stmt) {
    const StmtId id{static_cast<std::uint32_t>(ast_.statements.size())};
    ast_.statements.push_back(stmt);
    return id;
}

StmtId TreeBuilder::statement(KadrParser::StatementContext& context) {
    Stmt stmt;
    stmt.range = range_of(context);
    if (context.exception != nullptr) return add(stmt);
    switch (token_at(context)) {
        case Token::OpenBrace:
            return block(*static_cast<KadrParser::BlockStatementContext&>(context).block());
        case Token::If:
            if_statement(stmt, static_cast<KadrParser::IfStatementContext&>(context));
            break;
        case Token::While: {
            auto& loop = static_cast<KadrParser::WhileStatementContext&>(context);
            stmt.kind = StmtKind::While;
            stmt.expression[0] = condition(*loop.condition());
            stmt.statement[0] = statement(*loop.statement());
            break;
        }
        case Token::Do: {
            auto& loop = static_cast<KadrParser::DoStatementContext&>(context);
            stmt.kind = StmtKind::DoWhile;
            stmt.statement[0] = statement(*loop.statement());
            stmt.expression[0] = condition(*loop.condition());
            break;
        }
        case Token::For:
            for_statement(stmt, static_cast<KadrParser::ForStatementContext&>(context));
            break;
        case Token::Switch:
            switch_statement(stmt, static_cast<KadrParser::SwitchStatementContext&>(context));
            break;
        case Token::Slash:
        case Token::LiteralWord:
        case Token::BareWord:
        case Token::Address:
            words_statement(stmt, static_cast<KadrParser::WordsStatementContext&>(context));
            break;
        case Token::With:
            with_statement(stmt, static_cast<KadrParser::WithStatementContext&>(context));
            break;
        case Token::Const:
            stmt.kind = StmtKind::Declaration;
            stmt.declaration = variable(
                *static_cast<KadrParser::ConstantStatementContext&>(context).variable(), true);
            break;
        case Token::Auto:
        case Token::TypeName:
            stmt.kind = StmtKind::Declaration;
            stmt.declaration = variable(
                *static_cast<KadrParser::VariableStatementContext&>(context).variable(), false);
            break;
        case Token::Contour: {
            auto& kept = static_cast<KadrParser::ContourStatementContext&>(context);
            stmt.kind = StmtKind::Declaration;
            stmt.declaration = contour(kept, kept.Identifier(), *kept.block());
            break;
        }
        case Token::Raw:
            raw_statement(stmt, static_cast<KadrParser::RawStatementContext&>(context));
            break;
        default: simple_statement(stmt, context);
    }
    return add(stmt);
}

/// Statements without statements inside.
void TreeBuilder::simple_statement(Stmt& stmt, KadrParser::StatementContext& context) {
    const auto checked = [&](StmtKind kind, KadrParser::ConditionContext* tested,
                             KadrParser::ExpressionContext* text) {
        stmt.kind = kind;
        stmt.expression[0] = condition(*tested);
        if (text != nullptr) stmt.expression[1] = expression(*text);
    };
    const auto said = [&](StmtKind kind, KadrParser::ExpressionContext* text) {
        stmt.kind = kind;
        stmt.expression[0] = expression(*text);
    };
    switch (token_at(context)) {
        case Token::Semicolon: stmt.kind = StmtKind::Empty; return;
        case Token::Break: stmt.kind = StmtKind::Break; return;
        case Token::Continue: stmt.kind = StmtKind::Continue; return;
        case Token::Close: stmt.kind = StmtKind::Close; return;
        case Token::Return: {
            stmt.kind = StmtKind::Return;
            auto* value = static_cast<KadrParser::ReturnStatementContext&>(context).expression();
            if (value != nullptr) stmt.expression[0] = expression(*value);
            return;
        }
        case Token::Note:
            return said(StmtKind::Note,
                        static_cast<KadrParser::NoteStatementContext&>(context).expression());
        case Token::ErrorWord:
            return said(StmtKind::ErrorStmt,
                        static_cast<KadrParser::ErrorStatementContext&>(context).expression());
        case Token::Warn:
            return said(StmtKind::WarnStmt,
                        static_cast<KadrParser::WarnStatementContext&>(context).expression());
        case Token::Units:
            stmt.kind = StmtKind::Units;
            stmt.text =
                units(static_cast<KadrParser::UnitsStatementContext&>(context).Identifier());
            return;
        case Token::Require: {
            auto& check = static_cast<KadrParser::RequireStatementContext&>(context);
            return checked(StmtKind::Require, check.condition(), check.expression());
        }
        case Token::Assert: {
            auto& check = static_cast<KadrParser::AssertStatementContext&>(context);
            return checked(StmtKind::Assert, check.condition(), check.expression());
        }
        case Token::Expect:
            return checked(StmtKind::Expect,
                           static_cast<KadrParser::ExpectStatementContext&>(context).condition(),
                           nullptr);
        case Token::Assume:
            return checked(StmtKind::Assume,
                           static_cast<KadrParser::AssumeStatementContext&>(context).condition(),
                           nullptr);
        default:
            stmt.kind = StmtKind::Expression;
            stmt.expression[0] = assignment(
                *static_cast<KadrParser::ExpressionStatementContext&>(context).assignment());
    }
}

StmtId TreeBuilder::block(KadrParser::BlockContext& context) {
    Stmt stmt;
    stmt.kind = StmtKind::Block;
    stmt.range = range_of(context);
    stmt.statements = statements(context.statement());
    return add(stmt);
}

List TreeBuilder::statements(std::span<KadrParser::StatementContext* const> contexts) {
    std::vector<StmtId> ids;
    ids.reserve(contexts.size());
    for (KadrParser::StatementContext* context : contexts) ids.push_back(statement(*context));
    return list(ids);
}

void TreeBuilder::if_statement(Stmt& stmt, KadrParser::IfStatementContext& context) {
    stmt.kind = StmtKind::If;
    stmt.expression[0] = condition(*context.condition());
    stmt.statement[0] = statement(*context.statement(0));
    if (context.Else() != nullptr) stmt.statement[1] = statement(*context.statement(1));
}

void TreeBuilder::for_statement(Stmt& stmt, KadrParser::ForStatementContext& context) {
    auto* each = dynamic_cast<KadrParser::ForEachHeadContext*>(context.forHead());
    if (each != nullptr) {
        stmt.kind = StmtKind::ForEach;
        Decl decl;
        decl.kind = DeclKind::Variable;
        decl.range = range_of(*each);
        decl.is_const = each->Const() != nullptr;
        if (each->type() != nullptr) decl.type = type(*each->type());
        name(decl, each->Identifier());
        stmt.declaration = add(decl);
        stmt.expression[0] = range(*each->range());
        stmt.statement[0] = statement(*context.statement());
        return;
    }
    stmt.kind = StmtKind::For;
    auto& count = static_cast<KadrParser::ForCountHeadContext&>(*context.forHead());
    if (count.forStart() != nullptr) stmt.statement[0] = for_start(*count.forStart());
    if (count.condition() != nullptr) stmt.expression[0] = condition(*count.condition());
    if (count.assignment() != nullptr) stmt.expression[1] = assignment(*count.assignment());
    stmt.statement[1] = statement(*context.statement());
}

StmtId TreeBuilder::for_start(KadrParser::ForStartContext& context) {
    Stmt stmt;
    stmt.range = range_of(context);
    if (auto* declared = dynamic_cast<KadrParser::ForDeclarationContext*>(&context)) {
        stmt.kind = StmtKind::Declaration;
        Decl decl;
        decl.kind = DeclKind::Variable;
        decl.range = stmt.range;
        if (declared->type() != nullptr) decl.type = type(*declared->type());
        name(decl, declared->Identifier());
        decl.value = expression(*declared->expression());
        stmt.declaration = add(decl);
    } else {
        stmt.kind = StmtKind::Expression;
        stmt.expression[0] =
            assignment(*static_cast<KadrParser::ForAssignmentContext&>(context).assignment());
    }
    return add(stmt);
}

void TreeBuilder::switch_statement(Stmt& stmt, KadrParser::SwitchStatementContext& context) {
    stmt.kind = StmtKind::Switch;
    stmt.expression[0] = expression(*context.expression());
    std::vector<StmtId> cases;
    for (KadrParser::SwitchCaseContext* branch : context.switchCase()) {
        Stmt one;
        one.range = range_of(*branch);
        if (branch->exception == nullptr) {
            one.kind = StmtKind::Case;
            std::vector<ExprId> values;
            for (KadrParser::RangeContext* value : branch->range()) values.push_back(range(*value));
            one.expressions = list(values);
            one.statements = statements(branch->statement());
        }
        cases.push_back(add(one));
    }
    stmt.statements = list(cases);
}

/// The level behind `/`: a whole number from 0 to 9.
std::int8_t TreeBuilder::skip_level(KadrParser::SkipContext& context) {
    if (context.Number() == nullptr) return kDefaultSkipLevel;
    const Lexeme& level = lexeme(context.Number());
    const std::string_view spelled = file_.spelling(level);
    if (spelled.size() == 1 && level.unit == Unit::None) {
        return static_cast<std::int8_t>(spelled[0] - '0');
    }
    file_.sink.report(diag::SkipLevel, file_.range(level)).arg(spelled);
    return kDefaultSkipLevel;
}

void TreeBuilder::words_statement(Stmt& stmt, KadrParser::WordsStatementContext& context) {
    stmt.kind = StmtKind::Words;
    if (context.skip() != nullptr) stmt.skip_level = skip_level(*context.skip());
    std::vector<Word> words;
    for (KadrParser::WordContext* one : context.word()) words.push_back(word(*one));
    stmt.words = list(words);
    const std::vector<KadrParser::PointContext*> points = context.point();
    for (std::size_t i = 0; i < points.size(); ++i) stmt.expression[i] = point(*points[i]);
}

void TreeBuilder::with_statement(Stmt& stmt, KadrParser::WithStatementContext& context) {
    stmt.kind = StmtKind::With;
    std::vector<Word> words;
    std::vector<ExprId> frames;
    for (KadrParser::ModalContext* modal : context.modal()) {
        if (auto* modal_word = dynamic_cast<KadrParser::ModalWordContext*>(modal)) {
            words.push_back(word(*modal_word->word()));
            continue;
        }
        auto& frame = static_cast<KadrParser::ModalFrameContext&>(*modal);
        Expr call;
        call.kind = ExprKind::Call;
        call.range = range_of(frame);
        call.child[0] = name(lexeme(frame.Identifier()));
        call.list = arguments(frame.arguments());
        frames.push_back(add(call));
    }
    stmt.words = list(words);
    stmt.expressions = list(frames);
    stmt.statement[0] = block(*context.block());
}

void TreeBuilder::raw_statement(Stmt& stmt, KadrParser::RawStatementContext& context) {
    stmt.kind = StmtKind::Raw;
    if (context.expression() != nullptr) {
        stmt.expression[0] = expression(*context.expression());
        return;
    }
    const Lexeme& lines = lexeme(context.RawText());
    Expr text;
    text.kind = ExprKind::String;
    text.range = file_.range(lines);
    text.text = lines.text;
    stmt.expression[0] = add(text);
}

Word TreeBuilder::literal(const Lexeme& lexeme) {
    Word word;
    word.form = lexeme.token == Token::LiteralWord ? Word::Form::Literal : Word::Form::Bare;
    word.address = lexeme.text;
    word.number = lexeme.number;
    word.unit = lexeme.unit;
    word.range = file_.range(lexeme);
    return word;
}

Word TreeBuilder::word(KadrParser::WordContext& context) {
    const Lexeme& first = lexeme(context.start);
    if (first.token != Token::Address) return literal(first);
    auto& addressed = static_cast<KadrParser::AddressedWordContext&>(context);
    const Lexeme& sign = lexeme(addressed.children[1]);
    Word word;
    word.form = sign.token == Token::Assign ? Word::Form::Assigned : Word::Form::Increment;
    word.address = first.text;
    word.range = range_of(context);
    KadrParser::WordValueContext& value = *addressed.wordValue();
    if (token_at(value) == Token::Mode) {
        const bool is_absolute = file_.spelling(lexeme(value.start)) == "AC";
        word.mode = is_absolute ? Word::Mode::Absolute : Word::Mode::Incremental;
        word.value = expression(*static_cast<KadrParser::ModeValueContext&>(value).expression());
    } else {
        word.value = expression(*static_cast<KadrParser::PlainValueContext&>(value).expression());
    }
    if (sign.token != Token::Assign) word.mode = Word::Mode::Incremental;
    if (sign.token == Token::MinusAssign) {
        word.value = unary(Operator::Minus, word.value, ast_[word.value].range);
    }
    return word;
}

}  // namespace kadr::syntax
