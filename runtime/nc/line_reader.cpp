#include "nc/line_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "nc/match_faults.h"
#include "nc/spindle_words.h"

namespace kadr::nc {

LineReader::LineReader(const Dialect& dialect, std::string name, DiagnosticSink& sink)
    : tables_(dialect.tables()),
      bounds_(tables_, std::move(name)),
      faults_(dialect, bounds_, sink),
      modes_(tables_),
      points_(tables_, modes_, faults_),
      passed_(tables_, faults_),
      plain_(tables_, modes_, points_),
      values_(tables_, modes_, points_, faults_) {}

LineReader::Makes LineReader::read(std::string_view line, std::uint64_t number, Block& block) {
    begin(number);
    line = without_head(line);
    if (read_plain(line, block)) return Makes::Block;
    if (check_kind(line) != LineKind::Words) return Makes::Nothing;
    if (read_slow(line, block)) {
        if (block.kind != Block::Kind::Comment) bounds_.note_content();
        modes_.follow_line(block);
        return Makes::Block;
    }
    faults_.note_fault();
    return Makes::Nothing;
}

bool LineReader::read_plain(std::string_view line, Block& block) {
    if (!plain_.read(line, block)) {
        block.reset();
        return false;
    }
    bounds_.note_content();
    // Later forms depend on modal functions: G68 on its plane, G53 on absolute dimensions.
    if (block.function_count != 0 || block.motion != Function::None) modes_.follow(block);
    if (block.function_count != 0) note_machine_code(line);
    return true;
}

/// The last M code among codes and numbers.
void LineReader::note_machine_code(std::string_view line) {
    std::size_t at = line.find_last_of(tables_.notation.ignores_case ? "Mm" : "M");
    if (at == std::string_view::npos) return;
    const Decimal code = parse_decimal(line.data() + at + 1, line.data() + line.size());
    if (code.end != line.data() + at + 1) modes_.note_machine_code(code.value);
}

LineReader::LineKind LineReader::check_kind(std::string_view line) {
    const LineKind kind = bounds_.kind_of(line);
    if (kind == LineKind::Misplaced) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const auto at = static_cast<std::uint32_t>(begin);
        report_fault(line,
                     LineFault{&diag::IsoSyntax, {at, at + 1}, {std::string(1, line[begin])}});
    }
    if (kind == LineKind::WrongNumber) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const std::size_t end = std::min(line.find_first_of(" \t(;", begin), line.size());
        report_fault(line,
                     LineFault{&diag::IsoProgramNumber,
                               {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
                               {std::string(line.substr(begin, end - begin))}});
    }
    return kind;
}

bool LineReader::read_known(std::string_view line, Block& block) {
    if (!read_verbatim(tables_, modes_.units(), line, block)) return false;
    bounds_.note_content();
    modes_.follow(block);
    return true;
}

Done LineReader::read_words(std::string_view line, ControlLine& compiled,
                            std::span<const WordValue> values, Block& block, MatchedLine* known) {
    lexed_ = &compiled.words;
    set_values(tables_, compiled, values);
    if (modes_.has_chosen_master() && name_spindles(tables_, modes_, compiled.words))
        known = nullptr;
    bounds_.note_content();
    const bool is_whole = std::ranges::none_of(
        values, [](const WordValue& value) { return value.kind == WordValue::Kind::Vacant; });
    const bool is_known = known != nullptr && is_whole && known->holds_under(modes_.modal());
    if (is_known) known->recall(compiled.words, block, match_);
    const Done is_read =
        is_known ? apply(line, block) : fill(line, block, is_whole ? known : nullptr, &compiled);
    if (!is_read) {
        faults_.note_fault();
        return kFailed;
    }
    modes_.follow(block);
    return kDone;
}

Done LineReader::read_slow(std::string_view line, Block& block) {
    if (read_verbatim(tables_, modes_.units(), line, block)) return kDone;
    lexed_ = &own_lexed_;
    if (auto fault = lex_line(tables_, line, own_lexed_)) {
        report_fault(line, *fault);
        return kFailed;
    }
    if (modes_.has_chosen_master()) name_spindles(tables_, modes_, own_lexed_);
    if (!lexed_->label.empty()) {
        if (lexed_->words.empty()) {
            block.skip_level = lexed_->skip_level;
            block.number = lexed_->number;
            block.comment = lexed_->comment;
            block.kind = Block::Kind::Label;
            block.text = lexed_->label;
            return kDone;
        }
        report_fault(
            line,
            LineFault{&diag::IsoNotSupported, lexed_->spans[0], {"a label in front of words"}});
        return kFailed;
    }
    return fill(line, block);
}

/// The words of `lexed_` as a block.
Done LineReader::fill(std::string_view line, Block& block, MatchedLine* known,
                      const ControlLine* compiled) {
    block.skip_level = lexed_->skip_level;
    block.further_skip_levels = lexed_->further_skip_levels;
    block.number = lexed_->number;
    block.comment = lexed_->comment;
    block.text = lexed_->text;
    if (lexed_->comment_form != kNoForm) {
        tables_.note(&tables_.forms[lexed_->comment_form]);
        block.add(tables_.forms[lexed_->comment_form].function);
    }
    passed_.announce(*lexed_, line);
    if (lexed_->words.empty()) {
        // A number, a comment or both hold nothing that a control could execute.
        if (block.function_count == 0 && lexed_->passed.empty()) block.kind = Block::Kind::Comment;
        return kDone;
    }
    if (!check_code_points(line)) return kFailed;
    if (const auto fault =
            match_words(tables_, lexed_->words, lexed_->arguments, modes_.modal(), block, match_)) {
        if (passed_.leave_out(*fault, *lexed_, line)) {
            block.reset();
            return fill(line, block, known, compiled);
        }
        report_fault(line, fault_of_line(tables_, *fault, *lexed_, line, modes_.modal()));
        return kFailed;
    }
    if (known != nullptr) known->keep(tables_, *compiled, modes_.modal(), block, match_);
    return apply(line, block);
}

/// Codes that have no decimals stand without a point; none has a sign, or begins with the point.
/// Notes the M code meanwhile.
Done LineReader::check_code_points(std::string_view line) {
    for (std::size_t i = 0; i < lexed_->words.size(); ++i) {
        const GivenWord& word = lexed_->words[i];
        const Address& address = tables_.addresses[word.address];
        if (address.kind != Address::Kind::Code || word.is_left_out) continue;
        if (word.is_known && address.name == "M") modes_.note_machine_code(word.number);
        if (!word.is_known || word.is_computed) continue;
        const std::string text = lexed_->text_of(line, i);
        const std::size_t first = text.find_first_not_of(" \t", address.name.size());
        const bool has_sign = first != text.npos && (text[first] == '-' || text[first] == '+');
        const bool has_point =
            lexed_->decimals[i].has_point && (address.format.point == PointRule::Never ||
                                              (first != text.npos && text[first] == '.'));
        if (!has_sign && !has_point) continue;
        const DiagnosticRow& row = has_sign ? diag::IsoMinusNotAllowed : diag::IsoPointNotAllowed;
        report_fault(line, LineFault{&row, lexed_->spans[i], {text}});
        return kFailed;
    }
    return kDone;
}

/// Puts the numbers where they belong. The block's own changes of units act in it already.
Done LineReader::apply(std::string_view line, Block& block) {
    for (std::size_t i = 0; i < match_.form_count; ++i) {
        const FormId id = match_.forms[i];
        tables_.note(&tables_.forms[id]);
        modes_.note_form(id);
        passed_.announce(id, *lexed_, line);
    }
    const ModalFunctions before = modes_.modal();
    modes_.begin_numbers(block);
    block.has_inch_feed = modes_.units().inch_feed;
    Done applied = kDone;
    for (std::size_t i = 0; i < match_.claim_count && applied; ++i)
        applied = values_.put(match_.claims[i], *lexed_, line, block);
    if (!applied) modes_.go_back(before);
    modes_.follow_master(block);
    return applied;
}

void LineReader::report_fault(std::string_view line, const LineFault& fault) {
    faults_.report(line, fault, {is_about_words(*fault.row) && is_in_cycle(), false});
}

DiagnosticBuilder LineReader::report_event(std::string_view line, const LineFault& fault) {
    return faults_.report(line, fault, {is_in_cycle(), true});
}

void LineReader::report_too_long(std::string_view line, std::uint64_t number) {
    begin(number);
    const auto shown = static_cast<std::uint32_t>(std::min<std::size_t>(line.size(), 1));
    report_fault(
        line.substr(0, 80),
        LineFault{&diag::IsoLineTooLong, {0, shown}, {std::to_string(tables_.notation.max_line)}});
}

/// Whether a cycle acts, or the line that is read calls one.
bool LineReader::is_in_cycle() const {
    if (modes_.active(Group::CycleMode) == Function::Cycle) return true;
    return lexed_ != nullptr && std::ranges::any_of(lexed_->words, [&](const GivenWord& word) {
               const CodeStart* code =
                   word.is_known ? tables_.find_code(word.address, word.number) : nullptr;
               return code != nullptr && std::ranges::any_of(code->forms, [&](FormId id) {
                          return tables_.forms[id].function == Function::Cycle;
                      });
           });
}

}  // namespace kadr::nc
