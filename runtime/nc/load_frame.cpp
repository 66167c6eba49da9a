// The text around the blocks: program frame, block numbers, comments, rules of lines.
#include "base/diagnostics/dialect.h"
#include "nc/load_parts.h"

namespace kadr::nc {

namespace {

/// Whether a template's `{word}` is one that the writer fills: its Template tells what they mean.
bool is_template_word(std::string_view word) {
    if (word == "name" || word == "NAME" || word == "title" || word == "units") return true;
    return word == "number" ||
           (word.size() == 9 && word.starts_with("number:0") && word[8] >= '1' && word[8] <= '9');
}

/// Why a line of the frame cannot be filled; empty if it can.
std::string fault_of_template(std::string_view line) {
    bool is_inside = false;  // `[…]`
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '[' || line[at] == ']') {
            if (is_inside != (line[at] == ']')) return "`[` and `]` do not pair";
            is_inside = !is_inside;
        }
        if (line[at] == '}') return "`}` closes nothing";
        if (line[at] != '{') continue;
        const std::size_t close = line.find('}', at);
        if (close == std::string_view::npos) return "`{` is not closed";
        const std::string_view word = line.substr(at + 1, close - at - 1);
        if (!is_template_word(word)) {
            return "there is no `{" + std::string(word) +
                   "}`; known are {name}, {NAME}, {title}, {units}, {number} and {number:04}";
        }
        at = close;
    }
    return is_inside ? "`[` and `]` do not pair" : "";
}

void check_line(const XmlElement& line, Attributes& attributes) {
    const bool is_filled = line.name == "header" || line.name == "start" ||
                           line.name == "section" || line.name == "end";
    const bool is_plain = line.name == "finish";
    std::string fault;
    if (is_filled) fault = fault_of_template(line.text);
    if (is_plain && line.text.find('{') != std::string::npos) {
        fault = "only `header`, `start`, `section` and `end` are filled";
    }
    if (line.name == "end" && (line.text.starts_with('{') || line.text.starts_with('[')))
        fault = "a reader knows the `end` line by what stands before its first placeholder";
    if (fault.empty()) return;
    attributes.fail();
    attributes.sink()
        .report(diag::DialectBadForm, line.text_range)
        .arg(shown_value(line.text))
        .arg(fault);
}

}  // namespace

void load_program(const XmlElement& element, ProgramTemplates& frame, Attributes& attributes) {
    frame.header.clear();
    frame.start.clear();
    frame.section.clear();
    frame.finish.clear();
    frame.end.clear();
    frame.skipped.clear();
    attributes.read_number(element, "name_length", frame.name_length);
    attributes.read_number(element, "least_number", frame.least_number);
    attributes.read_number(element, "most_number", frame.most_number);
    attributes.read_number(element, "most_read_number", frame.most_read_number);
    if (const auto letters = attributes.choice(element, "name_letters", {"any", "two"})) {
        frame.name_needs_two_letters = *letters == 1;
    }
    frame.range = element.range;
    frame.is_inherited = false;
    for (const XmlElement& line : element.children) {
        check_line(line, attributes);
        if (line.name == "header") frame.header.push_back(line.text);
        if (line.name == "start") {
            frame.start.push_back({line.text, {}});
            attributes.read_functions(line, "uses", frame.start.back().uses);
        }
        if (line.name == "section") frame.section.push_back(line.text);
        if (line.name == "finish") frame.finish.push_back(line.text);
        if (line.name == "end") frame.end.push_back(line.text);
        if (line.name == "skipped") frame.skipped.push_back(line.text);
    }
}

namespace {

/// Blocks can be counted with these numbers; what is inherited counts, too.
void check_blocks(const XmlElement& element, const BlockNumbers& numbers, Attributes& attributes) {
    if (attributes.has_failed()) return;
    const auto first_of = [&](std::initializer_list<std::string_view> names) {
        const XmlAttribute* found = nullptr;
        for (const std::string_view name : names)
            if (found == nullptr) found = element.find(name);
        return found;
    };
    const std::string limits =
        std::to_string(numbers.least) + " to " + std::to_string(numbers.most);
    if (const XmlAttribute* step = element.find("step"); step != nullptr && numbers.step == 0)
        return attributes.bad_value(*step, "a block has another number than the one before");
    const bool is_inside = numbers.least <= numbers.start && numbers.start <= numbers.most;
    const XmlAttribute* said = first_of({"start", "most", "least"});
    if (!is_inside && said != nullptr)
        attributes.bad_value(*said, "the first number, " + std::to_string(numbers.start) +
                                        ", is outside of " + limits);
}

}  // namespace

void load_blocks(const XmlElement& element, BlockNumbers& numbers, Attributes& attributes) {
    if (const auto are_on = attributes.choice(element, "numbers", {"off", "on", "sections"})) {
        numbers.is_on = *are_on == 1;
        numbers.at_sections = *are_on == 2;
    }
    attributes.read_number(element, "start", numbers.start);
    attributes.read_number(element, "step", numbers.step);
    attributes.read_number(element, "least", numbers.least);
    attributes.read_number(element, "most", numbers.most);
    check_blocks(element, numbers, attributes);
}

/// A sign that would end a comment and of which the dialect has nothing.
void replace_unless_given(char sign, CommentStyle& style) {
    const bool is_given = std::ranges::any_of(
        style.replacements, [sign](const auto& pair) { return pair.first == sign; });
    if (!is_given) style.replacements.emplace_back(sign, sign == ']' ? ")" : "]");
}

/// Signs of a comment that is only read.
void load_read_comment(const XmlElement& element, CommentStyle& style, Attributes& attributes) {
    CommentMarks marks{needed(element, "open").value, {}};
    Attributes::read_text(element, "close", marks.close);
    const auto begins_alike = [&](std::string_view open) {
        while (open.ends_with(' ')) open.remove_suffix(1);
        return open.starts_with(marks.open) || marks.open.starts_with(open);
    };
    const bool is_taken = begins_alike(style.open) ||
                          std::ranges::any_of(style.also_read, [&](const CommentMarks& other) {
                              return begins_alike(other.open);
                          });
    if (is_taken)
        return attributes.bad_value(needed(element, "open"), "a comment begins so already");
    style.also_read.push_back(std::move(marks));
}

void load_comment(const XmlElement& element, CommentStyle& style, Attributes& attributes) {
    style.open = needed(element, "open").value;
    style.close.clear();
    Attributes::read_text(element, "close", style.close);
    style.replacements.clear();
    style.also_read.clear();
    style.is_upper = attributes.choice(element, "case", {"any", "upper"}) == 1u;
    style.is_ascii = attributes.choice(element, "charset", {"utf8", "ascii"}) == 1u;
    attributes.read_number(element, "max_length", style.max_length);
    for (const XmlElement& replace : element.children) {
        if (replace.name == "read") {
            load_read_comment(replace, style, attributes);
            continue;
        }
        const XmlAttribute& character = needed(replace, "character");
        const XmlAttribute& by = needed(replace, "by");
        const auto is_same = [&](const auto& pair) { return pair.first == character.value[0]; };
        if (character.value.size() != 1) {
            attributes.bad_value(character, "one ASCII character is expected");
        } else if (std::ranges::any_of(style.replacements, is_same)) {
            attributes.bad_value(character, "it is replaced already");
        } else if (!style.close.empty() && by.value.find(style.close) != std::string::npos) {
            attributes.bad_value(by, "it ends the comment");
        } else {
            style.replacements.emplace_back(character.value[0], by.value);
        }
    }
    if (style.close.size() == 1) replace_unless_given(style.close[0], style);
}

namespace {

void read_repeated(const XmlElement& element, std::string_view name, Repeated& out,
                   Attributes& attributes) {
    if (const auto found = attributes.choice(element, name, {"alarm", "last"})) {
        out = *found == 1 ? Repeated::LastWins : Repeated::Alarm;
    }
}

}  // namespace

void load_notation(const XmlElement& element, Notation& notation, Attributes& attributes) {
    read_repeated(element, "repeated_address", notation.address, attributes);
    read_repeated(element, "repeated_group", notation.group, attributes);
    if (const auto found = attributes.choice(element, "case", {"upper", "any"})) {
        notation.ignores_case = *found == 1;
    }
    attributes.read_flag(element, "assignment", notation.has_assignment);
    attributes.read_flag(element, "modes", notation.has_modes);
    attributes.read_flag(element, "number_first", notation.number_first);
    attributes.read_flag(element, "blanks_inside_words", notation.blanks_inside_words);
    attributes.read_flag(element, "several_skips", notation.has_several_skips);
    if (const XmlAttribute* sign = element.find("end_sign")) {
        if (sign->value.size() == 1) notation.end_sign = sign->value[0];
        else attributes.bad_value(*sign, "one ASCII character is expected");
    }
    Attributes::read_text(element, "front_signs", notation.front_signs);
    Attributes::read_text(element, "block_end", notation.block_end);
    Attributes::read_text(element, "modal_call", notation.modal_call);
    const auto read_words = [&](std::string_view name, std::vector<std::string>& out) {
        const XmlAttribute* attribute = element.find(name);
        if (attribute == nullptr) return;
        out.clear();
        for (const XmlWord& word : words_of(*attribute)) out.push_back(word.text);
    };
    if (const XmlAttribute* codes = element.find("builder_codes")) {
        Constraint range;
        if (codes->value == "none") notation.builder_codes = {};
        else if (read_range(codes->value, range))
            notation.builder_codes = {range.least, range.most};
        else attributes.bad_value(*codes, "two whole numbers, `100..999`, or `none` are expected");
    }
    attributes.read_number(element, "most_builder_code", notation.most_builder_code);
    read_words("spindle_words", notation.spindle_words);
    read_words("code_words", notation.code_words);
    attributes.read_number(element, "skip_levels", notation.skip_levels);
    attributes.read_number(element, "default_skip", notation.default_skip);
    attributes.read_number(element, "read_line", notation.max_line);
    attributes.read_number(element, "write_line", notation.write_line);
    if (const auto found = attributes.choice(element, "line_end", {"lf", "crlf"})) {
        notation.crlf = *found == 1;
    }
}

}  // namespace kadr::nc
