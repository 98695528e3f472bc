// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/file_space.h"

namespace toile {
namespace {

double millimetresIn(const SeamsFile& seams, const SourceFile& file) {
    return millimetresPer(seams.unit.value_or(file.unit));
}

template <class Entry>
std::vector<Entry> moved(std::vector<Entry> entries, const SeamsFile& seams,
                         const Garment& garment) {
    for (Entry& entry : entries) {
        for (Eigen::Vector3d& point : entry.points) {
            point = inPieceSpace(point, seams, garment);
        }
    }
    return entries;
}

}  // namespace

Eigen::Vector3d inPieceSpace(const Eigen::Vector3d& point, const SeamsFile& seams,
                             const Garment& garment) {
    if (garment.files.empty()) {
        return point;
    }
    const SourceFile& file = *garment.files.front();
    return millimetresIn(seams, file) * withYUp(file.up, point).transpose();
}

Eigen::Vector3d inFileSpace(const Eigen::Vector3d& point, const SeamsFile& seams,
                            const Garment& garment) {
    if (garment.files.empty()) {
        return point;
    }
    const SourceFile& file = *garment.files.front();
    return asInFile(file.up, point).transpose() / millimetresIn(seams, file);
}

std::vector<Eigen::Vector3d> inPieceSpace(std::vector<Eigen::Vector3d> points,
                                          const Garment& garment) {
    for (Eigen::Vector3d& point : points) {
        point = inPieceSpace(point, {}, garment);
    }
    return points;
}

std::vector<Eigen::Vector3d> inFileSpace(std::vector<Eigen::Vector3d> points,
                                         const Garment& garment) {
    for (Eigen::Vector3d& point : points) {
        point = inFileSpace(point, {}, garment);
    }
    return points;
}

std::vector<UserCut> cutsInPieceSpace(const SeamsFile& seams, const Garment& garment) {
    return moved(seams.cuts, seams, garment);
}

std::vector<UserJoin> joinsInPieceSpace(const SeamsFile& seams, const Garment& garment) {
    return moved(seams.joins, seams, garment);
}

}  // namespace toile
