// Dialect files: inheritance, and every mistake with its line and column.
#include "nc/load.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "base/diagnostics/iso.h"
#include "base/disk_files.h"
#include "base/text.h"
#include "nc/comment_text.h"
#include "nc/inspect.h"
#include "nc/lint.h"
#include "nc/tables.h"
#include "tests/nc/nc_testing.h"
#include "write/check.h"
#include "write/writer.h"

namespace kadr::nc::load_test {
namespace {

namespace fs = std::filesystem;
using testing::codes;

/// A folder of its own for the files of one test.
class Folder {
  public:
    Folder() : path_(fs::temp_directory_path() / ("kadr_nc_" + std::to_string(::getpid()))) {
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    std::string add(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name) << text;
        return (path_ / name).string();
    }
    SearchPath search() const { return {path_.string(), KADR_ROOT "/dialects"}; }

  private:
    fs::path path_;
};

std::string with(const std::string& body) {
    return "<dialect name=\"mine\" extends=\"iso\" title=\"Mine\" suffix=\"nc\">\n" + body +
           "\n</dialect>\n";
}

struct Loaded {
    std::optional<Dialect> dialect;
    DiagnosticList messages;
    Sources sources;
};

void load(Loaded& out, const std::string& text) {
    const Folder folder;
    const std::string file = folder.add("mine.xml", text);
    out.dialect = load_dialect(file, folder.search(), out.sources, out.messages);
}

TEST(Load, MistakesHaveTheirPlace) {
    struct Row {
        const char* body;
        const char* codes;
        unsigned line, column;
    };
    for (const Row& row : {
             Row{"<group name=\"g\"><code text=\"G7\" command=\"plane_xy\"></group>", "K9101", 2,
                 54},
             {"<gruop name=\"x\"/>", "K9103", 2, 2},
             {"<group name=\"x\"><command/></group>", "K9103", 2, 18},
             {"<number addresses=\"X\" decimal=\"3\"/>", "K9104", 2, 23},
             {"<alarm for=\"IsoUnknownCode\"/>", "K4006", 2, 13},
             {"<number addresses=\"X\" point=\"sometimes\"/>", "K4006", 2, 30},
             {"<number addresses=\"X\" decimals=\"many\"/>", "K4006", 2, 33},
             {"<number addresses=\"X\" decimals=\"12\"/>", "K4006", 2, 33},
             {"<number addresses=\"QQ\"/>", "K4006", 2, 20},
             {"<address name=\"X\" slot=\"left\"/>", "K4006", 2, 25},
             {"<alarm for=\"NoSuchRow\" number=\"1\"/>", "K4006", 2, 13},
             {"<cycle name=\"drill_pek\"><form>G83 Z{to}</form></cycle>", "K4006", 2, 14},
             {"<cycle name=\"mine\" parameters=\"to:length\"/>", "K4006", 2, 32},
             {"<group name=\"g\"><code text=\"G7\" command=\"fast\"/></group>", "K4008", 2, 42},
             {"<group name=\"g\" default=\"fast\"/>", "K4008", 2, 26},
             {"<command name=\"dwell\"><form>G4 P{seconds}</form></command>", "K4009", 2, 29},
             {"<command name=\"dwell\"><form>G4 P{time:hours}</form></command>", "K4009", 2, 29},
             {"<command name=\"dwell\"><form>G4 P{time</form></command>", "K4009", 2, 29},
             {"<command name=\"dwell\"><form>WAIT({time},{=1})</form></command>", "K4009", 2, 29},
             {"<command name=\"dwell\"><form>WAIT({time},{=one:length})</form></command>", "K4009",
              2, 29},
             {"<command name=\"dwell\"><form></form></command>", "K4009", 2, 24},
             {"<command name=\"dwell\"><form>WAIT({time}</form></command>", "K4009", 2, 29},
             {"<command name=\"tool_select\"><form>T{tool?}</form></command>", "K4009", 2, 35},
             {"<command name=\"work_offset\"><form>G{number+53}</form></command>", "K4009", 2, 35},
             {"<command name=\"work_offset\"><form when=\"number "
              "1..99999\">G{number}</form></command>",
              "K4009", 2, 58},
             {"<group name=\"g\"><code text=\"G123456789\" command=\"line\"/></group>", "K4009", 2,
              29},
             {"<command name=\"work_offset\"><form when=\"number one\">G54</form></command>",
              "K4006", 2, 48},
             {"<group name=\"g\"><code text=\"G0\" command=\"line\"/></group>", "K4010", 2, 29},
             {"<command name=\"tool_select\"><form>T1</form></command>", "K4011", 2, 35},
             {"<command name=\"dwell\"><form>G4 Q{time}</form></command>", "K4013", 2, 29},
         }) {
        SCOPED_TRACE(row.body);
        Loaded loaded;
        load(loaded, with(row.body));
        EXPECT_FALSE(loaded.dialect);
        ASSERT_FALSE(loaded.messages.all().empty());
        const Diagnostic& first = loaded.messages.all()[0];
        EXPECT_EQ(first.row->code, row.codes) << first.message();
        const LineColumn place = loaded.sources.locate(first.range.file, first.range.begin);
        EXPECT_EQ(place.line, row.line) << first.message();
        EXPECT_EQ(place.column, row.column) << first.message();
    }
}

TEST(Load, FilesThatAreNotThere) {
    Sources sources;
    DiagnosticList sink;
    EXPECT_FALSE(load_dialect("fanuk", testing::dialect_folders(), sources, sink));
    ASSERT_EQ(codes(sink), "K4001");
    EXPECT_NE(sink.all()[0].fixes[0].text.find("fanuc"), std::string::npos);
    EXPECT_FALSE(load_dialect("/nowhere/x.xml", testing::dialect_folders(), sources, sink));
    Loaded loaded;
    load(loaded, "<dialect name=\"m\" extends=\"izo\" title=\"t\" suffix=\"s\"/>");
    EXPECT_EQ(codes(loaded.messages), "K4001");
    Loaded empty;
    load(empty, "");
    EXPECT_EQ(codes(empty.messages), "K9101");
    Loaded other;
    load(other, "<machine/>");
    EXPECT_EQ(codes(other.messages), "K9102");
    Loaded nameless;
    load(nameless, "<dialect name=\"m\" extends=\"iso\" suffix=\"nc\"/>");
    EXPECT_EQ(codes(nameless.messages), "K9105");
}

TEST(Load, ExtendingInACircle) {
    const Folder folder;
    folder.add("a.xml", "<dialect name=\"a\" extends=\"b\" title=\"A\" suffix=\"nc\"/>");
    folder.add("b.xml", "<dialect name=\"b\" extends=\"a\" title=\"B\" suffix=\"nc\"/>");
    Sources sources;
    DiagnosticList sink;
    EXPECT_FALSE(load_dialect("a", folder.search(), sources, sink));
    EXPECT_EQ(codes(sink), "K4007");
}

TEST(Load, WhatAFileSaysReplacesWhatItExtends) {
    Loaded loaded;
    load(loaded, with("<group name=\"motion\"><code text=\"G1\" command=\"rapid\"/><code "
                      "text=\"G0\" command=\"line\"/></group>\n"
                      "<number addresses=\"X\" decimals=\"1\"/>\n<remove commands=\"dwell\"/>\n"
                      "<rule name=\"arc_tolerance\" value=\"0.5\"/>"));
    ASSERT_TRUE(loaded.dialect) << testing::rendered(loaded.messages, loaded.sources);
    const Dialect& dialect = *loaded.dialect;
    EXPECT_FALSE(dialect.can_write(Function::Dwell));
    EXPECT_TRUE(dialect.can_write(Function::ArcCw));
    EXPECT_EQ(describe(testing::source_block(dialect, "G0 X1")), "line X1");
    EXPECT_EQ(dialect.rules().arc_tolerance, 0.5);  // whatever iso says
    EXPECT_TRUE(dialect.names_rule(Rule::arc_tolerance));
    EXPECT_FALSE(dialect.names_rule(Rule::comp_start));
}

/// A source that names no dialect is written in the blocks of `iso`.
TEST(Load, TheRulesOfTheLanguageAreThoseOfTheCore) {
    Sources sources;
    DiagnosticList messages;
    const auto core = load_dialect("iso", {KADR_ROOT "/dialects"}, sources, messages);
    ASSERT_TRUE(core);
    EXPECT_TRUE(core->rules() == Rules::of_language());
}

/// Lines in front of the first block that do not say the units: the writer says them, as it makes
/// up for G90 and G94, where the control does not begin with them.
TEST(Load, UnitsThatNoStartLineSaysAreWritten) {
    Loaded loaded;
    load(loaded, with("<program><header>%</header><start>G17 G40 G90</start><finish>M30</finish>"
                      "<end>%</end><skipped>%</skipped></program>"));
    ASSERT_TRUE(loaded.dialect) << testing::rendered(loaded.messages, loaded.sources);
    for (const bool is_inch : {false, true}) {
        DiagnosticList sink;
        write::Writer writer(*loaded.dialect, {}, sink);
        std::string text;
        writer.begin({"test", 1, "", is_inch}, text);
        writer.write(testing::source_block(*loaded.dialect, "G1 X25.4 F254"), text);
        writer.end(text);
        EXPECT_EQ(codes(sink), "");
        const auto read = testing::read_blocks(*loaded.dialect, text);
        std::string meaning;
        for (const Block& block : read.blocks) meaning += describe(block) + '\n';
        EXPECT_EQ(meaning.find("inch") != std::string::npos, is_inch) << text;
        EXPECT_NE(meaning.find("X25.4"), std::string::npos) << text << meaning;
        DiagnosticList frame;
        write::check_frame(*loaded.dialect, frame);
        EXPECT_EQ(codes(frame), "");
    }
}

/// A sign that would end a comment is replaced, whether the dialect says by what or not.
TEST(Load, TheEndOfACommentIsNotInIt) {
    for (const auto& [said, written] :
         {std::pair{"", "a]b"}, std::pair{"<replace character=\"&gt;\" by=\"-\"/>", "a-b"}}) {
        Loaded loaded;
        load(loaded,
             with(std::string("<comment open=\"&lt;\" close=\"&gt;\">") + said + "</comment>"));
        ASSERT_TRUE(loaded.dialect) << testing::rendered(loaded.messages, loaded.sources);
        EXPECT_EQ(comment_text("a>b", loaded.dialect->tables().comment), written);
    }
}

/// `-d` finds a dialect by the name of its file.
TEST(Load, ADialectIsCalledAsItsFile) {
    for (const char* name : {"mine", "ours"}) {
        const Folder folder;
        const std::string file =
            folder.add("mine.xml", "<dialect name=\"" + std::string(name) +
                                       "\" extends=\"iso\" title=\"Mine\" suffix=\"nc\"/>");
        Sources sources;
        DiagnosticList found;
        const InspectedDialect inspected = inspect_dialect(file, folder.search(), sources, found);
        ASSERT_TRUE(inspected.dialect);
        check_sense(inspected.root, *inspected.dialect, found);
        EXPECT_EQ(codes(found), std::string_view(name) == "mine" ? "" : "K4275");
    }
}

/// What is written must be read: with an address every inherited form goes that has it.
TEST(Load, FormsOfARemovedAddressAreNotThere) {
    Loaded loaded;
    load(loaded, with("<remove addresses=\"RPL LIMS SPOS\"/>"));
    ASSERT_TRUE(loaded.dialect) << testing::rendered(loaded.messages, loaded.sources);
    const Dialect& dialect = *loaded.dialect;
    EXPECT_FALSE(dialect.can_write(Function::Rotate));
    EXPECT_FALSE(dialect.can_write(Function::SpeedLimit));
    for (const Form& form : dialect.tables().forms) {
        for (const char* word : {"RPL", "LIMS", "SPOS"})
            EXPECT_EQ(form.pattern.find(word), std::string::npos) << form.pattern;
    }
    EXPECT_TRUE(dialect.can_write(Function::Shift));
    EXPECT_TRUE(dialect.can_write(Function::Mirror));
    // Declared anew it serves the forms of the file that does so.
    Loaded again;
    load(again, with("<remove addresses=\"RPL\"/>\n<address name=\"RPL\"/>\n"
                     "<command name=\"rotate\"><form>ROT RPL={angle}</form></command>"));
    ASSERT_TRUE(again.dialect) << testing::rendered(again.messages, again.sources);
    EXPECT_TRUE(again.dialect->can_write(Function::Rotate));
}

/// A value that went through the units of the language differs in its last bit.
TEST(Load, ExamplesAreHeldWithinRounding) {
    for (const bool is_right : {true, false}) {
        Loaded loaded;
        load(loaded, with("<command name=\"speed_limit\"><form>G92 S{limit}</form></command>"));
        ASSERT_TRUE(loaded.dialect) << testing::rendered(loaded.messages, loaded.sources);
        Example example;
        example.text = "G92 S2000";
        example.block =
            is_right ? "speed_limit(limit=2000.0000000000002)" : "speed_limit(limit=2000.00000001)";
        DiagnosticList sink;
        write::check_example(*loaded.dialect, example, {}, sink);
        EXPECT_EQ(codes(sink), is_right ? "" : "K4017");
    }
}

TEST(Load, TimesInHundredthsOfASecond) {
    Loaded loaded;
    load(loaded, with("<command name=\"dwell\"><form>G4 P{time:cs}</form></command>"));
    ASSERT_TRUE(loaded.dialect) << testing::rendered(loaded.messages, loaded.sources);
    Example example;
    example.text = "G4 P250";
    for (const bool is_right : {true, false}) {
        example.block = is_right ? "dwell(time=2.5)" : "dwell(time=0.25)";
        DiagnosticList sink;
        write::check_example(*loaded.dialect, example, {}, sink);
        EXPECT_EQ(codes(sink), is_right ? "" : "K4017");
    }
}

TEST(Load, ANativeCycleNeedsItsParameters) {
    Loaded loaded;
    load(loaded,
         with("<cycle name=\"drill\"><form>G81 Z{to} R{retract} P{dwell:ms}</form></cycle>\n"
              "<cycle name=\"bore\"><form>G85 Z{to} R{retract} P{dwell=0}</form></cycle>"));
    ASSERT_TRUE(loaded.dialect) << testing::rendered(loaded.messages, loaded.sources);
    const Dialect& dialect = *loaded.dialect;
    constexpr unsigned kTo = 1, kRetract = 2, kInitial = 4, kDwell = 8;
    const CycleId drill = *dialect.find_cycle("drill");
    EXPECT_TRUE(dialect.has_native_cycle(drill, kTo | kRetract | kDwell, {}));
    EXPECT_FALSE(dialect.has_native_cycle(drill, kTo | kRetract, {})) << "P would lack its value";
    EXPECT_FALSE(dialect.has_native_cycle(drill, kTo | kRetract | kInitial | kDwell, {}));
    EXPECT_TRUE(dialect.has_native_cycle(*dialect.find_cycle("bore"), kTo | kRetract, {}));
}

/// A word cannot be read and be said not to be.
TEST(Load, WhatIsNotSupportedIsNotSpelled) {
    for (const char* name : {"sinumerik", "fanuc"}) {
        const DialectTables& tables = testing::shipped(name).tables();
        EXPECT_GT(tables.unsupported.size(), 10u);
        for (const auto& [word, meaning] : tables.unsupported) {
            // As it stands alone it asks for what is so anyway: `SETMS`.
            if (tables.passed.contains(word)) continue;
            const auto read = testing::read_blocks(testing::shipped(name), word + "\n");
            EXPECT_EQ(testing::codes(read.messages), "K5018") << name << ": " << word;
        }
    }
}

TEST(Load, TheShippedFilesFollowTheSchema) {
    if (std::system("command -v xmllint > /dev/null") != 0)
        GTEST_SKIP() << "xmllint is not installed";
    for (const char* name : {"iso", "sinumerik", "fanuc", "axioma"}) {
        const std::string command = "xmllint --noout --schema " KADR_ROOT
                                    "/dialects/dialect.xsd " KADR_ROOT "/dialects/" +
                                    std::string(name) + ".xml 2> /dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0) << name;
    }
}

TEST(Load, Questions) {
    const Dialect& fanuc = testing::shipped("fanuc");
    const Dialect& iso = testing::shipped("iso");
    const auto peck = fanuc.find_cycle("drill_peck");
    ASSERT_TRUE(peck);
    const std::array<double, 5> values = {-10, 3, 2, 50, 0};  // to, peck, retract, initial, dwell
    const std::array<double, 5> dwells = {-10, 3, 2, 50, 1};
    EXPECT_TRUE(fanuc.has_native_cycle(*peck, 0b11111, values));
    EXPECT_FALSE(fanuc.has_native_cycle(*peck, 0b11111, dwells));  // G83 has no dwell
    EXPECT_FALSE(iso.has_native_cycle(*peck, 0b11111, values));
    EXPECT_TRUE(testing::shipped("sinumerik").has_native_cycle(*peck, 0b11111, dwells));
    EXPECT_FALSE(fanuc.find_cycle("knit"));
    EXPECT_TRUE(fanuc.can_write(Function::LengthCompOn));
    EXPECT_FALSE(testing::shipped("sinumerik").can_write(Function::LengthCompOn));
    EXPECT_EQ(fanuc.alarm(diag::IsoUnknownCode)->number, "PS0010");
    EXPECT_FALSE(iso.alarm(diag::IsoUnknownCode));
    EXPECT_EQ(fanuc.power_on(Group::Plane), Function::PlaneXy);
    const auto list = list_dialects(testing::dialect_folders(), disk());
    ASSERT_GE(list.size(), 4u);
    EXPECT_EQ(list[0].name, "axioma");
    EXPECT_EQ(list[0].extends, "sinumerik");
    const Dialect& axioma = testing::shipped("axioma");
    EXPECT_EQ(list[0].suffix, axioma.suffix());
    EXPECT_EQ(list[0].title, axioma.title());
    EXPECT_TRUE(can_be_loaded("axioma", testing::dialect_folders(), disk()));
    EXPECT_FALSE(can_be_loaded("nonesuch", testing::dialect_folders(), disk()));
}

TEST(Load, ExplainsWhatIsNotRead) {
    const std::vector<std::string> lines = explain(testing::shipped("sinumerik"), "SONS");
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0],
              "`SONS` (punching and nibbling) is a word of the control; Kadr does not read it");
}

TEST(Load, ExplainsWordsWithTheirNumber) {
    struct Row {
        const char* dialect;
        const char* word;
        const char* line;
    };
    for (const Row& row : {
             Row{"fanuc", "DO1", "`DO{loop}` is loop"},
             Row{"fanuc", "END1", "`END{loop}` is end_loop"},
             Row{"fanuc", "GOTO10", "`GOTO{target}` is jump"},
             Row{"fanuc", "O", "its number, from 1 to 9999"},
             Row{"fanuc-lathe", "O0012", "its number, from 1 to 9999"},
             Row{"fanuc", "%", "`%` stands in front of a program"},
         }) {
        std::string all;
        for (const std::string& line : explain(testing::shipped(row.dialect), row.word))
            all += line + '\n';
        EXPECT_NE(all.find(row.line), std::string::npos) << row.word << ": " << all;
    }
    for (const char* word : {"1", "WHILE1", "THEN7", "END1X", "Q1234567"})
        EXPECT_TRUE(explain(testing::shipped("sinumerik"), word).empty()) << word;
}

// Whatever is read can be explained, words of the language as well.
TEST(Load, ExplainsWordsOfTheLanguage) {
    for (const char* word : {"AC", "IC", "DC", "ACP", "ACN", "REAL", "AXIS", "SAVE", "VAR", "TO",
                             "DEFAULT", "GOTOF", "ENDIF", "DIV", "XOR"}) {
        const std::vector<std::string> lines = explain(testing::shipped("sinumerik"), word);
        ASSERT_FALSE(lines.empty()) << word;
        EXPECT_NE(lines[0].find(word), std::string::npos) << lines[0];
    }
    for (const char* word : {"GOTO", "WHILE", "EQ", "MOD", "FUP"})
        EXPECT_FALSE(explain(testing::shipped("fanuc"), word).empty()) << word;
}

TEST(Load, Explanations) {
    const auto text = [](const char* dialect, const char* word) {
        std::string all;
        for (const std::string& line : explain(testing::shipped(dialect), word)) all += line + '\n';
        return all;
    };
    EXPECT_EQ(text("fanuc", "dwell"),
              "dwell: waits; seconds or spindle revolutions\n"
              "parameters: time (time, optional), revolutions (number, optional)\n"
              "written as `G04 P{time:ms}`, in a block of its own\n"
              "read as `G04 P{time:ms}`, without a motion in its block\n"
              "read as `G04 X{time:s}`, without a motion in its block\n"
              "example: `dwell(0.5s);` is written `G04 P500`\n");
    EXPECT_NE(text("fanuc", "G83").find("the cycle drill_peck"), std::string::npos);
    EXPECT_NE(text("fanuc", "X").find("without a point 1 means 0.001"), std::string::npos);
    EXPECT_NE(text("sinumerik", "trans").find("shift"), std::string::npos);
    EXPECT_NE(text("sinumerik", "set_position").find("no spelling"), std::string::npos);
    EXPECT_EQ(text("fanuc", "KNIT"), "");
}

// ---------------------------------------------------------------- schema and loader

/// What dialect.xsd says of one element, in the words of the loader's table.
class Schema {
  public:
    explicit Schema(const XmlElement& root) : root_(root) {}

    /// Compares the element and everything below it with the table.
    void compare(const std::string& name, const XmlElement& element) {
        if (!seen_.insert(name).second) return;
        SCOPED_TRACE("<" + name + ">");
        const XmlShape& shape = dialect_shape();
        const auto rule = std::ranges::find(shape.rules, name, &XmlRule::element);
        ASSERT_NE(rule, shape.rules.end());
        const XmlElement* type = type_of(element);
        std::set<std::string> attributes;
        std::map<std::string, const XmlElement*> children;
        if (type != nullptr) {
            for (const XmlElement& part : type->children) {
                if (part.name == "xs:attribute") attributes.insert(described(part));
                if (part.name == "xs:choice" || part.name == "xs:sequence") {
                    for (const XmlElement& child : part.children) {
                        children.emplace(child.find("name")->value, &child);
                    }
                }
            }
        }
        const bool is_mixed = type != nullptr && type->find("mixed") != nullptr;
        EXPECT_EQ(rule->text == XmlRule::Text::Allowed, type == nullptr || is_mixed);
        std::set<std::string> expected_attributes;
        for (const XmlAttributeRule& attribute : rule->attributes) {
            const bool is_needed = attribute.use != XmlAttributeRule::Use::Optional;
            expected_attributes.insert(std::string(attribute.name) + (is_needed ? "!" : ""));
        }
        EXPECT_EQ(expected_attributes, attributes);
        std::set<std::string> names;
        for (const auto& [child, definition] : children) names.insert(child);
        EXPECT_EQ(std::set<std::string>(rule->children.begin(), rule->children.end()), names);
        for (const auto& [child, definition] : children) compare(child, *definition);
    }

    std::size_t compared() const { return seen_.size(); }

  private:
    static std::string described(const XmlElement& attribute) {
        const XmlAttribute* use = attribute.find("use");
        const bool is_needed = use != nullptr && use->value == "required";
        return attribute.find("name")->value + (is_needed ? "!" : "");
    }

    /// The complex type of an element; nullptr if it holds text only.
    const XmlElement* type_of(const XmlElement& element) const {
        for (const XmlElement& child : element.children) {
            if (child.name == "xs:complexType") return &child;
        }
        const XmlAttribute* type = element.find("type");
        for (const XmlElement& child : root_.children) {
            if (type == nullptr || child.name != "xs:complexType") continue;
            if (child.find("name")->value == type->value) return &child;
        }
        return nullptr;
    }

    const XmlElement& root_;
    std::set<std::string> seen_;
};

// Editors read the schema, the loader its table: what one allows the other must.
TEST(Load, SchemaAndLoaderAgree) {
    static const std::vector<XmlRule> rules = {{"xs:schema", {}, {}}};
    Sources sources;
    DiagnosticList messages;
    const auto file = sources.read(KADR_ROOT "/dialects/dialect.xsd");
    ASSERT_TRUE(file);
    const auto root = parse_xml(*file, sources, {"a schema", rules}, messages);
    ASSERT_TRUE(root) << testing::rendered(messages, sources);
    Schema schema(*root);
    for (const XmlElement& element : root->children) {
        if (element.name == "xs:element") schema.compare("dialect", element);
    }
    EXPECT_EQ(schema.compared(), dialect_shape().rules.size());
}

}  // namespace
}  // namespace kadr::nc::load_test
