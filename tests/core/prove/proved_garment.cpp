// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/prove/proved_garment.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>

#include "core/prove/fresh_cloth.h"
#include "tests/core/support/laid_rows.h"

namespace toile::test {
namespace {

std::string lettersOf(const std::string& text) {
    std::string kept;
    for (const unsigned char c : text) {
        if (std::isalnum(c) != 0) {
            kept += static_cast<char>(std::tolower(c));
        }
    }
    return kept;
}

}  // namespace

ProvedGarment::ProvedGarment(const std::filesystem::path& file, LoadOptions options,
                             const FlattenOptions& flattening) {
    Progress progress;
    auto garment = loadGarment({file}, options, progress);
    EXPECT_TRUE(garment) << file;
    garment_ = std::move(*garment);
    results_ = flattenGarment(garment_, flattening, progress);
    laid_ = inRows(garment_, results_);
    source_.emplace(garment_, results_, laid_);
}

int ProvedGarment::pieceCalled(const std::string& name) const {
    const auto found = std::ranges::find(garment_.pieces, name, &Piece::name);
    EXPECT_NE(found, garment_.pieces.end()) << name;
    return static_cast<int>(found - garment_.pieces.begin());
}

PatternFile ProvedGarment::file() const {
    auto file = readPattern(writeApparelDxf(*source_), PatternFileKind::Dxf, "pattern.dxf");
    EXPECT_TRUE(file);
    return std::move(*file);
}

FilePiece& ProvedGarment::pieceOf(PatternFile& file, const std::string& name) {
    const auto found = std::ranges::find_if(file.pieces, [&](const FilePiece& piece) {
        return lettersOf(piece.name) == lettersOf(name);
    });
    EXPECT_NE(found, file.pieces.end()) << name;
    return *found;
}

MeshArrays ProvedGarment::design() const {
    return *prove::designSurface(garment_);
}

std::string objectsOf(const sew::CutCloth& cut) {
    std::ostringstream out;
    out.precision(17);
    for (Eigen::Index v = 0; v < cut.V.rows(); ++v) {
        out << "v " << cut.V(v, 0) << ' ' << cut.V(v, 1) << ' ' << cut.V(v, 2) << '\n';
    }
    for (Eigen::Index f = 0; f < cut.F.rows(); ++f) {
        if (f == 0 || cut.pieceOf[f] != cut.pieceOf[f - 1]) {
            out << "o piece_" << cut.pieceOf[f] << '\n';
        }
        out << "f " << cut.F(f, 0) + 1 << ' ' << cut.F(f, 1) + 1 << ' ' << cut.F(f, 2) + 1 << '\n';
    }
    return out.str();
}

void changePoints(FilePiece& piece,
                  const std::function<void(Eigen::Ref<Eigen::RowVector2d>)>& change) {
    std::vector<Points2*> lines{&piece.cut, &piece.sew};
    for (Points2& hole : piece.holes) {
        lines.push_back(&hole);
    }
    for (Points2* line : lines) {
        for (Eigen::Index k = 0; k < line->rows(); ++k) {
            change(line->row(k));
        }
    }
}

}  // namespace toile::test
