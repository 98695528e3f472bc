// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "app/views/tools/path_tool.h"
#include "app/views/tools/tool_box.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/window_fixture.h"

namespace toile::test {

using namespace app;

/// A window with a garment for tools that work in both views.
class ToolBench : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup() { fixture_.close(); }

protected:
    static constexpr double kWidth = 200, kHeight = 150;  ///< of the sheet, mm

    WindowFixture fixture_;

    /// Two separate sheets next to each other: one of kWidth x kHeight from the origin, and one of
    /// 50 x 50 mm from x = 300.
    void openSheets();
    /// Two parts of a cap with one sewn seam between them.
    void openCap();

    SceneView& garmentView() { return fixture_.garmentView(); }
    SceneView& patternView() { return fixture_.patternView(); }
    ToolBox& tools() { return fixture_.window().tools(); }
    const PathTool& pathTool() { return dynamic_cast<const PathTool&>(tools().current()); }
    Document& document() { return fixture_.document(); }

    /// Position of a point of the garment in a view.
    QPointF at(SceneView& view, int piece, const Eigen::Vector3d& point);
    /// True once the garment has this many pieces, all flat.
    bool waitForPieces(int count);

    /// The tool hint in the status bar.
    QString hint();
    /// Text of the banner; empty if it is hidden.
    QString said();

    /// The one sewn seam.
    std::optional<int> sewn();
    /// A point in the middle of the seam.
    QPointF onSeam(SceneView& view, int seam);

private:
    void open(const QString& file);
};

}  // namespace toile::test
