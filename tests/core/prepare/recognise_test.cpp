// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/recognise.h"

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/cut/cut_shapes.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

FileSurface asFile(MeshArrays mesh) {
    FileSurface surface{std::move(mesh), {}};
    for (int f = 0; f < surface.mesh.F.rows(); ++f) {
        surface.face.push_back(f);
    }
    return surface;
}

MeshArrays both(const MeshArrays& a, const MeshArrays& b) {
    MeshArrays joined{Points3(a.V.rows() + b.V.rows(), 3), Triangles(a.F.rows() + b.F.rows(), 3)};
    joined.V << a.V, b.V;
    joined.F << a.F, (b.F.array() + static_cast<int>(a.V.rows())).matrix();
    return joined;
}

MeshArrays scaled(MeshArrays mesh, double across, double along) {
    mesh.V.col(0) *= across;
    mesh.V.col(2) *= across;
    mesh.V.col(1) *= along;
    return mesh;
}

FileKind kindOf(const MeshArrays& mesh) {
    return recognise(asFile(mesh), Progress()).kind;
}

TEST(Recognise, OneSurfaceIsASheet) {
    EXPECT_EQ(kindOf(test::planeGrid(8, 8, 20)), FileKind::Sheet);
    EXPECT_EQ(kindOf(test::tube(24, 9)), FileKind::Sheet);
    EXPECT_EQ(kindOf(test::sphericalCap(8, 100, 1.2)), FileKind::Sheet);
    EXPECT_EQ(kindOf({Points3(0, 3), Triangles(0, 3)}), FileKind::Sheet);
}

TEST(Recognise, ACushionIsASolidThoughItsCornersAreFolded) {
    constexpr int kSide = 16;
    MeshArrays panel = test::planeGrid(kSide, kSide, 20);
    const Eigen::RowVector3d middle = panel.V.colwise().mean();
    std::vector<int> below;
    for (int v = 0; v < panel.V.rows(); ++v) {
        panel.V.row(v) -= middle;
        const Eigen::Array2d at = panel.V.row(v).head<2>().transpose().array() / (kSide * 10);
        panel.V(v, 2) = 60 * (1 - at.square()).prod();
        below.push_back(panel.V(v, 2) > 1e-3 ? v + static_cast<int>(panel.V.rows()) : v);
    }
    MeshArrays back = panel;
    back.V.col(2) *= -1;
    back.F.col(1).swap(back.F.col(2));
    MeshArrays cushion = both(panel, back);
    for (Eigen::Index f = panel.F.rows(); f < cushion.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            cushion.F(f, k) = below[cushion.F(f, k) - panel.V.rows()];
        }
    }
    EXPECT_EQ(kindOf(cushion), FileKind::Solid);
}

TEST(Recognise, AClosedFormIsASolid) {
    EXPECT_EQ(kindOf(test::octahedron()), FileKind::Solid);
    EXPECT_EQ(kindOf(test::sphere(16)), FileKind::Solid);
    EXPECT_EQ(kindOf(test::closedTorus(32, 16)), FileKind::Solid);
}

TEST(Recognise, ALiningInItsShellIsLayers) {
    const MeshArrays shell = test::tube(24, 9);
    MeshArrays lining = scaled(test::tube(17, 5), 0.85, 1.7);
    lining.V.col(2) *= 0.7;  // nearer here than there, as no shell's other surface
    const Recognition found = recognise(asFile(both(shell, lining)), Progress());
    EXPECT_EQ(found.kind, FileKind::Layers) << found.evidence;
    MeshArrays beside = shell;
    beside.V.col(0).array() += 300;
    EXPECT_EQ(kindOf(both(shell, beside)), FileKind::Sheet) << "two legs are no layers";
}

TEST(Recognise, TwoPanelsBehindEachOtherStay) {
    const MeshArrays front = test::planeGrid(12, 12, 40);
    MeshArrays back = front;
    back.V.col(2).array() -= 8;
    back.F.col(1).swap(back.F.col(2));
    const Recognition found = recognise(asFile(both(front, back)), Progress());
    EXPECT_EQ(found.kind, FileKind::Layers);
    EXPECT_TRUE(found.shell) << "a person may say that it is one";
    EXPECT_NE(found.evidence.find("8.0 mm"), std::string::npos) << found.evidence;
}

TEST(Recognise, FacesForBothSidesAreNoSolid) {
    const MeshArrays tube = test::tube(24, 9);
    MeshArrays doubled{tube.V, Triangles(2 * tube.F.rows(), 3)};
    doubled.F << tube.F, tube.F.rowwise().reverse();
    EXPECT_EQ(kindOf(doubled), FileKind::Sheet);
}

TEST(Recognise, PilesOfEqualTrianglesTakeNoTime) {
    Points3 V(6, 3);
    V << 0, 0, 0, 400, 0, 0, 0, 400, 0, 0, 0, -8, 400, 0, -8, 0, 400, -8;
    Triangles F(20'000, 3);
    for (int f = 0; f < F.rows(); ++f) {
        F.row(f) << (f % 2 == 0 ? Eigen::RowVector3i(0, 1, 2) : Eigen::RowVector3i(3, 5, 4));
    }
    EXPECT_NE(kindOf({V, F}), FileKind::Scan);  // and it ends
}

TEST(Recognise, FragmentsMakeAScanAndButtonsDoNot) {
    MeshArrays scan = test::planeGrid(40, 40, 20), shirt = scan;
    for (int k = 0; k < 6; ++k) {
        MeshArrays fragment = test::planeGrid(1 + k % 3, 1 + k / 3, 2.0 + k);
        fragment.V.rowwise() += Eigen::RowVector3d(100.0 * k, 50, 30);
        scan = both(scan, fragment);
        MeshArrays button = scaled(test::octahedron(), 5, 5);
        button.V.rowwise() += Eigen::RowVector3d(400, 100.0 * k, 10);
        shirt = both(shirt, button);
    }
    const Recognition found = recognise(asFile(scan), Progress());
    EXPECT_EQ(found.kind, FileKind::Scan);
    EXPECT_NE(found.evidence.find("6 fragments"), std::string::npos) << found.evidence;
    EXPECT_EQ(kindOf(shirt), FileKind::Sheet);
}

class RecogniseFile : public testing::TestWithParam<std::pair<const char*, FileKind>> {};

TEST_P(RecogniseFile, AsWhatItIs) {
    const auto& [name, kind] = GetParam();
    const auto path = test::dataFile(name);
    TOILE_NEEDS_SHARED(path);
    Progress progress;
    const auto soup = readSoup(path, progress);
    ASSERT_TRUE(soup);
    const Recognition found = recognise(surfaceOf(*soup, 10), progress);
    EXPECT_EQ(wordOf(kFileKindWords, found.kind), wordOf(kFileKindWords, kind)) << found.evidence;
}

INSTANTIATE_TEST_SUITE_P(Files, RecogniseFile,
                         testing::Values(std::pair("samples/tshirt.obj", FileKind::Sheet),
                                         std::pair("samples/skirt.obj", FileKind::Sheet),
                                         std::pair("samples/trousers.obj", FileKind::Sheet),
                                         std::pair("samples/bodice.obj", FileKind::Sheet),
                                         std::pair("samples/cap.obj", FileKind::Sheet),
                                         std::pair("garments/dress.obj", FileKind::Sheet),
                                         std::pair("garments/tee_sim.obj", FileKind::Sheet),
                                         std::pair("garments/tee_sim_pieces.obj", FileKind::Sheet),
                                         std::pair("garments/polo.obj", FileKind::Sheet),
                                         std::pair("garments/polo_pieces.obj", FileKind::Sheet),
                                         std::pair("garments/longsleeve.obj", FileKind::Sheet),
                                         std::pair("garments/skirt_clo.obj", FileKind::Sheet),
                                         std::pair("garments/leggings.ply", FileKind::Sheet),
                                         std::pair("garments/suit_mh.obj", FileKind::Sheet),
                                         std::pair("thick/tee_sim_thick.obj", FileKind::Shell),
                                         std::pair("thick/dress_thick.obj", FileKind::Shell),
                                         std::pair("scans/dress_scan.obj", FileKind::Scan),
                                         std::pair("nasty/hand_closed.off", FileKind::Solid),
                                         std::pair("nasty/knot_torus.off", FileKind::Solid),
                                         std::pair("nasty/boeing.off", FileKind::Sheet),
                                         std::pair("disks/face.obj", FileKind::Sheet)),
                         [](const auto& file) {
                             std::string word = file.param.first;
                             std::ranges::replace_if(
                                 word, [](char c) { return c == '/' || c == '.'; }, '_');
                             return word;
                         });

}  // namespace
}  // namespace toile
