#include "nc/load.h"

#include "nc/load_parts.h"

namespace kadr::nc {

namespace {

/// What patterns build upon.
void load_ground(const XmlElement& e, DialectTables& tables, Attributes& attributes) {
    if (e.name == "doc") tables.doc = e.text;
    if (e.name == "remove") load_remove(e, tables, attributes);
    if (e.name == "comment") load_comment(e, tables.comment, attributes);
    if (e.name == "rules") load_notation(e, tables.notation, attributes);
    if (e.name == "address") load_address(e, tables, attributes);
    if (e.name == "program") load_program(e, tables.program, attributes);
    if (e.name == "blocks") load_blocks(e, tables.block_numbers, attributes);
}

}  // namespace

Done apply_dialect(const XmlElement& root, DialectTables& tables, MachineKind kind,
                   const Files& files, DiagnosticSink& sink) {
    Attributes attributes(sink, kind);
    FormLoader forms(tables, attributes, files);
    tables.root = root.range;
    tables.program.is_inherited = true;
    tables.examples.clear();  // those of the files it extends are run with them
    // The ground comes first, wherever it stands in the file.
    for (const XmlElement& e : root.children) load_ground(e, tables, attributes);
    for (const XmlElement& e : root.children) {
        if (e.name == "number") load_number(e, tables, attributes);
        if (e.name == "group") forms.load_group(e);
        if (e.name == "command") forms.load_command(e);
        if (e.name == "cycle") forms.load_cycle(e);
        if (e.name == "deferred") forms.load_deferred(e);
        if (e.name == "alarm") load_alarm(e, tables, attributes);
        if (e.name == "rule") load_rule(e, tables, attributes);
        if (e.name == "unsupported") load_unsupported(e, tables);
        if (e.name == "foreign") load_foreign(e, tables);
        if (e.name == "passed") load_passed(e, tables, attributes);
        if (e.name == "example") load_example(e, tables);
        if (e.name == "language") load_language(e, tables, attributes);
    }
    drop_cleared_forms(tables);
    return Done(!attributes.has_failed());
}

}  // namespace kadr::nc
