// complain_recovery.cpp — where the parser goes on behind a mistake.
#include <algorithm>

#include "base/assert.h"
#include "syntax/parse.h"
#include "syntax/parser_position.h"
#include "syntax/token_kinds.h"

namespace kadr::syntax {

void Complaints::reportError(antlr4::Parser* parser, const antlr4::RecognitionException& e) {
    std::size_t index = stream_.index();
    if (e.getOffendingToken() != nullptr) {
        index = std::max(index, e.getOffendingToken()->getTokenIndex());
    }
    complain(*parser, index);
}

/// A single token is missing. `;` is put in, an address in place of a name is taken for it;
/// everything else ends the statement.
antlr4::Token* Complaints::recoverInline(antlr4::Parser* parser) {
    const std::size_t index = stream_.index();
    const ParserPosition at = location_of(*parser, index);
    const bool is_name = at.expects_only(Token::Identifier) && is_word(at.offending.token);
    const bool is_semicolon = at.expects_only(Token::Semicolon) && is_semicolon_forgotten(at);
    if (!is_name && !is_semicolon) throw antlr4::InputMismatchException(parser);
    complain(*parser, index);
    Lexeme lexeme = at.offending;
    if (is_name) {
        lexeme.token = Token::Identifier;
        lexeme.text = file_.texts.intern(file_.spelling(lexeme));
        stream_.consume();
    } else {
        lexeme.token = Token::Semicolon;
        lexeme.begin = lexeme.end = at.previous.end;
    }
    // The parser hangs tokens without an index into the tree itself.
    conjured_.emplace_back(lexeme, INVALID_INDEX);
    return &conjured_.back();
}

void Complaints::recover(antlr4::Parser* parser, std::exception_ptr e) {
    antlr4::ParserRuleContext& context = *parser->getContext();
    switch (context.getRuleIndex()) {
        case KadrParser::RuleParameters: return skip_parameters(context);
        case KadrParser::RuleStatement:
        case KadrParser::RuleDeclaration: return skip_statement(*parser, context);
        case KadrParser::RuleSwitchCase: return skip_statement(*parser, context);
        case KadrParser::RuleFile: return;
        default: std::rethrow_exception(e);
    }
}

/// The brackets that are open between the start of a rule and the position of the parser.
std::vector<Token> Complaints::open_brackets(const antlr4::ParserRuleContext& context) const {
    std::vector<Token> open;
    for (std::size_t i = context.start->getTokenIndex(); i < stream_.place(); ++i) {
        const Token token = stream_.lexeme(i).token;
        if (opens(token)) open.push_back(token);
        if (closes(token) && !open.empty()) open.pop_back();
    }
    return open;
}

/// Goes on behind the `)` of the parameters, so that the body is read.
void Complaints::skip_parameters(const antlr4::ParserRuleContext& context) {
    std::size_t depth = open_brackets(context).size();
    while (depth > 0 && stream_.LA(1) != antlr4::Token::EOF) {
        const Token token = token_of(stream_.LA(1));
        if (opens(token)) ++depth;
        if (closes(token)) --depth;
        stream_.consume();
    }
}

/// A state of the parser from which its rules call `block`. Full-context prediction follows the
/// chain of calling states; a block that recovery reads must seem to be called from such a one.
static std::size_t state_that_calls_block(const antlr4::Parser& parser) {
    for (const antlr4::atn::ATNState* state : parser.getATN().states) {
        if (state == nullptr || state->transitions.empty()) continue;
        const antlr4::atn::Transition* transition = state->transitions[0];
        if (transition->getSerializationType() == antlr4::atn::Transition::RULE &&
            transition->target->ruleIndex == KadrParser::RuleBlock) {
            return state->stateNumber;
        }
    }
    KADR_ASSERT(false, "the grammar has no rule that calls block");
}

/// Reads the block that comes next, whose mistakes are reported, wherever the parser stands.
static void read_block(antlr4::Parser& parser) {
    const std::size_t state = parser.getState();
    parser.setState(state_that_calls_block(parser));
    static_cast<KadrParser&>(parser).block();
    parser.setState(state);
}

/// Goes on behind the `;` of the statement, or behind its body, which is read meanwhile. Stops
/// before a `}` of the block around and before a line that is not indented deeper.
void Complaints::skip_statement(antlr4::Parser& parser, const antlr4::ParserRuleContext& context) {
    const Lexeme& start = static_cast<LexemeToken*>(context.start)->lexeme();
    const std::uint32_t indent = file_.lines.line_indent(start.begin);
    const std::size_t begin = context.start->getTokenIndex();
    std::vector<Token> open = open_brackets(context);
    // `for i = 0; i < 5; i++` without parentheses: its `;` end nothing.
    int separators =
        start.token == Token::For && stream_.lexeme(begin + 1).token != Token::OpenParen ? 2 : 0;
    while (stream_.LA(1) != antlr4::Token::EOF) {
        const Lexeme& lexeme = stream_.lexeme(stream_.index());
        const Token token = lexeme.token;
        if (open.empty()) {
            if (token == Token::OpenBrace) {
                read_block(parser);
                if (start.token != Token::If || token_of(stream_.LA(1)) != Token::Else) return;
                continue;
            }
            if (token == Token::Else && start.token == Token::If) {
                stream_.consume();
                if (token_of(stream_.LA(1)) == Token::If) stream_.consume();
                continue;
            }
            if (token == Token::CloseBrace) break;
            const bool has_moved = stream_.index() > begin;
            const Lexeme& previous = stream_.lexeme(stream_.index() - (has_moved ? 1 : 0));
            if (has_moved && token != Token::Semicolon &&
                file_.crosses_line(previous.end, lexeme.begin) &&
                file_.lines.indent(lexeme.begin) <= indent) {
                return;
            }
        }
        if (opens(token)) open.push_back(token);
        if (closes(token) && !open.empty()) open.pop_back();
        stream_.consume();
        if (token == Token::Semicolon && open.empty() && separators-- == 0) return;
    }
    // A statement that is nothing but a mistake must not be tried again.
    if (stream_.index() == begin && token_of(stream_.LA(1)) != Token::CloseBrace) stream_.consume();
}

/// Before each statement of a block and each declaration of a file: steps over what cannot begin
/// one.
void Complaints::sync(antlr4::Parser* parser) {
    antlr4::ParserRuleContext& context = *parser->getContext();
    const std::size_t rule = context.getRuleIndex();
    if (rule != KadrParser::RuleBlock && rule != KadrParser::RuleFile &&
        rule != KadrParser::RuleSwitchCase) {
        return;
    }
    const bool is_file = rule == KadrParser::RuleFile;
    const auto& atn = parser->getATN();
    const antlr4::misc::IntervalSet& starts = atn.nextTokens(atn.states[parser->getState()]);
    if (!starts.contains(static_cast<std::size_t>(is_file ? Token::Cycle : Token::If))) return;
    const auto fits = [&] {
        const Token token = token_of(stream_.LA(1));
        return starts.contains(stream_.LA(1)) || token == Token::EndOfFile ||
               (rule == KadrParser::RuleSwitchCase &&
                (token == Token::Case || token == Token::Default || token == Token::CloseBrace));
    };
    while (!fits()) {
        explain_start(*parser);
        skip_start(*parser, is_file);
    }
}

void Complaints::skip_start(antlr4::Parser& parser, bool is_file) {
    const Token first = token_of(stream_.LA(1));
    stream_.consume();
    if ((first == Token::Else || first == Token::Include) && !is_file) return;
    int depth = opens(first) ? 1 : 0;
    Token last = first;
    while (stream_.LA(1) != antlr4::Token::EOF) {
        const std::size_t index = stream_.index();
        const Token token = token_of(stream_.LA(1));
        const bool has_members = first == Token::Struct || first == Token::Enum;
        if (depth == 0 && token == Token::OpenBrace && !has_members) {
            read_block(parser);
            last = Token::CloseBrace;
            if (!is_file) return;
            continue;
        }
        if (depth == 0 && token == Token::CloseBrace && !is_file) return;
        if (depth == 0 && is_file) {
            const bool is_fresh =
                last == Token::Semicolon || last == Token::CloseBrace ||
                file_.crosses_line(stream_.lexeme(index - 1).end, stream_.lexeme(index).begin);
            const bool is_declaration = begins_declaration(token) || token == Token::TypeName ||
                                        token == Token::Const || token == Token::Contour;
            if (is_fresh && is_declaration) return;
        }
        if (opens(token)) ++depth;
        if (closes(token)) --depth;
        stream_.consume();
        last = token;
        if (has_members && depth == 0 && token == Token::CloseBrace && !is_file) return;
        const bool is_end =
            token == Token::Semicolon ||
            (token == Token::Colon && (first == Token::Case || first == Token::Default));
        if (depth == 0 && is_end && !is_file) return;
    }
}

}  // namespace kadr::syntax
