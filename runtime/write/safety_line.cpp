#include "write/safety_line.h"

#include <algorithm>
#include <span>

#include "base/numbers.h"

namespace kadr::write {

namespace {

constexpr std::size_t kOffsetNumber = parameter_of<Function::WorkOffset>("number");

/// Groups that a program begins with as it likes. G91 is none of them: who starts a program wants
/// to read G90, and the first distances say G91 themselves.
constexpr bool is_chosen(Group group) {
    return group == Group::Plane || group == Group::FeedMode || group == Group::Diameter ||
           group == Group::PathMode;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(' '); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(' ', end);
    }
    return words;
}

void add_word(std::string& line, std::string_view word) {
    if (word.empty()) return;
    if (!line.empty()) line += ' ';
    line += word;
}

}  // namespace

/// The form of one word, whose number is all that it says: a code, a name.
const Form* SafetyLine::form_of(std::string_view word) const {
    const DialectTables& tables = state_.view().tables;
    const AddressId letter = tables.find_address(word.substr(0, 1));
    if (letter != kNoAddress && word.size() > 1) {
        const Decimal number = parse_decimal(word.data() + 1, word.data() + word.size());
        const CodeStart* code = tables.find_code(letter, number.value);
        if (code != nullptr && code->simple != kNoForm) return &tables.forms[code->simple];
        const auto is_offset = [&](FormId id) {
            const Form& form = tables.forms[id];
            return form.function == Function::WorkOffset && form.words.size() == 1 &&
                   form.words[0].text == word;
        };
        if (code == nullptr) return name_form(word);
        const auto offset = std::ranges::find_if(code->forms, is_offset);
        return offset == code->forms.end() ? nullptr : &tables.forms[*offset];
    }
    return name_form(word);
}

/// `DIAMON`
const Form* SafetyLine::name_form(std::string_view word) const {
    const DialectTables& tables = state_.view().tables;
    for (std::size_t function = 0; function < tables.forms_of.size(); ++function) {
        if (!is_chosen(info(static_cast<Function>(function)).group)) continue;
        for (const FormId id : tables.forms_of[function])
            if (nc::first_line(tables.forms[id]) == word) return &tables.forms[id];
    }
    return nullptr;
}

const Form* SafetyLine::offset_form(double number) const {
    const DialectTables& tables = state_.view().tables;
    for (const FormId id : tables.forms_of[static_cast<std::size_t>(Function::WorkOffset)]) {
        const Form& form = tables.forms[id];
        const bool is_one_word =
            form.words.size() == 1 && form.words[0].kind == FormWord::Kind::Fixed;
        const bool is_number = std::ranges::any_of(form.fixed, [&](const auto& fixed) {
            return fixed.first == static_cast<int>(kOffsetNumber) && fixed.second == number;
        });
        if (is_one_word && is_number && form.is_written) return &form;
    }
    return nullptr;
}

/// What holds anyway, where the control has no code for it, needs no word.
bool SafetyLine::needs_no_word(Function function) const {
    return !state_.view().has_code(function) &&
           state_.modal().text_of(info(function).group) == function;
}

bool SafetyLine::can_take(const Invocation& invocation) const {
    const Function function = invocation.function;
    return is_chosen(info(function).group) &&
           (state_.view().has_code(function) || needs_no_word(function));
}

bool SafetyLine::take(const Block& block) {
    if (block.kind != Block::Kind::Nc || block.function_count == 0 || block.given != 0 ||
        block.motion != Function::None || block.skip_level >= 0 || block.number >= 0 ||
        !block.comment.empty())
        return false;
    const auto functions = std::span(block.functions).first(block.function_count);
    const auto is_offset = [&](const Invocation& invocation) {
        return invocation.function == Function::WorkOffset &&
               offset_form(block.argument(invocation, kOffsetNumber)) != nullptr;
    };
    if (!std::ranges::all_of(functions, [&](const Invocation& invocation) {
            return can_take(invocation) || is_offset(invocation);
        }))
        return false;
    for (const Invocation& invocation : functions) {
        if (invocation.function == Function::WorkOffset)
            taken_.offset = {true, block.argument(invocation, kOffsetNumber)};
        else if (!needs_no_word(invocation.function))
            taken_.functions[index_of(info(invocation.function).group)] = invocation.function;
    }
    state_.mean_all(block);
    state_.follow(block);
    holds_codes_ = true;
    return true;
}

/// A word of a template, or the one that stands in its place; what is wanted of the group is said
/// then.
std::string SafetyLine::word_for(std::string_view word, Wanted& wanted) const {
    const DialectTables& tables = state_.view().tables;
    const Form* form = form_of(word);
    if (form == nullptr) return std::string(word);
    if (form->function == Function::WorkOffset) {
        if (!wanted.offset.is_known) return std::string(word);
        wanted.offset.is_known = false;
        return offset_form(wanted.offset.value)->words[0].text;
    }
    const Group group = info(form->function).group;
    if (group == Group::NonModal) return std::string(word);
    if (group == Group::FeedMode && wanted.is_without_feed_mode) return {};
    const Function function = std::exchange(wanted.functions[index_of(group)], Function::None);
    if (function == Function::None || function == form->function) return std::string(word);
    const auto& forms = tables.forms_of[static_cast<std::size_t>(function)];
    return forms.empty() ? std::string(word) : nc::first_line(tables.forms[forms[0]]);
}

std::string SafetyLine::line_of(std::string_view text, Wanted& wanted) const {
    std::string line;
    for (const std::string_view word : words_of(text)) add_word(line, word_for(word, wanted));
    return line;
}

/// What no template has a word for.
std::string SafetyLine::rest_of(const Wanted& wanted) const {
    const DialectTables& tables = state_.view().tables;
    std::string line;
    if (wanted.offset.is_known) add_word(line, offset_form(wanted.offset.value)->words[0].text);
    for (const Function function : wanted.functions) {
        const bool is_left_out =
            wanted.is_without_feed_mode && info(function).group == Group::FeedMode;
        if (function == Function::None || is_left_out) continue;
        const auto& forms = tables.forms_of[static_cast<std::size_t>(function)];
        if (!forms.empty()) add_word(line, nc::first_line(tables.forms[forms[0]]));
    }
    return line;
}

/// The codes of the line are what the text has from here on.
void SafetyLine::say_words(std::string_view line) {
    const TextView& view = state_.view();
    const Form* shift = nullptr;  // that the line programs
    for (const std::string_view word : words_of(line)) {
        if (const Form* form = form_of(word); form != nullptr) state_.say(*form);
        const AddressId letter = view.tables.find_address(word.substr(0, 1));
        if (letter == kNoAddress || word.size() < 2) continue;
        const double number = parse_decimal(word.data() + 1, word.data() + word.size()).value;
        if (shift != nullptr) state_.start_shift(*shift, letter, number);
        if (shift == nullptr) shift = view.kept_shift(letter, number);
    }
}

void SafetyLine::write(const std::vector<std::string>& templates, const Wanted& wanted,
                       std::string& out) {
    Wanted open = wanted;
    std::vector<std::string> texts;
    std::size_t main = 0;  // the line of the plane
    for (const std::string& text : templates) {
        const auto has_plane = [&](std::string_view word) {
            const Form* form = form_of(word);
            return form != nullptr && info(form->function).group == Group::Plane;
        };
        if (std::ranges::any_of(words_of(text), has_plane)) main = texts.size();
        texts.push_back(line_of(text, open));
    }
    if (texts.empty()) return;
    add_word(texts[main], rest_of(open));
    for (const std::string& text : texts) {
        lines_.write(text, true, out);
        say_words(text);
    }
}

void SafetyLine::write_start(const std::vector<std::string>& templates, std::string& out) {
    // The offset of the template is the one that a program has which says none.
    for (const std::string& text : templates) {
        for (const std::string_view word : words_of(text)) {
            const Form* form = form_of(word);
            const bool is_offset = form != nullptr && form->function == Function::WorkOffset;
            if (!is_offset || taken_.offset.is_known) continue;
            Block block;
            block.set_argument(*block.add(Function::WorkOffset, 1), kOffsetNumber,
                               form->fixed.empty() ? 0 : form->fixed[0].second);
            state_.follow(block);
        }
    }
    write(templates, taken_, out);
    forget();
}

/// Whether some line of the templates has a word of the group.
bool SafetyLine::has_group(const std::vector<std::string>& templates, Group group) const {
    return std::ranges::any_of(templates, [&](const std::string& text) {
        return std::ranges::any_of(words_of(text), [&](std::string_view word) {
            const Form* form = form_of(word);
            return form != nullptr && info(form->function).group == group;
        });
    });
}

/// Whether a code of the feed would end the constant cutting speed that acts: G95 where G96 is one
/// of its group.
bool SafetyLine::would_end_cutting_speed() const {
    if (state_.modal().meant_of(Group::SpeedMode) != Function::CuttingSpeedOn) return false;
    const DialectTables& tables = state_.view().tables;
    const auto group_of = [&](Function function) {
        const auto& forms = tables.forms_of[static_cast<std::size_t>(function)];
        return forms.empty() ? -1 : tables.forms[forms[0]].group;
    };
    const int group = group_of(Function::CuttingSpeedOn);
    return group >= 0 && group == group_of(Function::FeedPerRevolution);
}

/// What acts behind the tool change, as far as a section has it.
SafetyLine::Wanted SafetyLine::standing(const std::vector<std::string>& templates) const {
    const WriterModal& modal = state_.modal();
    Wanted wanted = taken_;
    if (!wanted.offset.is_known) wanted.offset = modal.work_offset;
    if (wanted.offset.is_known && offset_form(wanted.offset.value) == nullptr)
        wanted.offset.is_known = false;
    wanted.is_without_feed_mode = would_end_cutting_speed();
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        const bool is_of_section =
            is_chosen(group) || group == Group::Distance || group == Group::Units;
        if (is_of_section && wanted.functions[i] == Function::None &&
            modal.text[i] != Function::None && state_.view().has_code(modal.text[i]))
            wanted.functions[i] = modal.text[i];
        // What no template has, and the control by itself, needs no word.
        const bool is_by_itself = wanted.functions[i] == state_.view().tables.power_on[i];
        if (is_by_itself && !has_group(templates, group)) wanted.functions[i] = Function::None;
    }
    return wanted;
}

void SafetyLine::write_section(const std::vector<std::string>& templates, std::string& out) {
    write(templates, standing(templates), out);
    forget();
}

}  // namespace kadr::write
