// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/picking.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Dense>

#include "app/render/scene_builder.h"
#include "core/geometry/triangle_tree.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

/// Side by side on the sheet, the second turned by a quarter and mirrored.
const SheetPlaces kPlaces = {{Placement{{5, 7}}},
                             {Placement{{400, 30}, std::numbers::pi / 2, true}}};

std::shared_ptr<const Scene> twoLayers() {
    // The second sheet lies 50 mm behind the first and stands out to the right.
    const auto garment = test::makeGarment({{"near", test::makeSheet(100, 100, 5, 5)},
                                            {"far", test::makeSheet(200, 100, 5, 5, {0, 0, -50})}});
    Progress progress;
    const PieceResults results = flattenGarment(*garment, {}, progress);
    return buildScene(*garment, results, progress);
}

/// Waves, so that rays meet several layers.
MeshArrays wavySheet(int columns, int rows) {
    MeshArrays mesh = test::makeSheet(columns, rows, columns, rows);
    for (Eigen::Index i = 0; i < mesh.V.rows(); ++i) {
        mesh.V(i, 2) = 30 * std::sin(mesh.V(i, 0) / 7) * std::cos(mesh.V(i, 1) / 11);
    }
    return mesh;
}

/// The garment's distance along a ray by looking at every triangle, infinite where it is missed.
/// By another formula than the program's.
double distanceOneByOne(const Scene& scene, const Ray& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto point = [&scene](std::uint32_t index) -> Eigen::Vector3d {
        return Eigen::Map<const Eigen::Vector3f>(scene.vertices[index].position).cast<double>();
    };
    const auto& triangles = scene.garment.triangles;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const Eigen::Vector3d a = point(triangles[t]);
        const Eigen::Vector3d ab = point(triangles[t + 1]) - a, ac = point(triangles[t + 2]) - a;
        Eigen::Matrix3d system;
        system << ab, ac, -ray.direction;
        if (std::abs(system.determinant()) < 1e-12) {
            continue;
        }
        const Eigen::Vector3d solved = system.inverse() * (ray.origin - a);
        if (solved[0] >= 0 && solved[1] >= 0 && solved[0] + solved[1] <= 1 && solved[2] > 0) {
            nearest = std::min(nearest, solved[2]);
        }
    }
    return nearest;
}

std::shared_ptr<const Scene> flatScene(const MeshArrays& mesh) {
    const auto garment = test::makeGarment({{"sheet", mesh}});
    auto result = std::make_shared<PieceResult>();
    result->piece = garment->pieces[0];
    result->flat.emplace();
    result->flat->Q = mesh.V.leftCols<2>();
    Progress progress;
    return buildScene(*garment, {result}, progress);
}

std::vector<Ray> randomRays(int count, double reach) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> across(-reach, reach);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d from(across(random), across(random), 400 + across(random));
        const Eigen::Vector3d to(across(random), across(random), 0);
        rays.push_back({from, (to - from).normalized()});
    }
    return rays;
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

    void onePieceIsPickedWhereverOthersLie() {
        const auto scene = twoLayers();
        for (const int index : {0, 1}) {
            const PieceScene& piece = scene->pieces[static_cast<std::size_t>(index)];
            const auto hit = pickPiece(*scene, index, piece.label);
            QVERIFY(hit);
            QCOMPARE(hit->piece, index);
            const Eigen::Vector2d at = patternPoint(*scene, index, hit->face, hit->barycentric);
            QVERIFY((at - piece.label).norm() < 1e-3);
            QVERIFY(!pickPiece(*scene, index, piece.flatBox.min() - Eigen::Vector2d(1, 1)));
        }
    }

    void flatPiecesAreFoundWhereTheyLie() {
        const auto scene = twoLayers();
        for (int i = 0; i < 2; ++i) {
            const PieceScene& piece = scene->pieces[static_cast<std::size_t>(i)];
            const auto hit =
                pickPattern(*scene, kPlaces, placeOf(kPlaces, i).placement.applied(piece.label));
            QVERIFY(hit);
            QCOMPARE(hit->piece, i);
            QVERIFY(std::abs(hit->barycentric.sum() - 1) < 1e-12);
        }
        const Eigen::AlignedBox2d box = sheetBox(*scene, kPlaces);
        QVERIFY(!pickPattern(*scene, kPlaces, box.min() - Eigen::Vector2d(1, 1)));
        QVERIFY(!pickPattern(*scene, kPlaces, box.max() + Eigen::Vector2d(1, 1)));
    }

    void theTreeFindsWhatASearchOneByOneFinds() {
        const auto scene = flatScene(wavySheet(60, 45));
        int hits = 0;
        for (const Ray& ray : randomRays(400, 45)) {
            const auto hit = pickGarment(*scene, ray);
            const double expected = distanceOneByOne(*scene, ray);
            QCOMPARE(hit.has_value(), std::isfinite(expected));
            if (hit) {
                ++hits;
                QVERIFY(std::abs(hit->distance - expected) < 1e-6);
                const Eigen::Vector3d place =
                    garmentPoint(*scene, hit->piece, hit->face, hit->barycentric);
                QVERIFY((place - ray.origin - hit->distance * ray.direction).norm() < 1e-6);
            }
        }
        QVERIFY(hits > 100 && hits < 400);
    }

    void everyPlaceOfTheFlatPieceIsFound() {
        const auto scene = flatScene(wavySheet(30, 20));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> x(-5, 35), y(-5, 25);
        for (int i = 0; i < 500; ++i) {
            const Eigen::Vector2d place(x(random), y(random));
            const bool within =
                place.x() >= 0 && place.x() <= 30 && place.y() >= 0 && place.y() <= 20;
            const auto hit = pickPattern(*scene, {}, place);
            QCOMPARE(hit.has_value(), within);
            if (hit) {
                const auto found = patternPoint(*scene, 0, hit->face, hit->barycentric);
                QVERIFY((found - place).norm() < 1e-4);
            }
        }
    }

    void aPickLooksAtFewOfManyTriangles() {
        const auto scene = flatScene(wavySheet(250, 250));
        QCOMPARE(scene->pieces.size(), std::size_t{1});
        const PieceScene& piece = scene->pieces[0];
        const auto expectFew = [](const auto& tree, const Eigen::Vector2f& at) {
            int boxes = 0, faces = 0;
            tree.search(
                [&](const auto& box) {
                    ++boxes;
                    const bool covers = box.low[0] <= at.x() && at.x() <= box.high[0] &&
                                        box.low[1] <= at.y() && at.y() <= box.high[1];
                    return covers ? 0.0 : geometry::TriangleTree<2>::kMissed;
                },
                [&faces](std::uint32_t) { ++faces; });
            QVERIFY2(faces > 0 && faces <= 1000, qPrintable(QString::number(faces)));
            QVERIFY2(boxes <= 1000, qPrintable(QString::number(boxes)));  // of some 30 000
        };
        for (int i = 1; i < 100; ++i) {
            const Eigen::Vector2d at(2.4 * i, 250 - 2.3 * i);
            expectFew(piece.patternTree, at.cast<float>());
            // Straight down.
            expectFew(piece.garmentTree, (at - scene->origin.head<2>()).cast<float>());
        }
    }
};

TOILE_WINDOW_TEST(PickingTest)
#include "picking_test.moc"
