// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/camera.h"

#include <QTest>

#include <glm/vec4.hpp>

#include "app/render/glm_eigen.h"
#include "app/render/pattern_renderer.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

const Eigen::AlignedBox3d kBox(Eigen::Vector3d(-300, -500, -150), Eigen::Vector3d(320, 450, 180));

/// Screen place of a point by way of the matrices that the shaders get.
Eigen::Vector2d throughMatrices(const Camera3D& camera, const Eigen::Vector3d& point, double width,
                                double height) {
    const glm::dvec4 clip = camera.projection(kBox) * camera.view() * glm::dvec4(toGlm(point), 1.0);
    return {(clip.x / clip.w + 1) / 2 * width, (1 - clip.y / clip.w) / 2 * height};
}

}  // namespace

class CameraTest : public QObject {
    Q_OBJECT

private slots:
    void projectAgreesWithTheMatrices() {
        Camera3D camera;
        camera.setViewport(800, 600);
        camera.frame({&kBox, 1});
        camera.orbit(130, -70);
        const Eigen::Vector3d point(120, -240, 90);
        QVERIFY((camera.project(point) - throughMatrices(camera, point, 800, 600)).norm() < 1e-6);
    }

    void rayPassesThroughWhatIsSeenAtAPixel() {
        Camera3D camera;
        camera.setViewport(800, 600);
        camera.frame({&kBox, 1});
        const Eigen::Vector3d point(100, 200, -50);
        const Eigen::Vector2d pixel = camera.project(point);
        const Ray ray = camera.ray(pixel.x(), pixel.y());
        QVERIFY(ray.direction.cross(point - ray.origin).norm() < 1e-6);
        QVERIFY(ray.direction.dot(point - ray.origin) > 0);
    }

    void depthShiftIsAShareOfTheDistanceWhereverTheEyeIs() {
        constexpr double kShare = 1e-3;
        for (const double zoom : {1.0, 12.0}) {
            for (const bool orthographic : {false, true}) {
                Camera3D camera;
                camera.setViewport(800, 600);
                camera.setOrthographic(orthographic);
                camera.frame({&kBox, 1});
                camera.zoomAt({0, 0, 180}, zoom);
                const auto depth = [&](const Eigen::Vector3d& point, double shift) -> double {
                    const glm::dvec4 clip =
                        camera.projection(kBox) * camera.view() * glm::dvec4(toGlm(point), 1.0);
                    return (clip.z - shift) / clip.w;
                };
                const double shift = camera.depthShift(kBox, kShare);
                const Eigen::Vector3d towards = camera.axes().col(2);
                for (const double z : {150.0, 0.0, -150.0}) {
                    const Eigen::Vector3d point(5, -7, z);
                    const double away =
                        orthographic ? camera.distance() : (camera.eye() - point).dot(towards);
                    // A line lifted so lies before cloth that is nearer by half of it, and behind
                    // cloth that is nearer by twice as much.
                    const auto nearer = [&](double times) -> Eigen::Vector3d {
                        return point + times * kShare * away * towards;
                    };
                    QVERIFY(depth(point, shift) < depth(nearer(0.5), 0));
                    QVERIFY(depth(point, shift) > depth(nearer(2), 0));
                }
            }
        }
    }

    void zoomEndsSomewhere() {
        Camera3D camera;
        camera.setViewport(800, 600);
        camera.frame({&kBox, 1});
        for (int i = 0; i < 1000; ++i) {
            camera.zoomAt({0, 0, 0}, 1.5);
        }
        QVERIFY(camera.distance() >= 1e-3);
        for (int i = 0; i < 1000; ++i) {
            camera.zoomAt({0, 0, 0}, 1 / 1.5);
        }
        QVERIFY(camera.distance() <= 1e7);
        camera.setOrthographic(true);
        // Rays start before all cloth, however large it is.
        QVERIFY((camera.ray(400, 300).origin).norm() > 1e8);
    }

    void framedBoxIsWhollyInView_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::newRow("wide") << 1200.0 << 300.0;
        QTest::newRow("tall") << 250.0 << 900.0;
    }

    void framedBoxIsWhollyInView() {
        QFETCH(double, width);
        QFETCH(double, height);
        Camera3D camera;
        camera.setViewport(width, height);
        for (int turn = 0; turn < 12; ++turn) {
            camera.orbit(90, turn * 17 - 80);
            camera.frame({&kBox, 1});
            double nearestEdge = 1e9;
            for (int corner = 0; corner < 8; ++corner) {
                const Eigen::Vector2d at = camera.project(
                    kBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
                nearestEdge =
                    std::min({nearestEdge, at.x(), at.y(), width - at.x(), height - at.y()});
            }
            QVERIFY(nearestEdge > 0);
            // And not lost in the middle of the view either.
            QVERIFY(nearestEdge < 0.15 * std::min(width, height));
        }
    }

    void zoomKeepsTheAnchorUnderTheCursor() {
        Camera3D camera;
        camera.setViewport(800, 600);
        camera.frame({&kBox, 1});
        const Eigen::Vector3d anchor(200, 300, 100);
        const Eigen::Vector2d before = camera.project(anchor);
        for (const double factor : {1.3, 1.3, 0.4, 2.0}) {
            camera.zoomAt(anchor, factor);
            QVERIFY((camera.project(anchor) - before).norm() < 1e-6);
        }
    }

    void zoomWithoutAHitKeepsThePointAtTargetDepth() {
        Camera3D camera;
        camera.setViewport(800, 600);
        camera.frame({&kBox, 1});
        const Eigen::Vector3d anchor = camera.pointAtTargetDepth(650, 80);
        QVERIFY((camera.project(anchor) - Eigen::Vector2d(650, 80)).norm() < 1e-6);
    }

    void panFollowsThePointerAtTargetDepth() {
        Camera3D camera;
        camera.setViewport(800, 600);
        camera.frame({&kBox, 1});
        const Eigen::Vector3d point = camera.pointAtTargetDepth(400, 300);
        camera.pan(37, -21);
        QVERIFY((camera.project(point) - Eigen::Vector2d(437, 279)).norm() < 1e-6);
    }

    void garmentStaysUprightHoweverItIsTurned() {
        Camera3D camera;
        camera.setViewport(600, 600);
        camera.frame({&kBox, 1});
        camera.orbit(5000, -9000);
        const Eigen::Vector2d foot = camera.project({0, -100, 0});
        const Eigen::Vector2d head = camera.project({0, 100, 0});
        QVERIFY(head.y() < foot.y());
    }

    void everythingLiesBetweenNearAndFar() {
        Camera3D camera;
        camera.setViewport(800, 600);
        camera.frame({&kBox, 1});
        camera.zoomAt(kBox.center(), 0.2);
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d point =
                kBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
            const glm::dvec4 clip =
                camera.projection(kBox) * camera.view() * glm::dvec4(toGlm(point), 1.0);
            QVERIFY(std::abs(clip.z) <= clip.w);
        }
    }

    void sheetHasOneScaleOnBothAxes() {
        Camera2D camera;
        camera.setViewport(700, 420);
        camera.frame({Eigen::Vector2d(0, 0), Eigen::Vector2d(1400, 300)}, {30, 40, 60});
        const Eigen::Vector2d origin = camera.toScreen({0, 0});
        const double across = camera.toScreen({100, 0}).x() - origin.x();
        const double up = origin.y() - camera.toScreen({0, 100}).y();
        QCOMPARE(across, up);
        QCOMPARE(across, 100 * camera.pixelsPerMillimetre());
        const glm::dmat4 matrix = camera.projection();
        QVERIFY(std::abs(matrix[0][0] * 700 - matrix[1][1] * 420) < 1e-9);
    }

    void framedSheetKeepsItsMargins() {
        Camera2D camera;
        camera.setViewport(700, 420);
        const Eigen::AlignedBox2d sheet(Eigen::Vector2d(50, 20), Eigen::Vector2d(450, 900));
        camera.frame(sheet, {30, 40, 60});
        const Eigen::Vector2d top = camera.toScreen(sheet.max());
        const Eigen::Vector2d bottom = camera.toScreen(sheet.min());
        QVERIFY(std::abs(top.y() - 40) < 1e-6);
        QVERIFY(std::abs(420 - bottom.y() - 60) < 1e-6);
        QVERIFY(bottom.x() >= 30 && top.x() <= 670);
    }

    void sheetZoomKeepsThePointUnderTheCursor() {
        Camera2D camera;
        camera.setViewport(700, 420);
        const Eigen::Vector2d before = camera.toWorld(120, 333);
        for (const double factor : {1.15, 3.0, 0.1}) {
            camera.zoomAt(120, 333, factor);
            QVERIFY((camera.toWorld(120, 333) - before).norm() < 1e-9);
        }
    }

    void sheetPanFollowsThePointer() {
        Camera2D camera;
        camera.setViewport(700, 420);
        const Eigen::Vector2d point = camera.toWorld(100, 100);
        camera.pan(25, -40);
        QVERIFY((camera.toScreen(point) - Eigen::Vector2d(125, 60)).norm() < 1e-9);
    }

    void gridIsTenCentimetresAtTheUsualScale() {
        QCOMPARE(gridSteps(0.6).major, 100.0);
        QCOMPARE(gridSteps(0.6).minorStrength, 0.0);
        QCOMPARE(gridSteps(3.0).major, 100.0);
        QVERIFY(gridSteps(3.0).minorStrength > 0.4);
    }
};

TOILE_WINDOW_TEST(CameraTest)
#include "camera_test.moc"
