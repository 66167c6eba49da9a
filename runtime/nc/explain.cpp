// What a dialect holds about a word, in sentences; made from the same tables that read and write.
#include <algorithm>

#include "base/numbers.h"
#include "base/text.h"
#include "nc/builder_codes.h"
#include "nc/explain_parts.h"
#include "nc/mode_words.h"
#include "nc/quoted.h"
#include "nc/tables.h"

namespace kadr::nc {

namespace {

class Explainer {
  public:
    Explainer(const DialectTables& tables) : tables_(tables) {}

    std::vector<std::string> explain(std::string_view word) {
        if (const auto function = find_function(word)) explain_function(*function);
        for (std::size_t i = 0; i < tables_.cycles.size(); ++i) {
            if (tables_.cycles[i].name == word) explain_cycle(static_cast<CycleId>(i));
        }
        const std::string text =
            tables_.notation.ignores_case ? upper_ascii(word) : std::string(word);
        explain_text(text);
        explain_program(text);
        explain_language(tables_.language, text, lines_);
        explain_mode(text);
        const std::string unsupported = tables_.unsupported_words(text);
        if (lines_.empty() && !unsupported.empty())
            lines_.push_back(unsupported + " is a word of the control; Kadr does not read it");
        const auto passed = std::ranges::find_if(tables_.passed, [&](const auto& entry) {
            return entry.first == word || entry.first == text;
        });
        if (passed != tables_.passed.end())
            lines_.push_back(passed->first + ": " + passed->second.meaning +
                             "; it is read, and has no effect here");
        return std::move(lines_);
    }

  private:
    void explain_function(Function function) {
        const FunctionInfo& row = info(function);
        lines_.push_back(std::string(row.name).append(": ").append(row.meaning));
        std::string parameters;
        for (const Parameter& parameter : row.parameters) add_parameter(parameters, parameter);
        if (!parameters.empty()) lines_.push_back("parameters: " + parameters);
        if (row.group != Group::NonModal) {
            lines_.push_back(std::string("modal, group ").append(group_name(row.group)));
        }
        std::size_t spelled = 0;
        for (const Form& form : tables_.forms) {
            if (form.function != function) continue;
            explain_form(form);
            ++spelled;
        }
        if (spelled == 0) lines_.push_back(tables_.name + " has no spelling for it");
        explain_examples(row.name);
    }

    void explain_cycle(CycleId cycle) {
        const CycleInfo& row = tables_.cycles[cycle];
        lines_.push_back(row.name + ": " + row.meaning);
        std::string parameters;
        for (const Parameter& parameter : row.parameters) add_parameter(parameters, parameter);
        lines_.push_back("parameters: " + parameters);
        std::size_t spelled = 0;
        for (const Form& form : tables_.forms) {
            if (form.function != Function::Cycle || form.cycle != cycle) continue;
            explain_form(form);
            ++spelled;
        }
        if (spelled == 0) {
            lines_.push_back(tables_.name +
                             " has no such cycle of its own; it is written as moves");
        }
        explain_examples(row.name);
    }

    static void add_parameter(std::string& out, const Parameter& parameter) {
        if (!out.empty()) out += ", ";
        out.append(parameter.name).append(" (").append(dimension_name(parameter.dimension));
        out += parameter.is_optional ? ", optional)" : ")";
    }

    void explain_form(const Form& form) {
        std::string line = form.is_written && form.is_read ? "written and read as "
                           : form.is_written               ? "written as "
                                                           : "read as ";
        std::string pattern = form.pattern;
        for (std::size_t at = 0; (at = pattern.find('\n', at)) != std::string::npos;) {
            const std::size_t end = std::min(pattern.find_first_not_of(" \n", at), pattern.size());
            pattern.replace(at, end - at, " ⏎ ");
        }
        line += quoted(pattern);
        for (const Constraint& c : form.when) {
            line += ", ";
            line += tables_.parameters(form)[static_cast<std::size_t>(c.parameter)].name;
            line += " from ";
            append_shortest(line, c.least);
            line += " to ";
            append_shortest(line, c.most);
        }
        if (!form.sets.empty()) {
            line += ", with";
            for (const Function also : form.sets) line.append(" ").append(info(also).name);
        }
        if (form.owns_block) line += ", in a block of its own";
        if (form.owns_axes) line += ", without a motion in its block";
        if (form.owns_line) line += ", without axis words in its block, written in one of its own";
        if (form.owns_address) line += ", alone among its address";
        if (!form.unsupported.empty()) line += ", not executed: " + form.unsupported;
        if (form.is_preset) line += ", for the calls that follow";
        if (!form.note.empty()) line += "; " + form.note;
        if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
        if (!form.doc.empty() &&
            std::find(lines_.begin(), lines_.end(), form.doc) == lines_.end()) {
            lines_.push_back(form.doc);
        }
    }

    void explain_examples(std::string_view name) {
        for (const Example& example : tables_.examples) {
            if (!example.source.starts_with(std::string(name) + "(")) continue;
            std::string line =
                "example: " + quoted(example.source) + " is written " + quoted(example.text);
            if (!example.meaning.empty()) line += ": " + example.meaning;
            lines_.push_back(std::move(line));
        }
    }

    /// The word in front of a program, with its number or name: `O`, `O1234`, `%`.
    void explain_program(std::string_view text) {
        const ProgramTemplates& program = tables_.program;
        const std::string_view word = text.substr(0, text.find_last_not_of("0123456789") + 1);
        for (const std::string& header : program.header) {
            const bool has_number = header.starts_with(std::string(word) + "{number");
            if (word.empty() || (header != text && !has_number)) continue;
            std::string line = quoted(header) + " stands in front of a program";
            if (has_number && program.most_number > 0) {
                line += ": its number, from " + std::to_string(program.least_number) + " to " +
                        std::to_string(program.most_number);
            }
            lines_.push_back(std::move(line));
        }
    }

    /// A word as it stands in the control's text: `X`, `G83`, `G54.1`, `TRANS`.
    void explain_text(std::string_view text) {
        if (const AddressId id = tables_.find_address(text); id != kNoAddress)
            return explain_address(id);
        const std::size_t digits = text.find_first_of("0123456789");
        if (digits == std::string_view::npos || digits == 0) return;
        const AddressId id = tables_.find_address(text.substr(0, digits));
        if (id == kNoAddress) return;
        const Decimal number = parse_decimal(text.data() + digits, text.data() + text.size());
        if (number.end != text.data() + text.size()) return;
        const CodeStart* code = tables_.find_code(id, number.value);
        if (code == nullptr) return explain_builder_code(id, number.value);
        for (const FormId form : code->forms) {
            explain_meaning(tables_.forms[form]);
        }
    }

    /// `M117`: of the builder by its number, without a form of its own.
    void explain_builder_code(AddressId id, double number) {
        if (!is_passed_to_builder(tables_, id, number)) return;
        const FunctionInfo& row = info(Function::MachineFunction);
        lines_.push_back(std::string(row.name).append(": ").append(row.meaning));
        for (const Form& form : tables_.forms)
            if (form.is_by_number && is_builder_code(tables_, id, number)) explain_form(form);
    }

    /// `AC`, `IC`: around the value of a word.
    void explain_mode(std::string_view text) {
        if (!tables_.notation.has_modes || !tables_.notation.has_assignment) return;
        for (const ModeWord& mode : kModeWords) {
            if (mode.name != text) continue;
            std::string line = quoted(text) + " around the value of a word, ";
            line += quoted("X=" + std::string(text) + "(10)");
            lines_.push_back(line.append(": ").append(mode.meaning));
        }
    }

    void explain_meaning(const Form& form) {
        if (form.function == Function::None) {
            lines_.push_back("accepted, without effect on what Kadr executes");
            return explain_form(form);
        }
        const bool is_cycle = form.function == Function::Cycle;
        const std::string_view name =
            is_cycle ? tables_.cycles[form.cycle].name : info(form.function).name;
        const std::string_view meaning =
            is_cycle ? tables_.cycles[form.cycle].meaning : info(form.function).meaning;
        std::string line =
            std::string(is_cycle ? "the cycle " : "").append(name).append(": ").append(meaning);
        if (std::find(lines_.begin(), lines_.end(), line) == lines_.end())
            lines_.push_back(std::move(line));
        explain_form(form);
    }

    void explain_address(AddressId id) {
        const Address& address = tables_.addresses[id];
        std::string line = quoted(address.name);
        switch (address.kind) {
            case Address::Kind::Value: line += " is an address"; break;
            case Address::Kind::Code: line += " is followed by the number of a function"; break;
            case Address::Kind::Word: line += " is a word by itself"; break;
            case Address::Kind::Call: line += " is a call"; break;
        }
        if (!address.doc.empty()) line += ": " + address.doc;
        lines_.push_back(std::move(line));
        if (address.kind == Address::Kind::Value && !address.is_block_number)
            explain_format(address);
        for (const FormId form : address.forms) explain_meaning(tables_.forms[form]);
    }

    void explain_format(const Address& address) {
        const NumberFormat& format = address.format;
        std::string line = "its number is written with up to ";
        append_shortest(line, format.decimals);
        line += " decimals";
        if (format.point == PointRule::Always) line += " and always a decimal point";
        if (format.point == PointRule::Never)
            line = "its number is written without a decimal point";
        if (format.increment > 0) {
            line += "; without a point 1 means ";
            append_shortest(line, format.increment);
        }
        lines_.push_back(std::move(line));
    }

    const DialectTables& tables_;
    std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> explain(const Dialect& dialect, std::string_view word) {
    return Explainer(dialect.tables()).explain(word);
}

}  // namespace kadr::nc
