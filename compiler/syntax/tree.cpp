#include "syntax/tree.h"

#include <algorithm>

#include "base/diagnostics/syntax.h"
#include "syntax/habits.h"

namespace kadr::syntax {

void TreeBuilder::build(KadrParser::FileContext& file) {
    for (KadrParser::DeclarationContext* context : file.declaration()) {
        if (token_at(*context) == Token::Semicolon) continue;
        ast_.top.push_back(declaration(*context));
    }
}

SourceRange TreeBuilder::range_of(const Rule& context) const {
    const Lexeme& first = lexeme(context.start);
    const std::uint32_t end =
        context.stop == nullptr ? first.end : std::max(first.begin, lexeme(context.stop).end);
    return file_.range(first.begin, end);
}

DeclId TreeBuilder::add(const Decl& decl) {
    const DeclId id{static_cast<std::uint32_t>(ast_.declarations.size())};
    ast_.declarations.push_back(decl);
    return id;
}

namespace {

template <typename Item>
List append(std::vector<Item>& all, std::span<const Item> items) {
    const List list{static_cast<std::uint32_t>(all.size()),
                    static_cast<std::uint32_t>(items.size())};
    all.insert(all.end(), items.begin(), items.end());
    return list;
}

}  // namespace

List TreeBuilder::list(std::span<const ExprId> ids) { return append(ast_.expression_lists, ids); }
List TreeBuilder::list(std::span<const StmtId> ids) { return append(ast_.statement_lists, ids); }
List TreeBuilder::list(std::span<const DeclId> ids) { return append(ast_.declaration_lists, ids); }
List TreeBuilder::list(std::span<const Word> words) { return append(ast_.words, words); }

void TreeBuilder::name(Decl& decl, antlr4::tree::TerminalNode* name) {
    const Lexeme& spelled = lexeme(name);
    decl.name = spelled.text;
    decl.name_range = file_.range(spelled);
}

DeclId TreeBuilder::declaration(KadrParser::DeclarationContext& context) {
    Decl decl;
    decl.range = range_of(context);
    if (context.exception != nullptr) return add(decl);
    decl.documentation = documentation(decl.range.begin);
    switch (token_at(context)) {
        case Token::Language:
        case Token::Dialect:
        case Token::Units:
        case Token::Import:
        case Token::Include:
        case Token::Test: simple_declaration(decl, context); break;
        case Token::Struct:
        case Token::Enum: members(decl, context); break;
        case Token::Curve:
            curve(decl, static_cast<KadrParser::CurveDeclarationContext&>(context));
            break;
        case Token::Contour: {
            auto& kept = static_cast<KadrParser::ContourDeclarationContext&>(context);
            const DeclId id = contour(kept, kept.Identifier(), *kept.block());
            ast_.declarations[id.index].documentation = decl.documentation;
            return id;
        }
        case Token::Const: {
            auto& constant = static_cast<KadrParser::ConstantDeclarationContext&>(context);
            const DeclId id = variable(*constant.variable(), true);
            ast_.declarations[id.index].documentation = decl.documentation;
            return id;
        }
        case Token::Auto: {
            auto& deduced = static_cast<KadrParser::AutoDeclarationContext&>(context);
            decl.kind = DeclKind::Variable;
            name(decl, deduced.Identifier());
            decl.value = expression(*deduced.expression());
            break;
        }
        default: callable(decl, context);
    }
    return add(decl);
}

void TreeBuilder::simple_declaration(Decl& decl, KadrParser::DeclarationContext& context) {
    if (auto* language = dynamic_cast<KadrParser::LanguageDeclarationContext*>(&context)) {
        decl.kind = DeclKind::Language;
        name(decl, language->Identifier());
    } else if (auto* file_units = dynamic_cast<KadrParser::UnitsDeclarationContext*>(&context)) {
        decl.kind = DeclKind::Units;
        name(decl, file_units->Identifier());
        decl.name = units(file_units->Identifier());
    } else if (auto* test = dynamic_cast<KadrParser::TestDeclarationContext*>(&context)) {
        decl.kind = DeclKind::Test;
        decl.name_range = range_of(*test->text());
        decl.name = plain_text(*test->text());
        decl.body = block(*test->block());
    } else if (token_at(context) == Token::Include) {
        const Lexeme& whole = lexeme(context.start);
        decl.kind = DeclKind::Import;
        decl.is_file = true;
        decl.name = whole.text;
        decl.name_range = file_.range(whole);
    } else {
        // Names of several parts, `fanuc-lathe` and `cycles.drilling`, are kept as written.
        const bool is_import = token_at(context) == Token::Import;
        decl.kind = is_import ? DeclKind::Import : DeclKind::Dialect;
        auto& parts = *static_cast<Rule*>(context.children[1]);
        decl.name_range = range_of(parts);
        const Token first = token_at(parts);
        if (first == Token::Text || first == Token::TextOpen) {
            decl.is_file = is_import;
            decl.name = plain_text(*static_cast<KadrParser::TextContext*>(parts.children[0]));
            return;
        }
        std::string joined;
        for (Node* part : parts.children) joined += file_.spelling(lexeme(part));
        decl.name = file_.texts.intern(joined);
    }
}

void TreeBuilder::members(Decl& decl, KadrParser::DeclarationContext& context) {
    std::vector<DeclId> ids;
    const auto member = [&](Rule& rule, antlr4::tree::TerminalNode* member_name,
                            KadrParser::TypeContext* member_type,
                            KadrParser::ExpressionContext* value) {
        Decl one;
        one.range = range_of(rule);
        if (rule.exception == nullptr) {
            one.kind = DeclKind::Variable;
            one.documentation = documentation(one.range.begin);
            if (member_type != nullptr) one.type = type(*member_type);
            name(one, member_name);
            if (value != nullptr) one.value = expression(*value);
        }
        ids.push_back(add(one));
    };
    if (auto* structure = dynamic_cast<KadrParser::StructDeclarationContext*>(&context)) {
        decl.kind = DeclKind::Struct;
        name(decl, structure->Identifier());
        for (KadrParser::FieldContext* field : structure->field()) {
            if (field->exception != nullptr) continue;
            member(*field, field->Identifier(), field->type(), field->expression());
        }
    } else {
        auto& enumeration = static_cast<KadrParser::EnumDeclarationContext&>(context);
        decl.kind = DeclKind::Enum;
        name(decl, enumeration.Identifier());
        for (KadrParser::EnumeratorContext* one : enumeration.enumerator()) {
            member(*one, one->Identifier(), nullptr, one->expression());
        }
    }
    decl.members = list(ids);
}

/// Everything with parameters or a type in front.
void TreeBuilder::callable(Decl& decl, KadrParser::DeclarationContext& context) {
    if (auto* cycle = dynamic_cast<KadrParser::CycleDeclarationContext*>(&context)) {
        decl.kind = DeclKind::Cycle;
        name(decl, cycle->Identifier());
        decl.parameters = parameters(*cycle->parameters());
        decl.preserves = preserved(cycle->preserves());
        decl.body = block(*cycle->block());
    } else if (auto* program = dynamic_cast<KadrParser::ProgramDeclarationContext*>(&context)) {
        decl.kind = DeclKind::Program;
        name(decl, program->Identifier());
        decl.parameters = parameters(*program->parameters());
        decl.preserves = preserved(program->preserves());
        decl.body = block(*program->block());
    } else if (auto* property = dynamic_cast<KadrParser::PropertyDeclarationContext*>(&context)) {
        decl.kind = DeclKind::Property;
        decl.name_range = range_of(*property->text());
        decl.name = plain_text(*property->text());
        decl.parameters = parameters(*property->parameters());
        decl.body = block(*property->block());
    } else {
        auto& typed = static_cast<KadrParser::TypedDeclarationContext&>(context);
        decl.type = type(*typed.type());
        name(decl, typed.Identifier());
        KadrParser::DefinitionContext& definition = *typed.definition();
        if (auto* function = dynamic_cast<KadrParser::FunctionDefinitionContext*>(&definition)) {
            decl.kind = DeclKind::Function;
            decl.parameters = parameters(*function->parameters());
            decl.body = block(*function->block());
        } else {
            decl.kind = DeclKind::Variable;
            auto* value =
                static_cast<KadrParser::VariableDefinitionContext&>(definition).expression();
            if (value != nullptr) decl.value = expression(*value);
        }
    }
}

void TreeBuilder::curve(Decl& decl, KadrParser::CurveDeclarationContext& context) {
    decl.kind = DeclKind::Curve;
    name(decl, context.Identifier(0));
    decl.parameters = parameters(*context.parameters());
    Decl running;
    running.kind = DeclKind::Variable;
    running.type = type(*context.type());
    name(running, context.Identifier(1));
    running.range = running.name_range;
    const DeclId running_id = add(running);
    decl.members = list(std::span<const DeclId>(&running_id, 1));
    KadrParser::RangeContext& limits = *context.range();
    decl.value = expression(*limits.expression(0));
    if (limits.expression(1) != nullptr) {
        decl.value_to = expression(*limits.expression(1));
    } else {
        file_.sink.report(diag::CurveRange, range_of(limits));
        decl.value_to = decl.value;
    }
    decl.body = block(*context.block());
}

DeclId TreeBuilder::variable(KadrParser::VariableContext& context, bool is_const) {
    Decl decl;
    decl.kind = DeclKind::Variable;
    decl.is_const = is_const;
    decl.range = range_of(context);
    if (auto* deduced = dynamic_cast<KadrParser::AutoVariableContext*>(&context)) {
        name(decl, deduced->Identifier());
        decl.value = expression(*deduced->expression());
    } else {
        auto& typed = static_cast<KadrParser::TypedVariableContext&>(context);
        decl.type = type(*typed.type());
        name(decl, typed.Identifier());
        if (typed.expression() != nullptr) decl.value = expression(*typed.expression());
    }
    return add(decl);
}

DeclId TreeBuilder::contour(Rule& context, antlr4::tree::TerminalNode* contour_name,
                            KadrParser::BlockContext& body) {
    Decl decl;
    decl.kind = DeclKind::Contour;
    decl.range = range_of(context);
    name(decl, contour_name);
    decl.body = block(body);
    return add(decl);
}

List TreeBuilder::parameters(KadrParser::ParametersContext& context) {
    std::vector<DeclId> ids;
    for (KadrParser::ParameterContext* parameter : context.parameter()) {
        if (parameter->exception != nullptr) continue;
        Decl decl;
        decl.kind = DeclKind::Parameter;
        decl.range = range_of(*parameter);
        decl.documentation = documentation(decl.range.begin);
        decl.type = type(*parameter->type());
        name(decl, parameter->Identifier());
        if (parameter->expression() != nullptr) decl.value = expression(*parameter->expression());
        if (parameter->range() != nullptr) decl.value = range(*parameter->range());
        ids.push_back(add(decl));
    }
    return list(ids);
}

List TreeBuilder::preserved(KadrParser::PreservesContext* context) {
    if (context == nullptr) return {};
    std::vector<Word> words;
    for (KadrParser::PreservedContext* one : context->preserved()) {
        words.push_back(literal(lexeme(one->start)));
        if (token_at(*one) == Token::Frames) words.back().address = file_.texts.intern("FRAMES");
    }
    return list(words);
}

TypeId TreeBuilder::type(KadrParser::TypeContext& context) {
    TypeRef type;
    type.range = range_of(context);
    type.name = lexeme(context.start).text;
    if (context.OpenBracket() != nullptr) {
        type.array = TypeRef::Array::Growing;
        if (context.expression() != nullptr) {
            type.array = TypeRef::Array::Fixed;
            type.size = expression(*context.expression());
        }
    }
    type.is_optional = context.Question() != nullptr;
    type.is_reference = context.And() != nullptr;
    const TypeId id{static_cast<std::uint32_t>(ast_.types.size())};
    ast_.types.push_back(type);
    return id;
}

TextId TreeBuilder::plain_text(KadrParser::TextContext& context) {
    const Lexeme& first = lexeme(context.start);
    if (first.token == Token::TextOpen) file_.sink.report(diag::TextNotPlain, range_of(context));
    return first.text;
}

TextId TreeBuilder::units(antlr4::tree::TerminalNode* unit) {
    const Lexeme& spelled = lexeme(unit);
    const std::string_view text = file_.spelling(spelled);
    if (text == "mm" || text == "inch") return spelled.text;
    if (text == "in") return file_.texts.intern("inch");
    auto message = file_.sink.report(diag::UnitsName, file_.range(spelled));
    message.arg(text);
    const std::string lower = lower_ascii(text);
    if (lower.starts_with("in") || lower.starts_with("imp"))
        message.fix(file_.range(spelled), "inch", "the word is `inch`");
    else if (lower.starts_with("m"))  // `MM`, `metric`, `millimeters`
        message.fix(file_.range(spelled), "mm", "the word is `mm`");
    return file_.texts.intern("mm");
}

/// The text of the `///` lines right before the index.
TextId TreeBuilder::documentation(std::uint32_t begin) {
    const auto& comments = ast_.comments;
    auto last = std::upper_bound(
        comments.begin(), comments.end(), begin,
        [](std::uint32_t index, const Comment& comment) { return index < comment.range.end; });
    const auto is_blank = [&](std::uint32_t from, std::uint32_t to) {
        return file_.text.substr(from, to - from).find_first_not_of(" \t\r\n") ==
               std::string_view::npos;
    };
    auto first = last;
    std::uint32_t next = begin;
    while (first != comments.begin()) {
        const Comment& comment = *(first - 1);
        if (!comment.is_documentation || !is_blank(comment.range.end, next)) break;
        next = comment.range.begin;
        --first;
    }
    std::string text;
    for (; first != last; ++first) {
        std::string_view line =
            file_.text.substr(first->range.begin + 3, first->range.end - first->range.begin - 3);
        if (line.starts_with(' ')) line.remove_prefix(1);
        line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
        if (!text.empty()) text += '\n';
        text += line;
    }
    return file_.texts.intern(text);
}

}  // namespace kadr::syntax
