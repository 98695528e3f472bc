// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/tool_bench.h"

#include <QLabel>
#include <algorithm>

#include "app/widgets/banner.h"
#include "core/cut/surface_point.h"
#include "tests/app/support/garments.h"

namespace toile::test {

using namespace app;

void ToolBench::initTestCase() {
    SKIP_WITHOUT_GL();
}

void ToolBench::openSheets() {
    const QString file = fixture_.path("sheets.obj");
    writeObj(file.toStdString(), {{"sheet", makeSheet(kWidth, kHeight, 20, 15)},
                                  {"other", makeSheet(50, 50, 5, 5, {300, 0, 0})}});
    open(file);
}

void ToolBench::openCap() {
    const QString file = fixture_.path("cap.obj");
    writeObj(file.toStdString(), sewnCapParts());
    open(file);
}

void ToolBench::open(const QString& file) {
    fixture_.open();
    fixture_.workspace().setUnit(LengthUnit::Millimetre);
    QVERIFY(fixture_.openAndWait(file));
    garmentView().setFocus();
}

QPointF ToolBench::at(SceneView& view, int piece, const Eigen::Vector3d& point) {
    const MeshArrays& mesh = document().garment()->pieces[static_cast<std::size_t>(piece)]->mesh;
    const SurfacePoint place = NearestSurface(mesh).find(point);
    return view.onScreen(piece, place.face, place.barycentric).value_or(QPointF(-1, -1));
}

bool ToolBench::waitForPieces(int count) {
    return QTest::qWaitFor(
               [this, count] {
                   return document().pieceCount() == count &&
                          !fixture_.workspace().jobs().isBusy() && document().isFlattened();
               },
               kPatience) &&
           fixture_.waitForResults();
}

QString ToolBench::hint() {
    return fixture_.find<QLabel>("toolHint").text();
}

QString ToolBench::said() {
    const Banner& banner = fixture_.window().banner();
    return banner.isVisible() ? banner.sentence() : QString();
}

std::optional<int> ToolBench::sewn() {
    const auto& seams = document().garment()->seams.seams;
    const auto found =
        std::ranges::find_if(seams, [](const Seam& seam) { return seam.kind != SeamKind::Free; });
    return found == seams.end() ? std::nullopt
                                : std::optional(static_cast<int>(found - seams.begin()));
}

QPointF ToolBench::onSeam(SceneView& view, int seam) {
    const QPolygonF line = view.seamOnScreen(seam).front();
    return line[line.size() / 2];
}

}  // namespace toile::test
