#include "tests/control/taken_ways.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "base/diagnostics/control.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "driver/program_files.h"
#include "macro/reference_queries.h"
#include "nc/held_text.h"
#include "nc/tables.h"
#include "tests/common/inputs.h"

namespace kadr::interp {
namespace {

using macro::NamedPlace;
using macro::References;
using macro::TextDeclaration;
using macro::TextUse;
using macro::WayTaken;
using nc::HeldText;

/// The references of the texts of one run, as they are asked for.
class Texts {
  public:
    Texts(const nc::Dialect& dialect, const std::string& text, const std::filesystem::path& called)
        : dialect_(dialect),
          main_(text),
          files_({called.string()}, test::quiet_session(called.string())) {}

    const References& of(const std::string& file) {
        const auto [known, is_new] = references_.emplace(file, References());
        if (!is_new) return known->second;
        HeldText text(text_of(file));
        macro::ReferenceOptions options;
        options.files = &files_;
        if (!file.empty()) options.main = &main_;
        known->second = find_references(dialect_, text, file, options);
        return known->second;
    }
    /// A line of a text, as it stands there.
    std::string line(const std::string& file, std::uint64_t number) {
        std::istringstream in(text_of(file));
        std::string line;
        for (std::uint64_t i = 0; i < number; ++i) std::getline(in, line);
        return line;
    }
    const nc::Dialect& dialect() const { return dialect_; }

  private:
    std::string text_of(const std::string& file) {
        return file.empty() ? main_.all() : read_file(file).value_or("");
    }

    const nc::Dialect& dialect_;
    HeldText main_;
    driver::ProgramFolders files_;
    std::map<std::string, References> references_;
};

bool is_open(const TextUse& use) {
    using Outcome = TextUse::Outcome;
    return use.outcome == Outcome::Computed || use.outcome == Outcome::Ambiguous ||
           use.outcome == Outcome::OfCaller;
}

/// Whether a use may be what has taken a way of this kind.
bool is_of_kind(const TextUse& use, WayTaken::Kind kind) {
    switch (kind) {
        case WayTaken::Kind::Repeat: return use.kind == TextUse::Kind::Repeat;
        case WayTaken::Kind::Call: return use.kind == TextUse::Kind::Call;
        case WayTaken::Kind::Jump:
            return use.kind == TextUse::Kind::Jump || use.kind == TextUse::Kind::Call;
    }
    return false;
}

std::vector<TextUse> uses_of_line(const References& references, std::uint64_t line) {
    std::vector<TextUse> found;
    std::ranges::copy_if(references.uses, std::back_inserter(found),
                         [&](const TextUse& use) { return use.range.line == line; });
    return found;
}

/// The lines of a program from its first one to that which names it.
bool begins_at(Texts& texts, const NamedPlace& place, std::uint64_t line) {
    for (const TextDeclaration& each : texts.of(place.file).declarations) {
        const bool is_it = each.kind == TextDeclaration::Kind::Program && each.range == place.range;
        if (is_it)
            return each.lines.line <= line && line <= std::max(each.range.line, each.lines.line);
    }
    return false;
}

bool leads_to(Texts& texts, const References& references, const TextUse& use, const KeptWay& way) {
    const auto target = target_of(references, use);
    if (!target || target->file != way.to_file) return false;
    if (target->kind == TextDeclaration::Kind::Program)
        return begins_at(texts, *target, way.to_line);
    if (target->range.line == way.to_line) return true;
    // A part of the program that runs is called: where it begins is a way of its own.
    const std::uint64_t begin = references.declarations[use.program].lines.line;
    return way.kind == WayTaken::Kind::Call && way.to_line == begin;
}

std::string shown(const KeptWay& way) {
    return way.file + ':' + std::to_string(way.line) + " leads to " + way.to_file + ':' +
           std::to_string(way.to_line);
}

bool runs_text(Texts& texts, const std::string& file, std::uint64_t line) {
    const std::string text = texts.line(file, line);
    return nc::front_of(texts.dialect().tables(), text).statement == nc::Statement::RunText;
}

bool expect_way(Texts& texts, const KeptWay& way) {
    const References& references = texts.of(way.file);
    std::vector<TextUse> uses = uses_of_line(references, way.line);
    std::erase_if(uses, [&](const TextUse& use) { return !is_of_kind(use, way.kind); });
    const auto is_it = [&](const TextUse& use) { return leads_to(texts, references, use, way); };
    if (std::ranges::any_of(uses, is_it)) return true;
    if (std::ranges::any_of(uses, is_open) || runs_text(texts, way.file, way.line)) return false;
    ADD_FAILURE() << shown(way) << ", and its references do not";
    return false;
}

/// What the control has looked for and not found.
void expect_missing(Texts& texts, const Diagnostic& message) {
    const std::set<const DiagnosticRow*> rows = {&diag::JumpTargetMissing, &diag::ProgramMissing,
                                                 &diag::RepeatLabelMissing};
    if (!rows.contains(message.row) || !message.line) return;
    const std::string file = message.line->file == "test" ? "" : message.line->file;
    std::vector<TextUse> uses = uses_of_line(texts.of(file), message.line->line);
    std::erase_if(uses, [](const TextUse& use) {
        return use.kind == TextUse::Kind::Read || use.kind == TextUse::Kind::Write;
    });
    if (uses.empty() || std::ranges::any_of(uses, is_open)) return;
    EXPECT_TRUE(std::ranges::any_of(
        uses, [](const TextUse& use) { return use.outcome == TextUse::Outcome::Missing; }))
        << message.line->line << " names what the control does not find";
}

}  // namespace

void WatchedWays::takes(const macro::WayTaken& way) {
    const KeptWay kept{way.kind, way.line, std::string(way.file), way.to_line,
                       std::string(way.to_file)};
    if (ways_.empty() || ways_.back() != kept) ways_.push_back(kept);
}

std::vector<KeptWay> WatchedWays::ways() const {
    const std::set<KeptWay> each(ways_.begin(), ways_.end());
    return {each.begin(), each.end()};
}

std::size_t expect_references(const nc::Dialect& dialect, const std::string& text,
                              const std::filesystem::path& called, const std::vector<KeptWay>& ways,
                              const std::vector<Diagnostic>& messages) {
    Texts texts(dialect, text, called);
    std::size_t compared = 0;
    for (const KeptWay& way : ways) compared += expect_way(texts, way) ? 1 : 0;
    for (const Diagnostic& message : messages) expect_missing(texts, message);
    return compared;
}

}  // namespace kadr::interp
