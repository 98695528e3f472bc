// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/cut/surface_paths.h"
#include "core/cut/surface_point.h"
#include "core/geometry/shortest_paths.h"
#include "core/tailor/cut_advice.h"

namespace toile::tailor {

/// Vertices at which a surface is separated, as cuts are added: those of rims, and the nearest
/// vertex to each point of a cut.
class PartedLines {
public:
    /// Keeps references.
    PartedLines(const SurfaceLinks& links, const NearestSurface& nearest,
                const std::vector<char>& rims)
        : links_(links), nearest_(nearest), isParted_(rims), isSewn_(rims) {}

    /// The nearest vertices to a line on the surface, in its order, without consecutive duplicates.
    std::vector<int> verticesAlong(const std::vector<Eigen::Vector3d>& points) const;
    /// @param isDart  other darts do not begin on it
    void add(const std::vector<Eigen::Vector3d>& points, bool isDart);

    const std::vector<char>& isParted() const { return isParted_; }
    /// Separated vertices with one more line added.
    std::vector<char> with(const std::vector<Eigen::Vector3d>& points) const;
    /// Whether a line meets a dart.
    bool meetsDart(const std::vector<Eigen::Vector3d>& points) const;
    /// Per vertex: distance from a rim or a seam along edges, mm; infinite if there is none.
    std::vector<double> distances(const std::vector<double>& edgeLengths,
                                  const Progress& progress) const;
    /// The shortest path to a vertex from a rim or a seam; its first point is on that line.
    std::vector<Eigen::Vector3d> wayTo(int vertex, const std::vector<double>& edgeLengths,
                                       const Progress& progress) const;

private:
    geometry::ShortestForest forest(const std::vector<double>& edgeLengths, int stopAt,
                                    const Progress& progress) const;

    const SurfaceLinks& links_;
    const NearestSurface& nearest_;
    std::vector<char> isParted_, isSewn_;
    std::map<int, Eigen::Vector3d> place_;  ///< on the line, of vertices near one
};

/// Takes cuts one by one, each with the largest reduction of strain for its length, by
/// `StrainModel`; and finds darts where surplus cloth remains. Keeps references.
class CutOrder {
public:
    /// @param opening  the shortest cuts that open the piece: included until other cuts open it
    CutOrder(const SurfaceLinks& links, const std::vector<PathPolyline>& opening,
             const Progress& progress);

    /// Adds a cut that is made in any case.
    void add(const UserCut& cut);
    /// Computes the state with all cuts added and taken.
    const std::optional<FlatScale>& look();

    /// Proposes a cut; cuts of both sides of a garment are taken together.
    void propose(AdvisedCut cut);
    bool isEmpty() const { return groups_.empty(); }  ///< nothing is proposed
    /// Takes all proposals.
    void takeAll();
    /// Takes proposals and darts while any removes a worthwhile share of the strain.
    void takeWorthwhile(std::size_t mostDarts);

    std::vector<AdvisedCut>& taken() { return taken_; }

private:
    struct Proposal {
        AdvisedCut cut;
        std::vector<Eigen::Vector3d> line;  ///< traced, with a point at each edge it meets
    };
    struct Group {
        std::vector<Proposal> cuts;
        double length = 0;
        double gain = std::numeric_limits<double>::infinity();  ///< per length, upper bound
    };
    struct DartFound {
        Proposal proposal;
        double gain = 0;
    };

    double mean() const;
    double gainOf(const std::optional<FlatScale>& scale) const;
    double gainOf(const Group& group);
    std::size_t bestGroup();
    void take(Proposal proposal);
    std::optional<FlatScale> scaleWith(std::vector<char> parted);
    bool isOpened(const std::vector<char>& parted) const;
    void takeGroup(std::size_t index);
    std::optional<DartFound> nextDart();
    std::optional<DartFound> dartTo(int tip);
    DartIntake intakeOf(const std::vector<Eigen::Vector3d>& points, const FlatScale& scale) const;

    const SurfaceLinks& links_;
    const Progress& progress_;
    const NearestSurface nearest_;
    StrainModel model_;
    const std::vector<double> lengths_;  ///< of edges
    PartedLines lines_;
    std::vector<int> opening_;  ///< vertices on the shortest cuts
    bool hasHandles_ = false;
    double size_ = 0;  ///< root of the area, mm
    std::optional<FlatScale> scale_;
    std::vector<Group> groups_;
    std::vector<AdvisedCut> taken_;
};

}  // namespace toile::tailor
