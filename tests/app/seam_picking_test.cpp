// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <limits>
#include <numbers>

#include "app/render/picking.h"
#include "app/render/scene_builder.h"
#include "core/seam/find_seams.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Two sheets of 100 x 100 mm that share the line x = 100.
struct Sheets {
    std::shared_ptr<const Garment> garment;
    std::shared_ptr<const Scene> scene;
    int sewn = -1;

    Sheets() {
        auto made = std::make_shared<Garment>(
            *test::makeGarment({{"left", test::makeSheet(100, 100, 5, 5)},
                                {"right", test::makeSheet(100, 100, 5, 5, {100, 0, 0})}}));
        made->seams = findSeams(made->pieces);
        garment = made;
        Progress progress;
        scene = buildScene(*garment, flattenGarment(*garment, {}, progress), progress);
        for (std::size_t i = 0; i < garment->seams.seams.size(); ++i) {
            if (garment->seams.seams[i].kind == SeamKind::Seam) {
                sewn = static_cast<int>(i);
            }
        }
    }

    bool isSewn(int seam) const { return seam == sewn; }

    /// Straight down onto the sheets from 500 mm above.
    Ray above(double x, double y) const {
        return {Eigen::Vector3d(x, y, 500) - scene->origin, {0, 0, -1}};
    }

    /// The middle of the seam on one of its sides, on the sheet.
    Eigen::Vector2d middle(const SheetPlaces& places, std::size_t side) const {
        const SeamScene::Side& part = scene->seams[static_cast<std::size_t>(sewn)].sides[side];
        return placeOf(places, part.piece).placement.applied(part.flatBox.center());
    }
};

}  // namespace

class SeamPickingTest : public QObject {
    Q_OBJECT

private slots:
    void theSeamNearTheRayIsFound() {
        const Sheets sheets;
        QVERIFY(sheets.sewn >= 0);
        // A hundredth of the depth: 5 mm to either side.
        for (const double x : {100.0, 96.0, 104.0}) {
            const auto hit = pickGarmentSeam(*sheets.scene, sheets.above(x, 50), 0.01, kFar);
            QVERIFY(hit);
            QCOMPARE(hit->seam, sheets.sewn);
            QVERIFY(std::abs(hit->distance - std::abs(x - 100) / 500) < 1e-6);
        }
        QVERIFY(!pickGarmentSeam(*sheets.scene, sheets.above(90, 50), 0.01, kFar));
        QVERIFY(!pickGarmentSeam(*sheets.scene, sheets.above(100, 50), 0.01, 400));  // hidden
        Ray away = sheets.above(100, 50);
        away.direction = -away.direction;
        QVERIFY(!pickGarmentSeam(*sheets.scene, away, 0.01, kFar));
    }

    void onlySeamsThatCountAreFound() {
        const Sheets sheets;
        const Ray hem = sheets.above(50, 0);
        const auto any = pickGarmentSeam(*sheets.scene, hem, 0.01, kFar);
        QVERIFY(any);
        QVERIFY(any->seam != sheets.sewn);
        QVERIFY(!pickGarmentSeam(*sheets.scene, hem, 0.01, kFar,
                                 [&](int seam) { return sheets.isSewn(seam); }));
    }

    void bothSidesAreFoundWhereThePiecesLie() {
        const Sheets sheets;
        const SheetPlaces places = {{Placement{{500, 70}}},
                                    {Placement{{-300, 30}, std::numbers::pi / 3, true}}};
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
            const Eigen::Vector2d middle = sheets.middle(places, side);
            const auto hit = pickPatternSeam(*sheets.scene, places, middle, 3);
            QVERIFY(hit);
            QCOMPARE(hit->seam, sheets.sewn);
            QCOMPARE(hit->side, static_cast<int>(side));
            QVERIFY(hit->distance < 1e-3);
            QVERIFY(!pickPatternSeam(*sheets.scene, places, middle + Eigen::Vector2d(4000, 0), 3));
        }
    }
};

TOILE_WINDOW_TEST(SeamPickingTest)
#include "seam_picking_test.moc"
