// Every cycle of the library is run over random parameters. A property of properties/ that calls it
// counts by itself; what C++ tests draw the parameters of stands here, with the file and what it
// calls.
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "base/text.h"

namespace coverage_test {

namespace {

namespace fs = std::filesystem;

struct Place {
    const char* file;
    const char* call;  // as it stands there
};

const std::map<std::string, Place> kDrawnInCpp = {
    {"center", {"drilling_test.cpp", "center(d: "}},
    {"drill", {"drilling_test.cpp", "\"drill\" + heights"}},
    {"drill_peck", {"drilling_test.cpp", "\"drill_peck\", \"drill_chip\""}},
    {"drill_chip", {"drilling_test.cpp", "\"drill_peck\", \"drill_chip\""}},
    {"drill_deep", {"drilling_test.cpp", "drill_deep(to: \" + mm("}},
    {"ream", {"drilling_test.cpp", "\"ream\" + heights"}},
    {"bore", {"drilling_test.cpp", "\"bore\" + heights"}},
    {"bore_stop", {"drilling_test.cpp", "\"bore_stop\" + heights"}},
    {"pocket_circle", {"milling_test.cpp", "pocket_circle(d: \" + mm("}},
    {"pocket_rect", {"milling_test.cpp", "pocket_rect(w: \" + mm("}},
    {"slot", {"milling_test.cpp", "slot(l: \" + mm("}},
    {"slot_arc", {"milling_test.cpp", "slot_arc(d: \" + mm("}},
    {"slot_trochoidal", {"milling_test.cpp", "slot_trochoidal(l: \" + mm("}},
    {"spigot_circle", {"milling_test.cpp", "spigot_circle(d: \" + mm("}},
    {"spigot_rect", {"milling_test.cpp", "spigot_rect(w: \" + mm("}},
    {"chamfer_circle", {"milling_test.cpp", "TEST(Milling, ChamfersOfAnySize)"}},
    {"chamfer_rect", {"milling_test.cpp", "TEST(Milling, ChamfersOfAnySize)"}},
    {"mill_contour", {"contours_test.cpp", "TEST(Contours, WallsOfAnyShape)"}},
    {"chamfer_contour", {"contours_test.cpp", "TEST(Contours, ChamfersOfAnyShape)"}},
    {"turn_rough", {"turning_test.cpp", "\"turn_rough\""}},
    {"face_rough", {"turning_test.cpp", "\"face_rough\""}},
    {"turn_contour", {"turning_test.cpp", "turn_contour(shape, allowance: \" + mm("}},
    {"native_stock_rough", {"turning_test.cpp", "TEST(Turning, NativeRoughing)"}},
    {"native_stock_follow", {"turning_test.cpp", "TEST(Turning, NativeFinishing)"}},
    {"turn_finish", {"turning_test.cpp", "\"turn_finish({\" + points"}},
    {"turn_face", {"turning_test.cpp", "turn_face(d: \" + mm("}},
    {"turn_groove", {"turning_test.cpp", "turn_groove(d: \" + mm("}},
    {"part_off", {"turning_test.cpp", "part_off(d: \" + mm("}},
    {"stock_removal", {"turning_test.cpp", "TEST(ControlTurning, StockRemoval)"}},
    {"groove_cut", {"turning_test.cpp", "TEST(ControlTurning, Groove)"}},
    {"turn_once", {"lathe_cycles_test.cpp", "\"turn_once\" + ends"}},
    {"face_once", {"lathe_cycles_test.cpp", "\"face_once\" + ends"}},
    {"undercut_shoulder", {"lathe_cycles_test.cpp", "undercut_shoulder(d: \" + mm("}},
    {"undercut_thread", {"lathe_cycles_test.cpp", "undercut_thread(d: \" + mm("}},
    {"stock_rough", {"lathe_cycles_test.cpp", "stock_rough(shape, step: \" + mm("}},
    {"stock_pattern", {"lathe_cycles_test.cpp", "stock_pattern(shape, relief_x: \" + mm("}},
    {"stock_follow", {"lathe_cycles_test.cpp", "stock_follow(shape)"}},
    {"stock_peck", {"lathe_cycles_test.cpp", "stock_peck(x: \" + mm("}},
    {"thread_turn", {"threading_test.cpp", "thread_turn(d: \" + mm("}},
    {"thread_cut", {"lathe_cycles_test.cpp", "thread_cut(lead: \" + mm("}},
    {"thread_cut_sized", {"lathe_cycles_test.cpp", "thread_cut_sized(thread_size: \" +"}},
    {"thread_chain", {"lathe_cycles_test.cpp", "\"thread_chain(\""}},
    {"thread_passes", {"lathe_cycles_test.cpp", "thread_passes(x: \" + mm("}},
    {"thread_once", {"lathe_cycles_test.cpp", "thread_once(x: \" + mm("}},
    // By the control's own call.
    {"cavity_rect", {"control_cycles_test.cpp", "call(\"POCKET3\""}},
    {"cavity_circle", {"control_cycles_test.cpp", "call(\"POCKET4\""}},
    {"cavity_slots", {"control_cycles_test.cpp", "call(\"SLOT1\""}},
    {"cavity_arc_slots", {"control_cycles_test.cpp", "call(\"SLOT2\""}},
    {"cavity_long_holes", {"control_cycles_test.cpp", "\"LONGHOLE\""}},
    {"face_strokes", {"control_cycles_test.cpp", "call(\"CYCLE71\""}},
    {"boss_rect", {"control_cycles_test.cpp", "call(\"CYCLE76\""}},
    {"boss_circle", {"control_cycles_test.cpp", "call(\"CYCLE77\""}},
    {"thread_helix", {"control_cycles_test.cpp", "call(\"CYCLE90\""}},
    {"contour_passes", {"control_cycles_test.cpp", "\"CYCLE72\""}},
    {"probe_edge", {"probing_test.cpp", "TEST(Probing, EdgesAreFoundWhereverTheyAre)"}},
    {"probe_bore", {"probing_test.cpp", "TEST(Probing, TouchesEveryFaceTwice)"}},
    {"probe_boss", {"probing_test.cpp", "TEST(Probing, TouchesEveryFaceTwice)"}},
};

/// Names of all cycles of the library.
std::set<std::string> cycles_of_library() {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(KADR_ROOT) / "stdlib")) {
        if (entry.path().extension() != ".kadr") continue;
        std::istringstream lines(kadr::read_file(entry.path().string()).value_or(""));
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("cycle ")) names.insert(line.substr(6, line.find('(') - 6));
        }
    }
    return names;
}

/// The properties of the folder, without the tests with fixed values beside them.
std::string properties() {
    std::string all;
    const fs::path folder = fs::path(KADR_ROOT) / "tests/stdlib/properties";
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::istringstream lines(kadr::read_file(entry.path().string()).value_or(""));
        bool is_test = false;
        for (std::string line; std::getline(lines, line);) {
            const bool is_head = !line.empty() && line[0] != ' ' && line[0] != '}';
            if (is_head) is_test = line.starts_with("test ") || line.starts_with("//");
            if (!is_test) all += line + '\n';
        }
    }
    return all;
}

TEST(Coverage, EveryCycleIsRunOverRandomParameters) {
    const std::set<std::string> cycles = cycles_of_library();
    EXPECT_GT(cycles.size(), 75u);
    const std::string text = properties();
    for (const std::string& name : cycles) {
        if (kDrawnInCpp.contains(name)) continue;
        EXPECT_TRUE(std::regex_search(text, std::regex("\\b" + name + "\\(")))
            << "no random test runs the cycle `" << name << '`';
    }
    for (const auto& [name, drawn] : kDrawnInCpp) {
        EXPECT_TRUE(cycles.contains(name)) << name << " is no cycle of the library any more";
        const std::string test =
            kadr::read_file(KADR_ROOT "/tests/stdlib/" + std::string(drawn.file)).value_or("");
        EXPECT_NE(test.find(drawn.call), std::string::npos)
            << drawn.file << " does not call " << name << " by " << drawn.call;
    }
}

}  // namespace

}  // namespace coverage_test
