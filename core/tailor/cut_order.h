// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/cut/surface_links.h"
#include "core/tailor/cut_advice.h"
#include "core/tailor/parted_lines.h"

namespace toile::tailor {

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
