// SPDX-License-Identifier: GPL-3.0-or-later
// What the overlays say of garments with known strain: values, scales, histogram, worst spots,
// crosses.
#include "app/render/overlay_values.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <numbers>

#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/render/overlay_figures.h"
#include "app/render/scene_builder.h"
#include "app/render/shader_program.h"
#include "app/views/colour_legend.h"
#include "app/views/overlay_watcher.h"
#include "core/garment/fabric.h"
#include "core/quality/piece_quality.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr double kUp = std::numbers::pi / 2;

/// Large enough to be worked out on another thread.
void openLargeSheet(Document& document) {
    auto garment = test::makeGarment({{"front", test::makeSheet(200, 100, 200, 100)}});
    auto result = std::make_shared<PieceResult>();
    result->piece = garment->pieces[0];
    result->flat = FlatPiece{};
    result->flat->Q = garment->pieces[0]->mesh.V.leftCols<2>();
    Derived derived;
    derived.garment = garment;
    derived.results = {result};
    Progress progress;
    draw(derived, progress);
    document.open({}, std::move(derived));
}

struct BuiltScene {
    std::shared_ptr<const Garment> garment;
    std::shared_ptr<const Scene> scene;
};

/// One result per piece as the solver would give it, with points of the test's choice.
BuiltScene builtScene(std::vector<std::pair<std::string, MeshArrays>> pieces,
                      const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& flatten) {
    BuiltScene built;
    built.garment = test::makeGarment(std::move(pieces));
    PieceResults results;
    for (const auto& piece : built.garment->pieces) {
        auto result = std::make_shared<PieceResult>();
        result->flat = FlatPiece{};
        Points2 Q(piece->mesh.V.rows(), 2);
        for (Eigen::Index v = 0; v < Q.rows(); ++v) {
            const Eigen::Vector2d worn = piece->mesh.V.row(v).head<2>().transpose();
            Q.row(v) = flatten(worn).transpose();
        }
        result->flat->Q = Q;
        result->quality = measure(*piece, Q);
        result->piece = piece;
        results.push_back(result);
    }
    Progress progress;
    built.scene = buildScene(*built.garment, results, progress);
    return built;
}

/// A sheet of 100 x 60 mm as worn, whose cloth is stretched by 5 % sideways.
BuiltScene stretchedSheet() {
    return builtScene({{"front", test::makeSheet(100, 60, 10, 6)}},
                      [](const Eigen::Vector2d& worn) -> Eigen::Vector2d {
                          return {worn.x() / 1.05, worn.y()};
                      });
}

SheetPlaces grainAt(double radians) {
    return {SheetPlace{Placement{}, radians}};
}

double valueOf(const BuiltScene& built, Overlay overlay, double grain, bool perTriangle = false) {
    const OverlayScale scale = overlayScale(*built.scene, overlay, *fabricPreset("woven"));
    return valueAt(*built.scene, grainAt(grain), {0, 17, {0.2, 0.5, 0.3}}, overlay, scale,
                   perTriangle)
        .value_or(-999);
}

bool isNear(double value, double expected, double tolerance = 1e-3) {
    return std::abs(value - expected) <= tolerance;
}

}  // namespace

class OverlayValuesTest : public QObject {
    Q_OBJECT

private slots:
    void aStretchedSheetIsStretchedWhereItIs() {
        const BuiltScene sheet = stretchedSheet();
        const double bias = 100 * (std::sqrt((1.05 * 1.05 + 1) / 2) - 1);
        for (const bool perTriangle : {false, true}) {
            QVERIFY(isNear(valueOf(sheet, Overlay::Warp, kUp, perTriangle), 0));
            QVERIFY(isNear(valueOf(sheet, Overlay::Weft, kUp, perTriangle), 5));
            QVERIFY(isNear(valueOf(sheet, Overlay::Bias, kUp, perTriangle), bias));
            QVERIFY(isNear(valueOf(sheet, Overlay::Principal, kUp, perTriangle), 5));
            QVERIFY(isNear(valueOf(sheet, Overlay::Area, kUp, perTriangle), 5));
            QVERIFY(isNear(valueOf(sheet, Overlay::Dirichlet, kUp, perTriangle),
                           100 * ((1.1025 + 1 / 1.1025 + 2) / 4 - 1), 2e-3));
        }
        QVERIFY(isNear(valueOf(sheet, Overlay::Strain, kUp, true), 5));
    }

    void clothThatIsFlippedIsSeenEverywhere() {
        // All edges keep their lengths.
        const BuiltScene sheet = builtScene({{"front", test::makeSheet(100, 60, 10, 6)}},
                                            [](const Eigen::Vector2d& worn) -> Eigen::Vector2d {
                                                return {-worn.x(), worn.y()};
                                            });
        for (const bool perTriangle : {false, true}) {
            QVERIFY(valueOf(sheet, Overlay::Area, kUp, perTriangle) < -100);
            for (const Overlay overlay : {Overlay::Warp, Overlay::Weft, Overlay::Bias,
                                          Overlay::Principal, Overlay::Dirichlet}) {
                QVERIFY(valueOf(sheet, overlay, kUp, perTriangle) > 1000);
            }
        }
        QVERIFY(isNear(valueOf(sheet, Overlay::Strain, kUp), 0));
    }

    void stretchOneWayAndSurplusTheOtherDoNotCancel() {
        const BuiltScene sheet = builtScene({{"front", test::makeSheet(100, 60, 10, 6)}},
                                            [](const Eigen::Vector2d& worn) -> Eigen::Vector2d {
                                                return {worn.x() / 1.05, worn.y() / 0.95};
                                            });
        for (const bool perTriangle : {false, true}) {
            // Of both the one nearer to its limit, -1 and +2 %.
            QVERIFY(isNear(valueOf(sheet, Overlay::Strain, kUp, perTriangle), -5));
        }
    }

    void whileATriangleIsBeyondNothingSaysThatAllIsWithin() {
        // One point of many moved by a tenth of a square: a handful of triangles.
        const BuiltScene sheet = builtScene({{"front", test::makeSheet(1000, 1000, 100, 100)}},
                                            [](const Eigen::Vector2d& worn) -> Eigen::Vector2d {
                                                const bool moved =
                                                    (worn - Eigen::Vector2d(500, 500)).norm() < 1;
                                                return moved ? Eigen::Vector2d(501, 501) : worn;
                                            });
        const SheetPlaces places = grainAt(kUp);
        for (const Overlay overlay :
             {Overlay::Strain, Overlay::Warp, Overlay::Weft, Overlay::Bias, Overlay::Principal}) {
            const OverlayFigures figures =
                overlayFigures({sheet.scene, places, *fabricPreset("woven"), overlay});
            QVERIFY(figures.histogram->beyond() > 0);
            QVERIFY(!figures.spots.empty());
            // The flag says the number that the histogram counts.
            QVERIFY(figures.scale.isBeyond(figures.spots.front().value));
            const QString sentence = legendOf(figures).shareSentence();
            QVERIFY2(sentence.startsWith("<1 %"), qPrintable(sentence));
        }
        const auto fit = fabricFit({sheet.scene, places, *fabricPreset("woven")});
        QVERIFY(fit && fit->any > 0 && fit->any < 0.01);
    }

    void theWorstCalloutIsTheEndOfTheTablesRange() {
        const auto garment = test::makeGarment({{"cap", test::makeCap(0)}});
        Progress progress;
        const PieceResults results = flattenGarment(*garment, {}, progress);
        const auto scene = buildScene(*garment, results, progress);
        const FlatPiece* flat = flatPieceOf(*garment, results, 0);
        QVERIFY(flat);
        const Eigen::VectorXd strains =
            100 * distortionFields(*garment->pieces[0], flat->Q).edgeStrain;
        const OverlayFigures figures =
            overlayFigures({scene, grainAt(kUp), *fabricPreset("woven"), Overlay::Strain});
        QVERIFY(!figures.spots.empty());
        const double least = strains.minCoeff(), most = strains.maxCoeff();
        const double worst =
            figures.scale.severity(least) > figures.scale.severity(most) ? least : most;
        QVERIFY2(isNear(figures.spots.front().value, worst),
                 qPrintable(QString("%1, not %2").arg(figures.spots.front().value).arg(worst)));
    }

    void theEndsAddUpToTheSentence() {
        QLocale::setDefault(QLocale::c());
        ColourLegend legend{Overlay::Warp, {-1, 2, false, false, true}, Histogram{}, {}};
        const auto shown = [&](double below, double above) -> QString {
            legend.histogram->below = below;
            legend.histogram->above = above;
            const QString sentence = legend.shareSentence();
            return legend.endShareText(false) + " + " + legend.endShareText(true) + " = " +
                   sentence.left(sentence.indexOf('%') + 1);
        };
        QCOMPARE(shown(0.104, 0.224), QString("10 % + 23 % = 33 %"));
        QCOMPARE(shown(0.224, 0.104), QString("23 % + 10 % = 33 %"));
        QCOMPARE(shown(0.366, 0.334), QString("37 % + 33 % = 70 %"));
        QCOMPARE(shown(0.995, 0.005), QString("99 % + 1 % = 100 %"));
        QCOMPARE(shown(0.003, 0.324), QString("<1 % + 33 % = 33 %"));
        QCOMPARE(shown(0.001, 0.001), QString("<1 % + <1 % = <1 %"));
        QCOMPARE(shown(0.0, 0.001), QString("0 % + <1 % = <1 %"));
        (void)shown(0, 0);  // nothing is flat yet
        QVERIFY(legend.shareSentence().isEmpty() && legend.endShareText(true).isEmpty());
        legend.histogram->bins[3] = 1;
        QVERIFY(shown(0, 0).startsWith("0 % + 0 % ="));
        QVERIFY(legend.shareSentence().startsWith("all cloth is within"));
    }

    void lackOfMemoryIsSaidAndTheNextQuestionIsAsked() {
        Document document;
        openLargeSheet(document);
        document.setOverlay(Overlay::Weft);
        bool isShort = true;  // read on the other thread, while nothing else runs here
        OverlayWatcher watcher(document, nullptr, [&isShort](const OverlayQuestion& question) {
            return isShort ? throw std::bad_alloc() : overlayFigures(question);
        });
        QSignalSpy failed(&watcher, &OverlayWatcher::failed);
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
        const QString said = failed.first().first().toString();
        QVERIFY2(said.contains("not enough memory"), qPrintable(said));
        QVERIFY(watcher.isUpToDate());
        QCOMPARE(watcher.figures().overlay, Overlay::Weft);
        QVERIFY(!watcher.figures().histogram);
        isShort = false;
        document.setOverlay(Overlay::Dirichlet);
        QVERIFY(QTest::qWaitFor([&] { return watcher.isUpToDate(); }, test::kPatience));
        QVERIFY(watcher.figures().histogram);
        QCOMPARE(failed.count(), 1);
    }

    void theWatcherComesBackWithThePerson() {
        Document document;
        openLargeSheet(document);
        document.setOverlay(Overlay::Weft);
        const OverlayWatcher watcher(document);
        QVERIFY(!watcher.isUpToDate());
        document.setOverlay(Overlay::Dirichlet);
        QCOMPARE(watcher.figures().overlay, Overlay::Dirichlet);
        document.setOverlay(Overlay::Weft);
        QCOMPARE(watcher.figures().overlay, Overlay::Weft);
        QVERIFY(watcher.figures().scale ==
                overlayScale(*document.scene(), Overlay::Weft, document.fabric()));
        QVERIFY(QTest::qWaitFor([&] { return watcher.isUpToDate(); }, test::kPatience));
        QCOMPARE(watcher.figures().overlay, Overlay::Weft);
        QVERIFY(watcher.figures().histogram);
    }

    void turningTheGrainExchangesWarpAndWeft() {
        const BuiltScene sheet = stretchedSheet();
        QVERIFY(isNear(valueOf(sheet, Overlay::Warp, 0), valueOf(sheet, Overlay::Weft, kUp)));
        QVERIFY(isNear(valueOf(sheet, Overlay::Weft, 0), valueOf(sheet, Overlay::Warp, kUp)));
        QVERIFY(isNear(valueOf(sheet, Overlay::Bias, kUp / 2), 5));
    }

    void nothingIsSaidOfWhatIsNotThere() {
        const BuiltScene sheet = stretchedSheet();
        const OverlayScale scale;
        const SheetPlaces places = grainAt(kUp);
        const auto value = [&](const SurfaceHit& place, Overlay overlay) {
            return valueAt(*sheet.scene, places, place, overlay, scale, false);
        };
        QVERIFY(!value({-1, 0, {}}, Overlay::Area));
        QVERIFY(!value({1, 0, {}}, Overlay::Area));
        QVERIFY(!value({0, 120, {}}, Overlay::Area));
        QVERIFY(!value({0, 0, {}}, Overlay::Checker));
        QVERIFY(value({0, 119, {}}, Overlay::Area));
    }

    void scalesEndAtTheLimitsOfTheFabric() {
        const BuiltScene sheet = stretchedSheet();
        const Fabric& woven = *fabricPreset("woven");
        const auto scale = [&](Overlay overlay, const Fabric& fabric) {
            return overlayScale(*sheet.scene, overlay, fabric);
        };
        QCOMPARE(scale(Overlay::Warp, woven).low, 100 * woven.warp.least);
        QCOMPARE(scale(Overlay::Weft, woven).high, 100 * woven.weft.most);
        QCOMPARE(scale(Overlay::Bias, woven).high, 100 * woven.bias.most);
        // No direction is known of an edge's strain: what the tightest allows.
        QCOMPARE(scale(Overlay::Strain, woven).high, 2.0);
        QCOMPARE(scale(Overlay::Principal, woven).low, -1.0);
        QVERIFY(scale(Overlay::Warp, woven).limited);
        QVERIFY(!scale(Overlay::Area, woven).limited);
        // Nobody has said what it is cut from: one scale for all strain, and nothing beyond it.
        const Fabric& unstated = fabricPresets().front();
        QVERIFY(!scale(Overlay::Warp, unstated).limited);
        QVERIFY(scale(Overlay::Warp, unstated) == scale(Overlay::Bias, unstated));
        QVERIFY(scale(Overlay::Warp, unstated).high > 0);
        QCOMPARE(fabricFit({sheet.scene, grainAt(kUp), unstated})->any, 0.0);
        Fabric stiff;  // all limits 0
        QVERIFY(scale(Overlay::Warp, stiff).high > 0 && scale(Overlay::Warp, stiff).low < 0);
    }

    void coloursHaveNothingInTheirMiddleHoweverUnlikeTheLimits() {
        const OverlayScale scale{-1, 4, false, false, true};
        QCOMPARE(scale.shade(0), 0.5);
        QCOMPARE(scale.shade(4), 1.0);
        QCOMPARE(scale.shade(2), 0.75);
        QCOMPARE(scale.shade(-0.5), 0.25);
        QCOMPARE(scale.position(0), 0.2);
        QCOMPARE(scale.severity(8), 2.0);
        QCOMPARE(scale.severity(-2), 2.0);
    }

    void histogramCountsClothByItsArea() {
        // The left half of the sheet as it is, the right half stretched by 5 %.
        const BuiltScene sheet =
            builtScene({{"front", test::makeSheet(100, 60, 10, 6)}},
                       [](const Eigen::Vector2d& worn) -> Eigen::Vector2d {
                           const double beyond = std::max(0.0, worn.x() - 50);
                           return {worn.x() - beyond + beyond / 1.05, worn.y()};
                       });
        const Fabric& woven = *fabricPreset("woven");
        const OverlayScale scale = overlayScale(*sheet.scene, Overlay::Weft, woven);
        const Histogram histogram =
            overlayHistogram(*sheet.scene, grainAt(kUp), Overlay::Weft, scale);
        const double stretched = 50 / 1.05, all = 50 + stretched;
        QVERIFY(isNear(histogram.above, stretched / all, 1e-6));
        QCOMPARE(histogram.below, 0.0);
        double sum = histogram.beyond();
        for (const double bin : histogram.bins) {
            sum += bin;
        }
        QVERIFY(isNear(sum, 1, 1e-9));
        const auto zero = static_cast<std::size_t>(scale.position(0.001) * kHistogramBins);
        QVERIFY(histogram.bins[zero] + histogram.bins[zero - 1] > 0.5);
        // Jersey gives way that far.
        const OverlayScale soft =
            overlayScale(*sheet.scene, Overlay::Weft, *fabricPreset("jersey"));
        QCOMPARE(overlayHistogram(*sheet.scene, grainAt(kUp), Overlay::Weft, soft).beyond(), 0.0);
    }

    void worstSpotsAreThePeaksWellApart() {
        // Two hills of strain, at x = 30 and x = 150, the second higher.
        const auto hill = [](double x, double middle) {
            return std::exp(-(x - middle) * (x - middle) / 100);
        };
        const BuiltScene sheet = builtScene({{"front", test::makeSheet(200, 60, 80, 24)}},
                                            [&](const Eigen::Vector2d& worn) -> Eigen::Vector2d {
                                                const double along = 1 - 0.08 * hill(worn.x(), 30) -
                                                                     0.12 * hill(worn.x(), 150);
                                                return {worn.x(), 30 + (worn.y() - 30) * along};
                                            });
        const OverlayScale scale =
            overlayScale(*sheet.scene, Overlay::Warp, *fabricPreset("woven"));
        const auto spots = worstSpots(*sheet.scene, grainAt(kUp), Overlay::Warp, scale);
        QVERIFY(spots.size() >= 2 && spots.size() <= std::size_t(kMaxWorstSpots));
        QVERIFY(isNear(spots.front().flat.x(), 150, 3));
        QVERIFY(isNear(spots.front().value, 100 * (1 / 0.88 - 1), 1));
        QVERIFY(std::ranges::any_of(
            spots, [](const WorstSpot& spot) { return std::abs(spot.flat.x() - 30) < 4; }));
        for (std::size_t i = 0; i < spots.size(); ++i) {
            QVERIFY(isNear(spots[i].normal.z(), 1, 1e-6));
            QVERIFY(i == 0 || scale.severity(spots[i].value) <= scale.severity(spots[i - 1].value));
            for (std::size_t k = 0; k < i; ++k) {
                QVERIFY((spots[i].flat - spots[k].flat).norm() > 10);
            }
            // Where it is worn: the sheet is not moved sideways.
            QVERIFY(
                isNear(spots[i].position.x() + sheet.scene->origin.x(), spots[i].flat.x(), 0.1));
        }
    }

    void clothWithoutTroubleHasNoWorstSpots() {
        const BuiltScene sheet = builtScene({{"front", test::makeSheet(100, 60, 10, 6)}},
                                            [](const Eigen::Vector2d& worn) { return worn; });
        for (int i = 0; i < kOverlayCount; ++i) {
            const auto overlay = static_cast<Overlay>(i);
            const OverlayScale scale = overlayScale(*sheet.scene, overlay, *fabricPreset("woven"));
            QVERIFY(worstSpots(*sheet.scene, {}, overlay, scale).empty());
        }
    }

    void questionsDifferOnlyWhereTheirAnswersDo() {
        const BuiltScene sheet = stretchedSheet();
        OverlayQuestion one{sheet.scene, grainAt(1), *fabricPreset("woven"), Overlay::Warp};
        OverlayQuestion other = one;
        other.places[0].placement.offset = {5, 7};
        QVERIFY(isSameQuestion(one, other));
        other.places[0].grain = 1.1;
        QVERIFY(!isSameQuestion(one, other));
        one.overlay = other.overlay = Overlay::Area;
        QVERIFY(isSameQuestion(one, other));
        other.fabric = *fabricPreset("jersey");
        QVERIFY(!isSameQuestion(one, other));
    }

    void glyphsStandEvenlyWhateverTheScale() {
        const BuiltScene sheet = builtScene({{"front", test::makeSheet(400, 400, 60, 60)}},
                                            [](const Eigen::Vector2d& worn) -> Eigen::Vector2d {
                                                return {worn.x() / 1.05, worn.y()};
                                            });
        const StrainGlyphs& glyphs = sheet.scene->glyphs;
        QVERIFY(glyphs.vertices.size() <= sheet.scene->faces.size());
        for (const double wanted : {10.0, 40.0, 100.0}) {
            const GlyphRange run = glyphsAt(glyphs, wanted);
            QVERIFY(run.spacing >= wanted && run.spacing < 1.5 * wanted);
            const double expected = 400 / 1.05 * 400 / (run.spacing * run.spacing);
            QVERIFY2(run.count > 0.6 * expected && run.count < 1.6 * expected + 4,
                     qPrintable(QString("%1 of %2").arg(run.count).arg(expected)));
        }
        QVERIFY(glyphsAt(glyphs, 1e9).count >= 1);
        for (const GlyphVertex& cross : glyphs.vertices) {
            QVERIFY(isNear(static_cast<double>(cross.strain[0]), 5));
            QVERIFY(isNear(static_cast<double>(cross.strain[1]), 0));
            QVERIFY(isNear(std::abs(static_cast<double>(cross.flatAlong[0])), 1));
            QVERIFY(isNear(std::abs(static_cast<double>(cross.along[0])), 1));
            QVERIFY(isNear(std::abs(static_cast<double>(cross.across[1])), 1));
        }
    }

    void trianglesOfBothViewsHaveTheirOwnValues() {
        // The first piece is closed and stays out of the pattern.
        BuiltScene built;
        built.garment = test::makeGarment(
            {{"blob", test::makeTetrahedron(40)}, {"front", test::makeSheet(100, 60, 10, 6)}});
        auto failed = std::make_shared<PieceResult>();
        failed->piece = built.garment->pieces[0];
        auto flat = std::make_shared<PieceResult>();
        flat->piece = built.garment->pieces[1];
        flat->flat = FlatPiece{};
        flat->flat->Q = built.garment->pieces[1]->mesh.V.leftCols<2>() * 0.5;
        Progress progress;
        built.scene = buildScene(*built.garment, {failed, flat}, progress);
        const auto worn = garmentFaces(*built.scene);
        QCOMPARE(built.scene->faces.size(), std::size_t(120));
        QCOMPARE(worn.size(), std::size_t(124));
        QCOMPARE(worn[3].metric[0], 0.0F);
        QVERIFY(isNear(static_cast<double>(worn[4].metric[0]), 4));
        QVERIFY(isNear(static_cast<double>(worn[4].flatArea), 25.0 / 2));
    }
};

TOILE_WINDOW_TEST(OverlayValuesTest)
#include "overlay_values_test.moc"
