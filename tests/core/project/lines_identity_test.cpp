// SPDX-License-Identifier: GPL-3.0-or-later
// What a person has said of a segment stays with that stretch of cloth, whatever else is done.
#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "core/assemble/file_space.h"
#include "core/geometry/segment.h"
#include "core/pattern/facings.h"
#include "core/pattern/notches.h"
#include "core/pattern/pattern.h"
#include "core/pattern/segments.h"
#include "core/pattern/walk.h"
#include "core/project/project_file.h"
#include "core/seam/outline.h"
#include "core/seam/seam_measure.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// What was typed of a segment, and where: the segment as a line in space, on which piece's side.
struct TypedSegment {
    Points3 line;
    PieceId uncut;
    SegmentSettings said;
    double facing = 0;  ///< width of its facing
};

struct LineState {
    Garment garment;
    LoadOptions loading;
    FlattenOptions options{Method::Curvature};
    LineSettings lines;
    std::vector<TypedSegment> typed;
    std::vector<Eigen::RowVector3d> notches;  ///< that were placed by hand
};

double distanceToLine(const Points3& line, const Eigen::RowVector3d& point) {
    double least = 1e300;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        const Eigen::RowVector3d a = line.row(i - 1), b = line.row(i);
        least = std::min(least, geometry::distanceToSegment(point, a, b));
    }
    return least;
}

double lengthOfLine(const Points3& line) {
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1))
        .rowwise()
        .norm()
        .sum();
}

class LineEditor {
public:
    explicit LineEditor(unsigned seed) : random_(seed) {
        Progress progress;
        state_.loading.unit = LengthUnit::Millimetre;
        state_.lines.notches = NotchRules{};
        state_.garment = *loadGarment({path_}, state_.loading, progress);
        draw();
        for (int k = 0; k < 4; ++k) {
            type();
        }
        notch();
        notch();
    }

    void edit() {
        switch (upTo(7)) {
            case 0:
                return type();
            case 5:
                return notch();
            case 1:
                return removeCut();
            case 2:
                return closeAndOpen();
            case 3:
                past_.push_back(state_);
                state_.options.method = upTo(2) == 0 ? Method::Wang2005 : Method::Curvature;
                return;
            case 4:
                if (!past_.empty()) {
                    state_ = past_.back();
                    past_.pop_back();
                }
                return;
            default:
                return cut();
        }
    }

    std::size_t cuts() const { return state_.loading.seams.cuts.size(); }

    void expectAllIsKept() {
        const auto all = segments();
        std::vector<int> found(state_.typed.size(), 0);
        for (std::size_t p = 0; p < all.size(); ++p) {
            const Piece& piece = *state_.garment.pieces[p];
            for (const Segment& segment : all[p].segments) {
                const Points3 line = spaceLine(segment.at, piece);
                const TypedSegment* expected = nullptr;
                for (std::size_t k = 0; k < state_.typed.size(); ++k) {
                    const TypedSegment& typed = state_.typed[k];
                    if (typed.uncut == piece.lineage.uncut.front() && liesOn(line, typed.line)) {
                        expected = &typed;
                        ++found[k];
                    }
                }
                if (expected) {
                    SegmentSettings said = expected->said;
                    said.place = segment.place;
                    EXPECT_EQ(segment.settings, said) << piece.name;
                    EXPECT_EQ(facingWidthAt(segment.place), expected->facing) << piece.name;
                }
            }
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_GT(found[k], 0) << "typed " << *state_.typed[k].said.length;
        }
        expectAllNotches(all);
        expectTheInternalLine();
    }

private:
    int upTo(std::size_t count) { return static_cast<int>(random_() % count); }

    double facingWidthAt(const LineStretch& place) const {
        const auto found =
            std::ranges::find_if(state_.lines.facings,
                                 [&place](const Facing& facing) { return isFaced(place, facing); });
        return found == state_.lines.facings.end() ? 0 : found->width;
    }

    std::vector<OutlineSegments> segments() const {
        Progress progress;
        const PieceResults results = flattenGarment(state_.garment, state_.options, progress);
        return findSegments(state_.garment, results, state_.lines);
    }

    std::vector<std::vector<Notch>> foundNotches(const std::vector<OutlineSegments>& all) const {
        Progress progress;
        return findNotches(state_.garment, flattenGarment(state_.garment, state_.options, progress),
                           all, *state_.lines.notches);
    }

    /// Where a notch is on the garment, on the left side of its seam.
    Eigen::RowVector3d spotOf(const Notch& notch) const {
        const SeamSide& side = state_.garment.seams.seams[notch.seam].left;
        const auto outlines = seam::buildOutlines(state_.garment.pieces);
        const seam::Outline& outline = outlines.list[outlines.indexOf(side)];
        return outline.pointAt(notch.at.left).transpose();
    }

    void expectAllNotches(const std::vector<OutlineSegments>& all) const {
        std::vector<Eigen::RowVector3d> byHand;
        for (const auto& ofSeam : foundNotches(all)) {
            for (const Notch& notch : ofSeam) {
                if (notch.reason == NotchReason::ByHand) {
                    byHand.push_back(spotOf(notch));
                }
            }
        }
        for (const Eigen::RowVector3d& typed : state_.notches) {
            EXPECT_TRUE(std::ranges::any_of(byHand, [&typed](const Eigen::RowVector3d& one) {
                return (one - typed).norm() < 1e-6;
            })) << typed;
        }
    }

    /// A notch on a seam of the division, away from the others.
    void notch() {
        const int seam = upTo(state_.garment.seams.seams.size());
        const Seam& of = state_.garment.seams.seams[seam];
        const double share = 0.1 + 0.01 * upTo(80);
        const auto said = of.matches.empty() || !of.cuts.empty()
                              ? std::nullopt
                              : notchSettingsAt(state_.garment, seam, share);
        if (!said) {
            return;
        }
        const Eigen::RowVector3d spot =
            spotOf({.seam = seam, .share = share, .at = placeAtShare(of, share)});
        if (std::ranges::any_of(state_.notches, [&spot](const Eigen::RowVector3d& other) {
                return (other - spot).norm() < 2 * kNotchGap;
            })) {
            return;
        }
        past_.push_back(state_);
        state_.lines.notches->notches.push_back(*said);
        state_.notches.push_back(spot);
    }

    /// A line within the cloth, between the centres of two triangles of a piece.
    void draw() {
        const Piece& piece = *state_.garment.pieces.front();
        InternalLine& line = state_.lines.internalLines.emplace_back();
        line.name = "pocket";
        for (const Eigen::Index face : {piece.mesh.F.rows() / 3, piece.mesh.F.rows() / 2}) {
            const Eigen::RowVector3d centre =
                (piece.mesh.V.row(piece.mesh.F(face, 0)) + piece.mesh.V.row(piece.mesh.F(face, 1)) +
                 piece.mesh.V.row(piece.mesh.F(face, 2))) /
                3;
            line.points.emplace_back(inFileSpace(centre.transpose(), {}, state_.garment));
        }
    }

    /// It ends where it was drawn, in one part or several, none of which is missing.
    void expectTheInternalLine() const {
        Progress progress;
        const PieceResults results = flattenGarment(state_.garment, state_.options, progress);
        const Pattern pattern = makePattern(state_.garment, results, state_.lines);
        const InternalLine& line = state_.lines.internalLines.front();
        std::vector<Eigen::Vector3d> ends;
        double length = 0;
        for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
            const MeshArrays& mesh = state_.garment.pieces[p]->mesh;
            for (const PieceInternal& part : pattern.pieces[p].internals) {
                EXPECT_EQ(part.name, line.name);
                length += measuredLength(mesh, {part.way, 0});
                ends.push_back(positionOf(mesh, part.way.front()));
                ends.push_back(positionOf(mesh, part.way.back()));
            }
        }
        for (const Eigen::Vector3d& point : line.points) {
            const Eigen::Vector3d there = inPieceSpace(point, {}, state_.garment);
            EXPECT_TRUE(std::ranges::any_of(
                ends, [&there](const auto& end) { return (end - there).norm() < 1e-6; }));
        }
        const double straight = (inPieceSpace(line.points[0], {}, state_.garment) -
                                 inPieceSpace(line.points[1], {}, state_.garment))
                                    .norm();
        EXPECT_GT(length, straight - 1e-6);
        EXPECT_LT(length, 1.5 * straight);
    }

    /// All of the segment is a part of the line.
    static bool liesOn(const Points3& part, const Points3& line) {
        for (Eigen::Index i = 1; i < part.rows(); ++i) {
            if (distanceToLine(line, 0.5 * (part.row(i) + part.row(i - 1))) > 1e-6) {
                return false;
            }
        }
        return true;
    }

    PieceId uncutOf(const SeamSide& side) const {
        return side.piece < 0 ? PieceId{}
                              : state_.garment.pieces[side.piece]->lineage.uncut.front();
    }

    /// A length for a segment of a rim of the division, of which nothing has been said.
    void type() {
        const auto all = segments();
        std::vector<std::pair<std::size_t, const Segment*>> free;
        for (std::size_t p = 0; p < all.size(); ++p) {
            const Piece& piece = *state_.garment.pieces[p];
            for (const Segment& segment : all[p].segments) {
                const Points3 line = spaceLine(segment.at, piece);
                const Seam* seam =
                    segment.seam >= 0 ? &state_.garment.seams.seams[segment.seam] : nullptr;
                // A piece that is sewn to itself, or was before it was cut, has two segments in one
                // place.
                const bool isCut =
                    seam && (!seam->cuts.empty() || uncutOf(seam->left) == uncutOf(seam->right));
                const bool isTyped =
                    std::ranges::any_of(state_.typed, [&](const TypedSegment& typed) {
                        return liesOn(line, typed.line) || liesOn(typed.line, line);
                    });
                if (!isCut && !isTyped && lengthOfLine(line) > 20) {
                    free.emplace_back(p, &segment);
                }
            }
        }
        if (free.empty()) {
            return;
        }
        past_.push_back(state_);
        const auto& [p, segment] = free[static_cast<std::size_t>(upTo(free.size()))];
        const Piece& piece = *state_.garment.pieces[p];
        ++count_;
        const SegmentSettings said{.place = segment->place,
                                   .length = segment->length() + 0.001 * count_,
                                   .tolerance = 0.5 + 0.001 * count_,
                                   .straight = upTo(2) == 0,
                                   .allowance = 5 + 0.001 * count_,
                                   .corner = static_cast<CornerRule>(upTo(7)),
                                   .extension = 2 + 0.001 * count_};
        state_.lines.segments.push_back(said);
        state_.lines.facings.push_back({"facing", {segment->place}, 20 + 0.001 * count_});
        state_.typed.push_back({spaceLine(segment->at, piece), piece.lineage.uncut.front(), said,
                                state_.lines.facings.back().width});
    }

    void recut(LoadOptions loading) {
        Progress progress;
        past_.push_back(state_);
        state_.garment = *cutGarment(state_.garment, loading, progress);
        state_.loading = resolveNames(std::move(loading), state_.garment);
    }

    /// From a corner of the outline to the middle of the cloth, or to another corner.
    void cut() {
        const auto pieces = state_.garment.pieces.size();
        const Piece& piece = *state_.garment.pieces[static_cast<std::size_t>(upTo(pieces))];
        LoadOptions loading = state_.loading;
        UserCut& cut = loading.seams.cuts.emplace_back();
        cut.name = "cut " + std::to_string(++count_);
        const auto place = [&](int vertex) {
            cut.points.emplace_back(piece.mesh.V.row(vertex).transpose());
        };
        place(piece.boundary[static_cast<std::size_t>(upTo(piece.boundary.size()))]);
        place(upTo(static_cast<std::size_t>(piece.mesh.V.rows())));
        recut(std::move(loading));
    }

    void removeCut() {
        LoadOptions loading = state_.loading;
        auto& cuts = loading.seams.cuts;
        if (!cuts.empty()) {
            cuts.erase(cuts.begin() + upTo(cuts.size()));
            recut(std::move(loading));
        }
    }

    void closeAndOpen() {
        Project project;
        project.files = meshReferences(state_.garment);
        project.loading = state_.loading;
        project.loading.known = knownPieces(state_.garment);
        project.options = state_.options;
        project.lines = state_.lines;
        const auto read = parseProject(projectText(project, "/"), "a.toile", "/");
        ASSERT_TRUE(read);
        Progress progress;
        past_.push_back(state_);
        state_.garment = *loadGarment({path_}, read->project.loading, progress);
        state_.loading = resolveNames(read->project.loading, state_.garment);
        state_.lines = read->project.lines;
        state_.options = read->project.options;
    }

    const std::filesystem::path path_ = test::dataFile("samples/tshirt.obj");
    std::mt19937 random_;
    LineState state_;
    std::vector<LineState> past_;
    int count_ = 0;
};

class LinesIdentity : public testing::TestWithParam<unsigned> {};

TEST_P(LinesIdentity, WhatWasSaidOfSegmentsStaysThroughRandomEdits) {
    LineEditor editor(GetParam());
    editor.expectAllIsKept();
    for (int k = 0; k < 15 && !HasFailure(); ++k) {
        if (editor.cuts() < 5) {
            editor.edit();
            editor.expectAllIsKept();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, LinesIdentity, testing::Range(1U, 7U));

}  // namespace
}  // namespace toile
