#include "macro/references.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "macro/target_search.h"
#include "macro/text_scan.h"

namespace kadr::macro {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A text that belongs to somebody else.
class BorrowedText final : public nc::TextSource {
  public:
    explicit BorrowedText(nc::TextSource& text) : text_(text) {}
    std::string_view next() override { return text_.next(); }
    bool seek(std::uint64_t offset) override { return text_.seek(offset); }

  private:
    nc::TextSource& text_;
};

/// Bytes in front of the first line that no control sees.
std::uint64_t mark_of(nc::TextSource& text) {
    if (!text.seek(0)) return 0;
    return text.next().starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
}

/// What the programs of definitions declare that stand in files of their own.
NamesOfProgram definitions_of(const nc::Dialect& dialect, ProgramUnits& units,
                              const ProgramText& own, OutsideNames& outside) {
    const nc::DialectTables& tables = dialect.tables();
    const nc::CallLanguage& calls = tables.language.calls;
    const std::string own_name = nc::program_of_path(calls, own.name, tables.notation.ignores_case);
    NamesOfProgram names;
    if (std::ranges::find(calls.definitions, own_name) != calls.definitions.end()) return names;
    for (const std::string& name : calls.definitions) {
        ProgramUnit* const unit = units.find_definitions(name);
        if (unit == nullptr || unit->text == &own) continue;
        ScannedText scanned;
        scanned.references.file = unit->text->name;
        TextScan scan(dialect, scanned, names, nullptr);
        scan.read(unit->text->source, 0, {});
        names.symbols = scan.common().symbols;
        names.macros = scan.common().macros;
        for (const TextDeclaration& each : scanned.references.declarations) {
            using Kind = TextDeclaration::Kind;
            if (each.kind != Kind::Variable && each.kind != Kind::Macro) continue;
            const std::uint32_t index =
                outside.add({unit->text->name, each.kind, each.name, each.range});
            names.known.insert_or_assign(each.name, KnownName{TextUse::Outcome::Elsewhere, index});
        }
    }
    return names;
}

}  // namespace

References find_references(const nc::Dialect& dialect, nc::TextSource& text, std::string file,
                           const ReferenceOptions& options) {
    ScannedText scanned;
    scanned.references.file = file;
    const std::uint64_t mark = mark_of(text);
    if (!text.seek(0)) return std::move(scanned.references);
    const bool has_main = options.main != nullptr;
    ProgramUnits units(dialect, has_main ? *options.main : text,
                       has_main ? options.main_name : file, 0, options.files);
    units.settle_main();
    ProgramText& own = has_main
                           ? *units.add(std::make_unique<BorrowedText>(text), std::move(file)).text
                           : *units.main().text;
    OutsideNames outside(scanned.references);
    TextScan scan(dialect, scanned, definitions_of(dialect, units, own, outside),
                  options.axis_names.empty() ? nullptr : &options.axis_names);
    scan.read(own.source, mark, has_main ? LinePosition{} : units.main().begin);
    index_blocks(dialect.tables(), own.source, mark, scanned);
    TargetSearch(dialect.tables(), units, own, scanned, outside).run();
    std::ranges::stable_sort(scanned.references.uses, {},
                             [](const TextUse& use) { return use.range.begin; });
    return std::move(scanned.references);
}

}  // namespace kadr::macro
