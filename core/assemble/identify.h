// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/id.h"
#include "core/garment/garment.h"

namespace toile {

/// The features by which a piece of the division is recognised in another version of its file.
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

/// By content, and how often the same content occurred before in the garment. Linear.
std::vector<FileId> fileIds(const std::vector<std::shared_ptr<const SourceFile>>& files);

/// Assigns ids to the pieces of a division, and origins to their rims. The same pieces of the same
/// file have the same ids: by its content, how often the garment has had it before, the piece's
/// first face and number of faces. If a piece is not found in this way, the file is another
/// version: of the remaining known pieces of the same file, the one at the same place with the same
/// size is taken, or one with the same name not far away. Cost: linear in the meshes, and in known
/// times unknown pieces of each file. Pure.
/// @param uncut  of all files
void identify(std::vector<std::shared_ptr<Piece>>& uncut,
              const std::vector<std::shared_ptr<const SourceFile>>& files,
              const std::vector<KnownPiece>& known);

/// Adds these ids to the notes of reading, repairing and checking, which refer to files and pieces
/// by name. Precondition: the uncut pieces are those of `files`, with ids. n log n in the notes and
/// the pieces.
void nameSubjects(const std::vector<std::shared_ptr<SourceFile>>& files,
                  const std::vector<std::shared_ptr<Piece>>& uncut);

}  // namespace toile
