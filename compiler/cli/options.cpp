#include "cli/options.h"

#include <algorithm>
#include <array>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "base/disk_files.h"
#include "base/numbers.h"
#include "base/unicode.h"
#include "driver/amount.h"
#include "driver/operator_events.h"
#include "driver/outputs.h"
#include "machine/machine.h"

namespace kadr::cli {

namespace {

constexpr const char* kAbout =
    "Kadr: parametric NC programs in a C-like language, written as ISO-7bit text for a control,\n"
    "executed and timed before a machine is.";
constexpr const char* kEpilogue =
    "SRC is a Kadr program (.kadr) or ISO-7bit text (anything else); - is standard input.\n"
    "Exit status: 0 done, 1 the program has errors, 2 wrong usage or unreadable file,\n"
    "3 an alarm while running. `man kadr` says more.";

/// Seconds of `1ms`, `0.002s`, `500us`. A bare number could be either: it is none. Throws what
/// CLI11 expects.
double parse_time(const std::string& text, const char* option) {
    const auto seconds = driver::seconds_of(text);
    if (!seconds)
        throw CLI::ValidationError(option, "`" + text + "` is not a time; write `1ms` or `0.002s`");
    return *seconds;
}

/// Bytes of `4GiB`, `200MB`, `64k`, `1000`.
std::uint64_t parse_size(const std::string& text, const char* option) {
    struct Unit {
        std::string_view name;
        double bytes;
    };
    static constexpr std::array<Unit, 12> kUnits = {{{"", 1},
                                                     {"B", 1},
                                                     {"kB", 1e3},
                                                     {"MB", 1e6},
                                                     {"GB", 1e9},
                                                     {"TB", 1e12},
                                                     {"KiB", 1024.0},
                                                     {"MiB", 1048576.0},
                                                     {"GiB", 1073741824.0},
                                                     {"TiB", 1099511627776.0},
                                                     {"M", 1048576.0},
                                                     {"G", 1073741824.0}}};
    const driver::Amount amount = driver::amount_of(text).value_or(driver::Amount());
    const auto unit = std::ranges::find(kUnits, amount.unit, &Unit::name);
    constexpr double kMost = 1e18;
    const double bytes = unit == kUnits.end() ? 0 : amount.value * unit->bytes;
    if (!(bytes >= 1) || bytes > kMost) {
        throw CLI::ValidationError(option, "`" + text + "` is not a size; write `500MB` or `2GiB`");
    }
    return static_cast<std::uint64_t>(bytes);
}

/// Millimetres of `5um`, `0.003mm`, `0.0001in`.
double parse_length(const std::string& text, const char* option) {
    const auto [value, unit] = driver::amount_of(text).value_or(driver::Amount());
    const double factor = unit == "mm" ? 1.0 : unit == "um" ? 1e-3 : unit == "in" ? 25.4 : 0.0;
    if (factor == 0 || value <= 0) {
        throw CLI::ValidationError(option,
                                   "`" + text + "` is not a length; write `5um` or `0.005mm`");
    }
    return value * factor;
}

/// A decimal number, which neither infinity nor "nan" is. What it returns is what CLI11 shows.
std::string check_number(const std::string& text) {
    const char* const end = text.data() + text.size();
    const bool is_number = !text.empty() && parse_decimal(text.data(), end).end == end;
    return is_number ? std::string() : '`' + text + "` is not a number";
}

/// As for the tick of a machine: the path between two setpoints tells nothing beyond a second.
double parse_tick(const std::string& text) {
    const double tick = parse_time(text, "--tick");
    if (tick < machine::kShortestTick || tick > machine::kLongestTick)
        throw CLI::ValidationError("--tick", "`" + text + "` is not from 1 us to 1 s");
    return tick;
}

sema::Define parse_define(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) {
        throw CLI::ValidationError("-D", "`" + text + "` is not of the form name=value");
    }
    return {composed(std::string_view(text).substr(0, equals)), text.substr(equals + 1)};
}

/// The values are in the name of the option's argument already.
CLI::Validator one_of(std::vector<std::string> values) {
    return CLI::IsMember(std::move(values)).description("");
}

CLI::Validator is_count(const char* of) {
    const auto check = [of](const std::string& text) -> std::string {
        const Decimal number = parse_decimal(text.data(), text.data() + text.size());
        const bool is_number = number.end == text.data() + text.size() && !text.empty();
        if (is_number && number.value >= 1) return {};
        return '`' + text + "` is not a number of " + of + ": it is 1 or more";
    };
    return {check, ""};
}

CLI::Validator is_assignment() {
    const auto check = [](const std::string& text) -> std::string {
        const std::size_t equals = text.find('=');
        if (equals != 0 && equals != std::string::npos && equals + 1 < text.size()) return {};
        return '`' + text + "` is not of the form NAME=VALUE";
    };
    return {check, ""};
}

/// Of a flag that may say a format: without one CLI11 says "true".
CLI::Validator is_format() {
    const auto check = [](const std::string& text) -> std::string {
        if (text == "true" || text == "text" || text == "json") return {};
        return '`' + text + "` is no format: there are text and json";
    };
    return {check, ""};
}

CLI::Validator is_folder() {
    const auto check = [](const std::string& name) -> std::string {
        if (disk().is_folder(name)) return {};
        return "there is no folder `" + name + "`";
    };
    return {check, ""};
}

/// Everything that CLI11 writes into, and what becomes of it.
class Parser {
  public:
    Parser();
    CommandLine parse(int count, const char* const* arguments);
    std::string message(const CLI::ParseError& error, int& status) const;
    std::string commands_message() const;
    static void refuse_empty_values(const CLI::App& command);
    void take_compared();
    void take_listed();
    void take_operator();
    double take_override(const std::string& text, const char* option, motion::OperatorAct act,
                         double most);

  private:
    CLI::App* add(CLI::App& parent, const char* name, const char* text, Verb verb);
    void add_dialect(CLI::App& command);
    void add_program(CLI::App& command);
    void add_include(CLI::App& command);
    void add_tools(CLI::App& command);
    void add_search(CLI::App& command);
    void add_inputs(CLI::App& command);
    void add_call(CLI::App& command);
    void add_reading(CLI::App& command);
    void add_writing(CLI::App& command);
    void add_solve(CLI::App& machine);
    void add_cycles(CLI::App& command);
    void add_expansion(CLI::App& command);
    void add_output(CLI::App& command, const driver::OutputRow& row);
    void check_settings() const;
    void add_limits(CLI::App& command);
    void add_expand();
    void add_run();
    void add_compare();
    void add_check();
    void add_test();
    void add_format();
    void add_repl();
    void add_tables();

    CLI::App app_{kAbout, "kadr"};
    CommandLine line_;
    std::string source_;
    std::string cycles_ = "native";
    std::string summary_;  // of a comparison
    std::string listed_;   // parameters: text or json; empty: a program is written
    std::string threads_;
    std::string messages_ = "text";
    std::string tick_;
    std::string feed_override_;
    std::string rapid_override_;
    std::vector<std::string> holds_;
    std::string max_time_;
    std::string max_input_;
    std::string max_output_;
    std::vector<std::string> defines_;
    std::vector<int> skips_;
    std::vector<std::string> compared_;  // sources
    std::vector<std::string> controls_;  // of them
    std::string tolerance_;
    bool is_check_ = false;
};

Parser::Parser() {
    app_.set_version_flag("--version", "kadr " KADR_VERSION);
    app_.set_help_flag("-h,--help", "show this help");
    app_.require_subcommand(1);
    app_.footer(kEpilogue);
    add_expand();
    add_run();
    add_compare();
    add_check();
    add_test();
    add_format();
    add_repl();
    add_tables();
}

CLI::App* Parser::add(CLI::App& parent, const char* name, const char* text, Verb verb) {
    CLI::App* command = parent.add_subcommand(name, text);
    command->callback([this, verb] { line_.verb = verb; });
    if (verb == Verb::Repl) return command;  // a conversation is for people
    command->add_option("--diagnostics", messages_, "messages as text or as one JSON object a line")
        ->check(one_of({"text", "json"}))
        ->type_name("text|json");
    return command;
}

void Parser::add_dialect(CLI::App& command) {
    command.add_option("-d,--dialect", line_.options.dialect, "control: a name or an XML file")
        ->type_name("DIALECT");
}

void Parser::add_include(CLI::App& command) {
    command
        .add_option("-I,--include", line_.options.folders, "folder in which imports are looked for")
        ->check(is_folder())
        ->type_name("DIR")
        ->allow_extra_args(false);
    add_reading(command);
}

/// What holds for all files that are read.
void Parser::add_reading(CLI::App& command) {
    command
        .add_option("--allow-read", line_.options.allow_read,
                    "folder whose files the program may read, besides its own")
        ->check(is_folder())
        ->type_name("DIR")
        ->allow_extra_args(false);
    command
        .add_option("--max-input", max_input_,
                    "size of a program, table or image at most (256MiB unless it is given)")
        ->type_name("SIZE");
}

void Parser::add_writing(CLI::App& command) {
    command
        .add_option("--max-output", max_output_,
                    "size of all outputs together at most (4GiB unless it is given)")
        ->type_name("SIZE");
}

void Parser::add_program(CLI::App& command) {
    command.add_option("-D,--define", defines_, "value of a parameter of the program")
        ->type_name("name=value")
        ->allow_extra_args(false);
    add_include(command);
    command.add_option("--program", line_.options.program, "which program of the file")
        ->type_name("NAME");
}

void Parser::add_tools(CLI::App& command) {
    command
        .add_option("--tools", line_.options.tools,
                    "tool library, CSV or XML; else the machine file may name one")
        ->type_name("FILE");
}

void Parser::add_search(CLI::App& command) {
    command
        .add_option("--search", line_.options.search,
                    "folder with programs that ISO-7bit text calls, besides its own")
        ->check(is_folder())
        ->type_name("DIR")
        ->allow_extra_args(false);
}

void Parser::add_inputs(CLI::App& command) {
    command
        .add_option("--set", line_.options.sets,
                    "an input from the machine: '#500=12.5', 'R5=2', '$A_IN[3]=1'")
        ->check(is_assignment())
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    command
        .add_option("--variables-in", line_.options.variable_files,
                    "a file of such values: of --variables, or as the control puts it out")
        ->type_name("FILE")
        ->allow_extra_args(false);
}

void Parser::add_call(CLI::App& command) {
    command
        .add_option("--call", line_.options.call,
                    "call the program with these arguments: 'A1. B2.', '(1, 2.5)'")
        ->type_name("ARGUMENTS");
}

void Parser::add_cycles(CLI::App& command) {
    command
        .add_option(
            "--cycles", cycles_,
            "the control's own cycles, modal where calls are equal; each call by itself; or "
            "single moves")
        ->check(one_of({"native", "calls", "moves"}))
        ->type_name("native|calls|moves");
}

void Parser::add_expansion(CLI::App& command) {
    add_cycles(command);
    command.add_flag("--verbose-modal", line_.options.verbose_modal, "repeat modal words");
    add_limits(command);
    for (const driver::OutputRow& row : driver::output_rows()) {
        if (row.kind == driver::OutputRow::Kind::FileOfExpansion) add_output(command, row);
    }
}

/// The option of an output or a setting. `a|b` are words, of which it takes one.
void Parser::add_output(CLI::App& command, const driver::OutputRow& row) {
    using Kind = driver::OutputRow::Kind;
    const std::string flag(row.flag);
    const std::string value(row.value);
    CLI::Option* option =
        command.add_option(flag, line_.run.outputs[flag], std::string(row.help))->type_name(value);
    const bool has_words = row.kind == Kind::Word || (row.kind == Kind::Setting && !row.fault);
    if (has_words) option->check(one_of(CLI::detail::split(value, '|')));
}

void Parser::add_limits(CLI::App& command) {
    command
        .add_option("--max-blocks", line_.options.max_blocks,
                    "stop after so many blocks, lines of the control's own language among them "
                    "(made: 20000000 unless it is given)")
        ->check(is_count("blocks"))
        ->type_name("N");
    command.add_option("--max-time", max_time_, "stop after so much time of computing")
        ->type_name("TIME");
}

void Parser::add_expand() {
    CLI::App* command = add(app_, "expand", "write a Kadr program as ISO-7bit text", Verb::Expand);
    command->add_option("SRC", source_, "Kadr program")->required();
    add_dialect(*command);
    command->add_option("-o,--output", line_.expand.output, "file for the text")->type_name("OUT");
    command
        ->add_option(
            "-m,--machine", line_.options.machine,
            "machine for which tilted planes are worked out and dangers are looked for: a name "
            "or an XML file")
        ->type_name("MACHINE");
    add_tools(*command);
    add_program(*command);
    add_expansion(*command);
    add_writing(*command);
    command
        ->add_flag("--parameters", listed_,
                   "list the parameters of the programs instead; --parameters=json for a program")
        ->check(is_format());
}

void Parser::add_run() {
    CLI::App* command = add(app_, "run", "execute a program and report its motion", Verb::Run);
    driver::RunJob& job = line_.run;
    driver::Options& options = line_.options;
    command->add_option("SRC", source_, "Kadr program or ISO-7bit text")->required();
    add_dialect(*command);
    command->add_option("-m,--machine", options.machine, "machine: a name or an XML file")
        ->type_name("MACHINE");
    add_tools(*command);
    add_search(*command);
    add_inputs(*command);
    add_call(*command);
    add_program(*command);
    add_expansion(*command);
    add_writing(*command);
    for (const driver::OutputRow& row : driver::output_rows()) {
        if (row.kind != driver::OutputRow::Kind::FileOfExpansion) add_output(*command, row);
    }
    command->add_option("--break", job.breaks, "stop in front of a block, a line, a name")
        ->type_name("BLOCK|NAME")
        ->allow_extra_args(false);
    command->add_option("--until", job.until, "the program ends in front of it")
        ->type_name("BLOCK|NAME")
        ->allow_extra_args(false);
    command->add_option("--tick", tick_, "time between setpoints")->type_name("TIME");
    command->add_option("--threads", threads_, "plan, sample and write setpoints at the same time")
        ->check(one_of({"on", "off"}))
        ->type_name("on|off");
    command
        ->add_option("--feed-override", feed_override_,
                     "the switch for the feed, 1 to 200 %; 100%,5s:50% turns it at 5 s")
        ->type_name("PERCENT");
    command
        ->add_option("--rapid-override", rapid_override_,
                     "the switch for rapid, 1 to 100 %, and turned as that for the feed")
        ->type_name("PERCENT");
    command->add_option("--hold", holds_, "feed hold at a time or block, and cycle start: 5s..7s")
        ->type_name("FROM..TO")
        ->allow_extra_args(false);
    command->add_option("--events", job.events, "what the operator does meanwhile, line by line")
        ->type_name("FILE");
    command->add_option("--skip", skips_, "leave out blocks of this skip level")
        ->check(CLI::Range(0, 9).description(""))
        ->type_name("LEVEL")
        ->allow_extra_args(false);
    command->add_flag("--optional-stop", options.optional_stop, "M1 stops");
    command
        ->add_option("--passes", options.passes,
                     "how often a main program is executed that begins itself again (M99)")
        ->check(is_count("passes"))
        ->type_name("N");
}

void Parser::add_compare() {
    CLI::App* command =
        add(app_, "compare", "whether two programs move the same way", Verb::Compare);
    command->add_option("SRC", compared_, "one source for two controls, or two sources")
        ->required()
        ->expected(1, 2);
    command->add_option("-d,--dialect", controls_, "control of the first, and of the second source")
        ->type_name("DIALECT")
        ->allow_extra_args(false);
    command->add_option("-m,--machine", line_.options.machine, "machine: a name or an XML file")
        ->type_name("MACHINE");
    add_tools(*command);
    command->add_option("--tolerance", tolerance_, "how far the paths may be apart")
        ->type_name("LENGTH");
    add_search(*command);
    add_inputs(*command);
    add_program(*command);
    add_cycles(*command);
    add_limits(*command);
    command->add_option("--summary", summary_, "for a person or for a program")
        ->check(one_of({"text", "json"}))
        ->type_name("text|json");
}

void Parser::add_check() {
    CLI::App* command = add(app_, "check", "find mistakes, write nothing", Verb::Check);
    command->add_option("SRC", line_.sources, "Kadr programs or ISO-7bit texts")->required();
    add_dialect(*command);
    add_search(*command);
    add_inputs(*command);
    add_call(*command);
    command->add_option("-m,--machine", line_.options.machine, "machine: a name or an XML file")
        ->type_name("MACHINE");
    add_tools(*command);
    add_include(*command);
    add_limits(*command);
}

void Parser::add_test() {
    CLI::App* command = add(app_, "test", "run the tests and properties of programs", Verb::Test);
    command->add_option("SRC", line_.test.sources, "Kadr programs")->required();
    add_dialect(*command);
    command->add_option("-m,--machine", line_.options.machine, "machine: a name or an XML file")
        ->type_name("MACHINE");
    add_tools(*command);
    command->add_option("--filter", line_.test.filter, "only tests with this in their name")
        ->type_name("TEXT");
    command->add_option("--runs", line_.test.runs, "sets of values of each property")
        ->check(CLI::Range(1, 1000000).description(""))
        ->type_name("N");
    command->add_option("--seed", line_.test.seed, "of the values")->type_name("N");
    command->add_option("-D,--define", defines_, "value of a parameter: one run of a property")
        ->type_name("name=value")
        ->allow_extra_args(false);
    add_include(*command);
    add_cycles(*command);
}

void Parser::add_format() {
    CLI::App* command = add(app_, "fmt", "lay out Kadr programs", Verb::Format);
    command->add_option("SRC", line_.sources, "Kadr programs")->required();
    command->add_flag("--check", is_check_, "write nothing, report files that would change");
}

void Parser::add_repl() {
    CLI::App* command =
        add(app_, "repl", "try statements, blocks and calls at a prompt", Verb::Repl);
    add_dialect(*command);
    command->add_option("-m,--machine", line_.options.machine, "machine: a name or an XML file")
        ->type_name("MACHINE");
    add_tools(*command);
    add_include(*command);
}

void Parser::add_tables() {
    CLI::App* explain = add(app_, "explain", "what a message means, with examples", Verb::Explain);
    explain->add_option(
        "CODE", line_.word,
        "its number, K1001, or that of an alarm, PS0011; without one all are listed");

    CLI::App* dialect = app_.add_subcommand("dialect", "the descriptions of controls");
    dialect->require_subcommand(1);
    add(*dialect, "list", "which dialects there are", Verb::DialectList);
    add(*dialect, "check", "find mistakes in a dialect file", Verb::DialectCheck)
        ->add_option("FILE", line_.file, "dialect file or name")
        ->required();
    CLI::App* word =
        add(*dialect, "explain", "what a word means on a control", Verb::DialectExplain);
    word->add_option("FILE", line_.file, "dialect file or name")->required();
    word->add_option("WORD", line_.word,
                     "as it stands in a program: G83, CR, M3; without one all commands are listed");

    CLI::App* machine = app_.add_subcommand("machine", "the descriptions of machines");
    machine->require_subcommand(1);
    add(*machine, "list", "which machines there are", Verb::MachineList);
    add(*machine, "check", "find mistakes in a machine file", Verb::MachineCheck)
        ->add_option("FILE", line_.file, "machine file or name")
        ->required();
    add_solve(*machine);
}

void Parser::add_solve(CLI::App& machine) {
    CLI::App* solve = add(machine, "solve", "where the tool stands, and which axes put it there",
                          Verb::MachineSolve);
    driver::SolveJob& job = line_.solve;
    solve->add_option("FILE", job.machine, "machine file or name")->required();
    CLI::Option* axes = solve->add_option(
        "--axes", job.axes, "where the axes stand: \"X1 Y2 Z3 A30 C45\"; gives tip and direction");
    CLI::Option* at = solve->add_option("--at", job.at, "the tip: X0,Y0,Z100; gives the axes");
    CLI::Option* tool = solve->add_option(
        "--tool", job.tool, "the direction of the tool, from the tip to the holder: 0,0.5,0.866");
    CLI::Option* euler = solve->add_option(
        "--euler", job.euler, "the orientation by rotations about Z, Y', Z'' in degrees: 30,45,0");
    CLI::Option* from = solve->add_option(
        "--from", job.from, "where the rotary axes come from: A0,C0; for the path choice");
    CLI::Option* vector = solve->add_flag("--vector", job.follows_vector,
                                          "the tool goes there along the great circle");
    solve->add_option("--length", job.length, "of the tool in mm")->check(check_number);
    solve->add_flag("--json", job.as_json, "one JSON object");
    for (CLI::Option* other : {at, tool, euler, from, vector}) axes->excludes(other);
    tool->excludes(euler);
}

/// `--tick ''` is a variable of a shell that is not set: what stands there was meant to give
/// something.
void Parser::refuse_empty_values(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& value : option->results()) {
            if (value.empty()) throw CLI::ValidationError(option->get_name(), "the value is empty");
        }
    }
    for (const CLI::App* inner : command.get_subcommands()) refuse_empty_values(*inner);
}

CommandLine Parser::parse(int count, const char* const* arguments) {
    app_.parse(count, arguments);
    refuse_empty_values(app_);
    driver::Options& options = line_.options;
    for (const std::string& define : defines_) options.defines.push_back(parse_define(define));
    for (const int level : skips_) options.skip_levels |= static_cast<std::uint16_t>(1u << level);
    if (!tick_.empty()) options.tick = parse_tick(tick_);
    if (!max_input_.empty()) options.max_input = parse_size(max_input_, "--max-input");
    if (!max_output_.empty()) options.max_output = parse_size(max_output_, "--max-output");
    if (!max_time_.empty()) options.max_time = parse_time(max_time_, "--max-time");
    options.native_cycles = cycles_ != "moves";
    options.modal_cycles = cycles_ == "native";
    line_.expand.source = line_.run.source = source_;
    line_.expand.map = line_.run.value_of("--map");
    if (!listed_.empty()) take_listed();
    if (!threads_.empty()) line_.run.threads = threads_ == "on";
    check_settings();
    take_operator();
    if (line_.verb == Verb::Compare) take_compared();
    line_.format = is_check_ ? driver::FormatMode::Check : driver::FormatMode::Write;
    line_.messages =
        messages_ == "json" ? driver::MessageFormat::Json : driver::MessageFormat::Text;
    return line_;
}

void Parser::check_settings() const {
    for (const driver::OutputRow& row : driver::output_rows()) {
        const std::string& value = line_.run.value_of(row.flag);
        if (row.fault == nullptr || value.empty()) continue;
        const std::string fault = row.fault(value);
        if (!fault.empty()) throw CLI::ValidationError(std::string(row.flag), fault);
    }
}

/// How a switch stands at the start; how it is set goes to the events of the run.
double Parser::take_override(const std::string& text, const char* option, motion::OperatorAct act,
                             double most) {
    if (text.empty()) return 1;
    const auto sequence = driver::override_sequence(text, act, most);
    if (!sequence) {
        throw CLI::ValidationError(option, "`" + text + "` is no sequence of a switch for 1 to " +
                                               std::to_string(static_cast<int>(100 * most)) +
                                               " %; write `80`, `80%` or `100%,5s:50%,N120:100%`");
    }
    std::vector<motion::OperatorEvent>& events = line_.run.operator_events;
    events.insert(events.end(), sequence->events.begin(), sequence->events.end());
    return sequence->at_start;
}

void Parser::take_operator() {
    driver::RunJob& job = line_.run;
    job.feed_override = take_override(feed_override_, "--feed-override",
                                      motion::OperatorAct::FeedOverride, driver::kMostFeedOverride);
    job.rapid_override =
        take_override(rapid_override_, "--rapid-override", motion::OperatorAct::RapidOverride,
                      driver::kMostRapidOverride);
    for (const std::string& text : holds_) {
        const auto events = driver::hold_events(text);
        if (!events) {
            throw CLI::ValidationError(
                "--hold", "`" + text + "` is no hold; write `5s..7s`, or `N120..2s` for 2 s");
        }
        job.operator_events.insert(job.operator_events.end(), events->begin(), events->end());
    }
}

/// Instead of the text of `expand`.
void Parser::take_listed() {
    using Format = driver::ParameterFormat;
    if (!defines_.empty())
        throw CLI::ValidationError("--parameters", "it lists what `-D` can set, and sets nothing");
    if (!line_.expand.map.empty())
        throw CLI::ValidationError("--parameters", "no text is written that `--map` could map");
    line_.verb = Verb::Parameters;
    line_.parameters = {source_, line_.expand.output,
                        listed_ == "json" ? Format::Json : Format::Text};
}

/// One source has two controls; of two sources each may have its own.
void Parser::take_compared() {
    driver::CompareJob& job = line_.compare;
    if (controls_.size() > 2) throw CLI::ValidationError("-d", "two controls at most");
    if (compared_.size() == 1 && controls_.size() < 2)
        throw CLI::ValidationError("-d",
                                   "one source is compared for two controls: give `-d` twice");
    job.sources = {compared_.front(), compared_.back()};
    if (!controls_.empty()) job.dialects = {controls_.front(), controls_.back()};
    if (!tolerance_.empty()) job.tolerance = parse_length(tolerance_, "--tolerance");
    if (summary_ == "json") job.summary = driver::SummaryFormat::Json;
}

std::string Parser::commands_message() const {
    const std::vector<std::string> rest = app_.remaining();
    std::string text =
        rest.empty() ? "a command is missing" : "there is no command `" + rest.front() + "`";
    text += "; there are";
    for (const CLI::App* command : app_.get_subcommands([](const CLI::App*) { return true; })) {
        text += ' ' + command->get_name();
    }
    return text + "\nRun with --help for more information.\n";
}

std::string Parser::message(const CLI::ParseError& error, int& status) const {
    std::ostringstream out;
    std::ostringstream wrong;
    status = app_.exit(error, out, wrong);
    if (status == 0) return out.str();
    // "A subcommand is required" tells neither what stood there nor what there is.
    if (app_.get_subcommands().empty()) return "kadr: " + commands_message();
    return "kadr: " + wrong.str();
}

}  // namespace

std::variant<CommandLine, Answer> parse_command_line(int count, const char* const* arguments) {
    Parser parser;
    try {
        return parser.parse(count, arguments);
    } catch (const CLI::ParseError& error) {
        int status = 0;
        std::string text = parser.message(error, status);
        return Answer{status == 0 ? driver::Status::Done : driver::Status::Usage, std::move(text)};
    }
}

}  // namespace kadr::cli
