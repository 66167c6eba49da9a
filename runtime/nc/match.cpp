#include "nc/match.h"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "nc/builder_codes.h"
#include "nc/center_words.h"
#include "nc/number_text.h"

namespace kadr::nc {

namespace {

using Fault = std::optional<MatchFault>;
using WordSet = std::bitset<kMaxWords>;

bool near(double a, double b) { return std::fabs(a - b) < 1e-9; }

/// How well a form fits the words that are left.
struct FormFit {
    enum class Answer : std::uint8_t { Yes, Missing, Value, Mode };
    Answer answer = Answer::Yes;
    std::size_t matched = 0;        // words of the block that it takes
    std::size_t culprit = 0;        // word of the block, for Value and Mode
    int argument = -1;              // … of a call
    bool is_idle = false;           // the modal functions are not active that it needs
    bool is_of_other_word = false;  // a word has another fixed number: L11 where the form has L10
    WordSet taken;
};

class Matcher {
  public:
    Matcher(const DialectTables& tables, std::span<const GivenWord> words,
            std::span<const GivenArgument> arguments, const ModalFunctions& modal, Block& block,
            Match& match, WordsOf words_of)
        : tables_(tables),
          words_(words),
          arguments_(arguments),
          modal_(modal),
          block_(block),
          match_(match),
          words_of_(words_of) {}

    Fault run() {
        if (words_.size() > kMaxWords) return MatchFault{MatchFault::Kind::Full};
        for (std::size_t i = 0; i < words_.size(); ++i) used_[i] = words_[i].is_left_out;
        if (Fault fault = check_repeated_addresses()) return fault;
        if (Fault fault = check_repeated_groups()) return fault;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (Fault fault = take_head(i)) return fault;
        }
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (Fault fault = take_value(i)) return fault;
        }
        if (Fault fault = cancel_cycle()) return fault;
        order_functions();
        if (Fault fault = check_cycle()) return fault;
        return check_alone();
    }

  private:
    const Address& address(std::size_t i) const { return tables_.addresses[words_[i].address]; }
    bool is_code(std::size_t i) const { return address(i).kind == Address::Kind::Code; }

    // ------------------------------------------------------------ words given twice

    Fault check_repeated_addresses() {
        for (std::size_t i = 1; i < words_.size(); ++i) {
            if (used_[i]) continue;
            std::size_t count = 1;
            std::size_t first = i;
            for (std::size_t j = i; j-- > 0;) {
                if (words_[j].address != words_[i].address || used_[j]) continue;
                ++count;
                first = j;
            }
            if (count <= address(i).read_max) continue;
            // A function is never dropped: which of too many the control would take is its
            // builder's choice.
            if (tables_.notation.address == Repeated::Alarm || is_code(i)) {
                return MatchFault{MatchFault::Kind::AddressTwice, i, first};
            }
            used_[first] = true;
        }
        if (tables_.notation.address == Repeated::LastWins) drop_earlier_places();
        return {};
    }

    /// X and U of a lathe name one axis; where the last of two words counts, it does of these.
    void drop_earlier_places() {
        if (!tables_.has_incremental_letters) return;
        for (std::size_t i = 1; i < words_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const bool is_same = !used_[i] && !used_[j] && address(i).slot >= 0 &&
                                     address(i).slot == address(j).slot;
                if (is_same && address(i).is_incremental != address(j).is_incremental)
                    used_[j] = true;
            }
        }
    }

    int group_of(std::size_t i) const {
        const Address& head = address(i);
        if (head.kind == Address::Kind::Word || head.kind == Address::Kind::Call) {
            return head.forms.empty() ? -1 : tables_.forms[head.forms[0]].group;
        }
        if (!words_[i].is_known) return -1;
        const CodeStart* code = tables_.find_code(words_[i].address, words_[i].number);
        return code == nullptr ? -1 : tables_.forms[code->forms[0]].group;
    }

    Fault check_repeated_groups() {
        for (std::size_t i = 1; i < words_.size(); ++i) {
            const int group = used_[i] ? -1 : group_of(i);
            if (group < 0 || tables_.groups[static_cast<std::size_t>(group)].stands_together)
                continue;
            for (std::size_t j = 0; j < i; ++j) {
                if (used_[j] || group_of(j) != group) continue;
                if (tables_.notation.group == Repeated::Alarm) {
                    return MatchFault{MatchFault::Kind::GroupTwice, i, j};
                }
                used_[j] = true;
            }
        }
        return {};
    }

    // ------------------------------------------------------------ heads of forms

    Fault take_head(std::size_t i) {
        if (used_[i]) return {};
        const GivenWord& word = words_[i];
        const Address& head = address(i);
        if (head.kind == Address::Kind::Word || head.kind == Address::Kind::Call) {
            return take_form(i, head.forms);
        }
        if (head.kind == Address::Kind::Code) {
            if (!word.has_value) return MatchFault{MatchFault::Kind::NoValue, i};
            if (!word.is_known) return MatchFault{MatchFault::Kind::CodeComputed, i};
            const CodeStart* code = tables_.find_code(word.address, word.number);
            if (code == nullptr && is_passed_to_builder(tables_, word.address, word.number))
                return take_for_builder(i);
            if (code == nullptr) return MatchFault{MatchFault::Kind::UnknownCode, i};
            return take_form(i, code->forms);
        }
        // A number that by itself means something (`D0`), if there is such a form.
        if (!word.is_known || tables_.code_index[word.address].empty()) return {};
        const CodeStart* code = tables_.find_code(word.address, word.number);
        return code == nullptr ? Fault{} : take_form(i, code->forms);
    }

    Fault take_for_builder(std::size_t i) {
        used_[i] = true;
        if (Fault fault = say(Function::MachineFunction, i, 1)) return fault;
        block_.set_argument(block_.functions[block_.function_count - 1u],
                            parameter_of<Function::MachineFunction>("number"), words_[i].number);
        return {};
    }

    Fault take_form(std::size_t head, const std::vector<FormId>& candidates) {
        FormId best = kNoForm;
        FormFit best_fit;
        FormId nearest = kNoForm;
        FormFit nearest_fit;
        for (const FormId id : candidates) {
            if (is_no_source_call(head, tables_.forms[id])) continue;
            const FormFit fit = fit_form(head, tables_.forms[id]);
            if (fit.answer == FormFit::Answer::Yes) {
                if (best == kNoForm || fit.matched > best_fit.matched) best = id, best_fit = fit;
            } else if (nearest == kNoForm || is_nearer(fit, nearest_fit)) {
                nearest = id, nearest_fit = fit;
            }
        }
        if (best == kNoForm) return no_form(head, nearest, nearest_fit);
        // A word with a wrong value is not passed over because a shorter form would do without it.
        if (nearest != kNoForm && nearest_fit.answer == FormFit::Answer::Value &&
            !best_fit.taken[nearest_fit.culprit] && !is_slot_word(nearest_fit.culprit) &&
            !is_of_other_code(head, nearest_fit.culprit)) {
            return no_form(head, nearest, nearest_fit);
        }
        if (nearest != kNoForm && is_unfinished_call(best, best_fit, nearest, nearest_fit))
            return no_form(head, nearest, nearest_fit);
        if (Fault fault = check_rivals(head, candidates, best, best_fit)) return fault;
        if (Fault fault = apply(tables_.forms[best], best, head, best_fit)) return fault;
        return take_joined(head, candidates, best);
    }

    /// Whether the block comes nearer to a form than to another one.
    static bool is_nearer(const FormFit& fit, const FormFit& other) {
        if (fit.is_idle != other.is_idle) return other.is_idle;
        if (fit.matched != other.matched) return fit.matched > other.matched;
        // Where both refuse one word, the first form tells best what it should be.
        const bool is_same = fit.answer == other.answer && fit.culprit == other.culprit;
        return !is_same && !fit.is_of_other_word && other.is_of_other_word;
    }

    /// Of a cycle of two lines: what looks like settings is the work, and lacks a word of it.
    bool is_unfinished_call(FormId best, const FormFit& best_fit, FormId nearest,
                            const FormFit& fit) const {
        return tables_.forms[best].is_preset && !tables_.forms[nearest].is_preset &&
               fit.answer == FormFit::Answer::Missing && !fit.is_idle &&
               fit.matched > best_fit.matched;
    }

    /// What the words that are left mean by another form of the same code.
    Fault take_joined(std::size_t head, const std::vector<FormId>& candidates, FormId first) {
        for (const FormId id : candidates) {
            const Form& form = tables_.forms[id];
            if (id == first || !(form.joins || tables_.forms[first].joins)) continue;
            const FormFit fit = fit_form(head, form);
            if (fit.answer == FormFit::Answer::Yes && fit.matched > 1)
                return apply(form, id, head, fit);
        }
        return {};
    }

    /// A call of a source is a cycle of a module that it can import.
    bool is_no_source_call(std::size_t head, const Form& form) const {
        return words_of_ == WordsOf::Source && address(head).kind == Address::Kind::Call &&
               form.function == Function::Cycle && tables_.cycles[form.cycle].module.empty();
    }

    bool is_slot_word(std::size_t i) const { return address(i).slot >= 0; }

    /// Whether another code of the block has a form that takes the word as it is: P of `G53 G31
    /// P2`.
    bool is_of_other_code(std::size_t head, std::size_t culprit) const {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (i == head || used_[i] || !is_code(i) || !words_[i].is_known) continue;
            const CodeStart* const code = tables_.find_code(words_[i].address, words_[i].number);
            if (code == nullptr) continue;
            const bool takes_it = std::ranges::any_of(code->forms, [&](FormId id) {
                const FormFit fit = fit_form(i, tables_.forms[id]);
                return fit.answer == FormFit::Answer::Yes && fit.taken[culprit];
            });
            if (takes_it) return true;
        }
        return false;
    }

    Fault no_form(std::size_t head, FormId nearest, const FormFit& fit) const {
        if (fit.answer == FormFit::Answer::Value) {
            return MatchFault{MatchFault::Kind::Value, fit.culprit, head, nearest, fit.argument};
        }
        if (fit.answer == FormFit::Answer::Mode)
            return MatchFault{MatchFault::Kind::Mode, fit.culprit, head, nearest};
        return MatchFault{MatchFault::Kind::Missing, head, head, nearest};
    }

    /// A word that another form of the same code would take must not slip through to a slot.
    Fault check_rivals(std::size_t head, const std::vector<FormId>& candidates, FormId best,
                       const FormFit& best_fit) const {
        for (const FormId id : candidates) {
            if (id == best || tables_.forms[id].joins || tables_.forms[best].joins) continue;
            const FormFit fit = fit_form(head, tables_.forms[id]);
            if (fit.answer != FormFit::Answer::Yes) continue;
            const WordSet beyond = fit.taken & ~best_fit.taken;
            if (beyond.none()) continue;
            const WordSet own = best_fit.taken & ~fit.taken;
            for (std::size_t w = 0; w < words_.size(); ++w) {
                if (!beyond[w]) continue;
                std::size_t other = head;
                for (std::size_t o = 0; o < words_.size(); ++o) {
                    if (own[o]) other = o;
                }
                return MatchFault{MatchFault::Kind::Conflict, w, other, best};
            }
        }
        return {};
    }

    /// Whether the modal functions are active that the form needs, or nobody knows. A word that
    /// means a slot under other motions takes the form only if the motion is known.
    bool acts(const Form& form) const {
        const FormWord& first = form.words[0];
        const bool is_value = first.kind == FormWord::Kind::Value;
        const bool has_slot = is_value && tables_.addresses[first.address].slot >= 0;
        return std::ranges::all_of(form.during, [&](Function needed) {
            const bool is_cycle = needed == Function::Cycle;
            // Whether a cycle is active there, only the running program knows.
            const bool is_place = words_of_ == WordsOf::Source && !has_slot && is_source_place();
            if (is_cycle && words_of_ == WordsOf::Source) return is_place;
            if (is_place && is_word_of_cycle(first)) return false;
            const bool calls_cycle = block_.find(Function::Cycle) != nullptr;
            if (is_cycle && form.of_cycle && *form.of_cycle != cycle_called(calls_cycle))
                return false;
            if (is_cycle && calls_cycle) return true;
            const Group group = is_cycle ? Group::CycleMode : info(needed).group;
            // Axis words of a modal cycle are no motion that words could belong to.
            const bool is_in_cycle =
                calls_cycle ||
                modal_[static_cast<std::size_t>(Group::CycleMode)] == Function::Cycle;
            if (group == Group::Motion && is_in_cycle) return false;
            const bool is_given = group == Group::Motion && block_.motion != Function::None;
            const Function active = is_given ? block_.motion : active_of(group);
            // Data of the control are input only where a block has begun it.
            // A text begins under the motion of power-on: no word belongs to another one there.
            const bool is_own_motion =
                group == Group::Motion && is_value && words_of_ == WordsOf::Text &&
                needed != tables_.power_on[static_cast<std::size_t>(Group::Motion)];
            const bool may_act = !has_slot && group != Group::DataInput && !is_own_motion;
            return active == needed || (active == Function::None && may_act);
        });
    }

    /// The cycle of this block, or the one whose mode lasts.
    CycleId cycle_called(bool by_block) const { return by_block ? block_.cycle : modal_.cycle; }

    /// A block of a source without a motion, which may be a position of a cycle.
    bool is_source_place() const {
        return block_.motion == Function::None && block_.find(Function::Cycle) == nullptr &&
               std::ranges::none_of(words_, [](const GivenWord& word) { return word.is_call; });
    }

    /// Whether a modal cycle has the word as well.
    bool is_word_of_cycle(const FormWord& first) const {
        if (first.address == kNoAddress) return false;
        return std::ranges::any_of(tables_.addresses[first.address].forms, [&](const FormId id) {
            const std::vector<Function>& during = tables_.forms[id].during;
            return std::ranges::find(during, Function::Cycle) != during.end();
        });
    }

    /// The member of the group that acts in the block: its own (`G90 G53`), else the modal one.
    Function active_of(Group group) const {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (!is_code(i) || !words_[i].is_known) continue;
            const CodeStart* code = tables_.find_code(words_[i].address, words_[i].number);
            if (code == nullptr || code->simple == kNoForm) continue;
            const Function said = tables_.forms[code->simple].function;
            if (info(said).group == group) return said;
        }
        return modal_[static_cast<std::size_t>(group)];
    }

    FormFit fit_form(std::size_t head, const Form& form) const {
        FormFit fit;
        fit.taken[head] = true;
        fit.matched = 1;
        fit.is_idle = !acts(form);
        if (fit.is_idle) fit.answer = FormFit::Answer::Missing;
        fit_word(form, form.words[0], head, fit);
        for (std::size_t f = 1; f < form.words.size(); ++f) {
            const FormWord& wanted = form.words[f];
            bool found = false;
            for (std::size_t i = 0; i < words_.size() && !found; ++i) {
                if (used_[i] || fit.taken[i] || words_[i].address != wanted.address) continue;
                const bool is_other_code = is_code(i) && !near(words_[i].number, wanted.number);
                if (is_other_code) continue;
                fit.taken[i] = true;
                ++fit.matched;
                found = true;
                fit_word(form, wanted, i, fit);
            }
            // Where distances have letters of their own (U beside X), such a word stands for the
            // one of the form; it stays a word of the block.
            if (!found && has_distance(wanted)) {
                ++fit.matched;
                found = true;
            }
            const bool may_lack = wanted.is_kept || wanted.is_optional || wanted.has_default;
            if (!found && !may_lack) {
                fit.answer =
                    fit.answer == FormFit::Answer::Yes ? FormFit::Answer::Missing : fit.answer;
            }
        }
        return fit;
    }

    bool has_distance(const FormWord& wanted) const {
        if (wanted.kind != FormWord::Kind::Value || !tables_.has_incremental_letters) return false;
        const Address& place = tables_.addresses[wanted.address];
        if (place.slot < 0 || place.is_incremental || wanted.dimension != place.dimension)
            return false;  // the X of a dwell is no position
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (!used_[i] && address(i).is_incremental && address(i).slot == place.slot)
                return true;
        }
        return false;
    }

    static void refuse(FormFit& fit, FormFit::Answer answer, std::size_t word, int argument = -1) {
        if (fit.answer == FormFit::Answer::Value) return;
        fit.answer = answer;
        fit.culprit = word;
        fit.argument = argument;
    }

    void fit_word(const Form& form, const FormWord& wanted, std::size_t i, FormFit& fit) const {
        const GivenWord& word = words_[i];
        switch (wanted.kind) {
            case FormWord::Kind::Fixed:
                if (!word.has_value || (word.is_known && !is_fixed(wanted, word.number))) {
                    fit.is_of_other_word = true;
                    refuse(fit, FormFit::Answer::Value, i);
                }
                break;
            case FormWord::Kind::Name:
                if (word.argument_count != 0) refuse(fit, FormFit::Answer::Value, i);
                break;
            case FormWord::Kind::Value:
                if (!word.has_value || word.is_text) refuse(fit, FormFit::Answer::Value, i);
                if (wanted.is_named_only && !wanted.is_placeholder && word.is_known &&
                    !near(word.number, 0)) {
                    refuse(fit, FormFit::Answer::Value, i);
                }
                if (!is_of_mode(wanted, word.mode)) refuse(fit, FormFit::Answer::Mode, i);
                if (word.is_known && !is_in_range(form, wanted, word.number))
                    refuse(fit, FormFit::Answer::Value, i);
                if (wanted.tail_digits > 0 && word.is_known && !has_tail(wanted, word.number))
                    refuse(fit, FormFit::Answer::Value, i);
                if (wanted.has_point_tail && word.is_known && word.number < 0)
                    refuse(fit, FormFit::Answer::Value, i);
                break;
            case FormWord::Kind::Quoted:
                if (!word.is_text) refuse(fit, FormFit::Answer::Value, i);
                break;
            case FormWord::Kind::Call: fit_call(form, wanted, i, fit); break;
            case FormWord::Kind::Empty:
            case FormWord::Kind::Text:
            case FormWord::Kind::Rest: break;
        }
    }

    static bool is_of_mode(const FormWord& wanted, GivenWord::Mode mode) {
        using Mode = GivenWord::Mode;
        const bool is_distance = mode == Mode::Absolute || mode == Mode::Shortest ||
                                 mode == Mode::Positive || mode == Mode::Negative;
        if (wanted.takes_rotary_approaches && is_distance) return true;
        if (wanted.is_incremental) return mode == Mode::Incremental;
        return mode == (wanted.is_absolute ? Mode::Absolute : Mode::Modal);
    }

    /// Whether a number is the one of the form. That of a quantity has been rounded in the units of
    /// the text.
    bool is_fixed(const FormWord& wanted, double number) const {
        if (!wanted.is_quantity) return near(number, wanted.number);
        TextUnits units;
        units.inch = modal_[static_cast<std::size_t>(Group::Units)] == Function::Inch;
        return is_quantity(wanted, number,
                           wanted.address == kNoAddress ? argument_format(tables_)
                                                        : tables_.addresses[wanted.address].format,
                           units);
    }

    /// Whether a whole number ends in the digits that the pattern wants.
    static bool has_tail(const FormWord& wanted, double number) {
        if (!(number >= 0) || number != std::floor(number)) return false;
        return wanted.tail_parameter >= 0 ||
               std::fmod(number, std::pow(10.0, wanted.tail_digits)) == wanted.tail_value;
    }

    bool is_in_range(const Form& form, const FormWord& wanted, double number) const {
        if (form.when.empty()) return true;
        double value = (number - wanted.offset) / wanted.factor;
        if (wanted.in_increments) value *= increment_size(tables_, wanted.dimension, TextUnits{});
        if (wanted.has_point_tail) value = std::floor(value);
        if (wanted.tail_digits > 0) value = std::floor(value / std::pow(10.0, wanted.tail_digits));
        return std::ranges::none_of(form.when, [&](const Constraint& c) {
            return c.parameter == wanted.parameter && (value < c.least || value > c.most);
        });
    }

    static bool is_constrained(const Form& form, const FormWord& wanted) {
        return std::ranges::find(form.when, wanted.parameter, &Constraint::parameter) !=
               form.when.end();
    }

    /// The argument that one of the form's is; -1: it is not given. Those with letters are found by
    /// them, the others by their place.
    int given_for(const FormWord& call, std::size_t wanted, const GivenWord& word) const {
        const AddressId letter = call.arguments[wanted].address;
        std::size_t place = 0;
        for (std::size_t a = 0; a < wanted; ++a)
            place += call.arguments[a].address == kNoAddress ? 1 : 0;
        for (std::size_t a = 0; a < word.argument_count; ++a) {
            const AddressId given = arguments_[word.first_argument + a].letter;
            if (given != letter) continue;
            if (letter != kNoAddress || place-- == 0) return static_cast<int>(a);
        }
        return -1;
    }

    static bool has_rest(const FormWord& call) {
        return !call.arguments.empty() && call.arguments.back().kind == FormWord::Kind::Rest;
    }

    /// `(UOT,1,Y5)`: of a command in brackets.
    void fit_lettered(const Form& form, const FormWord& wanted, std::size_t i, FormFit& fit) const {
        const GivenWord& word = words_[i];
        std::bitset<kMaxCallArguments> taken;
        for (std::size_t a = 0; a < wanted.arguments.size(); ++a) {
            const int at = given_for(wanted, a, word);
            const GivenArgument given =
                at < 0 ? GivenArgument{}
                       : arguments_[word.first_argument + static_cast<std::size_t>(at)];
            if (at >= 0) taken.set(static_cast<std::size_t>(at));
            const bool fits = fits_argument(form, wanted.arguments[a], given);
            if (!fits) refuse(fit, FormFit::Answer::Value, i, std::max(at, 0));
            if (fits && at >= 0) ++fit.matched;
        }
        if (has_rest(wanted)) return;
        for (std::size_t a = 0; a < word.argument_count; ++a) {
            const bool is_beyond =
                !taken[a] && arguments_[word.first_argument + a].kind != GivenArgument::Kind::Empty;
            if (is_beyond) refuse(fit, FormFit::Answer::Value, i, static_cast<int>(a));
        }
    }

    void fit_call(const Form& form, const FormWord& wanted, std::size_t i, FormFit& fit) const {
        const GivenWord& word = words_[i];
        if (wanted.text.starts_with('(')) return fit_lettered(form, wanted, i, fit);
        for (std::size_t a = 0; a < word.argument_count || a < wanted.arguments.size(); ++a) {
            const GivenArgument given =
                a < word.argument_count ? arguments_[word.first_argument + a] : GivenArgument{};
            const FormWord* want = a < wanted.arguments.size() ? &wanted.arguments[a] : nullptr;
            const bool fits = want == nullptr ? given.kind == GivenArgument::Kind::Empty
                                              : fits_argument(form, *want, given);
            if (!fits) refuse(fit, FormFit::Answer::Value, i, static_cast<int>(a));
            if (fits && given.kind != GivenArgument::Kind::Empty) ++fit.matched;
        }
    }

    bool fits_argument(const Form& form, const FormWord& want, const GivenArgument& given) const {
        const bool is_empty = given.kind == GivenArgument::Kind::Empty;
        const bool is_number = given.kind == GivenArgument::Kind::Number;
        const bool is_text = given.kind == GivenArgument::Kind::Text;
        if (want.kind == FormWord::Kind::Rest) return true;
        if (want.kind == FormWord::Kind::Empty) return is_empty;
        if (want.is_letter_alone)
            return given.kind == GivenArgument::Kind::Letter || (is_empty && want.is_optional);
        if (want.kind == FormWord::Kind::Text) return is_text || (is_empty && want.is_optional);
        if (want.is_work_offset) return is_number && given.number == modal_.work_offset;
        if (want.kind == FormWord::Kind::Fixed)
            return is_empty ? want.number == 0 : is_number && is_fixed(want, given.number);
        if (is_empty) return want.is_optional || want.has_default;
        // Which form it is cannot wait for the value.
        if (given.kind == GivenArgument::Kind::Computed) return !is_constrained(form, want);
        return is_number && is_in_range(form, want, given.number);
    }

    // ------------------------------------------------------------ what a form programs

    Fault apply(const Form& form, FormId id, std::size_t head, const FormFit& fit) {
        if (match_.form_count == match_.forms.size())
            return MatchFault{MatchFault::Kind::Full, head};
        match_.forms[match_.form_count++] = id;
        if (!form.unsupported.empty())
            return MatchFault{MatchFault::Kind::NotSupported, head, head, id};
        const bool is_source = words_of_ == WordsOf::Source;
        if ((form.owns_block || (form.owns_line && is_source)) && !alone_) alone_ = head;
        if (form.owns_axes && !without_axes_) without_axes_ = head;
        if (form.owns_line && !without_places_) without_places_ = head;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const bool is_barred =
                std::ranges::find(form.without, words_[i].address) != form.without.end();
            if (is_barred) return MatchFault{MatchFault::Kind::Company, head, i};
        }
        if (form.owns_address) {
            for (std::size_t i = 0; i < words_.size(); ++i) {
                if (i != head && words_[i].address == words_[head].address)
                    return MatchFault{MatchFault::Kind::Company, head, i};
            }
        }
        // The control knows it, and nothing here depends on it; no source is polar.
        const bool is_off_anyhow =
            words_of_ == WordsOf::Source && form.function == Function::PolarOff;
        if (form.function == Function::None || is_off_anyhow) {
            used_ |= fit.taken;
            return {};
        }
        for (const Function before : form.first) {
            if (Fault fault = say(before, head, info(before).parameters.size())) return fault;
        }
        const Function said = form.is_preset ? Function::CyclePreset : form.function;
        if (Fault fault = say(said, head, tables_.parameters(form).size())) return fault;
        if (form.function == Function::Cycle) {
            block_.cycle = form.cycle;
            block_.cycle_by_form = 0;
        }
        const auto invocation = static_cast<std::uint8_t>(block_.function_count - 1u);
        if (form.function == Function::PolynomialAxis && !form.fixed.empty()) {
            const auto axis = static_cast<Axis>(form.fixed[0].second - 1);
            take_mode(words_[head].mode, slot_of(axis));
        }
        for (const auto& [parameter, value] : form.fixed) {
            block_.set_argument(block_.functions[invocation], static_cast<std::size_t>(parameter),
                                value);
            if (form.function == Function::Cycle && parameter < 16)
                block_.cycle_by_form |= static_cast<std::uint16_t>(1u << parameter);
        }
        WordSet left = fit.taken;
        left[head] = false;
        used_[head] = true;
        claim_word(form.words[0], head, invocation);
        for (std::size_t f = 1; f < form.words.size(); ++f) {
            for (std::size_t i = 0; i < words_.size(); ++i) {
                if (!left[i] || words_[i].address != form.words[f].address) continue;
                left[i] = false;
                used_[i] = true;
                claim_word(form.words[f], i, invocation);
                break;
            }
        }
        for (const Function also : form.sets) {
            const Group group = info(also).group;
            if (group != Group::Motion && modal_[static_cast<std::size_t>(group)] == also) continue;
            if (Fault fault = say(also, head, 0)) return fault;
        }
        return {};
    }

    Fault say(Function function, std::size_t head, std::size_t parameters) {
        if (info(function).group == Group::Motion) {
            block_.motion = function;
            motion_head_ = head;
            return {};
        }
        if (block_.add(function, parameters) == nullptr)
            return MatchFault{MatchFault::Kind::Full, head};
        heads_[block_.function_count - 1u] = head;
        return {};
    }

    void claim_word(const FormWord& wanted, std::size_t i, std::uint8_t invocation) {
        if (wanted.is_any) return;
        if (wanted.kind == FormWord::Kind::Value || wanted.kind == FormWord::Kind::Quoted) {
            claim(wanted, i, -1, invocation);
        }
        if (wanted.kind != FormWord::Kind::Call) return;
        const GivenWord& word = words_[i];
        if (wanted.text.starts_with('(')) return claim_lettered(wanted, i, invocation);
        for (std::size_t a = 0; a < word.argument_count && a < wanted.arguments.size(); ++a) {
            const FormWord& argument = wanted.arguments[a];
            if (argument.parameter < 0) continue;
            if (arguments_[word.first_argument + a].kind == GivenArgument::Kind::Empty) continue;
            claim(argument, i, static_cast<int>(a), invocation);
        }
    }

    void claim_lettered(const FormWord& wanted, std::size_t i, std::uint8_t invocation) {
        const GivenWord& word = words_[i];
        for (std::size_t a = 0; a < wanted.arguments.size(); ++a) {
            if (wanted.arguments[a].parameter < 0) continue;
            const int at = given_for(wanted, a, word);
            if (at >= 0) claim(wanted.arguments[a], i, at, invocation);
        }
    }

    void claim(const FormWord& wanted, std::size_t i, int argument, std::uint8_t invocation) {
        Claim& claim = match_.claims[match_.claim_count++];
        claim = {};
        claim.word = static_cast<std::uint16_t>(i);
        claim.argument = static_cast<std::int16_t>(argument);
        claim.is_parameter = true;
        claim.invocation = invocation;
        claim.parameter = static_cast<std::uint8_t>(wanted.parameter);
        claim.index =
            static_cast<std::uint8_t>(block_.functions[invocation].first + wanted.parameter);
        claim.dimension = wanted.dimension;
        claim.adds = wanted.adds;
        claim.is_named_only = wanted.is_named_only;
        claim.is_pitch = wanted.is_pitch;
        claim.in_increments = wanted.in_increments;
        claim.tail_digits = wanted.tail_digits;
        claim.tail_parameter = wanted.tail_parameter;
        claim.has_point_tail = wanted.has_point_tail;
        claim.format = wanted.format ? &*wanted.format : nullptr;
        claim.factor = wanted.factor;
        claim.plain_factor = wanted.plain_factor;
        claim.offset = wanted.offset;
    }

    /// Functions stand in the order of their words, whichever was recognised first.
    void order_functions() {
        const std::size_t count = block_.function_count;
        std::array<std::uint8_t, kMaxInvocations> order{};
        for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint8_t>(i);
        std::stable_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                         [&](std::uint8_t a, std::uint8_t b) { return heads_[a] < heads_[b]; });
        const std::array<Invocation, kMaxInvocations> old = block_.functions;
        std::array<std::uint8_t, kMaxInvocations> place{};
        for (std::size_t i = 0; i < count; ++i) {
            block_.functions[i] = old[order[i]];
            place[order[i]] = static_cast<std::uint8_t>(i);
        }
        for (std::size_t i = 0; i < match_.claim_count; ++i) {
            Claim& claim = match_.claims[i];
            if (claim.is_parameter) claim.invocation = place[claim.invocation];
        }
    }

    // ------------------------------------------------------------ values

    Fault take_value(std::size_t i) {
        if (used_[i]) return {};
        const GivenWord& word = words_[i];
        const Address& head = address(i);
        if (!word.has_value) return MatchFault{MatchFault::Kind::NoValue, i};
        const bool has_form =
            std::ranges::any_of(head.forms, [&](FormId id) { return acts(tables_.forms[id]); });
        if (has_form) return take_form(i, head.forms);
        if (head.slot < 0) return MatchFault{MatchFault::Kind::Unused, i};
        if (word.is_text) return MatchFault{MatchFault::Kind::NoNumber, i};
        const std::optional<Slot> meant = slot_meant(static_cast<Slot>(head.slot));
        if (!meant) return MatchFault{MatchFault::Kind::Unused, i};
        const Slot slot = *meant;
        if (block_.has(slot) || (seen_slots_ & bit(slot)) != 0)
            return MatchFault{MatchFault::Kind::AddressTwice, i, i};
        seen_slots_ |= bit(slot);
        if (!take_mode(word.mode, slot)) return MatchFault{MatchFault::Kind::Mode, i};
        if (head.is_incremental) block_.incremental |= bit(slot);
        if (head.is_coordinate && word.mode == GivenWord::Mode::Modal &&
            active_of(Group::Distance) != Function::Incremental)
            block_.absolute |= bit(slot);
        used_[i] = true;
        Claim& claim = match_.claims[match_.claim_count++];
        claim = {};
        claim.word = static_cast<std::uint16_t>(i);
        claim.index = static_cast<std::uint8_t>(slot);
        claim.dimension = head.dimension;
        return {};
    }

    /// The slot that a word sets by itself. Of a centre beside an arc it may be the axis of the
    /// plane that tells; the word of the axis across means nothing then.
    std::optional<Slot> slot_meant(Slot slot) const {
        if (!tables_.rules.center_by_plane || (bit(slot) & kCenterSlots) == 0) return slot;
        const Function motion =
            block_.motion != Function::None ? block_.motion : active_of(Group::Motion);
        if (motion != Function::ArcCw && motion != Function::ArcCcw) return slot;
        if (slot == Slot::CenterZ) return std::nullopt;
        return center_slot_of_word(slot, active_of(Group::Plane));
    }

    /// False: a word of the slot cannot be given so.
    bool take_mode(GivenWord::Mode mode, Slot slot) {
        using Mode = GivenWord::Mode;
        if (mode == Mode::Modal) return true;
        if (mode == Mode::Indexed) return false;  // no axis has a table of positions
        if (mode >= Mode::Shortest) {
            if (slot < Slot::A || slot > Slot::C) return false;
            block_.set_rotary_approach(static_cast<Axis>(slot),
                                       mode == Mode::Shortest   ? RotaryApproach::Shortest
                                       : mode == Mode::Positive ? RotaryApproach::Positive
                                                                : RotaryApproach::Negative);
            return true;
        }
        const bool is_diameter =
            mode == Mode::DiameterAbsolute || mode == Mode::DiameterIncremental;
        const bool is_radius = mode == Mode::RadiusAbsolute || mode == Mode::RadiusIncremental;
        if ((bit(slot) & kModeSlots) == 0) return false;
        if ((is_diameter || is_radius) && slot != Slot::X) return false;
        if (is_diameter) block_.x_measure = XMeasure::Diameter;
        if (is_radius) block_.x_measure = XMeasure::Radius;
        const bool is_incremental = mode == Mode::Incremental ||
                                    mode == Mode::DiameterIncremental ||
                                    mode == Mode::RadiusIncremental;
        (is_incremental ? block_.incremental : block_.absolute) |= bit(slot);
        return true;
    }

    /// Where cycles are modal, the motion code that stands behind one ends it at once.
    Fault cancel_cycle() {
        if (!motion_head_ || tables_.forms_of[static_cast<std::size_t>(Function::CycleOff)].empty())
            return {};
        for (std::size_t i = 0; i < block_.function_count; ++i) {
            const bool is_cycle = block_.functions[i].function == Function::Cycle;
            if (is_cycle && heads_[i] < *motion_head_)
                return say(Function::CycleOff, *motion_head_, 0);
        }
        return {};
    }

    /// Words of arcs have other meanings beside a cycle (K: repeats); none of them is passed over.
    Fault check_cycle() const {
        if (block_.find(Function::Cycle) == nullptr) return {};
        const SlotMask of_arcs = kArcSlots | kThroughSlots | bit(Slot::Opening);
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (words_[i].is_left_out) continue;
            const int slot = address(i).slot;
            const bool is_slot =
                slot >= 0 && (seen_slots_ & of_arcs & bit(static_cast<Slot>(slot))) != 0;
            if (is_slot) return MatchFault{MatchFault::Kind::Unused, i};
        }
        return {};
    }

    Fault check_alone() const {
        constexpr SlotMask kPlaces = kTargetSlots | kArcSlots | kReadSlots;
        if (without_axes_ && (motion_head_ || (seen_slots_ & kPlaces) != 0))
            return MatchFault{MatchFault::Kind::Alone, *without_axes_};
        if (without_places_ && (seen_slots_ & kPlaces) != 0)
            return MatchFault{MatchFault::Kind::Alone, *without_places_,
                              place_beside().value_or(*without_places_)};
        if (!alone_) return {};
        const bool has_more = match_.form_count > 1 || seen_slots_ != 0;
        if (!has_more) return {};
        return MatchFault{MatchFault::Kind::Alone, *alone_, place_beside().value_or(*alone_)};
    }

    /// Of a function that takes positions, the first one that it does not take: Z of `G68 X0 Y0 Z0
    /// R30`.
    std::optional<std::size_t> place_beside() const {
        bool takes_places = false;
        std::optional<std::size_t> beside;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const int slot = words_[i].is_left_out ? -1 : address(i).slot;
            if (slot < 0 || (kTargetSlots & bit(static_cast<Slot>(slot))) == 0) continue;
            const bool is_taken = (seen_slots_ & bit(static_cast<Slot>(slot))) == 0;
            if (!is_taken && !beside) beside = i;
            takes_places |= is_taken;
        }
        return takes_places ? beside : std::nullopt;
    }

    const DialectTables& tables_;
    std::span<const GivenWord> words_;
    std::span<const GivenArgument> arguments_;
    const ModalFunctions& modal_;
    Block& block_;
    Match& match_;
    WordsOf words_of_;
    WordSet used_;
    SlotMask seen_slots_ = 0;
    std::optional<std::size_t> alone_;
    std::optional<std::size_t> without_axes_;
    std::optional<std::size_t> without_places_;
    std::optional<std::size_t> motion_head_;            // word that programs the motion
    std::array<std::size_t, kMaxInvocations> heads_{};  // word behind each function
};

}  // namespace

std::optional<MatchFault> match_words(const DialectTables& tables, std::span<const GivenWord> words,
                                      std::span<const GivenArgument> arguments,
                                      const ModalFunctions& modal, Block& block, Match& match,
                                      WordsOf words_of) {
    match.claim_count = 0;
    match.form_count = 0;
    return Matcher(tables, words, arguments, modal, block, match, words_of).run();
}

}  // namespace kadr::nc
