#include "driver/parameters.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "base/diagnostics/driver.h"
#include "base/diagnostics/expand.h"
#include "base/json_writer.h"
#include "base/unicode.h"
#include "driver/execution.h"
#include "driver/file_text.h"
#include "driver/output.h"
#include "driver/program.h"

namespace kadr::driver {

namespace {

using sema::FunctionCode;
using sema::ParameterInfo;
using syntax::Contract;
using syntax::ParameterContract;

/// A program of the file, as the tree tells it and as it was checked.
struct ListedProgram {
    const FunctionCode* code = nullptr;
    Contract contract;
};

bool can_be_set(const ParameterInfo& info) {
    return info.kind != ParameterInfo::Kind::Contour && info.kind != ParameterInfo::Kind::Other;
}

/// What a value must be one of; empty: it is no choice.
std::vector<std::string> choices(const sema::Code& code, const ParameterInfo& info) {
    if (info.kind == ParameterInfo::Kind::Bool) return {code.true_word, code.false_word};
    std::vector<std::string> names;
    if (info.kind != ParameterInfo::Kind::Enum) return names;
    for (const auto& [name, value] : code.enums[info.enumeration].members) names.push_back(name);
    return names;
}

const syntax::Ast* tree_of(const KadrProgram& program) {
    for (const syntax::Ast* ast : program.modules->trees()) {
        if (ast->file == program.file) return ast;
    }
    return nullptr;
}

/// In the order of the file.
std::vector<ListedProgram> programs_of(const KadrProgram& program, const syntax::Ast& ast,
                                       std::string_view text) {
    std::vector<ListedProgram> out;
    for (const syntax::DeclId id : ast.top) {
        if (ast[id].kind != syntax::DeclKind::Program) continue;
        const auto found =
            std::ranges::find_if(program.code->functions, [&](const FunctionCode& function) {
                return function.kind == sema::FunctionKind::Program && function.is_main_file &&
                       function.range == ast[id].name_range;
            });
        if (found == program.code->functions.end()) continue;
        out.push_back({&*found, syntax::contract_of(ast, id, text)});
    }
    return out;
}

/// Leaves the one that is asked for. Reports what there is instead.
Done choose(std::vector<ListedProgram>& programs, const std::string& wanted, FileId file,
            Messages& messages) {
    if (programs.empty()) {
        messages.report(diag::NoProgram, SourceRange{file, 0, 0});
        return kFailed;
    }
    if (wanted.empty()) return kDone;
    std::string all;
    for (const ListedProgram& program : programs)
        all += (all.empty() ? "" : ", ") + program.contract.name;
    std::erase_if(programs, [&](const ListedProgram& p) { return p.contract.name != wanted; });
    if (!programs.empty()) return kDone;
    messages.report(diag::UnknownProgram)
        .arg(wanted)
        .note("it is asked for by the option `--program`")
        .note("the file has: " + all);
    return kFailed;
}

std::string joined(const std::vector<std::string>& texts, std::string_view between) {
    std::string out;
    for (const std::string& text : texts) out += (out.empty() ? "" : std::string(between)) + text;
    return out;
}

std::string indented(std::string_view text) {
    std::string out;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end > begin) out += "  " + std::string(text.substr(begin, end - begin));
        out += '\n';
        begin = end + 1;
    }
    return out;
}

std::string as_text(const ListedProgram& program, const sema::Code& code, const syntax::Ast& ast) {
    const Contract& contract = program.contract;
    std::string out = contract.heading + '\n';
    out += indented(contract.about);
    if (contract.parameters.empty()) return out + "  no parameters\n";
    std::vector<ParameterRow> rows;
    for (std::size_t i = 0; i < contract.parameters.size(); ++i) {
        const ParameterInfo& info = program.code->parameters[i];
        ParameterRow row = parameter_row(ast, contract.parameters[i]);
        if (row.range.empty()) row.range = joined(choices(code, info), ", ");
        if (!can_be_set(info)) row.range = "not with -D";
        rows.push_back(std::move(row));
    }
    out += parameter_table(rows);
    for (const std::string& condition : contract.conditions) out += "  and " + condition + '\n';
    return out;
}

void put_parameter(JsonWriter& json, const sema::Code& code, const syntax::Ast& ast,
                   const ParameterInfo& info, const ParameterContract& parameter) {
    json.object([&] {
        json.key("name").value(parameter.name);
        json.key("type").value(parameter.type);
        json.key("unit").value(parameter_row(ast, parameter).unit);
        json.key("required").value(parameter.initial.empty() && !parameter.is_optional);
        if (parameter.initial.empty()) json.key("default").null();
        else json.key("default").value(parameter.initial);
        json.key("can_be_set").value(can_be_set(info));
        json.key("values").array([&] {
            for (const std::string& choice : choices(code, info)) json.value(choice);
        });
        json.key("bounds").array([&] {
            for (const syntax::Bound& bound : parameter.bounds) {
                json.object([&] {
                    json.key("is").value(syntax::spelling(bound.op));
                    json.key("value").value(bound.value);
                });
            }
        });
        json.key("documentation").value(parameter.meaning);
    });
}

std::string as_json(std::span<const ListedProgram> programs, const sema::Code& code,
                    const syntax::Ast& ast) {
    std::string out;
    JsonWriter json(out);
    json.object([&] {
        json.key("programs").array([&] {
            for (const ListedProgram& program : programs) {
                const Contract& contract = program.contract;
                json.object([&] {
                    json.key("name").value(contract.name);
                    json.key("documentation").value(contract.about);
                    json.key("parameters").array([&] {
                        for (std::size_t i = 0; i < contract.parameters.size(); ++i)
                            put_parameter(json, code, ast, program.code->parameters[i],
                                          contract.parameters[i]);
                    });
                    json.key("conditions").array([&] {
                        for (const std::string& condition : contract.conditions)
                            json.value(condition);
                    });
                });
            }
        });
    });
    json.end_line();
    return out;
}

Status refused(Session& session) {
    session.mark_usage();
    return session.status();
}

}  // namespace

ParameterRow parameter_row(const syntax::Ast& ast, const ParameterContract& parameter) {
    ParameterRow row;
    row.name = parameter.name;
    row.type = parameter.type;
    if (parameter.type_id.is_valid()) {
        const syntax::TypeRef& type = ast[parameter.type_id];
        row.unit = syntax::bare_unit(ast.text(type.name), syntax::is_inch(ast));
    }
    row.initial = parameter.initial;
    if (row.initial.empty()) row.initial = parameter.is_optional ? "none" : "needed";
    row.range = syntax::bounds_text(parameter);
    row.meaning = parameter.meaning;
    return row;
}

std::string parameter_table(std::span<const ParameterRow> rows) {
    struct Column {
        std::string_view head;
        std::string ParameterRow::*text;
    };
    static constexpr std::array<Column, 6> kColumns = {{
        {"parameter", &ParameterRow::name},
        {"type", &ParameterRow::type},
        {"unit", &ParameterRow::unit},
        {"default", &ParameterRow::initial},
        {"range", &ParameterRow::range},
        {"meaning", &ParameterRow::meaning},
    }};
    std::vector<std::string> lines(rows.size() + 1, " ");
    for (const auto& [head, text] : kColumns) {
        std::size_t width = 0;
        for (const ParameterRow& row : rows) width = std::max(width, display_width(row.*text));
        if (width == 0) continue;
        width = std::max(width, head.size());
        const auto put = [&](std::string& line, std::string_view cell) {
            line += ' ' + std::string(cell) + std::string(width - display_width(cell) + 1, ' ');
        };
        put(lines[0], head);
        for (std::size_t i = 0; i < rows.size(); ++i) put(lines[i + 1], rows[i].*text);
    }
    std::string out;
    for (const std::string& line : lines)
        out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    return out;
}

Status list_parameters(Session& session, const ParameterJob& job) {
    Messages& messages = session.messages();
    const auto source = open_source(session, job.source);
    if (!source) return session.status();
    if (job.source != "-" && !is_kadr_name(job.source)) {
        messages.report(diag::NotAKadrProgram).arg(job.source);
        return refused(session);
    }
    const FileId file = keep_source(session, job.source, *source);
    const std::optional<KadrProgram> program = load_program(session, file);
    if (!program) return session.status();
    const syntax::Ast* ast = tree_of(*program);
    KADR_ASSERT(ast != nullptr, "a program that was checked has a tree");
    std::vector<ListedProgram> programs = programs_of(*program, *ast, session.sources().text(file));
    if (!choose(programs, session.options().program, file, messages)) return session.status();
    const auto output = Output::open(session.files(), job.output, messages, session.output_rules());
    if (!output) return refused(session);
    if (job.format == ParameterFormat::Json) {
        output->write(as_json(programs, *program->code, *ast));
    } else {
        for (const ListedProgram& one : programs) {
            if (&one != &programs.front()) output->write("\n");
            output->write(as_text(one, *program->code, *ast));
        }
    }
    return output->commit(messages) ? session.status() : refused(session);
}

}  // namespace kadr::driver
