// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/sheet_bench.h"

#include <QDoubleSpinBox>

#include "app/render/scene.h"
#include "tests/app/support/garments.h"

namespace toile::test {

using namespace app;

void SheetBench::initTestCase() {
    SKIP_WITHOUT_GL();
    writeObj(fixture_.path("three.obj").toStdString(),
             {{"left", makeBentStrip(-300)},
              {"middle", makeBentStrip(0)},
              {"sheet", makeSheet(120, 80, 6, 4, {300, 0, 0})}});
}

void SheetBench::init() {
    fixture_.open();
    QVERIFY(fixture_.openAndWait(fixture_.path("three.obj")));
    document().setView(&ViewState::snapping, false);
    (void)fixture_.patternPicture();
}

QPointF SheetBench::on(int piece) {
    const auto& drawn = document().scene()->pieces[static_cast<std::size_t>(piece)];
    return onScreen(placement(piece).applied(drawn.label)) + QPointF(0, 16);
}

void SheetBench::frameAll() {
    view().frameAll();
    (void)fixture_.patternPicture();
}

void SheetBench::type(const char* field, const QString& text) {
    auto& box = fixture_.find<QDoubleSpinBox>(field);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
}

}  // namespace toile::test
