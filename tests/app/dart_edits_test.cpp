// SPDX-License-Identifier: GPL-3.0-or-later
// What edits of darts leave in the settings, without any window.
#include <QTest>

#include "app/document/line_edits.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

/// Two darts that mirror each other, and one that mirrors itself.
class DartEditsTest : public QObject {
    Q_OBJECT

private:
    Garment garment_;
    Symmetry symmetry_;

    void add(std::uint64_t line, SeamKind kind) {
        Seam& seam = garment_.seams.seams.emplace_back();
        seam.kind = kind;
        seam.place = {{LineId{line}, 0, 1}, {LineId{line + 1}, 1, 0}};
    }
    DartSettings said(const LineSettings& lines, int dart) {
        return dartSettings(garment_, lines, dart);
    }

private slots:
    void initTestCase() {
        add(1, SeamKind::Dart);
        add(3, SeamKind::Dart);
        add(5, SeamKind::Dart);
        symmetry_.lengths.mirrored = {1, 0, 2};
    }

    void anIntakeIsSaidOfBothAndTakenBackFromBoth() {
        LineSettings lines = withIntake({}, garment_, 0, 12.5, &symmetry_);
        QCOMPARE(lines.darts.size(), std::size_t(2));
        QVERIFY(said(lines, 0).intake == 12.5 && said(lines, 1).intake == 12.5);
        lines = withIntake(lines, garment_, 1, 20, &symmetry_);
        QCOMPARE(lines.darts.size(), std::size_t(2));
        QVERIFY(said(lines, 0).intake == 20.0);
        QVERIFY(withIntake(lines, garment_, 0, std::nullopt, &symmetry_) == LineSettings{});
    }

    void oneAloneIsSaidOnce() {
        for (const bool isMirrored : {false, true}) {
            const Symmetry* symmetry = isMirrored ? &symmetry_ : nullptr;
            const LineSettings lines = withIntake({}, garment_, 2, 8, symmetry);
            QCOMPARE(lines.darts.size(), std::size_t(1));
            QVERIFY(!said(lines, 0).intake);
        }
        QCOMPARE(withIntake({}, garment_, 0, 8, nullptr).darts.size(), std::size_t(1));
    }

    void theImageIsLaidOverTheOtherLeg() {
        LineSettings lines = withLay({}, garment_, 0, DartLay::First, &symmetry_);
        QVERIFY(said(lines, 0).lay == DartLay::First && said(lines, 1).lay == DartLay::Second);
        lines = withIntake(lines, garment_, 0, 9, &symmetry_);
        lines = withLay(lines, garment_, 1, std::nullopt, &symmetry_);
        QVERIFY(said(lines, 0).intake == 9.0 && !said(lines, 0).lay);
        QCOMPARE(lines.darts.size(), std::size_t(2));
    }

    void whatIsNoDartNowKeepsWhatWasSaid() {
        const LineSettings lines = withIntake({}, garment_, 2, 8, nullptr);
        garment_.seams.seams[2].kind = SeamKind::Seam;
        QVERIFY(!said(lines, 2).intake);
        QCOMPARE(withIntake(lines, garment_, 0, 5, nullptr).darts.size(), std::size_t(2));
        garment_.seams.seams[2].kind = SeamKind::Dart;
        QVERIFY(said(lines, 2).intake == 8.0);
    }
};

TOILE_WINDOW_TEST(DartEditsTest)
#include "dart_edits_test.moc"
