// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/garment/piece.h"
#include "core/linalg/sparse_cholesky.h"

namespace toile::bench {

/// What no method of one linear system can go below: CHOLMOD called straight, past Toile's own
/// solver. The interior cotangent Laplacian is assembled once, ordered, factorised symbolically and
/// numerically, and three right-hand sides are solved, one and then two at once, as `curvature`
/// needs them (its Poisson equation, then x and y).

/// One way to configure CHOLMOD. The floor is the fastest of all.
struct FloorCandidate {
    std::string name;  ///< as in the benchmark's name
    int ordering;      ///< CHOLMOD's number for it
    bool supernodal;
    bool relaxed = false;        ///< supernodes are merged more freely than CHOLMOD would
    bool loses = false;          ///< known to be far behind: measured to show it, and seldom
    int largest = 1 << 30;       ///< triangles beyond which it would only take the run's time
    bool boundedThreads = true;  ///< false: as Debian delivers CHOLMOD and OpenBLAS
};

std::span<const FloorCandidate> floorCandidates();

/// The interior cotangent Laplacian of a piece.
linalg::SymmetricMatrix assembleFloor(const Piece& piece);

/// Seconds of its stages.
struct FloorTimes {
    double assemble = 0, analyse = 0, factorise = 0, solve = 0;
};

/// From the piece in memory to the three solutions.
/// Throws std::runtime_error where CHOLMOD fails. One thread at a time: it sets the OpenMP and
/// OpenBLAS threads of the process, and leaves them bounded to one, as Toile does itself.
FloorTimes runFloor(const Piece& piece, const FloorCandidate& candidate);

}  // namespace toile::bench
