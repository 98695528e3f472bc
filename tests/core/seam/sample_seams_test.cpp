// SPDX-License-Identifier: GPL-3.0-or-later
// Our own samples: what is sewn to what is known from how they are made.
#include <map>

#include <gtest/gtest.h>

#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/seam/seam_shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// Names without their numbers, and how many of each.
std::map<std::string, int> counted(const SeamGraph& graph) {
    std::map<std::string, int> count;
    for (const Seam& seam : graph.seams) {
        std::string name = seam.name;
        const std::size_t end = name.find_last_not_of("0123456789 ");
        name.resize(end + 1);
        if (name.ends_with(", seam")) {
            name.resize(name.size() - 6);
        }
        ++count[name];
    }
    return count;
}

SeamGraph graphOf(const char* file) {
    Progress progress;
    const auto path = test::dataFile(std::string("samples/") + file);
    const auto garment = loadGarment({path}, {.unit = LengthUnit::Millimetre}, progress);
    EXPECT_TRUE(garment);
    SeamGraph graph = findSeams(garment->pieces);
    test::expectValid(graph, garment->pieces);
    for (const Seam& seam : graph.seams) {
        if (seam.kind != SeamKind::Free) {
            EXPECT_NEAR(seam.length3d[0], seam.length3d[1], 1e-9) << seam.name;
            EXPECT_LT(seam.gap, 1e-9) << seam.name;
            EXPECT_FALSE(seam.stacked) << seam.name;
        }
    }
    return graph;
}

using Count = std::map<std::string, int>;

TEST(SampleSeams, TShirt) {
    EXPECT_EQ(counted(graphOf("tshirt.obj")), (Count{{"back / neckband", 2},
                                                     {"back / sleeve_left", 1},
                                                     {"back / sleeve_right", 1},
                                                     {"back, free edge", 1},
                                                     {"front / back", 4},
                                                     {"front / neckband", 1},
                                                     {"front / sleeve_left", 1},
                                                     {"front / sleeve_right", 1},
                                                     {"front, free edge", 1},
                                                     {"neckband / itself", 1},
                                                     {"neckband, free edge", 1},
                                                     {"sleeve_left / itself", 1},
                                                     {"sleeve_left, free edge", 1},
                                                     {"sleeve_right / itself", 1},
                                                     {"sleeve_right, free edge", 1}}));
}

TEST(SampleSeams, Bodice) {
    EXPECT_EQ(counted(graphOf("bodice.obj")), (Count{{"back_left / back_right", 1},
                                                     {"back_left, free edge", 2},
                                                     {"back_right, free edge", 2},
                                                     {"front / back_left", 1},
                                                     {"front / back_right", 1},
                                                     {"front / side_front_left", 1},
                                                     {"front / side_front_right", 1},
                                                     {"front, free edge", 2},
                                                     {"side_back_left / back_left", 1},
                                                     {"side_back_left, free edge", 2},
                                                     {"side_back_right / back_right", 1},
                                                     {"side_back_right, free edge", 2},
                                                     {"side_front_left / side_back_left", 2},
                                                     {"side_front_left, free edge", 2},
                                                     {"side_front_right / side_back_right", 2},
                                                     {"side_front_right, free edge", 2}}));
}

TEST(SampleSeams, Trousers) {
    EXPECT_EQ(counted(graphOf("trousers.obj")), (Count{{"back_left / back_right", 1},
                                                       {"back_left / waistband", 1},
                                                       {"back_left, free edge", 1},
                                                       {"back_right / waistband", 1},
                                                       {"back_right, free edge", 1},
                                                       {"front_left / back_left", 2},
                                                       {"front_left / front_right", 1},
                                                       {"front_left / waistband", 1},
                                                       {"front_left, free edge", 1},
                                                       {"front_right / back_right", 2},
                                                       {"front_right / waistband", 1},
                                                       {"front_right, free edge", 1},
                                                       {"waistband / itself", 1},
                                                       {"waistband, free edge", 1}}));
}

TEST(SampleSeams, Cap) {
    EXPECT_EQ(counted(graphOf("cap.obj")), (Count{{"back_left / back_right", 1},
                                                  {"back_left, free edge", 1},
                                                  {"back_right, free edge", 1},
                                                  {"front_left / front_right", 1},
                                                  {"front_left / peak", 1},
                                                  {"front_left / side_left", 1},
                                                  {"front_right / peak", 1},
                                                  {"front_right / side_right", 1},
                                                  {"peak, free edge", 1},
                                                  {"side_left / back_left", 1},
                                                  {"side_left / peak", 1},
                                                  {"side_left, free edge", 1},
                                                  {"side_right / back_right", 1},
                                                  {"side_right / peak", 1},
                                                  {"side_right, free edge", 1}}));
}

TEST(SampleSeams, Skirt) {
    EXPECT_EQ(counted(graphOf("skirt.obj")), (Count{{"back / waistband", 2},
                                                    {"back, free edge", 1},
                                                    {"front / side_front_left", 1},
                                                    {"front / side_front_right", 1},
                                                    {"front / waistband", 1},
                                                    {"front, free edge", 1},
                                                    {"side_back_left / back", 1},
                                                    {"side_back_left / waistband", 1},
                                                    {"side_back_left, free edge", 1},
                                                    {"side_back_right / back", 1},
                                                    {"side_back_right / waistband", 1},
                                                    {"side_back_right, free edge", 1},
                                                    {"side_front_left / side_back_left", 1},
                                                    {"side_front_left / waistband", 1},
                                                    {"side_front_left, free edge", 1},
                                                    {"side_front_right / side_back_right", 1},
                                                    {"side_front_right / waistband", 1},
                                                    {"side_front_right, free edge", 1},
                                                    {"waistband / itself", 1},
                                                    {"waistband, free edge", 1}}));
}

}  // namespace
}  // namespace toile
