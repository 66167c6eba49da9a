#include "driver/debug/inspection.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "driver/debug/steps.h"

namespace kadr::driver {

namespace {

std::string position_text(double value) { return fmt::format("{:.3f}", round_to(value, 3) + 0.0); }

std::string_view type_of(macro::ControlVariable::Kind kind) {
    switch (kind) {
        case macro::ControlVariable::Kind::Real: return "REAL";
        case macro::ControlVariable::Kind::Int: return "INT";
        case macro::ControlVariable::Kind::Bool: return "BOOL";
        case macro::ControlVariable::Kind::Text: return "STRING";
        case macro::ControlVariable::Kind::Vacant: break;
    }
    return "";
}

std::vector<Variable> axis_variables(AxisMask axes, const AxisValues& values) {
    std::vector<Variable> out;
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) == 0) continue;
        out.push_back({std::string(kAxisNames[i]), {}, position_text(values[i]), {}, 0});
    }
    return out;
}

}  // namespace

void Inspection::begin(const Stop& stop) {
    frames_.clear();
    origins_.clear();
    named_.clear();
    if (stop.is_at_statement()) add_functions(stop);
    add_programs(stop);
    if (!stop.is_at_statement()) add_functions(stop);
}

/// The statement that an instruction belongs to; not valid: it stands in front of all.
SourceRange Inspection::statement_at(std::uint32_t instruction) const {
    const std::vector<sema::StatementStart>& all = execution_->program()->code->names.statements;
    const auto behind = std::ranges::upper_bound(all, instruction, {}, &sema::StatementStart::at);
    return behind == all.begin() ? SourceRange{} : (behind - 1)->range;
}

void Inspection::add_functions(const Stop& stop) {
    const GeneratedText* generated = execution_->generated();
    if (generated == nullptr || execution_->program() == nullptr) return;
    const std::vector<expand::RunningCall> calls = generated->expander().running_calls();
    const sema::Code& code = *execution_->program()->code;
    for (std::size_t i = calls.size(); i-- > 0;) {
        const bool is_innermost = i + 1 == calls.size();
        StackFrame frame;
        frame.kind = StackFrame::Kind::Function;
        frame.name = calls[i].function->name;
        frame.range = !is_innermost            ? code.locations[calls[i].at]
                      : stop.is_at_statement() ? stop.statement
                                               : statement_at(calls[i].at);
        if (!frame.range.file.is_valid()) continue;  // the program has not begun
        frame.file = session_.sources().name(frame.range.file);
        const LineColumn at = session_.sources().locate(frame.range.file, frame.range.begin);
        frame.line = at.line;
        frame.column = at.column;
        frames_.push_back(std::move(frame));
        origins_.push_back({calls[i], 0});
    }
}

void Inspection::add_programs(const Stop& stop) {
    const std::vector<macro::ProgramLevel> levels = std::as_const(*execution_).reader().levels();
    for (std::size_t i = levels.size(); i-- > 0;) {
        StackFrame frame;
        frame.kind = StackFrame::Kind::Program;
        frame.file = levels[i].file.empty() ? execution_->text_name() : levels[i].file;
        frame.name = levels[i].program.empty() ? frame.file : levels[i].program;
        const bool is_innermost = i + 1 == levels.size();
        frame.line = is_innermost && stop.line ? stop.line->line : levels[i].line;
        frames_.push_back(std::move(frame));
        origins_.push_back({{}, i});
    }
}

VariablesRef Inspection::name(Named named) {
    named_.push_back(std::move(named));
    return {static_cast<std::uint32_t>(named_.size())};
}

std::vector<Scope> Inspection::scopes(std::size_t frame) {
    using K = Scope::Kind;
    static constexpr std::pair<K, const char*> kOfFunction[] = {{K::Locals, "Locals"},
                                                                {K::Globals, "Globals"}};
    static constexpr std::pair<K, const char*> kOfProgram[] = {
        {K::ProgramLocals, "Local variables"},
        {K::CommonVariables, "Common variables"},
        {K::MachineValues, "Values of the machine"},
        {K::Position, "Position"},
        {K::MachinePosition, "Machine position"},
        {K::Codes, "Codes"},
        {K::State, "State"}};
    std::vector<Scope> scopes;
    const auto add = [&](const auto& rows) {
        for (const auto& [kind, title] : rows)
            scopes.push_back({kind, title, name({frame, kind, nullptr, {}})});
    };
    if (frame >= frames_.size()) return scopes;
    if (frames_[frame].kind == StackFrame::Kind::Function) add(kOfFunction);
    else add(kOfProgram);
    return scopes;
}

std::vector<Variable> Inspection::variables(VariablesRef of, std::size_t first, std::size_t most) {
    if (!of.is_valid() || of.number > named_.size()) return {};
    const Named named = named_[of.number - 1];
    if (named.variable != nullptr) return parts(named, first, most);
    std::vector<Variable> all;
    switch (named.kind) {
        case Scope::Kind::Locals:
        case Scope::Kind::Globals: all = named_variables(named); break;
        case Scope::Kind::ProgramLocals:
        case Scope::Kind::CommonVariables:
        case Scope::Kind::MachineValues: all = control_variables(named); break;
        case Scope::Kind::Position:
        case Scope::Kind::MachinePosition:
        case Scope::Kind::Codes:
        case Scope::Kind::State: all = modal_variables(named); break;
    }
    return all;
}

Variable Inspection::seen(const Named& at, std::string shown_name) {
    const expand::SeenValue value =
        execution_->generated()->expander().see(origins_[at.frame].call, *at.variable, at.path);
    Variable out;
    out.name = std::move(shown_name);
    out.type = at.path.empty() ? at.variable->type : value.form->type;
    out.value = value.text;
    out.part_count = value.parts;
    if (value.parts > 0) out.parts = name(at);
    return out;
}

std::vector<Variable> Inspection::parts(const Named& of, std::size_t first, std::size_t most) {
    const expand::SeenValue whole =
        execution_->generated()->expander().see(origins_[of.frame].call, *of.variable, of.path);
    std::vector<Variable> out;
    const auto count = static_cast<std::size_t>(whole.parts);
    for (std::size_t i = first; i < count && out.size() < most; ++i) {
        Named part = of;
        part.path.push_back(static_cast<std::uint32_t>(i));
        const bool is_member = whole.form->kind == sema::ShownForm::Kind::Members;
        out.push_back(
            seen(part, is_member ? whole.form->parts[i].name : '[' + std::to_string(i) + ']'));
    }
    return out;
}

std::vector<Variable> Inspection::named_variables(const Named& scope) {
    const sema::CodeNames& names = execution_->program()->code->names;
    const expand::RunningCall& call = origins_[scope.frame].call;
    const sema::FunctionCode& function = *call.function;
    std::vector<Variable> out;
    const auto add = [&](const sema::NamedVariable& variable) {
        out.push_back(seen({scope.frame, scope.kind, &variable, {}}, variable.name));
    };
    if (scope.kind == Scope::Kind::Globals) {
        const FileId file = frames_[scope.frame].range.file;
        for (const sema::NamedVariable& variable : names.globals) {
            if (variable.range.file == file) add(variable);
        }
        return out;
    }
    const auto begin =
        std::ranges::lower_bound(names.variables, function.entry, {}, &sema::NamedVariable::from);
    for (auto at = begin; at != names.variables.end() && at->from <= call.at; ++at) {
        if (call.at < at->to) add(*at);
    }
    return out;
}

std::vector<Variable> Inspection::control_variables(const Named& scope) const {
    const macro::VariableOwner owner =
        scope.kind == Scope::Kind::ProgramLocals     ? macro::VariableOwner::Program
        : scope.kind == Scope::Kind::CommonVariables ? macro::VariableOwner::Control
                                                     : macro::VariableOwner::Machine;
    std::vector<Variable> out;
    for (const macro::ControlVariable& variable :
         std::as_const(*execution_).reader().variables(origins_[scope.frame].level, owner))
        out.push_back(
            {variable.name, std::string(type_of(variable.kind)), json_text(variable), {}, 0});
    return out;
}

std::vector<Variable> Inspection::modal_variables(const Named& scope) const {
    const TraceState now = state();
    std::vector<Variable> out;
    switch (scope.kind) {
        case Scope::Kind::Position: return axis_variables(now.now.axes, now.now.work);
        case Scope::Kind::MachinePosition: return axis_variables(now.now.axes, now.now.machine);
        case Scope::Kind::Codes:
            for (const macro::ActiveCode& code : now.codes)
                out.push_back({std::string(code.group), {}, std::string(code.code), {}, 0});
            return out;
        default: break;
    }
    for (const ModalEntry& entry : now.modal)
        out.push_back({std::string(entry.name), {}, modal_text(entry.value, "none"), {}, 0});
    return out;
}

TraceState Inspection::state() const { return state_of(*execution_); }

}  // namespace kadr::driver
