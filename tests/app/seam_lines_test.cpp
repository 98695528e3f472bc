// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that both views draw, and what the garment view does on its way to the pattern.
#include <QTest>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "app/render/morph.h"
#include "app/render/picking.h"
#include "app/render/piece_values.h"
#include "app/render/render_style.h"
#include "app/render/scene_builder.h"
#include "app/settings/theme.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

struct Flattened {
    std::shared_ptr<const Garment> garment;
    PieceResults results;
    std::shared_ptr<const Scene> scene;
};

Flattened flattened(std::shared_ptr<const Garment> garment) {
    Progress progress;
    Flattened made{std::move(garment), {}, nullptr};
    made.results = flattenGarment(*made.garment, {}, progress);
    made.scene = buildScene(*made.garment, made.results, progress);
    return made;
}

SeamGraph seamsNamed(std::initializer_list<const char*> names) {
    SeamGraph graph;
    for (const char* name : names) {
        Seam& seam = graph.seams.emplace_back();
        seam.name = name;
        seam.kind =
            std::string(name).find("free") != std::string::npos ? SeamKind::Free : SeamKind::Seam;
    }
    return graph;
}

}  // namespace

class SeamLinesTest : public QObject {
    Q_OBJECT

private slots:
    void fewSeamsHaveColoursOfTheirOwn() {
        const auto colours =
            seamColours(seamsNamed({"a / b", "b / c", "c / d", "d / e", "a / c", "free 1"}));
        QCOMPARE(std::set<int>(colours.begin(), colours.end()).size(), std::size_t{6});
        QCOMPARE(colours.back(), -1);
    }

    void coloursRepeatEvenlyWhereThereAreManySeams() {
        SeamGraph graph;
        for (int i = 0; i < 3 * kSeamColours; ++i) {
            graph.seams.emplace_back().name = "seam " + std::to_string(i);
        }
        std::map<int, int> uses;
        for (const int colour : seamColours(graph)) {
            ++uses[colour];
        }
        QCOMPARE(uses.size(), std::size_t{kSeamColours});
        for (const auto& [colour, count] : uses) {
            QCOMPARE(count, 3);
        }
    }

    void noPieceHasOneColourTwice() {
        // Five pieces in a ring, each sewn to the next by two seams, and each to itself.
        SeamGraph graph;
        for (int piece = 0; piece < 5; ++piece) {
            for (int k = 0; k < 3; ++k) {
                Seam& seam = graph.seams.emplace_back();
                seam.name = "same name";
                seam.left.piece = piece;
                seam.right.piece = k < 2 ? (piece + 1) % 5 : piece;
            }
        }
        const auto colours = seamColours(graph);
        for (int piece = 0; piece < 5; ++piece) {
            std::set<int> seen;
            for (std::size_t s = 0; s < graph.seams.size(); ++s) {
                const Seam& seam = graph.seams[s];
                if (seam.left.piece == piece || seam.right.piece == piece) {
                    QVERIFY(seen.insert(colours[s]).second);
                }
            }
        }
    }

    void manySeamsOfOnePieceDifferAtLeastByTheirPartner() {
        SeamGraph graph;
        for (int i = 0; i < 3 * kSeamColours; ++i) {
            Seam& seam = graph.seams.emplace_back();
            seam.name = "seam " + std::to_string(i);
            seam.left.piece = 0;
            seam.right.piece = 1 + i % 3;
        }
        const auto colours = seamColours(graph);
        std::set<std::pair<int, int>> seen;
        for (std::size_t s = 0; s < graph.seams.size(); ++s) {
            QVERIFY(seen.insert({graph.seams[s].right.piece, colours[s]}).second);
        }
    }

    void coloursAreToldApartAndStandOutFromTheirGround() {
        const auto luminance = [](double r, double g, double b) -> double {
            const auto linear = [](double x) -> double {
                return x <= 10 ? x / 255 / 12.92 : std::pow((x / 255 + 0.055) / 1.055, 2.4);
            };
            return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        };
        for (const bool dark : {false, true}) {
            const RenderStyle style = renderStyle(dark ? darkPalette() : lightPalette());
            QCOMPARE(style.onDark, dark);
            const auto& palette = seamPalette(style.onDark);
            for (std::size_t i = 0; i < palette.size(); ++i) {
                const auto [r, g, b] = palette[i];
                for (const QColor& ground : {style.top, style.bottom}) {
                    const double there = luminance(ground.red(), ground.green(), ground.blue());
                    const double here = luminance(r, g, b);
                    const double contrast =
                        (std::max(here, there) + 0.05) / (std::min(here, there) + 0.05);
                    QVERIFY2(contrast > 2.2, qPrintable(QString("%1: %2").arg(i).arg(contrast)));
                }
                for (std::size_t k = 0; k < i; ++k) {
                    const Eigen::Vector3d difference(r - palette[k].r, g - palette[k].g,
                                                     b - palette[k].b);
                    QVERIFY2(difference.norm() > 60, qPrintable(QString("%1, %2").arg(i).arg(k)));
                }
            }
        }
    }

    void aSheetHasFourCornersAndACapNone() {
        const auto garment = test::makeGarment(
            {{"sheet", test::makeSheet(100, 60, 4, 3)}, {"strip", test::makeBentStrip(0)}});
        QCOMPARE(outlineCorners(*garment->pieces[0]).size(), std::size_t{4});
        // Bent, but only about one axis: its corners are as sharp as those of the sheet.
        QCOMPARE(outlineCorners(*garment->pieces[1]).size(), std::size_t{4});
    }

    void runsEndAtCorners() {
        const std::vector<int> corners = {2, 5, 9};
        QCOMPARE(runBetweenCorners(corners, 12, 3).first, 2);
        QCOMPARE(runBetweenCorners(corners, 12, 3).count, 3);
        QCOMPARE(runBetweenCorners(corners, 12, 5).first, 5);
        QCOMPARE(runBetweenCorners(corners, 12, 11).first, 9);
        QCOMPARE(runBetweenCorners(corners, 12, 11).count, 5);  // past the beginning
        QCOMPARE(runBetweenCorners(corners, 12, 0).first, 9);
        QCOMPARE(runBetweenCorners({}, 12, 7).count, 12);
    }

    void bothSidesOfASeamHaveOneTintInBothViews() {
        const auto made = flattened(test::makeSewnCap());
        const Scene& scene = *made.scene;
        bool sewn = false;
        for (std::size_t s = 0; s < scene.seams.size(); ++s) {
            std::set<float> tints;
            for (const VertexRun& run : scene.garmentLines.seams[s]) {
                for (std::uint32_t i = 0; i < run.count; ++i) {
                    tints.insert(scene.lineVertices[run.first + i].tint);
                }
            }
            for (const VertexRun& run : scene.patternLines.seams[s]) {
                for (std::uint32_t i = 0; i < run.count; ++i) {
                    tints.insert(scene.lineVertices[run.first + i].tint);
                }
            }
            QCOMPARE(tints.size(), std::size_t{1});
            const bool free = made.garment->seams.seams[s].kind == SeamKind::Free;
            QCOMPARE(*tints.begin() == kFreeEdgeTint, free);
            sewn = sewn || !free;
        }
        QVERIFY(sewn);
    }

    void aSeamIsFoundBesideItsLine() {
        const auto made = flattened(test::makeSewnCap());
        const Scene& scene = *made.scene;
        for (std::size_t s = 0; s < scene.seams.size(); ++s) {
            const VertexRun run = scene.patternLines.seams[s][0];
            const auto middle = static_cast<std::uint32_t>(run.first + run.count / 2);
            const auto at = [&](std::uint32_t i) -> Eigen::Vector2d {
                return Eigen::Map<const Eigen::Vector2f>(scene.lineVertices[i].flat).cast<double>();
            };
            const Eigen::Vector2d place = 0.5 * (at(middle - 1) + at(middle));
            const auto hit = pickPatternSeam(scene, {}, place, 0.5);
            QVERIFY(hit);
            QVERIFY(hit->distance < 0.01);
        }
        QVERIFY(
            !pickPatternSeam(scene, {}, sheetBox(scene, {}).min() - Eigen::Vector2d(20, 20), 6));
    }

    void aFlatPieceRestsWhereItIsWorn() {
        // A flat sheet somewhere in space rests exactly in itself.
        const auto made = flattened(
            test::makeGarment({{"sheet", test::makeSheet(100, 60, 4, 3, {500, 40, -30})}}));
        const PieceScene& piece = made.scene->pieces[0];
        const Points2& flat = made.results[0]->flat->Q;
        for (Eigen::Index i = 0; i < flat.rows(); ++i) {
            const Eigen::Vector3d worn =
                made.garment->pieces[0]->mesh.V.row(i).transpose() - made.scene->origin;
            const Eigen::Vector2d point = flat.row(i).transpose();
            QVERIFY((piece.rest.applied(point) - worn).norm() < 1e-3);
        }
        QVERIFY((piece.rest.turn.col(2) - Eigen::Vector3d::UnitZ()).norm() < 1e-6);
    }

    void theWayEndsOnTheStandingSheet() {
        const auto made = flattened(
            test::makeGarment({{"strip", test::makeBentStrip(-140)}, {"cap", test::makeCap(140)}}));
        const SheetPlaces places = {{Placement{{-100, 0}, 0.3}},
                                    {Placement{{150, 20}, -1.0, true}}};
        Morph morph;
        morph.way = 1;
        const auto motions = morphMotions(*made.scene, places, morph);
        const Eigen::Vector2d middle = sheetBox(*made.scene, places).center();
        for (int i = 0; i < 2; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Eigen::Vector2d point = made.scene->pieces[at].label;
            const Eigen::Vector2d onSheet = placeOf(places, i).placement.applied(point) - middle;
            const Eigen::Vector3d there = motions[at].applied(point);
            QVERIFY((there - Eigen::Vector3d(onSheet.x(), onSheet.y(), 0)).norm() < 1e-6);
            QVERIFY(std::abs(motions[at].turn.determinant() - 1) < 1e-9);
        }
    }

    void flatPiecesKeepTheirShapeOnTheWay() {
        const auto made = flattened(test::makeGarment({{"cap", test::makeCap(0)}}));
        for (const double way : {0.5, 0.6, 0.75, 0.9}) {
            Morph morph;
            morph.way = way;
            const auto motions = morphMotions(*made.scene, {{Placement{{0, 0}, 3.0}}}, morph);
            const Eigen::Matrix3d& turn = motions[0].turn;
            QVERIFY((turn.transpose() * turn - Eigen::Matrix3d::Identity()).norm() < 1e-9);
        }
    }
};

TOILE_WINDOW_TEST(SeamLinesTest)
#include "seam_lines_test.moc"
