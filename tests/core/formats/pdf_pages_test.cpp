// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pdf/pdf_pages.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "tests/core/formats/export_fixtures.h"

namespace toile {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kSame = 1e-9;  // mm

/// The rims of rectangles, from x, y, width and height.
PrintedContent rectangles(const std::vector<Eigen::Vector4d>& boxes) {
    PrintedContent content;
    for (const Eigen::Vector4d& box : boxes) {
        const Points2 area = test::rectangle(box[0], box[1], box[2], box[3]);
        Points2 line(5, 2);
        line << area, area.row(0);
        content.lines.push_back(line);
        content.areas.push_back(area);
        content.box.extend(
            AlignedBox2d(Vector2d(box[0], box[1]), Vector2d(box[0] + box[2], box[1] + box[3])));
    }
    return content;
}

PdfPlan planned(const PrintedContent& content, Paper paper, double overlap = 10) {
    const auto plan = planPages(content, {paper, overlap});
    EXPECT_TRUE(plan) << (plan ? "" : sentence(plan.error()));
    return plan ? *plan : PdfPlan{};
}

bool isShown(const PdfPlan& plan, const Vector2d& point) {
    for (const PdfPage& page : plan.pages) {
        if (page.window.exteriorDistance(onSheet(plan, point)) < kSame) {
            return true;
        }
    }
    return false;
}

TEST(PlanPages, TilesShowAllLinesAndAllCloth) {
    const PrintedContent content =
        rectangles({{0, 0, 700, 900}, {900, 100, 333, 40}, {-200, 1500, 20, 700}});
    for (const Paper paper : {Paper::A4, Paper::Letter, Paper::Shared, Paper::A0, Paper::ArchD,
                              Paper::ArchE, Paper::Roll610, Paper::Roll841, Paper::Roll914}) {
        for (const double overlap : {0.0, 10.0, 37.5}) {
            const PdfPlan plan = planned(content, paper, overlap);
            for (const Points2& area : content.areas) {
                const AlignedBox2d box(area.row(0).transpose(), area.row(2).transpose());
                for (double x = 0; x <= 1; x += 1.0 / 64) {
                    for (double y = 0; y <= 1; y += 1.0 / 64) {
                        const Vector2d share(x, y);
                        EXPECT_TRUE(isShown(plan, box.min() + share.cwiseProduct(box.sizes())));
                    }
                }
            }
        }
    }
}

TEST(PlanPages, TilesOverlapAsAskedAndFillThePaperToItsMargins) {
    const PrintedContent content = rectangles({{0, 0, 700, 900}});
    for (const double overlap : {0.0, 10.0, 25.0}) {
        const PdfPlan plan = planned(content, Paper::A4, overlap);
        ASSERT_TRUE(plan.isTiled);
        EXPECT_EQ(plan.paper, Vector2d(210, 297));
        for (const PdfPage& page : plan.pages) {
            EXPECT_LT((page.window.sizes() - Vector2d(190, 277)).norm(), kSame);
        }
        for (const SharedEdge& edge : plan.shared) {
            const AlignedBox2d both =
                plan.pages[static_cast<std::size_t>(edge.page)].window.intersection(
                    plan.pages[static_cast<std::size_t>(edge.other)].window);
            EXPECT_NEAR(both.sizes().minCoeff(), overlap, kSame);
        }
    }
    EXPECT_EQ(planned(content, Paper::Shared).paper, Vector2d(210, 279));
    EXPECT_EQ(planned(content, Paper::Letter).paper, Vector2d(215.9, 279.4));
}

TEST(PlanPages, LeavesOutWhatWouldBeEmpty) {
    // Two small pieces, far apart: their corners' tiles, and none between.
    const PdfPlan plan = planned(rectangles({{0, 0, 50, 50}, {1500, 2000, 50, 50}}), Paper::A4);
    EXPECT_LE(plan.pages.size(), 8U);
    EXPECT_GE(plan.rows * plan.columns, 60);
    std::set<std::string> names;
    for (const PdfPage& page : plan.pages) {
        EXPECT_TRUE(names.insert(tileName(page)).second);
    }
    // The inside of a piece is cloth, whether lines cross it or not.
    const PdfPlan full = planned(rectangles({{0, 0, 1500, 2000}}), Paper::A4);
    EXPECT_EQ(static_cast<int>(full.pages.size()), full.rows * full.columns);
}

TEST(PlanPages, MarksAreInReachOfBothPages) {
    for (const double overlap : {0.0, 10.0}) {
        const PdfPlan plan =
            planned(rectangles({{0, 0, 700, 900}, {500, 1200, 100, 40}}), Paper::Shared, overlap);
        std::set<std::pair<int, int>> pairs;
        for (const SharedEdge& edge : plan.shared) {
            const PdfPage& page = plan.pages[static_cast<std::size_t>(edge.page)];
            const PdfPage& other = plan.pages[static_cast<std::size_t>(edge.other)];
            EXPECT_TRUE(pairs.insert({edge.page, edge.other}).second);
            EXPECT_EQ(std::abs(page.row - other.row) + std::abs(page.column - other.column), 1);
            for (const PdfPage* side : {&page, &other}) {
                EXPECT_LT(side->window.exteriorDistance(edge.middle), kSame);
                // On the frame of both, where the paper is cut.
                const Vector2d low = edge.middle - side->frame.min();
                const Vector2d high = side->frame.max() - edge.middle;
                EXPECT_NEAR(std::min(low.cwiseAbs().minCoeff(), high.cwiseAbs().minCoeff()), 0,
                            kSame);
            }
        }
        // Every two neighbours share one.
        std::size_t neighbours = 0;
        for (const PdfPage& a : plan.pages) {
            for (const PdfPage& b : plan.pages) {
                neighbours += (b.row == a.row && b.column == a.column + 1) ||
                              (b.column == a.column && b.row == a.row + 1);
            }
        }
        EXPECT_EQ(plan.shared.size(), neighbours);
    }
}

TEST(PlanPages, RollsAreAsShortAsThePatternTurnedForThemAllows) {
    // 500 x 1500 lies along the roll as it is, 1500 x 500 after a quarter turn.
    const PdfPlan upright = planned(rectangles({{0, 0, 500, 1500}}), Paper::Roll610);
    const PdfPlan lying = planned(rectangles({{0, 0, 1500, 500}}), Paper::Roll610);
    EXPECT_FALSE(upright.isTiled || lying.isTiled);
    EXPECT_FALSE(upright.turned);
    EXPECT_TRUE(lying.turned);
    EXPECT_EQ(upright.paper, lying.paper);
    EXPECT_EQ(upright.paper.x(), 610);
    EXPECT_LT(upright.paper.y(), 1500 + 2 * kPageMargin + 4);
    // Wider than the roll: strips side by side.
    const PdfPlan wide = planned(rectangles({{0, 0, 1000, 2000}}), Paper::Roll610);
    EXPECT_TRUE(wide.isTiled);
    EXPECT_EQ(wide.pages.size(), 2U);
}

TEST(PlanPages, RollsAreDividedWhereTheyWouldBeTooLong) {
    const PdfPlan fits = planned(rectangles({{0, 0, 500, 5000}}), Paper::Roll610);
    EXPECT_EQ(fits.pages.size(), 1U);
    const PdfPlan plan = planned(rectangles({{0, 0, 500, 12000}}), Paper::Roll610);
    EXPECT_EQ(plan.pages.size(), 3U);
    EXPECT_EQ(plan.columns, 1);
    EXPECT_LE(plan.paper.y(), kLongestPage);
}

TEST(PlanPages, SheetsLieWhereThatTakesFewer) {
    const PdfPlan lying = planned(rectangles({{0, 0, 1100, 700}}), Paper::A0);
    EXPECT_FALSE(lying.isTiled);
    EXPECT_EQ(lying.paper, Vector2d(1189, 841));
    EXPECT_EQ(planned(rectangles({{0, 0, 700, 1100}}), Paper::A0).paper, Vector2d(841, 1189));
    EXPECT_TRUE(planned(rectangles({{0, 0, 2000, 1100}}), Paper::A0).isTiled);
}

TEST(PlanPages, RefusesAProjectorsPageThatWouldBeTooLongAndSaysTheLengths) {
    const double most = kLongestPage - 2 * kPageMargin - 2;
    const PdfPlan plan = planned(rectangles({{0, 0, most, 300}}), Paper::Projector);
    EXPECT_EQ(plan.pages.size(), 1U);
    EXPECT_NEAR(plan.paper.x(), kLongestPage, kSame);
    const auto refused = planPages(rectangles({{0, 0, most + 1, 300}}), {Paper::Projector, 10});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::PageTooSmall);
    EXPECT_NE(refused.error().detail.find("5081 mm x 322 mm"), std::string::npos)
        << refused.error().detail;
    EXPECT_NE(refused.error().detail.find("5080 mm"), std::string::npos);
}

TEST(PlanPages, RefusesMorePagesThanAnybodyPrints) {
    for (const double size : {1e6, 1e9, 1e300}) {
        for (const Paper paper : {Paper::A4, Paper::A0, Paper::Roll914}) {
            const auto refused = planPages(rectangles({{0, 0, size, size}}), {paper, 10});
            ASSERT_FALSE(refused) << size;
            EXPECT_EQ(refused.error().code, ErrorCode::PageTooSmall);
        }
    }
    EXPECT_TRUE(planPages({}, {}));
}

TEST(PlanPages, NamesTilesByLettersAndNumbers) {
    EXPECT_EQ(tileName({1, 2}), "B3");
    EXPECT_EQ(tileName({25, 0}), "Z1");
    EXPECT_EQ(tileName({26, 9}), "AA10");
}

}  // namespace
}  // namespace toile
