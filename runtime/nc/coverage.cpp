#include "nc/coverage.h"

#include <algorithm>
#include <set>

#include "base/numbers.h"
#include "nc/tables.h"

namespace kadr::nc {

namespace {

/// A pattern in one line, with what tells it from others that read the same.
std::string name_of(const DialectTables& tables, const Form& form) {
    std::string name = "form " + first_line(form);
    if (form.is_preset) name += " preset";
    for (const Function needed : form.during) name.append(" during ").append(info(needed).name);
    name += " means ";
    name += form.function == Function::Cycle  ? tables.cycles[form.cycle].name
            : form.function == Function::None ? "none"
                                              : std::string(info(form.function).name);
    return name;
}

std::string name_of(const VariableForm& form, const VariableRange& range) {
    std::string name = "variable " + form.form;
    if (!form.is_family) return name;
    name += ' ';
    append_shortest(name, static_cast<double>(range.first));
    name += "..";
    append_shortest(name, static_cast<double>(range.last));
    return name;
}

}  // namespace

std::vector<DialectEntry> entries_of(const Dialect& dialect) {
    const DialectTables& tables = dialect.tables();
    const FileId own = tables.root.file;
    std::vector<DialectEntry> entries;
    for (const Form& form : tables.forms) {
        // A phrase of Kadr's own is read by nobody but the run that has written it.
        const bool is_read = form.is_read && !form.is_verbatim;
        if (is_read && form.unsupported.empty() && form.range.file == own)
            entries.push_back({name_of(tables, form), &form});
    }
    const Language& language = tables.language;
    // A file that changes some variables of an inherited language has not made that language.
    const bool is_own = !language.variables.empty() &&
                        std::ranges::all_of(language.variables, [&](const VariableForm& form) {
                            return form.range.file == own;
                        });
    if (!is_own) return entries;
    for (const OperatorForm& form : language.operators)
        entries.push_back({"operator " + form.text + (form.is_prefix ? " before" : ""), &form});
    for (const FunctionForm& form : language.functions)
        entries.push_back({"function " + form.form, &form});
    for (const VariableForm& form : language.variables) {
        for (const VariableRange& range : form.ranges) {
            if (range.kind != VariableRange::Kind::Unsupported)
                entries.push_back({name_of(form, range), &range});
        }
    }
    for (const StatementForm& form : language.statements)
        entries.push_back({"statement " + form.form, &form});
    return entries;
}

std::vector<std::string> unused_entries(const Dialect& dialect, const UsedEntries& used) {
    std::set<std::string> reached;
    const std::vector<DialectEntry> entries = entries_of(dialect);
    for (const DialectEntry& entry : entries) {
        if (used.contains(entry.place)) reached.insert(entry.name);
    }
    std::vector<std::string> names;
    for (const DialectEntry& entry : entries) {
        const bool is_reported = std::find(names.begin(), names.end(), entry.name) != names.end();
        if (!reached.contains(entry.name) && !is_reported) names.push_back(entry.name);
    }
    return names;
}

}  // namespace kadr::nc
