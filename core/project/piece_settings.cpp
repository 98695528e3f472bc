// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/piece_settings.h"

#include <algorithm>
#include <set>

namespace toile {
namespace {

/// The label's colour; negative if it has none.
int colourOf(const PieceLabels& labels, PieceId id) {
    const auto known = labels.find(id);
    return known == labels.end() ? -1 : known->second.colour;
}

/// Another shade of a colour that is not in `taken` yet, and adds it there.
int takeShade(int colour, std::set<int>& taken) {
    do {
        colour += kHueCount;
    } while (!taken.insert(colour).second);
    return colour;
}

/// "skirt 2" for the part "front 2" of a piece that the user named "skirt"; else empty.
std::string inheritedName(const PieceLabels& labels, const Piece& whole, const Piece& part) {
    const std::string& said = nameOf(labels, whole);
    return said != whole.name && part.name.starts_with(whole.name)
               ? said + part.name.substr(whole.name.size())
               : std::string();
}

}  // namespace

PieceLabels withColours(PieceLabels labels, const Garment* before, const Garment& after) {
    std::set<int> present, ever;
    for (const auto& [id, label] : labels) {
        ever.insert(label.colour);
    }
    std::vector<int> colours;
    for (const auto& piece : after.pieces) {
        const int own = colourOf(labels, piece->id);
        colours.push_back(own >= 0 && present.insert(own).second ? own : -1);
    }
    const std::vector<int> was =
        before ? predecessors(before->pieces, after.pieces) : std::vector<int>{};
    int next = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (colours[i] < 0 && before && was[i] >= 0) {
            const int old = colourOf(labels, before->pieces[static_cast<std::size_t>(was[i])]->id);
            if (old >= 0) {
                colours[i] = present.insert(old).second ? old : takeShade(old, ever);
            }
        }
        while (colours[i] < 0) {
            colours[i] = ever.insert(next).second ? next : -1;
            ++next;
        }
        const bool isNew = !labels.contains(after.pieces[i]->id);
        PieceLabel& label = labels[after.pieces[i]->id];
        label.colour = colours[i];
        if (isNew && before && was[i] >= 0) {
            label.name = inheritedName(labels, *before->pieces[static_cast<std::size_t>(was[i])],
                                       *after.pieces[i]);
        }
    }
    return labels;
}

std::vector<int> coloursOf(const PieceLabels& labels, const Garment& garment) {
    std::vector<int> colours;
    for (const auto& piece : garment.pieces) {
        const int colour = colourOf(labels, piece->id);
        colours.push_back(colour < 0 ? static_cast<int>(colours.size()) : colour);
    }
    return colours;
}

const std::string& nameOf(const PieceLabels& labels, const Piece& piece) {
    const auto known = labels.find(piece.id);
    return known == labels.end() || known->second.name.empty() ? piece.name : known->second.name;
}

Subject labelled(const PieceLabels& labels, Subject subject) {
    const auto known = labels.find(subject.pieceId());
    if (known != labels.end() && !known->second.name.empty()) {
        subject.name = known->second.name;
    }
    return subject;
}

}  // namespace toile
