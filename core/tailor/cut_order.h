// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/cut/surface_links.h"
#include "core/cut/surface_point.h"
#include "core/geometry/shortest_paths.h"
#include "core/tailor/cut_advice.h"

namespace toile::tailor {

/// Where a surface is parted, by its vertices, as cuts are added one by one: those of rims, and for
/// each point of a cut the vertex next to it.
class PartedLines {
public:
    /// Keeps references.
    PartedLines(const SurfaceLinks& links, const NearestSurface& nearest,
                const std::vector<char>& rims)
        : links_(links), nearest_(nearest), isParted_(rims), isSewn_(rims) {}

    /// The vertices next to a line on the surface, in its order, none twice in a row.
    std::vector<int> verticesAlong(const std::vector<Eigen::Vector3d>& points) const;
    /// @param isDart  other darts do not begin on it
    void add(const std::vector<Eigen::Vector3d>& points, bool isDart);

    const std::vector<char>& isParted() const { return isParted_; }
    /// The same with one more line.
    std::vector<char> with(const std::vector<Eigen::Vector3d>& points) const;
    /// Whether a line meets a dart.
    bool meetsDart(const std::vector<Eigen::Vector3d>& points) const;
    /// Per vertex: how far it is from a rim or a seam along edges, mm; infinite where none is.
    std::vector<double> distances(const std::vector<double>& edgeLengths,
                                  const Progress& progress) const;
    /// The shortest way to a vertex from a rim or a seam: its first point lies on that.
    std::vector<Eigen::Vector3d> wayTo(int vertex, const std::vector<double>& edgeLengths,
                                       const Progress& progress) const;

private:
    geometry::ShortestForest forest(const std::vector<double>& edgeLengths, int stopAt,
                                    const Progress& progress) const;

    const SurfaceLinks& links_;
    const NearestSurface& nearest_;
    std::vector<char> isParted_, isSewn_;
    std::map<int, Eigen::Vector3d> place_;  ///< on the line, of vertices next to one
};

/// Takes cuts, one after the other those that take most strain away for their length, by
/// `StrainModel`; and finds darts where cloth remains that is too long. Keeps references.
class CutOrder {
public:
    /// @param opening  the shortest cuts that open the piece: counted in as long as nothing else
    ///                 opens it
    CutOrder(const SurfaceLinks& links, const std::vector<PathPolyline>& opening,
             const Progress& progress);

    /// A cut that is there anyhow.
    void add(const UserCut& cut);
    /// Makes known what there is with what was added and taken.
    const std::optional<FlatScale>& look();

    /// To be taken later; both sides' of a garment are taken together.
    void propose(AdvisedCut cut);
    bool isEmpty() const { return groups_.empty(); }  ///< nothing is proposed
    /// Takes everything proposed.
    void takeAll();
    /// Takes proposals and darts as long as one takes a worthwhile part of the strain away.
    void takeWorthwhile(std::size_t mostDarts);

    std::vector<AdvisedCut>& taken() { return taken_; }

private:
    struct Proposal {
        AdvisedCut cut;
        std::vector<Eigen::Vector3d> line;  ///< that it takes, at each edge that it meets
    };
    struct Group {
        std::vector<Proposal> cuts;
        double length = 0;
        double gain = std::numeric_limits<double>::infinity();  ///< by length, at most
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
    std::vector<int> opening_;  ///< vertices that the shortest cuts pass
    bool hasHandles_ = false;
    double size_ = 0;  ///< root of the area, mm
    std::optional<FlatScale> scale_;
    std::vector<Group> groups_;
    std::vector<AdvisedCut> taken_;
};

}  // namespace toile::tailor
