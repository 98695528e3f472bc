// SPDX-License-Identifier: GPL-3.0-or-later
// The measuring tool, with mouse and keys, in both views.
#include "app/views/tools/measure_tool.h"

#include <QClipboard>
#include <QGuiApplication>
#include <cmath>

#include "app/settings/length_display.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/tool_bench.h"

using namespace toile;
using namespace toile::app;

using test::click;
using test::doubleClick;
using test::moveTo;

class MeasureToolTest : public test::ToolBench {
    Q_OBJECT

private slots:
    void measuresOnTheClothAndInThePattern() {
        openSheets();
        const test::Moment start = test::momentOf(document());
        tools().choose(ToolId::Measure);
        const auto& tool = dynamic_cast<const MeasureTool&>(tools().current());
        SceneView& view = garmentView();
        click(view, at(view, 0, {0, 0, 0}));
        moveTo(view, at(view, 0, {kWidth, kHeight, 0}));
        QVERIFY(QTest::qWaitFor([&] { return tool.way().has_value(); }, test::kPatience));  // live
        doubleClick(view, at(view, 0, {kWidth, kHeight, 0}));
        QVERIFY(QTest::qWaitFor([&] { return tool.way().has_value(); }, test::kPatience));
        const double diagonal = std::hypot(kWidth, kHeight);
        QVERIFY(std::abs(tool.way()->onCloth - diagonal) < 0.01);
        QVERIFY(std::abs(*tool.way()->flat - diagonal) < 0.01);
        QVERIFY(tool.outline());
        QVERIFY(std::abs(tool.outline()->onCloth - kWidth - kHeight) < 1e-6);
        QVERIFY(std::abs(*tool.outline()->flat - kWidth - kHeight) < 1e-6);
        QCOMPARE(tool.lines().size(), 2);
        // The clipboard is the display's: another program may fill it between two calls.
        const auto copied = [&view] {
            QGuiApplication::clipboard()->clear();
            QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
            return QGuiApplication::clipboard()->text();
        };
        QTRY_COMPARE_WITH_TIMEOUT(copied(), tool.lines().join('\n'), test::kPatience);
        QVERIFY(tool.lines().join('\n').contains("250"));
        // Nothing of it goes to the document; a place on another piece begins anew.
        QVERIFY(test::momentOf(document()) == start);
        click(patternView(), at(patternView(), 1, {325, 25, 0}));
        QVERIFY(!tool.way());
        QTest::keyClick(&view, Qt::Key_Escape);
        QTest::keyClick(&view, Qt::Key_Escape);
        QCOMPARE(tools().current().id(), ToolId::Select);
    }

    void toolsSpeakInThePersonsUnit() {
        openSheets();
        tools().choose(ToolId::Measure);
        const auto& tool = dynamic_cast<const MeasureTool&>(tools().current());
        click(garmentView(), at(garmentView(), 0, {0, 0, 0}));
        click(garmentView(), at(garmentView(), 0, {kWidth, 0, 0}));
        QVERIFY(QTest::qWaitFor([&] { return tool.way().has_value(); }, test::kPatience));
        QVERIFY2(tool.lines().front().contains("200.0 mm"), qPrintable(tool.lines().front()));
        LengthDisplay::instance().choose(LengthUnit::Inch, 8);
        const QString inches = tool.lines().front();
        LengthDisplay::instance().choose(LengthUnit::Millimetre);
        QVERIFY2(inches.contains("7 7/8 in"), qPrintable(inches));
    }
};

TOILE_WINDOW_TEST(MeasureToolTest)
#include "measure_tool_test.moc"
