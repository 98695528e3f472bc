// SPDX-License-Identifier: GPL-3.0-or-later
// The sample garments are what the generator makes, and every piece is fit to be flattened.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "sample_mesh.h"

namespace toile::samples {

namespace {

/// A folder of its own for one test, removed at the end.
class ScratchFolder {
public:
    ScratchFolder() {
        const auto ticks = std::chrono::steady_clock::now().time_since_epoch().count();
        path_ = std::filesystem::temp_directory_path() / ("toile-samples-" + std::to_string(ticks));
        std::filesystem::create_directories(path_);
    }

    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Pieces that are sewn to themselves: only there may two vertices share a place.
bool hasSelfSeam(const std::string& name) {
    return name.starts_with("sleeve") || name == "neckband" || name == "waistband";
}

std::set<int> outlineVertices(const SamplePiece& piece) {
    std::set<int> vertices;
    for (const auto& [a, b] : outlineSides(piece)) {
        vertices.insert(a);
    }
    return vertices;
}

/// Length of the outline loop that starts at the first side, in sides.
std::size_t firstLoop(const std::vector<Side>& outline) {
    std::map<int, int> next(outline.begin(), outline.end());
    std::size_t count = 0;
    int vertex = outline.front().first;
    do {
        vertex = next.at(vertex);
        ++count;
    } while (vertex != outline.front().first && count <= outline.size());
    return count;
}

/// Triangles by their places, each turned so that the smallest place comes first.
std::multiset<std::array<Place, 3>> placedTriangles(const SamplePiece& piece, bool mirrored) {
    std::multiset<std::array<Place, 3>> triangles;
    for (const auto& corners : piece.triangles) {
        std::array<Place, 3> places;
        for (std::size_t k = 0; k < 3; ++k) {
            places[k] = piece.vertices[static_cast<std::size_t>(corners[k])];
            places[k][0] *= mirrored ? -1 : 1;
        }
        if (mirrored) {
            std::swap(places[1], places[2]);
        }
        std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
        triangles.insert(places);
    }
    return triangles;
}

class Samples : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        ASSERT_GE(pieces_.size(), 5U);
        for (const SamplePiece& piece : pieces_) {
            ASSERT_GT(piece.triangles.size(), 100U) << piece.name;
        }
    }

    std::vector<SamplePiece> pieces_ = loadSample(GetParam());
};

INSTANTIATE_TEST_SUITE_P(All, Samples, testing::ValuesIn(sampleNames()),
                         [](const auto& param) { return param.param; });

}  // namespace

TEST(SampleGenerator, ReproducesTheCommittedFiles) {
    const ScratchFolder folder;
    std::string command;
    command.append("\"").append(TOILE_MAKE_SAMPLES).append("\" \"");
    command.append(folder.path().string()).append("\"");
#ifdef _WIN32
    command.insert(0, "\"").append("\"");  // cmd.exe strips one pair of quotes
#endif
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    std::size_t written = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
        if (entry.is_directory()) {
            continue;
        }
        const std::filesystem::path committed =
            std::filesystem::path(TOILE_SAMPLES_DIR) /
            std::filesystem::relative(entry.path(), folder.path());
        EXPECT_TRUE(readBytes(entry.path()) == readBytes(committed))
            << committed << " is not what the generator makes; see resources/samples/README.md";
        ++written;
    }
    EXPECT_EQ(written, sampleNames().size() + 1);  // and the cube
}

TEST(CubeSample, IsADiskOf768TrianglesOpenedAlongFiveEdges) {
    const std::vector<SamplePiece> pieces = loadSample("shapes/cube-h");
    ASSERT_EQ(pieces.size(), 1U);
    const SamplePiece& cube = pieces.front();
    EXPECT_EQ(cube.triangles.size(), 768U);
    const std::map<Side, int> sides = countSides(cube);
    for (const auto& [side, count] : sides) {
        ASSERT_EQ(count, 1) << "side " << side.first << "-" << side.second;
    }
    const std::vector<Side> outline = outlineSides(cube);
    EXPECT_EQ(outline.size(), 80U);  // five edges of eight squares, from both sides
    EXPECT_EQ(firstLoop(outline), outline.size());
    const std::size_t edges = (sides.size() + outline.size()) / 2;
    EXPECT_EQ(cube.vertices.size() + cube.triangles.size(), edges + 1);
    EXPECT_TRUE(placedTriangles(cube, true) == placedTriangles(cube, false));
}

TEST_P(Samples, EveryPieceIsOneManifoldDisk) {
    for (const SamplePiece& piece : pieces_) {
        SCOPED_TRACE(piece.name);
        const std::map<Side, int> sides = countSides(piece);
        for (const auto& [side, count] : sides) {
            ASSERT_EQ(count, 1) << "side " << side.first << "-" << side.second;
        }
        const std::vector<Side> outline = outlineSides(piece);
        ASSERT_EQ(outlineVertices(piece).size(), outline.size());
        EXPECT_EQ(firstLoop(outline), outline.size()) << "more than one outline loop";

        std::set<int> used;
        for (const auto& [side, count] : sides) {
            used.insert(side.first);
        }
        EXPECT_EQ(used.size(), piece.vertices.size()) << "loose vertices";
        // One loop and this count also make the piece connected: V - E + F = 1.
        const std::size_t edges = (sides.size() + outline.size()) / 2;
        EXPECT_EQ(piece.vertices.size() + piece.triangles.size(), edges + 1);
    }
}

TEST_P(Samples, VerticesShareAPlaceOnSelfSeamsOnly) {
    for (const SamplePiece& piece : pieces_) {
        SCOPED_TRACE(piece.name);
        const std::set<int> outline = outlineVertices(piece);
        std::map<Place, int> seen;
        for (int v = 0; v < static_cast<int>(piece.vertices.size()); ++v) {
            const auto [other, isNew] =
                seen.emplace(piece.vertices[static_cast<std::size_t>(v)], v);
            if (!isNew) {
                EXPECT_TRUE(hasSelfSeam(piece.name));
                EXPECT_TRUE(outline.contains(v) && outline.contains(other->second));
            }
        }
    }
}

TEST_P(Samples, TrianglesAreWellShaped) {
    constexpr double kMinAngle = 20.0 * std::numbers::pi / 180.0;
    constexpr double kGreatestAngle = 125.0 * std::numbers::pi / 180.0;
    for (const SamplePiece& piece : pieces_) {
        SCOPED_TRACE(piece.name);
        for (const auto& corners : piece.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto at = [&](std::size_t slot) {
                    return piece.vertices[static_cast<std::size_t>(corners[slot % 3])];
                };
                const double angle = angleAt(at(k), at(k + 1), at(k + 2));
                EXPECT_GT(angle, kMinAngle);
                EXPECT_LT(angle, kGreatestAngle);
            }
        }
    }
}

TEST_P(Samples, InnerEdgesJoinOutlineVerticesAtSharpTipsOnly) {
    for (const SamplePiece& piece : pieces_) {
        SCOPED_TRACE(piece.name);
        const std::set<int> outline = outlineVertices(piece);
        const std::map<Side, int> sides = countSides(piece);
        int bridges = 0;
        for (const auto& [side, count] : sides) {
            bridges += side.first < side.second && sides.contains({side.second, side.first}) &&
                               outline.contains(side.first) && outline.contains(side.second)
                           ? 1
                           : 0;
        }
        const bool isPeak = piece.name == "peak";
        EXPECT_LE(bridges, isPeak ? 2 : (GetParam() == "cap" ? 1 : 0));
    }
}

TEST_P(Samples, CurvatureIsThatOfClothing) {
    constexpr double kMax = 1.5;  // radians: 2 pi minus the angle sum, over the inner vertices
    for (const SamplePiece& piece : pieces_) {
        SCOPED_TRACE(piece.name);
        const std::set<int> outline = outlineVertices(piece);
        double curvature =
            2.0 * std::numbers::pi * static_cast<double>(piece.vertices.size() - outline.size());
        for (const auto& corners : piece.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto at = [&](std::size_t slot) {
                    return piece.vertices[static_cast<std::size_t>(corners[slot % 3])];
                };
                if (!outline.contains(corners[k])) {
                    curvature -= angleAt(at(k), at(k + 1), at(k + 2));
                }
            }
        }
        EXPECT_LT(std::abs(curvature), kMax);
    }
}

TEST_P(Samples, IsMirrorSymmetric) {
    for (const SamplePiece& piece : pieces_) {
        SCOPED_TRACE(piece.name);
        const SamplePiece& partner = pieceNamed(pieces_, otherSide(piece.name));
        EXPECT_TRUE(placedTriangles(piece, true) == placedTriangles(partner, false));
    }
}

TEST(SampleSizes, ArePlausibleForAnAdult) {
    struct Expected {
        std::string name;
        std::size_t pieces;
        Place low, high;  // mm; each bound may be off by kSlack
    };

    constexpr long long kSlack = 15;
    constexpr long long kUnitsPerMillimetre = 10000;
    const std::vector<Expected> table{
        {"tshirt", 5, {-395, 800, -146}, {395, 1480, 140}},
        {"bodice", 7, {-163, 985, -118}, {163, 1450, 128}},
        {"trousers", 5, {-189, 85, -148}, {189, 1078, 117}},
        {"cap", 7, {-82, 1624, -99}, {82, 1762, 169}},
        {"skirt", 7, {-327, 440, -289}, {327, 1076, 289}},
    };
    for (const Expected& expected : table) {
        SCOPED_TRACE(expected.name);
        const std::vector<SamplePiece> pieces = loadSample(expected.name);
        EXPECT_EQ(pieces.size(), expected.pieces);
        Place low = pieces.front().vertices.front();
        Place high = low;
        std::size_t triangles = 0;
        for (const SamplePiece& piece : pieces) {
            triangles += piece.triangles.size();
            for (const Place& place : piece.vertices) {
                for (std::size_t k = 0; k < 3; ++k) {
                    low[k] = std::min(low[k], place[k]);
                    high[k] = std::max(high[k], place[k]);
                }
            }
        }
        EXPECT_GE(triangles, 2000U);
        EXPECT_LE(triangles, 6000U);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LE(std::abs(low[k] / kUnitsPerMillimetre - expected.low[k]), kSlack);
            EXPECT_LE(std::abs(high[k] / kUnitsPerMillimetre - expected.high[k]), kSlack);
        }
    }
}

}  // namespace toile::samples
