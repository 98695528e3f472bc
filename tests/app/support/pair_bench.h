// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "app/render/scene.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/window_fixture.h"

namespace toile::test {

using namespace app;

/// An empty window of 1200 x 800, and the file of a garment of two pieces, a bent strip and a cap.
class PairBench : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        writeObj(path("pair.obj").toStdString(),
                 {{"strip", makeBentStrip(-140)}, {"cap", makeCap(140)}});
    }
    void init() {
        fixture_.open({1200, 800});
        workspace().setUnit(LengthUnit::Millimetre);
    }
    void cleanup() { fixture_.close(); }

protected:
    WindowFixture fixture_;

    bool openPair() { return fixture_.openAndWait(path("pair.obj")); }

    QString path(const QString& name) const { return fixture_.path(name); }
    MainWindow& window() { return fixture_.window(); }
    Workspace& workspace() { return fixture_.workspace(); }
    Document& document() { return fixture_.document(); }
    GarmentView& garmentView() { return fixture_.garmentView(); }
    PatternView& patternView() { return fixture_.patternView(); }
    QAction& action(ActionId id) { return fixture_.action(id); }

    Placement placement(int piece) {
        return *document().settings()[static_cast<std::size_t>(piece)].placement;
    }
    /// The middle of a piece's box, in the garment view.
    QPointF onGarment(int piece) {
        const auto& box = document().scene()->pieces[static_cast<std::size_t>(piece)].box;
        const auto at = garmentView().camera().project(box.center());
        return {at.x(), at.y()};
    }
    /// Position of a piece's name, in the pattern view.
    QPointF onPattern(int piece) {
        const auto& entry = document().scene()->pieces[static_cast<std::size_t>(piece)];
        const auto at = patternView().camera().toScreen(placement(piece).applied(entry.label));
        return {at.x(), at.y()};
    }
};

}  // namespace toile::test
