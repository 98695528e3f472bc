// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene_builder.h"

#include <QTest>
#include <cmath>
#include <numbers>

#include "app/render/colour_map.h"
#include "app/render/piece_values.h"
#include "app/render/scene.h"
#include "app/render/shader_program.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

/// A result as the solver would give it, with points of the test's choice.
std::shared_ptr<const PieceResult> flatResult(std::shared_ptr<const Piece> piece, Points2 Q) {
    auto result = std::make_shared<PieceResult>();
    result->quality = measure(*piece, Q);
    result->flat = FlatPiece{};
    result->flat->Q = std::move(Q);
    result->piece = std::move(piece);
    return result;
}

Points2 plane(const Piece& piece, double scaleX, double scaleY) {
    Points2 Q = piece.mesh.V.leftCols<2>();
    Q.col(0) *= scaleX;
    Q.col(1) *= scaleY;
    return Q;
}

struct Built {
    std::shared_ptr<const Garment> garment;
    std::shared_ptr<const Scene> scene;
};

/// Two sheets, the first stretched by `scale` in x when flattened, and a closed piece between them.
Built build(double scale) {
    Built built;
    built.garment = test::makeGarment({{"front", test::makeSheet(100, 60, 10, 6)},
                                       {"blob", test::makeTetrahedron(40)},
                                       {"back", test::makeSheet(80, 40, 4, 2)}});
    const auto& pieces = built.garment->pieces;
    auto failed = std::make_shared<PieceResult>();
    failed->piece = pieces[1];
    failed->error = pieces[1]->defect;
    const PieceResults results = {flatResult(pieces[0], plane(*pieces[0], scale, 1)), failed,
                                  flatResult(pieces[2], plane(*pieces[2], 1, 1))};
    Progress progress;
    built.scene = buildScene(*built.garment, results, progress);
    return built;
}

}  // namespace

class SceneBuilderTest : public QObject {
    Q_OBJECT

private slots:
    void buffersHoldEveryPieceOnce() {
        const auto [garment, scene] = build(1);
        QCOMPARE(scene->vertices.size(), std::size_t(77 + 4 + 15));
        QCOMPARE(scene->garment.triangles.size(), std::size_t(3 * (120 + 4 + 16)));
        QCOMPARE(scene->pattern.triangles.size(), std::size_t(3 * (120 + 16)));
        QCOMPARE(scene->pattern.outline.size(), std::size_t(2 * (32 + 12)));
        for (const std::uint32_t index : scene->pattern.triangles) {
            QVERIFY(index < scene->vertices.size());
            QVERIFY(scene->vertices[index].piece != 1.0F);  // which is not flat
        }
        for (const std::uint32_t index : scene->garment.edges) {
            QVERIFY(index < scene->vertices.size());
        }
        QCOMPARE(scene->pieces[2].patternRun.first, 120U);
        QCOMPARE(scene->pieces[2].patternRun.count, 16U);
        QCOMPARE(scene->pieces[2].garmentRun.first, 124U);
    }

    void checkerboardCoordinatesAreMillimetresOfTheFlatPiece() {
        const auto [garment, scene] = build(1.25);
        // Last vertex of the first piece: upper right corner, stretched by 1.25 in the plane.
        const ClothVertex& corner = scene->vertices[76];
        QCOMPARE(corner.flat[0], 125.0F);
        QCOMPARE(corner.flat[1], 60.0F);
        QCOMPARE(corner.piece, 0.0F);
        QCOMPARE(scene->vertices[77 + 4].piece, 2.0F);
    }

    void failedPiecesAreInTheGarmentButNotInThePattern() {
        const auto [garment, scene] = build(1);
        QVERIFY(!scene->pieces[1].flat);
        QCOMPARE(scene->pieces[1].garmentRun.count, 4U);
        QCOMPARE(scene->pieces[1].patternRun.count, 0U);
        QVERIFY(!scene->pieces[1].box.isEmpty());
    }

    void valuesArePercentAndDegrees() {
        const auto [garment, scene] = build(1.25);
        const ClothVertex& inner = scene->vertices[27];
        QVERIFY(std::abs(inner.values[0] + 20.0F) < 1e-3F);  // a fifth of the flat area is surplus
        QVERIFY(inner.values[1] > 3.0F && inner.values[1] < 10.0F);
        // Edges across keep their lengths, those along are too long on the flat cloth: surplus.
        QVERIFY(std::abs(inner.values[2]) < 1e-3F);
        QVERIFY(std::abs(inner.values[3] + 20.0F) < 1e-3F);
        // The other piece is as it was.
        for (const float value : scene->vertices[80 + 4].values) {
            QVERIFY(std::abs(value) < 1e-4F);
        }
    }

    void scalesCoverTheValues() {
        const auto [garment, scene] = build(1.25);
        QCOMPARE(scene->scale(Overlay::Area).high, 20.0);
        QCOMPARE(scene->scale(Overlay::Area).low, -20.0);
        QCOMPARE(scene->scale(Overlay::Angle).low, 0.0);
    }

    void farFromTheOriginNothingIsLost() {
        const auto garment =
            test::makeGarment({{"front", test::makeSheet(100, 60, 10, 6, {4e7, -3e7, 1e7})}});
        Progress progress;
        const auto scene = buildScene(*garment, {}, progress);
        const auto& vertices = scene->vertices;
        QVERIFY(std::abs(vertices[1].position[0] - vertices[0].position[0] - 10.0F) < 1e-4F);
        QVERIFY(std::abs(scene->box.max().x() - 50) < 1e-4);
        QCOMPARE(scene->origin.y(), -3e7 + 30);
    }

    void normalsPointToTheRightSide() {
        const auto [garment, scene] = build(1);
        for (std::size_t i = 0; i < 77; ++i) {
            QCOMPARE(scene->vertices[i].normal[2], 1.0F);
        }
    }

    void beforeFlatteningThereIsTheGarmentAlone() {
        const auto garment = test::makeGarment({{"front", test::makeSheet(100, 60, 10, 6)}});
        Progress progress;
        const auto scene = buildScene(*garment, {}, progress);
        QCOMPARE(scene->vertices.size(), std::size_t(77));
        QVERIFY(scene->pattern.triangles.empty());
        QVERIFY(sheetBox(*scene, {}).isEmpty());
        QVERIFY(!scene->pieces[0].flat);
    }

    void pieceTableCarriesColourPlaceAndSelection() {
        const auto [garment, scene] = build(1);
        const double half = std::numbers::pi;
        const SheetPlaces places = {
            {Placement{{5, 7}, half, true}, 0.0, 3}, {}, {Placement{{200, 7}}}};
        const std::vector<float> table = makePieceTable(*scene, {2}, places);
        const auto texel = [&](int piece, int which) {
            return &table[std::size_t(4 * (kTexelsPerPiece * piece + which))];
        };
        const Rgb front = pieceColour(3), neutral = neutralColour();
        QCOMPARE(texel(0, 0)[0], static_cast<float>(front.r) / 255.0F);
        QCOMPARE(texel(0, 0)[3], float(kPieceFlat));
        // Mirrored, then turned by half a turn: x stays, y becomes -y.
        QCOMPARE(texel(0, 1)[0], 1.0F);
        QCOMPARE(texel(0, 1)[3], -1.0F);
        QCOMPARE(texel(0, 2)[0], 5.0F);
        QCOMPARE(texel(0, 2)[1], 7.0F);
        QCOMPARE(texel(0, 2)[2], 1.0F);
        QCOMPARE(texel(0, 2)[3], 0.0F);
        QCOMPARE(texel(1, 0)[0], static_cast<float>(neutral.r) / 255.0F);
        QCOMPARE(texel(1, 0)[3], 0.0F);
        QCOMPARE(texel(2, 0)[3], float(kPieceFlat | kPieceSelected));
        QCOMPARE(texel(2, 1)[0], 1.0F);
        QCOMPARE(texel(2, 2)[0], 200.0F);
        QCOMPARE(table.size(), std::size_t(4 * kTexelsPerPiece) * scene->pieces.size());
    }

    void sheetBoxIsWherePiecesLie() {
        const auto [garment, scene] = build(1);
        const SheetPlaces places = {{Placement{{5, 7}}}, {}, {Placement{{200, 7}}}};
        const Eigen::AlignedBox2d box = sheetBox(*scene, places);
        QCOMPARE(box.min().x(), 5.0);
        QCOMPARE(box.max().x(), 280.0);
        QCOMPARE(box.min().y(), 7.0);
        QCOMPARE(box.max().y(), 67.0);
    }

    void rimsOfHolesAreOutlinesInBothViews() {
        // A sheet of 6 by 6 squares without the four in its middle.
        MeshArrays mesh = test::makeSheet(60, 60, 6, 6);
        Triangles kept(mesh.F.rows() - 8, 3);
        Eigen::Index count = 0;
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            const auto square = f / 2;
            const auto row = square / 6, column = square % 6;
            if (row < 2 || row > 3 || column < 2 || column > 3) {
                kept.row(count++) = mesh.F.row(f);
            }
        }
        // The vertex in the middle belongs to nothing now: the last takes its place.
        const int last = static_cast<int>(mesh.V.rows()) - 1, middle = 24;
        mesh.V.row(middle) = mesh.V.row(last);
        mesh.V.conservativeResize(last, 3);
        mesh.F = (kept.array() == last).select(middle, kept);
        const auto garment = test::makeGarment({{"ring", mesh}});
        QCOMPARE(garment->pieces[0]->holes.size(), std::size_t(1));
        Progress progress;
        const PieceResults results = {
            flatResult(garment->pieces[0], plane(*garment->pieces[0], 1, 1))};
        const auto scene = buildScene(*garment, results, progress);
        QCOMPARE(scene->garment.outline.size(), std::size_t(2 * (24 + 8)));
        QCOMPARE(scene->pattern.outline.size(), std::size_t(2 * (24 + 8)));
        QCOMPARE(progress.fraction(), 1.0);
    }

    void labelOfACrescentLiesInside() {
        // A frame open on one side, whose centroid is in the hole.
        MeshArrays frame;
        frame.V.setZero(8, 3);
        frame.V.leftCols<2>() << 0, 0, 100, 0, 100, 30, 20, 30, 20, 70, 100, 70, 100, 100, 0, 100;
        frame.F.resize(6, 3);
        frame.F << 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 7, 4, 5, 6, 4, 6, 7;
        const auto garment = test::makeGarment({{"frame", frame}});
        Progress progress;
        const auto scene =
            buildScene(*garment, {flatResult(garment->pieces[0], frame.V.leftCols<2>())}, progress);
        const Eigen::Vector2d at = scene->pieces[0].label;
        const bool inHole = at.x() > 20 && at.y() > 30 && at.y() < 70;
        QVERIFY(!inHole);
        QVERIFY(at.x() > 0 && at.x() < 100 && at.y() > 0 && at.y() < 100);
    }

    void cancelledBuildingEndsEarly() {
        const auto garment = test::makeGarment({{"front", test::makeSheet(100, 60, 10, 6)}});
        Progress progress;
        progress.cancel();
        QVERIFY(buildScene(*garment, {}, progress)->pieces.empty());
    }
};

TOILE_WINDOW_TEST(SceneBuilderTest)
#include "scene_builder_test.moc"
