// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/views/tools/measure_tool.h"
#include "core/cut/surface_point.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

/// A sheet of 200 x 100 mm, and its flat points, twice as large.
struct TestSheet {
    Piece piece = makePiece("sheet", test::makeSheet(200, 100, 20, 10));
    Points2 twice = 2 * piece.mesh.V.leftCols<2>();

    SurfacePoint at(double x, double y) const { return NearestSurface(piece.mesh).find({x, y, 0}); }
};

bool near(double a, double b) {
    return std::abs(a - b) < 1e-9;
}

}  // namespace

class MeasurementTest : public QObject {
    Q_OBJECT

private slots:
    void flatDistanceIsStraight() {
        const TestSheet sheet;
        QVERIFY(
            near(flatDistance(sheet.piece, sheet.twice, sheet.at(10, 10), sheet.at(40, 50)), 100));
    }

    void differenceIsThatOfTheFlatLength() {
        QVERIFY(!MeasuredLength{10}.difference());
        QVERIFY(near(*(MeasuredLength{10, 11}).difference(), 0.1));
        QVERIFY(!(MeasuredLength{0, 0}).difference());
    }

    void theOutlineIsMeasuredTheShorterWayRound() {
        const TestSheet sheet;
        const auto measure = [&](const SurfacePoint& a, const SurfacePoint& b) {
            return alongOutline(sheet.piece, &sheet.twice, a, b);
        };
        // Around the lower right corner, either way asked; in the middle of edges and at vertices.
        for (const auto& length : {measure(sheet.at(155, 0), sheet.at(200, 23)),
                                   measure(sheet.at(200, 23), sheet.at(155, 0))}) {
            QVERIFY(length);
            QVERIFY(near(length->onCloth, 68));
            QVERIFY(near(*length->flat, 136));
        }
        QVERIFY(near(measure(sheet.at(0, 0), sheet.at(200, 0))->onCloth, 200));
        QVERIFY(near(measure(sheet.at(0, 30), sheet.at(30, 0))->onCloth, 60));
        QVERIFY(near(measure(sheet.at(1, 0), sheet.at(8, 0))->onCloth, 7));  // on one edge
        QVERIFY(near(measure(sheet.at(50, 100), sheet.at(50, 100))->onCloth, 0));
    }

    void insideThereIsNoOutline() {
        const TestSheet sheet;
        QVERIFY(!alongOutline(sheet.piece, nullptr, sheet.at(50, 50), sheet.at(0, 0)));
        QVERIFY(!alongOutline(sheet.piece, nullptr, sheet.at(0, 0), sheet.at(50, 55)));
        QVERIFY(!alongOutline(sheet.piece, nullptr, sheet.at(0, 0), sheet.at(10, 0))->flat);
    }
};

TOILE_WINDOW_TEST(MeasurementTest)
#include "measurement_test.moc"
