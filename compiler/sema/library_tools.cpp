#include "sema/library_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/diagnostics/sema.h"
#include "base/diagnostics/tools.h"
#include "base/text.h"
#include "machine/tool_library.h"
#include "sema/calls.h"
#include "sema/expressions.h"
#include "sema/scope.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using machine::CuttingData;
using machine::LibraryTool;
using machine::ToolLibrary;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

constexpr std::array<std::string_view, 15> kMembers = {
    "number", "name",   "kind", "d",  "r", "length", "flutes", "tip_angle",
    "pitch",  "holder", "vc",   "fz", "f", "speed",  "feed"};
constexpr std::size_t kFirstOfMaterial = 10;

std::string in_quotes(std::string_view name) { return '"' + std::string(name) + '"'; }

const ToolLibrary* library_of(Check& check, std::string_view asked, const SourceRange& range) {
    const ToolLibrary* library = check.options.tools ? check.options.tools() : nullptr;
    if (library != nullptr || check.told.no_tools) return library;
    check.told.no_tools = !check.sink.is_quiet;
    check.report(diag::ToolsNotNamed, range)
        .arg(asked)
        .fix("name the file of the library: `import \"tools.csv\";` in the program, or `--tools`");
    return nullptr;
}

const LibraryTool* named(Check& check, const ToolLibrary& library, std::string_view name,
                         const SourceRange& range) {
    if (const LibraryTool* tool = library.find(name)) return tool;
    std::vector<std::string_view> names;
    for (const LibraryTool& tool : library.tools) names.push_back(tool.name);
    auto message = check.report(diag::ToolNotInLibrary, range);
    message.arg('`' + std::string(name) + '`').arg(library.file);
    if (const auto near = nearest_name(name, names.data(), names.size()))
        message.fix(range, in_quotes(*near), "did you mean `" + std::string(*near) + "`?");
    return nullptr;
}

/// The tool that `tool(…)` names by a constant text or number.
const LibraryTool* tool_of(Check& check, ExprId id, std::string_view& text_of_tool) {
    const SourceRange range = check.ast()[id].range;
    text_of_tool = check.sources.text(range);
    const Value value = expression(check, id);
    if (check.is_error(value)) return nullptr;
    const bool is_text = check.kind(value.type) == TypeKind::String;
    if (!value.is_constant() || (!is_text && value.type != types::kInt)) {
        check.report(diag::NotConstant, range).arg("the name or number of a tool of the library");
        return nullptr;
    }
    const ToolLibrary* library = library_of(check, text_of_tool, range);
    if (library == nullptr) return nullptr;
    if (is_text) {
        const auto index = static_cast<std::size_t>(value.constant.integer);
        return named(check, *library, std::string(check.code->texts[index]), range);
    }
    const LibraryTool* tool = library->find(value.constant.integer);
    if (tool == nullptr)
        check.report(diag::ToolNotInLibrary, range).arg(value.constant.integer).arg(library->file);
    return tool;
}

std::string materials_of(const LibraryTool& tool) {
    std::string list;
    for (const CuttingData& cutting : tool.cutting)
        list.append(list.empty() ? "`" : ", `").append(cutting.material).append("`");
    return list;
}

/// The cutting data of the material that the call names, or the only ones. Null without a message:
/// the tool has none; with `failed`: it has been reported.
const CuttingData* cutting_of(Check& check, const LibraryTool& tool, ExprId material,
                              const SourceRange& range, bool& failed) {
    if (!material.is_valid()) {
        if (tool.cutting.size() < 2) return tool.cutting.empty() ? nullptr : tool.cutting.data();
        check.report(diag::ToolMaterial, range)
            .arg(tool.name)
            .arg("one material alone")
            .note(tool.range, "it has them for " + materials_of(tool))
            .fix("say which: `tool(" + in_quotes(tool.name) + ", " +
                 in_quotes(tool.cutting[0].material) + ")`");
        failed = true;
        return nullptr;
    }
    const SourceRange at = check.ast()[material].range;
    const Value value = expression(check, material, types::kString);
    failed = true;
    if (check.is_error(value)) return nullptr;
    if (!value.is_constant() || check.kind(value.type) != TypeKind::String) {
        check.report(diag::NotConstant, at).arg("the material");
        return nullptr;
    }
    const std::string name = check.code->texts[static_cast<std::size_t>(value.constant.integer)];
    auto found = std::ranges::find(tool.cutting, name, &CuttingData::material);
    // Data without a material hold for every one.
    if (found == tool.cutting.end())
        found = std::ranges::find(tool.cutting, std::string(), &CuttingData::material);
    if (found != tool.cutting.end()) {
        failed = false;
        return &*found;
    }
    std::vector<std::string_view> names;
    for (const CuttingData& cutting : tool.cutting) names.push_back(cutting.material);
    auto message = check.report(diag::ToolMaterial, at);
    message.arg(tool.name).arg('`' + name + '`');
    message.note(tool.range, tool.cutting.empty() ? std::string("it has none")
                                                  : "it has them for " + materials_of(tool));
    if (const auto near = nearest_name(name, names.data(), names.size()))
        message.fix(at, in_quotes(*near), "did you mean `" + std::string(*near) + "`?");
    return nullptr;
}

/// rev/s, a whole number of turns a minute: what an author would write.
std::optional<double> spindle_speed(const LibraryTool& tool, const CuttingData& cutting) {
    if (!cutting.cutting_speed || !tool.diameter) return std::nullopt;
    const double rpm = *cutting.cutting_speed * 60 / (std::numbers::pi * *tool.diameter);
    return std::max(1.0, std::round(rpm)) / 60;
}

/// mm/s, a whole number of mm/min.
std::optional<double> path_feed(const LibraryTool& tool, const CuttingData& cutting) {
    const std::optional<double> speed = spindle_speed(tool, cutting);
    std::optional<double> per_turn = cutting.feed_per_turn;
    if (cutting.feed_per_tooth && tool.flutes)
        per_turn = *cutting.feed_per_tooth * static_cast<double>(*tool.flutes);
    if (!speed || !per_turn) return std::nullopt;
    return std::max(1.0, std::round(*speed * 60 * *per_turn)) / 60;
}

/// A number of the library, or nothing of that type.
struct Asked {
    Type type;
    std::optional<double> number;
};

Asked cutting_value(Check& check, std::string_view member, const LibraryTool& tool,
                    const CuttingData& cutting) {
    if (member == "vc") return {check.types.real(kFeedPerTime), cutting.cutting_speed};
    if (member == "fz") return {types::kLengthType, cutting.feed_per_tooth};
    if (member == "f") return {check.types.real(kFeedPerTurn), cutting.feed_per_turn};
    if (member == "speed") return {check.types.real(kSpindleSpeed), spindle_speed(tool, cutting)};
    return {check.types.real(kFeedPerTime), path_feed(tool, cutting)};
}

Asked size_of(std::string_view member, const LibraryTool& tool) {
    if (member == "d") return {types::kLengthType, tool.diameter};
    if (member == "r") return {types::kLengthType, tool.corner_radius};
    if (member == "length") return {types::kLengthType, tool.length};
    if (member == "pitch") return {types::kLengthType, tool.pitch};
    return {types::kAngleType, tool.tip_angle};
}

Value absent(Check& check, Type type, const LibraryTool& tool, std::string_view member,
             const SourceRange& range, bool is_needed) {
    if (is_needed) {
        check.report(diag::ToolValueAbsent, range)
            .arg(member)
            .arg(tool.name)
            .note(tool.range, "the tool stands here")
            .fix("give it in the library, or say what holds without it: `?? …`");
        return error_value();
    }
    const Reg reg = check.emit.take(1);
    const Type optional = check.types.optional(type);
    emit_unset(check, optional, reg);
    return in_registers(optional, reg);
}

/// Where it may be not given, its type says so even if this tool has it: another library need not.
Value given_value(Check& check, Value value, bool is_needed) {
    if (is_needed) return value;
    const Reg reg = in_register(check, value);
    return in_registers(check.types.optional(value.type), reg);
}

}  // namespace

std::span<const std::string_view> library_members() { return kMembers; }

bool asks_library(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    if (expr.kind != ExprKind::Call) return false;
    const Expr& callee = check.ast()[expr.child[0]];
    if (callee.kind != ExprKind::Name || check.text(callee.text) != "tool") return false;
    const Found found = find(check, "tool");
    return found.symbol < 0 && found.name == nullptr;
}

Value library_value(Check& check, ExprId id, ExprId call_id, bool is_needed) {
    const Expr& expr = check.ast()[id];
    const Expr& call = check.ast()[call_id];
    const std::string_view member = check.text(expr.text);
    static constexpr std::array<std::string_view, 2> kParameters = {"tool", "material"};
    const auto bound = bind_arguments(check, call, "tool", kParameters, {}, 1);
    if (!bound) return error_value();
    if (!(*bound)[0].is_valid()) {
        check.report(diag::ArgumentMissing, call.range).arg("tool").arg("tool");
        return error_value();
    }
    const auto known = std::ranges::find(kMembers, member);
    if (known == kMembers.end()) {
        auto message = check.report(diag::ToolValueUnknown, expr.range);
        message.arg(member);
        if (const auto near = nearest_name(member, kMembers.data(), kMembers.size()))
            message.fix("did you mean `" + std::string(*near) + "`?");
        return error_value();
    }
    std::string_view written;
    const LibraryTool* tool = tool_of(check, (*bound)[0], written);
    if (tool == nullptr) return error_value();
    if (member == "number") return constant_integer(tool->number, types::kInt);
    if (member == "name") return constant_text(check, tool->name);
    if (member == "kind") return constant_text(check, machine::tool_kind_name(tool->kind));
    if (member == "holder") {
        if (tool->holder.empty())
            return absent(check, types::kString, *tool, member, expr.range, is_needed);
        return given_value(check, constant_text(check, tool->holder), is_needed);
    }
    if (member == "flutes") {
        if (!tool->flutes) return absent(check, types::kInt, *tool, member, expr.range, is_needed);
        return given_value(check, constant_integer(*tool->flutes, types::kInt), is_needed);
    }
    Asked asked;
    if (known - kMembers.begin() >= static_cast<std::ptrdiff_t>(kFirstOfMaterial)) {
        bool failed = false;
        const CuttingData* cutting = cutting_of(check, *tool, (*bound)[1], expr.range, failed);
        if (failed) return error_value();
        asked = cutting_value(check, member, *tool, cutting ? *cutting : CuttingData{});
    } else {
        asked = size_of(member, *tool);
    }
    if (!asked.number) return absent(check, asked.type, *tool, member, expr.range, is_needed);
    return given_value(check, constant_number(*asked.number, asked.type), is_needed);
}

Value called_tool(Check& check, const Value& name, const SourceRange& range) {
    if (!name.is_constant()) {
        check.report(diag::NotConstant, range).arg("the name of a tool");
        return error_value();
    }
    const std::string text = check.code->texts[static_cast<std::size_t>(name.constant.integer)];
    const ToolLibrary* library = library_of(check, in_quotes(text), range);
    const LibraryTool* tool = library == nullptr ? nullptr : named(check, *library, text, range);
    return tool == nullptr ? error_value() : constant_integer(tool->number, types::kInt);
}

}  // namespace kadr::sema
