// SPDX-License-Identifier: GPL-3.0-or-later
// Takes docs/input.md's pictures of files that are no plain sheets, made here of the samples; with
// TOILE_UPDATE_DOCS set they are written.
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <fstream>

#include "app/panels/scan_form.h"
#include "app/render/piece_values.h"
#include "app/widgets/garment_card.h"
#include "core/mesh/mesh_arrays.h"
#include "core/prepare/file_surface.h"
#include "tests/app/support/doc_picture.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"
#include "tests/core/prepare/scan_shapes.h"
#include "tests/core/support/half_shapes.h"

using namespace toile;
using namespace toile::app;

namespace {

PolygonSoup sampleTshirt() {
    Progress progress;
    return *readSoup(TOILE_SOURCE_DIR "/resources/samples/tshirt.obj", progress);
}

/// The T-shirt and a lining so far within it, mm; no neckband is lined.
PolygonSoup linedTshirt(double apart) {
    PolygonSoup soup = sampleTshirt();
    const MeshArrays mesh = surfaceOf(soup, 1).mesh;
    const MeshArrays sewn{mesh.V, weldedFaces(mesh)};
    const Points3 normals = vertexNormals(sewn);
    std::vector<Eigen::Vector3d> inner = soup.positions;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            const auto v = static_cast<std::size_t>(mesh.F(f, k));
            inner[v] = soup.positions[v] - apart * normals.row(sewn.F(f, k)).transpose();
        }
    }
    const int vertices = static_cast<int>(soup.positions.size());
    const int faces = soup.faceCount(), objects = static_cast<int>(soup.objects.size());
    soup.positions.insert(soup.positions.end(), inner.begin(), inner.end());
    for (int object = 0; object < objects; ++object) {
        std::string name = soup.objects[static_cast<std::size_t>(object)];
        constexpr std::string_view kSleeve = "sleeve";
        name =
            name.starts_with(kSleeve) ? "lining" + name.substr(kSleeve.size()) : "lining_" + name;
        soup.objects.push_back(std::move(name));
    }
    for (int face = 0; face < faces; ++face) {
        const auto f = static_cast<std::size_t>(face);
        const int object = soup.faceObject[f];
        if (soup.objects[static_cast<std::size_t>(object)] == "neckband") {
            continue;
        }
        for (int c = soup.faceStart[f]; c < soup.faceStart[f + 1]; ++c) {
            soup.corners.push_back(soup.corners[static_cast<std::size_t>(c)] + vertices);
        }
        soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
        soup.faceObject.push_back(object + objects);
    }
    return soup;
}

/// The T-shirt in one, as a scanner sees it: noise, two holes, and what else was in the room.
MeshArrays scannedTshirt() {
    const MeshArrays panels = surfaceOf(sampleTshirt(), 1).mesh;
    const Eigen::RowVector3d middle =
        (panels.V.colwise().minCoeff() + panels.V.colwise().maxCoeff()) / 2;
    MeshArrays scan{panels.V.rowwise() - middle, weldedFaces(panels)};
    scan = test::withHole(test::withHole(scan, 110, 60, 28), -90, -150, 35);
    scan = test::withNoise(scan, 1);
    constexpr double kGolden = 2.4;  // radians: spread without a pattern
    for (int k = 0; k < 40; ++k) {
        MeshArrays scrap = test::planeGrid(1 + k % 4, 1 + k % 3, 4.0 + 0.8 * (k % 5));
        const Eigen::AngleAxisd turn(k, Eigen::Vector3d(k % 5, 1, k % 3).normalized());
        scrap.V = scrap.V * turn.toRotationMatrix();
        const double phi = kGolden * k, off = 1 + 0.04 * (k % 4);
        const Eigen::RowVector3d place(430 * off * std::cos(phi), -340 + 17.0 * k,
                                       260 * off * std::sin(phi));
        scan = test::beside(scan, test::withNoise(scrap, 2), place);
    }
    return scan;
}

/// Two square panels of 440 mm, sewn along their outline and stuffed.
MeshArrays cushion() {
    constexpr int kSide = 22;
    constexpr double kSquare = 20, kThick = 90;
    MeshArrays panel = test::planeGrid(kSide, kSide, kSquare);
    const Eigen::RowVector3d middle = panel.V.colwise().mean();
    for (auto point : panel.V.rowwise()) {
        point -= middle;
        const Eigen::Array2d at = point.head<2>().transpose().array() / (kSide * kSquare / 2);
        point.z() = kThick * std::pow(std::max(0.0, (1 - at.square()).prod()), 0.8);
    }
    constexpr double kAtRim = 1e-3;  // two corners would lie on those of the other panel
    panel = test::part(panel, [](const Eigen::RowVector3d& at) { return at.z() > kAtRim; });
    std::vector<int> below;  // of each vertex; at the rim itself
    for (int v = 0; v < panel.V.rows(); ++v) {
        below.push_back(panel.V(v, 2) > kAtRim ? v + static_cast<int>(panel.V.rows()) : v);
    }
    MeshArrays both = test::beside(panel, panel, {0, 0, 0});
    both.V.bottomRows(panel.V.rows()).col(2) *= -1;
    for (Eigen::Index f = 0; f < panel.F.rows(); ++f) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            both.F(panel.F.rows() + f, k) = below[static_cast<std::size_t>(panel.F(f, 2 - k))];
        }
    }
    return both;
}

}  // namespace

class ReadingPicturesTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    void write(const char* file, const PolygonSoup& soup) {
        std::ofstream(fixture_.path(file).toStdString()) << test::objOf(soup);
    }

    bool isDone() {
        return fixture_.waitUntilIdle() &&
               QTest::qWaitFor([this] { return fixture_.window().views().isUpToDate(); },
                               test::kPatience);
    }

    void open(const char* file) {
        fixture_.open({1280, 760}, NewGarment::Pattern);
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        fixture_.window().openFiles({fixture_.path(file)});
        QVERIFY(isDone());
    }

    void keep(const char* name, const QPixmap& picture) {
        test::keepForDocs(QString("input-%1").arg(name), picture);
    }
    void keep(const char* name) {
        QTest::qWait(300);  // what comes a moment later is there
        keep(name, fixture_.window().grab());
    }

    /// The window with a form over it, at a place in it.
    QPixmap withForm(QWidget& form, const QPoint& at) {
        QTest::qWait(300);
        QPixmap picture = fixture_.window().grab();
        QPainter painter(&picture);
        painter.drawPixmap(at, form.grab());
        painter.drawRect(QRect(at, form.size()).adjusted(-1, -1, 0, 0));
        return picture;
    }

    bool isAsked(const char* words) {
        const GarmentCard& card = fixture_.window().card();
        return card.isVisible() && card.sentence().contains(words);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        write("lined T-shirt.obj", linedTshirt(8));
        write("half a T-shirt.obj", test::halfOf(sampleTshirt(), Eigen::Hyperplane<double, 3>(
                                                                     Eigen::Vector3d::UnitX(), 0)));
        test::writeObj(fixture_.path("scanned T-shirt.obj").toStdString(),
                       {{"scan", scannedTshirt()}});
        test::writeObj(fixture_.path("cushion.obj").toStdString(), {{"cushion", cushion()}});
    }

    void cleanup() { fixture_.close(); }

    void layers() {
        open("lined T-shirt.obj");
        QVERIFY(isAsked("contains 2 layers of cloth"));
        keep("layers");
    }

    void half() {
        open("half a T-shirt.obj");
        QVERIFY(isAsked("half a garment"));
        keep("half");
    }

    void solid() {
        open("cushion.obj");
        QVERIFY(isAsked("a closed shape"));
        keep("solid");
    }

    void scanFormAndDebris() {
        open("scanned T-shirt.obj");
        QVERIFY(isAsked("looks like a scan"));
        fixture_.workspace().setAutoCut(true);
        QVERIFY(isDone());
        fixture_.action(ActionId::ReadScan).trigger();
        auto* form = fixture_.window().findChild<ScanForm*>();
        QVERIFY(form);
        QTRY_VERIFY_WITH_TIMEOUT(
            fixture_.find<QLabel>("scanEffect").text().contains("40 fragments"), test::kPatience);
        QVERIFY(isDone());
        keep("scan-form", withForm(*form, {620, 220}));
        QTest::mouseClick(&fixture_.find<QPushButton>("scanDone"), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([this] { return !fixture_.window().findChild<ScanForm*>(); },
                                test::kPatience));
        QVERIFY(fixture_.waitForResults());
        QVERIFY(!fixture_.document().scene()->garmentLines.leftOut.empty());
        keep("debris");
    }
};

TOILE_WINDOW_TEST(ReadingPicturesTest)
#include "reading_pictures_test.moc"
