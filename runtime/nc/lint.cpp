#include "nc/lint.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "base/diagnostics/dialect.h"
#include "base/text.h"
#include "nc/letters.h"
#include "nc/match.h"
#include "nc/program_head.h"
#include "nc/quoted.h"
#include "nc/reader.h"
#include "nc/tables.h"

namespace kadr::nc {

namespace {

constexpr std::string_view kAnywhere;  // of the attributes that make an element the same again

/// Elements of which a file has one for each thing, and the attributes that name the thing.
struct Unique {
    std::string_view element;
    std::array<std::string_view, 2> attributes;  // empty: none
};
constexpr Unique kUnique[] = {
    {"program", {}},
    {"blocks", {}},
    {"comment", {}},
    {"rules", {}},
    {"language", {}},
    {"address", {"name", kAnywhere}},
    {"rule", {"name", kAnywhere}},
    {"alarm", {"for", "about"}},
    {"operator", {"text", "prefix"}},
    {"function", {"form", kAnywhere}},
    {"type", {"name", kAnywhere}},
};

/// What ends a structure of the control's language.
struct StructureEnd {
    Statement begin;
    Statement end;
};
constexpr StructureEnd kStructures[] = {{Statement::If, Statement::EndIf},
                                        {Statement::While, Statement::EndLoop},
                                        {Statement::Loop, Statement::EndLoop},
                                        {Statement::For, Statement::EndLoop},
                                        {Statement::Repeat, Statement::Until},
                                        {Statement::ContourBegin, Statement::ContourEnd},
                                        {Statement::ContourCode, Statement::ContourEnd},
                                        {Statement::CallSection, Statement::EndSection}};

class SenseCheck {
  public:
    SenseCheck(const XmlElement& root, const Dialect& dialect, DiagnosticSink& sink)
        : root_(root), dialect_(dialect), tables_(dialect.tables()), sink_(sink) {}

    void run() {
        check_name();
        check_leads();
        check_forms();
        check_twice(root_);
        for (const XmlElement& element : root_.children) {
            if (element.name == "language") check_twice(element);
            if (element.name == "group") check_default(element);
            if (element.name == "group" || element.name == "command") check_codes(element);
            if (element.name == "unsupported") check_unsupported(element);
            if (element.name == "rules") check_blanks(element);
            if (element.name == "program") check_start(element);
            if (element.name == "language") check_language(element);
        }
    }

  private:
    /// `-d` finds the file by its own name.
    void check_name() {
        const XmlAttribute& name = *root_.find("name");
        const std::string file = std::filesystem::path(tables_.file).stem().string();
        if (file == name.value) return;
        sink_.report(diag::DialectNameOfFile, name.value_range).arg(name.value).arg(file);
    }

    /// The code that begins the line before a cycle is one of the dialect: where `M29` has been
    /// taken away and is a conveyor, tapping would start it.
    void check_leads() {
        for (const Form& form : tables_.forms) {
            if (form.lead.empty() || form.lead[0].kind != FormWord::Kind::Fixed) continue;
            const FormWord& code = form.lead[0];
            const CodeStart* const read = tables_.find_code(code.address, code.number);
            const bool is_own =
                read != nullptr && std::ranges::none_of(read->forms, [&](FormId id) {
                    return tables_.forms[id].function == Function::MachineFunction;
                });
            if (is_own) continue;
            sink_.report(diag::DialectContradiction, form.range).arg(code.text);
        }
    }

    /// The head brings the control to where a Kadr program begins: what it leaves otherwise no
    /// block programs again, and a cycle would drill along another axis.
    void check_start(const XmlElement& program) {
        const auto start = std::ranges::find(program.children, "start", &XmlElement::name);
        if (start == program.children.end()) return;
        ModalFunctions modal{tables_.power_on};
        for (const Block& block : blocks_of_head(dialect_))
            follow_modal(tables_.rules, block, modal);
        const Function plane = tables_.power_on[index(Group::Plane)] == Function::PlaneZx
                                   ? Function::PlaneZx  // of a lathe
                                   : Function::PlaneXy;
        for (const Function wanted :
             {plane, Function::Absolute, Function::FeedPerMinute, Function::RadiusCompOff}) {
            const Function begun = modal[index(info(wanted).group)];
            if (begun == wanted || !dialect_.can_write(wanted)) continue;
            std::string why = "a program begins under " + quoted(info(wanted).name) + ", and ";
            if (begun == Function::None) why += "nothing says so";
            else why += quoted(info(begun).name) + " acts behind this head";
            sink_.report(diag::DialectBadValue, start->range)
                .arg(start->text)
                .arg("start")
                .arg(why);
        }
    }
    static constexpr std::size_t index(Group group) { return static_cast<std::size_t>(group); }

    void check_forms() {
        for (const Form& form : tables_.forms) {
            if (form.range.file != root_.range.file) continue;
            check_motion_code(form);
            check_parameters(form);
        }
    }

    /// `G1 Z{to} R{retract}` of a cycle would take a plain line with these words for its call.
    void check_motion_code(const Form& form) {
        const FormWord& head = form.words[0];
        if (form.function != Function::Cycle || !form.is_read || head.kind != FormWord::Kind::Fixed)
            return;
        const CodeStart* const code = tables_.find_code(head.address, head.number);
        if (code == nullptr || code->simple == kNoForm) return;
        const Form& motion = tables_.forms[code->simple];
        if (info(motion.function).group != Group::Motion) return;
        sink_.report(diag::DialectConflict, form.range)
            .arg(first_line(form))
            .arg(info(motion.function).name)
            .note(motion.range, "here");
    }

    /// Two words for one value can contradict each other in a line that is read.
    void check_parameters(const Form& form) {
        if (!form.is_read || form.is_verbatim) return;
        std::vector<int> said;
        const auto take = [&](const FormWord& word) {
            if (word.kind != FormWord::Kind::Value || word.parameter < 0) return;
            if (std::ranges::find(said, word.parameter) != said.end() && !word.adds) {
                sink_.report(diag::DialectBadForm, form.range)
                    .arg(first_line(form))
                    .arg("the parameter `" +
                         std::string(tables_.parameters(form)[word.parameter].name) +
                         "` stands twice in it");
            }
            said.push_back(word.parameter);
        };
        for (const FormWord& word : form.words) {
            take(word);
            for (const FormWord& argument : word.arguments) take(argument);
        }
    }

    void check_twice(const XmlElement& parent) {
        std::map<std::string, const XmlElement*> seen;
        for (const XmlElement& element : parent.children) {
            const auto unique = std::ranges::find(kUnique, element.name, &Unique::element);
            if (unique == std::end(kUnique)) continue;
            std::string key = element.name;
            for (const std::string_view attribute : unique->attributes) {
                const XmlAttribute* value = element.find(attribute);
                key += '\n';
                if (value != nullptr) key += value->value;
            }
            const auto [first, is_new] = seen.emplace(key, &element);
            if (is_new) continue;
            sink_.report(diag::DialectTwice, element.range)
                .arg(shown(element, *unique))
                .note(first->second->range, "here");
        }
    }

    /// `<address name="X">`
    static std::string shown(const XmlElement& element, const Unique& unique) {
        std::string text = '<' + element.name;
        for (const std::string_view attribute : unique.attributes) {
            const XmlAttribute* value = element.find(attribute);
            if (value == nullptr) continue;
            text += ' ' + value->name + "=\"" + shown_value(value->value) + '"';
        }
        return text + '>';
    }

    // ------------------------------------------------------------ groups and codes

    int group_named(std::string_view name) const {
        const auto found = std::ranges::find(tables_.groups, name, &DialectGroup::name);
        return static_cast<int>(found - tables_.groups.begin());
    }

    /// A group that has members begins with one of them.
    void check_default(const XmlElement& element) {
        const XmlAttribute* attribute = element.find("default");
        if (attribute == nullptr) return;
        const int group = group_named(element.find("name")->value);
        const auto is_member = [&](const Form& form) { return form.group == group; };
        if (std::ranges::none_of(tables_.forms, is_member)) return;
        for (const XmlWord& word : words_of(*attribute)) {
            const std::optional<Function> function = find_function(word.text);
            if (!function) continue;
            const bool is_given = std::ranges::any_of(tables_.forms, [&](const Form& form) {
                return form.function == *function ||
                       std::ranges::find(form.sets, *function) != form.sets.end();
            });
            const bool is_own = std::ranges::any_of(tables_.forms, [&](const Form& form) {
                const bool says = form.function == *function ||
                                  std::ranges::find(form.sets, *function) != form.sets.end();
                return says && is_member(form);
            });
            // What no code programs at all is in force until one programs another.
            if (is_own || !is_given) continue;
            sink_.report(diag::DialectDefaultStranger, word.range)
                .arg(word.text)
                .arg(element.find("name")->value);
        }
    }

    /// Codes that stand for themselves read as what they mean.
    void check_codes(const XmlElement& element) {
        for (const XmlElement& child : element.children) {
            const bool is_code = child.name == "code";
            const XmlAttribute* text = is_code ? child.find("text") : nullptr;
            if (text == nullptr || !is_plain(*text)) continue;
            DiagnosticList messages;
            WholeText source(text->value);
            Reader reader(dialect_, source, "code", messages);
            std::array<Block, 1> blocks;
            const bool is_read = reader.pull(blocks) == 1 && !messages.has_errors();
            if (is_read) continue;
            const std::string why = messages.has_errors() ? messages.all().back().message()
                                                          : "no line with it makes a block";
            sink_.report(diag::DialectNeverRead, text->value_range).arg(text->value).arg(why);
        }
    }

    /// Whether the form is one word, read, and nothing around it has to be so.
    bool is_plain(const XmlAttribute& text) const {
        const auto form = std::ranges::find_if(tables_.forms, [&](const Form& one) {
            return one.pattern == text.value && one.range.begin == text.value_range.begin;
        });
        return form != tables_.forms.end() && form->is_read && !form->is_comment &&
               form->words.size() == 1 && form->during.empty() && form->unsupported.empty() &&
               info(form->function).parameters.empty() && form->function != Function::Cycle;
    }

    // ------------------------------------------------------------ words without effect

    void check_unsupported(const XmlElement& element) {
        for (const XmlWord& word : words_of(*element.find("words"))) {
            const char first = word.text[0];
            if (first == '(' && tables_.has_bracket_calls) continue;
            if (!is_letter(first) && first != '$' && first != '#') {
                sink_.report(diag::DialectNeverRead, word.range)
                    .arg(word.text)
                    .arg("no word begins with `" + std::string(1, first) + "`");
                continue;
            }
            const auto reads = [&](const Form& form) {
                const bool is_code = form.words[0].kind == FormWord::Kind::Fixed;
                const bool begins = is_code && form.words[0].text == word.text;
                return form.is_read && (begins || form.pattern == word.text) &&
                       form.unsupported.empty();
            };
            const auto form = std::ranges::find_if(tables_.forms, reads);
            if (form == tables_.forms.end()) continue;
            sink_.report(diag::DialectContradiction, word.range)
                .arg(word.text)
                .note(form->range, "here it is read");
        }
    }

    /// `LBL` would be the letters L, B and L where blanks may stand inside of words.
    void check_blanks(const XmlElement& element) {
        const XmlAttribute* attribute = element.find("blanks_inside_words");
        if (attribute == nullptr || !tables_.notation.blanks_inside_words) return;
        for (const XmlElement& child : root_.children) {
            const XmlAttribute* name = child.name == "address" ? child.find("name") : nullptr;
            if (name == nullptr || name->value.size() < 2 || name->value[0] == ',') continue;
            sink_.report(diag::DialectContradiction, name->value_range)
                .arg(name->value)
                .note(attribute->value_range, "here blanks may stand inside of words");
        }
    }

    // ------------------------------------------------------------ the control's own language

    void check_language(const XmlElement& language) {
        for (const XmlElement& element : language.children) {
            if (element.name == "statement") check_statement(element);
            if (element.name == "begins") check_begins(element);
        }
    }

    const StatementForm* form_of(const XmlElement& element) const {
        const auto& forms = tables_.language.statements;
        const auto found = std::ranges::find(forms, element.text, &StatementForm::form);
        return found == forms.end() ? nullptr : &*found;
    }

    /// Whether a statement ends what the other one begins.
    static bool ends(const StatementForm& form, const StructureEnd& structure) {
        if (form.statement != structure.end) return false;
        if (structure.end != Statement::EndLoop) return true;
        return (form.closes >> static_cast<unsigned>(structure.begin) & 1u) != 0;
    }

    void check_statement(const XmlElement& element) {
        const StatementForm* form = form_of(element);
        if (form == nullptr) return;
        for (const StructureEnd& structure : kStructures) {
            const bool is_ended = std::ranges::any_of(
                tables_.language.statements,
                [&](const StatementForm& other) { return ends(other, structure); });
            if (structure.begin != form->statement || is_ended) continue;
            sink_.report(diag::DialectNoEnd, element.text_range)
                .arg(form->form)
                .arg(info(structure.end).name);
        }
        check_first_word(element, *form);
    }

    /// Of a label and a call with one first word the search for the label finds the call, unless
    /// what stands behind tells them apart.
    void check_first_word(const XmlElement& element, const StatementForm& form) {
        if (form.statement != Statement::Label) return;
        for (const StatementForm& other : tables_.language.statements) {
            const bool is_like =
                other.statement != Statement::Label && other.tokens[0].text == form.tokens[0].text;
            if (!is_like || is_told_apart(form, other)) continue;
            sink_.report(diag::DialectNeverRead, element.text_range)
                .arg(form.form)
                .arg("`" + other.form +
                     "` begins with the same word, and a search for the label "
                     "would find it");
            return;
        }
    }

    /// A word or a sign of one pattern, at an index where the other has another one; or a pattern
    /// that goes on where the other one has ended.
    static bool is_told_apart(const StatementForm& a, const StatementForm& b) {
        const std::size_t both = std::min(a.tokens.size(), b.tokens.size());
        for (std::size_t i = 0; i < both; ++i) {
            const StatementToken& one = a.tokens[i];
            const StatementToken& other = b.tokens[i];
            const bool has_text =
                one.kind != StatementToken::Kind::Hole && other.kind != StatementToken::Kind::Hole;
            if (has_text && one.text != other.text) return true;
        }
        const StatementForm& longer = a.tokens.size() > both ? a : b;
        return longer.tokens.size() > both && !longer.tokens[both].is_optional;
    }

    /// `O{n}` begins a program, `O{loop} WHILE …` would be a head for the reader.
    void check_begins(const XmlElement& element) {
        const XmlAttribute& program = *element.find("program");
        const std::size_t hole = program.value.find('{');
        if (hole == 0 || hole == std::string::npos) return;
        const std::string_view front = std::string_view(program.value).substr(0, hole);
        for (const StatementForm& form : tables_.language.statements) {
            const bool has_hole =
                form.tokens.size() > 1 && form.tokens[1].kind == StatementToken::Kind::Hole;
            if (form.tokens[0].text != front || !has_hole) continue;
            sink_.report(diag::DialectNeverRead, program.value_range)
                .arg(form.form)
                .arg("a line that begins so is the head of a program, `" + program.value + "`");
            return;
        }
    }

    const XmlElement& root_;
    const Dialect& dialect_;
    const DialectTables& tables_;
    DiagnosticSink& sink_;
};

}  // namespace

void check_sense(const XmlElement& root, const Dialect& dialect, DiagnosticSink& sink) {
    SenseCheck(root, dialect, sink).run();
}

}  // namespace kadr::nc
