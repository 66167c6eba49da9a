// Words of source blocks → BlockPlan, with the tables of the input dialect.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/done.h"
#include "base/numbers.h"
#include "base/text.h"
#include "nc/lost_words.h"
#include "nc/match.h"
#include "nc/number_text.h"

namespace kadr::nc {

namespace {

/// The cycle of a form that no block of a source can be.
void report_cycle(std::string_view name, const SourceRange& range, const DialectTables& tables,
                  CycleId cycle, DiagnosticSink& sink) {
    auto report = std::move(sink.report(diag::SourceCycle, range).arg(name));
    const AddressId word = tables.find_address(name);
    const bool is_call = word != kNoAddress && tables.addresses[word].kind == Address::Kind::Call;
    if (is_call && tables.forms_of_cycle[cycle].empty()) {
        // Its name would be that of what the interpreter runs, with levels and masks of this
        // control.
        report.fix(
            "say it with the library's cycles, which every control understands: holes in a "
            "row, a circle or a grid, pockets, slots, spigots, threads, turning");
        return;
    }
    const std::string advice =
        "call the library's `" + tables.cycles[cycle].name + "` at each position: ";
    if (tables.forms_of_cycle[cycle].empty())
        report.fix(advice + "it says what this cycle leaves open");
    else report.fix(advice + "it is written as the control's own cycle");
}

/// The form as a person writes it: names of a call's parameters, and numbers where they are fixed.
std::string shown(const Form& form) {
    const std::string pattern = first_line(form);
    std::string out;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::size_t open = std::min(pattern.find('{', at), pattern.size());
        out.append(pattern, at, open - at);
        if (open == pattern.size()) break;
        const std::size_t close = std::min(pattern.find('}', open), pattern.size());
        std::string hole = pattern.substr(open + 1, close - open - 1);
        hole.resize(std::min(hole.find(':'), hole.size()));
        const std::size_t equal = hole.find('=');
        if (equal == 0) hole.erase(0, 1);  // `{=1:length}` is the number 1
        else hole.resize(std::min(equal, hole.size()));
        if (hole.ends_with('?')) hole.pop_back();
        if (hole.starts_with('+')) hole.erase(0, 1);
        const bool is_argument = open > 0 && (pattern[open - 1] == '(' || pattern[open - 1] == ',');
        out += is_argument ? hole : "…";
        at = close + 1;
    }
    return out;
}

/// The words of the pattern before its first hole, as the control spells them: `G05.1 Q1` of
/// `G05.1 Q1 R{?}`; empty if it begins with one.
std::string fixed_words(const Form& form) {
    std::string pattern = first_line(form);
    const std::size_t hole = pattern.find('{');
    if (hole == std::string::npos) return pattern;
    const std::size_t blank = pattern.rfind(' ', hole);
    pattern.resize(blank == std::string::npos ? 0 : blank);
    while (pattern.ends_with(' ')) pattern.pop_back();
    return pattern;
}

Hole hole_of(const Claim& claim, const DialectTables& tables) {
    Hole hole;
    hole.dimension = claim.dimension;
    hole.is_argument = claim.is_parameter;
    hole.index = claim.index;
    hole.invocation = claim.invocation;
    hole.parameter = claim.parameter;
    hole.adds = claim.adds;
    hole.factor = claim.in_increments ? increment_size(tables, claim.dimension, TextUnits{})
                                      : 1 / claim.factor;
    hole.offset = -claim.offset / claim.factor;
    return hole;
}

class BlockPlanner {
  public:
    BlockPlanner(const Dialect& dialect, std::span<const SourceWord> words, DiagnosticSink& sink)
        : dialect_(dialect), tables_(dialect.tables()), words_(words), sink_(sink) {}

    std::optional<BlockPlan> plan() {
        if (words_.size() > kMaxWords) {
            sink_.report(diag::BlockWordsTooMany, words_[0].range);
            return std::nullopt;
        }
        bool failed = false;
        for (std::size_t i = 0; i < words_.size(); ++i) failed |= !take(i);
        if (failed) return std::nullopt;
        const ModalFunctions unknown{};
        const Block before_match = plan_.block;  // its number and its level of `/`
        const auto fault = match_words(tables_, std::span(given_.data(), count_), {}, unknown,
                                       plan_.block, match_, WordsOf::Source);
        if (fault) {
            report(*fault);
            return std::nullopt;
        }
        if (!require_writable(match_)) return std::nullopt;
        plan_.planes = planes_of_meaning(before_match);
        for (std::size_t i = 0; i < match_.claim_count; ++i) add_hole(match_.claims[i]);
        if (!check_arc_words(std::span(match_.claims).first(match_.claim_count)))
            return std::nullopt;
        return std::move(plan_);
    }

    /// Behind plan(): the forms of which the plan keeps nothing, or not all.
    std::vector<LostWord> lost() const {
        std::vector<LostWord> found;
        for (std::size_t i = 0; i < match_.form_count; ++i) {
            const Form& form = tables_.forms[match_.forms[i]];
            const bool is_empty = form.function == Function::None && form.sets.empty();
            if (form.lost == "nothing" || (form.lost.empty() && !is_empty)) continue;
            const SourceWord& head = head_of(form);
            LostWord word{fixed_words(form), form.lost, head.range};
            if (word.text.empty()) word.text = text_of(head);
            if (word.why.empty()) word.why = "the language has no meaning for it";
            found.push_back(std::move(word));
        }
        return found;
    }

  private:
    std::string text_of(const SourceWord& word) const {
        std::string text(word.address);
        if (word.value == SourceWord::Value::Literal) append_shortest(text, word.number);
        return text;
    }

    Done take(std::size_t i) {
        const SourceWord& word = words_[i];
        const AddressId address = tables_.find_address(word.address);
        const bool is_removed = address != kNoAddress &&
                                tables_.addresses[address].kind == Address::Kind::Word &&
                                tables_.addresses[address].forms.empty();
        if (address == kNoAddress || is_removed) {
            report_unknown(word);
            return kFailed;
        }
        if (tables_.addresses[address].is_block_number) {
            if (word.value != SourceWord::Value::Literal) {
                sink_.report(diag::BlockWordCodeComputed, word.range).arg(word.address);
                return kFailed;
            }
            plan_.block.number = static_cast<std::int32_t>(word.number);
            return kDone;
        }
        GivenWord& given = given_[count_];
        given.address = address;
        given.has_value = word.value != SourceWord::Value::None;
        given.is_known = word.value == SourceWord::Value::Literal;
        given.number = word.number;
        given.mode = static_cast<GivenWord::Mode>(word.mode);
        source_[count_++] = i;
        return kDone;
    }

    /// What a control reads, but a block of a source cannot be: it would mean something else there.
    Done require_writable(const Match& match) {
        for (std::size_t i = 0; i < match.form_count; ++i) {
            const Form& form = tables_.forms[match.forms[i]];
            plan_.feed_stays_metric = plan_.feed_stays_metric || form.feed_stays_metric;
            const bool is_cycle = form.function == Function::Cycle;
            if (has_fact(form.function, Fact::ReadOnly) && form.function != Function::PolarOff) {
                report_read_only(head_of(form));
                return kFailed;
            }
            if (is_cycle && !form.is_preset && can_be_source(dialect_, form.cycle)) continue;
            if (!is_cycle && !form.feed_by_radius) continue;
            const SourceWord& word = head_of(form);
            if (is_cycle) {
                report_cycle(text_of(word), word.range, tables_, form.cycle, sink_);
            } else {
                sink_.report(diag::SourceInverseTime, word.range)
                    .arg(text_of(word))
                    .arg(tables_.name)
                    .fix("call `feed_inverse_time()`: then F is 1/min, of arcs too");
            }
            return kFailed;
        }
        for (std::size_t i = 0; i < match.claim_count; ++i) {
            const Claim& claim = match.claims[i];
            constexpr SlotMask kRefused = kReadSlots & ~kPolarSlots;
            if (claim.is_parameter || (kRefused >> claim.index & 1u) == 0) continue;
            report_read_only(words_[source_[claim.word]]);
            return kFailed;
        }
        return kDone;
    }

    void report_read_only(const SourceWord& word) {
        sink_.report(diag::SourceReadOnly, word.range).arg(text_of(word));
    }

    /// In which planes the words mean what they were taken for: `ROT X30` turns the plane Y-Z, and
    /// is a rotation in space in the others.
    PlaneMask planes_of_meaning(const Block& before_match) const {
        const bool depends = std::ranges::any_of(
            std::span(match_.forms).first(match_.form_count), [&](const FormId id) {
                return std::ranges::any_of(tables_.forms[id].during, [](Function needed) {
                    return info(needed).group == Group::Plane;
                });
            });
        if (!depends) return kAllPlanes;
        PlaneMask planes = 0;
        for (std::size_t i = 0; i < kFunctions; ++i) {
            const auto plane = static_cast<Function>(i);
            if (info(plane).group != Group::Plane) continue;
            ModalFunctions modal{};
            modal[static_cast<std::size_t>(Group::Plane)] = plane;
            Block block = before_match;
            Match match;
            const auto fault = match_words(tables_, std::span(given_.data(), count_), {}, modal,
                                           block, match, WordsOf::Source);
            if (!fault && block == plan_.block && has_same_claims(match))
                planes |= bit_of_plane(plane);
        }
        return planes;
    }

    bool has_same_claims(const Match& other) const {
        const auto claims = [](const Match& match) {
            return std::span(match.claims).first(match.claim_count);
        };
        return std::ranges::equal(
            claims(other), claims(match_), [](const Claim& a, const Claim& b) {
                return a.word == b.word && a.is_parameter == b.is_parameter && a.index == b.index;
            });
    }

    /// The word that a form begins with.
    const SourceWord& head_of(const Form& form) const {
        for (std::size_t i = 0; i < count_; ++i) {
            const FormWord& head = form.words[0];
            if (given_[i].address != head.address) continue;
            const bool is_any = head.kind == FormWord::Kind::Value;
            if (is_any || std::fabs(given_[i].number - head.number) < 1e-9)
                return words_[source_[i]];
        }
        return words_[0];
    }

    void report_unknown(const SourceWord& word) {
        std::vector<std::string_view> names;
        for (const Address& address : tables_.addresses) {
            const bool is_removed = address.kind == Address::Kind::Word && address.forms.empty();
            if (!address.name.empty() && address.kind != Address::Kind::Call && !is_removed)
                names.push_back(address.name);
        }
        auto report = std::move(
            sink_.report(diag::BlockWordUnknown, word.range).arg(text_of(word)).arg(tables_.name));
        const std::string upper = upper_ascii(word.address);
        if (const auto near = nearest_name(upper, names.data(), names.size())) {
            report.fix("is `" + std::string(*near) + "` meant?");
        }
    }

    void add_hole(const Claim& claim) {
        const std::size_t word = source_[claim.word];
        const SourceWord& source = words_[word];
        if (claim.is_parameter && claim.is_named_only) {
            plan_.block.set_argument(plan_.block.functions[claim.invocation], claim.parameter, 0);
            return;
        }
        const double value = (source.number - claim.offset) / claim.factor;
        const bool is_literal = source.value == SourceWord::Value::Literal;
        if (claim.is_parameter && claim.tail_digits == 0 && claim.dimension == Dimension::Count &&
            is_literal) {
            plan_.block.set_argument(plan_.block.functions[claim.invocation], claim.parameter,
                                     value);
            return;
        }
        if (claim.tail_digits > 0) return take_apart(claim, source);
        Hole hole = hole_of(claim, tables_);
        hole.word = static_cast<std::uint16_t>(word);
        plan_.holes.push_back(hole);
    }

    /// A number in two parts: `T0101` is tool 1 with offset 1.
    void take_apart(const Claim& claim, const SourceWord& source) {
        if (source.value != SourceWord::Value::Literal) {
            sink_.report(diag::BlockWordCodeComputed, source.range).arg(source.address);
            return;
        }
        Invocation& invocation = plan_.block.functions[claim.invocation];
        const double front = std::pow(10.0, claim.tail_digits);
        plan_.block.set_argument(invocation, claim.parameter, std::floor(source.number / front));
        if (claim.tail_parameter < 0) return;
        plan_.block.set_argument(invocation, static_cast<std::size_t>(claim.tail_parameter),
                                 std::fmod(source.number, front));
    }

    /// Words of arcs beside a motion that is none, as far as the block itself programs its motion.
    Done check_arc_words(std::span<const Claim> claims) {
        const Function motion = plan_.block.motion;
        const bool is_straight = has_fact(motion, Fact::Straight);
        const auto slot_of = [](const Claim& claim) { return static_cast<Slot>(claim.index); };
        const Claim* radius = nullptr;
        const Claim* center = nullptr;
        Done checked = kDone;
        for (const Claim& claim : claims) {
            if (claim.is_parameter || (bit(slot_of(claim)) & kArcSlots) == 0) continue;
            if (slot_of(claim) == Slot::Radius) radius = &claim;
            if ((bit(slot_of(claim)) & kCenterSlots) != 0) center = &claim;
            if (!is_straight) continue;  // the centre word of a tapping motion is its pitch
            const SourceWord& word = words_[source_[claim.word]];
            sink_.report(diag::ArcWordWithoutArc, word.range)
                .arg(text_of(word))
                .arg(info(motion).name);
            checked = kFailed;
        }
        if (!checked || radius == nullptr || center == nullptr) return checked;
        sink_.report(diag::ArcSaidTwice, words_[source_[radius->word]].range)
            .note(words_[source_[center->word]].range, "the centre");
        return kFailed;
    }

    void report(const MatchFault& fault) {
        using Kind = MatchFault::Kind;
        const SourceWord& word = words_[source_[fault.word]];
        const SourceWord& other = words_[source_[fault.other]];
        const std::string text = text_of(word);
        const std::string form = fault.form == kNoForm ? "" : shown(tables_.forms[fault.form]);
        switch (fault.kind) {
            case Kind::UnknownCode: report_code(word); break;
            case Kind::CodeComputed:
                sink_.report(diag::BlockWordCodeComputed, word.range).arg(word.address);
                break;
            case Kind::NoValue:
            case Kind::NoNumber:
                sink_.report(diag::BlockWordNeedsValue, word.range).arg(text);
                break;
            case Kind::AddressTwice:
                sink_.report(diag::BlockWordTwice, word.range)
                    .arg(word.address)
                    .note(other.range, "first here");
                break;
            case Kind::GroupTwice:
                sink_.report(diag::BlockWordGroupTwice, word.range)
                    .arg(text)
                    .arg(text_of(other))
                    .note(other.range, "the other one");
                break;
            case Kind::Missing:
                sink_.report(diag::BlockWordMissing, word.range).arg(text).arg(form);
                break;
            case Kind::Value:
            case Kind::NotSupported:
                sink_.report(diag::BlockWordValueWrong, word.range).arg(text).arg(form);
                break;
            case Kind::Conflict:
            case Kind::Company:
                sink_.report(diag::BlockWordConflict, word.range)
                    .arg(text)
                    .arg(text_of(other))
                    .note(other.range, "the other one");
                break;
            case Kind::Unused: sink_.report(diag::BlockWordUnused, word.range).arg(text); break;
            case Kind::Alone: sink_.report(diag::BlockWordAlone, word.range).arg(text); break;
            case Kind::Mode:
                sink_.report(diag::BlockWordModeMisplaced, word.range).arg(word.address);
                break;
            case Kind::Full: sink_.report(diag::BlockWordsTooMany, word.range); break;
        }
    }

    /// A code with a number like it means something else altogether: none is proposed.
    void report_code(const SourceWord& word) {
        const std::string code = text_of(word);
        const std::vector<CallForm>& calls = tables_.language.calls.calls;
        const bool is_call = std::ranges::any_of(
            calls, [&](const CallForm& call) { return !call.is_name && call.code == code; });
        if (is_call) {
            sink_.report(diag::SourceSubprogram, word.range)
                .arg(code)
                .fix(
                    "make a cycle or a function of the subprogram, and call it by its name: "
                    "`import` brings it in from another file");
            return;
        }
        sink_.report(diag::BlockWordCodeUnknown, word.range).arg(text_of(word)).arg(tables_.name);
    }

    const Dialect& dialect_;
    const DialectTables& tables_;
    std::span<const SourceWord> words_;
    DiagnosticSink& sink_;
    BlockPlan plan_;
    Match match_;
    std::array<GivenWord, kMaxWords> given_;
    std::array<std::size_t, kMaxWords> source_{};
    std::size_t count_ = 0;
};

}  // namespace

std::optional<BlockPlan> plan_block(const Dialect& dialect, std::span<const SourceWord> words,
                                    DiagnosticSink& sink) {
    return BlockPlanner(dialect, words, sink).plan();
}

std::vector<LostWord> lost_words(const Dialect& dialect, std::span<const SourceWord> words) {
    DiagnosticList unheard;
    BlockPlanner planner(dialect, words, unheard);
    if (!planner.plan()) return {};
    return planner.lost();
}

namespace {

/// What the manual calls the arguments of a call; empty if the dialect does not have it.
std::span<const std::string> argument_names(const DialectTables& tables, AddressId call) {
    for (const FormId id : tables.addresses[call].forms) {
        if (!tables.forms[id].names.empty()) return tables.forms[id].names;
    }
    return {};
}

/// `CYCLE84(RTP, RFP, …)`.
std::string shown_call(std::string_view name, std::span<const std::string> arguments) {
    std::string out(name);
    for (std::size_t i = 0; i < arguments.size(); ++i) out += (i == 0 ? "(" : ", ") + arguments[i];
    return out + ')';
}

}  // namespace

std::optional<BlockPlan> plan_call(const Dialect& dialect, std::string_view name,
                                   const SourceRange& range,
                                   std::span<const SourceArgument> arguments,
                                   DiagnosticSink& sink) {
    const DialectTables& tables = dialect.tables();
    const CallMeaning meaning = call_meaning(dialect, name);
    if (meaning.function != Function::Cycle || !can_be_source(dialect, meaning.cycle)) {
        report_cycle(name, range, tables, meaning.cycle, sink);
        return std::nullopt;
    }
    if (arguments.size() > kMaxCallArguments) {
        sink.report(diag::BlockWordsTooMany, range);
        return std::nullopt;
    }
    std::array<GivenArgument, kMaxCallArguments> given{};
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        given[i].kind = static_cast<GivenArgument::Kind>(arguments[i].kind);
        given[i].number = arguments[i].number;
    }
    GivenWord word;
    word.address = tables.find_address(name);
    word.is_call = true;
    word.argument_count = static_cast<std::uint16_t>(arguments.size());
    BlockPlan plan;
    Match match;
    const auto fault = match_words(tables, std::span(&word, 1), std::span(given), ModalFunctions{},
                                   plan.block, match, WordsOf::Source);
    if (fault) {
        const auto at = static_cast<std::size_t>(std::max(fault->argument, 0));
        const bool is_written = fault->argument >= 0 && at < arguments.size() &&
                                arguments[at].kind != SourceArgument::Kind::Empty;
        const SourceRange location = is_written ? arguments[at].range : range;
        const std::span<const std::string> names = argument_names(tables, word.address);
        std::string what = is_written ? "argument " + std::to_string(at + 1) : std::string(name);
        if (is_written && at < names.size()) what = names[at];
        std::string form = fault->form == kNoForm ? "" : shown(tables.forms[fault->form]);
        if (!names.empty()) form = shown_call(name, names);
        sink.report(diag::BlockWordValueWrong, location).arg(what).arg(form);
        return std::nullopt;
    }
    for (std::size_t i = 0; i < match.claim_count; ++i) {
        Hole hole = hole_of(match.claims[i], tables);
        hole.word = static_cast<std::uint16_t>(match.claims[i].argument);
        plan.holes.push_back(hole);
    }
    return plan;
}

std::optional<CycleId> cycle_of(const Dialect& dialect, std::string_view address, double number) {
    const DialectTables& tables = dialect.tables();
    const AddressId id = tables.find_address(address);
    if (id == kNoAddress || tables.addresses[id].kind != Address::Kind::Code) return std::nullopt;
    const CodeStart* code = tables.find_code(id, number);
    if (code == nullptr) return std::nullopt;
    for (const FormId form : code->forms) {
        if (tables.forms[form].function == Function::Cycle) return tables.forms[form].cycle;
    }
    return std::nullopt;
}

std::optional<CycleId> cycle_of_word(const Dialect& dialect, std::string_view word) {
    const CallMeaning call = call_meaning(dialect, word);
    if (call.function == Function::Cycle) return call.cycle;
    const std::size_t digits = std::min(word.find_first_of("0123456789"), word.size());
    double number = 0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data() + digits, end, number);
    if (digits == word.size() || read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return cycle_of(dialect, word.substr(0, digits), number);
}

bool can_be_source(const Dialect& dialect, CycleId cycle) {
    return !dialect.tables().cycles[cycle].module.empty();
}

PlainNumber plain_number(const Dialect& dialect, std::string_view address, bool is_inch) {
    const DialectTables& tables = dialect.tables();
    const AddressId id = tables.find_address(address);
    if (id == kNoAddress || tables.addresses[id].kind != Address::Kind::Value) return {};
    const NumberFormat& format = tables.addresses[id].format;
    PlainNumber plain;
    if (format.increment != 0) plain.time = format.increment;
    if (is_inch && format.inch_increment != 0) plain.time = format.inch_increment;
    plain.revolution = format.revolution_increment != 0 ? format.revolution_increment : plain.time;
    return plain;
}

CallMeaning call_meaning(const Dialect& dialect, std::string_view name) {
    const DialectTables& tables = dialect.tables();
    const AddressId id = tables.find_address(name);
    if (id == kNoAddress || tables.addresses[id].kind != Address::Kind::Call) return {};
    if (tables.addresses[id].forms.empty()) return {};
    const Form& form = tables.forms[tables.addresses[id].forms[0]];
    return {form.function, form.cycle};
}

WordKind word_kind(const Dialect& dialect, std::string_view identifier) {
    const DialectTables& tables = dialect.tables();
    if (!tables.notation.modal_call.empty() && identifier == tables.notation.modal_call)
        return WordKind::Word;
    const AddressId id = tables.find_address(identifier);
    if (id == kNoAddress) return WordKind::None;
    switch (tables.addresses[id].kind) {
        case Address::Kind::Value:
        case Address::Kind::Code: return WordKind::Address;
        case Address::Kind::Word: return WordKind::Word;
        case Address::Kind::Call:
            return tables.addresses[id].is_word_too ? WordKind::Word : WordKind::Call;
    }
    return WordKind::None;
}

}  // namespace kadr::nc
