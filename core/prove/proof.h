// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/wording.h"
#include "core/diagnose/finding.h"
#include "core/formats/export_source.h"
#include "core/formats/pattern_file.h"
#include "core/prove/proof_settings.h"
#include "core/sew/gap.h"
#include "core/sew/settle.h"

namespace toile {

/// What to prove, and how.
struct ProofOrder {
    /// The pattern read from a file; none: the garment's own, written to ASTM DXF and read back.
    std::optional<PatternFile> file{};
    bool isReference = false;  ///< use the designer's own (`Piece::reference`) instead
    /// The body under the cloth, mm, in the garment's space; none: the design's own surface.
    std::optional<MeshArrays> body{};
    std::string bodyName{};  ///< of its file, for messages
    ProofSettings settings{};
    /// Factor on the size of the pattern: 0.97 for shrinkage by 3 % in the wash.
    double scale = 1;
    /// Called on the working thread after each step, with the positions of the vertices of every
    /// piece (`ProvenPiece::sewn`); may be empty.
    std::function<void(const std::vector<Points3>&)> watch{};
};

/// A sewn piece of the garment. Empty if it has no cloth: it is not flat, left out, or not in the
/// file.
struct ProvenPiece {
    Points3 sewn = Points3(0, 3);  ///< position of each vertex of the piece, mm
    Eigen::VectorXd gap{};  ///< per vertex: distance outside the design, mm; inside: negative
    /// Per vertex: the cloth's principal strain of larger absolute value, 1 is 100 %; positive is
    /// tension.
    Eigen::VectorXd strain{};
    sew::SpreadFigures gapFigures{};  ///< mm, of the fresh cloth; `place` is a vertex of the piece
    double mostPull = 0,
           mostSlack = 0;  ///< strain exceeded by a twentieth of its area; >= 0, both
    double freeShare = 0;  ///< share of its area that touches nothing

    bool isSewn() const { return sewn.rows() > 0; }
};

/// Comparison of the two sides of a seam.
struct ProvenSeam {
    int seam = -1;               ///< index into the garment's seams
    double left = 0, right = 0;  ///< lengths in the pattern, mm
    /// The unintended part of their difference: left - (1 + ease) right, mm.
    double slip = 0;
    double strain = 0;  ///< mean along it of the sewn cloth; positive is tension
};

/// A pattern sewn back together over its design, and measured.
struct Proof {
    std::vector<ProvenPiece> pieces{};  ///< one per piece of the garment
    std::vector<Fabric> fabrics{};      ///< fabric of each piece
    std::vector<ProvenSeam> seams{};    ///< of those that are sewn
    /// Faults of the pattern before sewing, or of all of it afterwards: Mirrored to FarOff.
    /// `reason` is the sentence, `badness` the amount in mm or 0. LengthDiffers is a doubt: a
    /// method with a free outline changes both sides alike, so the seam can still be sewn.
    std::vector<Finding> faults{};
    sew::SpreadFigures gap{};     ///< mm, over all cloth, by area; without any rigid motion
    int gapPiece = -1;            ///< piece with the largest; `gap.place` is a vertex of it
    sew::SpreadFigures strain{};  ///< absolute values, 1 is 100 %
    int strainPiece = -1;         ///< piece with the largest; `strain.place` is a vertex of it
    double freeShare = 0;         ///< share of the cloth's area that touches nothing
    // How the proof was made.
    Wording source{};          ///< of the rest state: "ASTM DXF, read back", the file's format
    ProofSettings settings{};  ///< as ordered
    bool hasBody = false;      ///< false: on the design
    std::string bodyName{};    ///< as ordered
    double scale = 1;          ///< as ordered
    double edge = 0;           ///< mean length of the triangles' edges at rest, mm
    int triangles = 0;
    int iterations = 0;                   ///< factorisations
    double restForce = 0, seamForce = 0;  ///< as of `sew::SettledCloth`, N
    bool hasSettled = false;
    double seconds = 0;
};

/// From this mean gap on a pattern is doubtful for cutting, mm.
inline constexpr double kDoubtfulGap = 2;

/// Residual force as a share of the force at seams; 0 without forces.
inline double restShare(const Proof& proof) {
    return proof.seamForce > 0 ? proof.restForce / proof.seamForce : 0;
}

/// "The sewn pattern is 0.3 mm from the design on average, 95 % within 1.4 mm. Tightest seam:
/// armhole left, 3.1 %, more than the fabric allows": with the seam under most tension, else the
/// piece with most tension or slack, from 1 % on, and the free share, from 10 % on. Without a full
/// stop at the end.
Wording sentence(const Proof& proof, const Garment& garment);

/// The support of the cloth and other settings: "on avatar.obj, 10 Pa, gravity, 0.97 times as
/// large, cloth as typed".
Wording howHeld(const Proof& proof);

/// Sews the pattern back together over the design and measures its distance from it at rest.
/// Errors: NoGeometry (nothing is flat, nothing of the file is the garment's, or its lengths are
/// those of another unit), those of `sew::settle`, NotReadBack, Cancelled. The same input gives the
/// same bytes, except `seconds`.
/// Cost: 45 000 triangles take some 24 s on two cores.
Result<std::shared_ptr<const Proof>> proofOf(const ExportSource& source, const ProofOrder& order,
                                             const Progress& progress);

/// The proof as JSON (docs/prove.md): `gap_mm: {mean, p95, max}` and the rest.
std::string writeProof(const Garment& garment, const Proof& proof);

}  // namespace toile
