// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/id.h"
#include "core/garment/garment.h"

namespace toile {

/// By what a piece of the division is known again in another version of its file.
struct KnownPiece {
    PieceId id;
    int file = 0;      ///< index into Garment::files
    std::string name;  ///< as divided
    Eigen::Vector3d centre =
        Eigen::Vector3d::Zero();  ///< of its cloth, in the file's unit and axes
    double area = 0;              ///< likewise

    bool operator==(const KnownPiece&) const = default;
};

/// Of the garment's pieces before any join or cut. Linear.
std::vector<KnownPiece> knownPieces(const Garment& garment);

/// By content, and how often the garment has had it before. Linear.
std::vector<FileId> fileIds(const std::vector<std::shared_ptr<const SourceFile>>& files);

/// Gives the pieces of a division their ids, and their rims their origins. The same pieces of the
/// same file have the same ids: by its content, how often the garment has had it before, the
/// piece's first face and how many it has. Where a piece is not known by that, the file is another
/// version: of the known pieces of the same file that are left, it is the one that lies where it
/// lies and is as large, or has its name and is not far from it. Cost: linear in the meshes, and in
/// known times unknown pieces of each file. Pure.
/// @param uncut  of all files
void identify(std::vector<std::shared_ptr<Piece>>& uncut,
              const std::vector<std::shared_ptr<const SourceFile>>& files,
              const std::vector<KnownPiece>& known);

/// Completes with these ids what reading, repairing and checking said of files and pieces by name.
/// Precondition: the uncut pieces are those of `files`, with ids. n log n in what was said and the
/// pieces.
void nameSubjects(const std::vector<std::shared_ptr<SourceFile>>& files,
                  const std::vector<std::shared_ptr<Piece>>& uncut);

}  // namespace toile
