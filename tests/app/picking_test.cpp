// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/picking.h"

#include <QTest>

#include "app/render/scene_builder.h"
#include "tests/app/support/garments.h"

using namespace toile;

namespace {

std::shared_ptr<const Scene> twoLayers() {
    // The second sheet lies 50 mm behind the first and stands out to the right.
    const auto garment = test::makeGarment({{"near", test::makeSheet(100, 100, 5, 5)},
                                            {"far", test::makeSheet(200, 100, 5, 5, {0, 0, -50})}});
    Progress progress;
    const PieceResults results = flattenGarment(*garment, {}, progress);
    return buildScene(*garment, results, layOut(*garment, results).offsets, progress);
}

}  // namespace

class PickingTest : public QObject {
    Q_OBJECT

private slots:
    void nearestPieceIsHit() {
        const auto scene = twoLayers();
        const Eigen::Vector3d eye(50, 50, 500);
        const auto hit = pickGarment(*scene, {eye - scene->origin, {0, 0, -1}});
        QVERIFY(hit);
        QCOMPARE(hit->piece, 0);
        QVERIFY(std::abs(hit->distance - 500) < 1e-3);
    }

    void clothIsHitFromBehindToo() {
        const auto scene = twoLayers();
        const Eigen::Vector3d eye(50, 50, -500);
        const auto hit = pickGarment(*scene, {eye - scene->origin, {0, 0, 1}});
        QVERIFY(hit);
        QCOMPARE(hit->piece, 1);
    }

    void pastTheEdgeTheOtherPieceOrNothing() {
        const auto scene = twoLayers();
        const Eigen::Vector3d right(150, 50, 500), outside(250, 50, 500);
        QCOMPARE(pickGarment(*scene, {right - scene->origin, {0, 0, -1}})->piece, 1);
        QVERIFY(!pickGarment(*scene, {outside - scene->origin, {0, 0, -1}}));
        QVERIFY(!pickGarment(*scene, {right - scene->origin, {0, 0, 1}}));  // behind the eye
    }

    void flatPiecesAreFoundWhereTheyLie() {
        const auto scene = twoLayers();
        for (int i = 0; i < 2; ++i) {
            const PieceScene& piece = scene->pieces[static_cast<std::size_t>(i)];
            const auto hit = pickPattern(*scene, piece.label + piece.offset);
            QVERIFY(hit);
            QCOMPARE(*hit, i);
        }
        QVERIFY(!pickPattern(*scene, scene->sheetBox.min() - Eigen::Vector2d(1, 1)));
    }
};

QTEST_MAIN(PickingTest)
#include "picking_test.moc"
