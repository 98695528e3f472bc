// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame asks of the graphics driver: as many draw calls however many pieces and triangles
// there are, and nothing sent while only the camera moves.
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QTest>
#include <cmath>

#include "app/platform_choice.h"
#include "app/render/garment_renderer.h"
#include "app/render/pattern_renderer.h"
#include "app/render/scene_builder.h"
#include "core/seam/find_seams.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr int kSize = 256;

/// Waves of cloth, so that it is not all in one plane.
MeshArrays wavySheetAt(double x, int columns, int rows) {
    MeshArrays mesh = test::makeSheet(columns, rows, columns, rows, {x, 0, 0});
    for (Eigen::Index i = 0; i < mesh.V.rows(); ++i) {
        mesh.V(i, 2) = 20 * std::sin(mesh.V(i, 0) / 40) * std::cos(mesh.V(i, 1) / 50);
    }
    return mesh;
}

/// Pieces in a row, flat as seen from the front: what they look like is no matter here.
std::shared_ptr<const Scene> sceneOf(int pieces, int columns, int rows) {
    std::vector<std::pair<std::string, MeshArrays>> parts;
    for (int i = 0; i < pieces; ++i) {
        parts.emplace_back("piece " + std::to_string(i),
                           wavySheetAt(1.5 * columns * i, columns, rows));
    }
    const auto garment = std::make_shared<Garment>(*test::makeGarment(std::move(parts)));
    garment->seams = findSeams(garment->pieces);
    PieceResults results;
    for (const auto& piece : garment->pieces) {
        auto result = std::make_shared<PieceResult>();
        result->piece = piece;
        result->flat.emplace();
        result->flat->Q = piece->mesh.V.leftCols<2>();
        results.push_back(std::move(result));
    }
    Progress progress;
    return buildScene(*garment, results, progress);
}

}  // namespace

class FrameCostTest : public QObject {
    Q_OBJECT

private:
    QOpenGLContext context_;
    QOffscreenSurface surface_;
    std::unique_ptr<QOpenGLFramebufferObject> target_;
    FrameCounts firstFrame_;  ///< what `secondFrame` has measured of the one before

    /// The second of two frames, between which the camera moves.
    template <class Renderer, class Paint>
    FrameCounts secondFrame(const std::shared_ptr<const Scene>& scene, const Paint& paint) {
        Renderer renderer;
        if (!renderer.initialize().isEmpty()) {
            return {-1, 0};
        }
        renderer.show({.scene = scene, .selection = {0}, .seam = 0});
        paint(renderer, 0);
        const FrameCounts before = renderer.counts();
        firstFrame_ = before;
        paint(renderer, 1);
        const FrameCounts after = renderer.counts();
        renderer.release();
        return {after.drawCalls - before.drawCalls, after.uploadedBytes - before.uploadedBytes};
    }

    FrameCounts garmentFrame(const std::shared_ptr<const Scene>& scene, double way = 0,
                             Overlay overlay = Overlay::None) {
        return secondFrame<GarmentRenderer>(scene, [&](GarmentRenderer& renderer, int turn) {
            Camera3D camera;
            camera.setViewport(kSize, kSize);
            camera.setDirection(0.2 + turn, 0.1);
            const Eigen::AlignedBox3d boxes[] = {scene->box};
            camera.frame(boxes);
            ViewState view;
            view.wireframe = view.referencePanels = view.valuesPerTriangle = true;
            view.overlay = overlay;
            Morph morph;
            morph.way = way;
            renderer.paint(camera, view, renderStyle({}), kSize, kSize, 1, morph);
        });
    }

    FrameCounts patternFrame(const std::shared_ptr<const Scene>& scene,
                             Overlay overlay = Overlay::None) {
        return secondFrame<PatternRenderer>(scene, [&](PatternRenderer& renderer, int turn) {
            Camera2D camera;
            camera.setViewport(kSize, kSize);
            camera.frame(sheetBox(*scene, {}), {});
            camera.pan(20 * turn, 0);
            ViewState view;
            view.wireframe = view.referencePanels = view.valuesPerTriangle = true;
            view.overlay = overlay;
            renderer.paint(camera, view, renderStyle({}), kSize, kSize, 1);
        });
    }

private slots:
    void initTestCase() {
        loadResources();
        if (!glProblem().isEmpty()) {
            QSKIP("no OpenGL 3.3 context can be made here");
        }
        context_.setFormat(sceneSurfaceFormat());
        QVERIFY(context_.create());
        surface_.setFormat(context_.format());
        surface_.create();
        QVERIFY(context_.makeCurrent(&surface_));
        target_ = std::make_unique<QOpenGLFramebufferObject>(kSize, kSize,
                                                             QOpenGLFramebufferObject::Depth);
        QVERIFY(target_->bind());
    }

    void cleanupTestCase() { target_.reset(); }

    void manyPiecesTakeAsManyDrawCallsAsOne() {
        const auto one = sceneOf(1, 12, 10), thirty = sceneOf(30, 12, 10);
        QCOMPARE(thirty->pieces.size(), std::size_t{30});
        const FrameCounts ofOne = garmentFrame(one), ofThirty = garmentFrame(thirty);
        QVERIFY(ofOne.drawCalls > 0);
        QCOMPARE(ofThirty.drawCalls, ofOne.drawCalls);
        QCOMPARE(patternFrame(thirty).drawCalls, patternFrame(one).drawCalls);
        QVERIFY2(ofOne.drawCalls <= 16, "a frame is a handful of draw calls");
    }

    void aCameraThatMovesSendsNothing() {
        const auto scene = sceneOf(3, 12, 10);
        QCOMPARE(garmentFrame(scene).uploadedBytes, std::size_t{0});
        QCOMPARE(patternFrame(scene).uploadedBytes, std::size_t{0});
        QCOMPARE(garmentFrame(scene, 0.5).uploadedBytes, std::size_t{0});
    }

    void overlaysSendNothingEither() {
        const auto one = sceneOf(1, 12, 10), three = sceneOf(3, 12, 10);
        const FrameCounts plain = garmentFrame(three);
        const std::size_t sentPlain = firstFrame_.uploadedBytes;
        for (const Overlay overlay : {Overlay::Strain, Overlay::Principal}) {
            const FrameCounts garment = garmentFrame(three, 0, overlay);
            // The triangles' table is sent once, and counted.
            QVERIFY(firstFrame_.uploadedBytes >=
                    sentPlain + three->garment.triangles.size() / 3 * sizeof(FaceValues));
            QCOMPARE(garment.uploadedBytes, std::size_t{0});
            const int glyphs = overlay == Overlay::Principal ? 1 : 0;
            QCOMPARE(garment.drawCalls, plain.drawCalls + glyphs);
            QCOMPARE(garmentFrame(one, 0, overlay).drawCalls, garment.drawCalls);
            QCOMPARE(patternFrame(three, overlay).uploadedBytes, std::size_t{0});
            QCOMPARE(patternFrame(one, overlay).drawCalls, patternFrame(three, overlay).drawCalls);
        }
    }

    void linesOfAHiddenLayerStayHiddenNearby() {
        // Two layers 15 mm apart, the eye 200 mm before the one in front, in a garment of a metre.
        auto garment =
            test::makeGarment({{"front", test::makeSheet(1000, 1000, 4, 4)},
                               {"lining", test::makeSheet(40, 40, 2, 2, {480, 480, -15})}});
        Progress progress;
        const auto scene = buildScene(*garment, {}, progress);
        GarmentRenderer renderer;
        QVERIFY(renderer.initialize().isEmpty());
        const auto picture = [&](const std::set<int>& selection) -> QImage {
            Camera3D camera;
            camera.setViewport(kSize, kSize);
            camera.setDirection(0, 0);
            const Eigen::AlignedBox3d boxes[] = {scene->box};
            camera.frame(boxes);
            const Eigen::Vector3d front(0, 0, scene->box.max().z());
            camera.zoomAt(front, (camera.distance() - front.z()) / 200);
            renderer.show({.scene = scene, .selection = selection});
            renderer.paint(camera, {}, renderStyle({}), kSize, kSize, 1);
            return target_->toImage();
        };
        const QImage without = picture({}), with = picture({1});
        renderer.release();
        QVERIFY(without == with);
    }

    void onTheWayToTheSheetOnlyATableIsSent() {
        // The sheet stands before the eye, so the camera moves it: no mesh is sent for that.
        const auto scene = sceneOf(3, 60, 50);
        QVERIFY(garmentFrame(scene, 0.8).uploadedBytes <= std::size_t{16} * 2048);
    }

    void aMillionTrianglesTakeNoMoreDrawCalls() {
        if (qEnvironmentVariableIsSet("TOILE_QUICK")) {
            QSKIP("TOILE_QUICK is set: a million triangles take some seconds");
        }
        const auto small = sceneOf(1, 12, 10), large = sceneOf(1, 708, 708);
        QVERIFY(large->garment.triangles.size() > 3'000'000);
        const FrameCounts ofLarge = garmentFrame(large);
        QCOMPARE(ofLarge.drawCalls, garmentFrame(small).drawCalls);
        QCOMPARE(ofLarge.uploadedBytes, std::size_t{0});
        const FrameCounts flat = patternFrame(large);
        QCOMPARE(flat.drawCalls, patternFrame(small).drawCalls);
        QCOMPARE(flat.uploadedBytes, std::size_t{0});
    }
};

TOILE_WINDOW_TEST(FrameCostTest)
#include "frame_cost_test.moc"
