// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/garmentcode_panels.h"

#include <algorithm>
#include <map>

#include <Eigen/SVD>

#include "core/export/curve_parts.h"
#include "core/pattern/piece_curves.h"

namespace toile {
namespace {

/// A curve is divided if the distance of its ends is less than this share of its length, because
/// control points are relative to the chord.
constexpr double kMinChord = 0.2;

void addHalved(const CubicCurve& curve, std::vector<CubicCurve>& chain) {
    const double length = curveLength(curve);
    if (!(length > 0)) {
        return;
    }
    if (!curve.isLine && (curve.end - curve.start).norm() < kMinChord * length) {
        const auto halves = dividedAt(curve, 0.5);
        chain.insert(chain.end(), halves.begin(), halves.end());
    } else {
        chain.push_back(curve);
    }
}

/// One side of a seam: consecutive segments of one piece.
struct SeamRun {
    int piece = -1;
    std::vector<int> segments{};
    std::vector<CubicCurve> chain{};
    std::vector<std::size_t> first{};  ///< index of each segment's first curve in the chain

    void measure(const std::vector<std::vector<std::vector<CubicCurve>>>& curves) {
        for (const int segment : segments) {
            first.push_back(chain.size());
            const auto& own =
                curves[static_cast<std::size_t>(piece)][static_cast<std::size_t>(segment)];
            chain.insert(chain.end(), own.begin(), own.end());
        }
    }
};

using SideKey = std::pair<int, bool>;  // number of the seam, right side

/// The runs of all seams, each from the start of its side along the outline. A side that is not one
/// run is left out.
std::map<SideKey, SeamRun> seamRuns(const Pattern& pattern) {
    std::map<SideKey, SeamRun> runs;
    for (int p = 0; p < static_cast<int>(pattern.pieces.size()); ++p) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(p)];
        const int count = static_cast<int>(piece.segments.size());
        for (const SeamLine& seam : piece.seams) {
            if (seam.kind == SeamKind::Free) {
                continue;
            }
            const auto isPart = [&](int k) {
                const PatternSegment& segment =
                    piece.segments[static_cast<std::size_t>((k + count) % count)];
                return segment.seam == seam.number && segment.isRight == seam.isRight;
            };
            SeamRun run{p};
            int start = -1;
            for (int k = 0; k < count; ++k) {
                const bool begins =
                    isPart(k) &&
                    (!isPart(k - 1) || std::abs(piece.segments[static_cast<std::size_t>(k)].from -
                                                seam.from) < kSameJoint);
                start = begins && start < 0 ? k : start;
            }
            for (int k = start; start >= 0 && k < start + count && isPart(k); ++k) {
                run.segments.push_back(k % count);
            }
            if (!run.segments.empty()) {
                runs.emplace(SideKey{seam.number, seam.isRight}, std::move(run));
            }
        }
    }
    return runs;
}

/// Divides the curves of both sides at the joints of either, so that they correspond one to one.
/// @param opposed  the right one runs from the end of the seam to its start
void divideAlike(SeamRun& left, SeamRun& right, bool opposed) {
    const double lengthLeft = curveLength(left.chain), lengthRight = curveLength(right.chain);
    const auto across = [&](double at, double from, double to) {
        return opposed ? to * (1 - at / from) : to * at / from;
    };
    std::vector<double> onLeft;  // the joints of the right side
    for (const double joint : jointsOf(right.chain)) {
        onLeft.push_back(across(joint, lengthRight, lengthLeft));
    }
    std::ranges::sort(onLeft);
    // Joints of the two sides at the same place divide neither side. Each joint is matched once, so
    // both sides get the same number, measured on the left side.
    const std::vector<double> leftJoints = jointsOf(left.chain);
    std::vector<double> newOnLeft, newOnRight;
    const auto divideRight = [&](double place) {
        newOnRight.push_back(across(place, lengthLeft, lengthRight));
    };
    std::size_t l = 0, r = 0;
    while (l < leftJoints.size() || r < onLeft.size()) {
        const bool isLast = r == onLeft.size();
        if (!isLast && l < leftJoints.size() && std::abs(leftJoints[l] - onLeft[r]) < kSameJoint) {
            ++l;
            ++r;
        } else if (isLast || (l < leftJoints.size() && leftJoints[l] < onLeft[r])) {
            divideRight(leftJoints[l++]);
        } else {
            newOnLeft.push_back(onLeft[r++]);
        }
    }
    std::ranges::sort(newOnRight);
    const auto divide = [](SeamRun& run, const std::vector<double>& places) {
        std::vector<double> starts(run.first.size(), 0);
        double at = 0;
        for (std::size_t k = 0, s = 0; k < run.chain.size(); ++k) {
            while (s < run.first.size() && run.first[s] == k) {
                starts[s++] = at;
            }
            at += curveLength(run.chain[k]);
        }
        run.chain = dividedChain(run.chain, places, 0);
        at = 0;
        std::size_t s = 0;
        for (std::size_t k = 0; k < run.chain.size(); ++k) {
            while (s < run.first.size() && at >= starts[s] - kSameJoint / 4) {
                run.first[s++] = k;
            }
            at += curveLength(run.chain[k]);
        }
    };
    divide(left, newOnLeft);
    divide(right, newOnRight);
}

/// Finds the rigid motion that brings a flat piece nearest to its place in the garment.
void placeInSpace(const Points2& flat, const Points3& garment, SewnPanel& panel) {
    const Eigen::Vector3d middle = garment.colwise().mean().transpose();
    const Eigen::Vector2d flatMiddle = flat.colwise().mean().transpose();
    const Eigen::Matrix<double, Eigen::Dynamic, 2> from = flat.rowwise() - flatMiddle.transpose();
    const Points3 to = garment.rowwise() - middle.transpose();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    spread.leftCols<2>() = to.transpose() * from;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
    sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    const Eigen::Matrix3d turn = svd.matrixU() * sign * svd.matrixV().transpose();
    if (turn.allFinite() && middle.allFinite()) {
        panel.turn = turn;
        panel.shift = middle - turn.leftCols<2>() * flatMiddle;
    }
}

}  // namespace

SewnPanels sewnPanels(const ExportSource& source) {
    const Pattern& pattern = source.laid().wholePattern;
    std::vector<std::vector<std::vector<CubicCurve>>> curves(pattern.pieces.size());
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        const PatternPiece& piece = pattern.pieces[p];
        const auto outline = geometry::Line::closed(piece.outline);
        for (const PatternSegment& segment : piece.segments) {
            std::vector<CubicCurve>& chain = curves[p].emplace_back();
            for (const CubicCurve& curve : curvesOf(piece, outline, segment)) {
                addHalved(curve, chain);
            }
        }
    }
    std::map<SideKey, SeamRun> runs = seamRuns(pattern);
    struct Sewn {
        SeamRun *left, *right;
        bool opposed;
    };
    std::vector<Sewn> sewn;
    for (auto& [key, run] : runs) {
        const auto other = runs.find({key.first, true});
        const auto number = static_cast<std::size_t>(key.first);
        if (key.second || other == runs.end() || number < 1 ||
            number > source.garment().seams.seams.size()) {
            continue;
        }
        const Seam& seam = source.garment().seams.seams[number - 1];
        run.measure(curves);
        other->second.measure(curves);
        if (run.chain.empty() || other->second.chain.empty()) {
            continue;
        }
        const bool opposed = seam.left.reversed != seam.right.reversed;
        divideAlike(run, other->second, opposed);
        sewn.push_back({&run, &other->second, opposed});
    }
    // Assign the divided curves to their segments again.
    for (const Sewn& seam : sewn) {
        for (const SeamRun* run : {seam.left, seam.right}) {
            for (std::size_t s = 0; s < run->segments.size(); ++s) {
                const std::size_t end =
                    s + 1 < run->first.size() ? run->first[s + 1] : run->chain.size();
                curves[static_cast<std::size_t>(run->piece)]
                      [static_cast<std::size_t>(run->segments[s])]
                          .assign(run->chain.begin() + static_cast<std::ptrdiff_t>(run->first[s]),
                                  run->chain.begin() + static_cast<std::ptrdiff_t>(end));
            }
        }
    }
    SewnPanels made;
    std::vector<std::vector<int>> firstEdges(pattern.pieces.size());
    std::vector<int> panelOf(pattern.pieces.size(), -1);
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        const PatternPiece& piece = pattern.pieces[p];
        if (piece.outline.rows() == 0 || piece.segments.empty()) {
            continue;
        }
        panelOf[p] = static_cast<int>(made.panels.size());
        SewnPanel& panel = made.panels.emplace_back();
        panel.name = piece.slug;
        panel.label = piece.name;
        for (const auto& chain : curves[p]) {
            firstEdges[p].push_back(static_cast<int>(panel.edges.size()));
            for (const CubicCurve& curve : chain) {
                panel.edges.push_back({curve, curveLength(curve)});
            }
        }
        if (p < source.results().size() && source.results()[p] && source.results()[p]->flat &&
            p < source.garment().pieces.size()) {
            placeInSpace(source.results()[p]->flat->Q, source.garment().pieces[p]->mesh.V, panel);
        }
    }
    for (const Sewn& seam : sewn) {
        const auto edgesOf = [&](const SeamRun& run) {
            std::vector<SewnEdges::Side> sides;
            const auto piece = static_cast<std::size_t>(run.piece);
            for (const int segment : run.segments) {
                const int first = firstEdges[piece][static_cast<std::size_t>(segment)];
                const auto count =
                    static_cast<int>(curves[piece][static_cast<std::size_t>(segment)].size());
                for (int k = first; k < first + count; ++k) {
                    sides.push_back({panelOf[piece], k});
                }
            }
            return sides;
        };
        const auto left = edgesOf(*seam.left);
        auto right = edgesOf(*seam.right);
        if (seam.opposed) {
            std::ranges::reverse(right);
        }
        for (std::size_t k = 0; k < std::min(left.size(), right.size()); ++k) {
            made.stitches.push_back({{left[k], right[k]}});
        }
    }
    return made;
}

}  // namespace toile
