// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "app/render/scene.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/pixels.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

namespace toile::test {

using namespace app;

inline const QColor kHighlight(255, 214, 10);  ///< of a highlighted seam

/// A window with two sewn parts of a cap, and a mouse pointer in it.
class PointerBench : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        writeObj(fixture_.path("cap.obj").toStdString(), sewnCapParts());
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("cap.obj")));
        fixture_.action(overlayAction(Overlay::None)).trigger();
        QVERIFY(firstSeam() >= 0);
    }

    void cleanup() { fixture_.close(); }

protected:
    WindowFixture fixture_;

    GarmentView& garmentView() { return fixture_.garmentView(); }
    PatternView& patternView() { return fixture_.patternView(); }
    Document& document() { return fixture_.document(); }
    const Scene& scene() { return *document().scene(); }

    void moveTo(QWidget& view, const QPointF& at) { test::moveTo(view, at); }
    void leave(QWidget& view) { test::leave(view); }

    /// Turns the wheel at the middle of the view.
    void zoomIn(QWidget& view, int notches) {
        for (int i = 0; i < notches; ++i) {
            turnWheel(view, view.rect().center(), 1);
        }
    }

    void click(QWidget& view, const QPointF& at) {
        QTest::mouseClick(&view, Qt::LeftButton, {}, at.toPoint());
    }

    int firstSeam() {
        const auto& seams = document().garment()->seams.seams;
        for (std::size_t i = 0; i < seams.size(); ++i) {
            if (seams[i].kind == SeamKind::Seam) {
                return static_cast<int>(i);
            }
        }
        return -1;
    }

    /// A third along a side of a seam, in the pattern view.
    QPointF onPatternSeam(int seam, std::size_t side) {
        const VertexRun run = scene().patternLines.seams[std::size_t(seam)][side];
        const auto& vertex = scene().lineVertices[run.first + run.count / 3];
        const int piece = scene().seams[std::size_t(seam)].sides[side].piece;
        const Eigen::Vector2d flat = Eigen::Map<const Eigen::Vector2f>(vertex.flat).cast<double>();
        const auto placement = document().settings()[std::size_t(piece)].placement;
        const Eigen::Vector2d at = patternView().camera().toScreen(placement->applied(flat));
        return {at.x(), at.y()};
    }

    QPointF onGarmentSeam(int seam) {
        const VertexRun run = scene().garmentLines.seams[std::size_t(seam)][0];
        const auto& vertex = scene().lineVertices[run.first + run.count / 3];
        const Eigen::Vector2d at = garmentView().camera().project(
            Eigen::Map<const Eigen::Vector3f>(vertex.position).cast<double>());
        return {at.x(), at.y()};
    }

    QPointF onPatternPiece(int piece) {
        const auto placement = document().settings()[std::size_t(piece)].placement;
        const Eigen::Vector2d at = patternView().camera().toScreen(
            placement->applied(scene().pieces[std::size_t(piece)].label));
        return {at.x(), at.y()};
    }

    int highlightedInGarment() { return countPixels(fixture_.garmentPicture(), kHighlight, 30); }
    int highlightedInPattern() { return countPixels(fixture_.patternPicture(), kHighlight, 30); }
    QLabel& label(QWidget& view) { return *view.findChild<QLabel*>("hoverText"); }
};

}  // namespace toile::test
