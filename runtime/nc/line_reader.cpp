#include "nc/line_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/powers.h"
#include "base/text.h"
#include "nc/head_words.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

/// Whether a line is the last one of a program: it begins as the template does before what is
/// filled in.
bool is_end_line(std::string_view line, std::string_view end) {
    const std::size_t fixed = end.find_first_of("{[");
    if (fixed == 0 || fixed == std::string_view::npos) return line == end;
    return line.starts_with(end.substr(0, fixed));
}

/// Whether the first word of a form may have this number.
bool takes_number(const Form& form, double number) {
    return std::ranges::none_of(form.when, [&](const Constraint& c) {
        return c.parameter == form.words[0].parameter && (number < c.least || number > c.most);
    });
}

}  // namespace

LineReader::LineReader(const Dialect& dialect, std::string name, DiagnosticSink& sink)
    : dialect_(dialect), tables_(dialect.tables()), own_text_{std::move(name), {}}, sink_(sink) {
    for (std::size_t letter = 0; letter < letters_.size(); ++letter) prepare(letter);
    prepare_names();
    modal_ = ModalFunctions{tables_.power_on};
    modal_[static_cast<std::size_t>(Group::Motion)] = Function::None;
    last_forms_.assign(tables_.groups.size(), kNoForm);
    const auto& threads = tables_.forms_of[static_cast<std::size_t>(Function::Thread)];
    feed_is_pitch_ = !threads.empty() && tables_.forms[threads[0]].feed_is_pitch;
    if (feed_is_pitch_) {
        for (const FunctionInfo& thread : all_functions()) {
            if (has_fact(thread.function, Fact::Pitch) && !is_tapping(thread.function))
                closely_read_.set(static_cast<std::size_t>(thread.function));
        }
    }
    follow_units();
}

// ---------------------------------------------------------------- lines

LineReader::LineKind LineReader::kind_of(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (line.empty()) return LineKind::Nothing;
    const std::vector<std::string>& ends = tables_.program.end;
    const auto is_end = [&](const std::string& end) { return is_end_line(line, end); };
    if (text_->has_content && std::ranges::any_of(ends, is_end)) text_->has_ended = true;
    if (text_->has_ended) return LineKind::Nothing;
    // `O100`, `O<NAME>`, and no word that begins with the letter.
    const bool is_header =
        std::ranges::any_of(tables_.program.skipped, [&](const std::string& front) {
            const bool goes_on = !front.empty() && is_letter(front.back()) &&
                                 line.size() > front.size() && is_letter(line[front.size()]);
            return line.starts_with(front) && !goes_on;
        });
    if (!is_header) return LineKind::Words;
    if (!text_->has_content) note_program(line);
    if (text_->has_content &&
        program_of_header(tables_.language.calls, line, tables_.notation.ignores_case)) {
        text_->has_ended = true;
        return LineKind::Nothing;
    }
    if (has_wrong_number(line)) return LineKind::WrongNumber;
    if (!text_->has_content) return LineKind::Nothing;
    // Where a mark ends the text, another program may begin before it.
    text_->has_ended = !ends.empty();
    return text_->has_ended ? LineKind::Nothing : LineKind::Misplaced;
}

void LineReader::note_program(std::string_view line) {
    if (auto program =
            program_of_header(tables_.language.calls, line, tables_.notation.ignores_case))
        text_->program = std::move(*program);
}

std::string_view LineReader::without_head(std::string_view line) {
    if (text_->has_content || line.empty()) return line;
    const std::size_t words = words_behind_head(tables_, line);
    const std::size_t begin = line.find_first_not_of(" \t");
    if (words == std::string_view::npos || has_wrong_number(line.substr(begin))) return line;
    note_program(line);
    head_line_ = head_text_ = line;
    head_number_ = line_number_;
    std::fill_n(head_line_.begin(), words, ' ');
    return head_line_;
}

/// Whether the line names the program by a number that the control does not have.
bool LineReader::has_wrong_number(std::string_view line) const {
    const ProgramFrame& frame = tables_.program;
    if (frame.most_read_number == 0) return false;
    for (const std::string& header : frame.header) {
        const std::size_t front = header.find("{number");
        if (front == 0 || front == std::string::npos) continue;
        if (!line.starts_with(std::string_view(header).substr(0, front))) continue;
        const char* const digits = line.data() + front;
        const Decimal number = parse_decimal(digits, line.data() + line.size());
        return number.end != digits && (number.value < static_cast<double>(frame.least_number) ||
                                        number.value > static_cast<double>(frame.most_read_number));
    }
    return false;
}

bool LineReader::read_plain(std::string_view line, Block& block) {
    if (!read_fast(line, block)) {
        block.reset();
        return false;
    }
    text_->has_content = true;
    // Later forms depend on modal functions: G68 on its plane, G53 on absolute dimensions.
    if (block.function_count != 0 || block.motion != Function::None)
        follow_modal(tables_.rules, block, modal_);
    if (block.function_count != 0) note_machine_code(line);
    return true;
}

/// The last M code among codes and numbers.
void LineReader::note_machine_code(std::string_view line) {
    std::size_t at = line.find_last_of(tables_.notation.ignores_case ? "Mm" : "M");
    if (at == std::string_view::npos) return;
    const Decimal code = parse_decimal(line.data() + at + 1, line.data() + line.size());
    if (code.end != line.data() + at + 1) machine_code_ = code.value;
}

LineReader::LineKind LineReader::check_kind(std::string_view line) {
    const LineKind kind = kind_of(line);
    if (kind == LineKind::Misplaced) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const auto at = static_cast<std::uint32_t>(begin);
        report(line, LineFault{&diag::IsoSyntax, {at, at + 1}, {std::string(1, line[begin])}});
    }
    if (kind == LineKind::WrongNumber) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const std::size_t end = std::min(line.find_first_of(" \t(;", begin), line.size());
        report(line, LineFault{&diag::IsoProgramNumber,
                               {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
                               {std::string(line.substr(begin, end - begin))}});
    }
    return kind;
}

bool LineReader::read_known(std::string_view line, Block& block) {
    if (!read_verbatim(line, block)) return false;
    text_->has_content = true;
    follow_modal(tables_.rules, block, modal_);
    return true;
}

LineReader::Makes LineReader::read(std::string_view line, std::uint64_t number, Block& block) {
    begin(number);
    line = without_head(line);
    if (read_plain(line, block)) return Makes::Block;
    if (check_kind(line) != LineKind::Words) return Makes::Nothing;
    if (read_slow(line, block)) {
        text_->has_content |= block.kind != Block::Kind::Comment;
        follow(block);
        return Makes::Block;
    }
    note_fault();
    return Makes::Nothing;
}

Done LineReader::read_words(std::string_view line, ControlLine& compiled,
                            std::span<const WordValue> values, Block& block, MatchedLine* known) {
    lexed_ = &compiled.words;
    set_values(compiled, values);
    if (knows_masters_ && name_spindles(compiled.words)) known = nullptr;
    text_->has_content = true;
    const bool is_whole = std::ranges::none_of(
        values, [](const WordValue& value) { return value.kind == WordValue::Kind::Vacant; });
    const bool is_known =
        known != nullptr && known->is_valid && is_whole && known->before == modal_;
    if (is_known) recall(*known, block);
    const Done is_read =
        is_known ? apply(block, line) : fill(line, block, is_whole ? known : nullptr, &compiled);
    if (!is_read) {
        note_fault();
        return kFailed;
    }
    follow_modal(tables_.rules, block, modal_);
    return kDone;
}

/// The block as the words were understood before; the values are to be put in.
void LineReader::recall(const MatchedLine& known, Block& block) {
    const Block& shape = known.shape;
    block.skip = shape.skip;
    block.further_skip_levels = shape.further_skip_levels;
    block.number = shape.number;
    block.motion = shape.motion;
    block.incremental = shape.incremental;
    block.absolute = shape.absolute;
    block.x_measure = shape.x_measure;
    block.rotary_approaches = shape.rotary_approaches;
    block.cycle = shape.cycle;
    block.function_count = shape.function_count;
    block.argument_count = shape.argument_count;
    std::copy_n(shape.functions.begin(), shape.function_count, block.functions.begin());
    std::copy_n(shape.arguments.begin(), shape.argument_count, block.arguments.begin());
    if (!lexed_->comment.empty()) block.comment = lexed_->comment;
    if (!lexed_->text.empty()) block.text = lexed_->text;
    std::ranges::copy(known.claims, match_.claims.begin());
    std::ranges::copy(known.forms, match_.forms.begin());
    match_.claim_count = known.claims.size();
    match_.form_count = known.forms.size();
}

/// Words that name the first spindle are words of the master while it is that, and words with a
/// number while another one is; true if there are any.
bool LineReader::name_spindles(LexedLine& words) const {
    bool has_any = false;
    for (GivenWord& word : words.words) {
        if (!word.names_first) continue;
        has_any = true;
        const std::string& name = tables_.addresses[word.address].name;
        const bool is_numbered = name.back() == '1' || name.back() == ']';
        if (is_numbered == has_other_master_) continue;
        const std::string plain = is_numbered ? name.substr(0, name.find_first_of("1[")) : name;
        AddressId wanted = tables_.find_address(plain);
        if (!is_numbered) wanted = tables_.find_address(name + '1');
        if (wanted == kNoAddress) wanted = tables_.find_address(name + "[1]");
        // M1=8 is no function of a spindle.
        const auto takes = [&](FormId id) { return takes_number(tables_.forms[id], word.number); };
        const bool is_taken =
            is_numbered ||
            (wanted != kNoAddress && std::ranges::any_of(tables_.addresses[wanted].forms, takes));
        if (wanted != kNoAddress && is_taken) word.address = wanted;
    }
    return has_any;
}

/// Only lines of which no computed value decides what they say.
void LineReader::remember(const ControlLine& compiled, const Block& block,
                          MatchedLine& known) const {
    known.is_valid = !compiled.words.words.empty() &&
                     std::ranges::all_of(compiled.computed, [&](const ComputedValue& computed) {
                         if (computed.argument >= 0) return false;
                         const AddressId id = compiled.words.words[computed.word].address;
                         const Address& address = tables_.addresses[id];
                         return address.kind == Address::Kind::Value && address.slot >= 0 &&
                                address.forms.empty() && tables_.code_index[id].empty();
                     });
    if (!known.is_valid) return;
    known.before = modal_;
    known.shape = block;
    known.claims.assign(match_.claims.begin(),
                        match_.claims.begin() + static_cast<std::ptrdiff_t>(match_.claim_count));
    known.forms.assign(match_.forms.begin(),
                       match_.forms.begin() + static_cast<std::ptrdiff_t>(match_.form_count));
}

/// Puts computed values into the words; a word that is vacant is none.
void LineReader::set_values(ControlLine& compiled, std::span<const WordValue> values) {
    LexedLine& lexed = compiled.words;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ComputedValue& computed = compiled.computed[i];
        const WordValue& value = values[i];
        if (value.kind == WordValue::Kind::Text) lexed.text = value.text;
        if (computed.argument >= 0) {
            GivenArgument& argument = lexed.arguments[static_cast<std::size_t>(computed.argument)];
            argument.kind = value.kind == WordValue::Kind::Text     ? GivenArgument::Kind::Text
                            : value.kind == WordValue::Kind::Vacant ? GivenArgument::Kind::Empty
                                                                    : GivenArgument::Kind::Number;
            argument.number = value.number;
            continue;
        }
        GivenWord& word = lexed.words[computed.word];
        word.is_computed = true;
        word.is_left_out = value.kind == WordValue::Kind::Vacant;
        word.is_text = value.kind == WordValue::Kind::Text;
        word.is_known = value.kind == WordValue::Kind::Number;
        word.number = whole_if_needed(word.address, value.number);
        Decimal& decimal = lexed.decimals[computed.word];
        decimal = {};
        decimal.value = word.number;
        decimal.has_point = true;
        lexed.minus[computed.word] = word.number < 0;
    }
}

/// Codes and addresses that take whole numbers get one: `M[3.5]` is M4.
double LineReader::whole_if_needed(AddressId id, double value) const {
    const Address& address = tables_.addresses[id];
    const bool is_whole = address.kind == Address::Kind::Code
                              ? !has_decimal_codes(id)
                              : address.format.point == PointRule::Never;
    return is_whole ? std::round(value) : value;
}

bool LineReader::has_decimal_codes(AddressId id) const {
    const std::vector<std::uint16_t>& index = tables_.code_index[id];
    for (std::size_t i = 0; i < index.size(); ++i) {
        if (index[i] != 0 && i % 10 != 0) return true;
    }
    return false;
}

int LineReader::value_decimals(const ControlLine& line, std::size_t computed) const {
    const ComputedValue& value = line.computed[computed];
    if (value.argument >= 0) return 0;
    const Address& address = tables_.addresses[line.words.words[value.word].address];
    return text_decimals(address.format, address.dimension, units_);
}

/// A computed value as the control takes it: rounded to the increment of its address, halves away
/// from zero.
double LineReader::rounded(double value, const NumberFormat& format, Dimension dimension) const {
    if (!tables_.language.rules.rounds_values) return value;
    const double power = power_of_ten(text_decimals(format, dimension, units_));
    return std::round(value * power) / power;
}

void LineReader::report_too_long(std::string_view line, std::uint64_t number) {
    begin(number);
    const auto shown = static_cast<std::uint32_t>(std::min<std::size_t>(line.size(), 1));
    report(
        line.substr(0, 80),
        LineFault{&diag::IsoLineTooLong, {0, shown}, {std::to_string(tables_.notation.max_line)}});
}

/// A line of the control's own language that the dialect knows by its letters.
bool LineReader::read_verbatim(std::string_view line, Block& block) const {
    if (tables_.verbatim_forms.empty()) return false;
    const char* begin = line.data();
    const char* const end = begin + line.size();
    const auto skip_blanks = [&] {
        while (begin != end && is_blank(*begin)) ++begin;
    };
    skip_blanks();
    std::int8_t skip = -1;
    if (begin != end && *begin == '/') {
        ++begin;
        skip = static_cast<std::int8_t>(tables_.notation.default_skip);
        if (begin != end && is_digit(*begin)) skip = static_cast<std::int8_t>(*begin++ - '0');
        skip_blanks();
    }
    std::int32_t number = -1;
    if (begin != end && *begin == 'N') {
        const Decimal decimal = parse_decimal(begin + 1, end);
        if (decimal.end == begin + 1 || decimal.has_point || decimal.value > 99999999) return false;
        number = static_cast<std::int32_t>(decimal.value);
        begin = decimal.end;
    }
    for (const FormId id : tables_.verbatim_forms) {
        const Form& form = tables_.forms[id];
        if (!match_verbatim(form, {begin, end}, block)) continue;
        tables_.note(&form);
        block.number = number;
        block.skip = skip;
        return true;
    }
    return false;
}

/// Fills the block if the text has the letters of the form and numbers between them; blanks do not
/// count.
bool LineReader::match_verbatim(const Form& form, std::string_view text, Block& block) const {
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto skip = [](const char*& p, const char* last) {
        while (p != last && is_blank(*p)) ++p;
    };
    std::array<double, 32> values{};
    std::uint32_t given = 0;
    for (const FormWord& word : form.words) {
        const char* letter = word.text.data();
        const char* const last = letter + word.text.size();
        for (skip(letter, last); letter != last; skip(letter, last)) {
            skip(at, end);
            if (at == end || *at != *letter) return false;
            ++at;
            ++letter;
        }
        if (word.parameter < 0 && !word.is_quantity) continue;
        skip(at, end);
        const Decimal decimal = parse_decimal(at, end);
        if (decimal.end == at) return false;
        at = decimal.end;
        if (word.is_quantity) {
            if (!is_quantity(word, decimal.value, argument_format(tables_), units_)) return false;
            continue;
        }
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const double scale = text_scale(word.dimension, units_, false);
        const double value = (decimal.value / scale - word.offset) / word.factor;
        const bool is_given = (given >> parameter & 1u) != 0;
        if (is_given && value != values[parameter]) return false;
        values[parameter] = value;
        given |= 1u << parameter;
    }
    skip(at, end);
    if (at != end) return false;
    for (const Constraint& c : form.when) {
        const double value = values[static_cast<std::size_t>(c.parameter)];
        if (value < c.least || value > c.most) return false;
    }
    const std::size_t count = tables_.parameters(form).size();
    Invocation* invocation = block.add(form.function, count);
    if (invocation == nullptr) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if ((given >> i & 1u) != 0) block.set_argument(*invocation, i, values[i]);
    }
    for (const auto& [parameter, value] : form.fixed) {
        block.set_argument(*invocation, static_cast<std::size_t>(parameter), value);
    }
    return true;
}

Done LineReader::read_slow(std::string_view line, Block& block) {
    if (read_verbatim(line, block)) return kDone;
    lexed_ = &own_lexed_;
    if (auto fault = lex_line(tables_, line, own_lexed_)) {
        report(line, *fault);
        return kFailed;
    }
    if (knows_masters_) name_spindles(own_lexed_);
    if (!lexed_->label.empty()) {
        if (lexed_->words.empty()) {
            block.skip = lexed_->skip;
            block.number = lexed_->number;
            block.comment = lexed_->comment;
            block.kind = Block::Kind::Label;
            block.text = lexed_->label;
            return kDone;
        }
        report(line,
               LineFault{&diag::IsoNotSupported, lexed_->spans[0], {"a label in front of words"}});
        return kFailed;
    }
    return fill(line, block);
}

/// The words of `lexed_` as a block.
Done LineReader::fill(std::string_view line, Block& block, MatchedLine* known,
                      const ControlLine* compiled) {
    block.skip = lexed_->skip;
    block.further_skip_levels = lexed_->further_skip_levels;
    block.number = lexed_->number;
    block.comment = lexed_->comment;
    block.text = lexed_->text;
    if (lexed_->comment_form != kNoForm) {
        tables_.note(&tables_.forms[lexed_->comment_form]);
        block.add(tables_.forms[lexed_->comment_form].function);
    }
    say_passed(*lexed_, line);
    if (lexed_->words.empty()) {
        // A number, a comment or both say nothing that a control could execute.
        if (block.function_count == 0 && lexed_->passed.empty()) block.kind = Block::Kind::Comment;
        return kDone;
    }
    if (!check_code_points(line)) return kFailed;
    if (const auto fault =
            match_words(tables_, lexed_->words, lexed_->arguments, modal_, block, match_)) {
        if (const PassedWord* passed = passed_beside(*fault)) {
            pass(*fault, *passed, line);
            block.reset();
            return fill(line, block, known, compiled);
        }
        report(line, *fault);
        return kFailed;
    }
    if (known != nullptr) remember(*compiled, block, *known);
    return apply(block, line);
}

void LineReader::say_passed(const LexedLine& words, std::string_view line) {
    for (const LexedLine::Passed& passed : words.passed) {
        if (!passed.word->is_said || !said_passed_.insert(passed.word).second) continue;
        const Span& span = passed.span;
        DiagnosticBuilder builder =
            sink_.report(diag::WordPassed, place(line, line_number_, passed.span));
        builder.arg(line.substr(span.begin, span.end - span.begin)).arg(passed.word->meaning);
        write_notes(builder);
    }
}

/// What a word that no form takes is to another one of the block, as P to the function of the
/// machine in `M59 P10`; null: it belongs to none.
const PassedWord* LineReader::passed_beside(const MatchFault& fault) const {
    if (fault.kind != MatchFault::Kind::Unused && fault.kind != MatchFault::Kind::Value)
        return nullptr;
    const GivenWord& word = lexed_->words[fault.word];
    const std::string front = tables_.addresses[word.address].name + '@';
    const auto first = tables_.passed.lower_bound(front);
    if (first == tables_.passed.end() || !first->first.starts_with(front)) return nullptr;
    const PassedWord* found = nullptr;
    for (const GivenWord& other : lexed_->words) {
        const Address& address = tables_.addresses[other.address];
        std::string name = address.name;
        if (address.kind == Address::Kind::Code) {
            const Code* const code =
                other.is_known ? tables_.find_code(other.address, other.number) : nullptr;
            const Function said = code == nullptr ? Function::MachineFunction
                                                  : tables_.forms[code->forms[0]].function;
            name = info(said).name;
        }
        const auto rule = tables_.passed.find(front + name);
        if (&other != &word && rule != tables_.passed.end() && found == nullptr)
            found = &rule->second;
    }
    // What is said of several words is said once.
    for (auto same = first; found != nullptr && same->first.starts_with(front); ++same) {
        if (same->second.meaning != found->meaning) continue;
        found = &same->second;
        break;
    }
    return found;
}

/// The block is read without the word.
void LineReader::pass(const MatchFault& fault, const PassedWord& found, std::string_view line) {
    lexed_->words[fault.word].is_left_out = true;
    const auto is_known = [&](const LexedLine::Passed& passed) { return passed.word == &found; };
    if (std::ranges::none_of(lexed_->passed, is_known))
        lexed_->passed.push_back({lexed_->spans[fault.word], &found});
    say_passed(*lexed_, line);
}

/// Puts the numbers where they belong. The block's own changes of units act in it already.
Done LineReader::apply(Block& block, std::string_view line) {
    for (std::size_t i = 0; i < match_.form_count; ++i) {
        note_form(match_.forms[i], line);
    }
    const ModalFunctions before = modal_;
    follow_modal(tables_.rules, block, modal_);
    follow_units();
    block.has_inch_feed = units_.inch_feed;
    Done applied = kDone;
    for (std::size_t i = 0; i < match_.claim_count && applied; ++i) {
        applied = apply_claim(match_.claims[i], block, line);
    }
    if (!applied) modal_ = before;
    if (const Invocation* master = block.find(Function::MasterSpindle)) {
        knows_masters_ = true;
        has_other_master_ =
            block.argument(*master, parameter_of<Function::MasterSpindle>("spindle"), 1) != 1;
    }
    return applied;
}

/// What a form that was read leaves behind for the lines that follow.
void LineReader::note_form(FormId id, std::string_view line) {
    const Form& form = tables_.forms[id];
    tables_.note(&form);
    if (info(form.function).group == Group::Units) feed_stays_metric_ = form.feed_stays_metric;
    if (info(form.function).group == Group::FeedMode) feed_is_time_ = form.feed_is_time;
    if (form.group >= 0) last_forms_[static_cast<std::size_t>(form.group)] = id;
    if (form.function == Function::Cycle && !form.is_preset)
        last_cycle_ = tables_.cycles[form.cycle].is_modal ? id : kNoForm;
    const bool is_told = form.passed.empty() || std::ranges::find(passed_, id) != passed_.end();
    if (is_told) return;
    passed_.push_back(id);
    const Span span = span_of_form(form, line);
    DiagnosticBuilder message = sink_.report(diag::IsoPassedOver, place(line, line_number_, span));
    message.arg(std::string(line.substr(span.begin, span.end - span.begin))).arg(form.passed);
    write_notes(message);
}

/// Where the first word of the form stands.
Span LineReader::span_of_form(const Form& form, std::string_view line) const {
    for (std::size_t i = 0; i < lexed_->words.size(); ++i) {
        const GivenWord& word = lexed_->words[i];
        if (word.address == form.words[0].address && word.number == form.words[0].number)
            return lexed_->spans[i];
    }
    return {0, static_cast<std::uint32_t>(line.size())};
}

/// Codes that have no decimals stand without a point; none has a sign, or begins with the point.
/// Notes the M code on the way.
Done LineReader::check_code_points(std::string_view line) {
    for (std::size_t i = 0; i < lexed_->words.size(); ++i) {
        const GivenWord& word = lexed_->words[i];
        const Address& address = tables_.addresses[word.address];
        if (address.kind != Address::Kind::Code || word.is_left_out) continue;
        if (word.is_known && address.name == "M") machine_code_ = word.number;
        if (!word.is_known || word.is_computed) continue;
        const std::string text = word_text(line, i);
        const std::size_t first = text.find_first_not_of(" \t", address.name.size());
        const bool has_sign = first != text.npos && (text[first] == '-' || text[first] == '+');
        const bool has_point =
            lexed_->decimals[i].has_point && (address.format.point == PointRule::Never ||
                                              (first != text.npos && text[first] == '.'));
        if (!has_sign && !has_point) continue;
        const DiagnosticRow& row = has_sign ? diag::IsoMinusNotAllowed : diag::IsoPointNotAllowed;
        report(line, LineFault{&row, lexed_->spans[i], {text}});
        return kFailed;
    }
    return kDone;
}

Done LineReader::apply_claim(const Claim& claim, Block& block, std::string_view line) {
    const GivenWord& word = lexed_->words[claim.word];
    Invocation* invocation = claim.is_parameter ? &block.functions[claim.invocation] : nullptr;
    if (claim.dimension == Dimension::Text) return kDone;
    if (claim.argument >= 0) {
        const double number =
            lexed_->arguments[word.first_argument + static_cast<std::size_t>(claim.argument)]
                .number;
        const double value =
            (number / text_scale(claim.dimension, units_, false) - claim.offset) / claim.factor;
        // A clearance is entered without its sign (S 9.1 SDIS).
        const double sum =
            claim.adds ? block.argument(*invocation, claim.parameter) + std::fabs(value) : value;
        block.set_argument(*invocation, claim.parameter, sum);
        return kDone;
    }
    if (word.is_text && !word.is_known) return kDone;  // a name; it stands in the block's text
    if (word.is_text) block.text.clear();
    if (claim.is_named_only) {
        block.set_argument(*invocation, claim.parameter, 0);
        return kDone;
    }
    const Decimal& decimal = lexed_->decimals[claim.word];
    if (claim.in_increments || claim.tail_digits > 0) return apply_whole(claim, block, line);
    const NumberFormat& own = tables_.addresses[word.address].format;
    std::optional<NumberFormat> lead;
    if (claim.is_lead || (invocation == nullptr && is_pitch(claim, block))) lead = lead_format(own);
    const NumberFormat& format = lead ? *lead : own;
    // A plain factor below 0: the digits are the number, whatever one without a point means.
    const bool takes_digits = claim.plain_factor < 0;
    const double meaning = takes_digits ? decimal.value
                           : word.is_computed
                               ? rounded(decimal.value, format, claim.dimension)
                               : read_meaning(decimal, format, claim.dimension, units_);
    Decimal written = decimal;
    if (word.is_computed) written.has_point = format.point != PointRule::Never;
    const bool is_plain = claim.plain_factor > 0 && !decimal.has_point;
    const double factor = is_plain ? claim.plain_factor : claim.factor;
    const NumberFault fault =
        check_read(written, lexed_->minus[claim.word], takes_digits ? 0 : meaning, format,
                   claim.dimension, units_);
    if (fault != NumberFault::None) {
        const DiagnosticRow& row = fault == NumberFault::Point      ? diag::IsoPointNotAllowed
                                   : fault == NumberFault::Negative ? diag::IsoMinusNotAllowed
                                                                    : diag::IsoTooManyDigits;
        report(line, LineFault{&row, lexed_->spans[claim.word], {word_text(line, claim.word)}});
        return kFailed;
    }
    if (invocation == nullptr) {
        const auto slot = static_cast<Slot>(claim.place);
        if (points_.is_open() && is_place(slot)) watch_point(claim, line);
        const double scale = text_scale(claim.dimension, units_, true);
        const bool is_time = feed_is_time_ && slot == Slot::Feed && units_.inverse_time;
        constexpr double kMinute = 60;  // s; feeds under inverse time are 1/min
        block.set(slot, is_time && meaning != 0 ? kMinute / meaning
                        : scale == 1            ? meaning
                                                : meaning / scale);
        return kDone;
    }
    // What a block sets for cycles behind it are strokes and allowances: `G71 U2000 R500`.
    const bool is_preset = invocation->function == Function::CyclePreset;
    if (points_.is_open() && !is_preset && is_place(claim)) watch_point(claim, line);
    const double scaled = meaning / text_scale(claim.dimension, units_, false);
    block.set_argument(*invocation, claim.parameter, (scaled - claim.offset) / factor);
    return kDone;
}

/// Whether the word of a function is a place or a size at the part, as Z and R of a cycle, `,R`, or
/// X of G52. Strokes and allowances have their whole numbers by custom: `Q5000`, `U400`.
bool LineReader::is_place(const Claim& claim) const {
    if (claim.dimension != Dimension::Length) return false;
    const std::string& name = tables_.addresses[lexed_->words[claim.word].address].name;
    return name.size() <= 2 && std::string_view("XYZRC").find(name.back()) != std::string::npos;
}

/// Whether the word is F of a thread, where F is the pitch.
bool LineReader::is_pitch(const Claim& claim, const Block& block) const {
    if (static_cast<Slot>(claim.place) != Slot::Feed || !feed_is_pitch_) return false;
    const Function modal = modal_[static_cast<std::size_t>(Group::Motion)];
    const Function motion = block.motion != Function::None ? block.motion : modal;
    return motion == Function::Thread || has_fact(motion, Fact::VaryingThread) ||
           has_fact(motion, Fact::ArcThread);
}

/// A whole number that counts increments, or holds two parameters.
Done LineReader::apply_whole(const Claim& claim, Block& block, std::string_view line) {
    Decimal decimal = lexed_->decimals[claim.word];
    if (lexed_->words[claim.word].is_computed) {
        decimal.value = std::round(decimal.value);
        decimal.has_point = false;
    }
    const GivenWord& word = lexed_->words[claim.word];
    const int most_digits = tables_.addresses[word.address].format.max_digits;
    const bool is_long = !word.is_computed && most_digits != 0 && decimal.digits > most_digits;
    const DiagnosticRow* fault = decimal.has_point           ? &diag::IsoPointNotAllowed
                                 : lexed_->minus[claim.word] ? &diag::IsoMinusNotAllowed
                                 : is_long                   ? &diag::IsoTooManyDigits
                                                             : nullptr;
    if (fault != nullptr) {
        report(line, LineFault{fault, lexed_->spans[claim.word], {word_text(line, claim.word)}});
        return kFailed;
    }
    Invocation& invocation = block.functions[claim.invocation];
    if (claim.in_increments) {
        const double size = increment_size(tables_, claim.dimension, units_);
        const double value = decimal.value * size / text_scale(claim.dimension, units_, false);
        block.set_argument(invocation, claim.parameter, round_to(value, 9));
        return kDone;
    }
    const double front = std::pow(10.0, claim.tail_digits);
    block.set_argument(invocation, claim.parameter, std::floor(decimal.value / front));
    if (claim.tail_parameter >= 0) {
        block.set_argument(invocation, static_cast<std::size_t>(claim.tail_parameter),
                           std::fmod(decimal.value, front));
    }
    return kDone;
}

// ---------------------------------------------------------------- modal state

void LineReader::follow(const Block& block) {
    if (block.kind != Block::Kind::Nc) return;
    follow_modal(tables_.rules, block, modal_);
    if (block.skip < 0) return;
    // Nobody knows here whether the operator lets the block run.
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Group group = info(block.functions[i].function).group;
        const bool scales =
            group == Group::Units || group == Group::FeedMode || group == Group::SpeedMode;
        if (!scales) modal_[static_cast<std::size_t>(group)] = Function::None;
    }
}

void LineReader::restore(const ModalFunctions& wanted, Block& block) {
    for (std::size_t i = 1; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if (wanted[i] == modal_[i] || wanted[i] == Function::None) continue;
        // The spindle and the coolant run on; offsets come back with the frames.
        const bool is_state = group == Group::Spindle || group == Group::Coolant ||
                              group == Group::WorkOffsets || group == Group::LengthComp ||
                              group == Group::CycleMode || group == Group::SpeedMode;
        if (is_state) continue;
        if (group == Group::Motion) {
            block.motion = wanted[i];
        } else {
            block.add(wanted[i]);
        }
    }
    follow_modal(tables_.rules, block, modal_);
    follow_units();
}

void LineReader::follow_units() {
    const auto active = [&](Group group) { return modal_[static_cast<std::size_t>(group)]; };
    units_.inch = active(Group::Units) == Function::Inch;
    units_.inch_feed = units_.inch && !feed_stays_metric_;
    units_.per_revolution = active(Group::FeedMode) == Function::FeedPerRevolution;
    units_.inverse_time = active(Group::FeedMode) == Function::FeedInverseTime;
    units_.cutting_speed = active(Group::SpeedMode) == Function::CuttingSpeedOn;
    for (std::size_t i = 0; i < slot_scales_.size(); ++i)
        slot_scales_[i] = text_scale(static_cast<Dimension>(i), units_, true);
}

}  // namespace kadr::nc
