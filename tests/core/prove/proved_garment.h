// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/formats/dxf/apparel_dxf.h"
#include "core/formats/read_pattern.h"
#include "core/prove/fresh_cloth.h"
#include "core/sew/cloth.h"
#include "core/toile/pipeline.h"

namespace toile::test {

/// A garment that is flat, with its pattern: what a proof is made of.
class ProvedGarment {
public:
    explicit ProvedGarment(const std::filesystem::path& file, LoadOptions options = {},
                           const FlattenOptions& flattening = {});

    const Garment& garment() const { return garment_; }
    const ExportSource& source() const { return *source_; }
    int pieceCalled(const std::string& name) const;
    /// The pattern as a file of ASTM DXF holds it.
    PatternFile file() const;
    /// The piece of a file that is called so, letters and digits alike.
    static FilePiece& pieceOf(PatternFile& file, const std::string& name);
    /// The design, sewn.
    MeshArrays design() const;

private:
    Garment garment_;
    PieceResults results_;
    LaidOutPattern laid_;
    std::optional<ExportSource> source_;
};

/// A shape that is sewn of pieces, as a garment in millimetres: writes an OBJ with an object for
/// each piece. @return what was written
std::string objectsOf(const sew::CutCloth& cut);

/// All of a file's points changed.
void changePoints(FilePiece& piece,
                  const std::function<void(Eigen::Ref<Eigen::RowVector2d>)>& change);

}  // namespace toile::test
