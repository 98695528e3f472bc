// SPDX-License-Identifier: GPL-3.0-or-later
// What the window asks for while a person waits, of half a million and a million triangles, in
// processor time of its thread. Runs at night: see the other tests of these things for what they
// do.
#include <QTest>
#include <cmath>

#include "app/document/document.h"
#include "app/jobs/path_finder.h"
#include "app/render/overlay_figures.h"
#include "app/render/picking.h"
#include "app/render/scene_builder.h"
#include "core/cut/surface_point.h"
#include "core/garment/fabric.h"
#include "core/quality/piece_quality.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/processor_time.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr int kSquares = 710;  ///< squares: a million triangles

/// Waves, worn as they are, whose cloth lies stretched more and more to the right.
std::shared_ptr<const Scene> millionTriangles() {
    MeshArrays mesh = test::makeSheet(kSquares, kSquares, kSquares, kSquares);
    for (Eigen::Index i = 0; i < mesh.V.rows(); ++i) {
        mesh.V(i, 2) = 30 * std::sin(mesh.V(i, 0) / 7) * std::cos(mesh.V(i, 1) / 11);
    }
    const auto garment = test::makeGarment({{"sheet", mesh}});
    auto result = std::make_shared<PieceResult>();
    result->piece = garment->pieces[0];
    result->flat.emplace();
    result->flat->Q = mesh.V.leftCols<2>();
    result->flat->Q.col(0).array() *= 1 - 2e-5 * mesh.V.col(0).array();
    result->quality = measure(*result->piece, result->flat->Q);
    Progress progress;
    return buildScene(*garment, {result}, progress);
}

template <class Work>
double milliseconds(const Work& work) {
    const double start = test::processorTime();
    work();
    return test::processorTime() - start;
}

#define VERIFY_WITHIN(limit, taken) \
    QVERIFY2((taken) < (limit), qPrintable(QString("%1 ms").arg(taken)))

}  // namespace

class ClockTest : public QObject {
    Q_OBJECT

    std::shared_ptr<const Scene> scene_;

private slots:
    void initTestCase() { scene_ = millionTriangles(); }

    void picksTakeTenMillisecondsAtMost() {
        constexpr int kPicks = 200;
        VERIFY_WITHIN(10 * kPicks, milliseconds([this] {
                          for (int i = 0; i < kPicks; ++i) {
                              const Eigen::Vector3d from(3.5 * i, 700 - 3.3 * i, 400);
                              (void)pickGarment(*scene_,
                                                {from - scene_->origin,
                                                 Eigen::Vector3d(0.2, -0.1, -1).normalized()});
                          }
                      }));
        VERIFY_WITHIN(10 * kPicks, milliseconds([this] {
                          for (int i = 0; i < kPicks; ++i) {
                              (void)pickPattern(*scene_, {}, {3.5 * i, 700 - 3.3 * i});
                          }
                      }));
    }

    void overlaysAreAnsweredSoon() {
        const SheetPlaces places{SheetPlace{Placement{}, 0.3}};
        const OverlayScale scale = overlayScale(*scene_, Overlay::Bias, *fabricPreset("woven"));
        VERIFY_WITHIN(
            500, milliseconds([&] {
                QVERIFY(overlayHistogram(*scene_, places, Overlay::Bias, scale).tallest() > 0);
            }));
        VERIFY_WITHIN(1500, milliseconds([&] {
                          QVERIFY(!worstSpots(*scene_, places, Overlay::Bias, scale).empty());
                      }));
    }

    void toAskForAPathHoldsNothingUp() {
        PathFinder finder;
        const auto piece =
            std::make_shared<const Piece>(makePiece("sheet", test::makeSheet(200, 100, 700, 350)));
        const auto request = [&piece](const Eigen::Vector3d& to) -> PathRequest {
            return {piece, NearestSurface(piece->mesh).find({1, 1, 0}),
                    NearestSurface(piece->mesh).find(to)};
        };
        const PathRequest first = request({199, 99, 0}), last = request({60, 60, 0});
        VERIFY_WITHIN(50, milliseconds([&] {
                          finder.find(first, [](const Result<PathPolyline>&) {});
                          finder.find(last, [](const Result<PathPolyline>&) {});
                      }));
    }
};

TOILE_WINDOW_TEST(ClockTest)
#include "clock_test.moc"
