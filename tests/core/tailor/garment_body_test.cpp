// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/garment_body.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/core/support/shapes.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

GarmentBody bodyOf(const MeshArrays& mesh) {
    const auto body = readBody(test::asPiece(mesh));
    EXPECT_TRUE(body);
    return body ? *body : GarmentBody{};
}

TEST(GarmentBody, AShirtHasNeckHemAndCuffs) {
    const GarmentBody body = bodyOf(test::wornShirt());
    EXPECT_EQ(body.form, BodyForm::Top);
    ASSERT_EQ(body.openings.size(), 4U);
    ASSERT_TRUE(body.find(OpeningKind::Neck) && body.find(OpeningKind::Hem));
    EXPECT_NEAR(body.height(body.find(OpeningKind::Hem)->centre), 0, 1e-9);
    const auto cuffs = body.pair(OpeningKind::Cuff);
    ASSERT_TRUE(cuffs);
    EXPECT_NEAR(body.across((*cuffs)[0]->centre), -360, 1e-6);
    EXPECT_NEAR(body.across((*cuffs)[1]->centre), 360, 1e-6);
    EXPECT_LT(body.plane.deviation, 1e-6);
    EXPECT_GT(body.forward.z(), 0.99);  // where the neck is low
    EXPECT_EQ(body.isLeftAcross(), body.plane.normal.x() > 0);
}

TEST(GarmentBody, TrousersAndSkirtsAreToldApart) {
    const GarmentBody trousers = bodyOf(test::wornTrousers());
    EXPECT_EQ(trousers.form, BodyForm::Trousers);
    EXPECT_TRUE(trousers.pair(OpeningKind::Ankle));
    const GarmentBody skirt = bodyOf(test::wornSkirt());
    EXPECT_EQ(skirt.form, BodyForm::Skirt);
    EXPECT_GT(skirt.height(skirt.find(OpeningKind::Waist)->centre),
              skirt.height(skirt.find(OpeningKind::Hem)->centre));
}

TEST(GarmentBody, LeftIsToldFromRightThoughFrontAndBackAreMoreAlike) {
    MeshArrays mesh = test::wornTrousers();
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        if (mesh.V(v, 0) > 20 && mesh.V(v, 1) < 300) {
            mesh.V(v, 0) += 30;  // one leg hangs outwards
        }
        if (mesh.V(v, 1) > 770) {
            mesh.V(v, 1) = 770;  // front and back are of one height
        }
    }
    EXPECT_EQ(bodyOf(mesh).form, BodyForm::Trousers);
}

TEST(GarmentBody, ItIsTheSameHoweverOneTurnsAboutTheHeight) {
    MeshArrays mesh = test::wornShirt();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()).toRotationMatrix();
    mesh.V = (mesh.V * turn.transpose()).rowwise() + Eigen::RowVector3d(500, -20, 90);
    const GarmentBody body = bodyOf(mesh);
    EXPECT_EQ(body.form, BodyForm::Top);
    EXPECT_GT(body.forward.dot(turn * Eigen::Vector3d::UnitZ()), 0.99);
}

TEST(GarmentBody, WhatIsNotWornHasNoForm) {
    for (const MeshArrays& mesh : {test::octahedron(), test::piercedTorus(24, 12)}) {
        const auto body = readBody(test::asPiece(mesh));
        EXPECT_TRUE(!body || body->form == BodyForm::Unknown);
    }
}

}  // namespace
}  // namespace toile
