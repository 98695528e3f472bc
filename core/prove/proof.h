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
#include "core/export/export_source.h"
#include "core/prove/proof_settings.h"
#include "core/reading/pattern_file.h"
#include "core/sew/gap.h"
#include "core/sew/settle.h"

namespace toile {

/// What is proved.
struct ProofOrder {
    /// The pattern as it was read from a file; none: the garment's own, as written to ASTM DXF and
    /// read back.
    std::optional<PatternFile> file{};
    bool isReference = false;  ///< the designer's own (`Piece::reference`) in its place
    /// What the cloth is worn on, mm, in the garment's space; none: the design's own surface.
    std::optional<MeshArrays> body{};
    std::string bodyName{};  ///< of its file, to be told
    ProofSettings settings{};
    /// The pattern is sewn this many times as large as it is: shrunk by 3 % in the wash is 0.97.
    double scale = 1;
    /// Called on the working thread after each step, with where the vertices of every piece lie
    /// (`ProvenPiece::sewn`); may be empty.
    std::function<void(const std::vector<Points3>&)> watch{};
};

/// A piece of the garment, sewn. Nothing in it where it has no cloth: it is not flat, left out, or
/// not in the file.
struct ProvenPiece {
    Points3 sewn = Points3(0, 3);  ///< where each vertex of the piece comes to lie, mm
    Eigen::VectorXd gap{};  ///< per vertex: how far outside of the design, mm; inside: below 0
    /// Per vertex: the principal strain of larger size of the cloth there, part of 1; above 0
    /// pulls.
    Eigen::VectorXd strain{};
    sew::SpreadFigures gapFigures{};  ///< mm, of the fresh cloth; `place` is a vertex of the piece
    double mostPull = 0,
           mostSlack = 0;  ///< strain that a twentieth of its area exceeds; >= 0, both
    double freeShare = 0;  ///< of its area that touches nothing

    bool isSewn() const { return sewn.rows() > 0; }
};

/// How the two sides of a seam go together.
struct ProvenSeam {
    int seam = -1;               ///< index into the garment's seams
    double left = 0, right = 0;  ///< lengths in the pattern, mm
    /// What of their difference nobody wants: left - (1 + ease) right, mm.
    double slip = 0;
    double strain = 0;  ///< mean along it of the sewn cloth, part of 1; above 0 pulls
};

enum class ProofFaultKind {
    Mirrored,       ///< the file has the piece mirrored
    OtherFits,      ///< what the file has in this piece's place fits another piece better
    SeamSlips,      ///< the two sides of a seam do not fit each other
    LengthDiffers,  ///< a side of a seam has another length than on the design
    NotThere,       ///< the pattern has no such piece
    NotNeeded,      ///< the file has a piece that is none of the garment's
    FarOff,         ///< the cloth came to rest nowhere near the design
};

/// "mirrored", "other-fits", "seam-slips", "length-differs", "not-there", "not-needed", "far-off".
std::string_view name(ProofFaultKind kind);

/// What is wrong with a pattern before anything is sewn, or with all of it afterwards.
struct ProofFault {
    ProofFaultKind kind = ProofFaultKind::NotThere;
    Subject subject{};
    std::vector<int> pieces{};  ///< indices into the garment's pieces
    int seam = -1;              ///< index into the garment's seams, or -1
    double amount = 0;          ///< mm; of what has none: 0
    Wording told{};             ///< a sentence without a full stop
};

/// A pattern sewn back together over its design, and measured.
struct Proof {
    std::vector<ProvenPiece> pieces{};  ///< one per piece of the garment
    std::vector<Fabric> fabrics{};      ///< what each is of
    std::vector<ProvenSeam> seams{};    ///< of those that are sewn
    std::vector<ProofFault> faults{};
    sew::SpreadFigures gap{};     ///< mm, over all cloth, by area; without any motion of the whole
    int gapPiece = -1;            ///< where the largest is; `gap.place` is a vertex of it
    sew::SpreadFigures strain{};  ///< sizes, part of 1
    int strainPiece = -1;         ///< where the largest is; `strain.place` is a vertex of it
    double freeShare = 0;         ///< of the cloth's area that touches nothing
    // How it was found.
    Wording source{};          ///< of the rest state: "ASTM DXF, read back", the file's format
    ProofSettings settings{};  ///< as ordered
    bool hasBody = false;      ///< else on the design
    std::string bodyName{};    ///< as ordered
    double scale = 1;          ///< as ordered
    double edge = 0;           ///< mean length of the triangles' edges at rest, mm
    int triangles = 0;
    int iterations = 0;                   ///< factorisations
    double restForce = 0, seamForce = 0;  ///< as of `sew::SettledCloth`, N
    bool hasSettled = false;
    double seconds = 0;
};

/// A mean gap from here on is a doubt for who is about to cut, mm.
inline constexpr double kDoubtfulGap = 2;

/// What of the force at seams is left where it came to rest; 0 where there are no forces.
inline double restShare(const Proof& proof) {
    return proof.seamForce > 0 ? proof.restForce / proof.seamForce : 0;
}

/// "Sewn back it sits 0.3 mm from the design on average, 1.4 mm at the worst twentieth; the seam
/// armhole left pulls 3.1 %, more than the fabric gives": with the seam that pulls most, else the
/// piece that pulls or bags most, from 1 % on, and what hangs free, from 10 % on. A sentence
/// without a full stop.
Wording sentence(const Proof& proof, const Garment& garment);

/// What held the cloth, and what else was asked for: "on avatar.obj, 10 Pa, gravity, 0.97 times as
/// large, cloth as typed".
Wording howHeld(const Proof& proof);

/// Sews the pattern back together over the design and measures how far from it it comes to rest.
/// Errors: NoGeometry (nothing is flat, nothing of the file is the garment's, or its lengths are
/// those of another unit), those of
/// `sew::settle`, NotReadBack, Cancelled. Same input, same bytes, but for
/// `seconds`.
/// Cost: 45 000 triangles take some 24 s on two cores.
Result<std::shared_ptr<const Proof>> proofOf(const ExportSource& source, const ProofOrder& order,
                                             const Progress& progress);

/// The proof as JSON (docs/prove.md): `gap_mm: {mean, p95, max}` and the rest.
std::string writeProof(const Garment& garment, const Proof& proof);

}  // namespace toile
