// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/piece_edits.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "core/pattern/piece_marks.h"
#include "core/project/layer_materials.h"
#include "core/project/piece_names.h"
#include "core/project/piece_settings.h"

namespace toile::app {

namespace {

std::vector<int> inGarment(const Document& document, std::vector<int> pieces) {
    std::erase_if(pieces, [&](int piece) { return piece < 0 || piece >= document.pieceCount(); });
    return pieces;
}

DocumentState withSettings(const Document& document, const std::vector<int>& pieces,
                           const std::function<void(int piece, PieceSettings&)>& change) {
    DocumentState next = document.state();
    for (const int piece : pieces) {
        const auto at = static_cast<std::size_t>(piece);
        PieceSettings& said = next.settings[document.garment()->pieces[at]->id];
        said = document.settings()[at];
        change(piece, said);
    }
    return next;
}

}  // namespace

void editSettings(Document& document, const QString& text, const std::vector<int>& pieces,
                  const std::function<void(int piece, PieceSettings&)>& change, int gesture) {
    document.edit(text, withSettings(document, pieces, change), gesture);
}

void renamePiece(Document& document, int piece, const QString& name) {
    if (inGarment(document, {piece}).empty()) {
        return;
    }
    document.edit(tr("Rename %1").arg(pieceName(document, piece)), &DocumentState::labels,
                  withName(document.state().labels, *document.garment(), piece,
                           name.simplified().toStdString()));
}

void setQuantity(Document& document, const std::vector<int>& pieces, int quantity) {
    const std::vector<int> there = inGarment(document, pieces);
    const int copies = std::clamp(quantity, 1, kMaxCopies);
    if (!there.empty()) {
        editSettings(document,
                     tr("Set quantity of %1 to %2").arg(nameOfPieces(document, there)).arg(copies),
                     there, [copies](int, PieceSettings& settings) { settings.quantity = copies; });
    }
}

void setMirroredPair(Document& document, const std::vector<int>& pieces, bool isPair) {
    const std::vector<int> there = inGarment(document, pieces);
    if (!there.empty()) {
        const QString text =
            isPair ? tr("Set mirrored pair for %1") : tr("Clear mirrored pair for %1");
        editSettings(document, text.arg(nameOfPieces(document, there)), there,
                     [isPair](int, PieceSettings& settings) { settings.mirroredPair = isPair; });
    }
}

QStringList proposedMaterials() {
    return {tr("Shell"), tr("Lining"), tr("Interfacing")};
}

void setMaterial(Document& document, const std::vector<int>& pieces, const QString& material) {
    const std::vector<int> there = inGarment(document, pieces);
    if (there.empty()) {
        return;
    }
    const QString shown = material.simplified().left(static_cast<qsizetype>(kMaxLabelText));
    const std::string name = shown.toStdString();
    DocumentState next = withSettings(document, there, [&name](int, PieceSettings& settings) {
        settings.material = name;
        settings.materialByHand = true;
    });
    next.materials = materialsInUse(next);
    const QString text =
        name.empty()
            ? tr("Set material of %1 to garment's fabric").arg(nameOfPieces(document, there))
            : tr("Set material of %1 to %2").arg(nameOfPieces(document, there), shown);
    document.edit(text, std::move(next));
}

namespace {

/// @param groups  one per piece
template <class Group>
void selectAlike(Document& document, const std::vector<int>& pieces,
                 const std::vector<Group>& groups) {
    std::set<Group> meant;
    Document::Selection selection(pieces.begin(), pieces.end());
    for (const int piece : pieces) {
        meant.insert(groups[static_cast<std::size_t>(piece)]);
    }
    for (int i = 0; i < document.pieceCount(); ++i) {
        if (!isHidden(document, i) && meant.contains(groups[static_cast<std::size_t>(i)])) {
            selection.insert(i);
        }
    }
    document.setSelection(std::move(selection));
}

}  // namespace

void selectSameMaterial(Document& document, const std::vector<int>& pieces) {
    std::vector<std::string> materials;
    for (const PieceSettings& said : document.settings()) {
        materials.push_back(said.material);
    }
    selectAlike(document, inGarment(document, pieces), materials);
}

void selectSameLayer(Document& document, const std::vector<int>& pieces) {
    if (hasLayers(document)) {
        selectAlike(document, inGarment(document, pieces), layersOf(*document.garment()));
    }
}

bool hasLayers(const Document& document) {
    return document.garment() && !layersOf(*document.garment()).empty();
}

void setByHalf(Document& document, const std::vector<int>& pieces, bool byHalf) {
    const std::vector<int> there = inGarment(document, pieces);
    if (there.empty()) {
        return;
    }
    DocumentState next = withSettings(
        document, there, [byHalf](int, PieceSettings& settings) { settings.byHalf = byHalf; });
    if (byHalf && next.lines.mirror == Mirror::None) {
        next.lines.mirror = Mirror::Close;
    }
    const QString text = byHalf ? tr("Draw %1 as half") : tr("Draw %1 as whole");
    document.edit(text.arg(nameOfPieces(document, there)), std::move(next));
}

void hidePieces(Document& document, const std::vector<int>& pieces) {
    const std::vector<int> there = inGarment(document, pieces);
    if (there.empty()) {
        return;
    }
    Document::Selection rest = document.selection();
    for (const int piece : there) {
        rest.erase(piece);
    }
    editSettings(document, tr("Hide %1").arg(nameOfPieces(document, there)), there,
                 [](int, PieceSettings& settings) { settings.hidden = true; });
    document.setSelection(std::move(rest));
}

void showOnlyPieces(Document& document, const std::vector<int>& pieces) {
    const std::vector<int> there = inGarment(document, pieces);
    if (there.empty()) {
        return;
    }
    const Document::Selection all = document.everyPiece(), shown(there.begin(), there.end());
    editSettings(
        document, tr("Show only %1").arg(nameOfPieces(document, there)), {all.begin(), all.end()},
        [&shown](int piece, PieceSettings& settings) { settings.hidden = !shown.contains(piece); });
}

void showAllPieces(Document& document) {
    const Document::Selection all = document.everyPiece();
    editSettings(document, tr("Show all pieces"), {all.begin(), all.end()},
                 [](int, PieceSettings& settings) { settings.hidden = false; });
}

bool isHidden(const Document& document, int piece) {
    return document.settings()[static_cast<std::size_t>(piece)].hidden;
}

bool isAnyHidden(const Document& document) {
    return std::ranges::any_of(document.settings(), &PieceSettings::hidden);
}

void setLeftOut(Document& document, const std::vector<int>& pieces, bool leftOut) {
    std::vector<int> meant = inGarment(document, pieces);
    std::erase_if(meant, [&](int piece) { return isLeftOut(document, piece) == leftOut; });
    if (!meant.empty()) {
        const QString text = leftOut ? tr("Leave out %1") : tr("Include %1");
        editSettings(document, text.arg(nameOfPieces(document, meant)), meant,
                     [leftOut](int, PieceSettings& settings) { settings.leftOut = leftOut; });
    }
}

bool isLeftOut(const Document& document, int piece) {
    return document.settings()[static_cast<std::size_t>(piece)].leftOut;
}

std::vector<int> piecesBelow(const Document& document, double area) {
    std::vector<int> found;
    for (int i = 0; i < document.pieceCount(); ++i) {
        if (!isLeftOut(document, i) &&
            wornArea(*document.garment()->pieces[static_cast<std::size_t>(i)]) < area) {
            found.push_back(i);
        }
    }
    return found;
}

int copiesOf(const Document& document, int piece) {
    const PieceSettings& settings = document.settings()[static_cast<std::size_t>(piece)];
    return settings.quantity * (settings.mirroredPair ? 2 : 1);
}

}  // namespace toile::app
