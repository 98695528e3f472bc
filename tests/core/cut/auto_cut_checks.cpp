// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/cut/auto_cut_checks.h"

#include <gtest/gtest.h>

#include "tests/core/cut/cut_checks.h"

namespace toile::test {

AutoCut propose(const MeshArrays& mesh, const AutoCutOptions& options) {
    const auto proposal =
        proposeCuts(mesh, buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows())), options);
    EXPECT_TRUE(proposal) << (proposal ? "" : sentence(proposal.error()));
    return proposal ? *proposal : AutoCut{};
}

AutoCut expectOneDisk(const MeshArrays& mesh, const std::string& what,
                      const AutoCutOptions& options) {
    const AutoCut proposal = propose(mesh, options);
    const auto result = applyAutoCut(mesh, proposal);
    EXPECT_TRUE(result) << what;
    if (!result) {
        return proposal;
    }
    if (proposal.holesToFill.empty()) {
        expectValidCut(mesh, *result, what);
    }
    EXPECT_EQ(expectDisks(result->mesh, what), 1) << what;
    for (const PathPolyline& cut : proposal.cuts) {
        EXPECT_GT(cut.length, 0) << what;
    }
    return proposal;
}

}  // namespace toile::test
