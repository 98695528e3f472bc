// SPDX-License-Identifier: GPL-3.0-or-later
// What edits of notches and allowances leave in the settings, without any window.

#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/document/line_edits.h"
#include "core/symmetry/symmetry.h"
#include "core/toile/garment_flattener.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

/// Two parts of a cap, sewn to each other: a seam of more than 200 mm.
class NotchEditsTest : public QObject {
    Q_OBJECT

private:
    std::shared_ptr<const Garment> garment_ = test::makeSewnCap();
    PieceResults results_;

    std::vector<SeamNotch> notches(const LineSettings& lines) {
        return notchesOf(makePattern(*garment_, results_, lines));
    }

    static LineSettings notched() {
        LineSettings lines;
        lines.notches = NotchRules{};
        return lines;
    }

    static bool has(const std::vector<SeamNotch>& notches, double share) {
        return std::ranges::any_of(notches, [share](const SeamNotch& notch) {
            return notch.seam == 0 && std::abs(notch.share - share) < 1e-6;
        });
    }

private slots:
    void initTestCase() {
        Progress progress;
        FlattenOptions options;
        options.method = Method::Curvature;
        GarmentFlattener flattener;
        results_ = flattener.flatten(*garment_, options, progress);
        QVERIFY(!notches(notched()).empty());
    }

    void anAddedNotchIsWhereItWasPut() {
        const LineSettings lines = withNotch(LineSettings{}, *garment_, {0, 0.31});
        QCOMPARE(lines.notches->notches.size(), std::size_t(1));
        QVERIFY(lines.notches->automatic);
        const auto there = notches(lines);
        QVERIFY(has(there, 0.31));
        QCOMPARE(there.size(), notches(notched()).size() + 1);
    }

    void aNotchPlacedByHandIsForgotten() {
        const LineSettings lines = withNotch(notched(), *garment_, {0, 0.31});
        for (const SeamNotch& notch : notches(lines)) {
            if (notch.reason == NotchReason::ByHand) {
                QVERIFY(withoutNotch(lines, *garment_, notch, nullptr) == notched());
            }
        }
    }

    void aNotchThatComesByItselfIsKeptAway() {
        const auto before = notches(notched());
        const LineSettings lines = withoutNotch(notched(), *garment_, before.front(), nullptr);
        QCOMPARE(lines.notches->notches.size(), std::size_t(1));
        QVERIFY(!lines.notches->notches[0].isThere);
        QCOMPARE(notches(lines).size(), before.size() - 1);
        QVERIFY(!has(notches(lines), before.front().share));
    }

    void aMovedNotchIsElsewhereAndNothingElseChanges() {
        const auto before = notches(notched());
        const double away = before.front().share > 0.5 ? -0.02 : 0.02;  // less than a gap, too
        for (const double share : {before.front().share + away, before.front().share + 8 * away}) {
            LineSettings lines =
                withNotchMoved(notched(), *garment_, before.front(), share, nullptr);
            QCOMPARE(notches(lines).size(), before.size());
            QVERIFY(has(notches(lines), share));
            // Moved on, it leaves no trace of where it was between.
            const auto now = notches(lines);
            const auto there = std::ranges::find_if(
                now, [](const SeamNotch& one) { return one.reason == NotchReason::ByHand; });
            QVERIFY(there != now.end());
            lines = withNotchMoved(lines, *garment_, *there, share + away / 2, nullptr);
            QCOMPARE(lines.notches->notches.size(), std::size_t(2));
            QVERIFY(has(notches(lines), share + away / 2) && !has(notches(lines), share));
        }
    }

    void anAllowanceIsSaidOfBothSidesAndTakenBack() {
        const LineFacts facts = lineFacts(*garment_, results_, {});
        const SegmentAt one = *segmentOfSeam(facts, garment_->seams.seams[0]);
        const auto both = alikeSegments(*garment_, facts, one, true, nullptr);
        QCOMPARE(both.size(), std::size_t(2));
        QVERIFY(both[1] == *partnerOf(*garment_, facts, one));
        QCOMPARE(alikeSegments(*garment_, facts, one, false, nullptr).size(), std::size_t(1));
        const LineSettings lines = withAllowance({}, facts, both, 22.0);
        QVERIFY(lines.allowance == AllowanceWidths{});
        QCOMPARE(lines.segments.size(), std::size_t(2));
        const Pattern pattern = makePattern(*garment_, results_, lines);
        for (const PatternPiece& piece : pattern.pieces) {
            for (const PatternSegment& segment : piece.segments) {
                QCOMPARE(segment.seam == 1 ? segment.allowance : segment.usualAllowance,
                         segment.seam == 1 ? 22.0 : AllowanceWidths{}.hem);
            }
        }
        const LineFacts later = lineFacts(*garment_, results_, lines);
        QCOMPARE(allowanceOf(*garment_, later.at(one), lines), 22.0);
        LineSettings back = withAllowance(lines, later, both, std::nullopt);
        QVERIFY(back.segments.empty());
        QCOMPARE(allowanceOf(*garment_, facts.at(one), back), AllowanceWidths{}.seam);
    }

    void aCornerIsSaidOfTheSegmentThatBeginsThere() {
        const LineFacts facts = lineFacts(*garment_, results_, {});
        const SegmentAt one = *segmentOfSeam(facts, garment_->seams.seams[0]);
        const LineSettings lines =
            withCorner({}, facts, one, std::nullopt, CornerRule::MirrorFirst);
        QCOMPARE(lines.segments.size(), std::size_t(1));
        QVERIFY(lines.segments[0].place == facts.at(one).place);
        QVERIFY(lines.segments[0].corner == CornerRule::MirrorFirst && lines.allowance);
        const LineFacts later = lineFacts(*garment_, results_, lines);
        QVERIFY(withCorner(lines, later, one, std::nullopt, std::nullopt).segments.empty());
    }
};

TOILE_WINDOW_TEST(NotchEditsTest)
#include "notch_edits_test.moc"
