// Ways on which the tool turns, S 7.4: cones, a surface with lead and tilt, a second point of the
// tool, and its angle about itself. The numbers of cones and leans are those of the oracles.
#include <cmath>
#include <fstream>
#include <sstream>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "machine/orientation.h"
#include "path/orient_law.h"
#include "tests/interp/five_axis_bench.h"

namespace kadr::interp::orient_interpolation_test {
namespace {

using nlohmann::json;
using path::OrientKind;

constexpr double kOracle = 1e-7;

/// A head that holds the tool in any direction, with a third axis about the tool.
machine::Machine free_head(bool has_spin = false) {
    machine::Machine machine = trunnion();
    machine::Chain chain;
    chain.joints[machine::kR1] = {true,          Axis::C,     machine::ChainSide::Head,
                                  Vec3::UnitZ(), {0, 0, 200}, 1};
    chain.joints[machine::kR2] = {true,          Axis::A,     machine::ChainSide::Head,
                                  Vec3::UnitX(), {0, 0, 120}, 1};
    if (has_spin) {
        chain.joints[machine::kPsi] = {true,          Axis::B,   machine::ChainSide::Head,
                                       Vec3::UnitZ(), {0, 0, 0}, 1};
        machine::MachineAxis spin = machine.axes.back();
        spin.name = "B";
        spin.axis = Axis::B;
        machine.axes.push_back(spin);
    }
    for (machine::MachineAxis& axis : machine.axes) {
        if (!axis.is_rotary) continue;
        axis.lower = -70;
        axis.upper = 70;
    }
    machine.kinematics->chain = machine::prepare(chain).value();
    return machine;
}

std::vector<path::Command> courses(const std::string& text, bool has_spin = false,
                                   const std::string& control = "sinumerik") {
    const Ran ran = read(control, "S1000 M3\nTRAORI\n" + text + "\nM30", free_head(has_spin));
    EXPECT_EQ(alarms(ran), "") << text;
    return motions(ran);
}

std::string refusal(const std::string& text, bool has_spin = false) {
    const Ran ran = read("sinumerik", "S1000 M3\nTRAORI\n" + text, free_head(has_spin));
    return alarms(ran) + " " + (ran.messages.empty() ? "" : std::string(ran.messages[0].row->code));
}

std::vector<json> cases(const char* kind) {
    std::ifstream file(KADR_ROOT "/tests/oracles/orientation.json");
    std::vector<json> found;
    const json all = json::parse(file);
    for (const json& one : all["cases"])
        if (one["kind"] == kind) found.push_back(one);
    EXPECT_FALSE(found.empty()) << kind;
    return found;
}

Vec3 vec(const json& list) {
    return Vec3(list[0].get<double>(), list[1].get<double>(), list[2].get<double>());
}

std::string name_of(const json& one) { return one["id"].get<std::string>(); }

/// `A3=… B3=… C3=…`
std::string words(const json& vector, char number) {
    std::string out;
    for (std::size_t i = 0; i < 3; ++i) {
        out += " ABC"[i + 1];
        out += number;
        char digits[40];
        std::snprintf(digits, sizeof digits, "=%.13f ", vector[i].get<double>());
        out += digits;
    }
    return out;
}

/// Direction of the tool at a fraction of a command that follows another one.
Vec3 tool_at(const path::Command& before, const path::Command& command, double fraction) {
    path::OrientLaw orientation{
        command.motion().orient_kind,         1,
        command.motion().orientation().from,  command.motion().orientation().axis,
        command.motion().orientation().angle, command.motion().orientation().lead_tilt};
    if (command.motion().orient_kind == OrientKind::Cone)
        orientation.start = before.motion().direction;
    const Vec3 from(before.motion().to.data()), to(command.motion().to.data());
    const path::Curve line =
        from == to ? path::Curve(path::Point{from}) : path::Curve(path::make_line(from, to));
    const double length = path::length(line);
    if (command.motion().orient_kind == OrientKind::Surface) orientation.rate /= length;
    if (command.motion().orient_kind == OrientKind::Point) orientation.axis /= length;
    orientation.length = command.motion().orient_kind == OrientKind::Cone ? 1 : length;
    return path::direction_at(orientation, line, fraction * orientation.length);
}

void expect_course(const std::string& text, const json& fractions, const json& vectors,
                   const std::string& what) {
    const auto all = courses(text);
    ASSERT_EQ(all.size(), 2u) << what;
    EXPECT_EQ(all[1].motion().orient_kind, OrientKind::Cone);
    for (std::size_t i = 0; i < fractions.size(); ++i) {
        const Vec3 tool = tool_at(all[0], all[1], fractions[i].get<double>());
        EXPECT_LT((tool - vec(vectors[i])).norm(), kOracle) << what << " " << fractions[i];
    }
    // The rotary axes are where the kinematics have the same direction.
    const machine::Chain chain = free_head().kinematics->chain;
    const Vec3 joints(rad_from_deg(all[1].motion().to[index(Axis::C)]),
                      rad_from_deg(all[1].motion().to[index(Axis::A)]), 0);
    EXPECT_LT((machine::tool_vector(chain, joints) - tool_at(all[0], all[1], 1)).norm(), 1e-9);
}

std::string start_of(const json& in) {
    return "ORIAXES\nG1 X0 Y0 Z0 " + words(in["start"], '3') + " F1000\n";
}

TEST(ToolCourses, ConesAboutAnAxisFollowTheOracle) {
    for (const json& one : cases("ORICONCCW_ORICONCW")) {
        const json& in = one["input"];
        const std::string end = "\nX50 " + words(in["end"], '3') + words(in["cone_axis"], '6');
        expect_course(start_of(in) + "ORICONCCW" + end, in["fractions_of_path_length"],
                      one["expect"]["vectors_ccw"], name_of(one));
        expect_course(start_of(in) + "ORICONCW" + end, in["fractions_of_path_length"],
                      one["expect"]["vectors_cw"], name_of(one));
    }
}

TEST(ToolCourses, ConesByTheirOpeningFollowTheOracle) {
    for (const json& one : cases("NUT")) {
        const json& in = one["input"];
        const std::string end =
            "\nX50 " + words(in["end"], '3') + " NUT=" + std::to_string(in["NUT"].get<double>());
        expect_course(start_of(in) + "ORICONCCW" + end, in["fractions_of_path_length"],
                      one["expect"]["vectors_ccw"], name_of(one));
        expect_course(start_of(in) + "ORICONCW" + end, in["fractions_of_path_length"],
                      one["expect"]["vectors_cw"], name_of(one));
    }
}

TEST(ToolCourses, ConesOverADirectionFollowTheOracle) {
    for (const json& one : cases("ORICONIO_path")) {
        const json& in = one["input"];
        expect_course(start_of(in) + "ORICONIO\nX50 " + words(in["end"], '3') +
                          words(in["intermediate"], '7'),
                      in["fractions_of_path_length"], one["expect"]["vectors"], name_of(one));
    }
}

TEST(ToolCourses, TangentialConesGoOnInTheDirectionOfTheLastTurn) {
    // A great circle about Y arrives along X turned down; the cone goes on from there.
    const auto all = courses("G1 X10 A3=1 C3=1 F1000\nORICONTO\nX20 A3=1 B3=1 C3=1");
    ASSERT_EQ(all.size(), 2u);
    const Vec3 arriving = all[0].motion().orientation().axis.cross(all[0].motion().direction);
    const Vec3 leaving = (tool_at(all[0], all[1], 1e-6) - all[0].motion().direction).normalized();
    EXPECT_LT((leaving - arriving).norm(), 1e-5);
    EXPECT_LT((all[1].motion().direction - Vec3(1, 1, 1).normalized()).norm(), 1e-9);
    EXPECT_LT((tool_at(all[0], all[1], 1) - all[1].motion().direction).norm(), 1e-12);
}

TEST(ToolCourses, LeansFollowTheOracleInBothReadings) {
    for (const json& one : cases("LEAD_TILT")) {
        const json& in = one["input"];
        for (const auto about : {path::TiltAbout::Normal, path::TiltAbout::Tangent}) {
            const path::LeadTiltAngles lead_tilt{rad_from_deg(in["LEAD"].get<double>()),
                                                 rad_from_deg(in["TILT"].get<double>()), about};
            const char* const name = about == path::TiltAbout::Normal ? "vector_tilt_about_normal"
                                                                      : "vector_tilt_about_tangent";
            const Vec3 tool = path::leant(vec(in["normal"]).normalized(),
                                          vec(in["tangent"]).normalized(), lead_tilt);
            EXPECT_LT((tool - vec(one["expect"][name])).norm(), kOracle) << one["id"];
        }
    }
}

TEST(ToolCourses, TheToolLeansAlongTheWholeWay) {
    const auto all = courses("ORIPATH\nG1 X50 LEAD=20 TILT=10 F1000\nX100 A4=0 C4=1 B5=1 C5=4");
    // At the first block's start the tool turns from where it stands, while the tip stands.
    ASSERT_EQ(all.size(), 3u);
    const double lead = rad_from_deg(20), tilt = rad_from_deg(10);
    const Vec3 leant(std::sin(lead), -std::sin(tilt) * std::cos(lead),
                     std::cos(tilt) * std::cos(lead));
    EXPECT_EQ(all[0].motion().to[0], 0);
    EXPECT_EQ(all[0].motion().orient_kind, OrientKind::Cone);
    EXPECT_LT((all[0].motion().direction - leant).norm(), 1e-12);
    EXPECT_EQ(all[1].motion().orient_kind, OrientKind::Surface);
    for (const double f : {0.0, 0.3, 1.0})
        EXPECT_LT((tool_at(all[0], all[1], f) - leant).norm(), 1e-12);
    // The normal turns about X: the lean turns with it, in proportion to the way.
    const double whole = std::atan2(1, 4);
    for (const double f : {0.0, 0.25, 0.5, 1.0}) {
        const Vec3 wanted = Eigen::AngleAxisd(-f * whole, Vec3::UnitX()) * leant;
        EXPECT_LT((tool_at(all[1], all[2], f) - wanted).norm(), 1e-9) << f;
    }
    EXPECT_LT((all[2].motion().direction - tool_at(all[1], all[2], 1)).norm(), 1e-9);
}

TEST(ToolCourses, TheToolFollowsTheTangentOfAnArc) {
    const auto all = courses("ORIPATH\nG1 X50 LEAD=20 F1000\nG3 X60 Y10 CR=10");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[2].op(), path::Op::Arc);
    EXPECT_EQ(all[2].motion().orient_kind, OrientKind::Surface);
    const double lead = rad_from_deg(20);
    EXPECT_LT((all[2].motion().direction - Vec3(0, std::sin(lead), std::cos(lead))).norm(), 1e-9);
}

TEST(ToolCourses, AxiomaLeansAtTheEndOfTheBlockOnly) {
    const auto all = courses("G1 X50 LEAD=20 F1000\nG3 X60 Y10 CR=10 LEAD=20", false, "axioma");
    ASSERT_EQ(all.size(), 2u);
    const double lead = rad_from_deg(20);
    EXPECT_EQ(all[0].motion().orient_kind, OrientKind::Cone);
    EXPECT_LT((all[0].motion().direction - Vec3(std::sin(lead), 0, std::cos(lead))).norm(), 1e-9);
    EXPECT_EQ(all[1].motion().orient_kind, OrientKind::Cone);
    EXPECT_LT((all[1].motion().direction - Vec3(0, std::sin(lead), std::cos(lead))).norm(), 1e-9);
}

TEST(ToolCourses, AxiomasAnglesAreZyz) {
    // φ = 30, θ = 45: A 3, where SINUMERIK's ORIEULER turns about X'.
    const auto all = courses("ORIEULER\nG1 X10 A2=30 B2=45 C2=60 F1000", false, "axioma");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_LT((all[0].motion().direction - Vec3(0.6123724357, 0.3535533906, 0.7071067812)).norm(),
              1e-9);
    const auto rpy = courses("ORIRPY\nG1 X10 A2=30 B2=45 C2=60 F1000", false, "axioma");
    EXPECT_LT((rpy.at(0).motion().direction - Vec3(0.739199, 0.280330, 0.612372)).norm(), 1e-6);
}

/// A head whose C cannot go the short way from 160 to 200 degrees, and whose A does not change the
/// configuration.
machine::Machine cramped(machine::PathRule rule) {
    machine::Machine machine = free_head();
    machine.kinematics->rule = rule;
    for (machine::MachineAxis& axis : machine.axes) {
        if (axis.axis == Axis::C) axis.lower = -(axis.upper = rad_from_deg(170));
        if (axis.axis == Axis::A) axis.lower = 0, axis.upper = rad_from_deg(90);
    }
    return machine;
}

TEST(ToolCourses, AxiomaGoesTheWaysThatItsParameterAdmits) {
    // A 5: 1 the shortest way only, 2 any way between axes, 3 any way, then between axes.
    const std::string start = "TRAORI\nORIAXES\nG1 X0 A=30 C=160 F1000\n";
    const double azimuth = rad_from_deg(200), tilt = rad_from_deg(30);
    char block[160];
    std::snprintf(block, sizeof block, "X10 A3=%.9f B3=%.9f C3=%.9f\nM30",
                  std::sin(azimuth) * std::sin(tilt), -std::cos(azimuth) * std::sin(tilt),
                  std::cos(tilt));
    using machine::PathRule;
    const struct {
        PathRule rule;
        std::string mode;
        std::string alarm;
    } rows[] = {
        {PathRule::Shortest, "ORIAXES\n", "14112"},
        {PathRule::Shortest, "ORIVECT\n", "14112"},
        {PathRule::LongInAxisMode, "ORIAXES\n", ""},
        {PathRule::LongInAxisMode, "ORIVECT\n", "14112"},
        {PathRule::LongAlways, "ORIAXES\n", ""},
        {PathRule::LongAlways, "ORIVECT\n", "K6331"},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.mode + std::to_string(static_cast<int>(row.rule)));
        const Ran ran = read("axioma", "S1000 M3\n" + start + row.mode + block, cramped(row.rule));
        EXPECT_EQ(alarms(ran), row.alarm);
        EXPECT_EQ(ran.alarmed, row.alarm == "14112");
        if (ran.alarmed) {
            EXPECT_EQ(ran.messages.at(0).row->code, "K5607");
            continue;
        }
        if (row.alarm == "K6331") {
            // C turns by 320 degrees with the tool 30 degrees off its axis. Half way round the tool
            // leans to the other side, and the plane atan(tan 30° · cos 20°) = 28.4817° to this
            // one.
            EXPECT_EQ(ran.messages.at(0).arguments.at(0), "58.4812");
        }
        const auto all = motions(ran);
        ASSERT_EQ(all.size(), 2u);
        EXPECT_NEAR(all[1].motion().to[index(Axis::C)], -160, 1e-6);
        EXPECT_EQ(all[1].motion().orient_kind, OrientKind::Axes);
    }
}

TEST(ToolCourses, WithOneRotaryAxisAVectorIsRefusedAndTheTipIsHeld) {
    machine::Machine machine = trunnion();
    machine.kinematics->chain.joints[machine::kR1].is_present = false;
    machine.kinematics->chain = machine::prepare(machine.kinematics->chain).value();
    const Ran held = read("axioma", "S1000 M3\nTRAORI\nG1 X10 A=20 F1000\nM30", machine);
    EXPECT_EQ(alarms(held), "");
    const Ran refused = read("axioma", "S1000 M3\nTRAORI\nG1 X10 A3=1 C3=1 F1000\nM30", machine);
    EXPECT_EQ(alarms(refused), "14112");
    EXPECT_EQ(refused.messages.at(0).row->code, "K5606");
}

TEST(ToolCourses, ASecondPointLeadsTheTool) {
    const auto all =
        courses("ORICURVE\nG1 X0 Y0 Z0 XH=0 YH=0 ZH=100 F1000\nX50 XH=50 YH=40 ZH=80\nX100 XH=90");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[1].motion().orient_kind, OrientKind::Point);
    for (const double f : {0.0, 0.3, 0.7, 1.0}) {
        const Vec3 tip(50 * f, 0, 0);
        const Vec3 point = Vec3(0, 0, 100) + f * Vec3(50, 40, -20);
        EXPECT_LT((tool_at(all[0], all[1], f) - (point - tip).normalized()).norm(), 1e-12) << f;
    }
    EXPECT_LT(
        (all[2].motion().direction - (Vec3(90, 40, 80) - Vec3(100, 0, 0)).normalized()).norm(),
        1e-9);
}

TEST(ToolCourses, TheThirdAngleTurnsTheToolAboutItself) {
    const auto all = courses("ORIEULER\nG1 X10 A2=30 B2=40 C2=50 F1000", true);
    ASSERT_EQ(all.size(), 1u);
    const machine::Chain chain = free_head(true).kinematics->chain;
    const Vec3 joints(rad_from_deg(all[0].motion().to[index(Axis::C)]),
                      rad_from_deg(all[0].motion().to[index(Axis::A)]),
                      rad_from_deg(all[0].motion().to[index(Axis::B)]));
    const machine::Mat3 wanted =
        machine::euler_zxz({rad_from_deg(30), rad_from_deg(40), rad_from_deg(50)});
    EXPECT_LT((machine::rotation_of(chain, joints) - wanted).norm(), 1e-9);
}

/// The tool's own X where a command ends.
Vec3 across_of(const path::Command& command) {
    const machine::Chain chain = free_head(true).kinematics->chain;
    return machine::rotation_of(chain, {rad_from_deg(command.motion().to[index(Axis::C)]),
                                        rad_from_deg(command.motion().to[index(Axis::A)]),
                                        rad_from_deg(command.motion().to[index(Axis::B)])})
        .col(0);
}

TEST(ToolCourses, ThetaCountsFromWhatItsModeSays) {
    const double theta = rad_from_deg(30);
    // In space: the third angle of ORIEULER.
    const auto fixed = courses("G1 X10 A3=1 B3=2 C3=3 THETA=30 F1000", true);
    const Vec3 tool = Vec3(1, 2, 3).normalized();
    const double around = std::atan2(2, 1) + std::numbers::pi / 2;
    const machine::Mat3 wanted =
        machine::euler_zxz({around, std::acos(3 / std::sqrt(14.0)), theta});
    EXPECT_LT((across_of(fixed.at(0)) - wanted.col(0)).norm(), 1e-9);
    // From the plane of the great circle: at 0 along the way on which the tool turns.
    const auto plane = courses("ORIROTR\nG1 X10 A3=1 B3=2 C3=3 THETA=30 F1000", true);
    const Vec3 along = plane.at(0).motion().orientation().axis.cross(tool);
    EXPECT_LT((across_of(plane.at(0)) - Eigen::AngleAxisd(theta, tool) * along).norm(), 1e-9);
    // From the direction of travel.
    const auto path = courses("ORIROTC\nG1 X10 A3=0 B3=1 C3=1 THETA=30 F1000", true);
    const Vec3 leant = Vec3(0, 1, 1).normalized();
    EXPECT_LT((across_of(path.at(0)) - Eigen::AngleAxisd(theta, leant) * Vec3::UnitX()).norm(),
              1e-9);
    const auto by = courses("G1 X10 THETA=30 F1000\nX20 THETA=IC(15)", true);
    EXPECT_NEAR(by.at(1).motion().to[index(Axis::B)] - by.at(0).motion().to[index(Axis::B)], 15,
                1e-9);
}

TEST(ToolCourses, ThetaWithoutAThirdAxisIsIgnoredAndSaid) {
    EXPECT_EQ(refusal("G1 X10 A3=1 C3=1 THETA=30 F1000\nX20 THETA=40\nM30"), "K5630 K5630");
}

TEST(ToolCourses, TheRotaryAxesCanBeSentHome) {
    const auto all = courses("G1 X10 A3=1 C3=1 F1000\nORIRESET(20,30)\nORIRESET()");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_NEAR(all[1].motion().to[index(Axis::C)], 20, 1e-9);
    EXPECT_NEAR(all[1].motion().to[index(Axis::A)], 30, 1e-9);
    EXPECT_EQ(all[1].motion().orient_kind, OrientKind::Axes);
    EXPECT_EQ(all[1].motion().to[0], 10);
    EXPECT_EQ(all[2].motion().to[index(Axis::C)], 0);
    EXPECT_EQ(all[2].motion().to[index(Axis::A)], 0);
}

TEST(ToolCourses, ConeThatALimitCutsIsRefused) {
    machine::Machine machine = free_head();
    for (machine::MachineAxis& axis : machine.axes)
        if (axis.axis == Axis::C) axis.lower = axis.upper - rad_from_deg(200);
    const Ran ran = read("sinumerik",
                         "S1000 M3\nTRAORI\nG1 X10 A3=1 C3=2 F1000\nORICONCCW\n"
                         "X20 A3=1 C3=2 C6=1\nX30 A3=0.9 B3=-0.435889894 C3=2 C6=1",
                         machine);
    EXPECT_EQ(alarms(ran), "14112");
    EXPECT_EQ(ran.messages.at(0).row->code, "K5607");
}

TEST(ToolCourses, WordsThatDoNotFitAreRefused) {
    const std::string g1 = "G1 X10 ";
    EXPECT_EQ(refusal("ORIPATH\n" + g1 + "A3=1 C3=1 F100"), "14116 K5617");
    EXPECT_EQ(refusal("ORIPATH\n" + g1 + "LEAD=95 F100"), "14113 K5615");
    EXPECT_EQ(refusal("ORIPATH\n" + g1 + "TILT=-90 F100"), "14114 K5616");
    EXPECT_EQ(refusal("ORIPATH\nG1 Z10 C4=1 LEAD=10 F100"), "14115 K5614");
    EXPECT_EQ(refusal("ORIPATH\nG1 C4=1 LEAD=10 F100"), "14115 K5613");
    EXPECT_EQ(refusal("ORIPATH\n" + g1 + "LEAD=10 A=20 F100"), "14131 K5627");
    EXPECT_EQ(refusal("ORICONCW\n" + g1 + "A3=1 C3=1 F100"), "14117 K5618");
    EXPECT_EQ(refusal("ORICONCW\n" + g1 + "A3=1 C3=1 A6=1 F100"), "14112 K5619");
    EXPECT_EQ(refusal("ORICONCCW\n" + g1 + "C6=1 NUT=30 F100"), "14118 K5620");
    EXPECT_EQ(refusal("ORICONIO\n" + g1 + "A3=1 C3=1 F100"), "14119 K5621");
    EXPECT_EQ(refusal("ORICONIO\n" + g1 + "A3=1 C3=1 C7=1 F100"), "14112 K5622");
    EXPECT_EQ(refusal("ORICONCCW\n" + g1 + "A3=1 C3=1 NUT=30 F100"), "14112 K5623");
    EXPECT_EQ(refusal("ORIVECT\n" + g1 + "A3=1 C3=1 C6=1 F100"), "K5624 K5624");
    EXPECT_EQ(
        read("sinumerik", "S1000 M3\nTRAORI\nORICONCW\nX10 A3=1 C3=1 C7=1 F100", free_head(false))
            .messages.at(0)
            .message(),
        "`C7=1` means nothing under `ORICONCW`");
    // Nobody has said the way on which the tool turns: it is the control's first one.
    EXPECT_EQ(read("sinumerik", "S1000 M3\nTRAORI\nG1 X10 A3=1 C3=1 C6=1 F100", free_head(false))
                  .messages.at(0)
                  .message(),
              "`C6=1` means nothing under `ORIVECT`");
    EXPECT_EQ(refusal("ORICURVE\n" + g1 + "Y0 Z0 XH=10 YH=0 ZH=0 F100"), "14121 K5625");
    EXPECT_EQ(refusal("ORIROTR\n" + g1 + "THETA=30 F100", true), "K5626 K5626");
    EXPECT_EQ(refusal("ORIRESET(0,0,90)"), "14130 K5628");
}

}  // namespace
}  // namespace kadr::interp::orient_interpolation_test
