// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes damaged in whatever way a file may be, and read as whatever a person may say they
// are.
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/prepare/scan_shapes.h"
#include "tests/core/prepare/thick_shapes.h"
#include "tests/core/support/generator.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"
#include "tests/fuzz/check_prepare.h"

namespace toile {
namespace {

/// How often each mesh is damaged, and a large one; each time it is read as one kind.
constexpr int kRounds = 112, kFewRounds = 14, kLarge = 1000;

struct MutatedMesh {
    const char* name;
    PolygonSoup (*make)();
};

PolygonSoup sampleBodice() {
    Progress progress;
    return *readSoup(test::sourceFile("resources/samples/bodice.obj"), progress);
}

PolygonSoup thickTube() {
    return test::thickened(test::asSoup(test::tube(10, 4)));
}

PolygonSoup scannedTube() {
    MeshArrays mesh = test::withNoise(test::withHole(test::tube(16, 8), 0, 80, 25), 0.5);
    return test::asSoup(test::beside(mesh, test::planeGrid(2, 1, 3), {90, 20, 0}));
}

PolygonSoup linedTube() {
    MeshArrays lining = test::tube(9, 4);
    lining.V.col(0) *= 0.9;
    lining.V.col(2) *= 0.8;
    return test::asSoup(test::beside(test::tube(12, 4), lining, {0, 0, 0}));
}

PolygonSoup halfATube() {
    return test::asSoup(test::part(
        test::tube(12, 5), [](const Eigen::RowVector3d& middle) { return middle.x() > 0; }));
}

PolygonSoup looseTorus() {
    return test::looseSoup(test::asSoup(test::piercedTorus(9, 6)));
}

/// A random face goes, comes twice, turns over, or gets a corner that it has already; a position
/// moves a little or far, onto another one, or becomes no number; the whole is tiny, huge or far.
void damage(PolygonSoup& soup, test::Generator& random) {
    const int faces = soup.faceCount();
    const auto vertex = [&] {
        return random.whole(0, static_cast<int>(soup.positions.size()) - 1);
    };
    const int face = random.whole(0, faces - 1);
    const int first = soup.faceStart[face], count = soup.cornerCount(face);
    Eigen::Vector3d& position = soup.positions[vertex()];
    switch (random.whole(0, 9)) {
        case 0:
            soup = test::withoutFaces(soup, {face});
            break;
        case 1:
            for (int k = 0; k < count; ++k) {
                soup.corners.push_back(soup.corners[first + k]);
            }
            soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
            break;
        case 2:
            std::reverse(soup.corners.begin() + first, soup.corners.begin() + first + count);
            break;
        case 3:
            soup.corners[first] = soup.corners[first + random.whole(0, count - 1)];
            break;
        case 4:
            soup.corners[first] = vertex();
            break;
        case 5:
            position += Eigen::Vector3d(random.between(-9, 9), random.between(-9, 9), 0);
            break;
        case 6:
            position = 1e6 * Eigen::Vector3d(random.unit(), random.unit(), random.unit());
            break;
        case 7:
            position = soup.positions[vertex()];
            break;
        case 8:
            position[random.whole(0, 2)] = random.chance(0.5)
                                               ? std::numeric_limits<double>::quiet_NaN()
                                               : std::numeric_limits<double>::infinity();
            break;
        default: {
            const double scales[] = {1e-12, 1e-3, 1e3, 1e12};
            const double scale = scales[random.whole(0, 3)];
            for (Eigen::Vector3d& point : soup.positions) {
                point *= scale;
            }
        }
    }
}

/// Names and a map are not what is damaged here.
PolygonSoup shapeAlone(const PolygonSoup& soup) {
    PolygonSoup bare;
    bare.positions = soup.positions;
    bare.corners = soup.corners;
    bare.faceStart = soup.faceStart;
    return bare;
}

/// Of which new triangles are no more than a fraction: making very many takes its time.
double sizeOf(const PolygonSoup& soup) {
    double size = 0;
    for (const Eigen::Vector3d& position : soup.positions) {
        size = position.allFinite() ? std::max(size, position.cwiseAbs().maxCoeff()) : size;
    }
    return size;
}

Preparation anyPreparation(test::Generator& random, int round, double size) {
    constexpr int kKinds = static_cast<int>(std::size(kFileKindWords));
    Preparation preparing;
    if (const int kind = round % (kKinds + 1); kind < kKinds) {
        preparing.as = kFileKindWords[kind].first;
    }
    preparing.surface = kShellSurfaceWords[random.whole(0, 2)].first;
    preparing.onlyLayer = random.whole(0, 4);
    preparing.isHalf = random.chance(0.3);
    preparing.weldDistance = random.chance(0.5) ? 0 : random.between(0, 5);
    preparing.scan = {random.chance(0.7), random.between(0, 500), random.between(0, 3),
                      random.chance(0.5) ? 0 : size * random.between(0.1, 0.5)};
    return preparing;
}

class MutatedFiles : public testing::TestWithParam<MutatedMesh> {};

TEST_P(MutatedFiles, BreakNoPromiseHoweverTheyAreRead) {
    const PolygonSoup whole = shapeAlone(GetParam().make());
    const int rounds = whole.faceCount() > kLarge ? kFewRounds : kRounds;
    for (int round = 0; round < rounds; ++round) {
        test::Generator random(static_cast<std::uint64_t>(round));
        PolygonSoup soup = whole;
        for (int damages = random.whole(0, 6); damages > 0; --damages) {
            damage(soup, random);
        }
        const Preparation preparing = anyPreparation(random, round, sizeOf(soup));
        ASSERT_EQ(fuzz::whatBreaksInPreparing(std::make_shared<const PolygonSoup>(std::move(soup)),
                                              preparing),
                  "")
            << "round " << round;
    }
}

constexpr MutatedMesh kMutatedMeshes[] = {{"ThickTube", thickTube},   {"ScannedTube", scannedTube},
                                          {"LinedTube", linedTube},   {"HalfATube", halfATube},
                                          {"LooseTorus", looseTorus}, {"Bodice", sampleBodice}};

INSTANTIATE_TEST_SUITE_P(AllMeshes, MutatedFiles, testing::ValuesIn(kMutatedMeshes),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace toile
