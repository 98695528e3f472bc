// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/piece_names.h"

#include <map>
#include <utility>

#include "core/base/characters.h"
#include "core/base/text.h"

namespace toile {
namespace {

bool hasName(const PieceLabels& labels, const Piece& piece) {
    const auto known = labels.find(piece.id);
    return known != labels.end() && !known->second.name.empty();
}

/// One name per piece, made unique because the labels may be of another version.
std::vector<std::string> namesOf(const PieceLabels& labels, const Garment& garment) {
    UniqueNames names;
    for (const auto& piece : garment.pieces) {
        if (!hasName(labels, *piece)) {
            names.take(piece->name);
        }
    }
    std::vector<std::string> found;
    for (const auto& piece : garment.pieces) {
        found.push_back(hasName(labels, *piece) ? names.free(nameOf(labels, *piece)) : piece->name);
    }
    return found;
}

std::shared_ptr<const PieceResult> under(const std::shared_ptr<const Piece>& piece,
                                         const PieceResult& result) {
    auto renamed = std::make_shared<PieceResult>(result);
    const auto rename = [&piece](Subject& subject) {
        if (subject.pieceId() == piece->id) {
            subject.name = piece->name;
        }
    };
    renamed->piece = piece;
    if (renamed->error) {
        rename(renamed->error->subject);
    }
    if (renamed->flat) {
        for (Error& note : renamed->flat->notes) {
            rename(note.subject);
        }
    }
    if (renamed->exact) {
        renamed->exact = under(piece, *renamed->exact);
    }
    return renamed;
}

}  // namespace

PieceLabels withName(PieceLabels labels, const Garment& garment, int piece, std::string name) {
    const Piece& meant = *garment.pieces[static_cast<std::size_t>(piece)];
    const auto first = name.find_first_not_of(" \t"), last = name.find_last_not_of(" \t");
    name = first == std::string::npos ? std::string() : name.substr(first, last + 1 - first);
    name = shownText(name, kMaxPieceName);
    std::string& stated = labels[meant.id].name;
    if (name.empty() || name == meant.name) {
        stated.clear();
        return labels;
    }
    UniqueNames names;
    for (const auto& other : garment.pieces) {
        if (other->id != meant.id) {
            names.take(nameOf(labels, *other));
        }
    }
    stated = names.free(name);
    return labels;
}

std::string nameOf(const PieceLabels& labels, const Garment& garment, const Seam& seam) {
    const Piece& left = *garment.pieces[static_cast<std::size_t>(seam.left.piece)];
    if (!seam.name.starts_with(left.name)) {
        return seam.name;
    }
    std::string name = nameOf(labels, left);
    std::string rest = seam.name.substr(left.name.size());
    if (seam.kind == SeamKind::Seam && seam.right.piece != seam.left.piece) {
        const Piece& right = *garment.pieces[static_cast<std::size_t>(seam.right.piece)];
        const std::string own = " / " + right.name;
        if (rest.starts_with(own)) {
            name += " / " + nameOf(labels, right);
            rest = rest.substr(own.size());
        }
    }
    return name + rest;
}

Garment named(Garment garment, const PieceLabels& labels) {
    for (Seam& seam : garment.seams.seams) {
        seam.name = nameOf(labels, garment, seam);
    }
    std::map<std::string, std::string> nameOfOwn;
    const std::vector<std::string> names = namesOf(labels, garment);
    for (const auto& piece : garment.uncut) {
        nameOfOwn[piece->name] = nameOf(labels, *piece);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto& piece = garment.pieces[i];
        nameOfOwn[piece->name] = names[i];
        if (piece->name != names[i]) {
            auto renamed = std::make_shared<Piece>(*piece);
            renamed->name = names[i];
            nameDefect(*renamed);
            piece = std::move(renamed);
        }
    }
    for (AppliedCut& cut : garment.cuts) {
        const auto found = nameOfOwn.find(cut.piece);
        if (found != nameOfOwn.end()) {
            if (cut.name.starts_with(cut.piece)) {  // a cut named by Toile
                cut.name = found->second + cut.name.substr(cut.piece.size());
            }
            cut.piece = found->second;
        }
    }
    for (Error& problem : garment.problems) {
        problem.subject = labelled(labels, std::move(problem.subject));
    }
    return garment;
}

PieceResults resultsFor(const Garment& named, PieceResults results) {
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto& piece = named.pieces[i];
        if (results[i] && results[i]->piece != piece && results[i]->piece->id == piece->id) {
            results[i] = under(piece, *results[i]);
        }
    }
    return results;
}

}  // namespace toile
