// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "core/flatten/flatten.h"
#include "core/garment/piece.h"

namespace toile::test {

/// The piece's flat points by a method; a piece that cannot be flattened fails the test.
inline Points2 flatOf(const Piece& piece, Method method) {
    FlattenOptions options;
    options.method = method;
    Progress progress;
    const auto flat = flatten(piece, options, progress);
    EXPECT_TRUE(flat) << (flat ? "" : sentence(flat.error()));
    return flat ? flat->Q : Points2(Points2::Zero(piece.mesh.V.rows(), 2));
}

}  // namespace toile::test
