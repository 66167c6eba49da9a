// XML files: what is kept of them with its place, and one message for every way to spoil one.
#include "base/xml.h"

#include <array>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/scratch.h"

namespace kadr::xml_test {
namespace {

const XmlShape& shape() {
    constexpr auto Needed = XmlAttributeRule::Use::Needed;
    constexpr auto Filled = XmlAttributeRule::Use::Filled;
    static const std::vector<XmlRule> rules = {
        {"plan", {{"name", Filled}, "title"}, {"step", "note"}},
        {"step", {{"by", Needed}, "tool"}, {"note", "step"}},
        {"note", {}, {}, XmlRule::Text::Allowed},
    };
    static const XmlShape shape = {"a plan", rules};
    return shape;
}

struct Read {
    explicit Read(const std::string& text) {
        file = sources.add("plan.xml", text);
        root = parse_xml(file, sources, shape(), messages);
        if (root) is_good = bool{check_xml(*root, shape(), messages)};
    }
    Sources sources;
    DiagnosticList messages;
    FileId file;
    std::optional<XmlElement> root;
    bool is_good = false;
};

TEST(Xml, EverythingHasItsPlace) {
    const Read read(
        "<?xml version='1.0'?>\n<!-- a plan -->\n<plan name = 'a &lt; b'\n  title=\"\">\n"
        "  <note>  first &amp; last\n  </note>\n  <note><![CDATA[<raw>]]></note>\n</plan>\n<!-- "
        "end -->");
    ASSERT_TRUE(read.is_good);
    const auto text = [&](const SourceRange& range) { return read.sources.text(range); };
    const XmlElement& plan = *read.root;
    EXPECT_EQ(text(plan.range), "plan");
    ASSERT_EQ(plan.attributes.size(), 2u);
    EXPECT_EQ(plan.attributes[0].value, "a < b");
    EXPECT_EQ(text(plan.attributes[0].name_range), "name");
    EXPECT_EQ(text(plan.attributes[0].value_range), "a &lt; b");
    EXPECT_EQ(text(plan.attributes[1].name_range), "title");
    EXPECT_EQ(text(plan.attributes[1].value_range), "");
    EXPECT_FALSE(plan.text_range.file.is_valid());
    EXPECT_EQ(plan.find("titel"), nullptr);
    ASSERT_EQ(plan.children.size(), 2u);
    EXPECT_EQ(plan.children[0].text, "first & last");
    EXPECT_EQ(text(plan.children[0].text_range), "first &amp; last");
    EXPECT_EQ(plan.children[1].text, "<raw>");
    EXPECT_EQ(text(plan.children[1].text_range), "<raw>");
}

/// A mistake, the text that is underlined, and what is proposed instead.
struct Mistake {
    const char* xml;
    const char* message;
    const char* marked;
    const char* fix;
};

TEST(Xml, EveryMistakeHasOneMessage) {
    const std::string broken = "K9101 this is not well-formed XML: ";
    const auto expect = [](const Mistake& mistake) {
        SCOPED_TRACE(mistake.xml);
        const Read read(mistake.xml);
        EXPECT_FALSE(read.is_good);
        ASSERT_EQ(read.messages.all().size(), 1u);
        const Diagnostic& said = read.messages.all()[0];
        EXPECT_EQ(std::string(said.row->code) + ' ' + said.message(), mistake.message);
        // What is no XML at all is named by its file; nothing of it is shown.
        if (said.range.file.is_valid()) {
            EXPECT_EQ(read.sources.text(said.range), mistake.marked);
        }
        EXPECT_EQ(said.fixes.empty() ? "" : said.fixes[0].replacement, mistake.fix);
    };
    for (const auto& [xml, why, marked] : std::vector<std::array<const char*, 3>>{
             {"", "there is no element", ""},
             {"hello", "there is no element", ""},
             {"<!-- nothing -->", "there is no element", ""},
             {"<plan name='a'", "the start tag is broken", "'"},
             {"<plan name=a/>", "the attribute is broken", "a"},
             {"<plan name='a'><note></plan>", "start tag and end tag do not match", "p"},
             {"<plan name='a'><!-- open</plan>", "the comment is not closed", ">"},
             {"<plan name='a'/><plan name='b'/>", "there is a second outermost element", "plan"},
             {"<plan name='a'/> and more", "there is text outside of the element", "a"},
             {"so: <plan name='a'/>", "there is text outside of the element", "s"},
             {"<plan name='a &c; b'/>",
              "`&` begins no entity here; the sign itself is written `&amp;`", "&"},
             {"<plan name='a'><note>M3 & M8</note></plan>",
              "`&` begins no entity here; the sign itself is written `&amp;`", "&"}}) {
        expect({xml, (broken + why).c_str(), marked, ""});
    }
    for (const Mistake& mistake :
         {Mistake{"<plans name='a'/>",
                  "K9102 the outermost element is `<plans>`, a plan has `<plan>`", "plans", "plan"},
          {"<machine/>", "K9102 the outermost element is `<machine>`, a plan has `<plan>`",
           "machine", ""},
          {"<plan name='a'><stepp by='1'/></plan>",
           "K9103 `<stepp>` has no meaning inside `<plan>`", "stepp", "step"},
          {"<plan name='a'><note><step by=''/></note></plan>",
           "K9103 `<step>` has no meaning inside `<note>`", "step", ""},
          {"<plan name='a' tilte='b'/>", "K9104 `<plan>` has no attribute `tilte`", "tilte",
           "title"},
          {"<plan nme='a'/>", "K9104 `<plan>` has no attribute `nme`", "nme", "name"},
          {"<plan title='a'/>", "K9105 `<plan>` lacks the attribute `name`", "plan", ""},
          {"<plan name=''/>", "K9106 `name` of `<plan>` is empty", "name", ""},
          {"<plan name='a' name='b'/>", "K9107 `name` stands twice in `<plan>`", "name", ""},
          {"<plan name='a'>text</plan>", "K9108 there is text inside `<plan>`", "text", ""}}) {
        expect(mistake);
    }
}

TEST(Xml, AMisplacedElementIsToldWhereItBelongs) {
    const Read read("<plan name='a'><note><step by=''/></note></plan>");
    ASSERT_EQ(read.messages.all().size(), 1u);
    const auto& notes = read.messages.all()[0].notes;
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_EQ(notes[0].text, "`<step>` may stand inside `<plan>`");
    EXPECT_EQ(notes[1].text, "`<step>` may stand inside `<step>`");
}

TEST(Xml, TheFirstTagIsReadAlone) {
    const std::string path = testing::scratch("first_tag.xml");
    const std::string tag = "<plan name=\"a &amp; b\" title='two'";
    const auto tag_of = [&](const std::string& text) {
        EXPECT_TRUE(write_file_whole(path, text));
        return first_tag(path, disk());
    };
    const std::map<std::string, std::string> both = {{"name", "a & b"}, {"title", "two"}};
    const std::string many = "<!--" + std::string(5000, 'x') + "-->";
    std::string steps;
    for (int i = 0; i < 1000; ++i) steps += "<step by=\"x\"/>";
    EXPECT_EQ(tag_of(tag + "/>"), both);
    EXPECT_EQ(tag_of("\xEF\xBB\xBF<?xml version=\"1.0\"?>\n" + tag + ">" + steps + "</plan>"),
              both);
    EXPECT_EQ(tag_of(many + tag + ">" + steps + "</plan>"), both);
    EXPECT_EQ(tag_of(many.substr(0, 4080) + "-->" + tag + ">" + steps + "</plan>"), both);
    // A mistake behind it is not looked at.
    EXPECT_EQ(tag_of(tag + "><step by=\"</plan>"), both);
    EXPECT_EQ(tag_of(tag + " name"), both);
    EXPECT_TRUE(tag_of("no XML").empty());
    EXPECT_TRUE(tag_of("").empty());
    std::filesystem::remove(path);
    EXPECT_TRUE(first_tag(path, disk()).empty());
}

TEST(Xml, AttributesOfXmlItselfPass) {
    EXPECT_TRUE(Read("<plan name='a' xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' "
                     "xsi:noNamespaceSchemaLocation='plan.xsd'/>")
                    .is_good);
}

// 64 elements may lie in one another; the stack never holds more, however deep the file is.
TEST(Xml, DepthHasALimit) {
    const auto nested = [](int steps) {
        std::string text = "<plan name='a'>";
        for (int i = 0; i < steps; ++i) text += "<step by='1'>";
        for (int i = 0; i < steps; ++i) text += "</step>";
        return text + "</plan>";
    };
    EXPECT_TRUE(Read(nested(63)).is_good);
    for (const int steps : {64, 100000}) {
        const Read read(nested(steps));
        ASSERT_EQ(read.messages.all().size(), 1u) << steps;
        EXPECT_EQ(read.messages.all()[0].message(),
                  "this is not well-formed XML: elements are nested deeper than 64");
    }
}

TEST(Xml, LongNamesAreCutBetweenCharacters) {
    EXPECT_EQ(shown_value("short"), "short");
    EXPECT_EQ(shown_value(std::string(60, 'x')), std::string(60, 'x'));
    EXPECT_EQ(shown_value(std::string(61, 'x')), std::string(60, 'x') + "…");
    EXPECT_EQ(shown_value(std::string(59, 'x') + "жж"), std::string(59, 'x') + "…");
}

}  // namespace
}  // namespace kadr::xml_test
