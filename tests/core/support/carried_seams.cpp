// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/carried_seams.h"

#include <algorithm>
#include <cmath>

#include "core/assemble/file_space.h"
#include "core/cut/surface_paths.h"
#include "core/seam/seam_measure.h"

namespace toile::test {
namespace {

constexpr double kMeet = 0.01;  // mm

/// Points along a line, the first and the last among them, about so far from each other.
std::vector<Eigen::Vector3d> pointsAlong(const Points3& line, double step) {
    double length = 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        length += (line.row(i) - line.row(i - 1)).norm();
    }
    const int count = std::max(1, static_cast<int>(std::lround(length / step)));
    std::vector<Eigen::Vector3d> points{line.row(0).transpose()};
    double way = 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        const double edge = (line.row(i) - line.row(i - 1)).norm();
        for (double next = static_cast<double>(points.size()) * length / count;
             std::ssize(points) < count && next <= way + edge;
             next = static_cast<double>(points.size()) * length / count) {
            const double share = (next - way) / edge;
            points.emplace_back((1 - share) * line.row(i - 1) + share * line.row(i));
        }
        way += edge;
    }
    points.emplace_back(line.row(line.rows() - 1).transpose());
    return points;
}

}  // namespace

SeamsFile carriedSeams(const Garment& from, const Garment& onto, const Carrying& how) {
    const Piece& piece = *onto.uncut.front();
    const SurfaceLinks links(piece.mesh, piece.table);
    const NearestSurface nearest(piece.mesh);
    const auto isOnRim = [&](const SurfacePoint& point) {
        const Carrier carrier = links.carrierOf(point);
        return (carrier.kind == Carrier::Kind::Vertex && !links.isInner(carrier.index)) ||
               (carrier.kind == Carrier::Kind::Edge && piece.table.isBorder(carrier.index));
    };
    SeamsFile file;
    file.unit = LengthUnit::Millimetre;
    // Seams that meet do so to the last digit, else threads of cloth stay between them.
    std::vector<Eigen::Vector3d> ends;
    const auto meet = [&ends](Eigen::Vector3d& end) {
        const auto met = std::ranges::find_if(
            ends, [&end](const Eigen::Vector3d& other) { return (other - end).norm() < kMeet; });
        met == ends.end() ? ends.push_back(end) : void(end = *met);
    };
    const auto add = [&](std::vector<Eigen::Vector3d> run, const std::string& name) {
        double length = 0;
        for (std::size_t i = 1; i < run.size(); ++i) {
            length += (run[i] - run[i - 1]).norm();
        }
        if (run.size() > 1 && length >= how.shortest) {
            meet(run.front());
            meet(run.back());
            UserCut cut;
            cut.name = name;
            for (const Eigen::Vector3d& point : run) {
                cut.points.push_back(inFileSpace(point, file, onto));
            }
            file.cuts.push_back(std::move(cut));
        }
    };
    for (const Seam& seam : from.seams.seams) {
        if (seam.right.piece < 0) {
            continue;
        }
        std::vector<Eigen::Vector3d> run;
        bool wasOnRim = false;
        for (const Eigen::Vector3d& point :
             pointsAlong(spaceLine(seam.left, *from.pieces[seam.left.piece]), how.step)) {
            const SurfacePoint place = nearest.find(point);
            const Eigen::Vector3d there = positionOf(piece.mesh, place);
            const bool isFar = (there - point).norm() > how.farthest;
            const bool onRim = isOnRim(place);
            if (isFar && !onRim) {
                add(run, seam.name);
                run.clear();
            } else if (onRim && wasOnRim) {
                run = {there};  // along the rim
            } else if (onRim && !run.empty()) {
                run.push_back(there);
                add(run, seam.name);
                run = {there};
            } else {
                run.push_back(there);
            }
            wasOnRim = onRim;
        }
        add(run, seam.name);
    }
    return file;
}

}  // namespace toile::test
