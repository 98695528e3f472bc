// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/body_file.h"

#include <gtest/gtest.h>

#include "core/toile/pipeline.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

constexpr const char* kWorn = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\no flap\nf 1 2 3\nf 1 3 4\n";
/// Two tetrahedra, the second inside out.
constexpr const char* kTwoBodies =
    "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nv 9 0 0\nv 13 0 0\nv 9 4 0\nv 9 0 4\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 5 6 7\nf 5 8 6\nf 6 8 7\nf 5 7 8\n";

Garment wornGarment(const test::TemporaryFolder& folder) {
    Progress progress;
    LoadOptions options;
    options.unit = LengthUnit::Centimetre;
    return *loadGarment({folder.write("worn.obj", kWorn)}, options, progress);
}

double enclosed(const MeshArrays& mesh) {
    double volume = 0;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        volume += doubleAreaNormal(mesh, f).dot(mesh.V.row(mesh.F(f, 0)).transpose()) / 6;
    }
    return volume;
}

TEST(BodyFile, IsInTheUnitOfTheGarmentWithFacesOutwards) {
    const test::TemporaryFolder folder;
    const Garment garment = wornGarment(folder);
    Progress progress;
    const auto path = folder.write("bodies.obj", kTwoBodies);
    const auto body = readBody(path, std::nullopt, garment, progress);
    ASSERT_TRUE(body);
    EXPECT_NEAR(enclosed(*body), 2 * 40.0 * 40 * 40 / 6, 1e-6);
    EXPECT_TRUE(isNear(*body, garment));
    const auto stated = readBody(path, FileUnit(LengthUnit::Millimetre), garment, progress);
    ASSERT_TRUE(stated);
    EXPECT_NEAR(enclosed(*stated), 2 * 4.0 * 4 * 4 / 6, 1e-6);
}

TEST(BodyFile, ElsewhereIsNotNear) {
    const test::TemporaryFolder folder;
    const Garment garment = wornGarment(folder);
    Progress progress;
    const auto path = folder.write("far.obj", "v 0 0 50\nv 1 0 50\nv 0 1 50\nf 1 2 3\n");
    const auto body = readBody(path, std::nullopt, garment, progress);
    ASSERT_TRUE(body);
    EXPECT_FALSE(isNear(*body, garment));
}

TEST(BodyFile, WithoutFacesIsRefused) {
    const test::TemporaryFolder folder;
    const Garment garment = wornGarment(folder);
    Progress progress;
    const auto none = readBody(folder.write("none.obj", "v 0 0 0\n"), {}, garment, progress);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NoGeometry);
    const auto flat = readBody(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), {},
                               garment, progress);
    ASSERT_FALSE(flat);
    EXPECT_EQ(flat.error().code, ErrorCode::NoGeometry);
    EXPECT_FALSE(readBody(folder / "missing.obj", {}, garment, progress));
}

}  // namespace
}  // namespace toile
