// Plots: what is kept of a long path, and what a drawing shows.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plot/plot_colors.h"
#include "plot/plot_layout.h"
#include "plot/plot_scene.h"
#include "plot/plot_svg.h"

namespace plot_test {

namespace {

using namespace kadr;
using namespace kadr::plot;
using path::Vec3;

class Plot : public ::testing::Test {
  protected:
    void go(motion::SegmentKind kind, const path::Curve& curve, double feed) {
        motion::Segment segment;
        segment.kind = kind;
        segment.curve = curve;
        at_ = path::end(curve);
        scene_.add(segment, feed);
    }
    void rapid(const Vec3& to) { go(motion::SegmentKind::Rapid, path::make_line(at_, to), 0); }
    void line(const Vec3& to, double feed) {
        go(motion::SegmentKind::Feed, path::make_line(at_, to), feed);
    }
    void arc(const Vec3& to, const Vec3& center, double sweep, double feed) {
        go(motion::SegmentKind::Feed, path::make_helix(at_, to, center, Vec3::UnitZ(), sweep),
           feed);
    }
    Vec3 at_{-100, -100, 100};  // where the machine happens to stand
    PlotScene scene_;
};

TEST_F(Plot, BeginsWhereTheFirstMotionArrives) {
    rapid({5, 5, 50});
    line({5, 5, 0}, 100);
    ASSERT_EQ(scene_.pieces().size(), 2u);
    EXPECT_EQ(scene_.pieces()[0].kind, PlotPiece::Kind::Jump);
    EXPECT_EQ(scene_.feed_box().lower.z(), 0);
    EXPECT_EQ(scene_.feed_box().upper.z(), 50);
}

TEST_F(Plot, BoxHoldsTheBulgeOfAnArc) {
    // Half a circle of radius 10 about the origin from (10, 0) to (-10, 0) reaches y = 10.
    rapid({10, 0, 0});
    arc({-10, 0, 0}, {0, 0, 0}, std::numbers::pi, 200);
    EXPECT_NEAR(scene_.feed_box().upper.y(), 10, 0.1);
    EXPECT_NEAR(scene_.feed_box().lower.y(), 0, 1e-9);
}

TEST_F(Plot, PointOnHelix) {
    // A full turn that rises by 4: after a quarter the height has grown by 1.
    const PlotArc helix{{0, 0, 0}, Vec3::UnitZ(), 2 * std::numbers::pi};
    const Vec3 point = point_on_arc(helix, {10, 0, 0}, {10, 0, 4}, 0.25);
    EXPECT_NEAR((point - Vec3(0, 10, 1)).norm(), 0, 1e-12);
}

TEST_F(Plot, ToolsAreDrawnAlongThePathInEveryView) {
    rapid({0, 0, 0});
    line({100, 0, 0}, 100);
    line({100, 60, 20}, 100);
    const std::string without = plot_svg(scene_, {}, PlotColor::Feed);
    EXPECT_EQ(without.find("isometric"), std::string::npos);
    std::vector<PlotTool> tools;
    for (int i = 0; i <= 1000; ++i) tools.push_back({{0.1 * i, 0, 0}, Vec3(0, 0.6, 0.8)});
    const PlotLayout layout = lay_out(scene_, tools);
    ASSERT_EQ(layout.views.size(), 4u);
    // The tool is drawn 12 % of 100 mm long: the views have room for its end.
    EXPECT_GE(layout.shown.upper.z(), 20);
    EXPECT_GE(layout.shown.upper.y(), 60);
    // X, Y and Z go to the right below, to the right above, and up; all in one scale.
    const View& view = layout.views[3];
    const auto step = [&](const Vec3& delta) {
        return std::pair(view.x(delta) - view.x(Vec3::Zero()),
                         view.y(Vec3::Zero()) - view.y(delta));
    };
    const auto [x_right, x_up] = step(Vec3::UnitX());
    const auto [y_right, y_up] = step(Vec3::UnitY());
    const auto [z_right, z_up] = step(Vec3::UnitZ());
    EXPECT_NEAR(x_right, y_right, 1e-9);
    EXPECT_NEAR(x_up, -y_up, 1e-9);
    EXPECT_NEAR(z_right, 0, 1e-9);
    EXPECT_NEAR(z_up, std::hypot(x_right, x_up), 1e-9);
    EXPECT_LT(x_up, 0);
    EXPECT_GT(z_up, 0);
    // Every corner of what is shown is on the paper of the view.
    for (const Vec3& corner : {layout.shown.lower, layout.shown.upper}) {
        EXPECT_GT(view.x(corner), view.frame.left);
        EXPECT_LT(view.x(corner), view.frame.right());
        EXPECT_GT(view.y(corner), view.frame.top);
        EXPECT_LT(view.y(corner), view.frame.bottom());
    }
    const std::string svg = plot_svg(scene_, {}, PlotColor::Feed, tools);
    EXPECT_NE(svg.find("isometric"), std::string::npos);
    EXPECT_NE(svg.find("tool, from its tip"), std::string::npos);
    std::size_t drawn = 0;
    const std::string mark = "<path class=\"tool\" d=\"";
    for (std::size_t from = svg.find(mark); from != std::string::npos;
         from = svg.find(mark, from + 1)) {
        const std::string one = svg.substr(from, svg.find("/>", from) - from);
        drawn += static_cast<std::size_t>(std::ranges::count(one, 'M'));
    }
    EXPECT_GT(drawn, 100u);
    EXPECT_LT(drawn, 400u) << "no more than have room";
}

TEST_F(Plot, LongPathsAreThinnedToWhatIsVisible) {
    // A million short lines along a circle of radius 50.
    rapid({50, 0, 0});
    for (int i = 1; i <= 1'000'000; ++i) {
        const double a = i * 2 * std::numbers::pi / 100'000;
        line({50 * std::cos(a), 50 * std::sin(a), -1}, 500);
    }
    EXPECT_LE(scene_.pieces().size(), 200'000u);
    for (const PlotPiece& piece : scene_.pieces()) {
        ASSERT_NEAR(std::hypot(piece.to.x(), piece.to.y()), 50, 0.5);
    }
    EXPECT_NEAR(scene_.pieces().back().to.x(), 50, 1e-6);
}

TEST_F(Plot, FewFeedsHaveAColorEach) {
    rapid({0, 0, 0});
    for (const double feed : {300.0, 100.0, 300.0, 200.0}) line({feed, 0, 0}, feed);
    const auto legend = legend_of(scene_, PlotColor::Feed);
    ASSERT_EQ(legend.size(), 3u);
    EXPECT_EQ(legend[0].label, "100");
    EXPECT_EQ(legend[2].label, "300");
    EXPECT_EQ(&entry_for(legend, 200), &legend[1]);
}

TEST_F(Plot, ManyShadesAreGrouped) {
    rapid({0, 0, 0});
    for (int i = 1; i <= 70; ++i) line({i * 1.0, 0, 0}, i);
    EXPECT_EQ(legend_of(scene_, PlotColor::Feed).front().label, "1 to 10");
    EXPECT_EQ(legend_of(scene_, PlotColor::Line).back().label, "lines 61 to 70");
}

TEST_F(Plot, ViewsHaveOneScaleAndLineUp) {
    rapid({0, 0, 5});
    line({100, 60, -10}, 100);
    const PlotLayout layout = lay_out(scene_);
    ASSERT_EQ(layout.views.size(), 3u);
    const View& plan = layout.views[0];
    const View& front = layout.views[1];
    const View& side = layout.views[2];
    EXPECT_EQ(plan.scale, front.scale);
    EXPECT_EQ(plan.x(40), front.x(40));
    EXPECT_EQ(plan.y(20), side.y(20));
    EXPECT_LT(plan.y(60), plan.y(0));
    EXPECT_EQ(plan.towards_eye(), Vec3::UnitZ());
}

TEST_F(Plot, TurnedPartLiesInTheChuck) {
    rapid({30, 0, 2});
    line({30, 0, -70}, 200);
    line({32, 0, -70}, 200);
    const PlotLayout layout = lay_out(scene_);
    ASSERT_EQ(layout.views.size(), 1u);
    EXPECT_EQ(layout.views[0].name, "Z-X");
    // On a lathe X is read off as the control shows it.
    PlotText text;
    text.has_diameters = true;
    const std::string svg = plot_svg(scene_, text, PlotColor::Feed);
    EXPECT_NE(svg.find(">Z-X, X as diameters</text>"), std::string::npos);
    EXPECT_NE(svg.find(">4</text>"), std::string::npos);  // from diameter 60 to 64
    EXPECT_NE(svg.find(">60</text>"), std::string::npos);
}

TEST_F(Plot, FeedsThatOnlyRoundingTellsApartAreOne) {
    rapid({0, 0, 0});
    line({10, 0, 0}, 100);
    line({20, 0, 0}, 1088.931);
    line({30, 10, 0}, 1088.932);
    const std::string svg = plot_svg(scene_, {}, PlotColor::Feed);
    EXPECT_NE(svg.find(">1088.931</text>"), std::string::npos);
    EXPECT_EQ(svg.find(">1088.932</text>"), std::string::npos);
}

TEST_F(Plot, RapidsToAndFroAreDrawnOnce) {
    rapid({0, 0, 10});
    line({0, 0, 0}, 100);
    rapid({50, 20, 0});
    const std::string svg = plot_svg(scene_, {}, PlotColor::Feed);
    EXPECT_NE(svg.find("<path class=\"rapid\" d=\"M"), std::string::npos);
    rapid({0, 0, 0});
    rapid({50, 20, 0});
    EXPECT_EQ(plot_svg(scene_, {}, PlotColor::Feed), svg);
}

TEST_F(Plot, DrawingShowsArcsRapidsAndDimensions) {
    rapid({10, 0, 0});
    arc({10, 0, 0}, {0, 0, 0}, 2 * std::numbers::pi, 200);
    rapid({0, 0, 20});
    const std::string svg =
        plot_svg(scene_, {"a<b>.kadr", "control", "", "mm/min"}, PlotColor::Feed);
    EXPECT_NE(svg.find("a&lt;b&gt;.kadr"), std::string::npos);
    EXPECT_NE(svg.find("class=\"rapid\""), std::string::npos);
    EXPECT_NE(svg.find(">20</text>"), std::string::npos);  // the diameter as a dimension
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    std::size_t arcs = 0;
    for (std::size_t at = svg.find('A'); at != std::string::npos; at = svg.find('A', at + 1)) {
        arcs += svg[at + 1] >= '0' && svg[at + 1] <= '9' ? 1 : 0;
    }
    EXPECT_EQ(arcs, 3u);  // the circle of the plan view, in thirds; the side views see lines
}

TEST_F(Plot, EmptySceneIsADrawingToo) {
    const std::string svg =
        plot_svg(scene_, {"empty", "", "not complete", "mm/min"}, PlotColor::Feed);
    EXPECT_NE(svg.find("not complete"), std::string::npos);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

/// Where the name of a mark stands: x, y of its first or last letter, and which of both.
struct Name {
    double x = 0;
    double y = 0;
    bool is_end = false;
};

Name name_in(const std::string& svg, const std::string& text) {
    const std::size_t at = svg.rfind("<text", svg.find('>' + text + "</text>"));
    const auto number = [&](const std::string& attribute) {
        return std::stod(svg.substr(svg.find(attribute + "=\"", at) + attribute.size() + 2));
    };
    return {number("x"), number("y"), svg.find("text-anchor=\"end\"", at) < svg.find('>', at)};
}

TEST_F(Plot, NamesOfTheMarksStayInsideTheFrame) {
    // From the upper right corner of the drawing to its lower left one.
    rapid({100, 60, 0});
    line({0, 0, 0}, 100);
    const PlotFrame frame = lay_out(scene_).views[0].frame;
    const std::string svg = plot_svg(scene_, {}, PlotColor::Feed);
    for (const std::string name : {"start", "end"}) {
        SCOPED_TRACE(name);
        const Name at = name_in(svg, name);
        const double width = 7.0 * static_cast<double>(name.size());
        EXPECT_GE(at.x - (at.is_end ? width : 0), frame.left);
        EXPECT_LE(at.x + (at.is_end ? 0 : width), frame.right());
        EXPECT_GE(at.y - 12, frame.top);
        EXPECT_LE(at.y, frame.bottom());
    }
}

}  // namespace

}  // namespace plot_test
