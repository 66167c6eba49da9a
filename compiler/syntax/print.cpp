#include "syntax/print.h"

#include "base/numbers.h"
#include "syntax/operators.h"

namespace kadr::syntax {

namespace {

/// A text between quotes; line ends stay readable.
std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '\n') {
            out += "\\n";
        } else {
            if (c == '"' || c == '\\') out += '\\';
            out += c;
        }
    }
    return out + "\"";
}

class Printer {
  public:
    explicit Printer(const Ast& ast) : ast_(ast) {}

    void declaration(DeclId id, int depth);
    void expression(ExprId id);
    void chain(ExprId id);
    std::string take() { return std::move(out_); }

  private:
    void statement(StmtId id, int depth);
    void body(StmtId id, int depth);
    void child(StmtId id, int depth);
    void open(int depth, std::string_view head);
    void declared(const Decl& decl);
    void type(TypeId id);
    void word(const Word& word);
    void arguments(List list);
    void spaced(ExprId id) {
        out_ += ' ';
        expression(id);
    }
    std::string_view text(TextId id) const { return ast_.text(id); }

    const Ast& ast_;
    std::string out_;
};

void Printer::open(int depth, std::string_view head) {
    if (!out_.empty()) out_ += '\n';
    out_.append(static_cast<std::size_t>(depth) * 2, ' ');
    out_ += '(';
    out_ += head;
}

void Printer::type(TypeId id) {
    const TypeRef& type = ast_[id];
    out_ += text(type.name);
    if (type.array != TypeRef::Array::None) {
        out_ += '[';
        if (type.size.is_valid()) expression(type.size);
        out_ += ']';
    }
    if (type.is_optional) out_ += '?';
    if (type.is_reference) out_ += '&';
}

/// Type, name and value of a variable or parameter.
void Printer::declared(const Decl& decl) {
    if (decl.is_const) out_ += " const";
    out_ += ' ';
    if (decl.type.is_valid()) {
        type(decl.type);
    } else {
        out_ += "auto";
    }
    out_ += ' ';
    out_ += text(decl.name);
    if (decl.value.is_valid()) spaced(decl.value);
}

std::string_view kind_text(DeclKind kind) {
    switch (kind) {
        case DeclKind::Invalid: return "invalid";
        case DeclKind::Variable: return "var";
        case DeclKind::Parameter: return "param";
        case DeclKind::Function: return "function";
        case DeclKind::Cycle: return "cycle";
        case DeclKind::Program: return "program";
        case DeclKind::Struct: return "struct";
        case DeclKind::Enum: return "enum";
        case DeclKind::Import: return "import";
        case DeclKind::Contour: return "contour";
        case DeclKind::Curve: return "curve";
        case DeclKind::Test: return "test";
        case DeclKind::Property: return "property";
        case DeclKind::Units: return "units";
        case DeclKind::Dialect: return "dialect";
        case DeclKind::Language: return "language";
    }
    return "";
}

void Printer::declaration(DeclId id, int depth) {
    const Decl& decl = ast_[id];
    open(depth, kind_text(decl.kind));
    switch (decl.kind) {
        case DeclKind::Invalid: break;
        case DeclKind::Variable:
        case DeclKind::Parameter: declared(decl); break;
        case DeclKind::Enum:
            out_ += ' ';
            out_ += text(decl.name);
            for (const DeclId member : ast_.decls(decl.members)) {
                const Decl& one = ast_[member];
                out_ += ' ';
                if (one.value.is_valid()) out_ += "(= ";
                out_ += text(one.name);
                if (one.value.is_valid()) {
                    spaced(one.value);
                    out_ += ')';
                }
            }
            break;
        case DeclKind::Test:
        case DeclKind::Property: out_ += " " + quoted(text(decl.name)); break;
        case DeclKind::Import:
            out_ += " " + (decl.is_file ? quoted(text(decl.name)) : std::string(text(decl.name)));
            break;
        case DeclKind::Function:
            out_ += ' ';
            type(decl.type);
            [[fallthrough]];
        case DeclKind::Cycle:
        case DeclKind::Program:
        case DeclKind::Struct:
        case DeclKind::Contour:
        case DeclKind::Curve:
        case DeclKind::Units:
        case DeclKind::Dialect:
        case DeclKind::Language:
            out_ += ' ';
            out_ += text(decl.name);
            break;
    }
    if (!decl.documentation.is_empty()) out_ += " (doc " + quoted(text(decl.documentation)) + ")";
    if (decl.preserves.count > 0) {
        out_ += " (preserves";
        for (const Word& one : ast_.word_run(decl.preserves)) {
            out_ += ' ';
            word(one);
        }
        out_ += ')';
    }
    for (const DeclId parameter : ast_.decls(decl.parameters)) declaration(parameter, depth + 1);
    if (decl.kind == DeclKind::Struct || decl.kind == DeclKind::Curve) {
        for (const DeclId member : ast_.decls(decl.members)) declaration(member, depth + 1);
    }
    if (decl.kind == DeclKind::Curve) {
        out_ += " (..";
        spaced(decl.value);
        spaced(decl.value_to);
        out_ += ')';
    }
    if (decl.body.is_valid()) body(decl.body, depth + 1);
    out_ += ')';
}

/// The statements of a block, without the block around them.
void Printer::body(StmtId id, int depth) {
    const Stmt& stmt = ast_[id];
    if (stmt.kind != StmtKind::Block) return statement(id, depth);
    for (const StmtId one : ast_.stmts(stmt.statements)) statement(one, depth);
}

/// A statement inside another one; nothing where it was left out.
void Printer::child(StmtId id, int depth) {
    if (id.is_valid()) statement(id, depth);
}

std::string_view kind_text(StmtKind kind) {
    switch (kind) {
        case StmtKind::Invalid: return "invalid";
        case StmtKind::Empty: return "empty";
        case StmtKind::Block: return "block";
        case StmtKind::Expression: return "do";
        case StmtKind::Declaration: return "var";
        case StmtKind::If: return "if";
        case StmtKind::While: return "while";
        case StmtKind::DoWhile: return "do-while";
        case StmtKind::For: return "for";
        case StmtKind::ForEach: return "for-each";
        case StmtKind::Switch: return "switch";
        case StmtKind::Case: return "case";
        case StmtKind::Break: return "break";
        case StmtKind::Continue: return "continue";
        case StmtKind::Return: return "return";
        case StmtKind::Words: return "words";
        case StmtKind::With: return "with";
        case StmtKind::Note: return "note";
        case StmtKind::Raw: return "raw";
        case StmtKind::Units: return "units";
        case StmtKind::Require: return "require";
        case StmtKind::Assert: return "assert";
        case StmtKind::ErrorStmt: return "error";
        case StmtKind::WarnStmt: return "warn";
        case StmtKind::Close: return "close";
        case StmtKind::Assume: return "assume";
        case StmtKind::Expect: return "expect";
    }
    return "";
}

void Printer::statement(StmtId id, int depth) {
    const Stmt& stmt = ast_[id];
    if (stmt.kind == StmtKind::Declaration) return declaration(stmt.declaration, depth);
    open(depth, kind_text(stmt.kind));
    if (stmt.kind == StmtKind::Case && stmt.expressions.count == 0) out_ += " default";
    if (stmt.kind == StmtKind::ForEach) declared(ast_[stmt.declaration]);
    if (!stmt.text.is_empty()) {
        out_ += ' ';
        out_ += text(stmt.text);
    }
    if (stmt.skip_level == kDefaultSkipLevel) out_ += " skip";
    else if (stmt.skip_level >= 0) out_ += " skip" + std::to_string(stmt.skip_level);
    for (const Word& one : ast_.word_run(stmt.words)) {
        out_ += ' ';
        word(one);
    }
    for (const ExprId one : ast_.exprs(stmt.expressions)) spaced(one);
    if (stmt.kind == StmtKind::For) {
        // Parts that were left out are shown as `_`.
        child(stmt.statement[0], depth + 1);
        for (const ExprId one : stmt.expression) {
            if (one.is_valid()) {
                spaced(one);
            } else {
                out_ += " _";
            }
        }
        child(stmt.statement[1], depth + 1);
    } else {
        for (const ExprId one : stmt.expression) {
            if (one.is_valid()) spaced(one);
        }
        for (const StmtId one : stmt.statement) child(one, depth + 1);
    }
    for (const StmtId one : ast_.stmts(stmt.statements)) statement(one, depth + 1);
    out_ += ')';
}

void Printer::word(const Word& word) {
    const std::string_view address = text(word.address);
    switch (word.form) {
        case Word::Form::Bare: out_ += address; return;
        case Word::Form::Literal:
            out_ += address;
            append_shortest(out_, word.number);
            out_ += unit_text(word.unit);
            return;
        case Word::Form::Assigned:
        case Word::Form::Increment:
            out_ += '(';
            out_ += address;
            out_ += word.form == Word::Form::Increment ? "+=" : "=";
            if (word.mode == Word::Mode::Absolute) out_ += "AC";
            if (word.form == Word::Form::Assigned && word.mode == Word::Mode::Incremental) {
                out_ += "IC";
            }
            spaced(word.value);
            out_ += ')';
            return;
    }
}

void Printer::arguments(List list) {
    for (const ExprId one : ast_.exprs(list)) spaced(one);
    out_ += ')';
}

/// `(+ (+ a b) c)`: the operators from the last one on, then what stands between them.
void Printer::chain(ExprId id) {
    std::vector<ExprId> links;
    const auto open = [&](ExprId link) {
        links.push_back(link);
        out_ += '(';
        out_ += operator_text(ast_[link].op);
    };
    open(id);
    while (ast_[links.back()].is_chain_link() &&
           ast_[ast_[links.back()].child[0]].is_chain_link()) {
        out_ += ' ';
        open(ast_[links.back()].child[0]);
    }
    spaced(ast_[links.back()].child[0]);
    for (; !links.empty(); links.pop_back()) {
        spaced(ast_[links.back()].child[1]);
        out_ += ')';
    }
}

void Printer::expression(ExprId id) {
    const Expr& expr = ast_[id];
    const auto group = [&](std::string_view head, std::size_t children) {
        out_ += '(';
        out_ += head;
        for (std::size_t i = 0; i < children; ++i) spaced(expr.child[i]);
        out_ += ')';
    };
    switch (expr.kind) {
        case ExprKind::Invalid: out_ += "invalid"; return;
        case ExprKind::Bool: out_ += expr.integer != 0 ? "true" : "false"; return;
        case ExprKind::Int:
            out_ += std::to_string(expr.integer);
            out_ += unit_text(expr.unit);
            return;
        case ExprKind::Real:
            append_shortest(out_, expr.number);
            if (expr.unit == Unit::None &&
                out_.find_first_of(".e", out_.find_last_of(" (") + 1) == std::string::npos) {
                out_ += ".0";
            }
            out_ += unit_text(expr.unit);
            return;
        case ExprKind::String:
            if (expr.list.count == 0) {
                out_ += quoted(text(expr.text));
            } else {
                out_ += "(text";
                arguments(expr.list);
            }
            return;
        case ExprKind::Format:
            if (expr.text.is_empty()) return expression(expr.child[0]);
            out_ += "(format ";
            expression(expr.child[0]);
            out_ += ' ';
            out_ += text(expr.text);
            out_ += ')';
            return;
        case ExprKind::Name: out_ += text(expr.text); return;
        case ExprKind::Binary: return chain(id);
        case ExprKind::Unary:
        case ExprKind::Assign:
            return group(operator_text(expr.op), expr.kind == ExprKind::Unary ? 1 : 2);
        case ExprKind::Conditional: return group("?", 3);
        case ExprKind::Index: return group("index", 2);
        case ExprKind::Given: return group("given", 1);
        case ExprKind::Range: return group("..", 2);
        case ExprKind::Call:
            out_ += "(call ";
            expression(expr.child[0]);
            return arguments(expr.list);
        case ExprKind::TypedCall:
            out_ += "(call ";
            out_ += text(expr.text);
            out_ += '<';
            type(expr.type);
            out_ += '>';
            return arguments(expr.list);
        case ExprKind::Argument:
            if (!expr.text.is_empty()) {
                out_ += text(expr.text);
                out_ += ": ";
            }
            if (expr.child[0].is_valid()) expression(expr.child[0]);
            return;
        case ExprKind::Member:
            out_ += "(. ";
            expression(expr.child[0]);
            out_ += ' ';
            out_ += text(expr.text);
            out_ += ')';
            return;
        case ExprKind::Braces: out_ += "(braces"; return arguments(expr.list);
    }
}

}  // namespace

std::string dump(const Ast& ast) {
    Printer printer(ast);
    for (const DeclId id : ast.top) printer.declaration(id, 0);
    return printer.take();
}

std::string dump(const Ast& ast, ExprId id) {
    Printer printer(ast);
    printer.expression(id);
    return printer.take();
}

std::string_view unit_text(Unit unit) {
    switch (unit) {
        case Unit::None: return "";
        case Unit::Mm: return "mm";
        case Unit::Cm: return "cm";
        case Unit::M: return "m";
        case Unit::Um: return "um";
        case Unit::Inch: return "in";
        case Unit::Deg: return "deg";
        case Unit::Rad: return "rad";
        case Unit::S: return "s";
        case Unit::Ms: return "ms";
        case Unit::Min: return "min";
        case Unit::MmPerMin: return "mm/min";
        case Unit::MPerMin: return "m/min";
        case Unit::InchPerMin: return "in/min";
        case Unit::MmPerS: return "mm/s";
        case Unit::MmPerRev: return "mm/rev";
        case Unit::InchPerRev: return "in/rev";
        case Unit::Rpm: return "rpm";
        case Unit::Percent: return "%";
    }
    return "";
}

std::string_view operator_text(Operator op) {
    if (const BinaryOperator* row = find_binary_operator(op)) return row->text;
    switch (op) {
        case Operator::Plus: return "+";
        case Operator::Minus: return "-";
        case Operator::Not: return "!";
        case Operator::BitNot: return "~";
        case Operator::PreIncrement: return "pre++";
        case Operator::PreDecrement: return "pre--";
        case Operator::PostIncrement: return "post++";
        case Operator::PostDecrement: return "post--";
        case Operator::Assign: return "=";
        case Operator::AddAssign: return "+=";
        case Operator::SubtractAssign: return "-=";
        case Operator::MultiplyAssign: return "*=";
        case Operator::DivideAssign: return "/=";
        case Operator::ModuloAssign: return "%=";
        case Operator::ShiftLeftAssign: return "<<=";
        case Operator::ShiftRightAssign: return ">>=";
        case Operator::BitAndAssign: return "&=";
        case Operator::BitXorAssign: return "^=";
        case Operator::BitOrAssign: return "|=";
        default: return "";
    }
}

}  // namespace kadr::syntax
