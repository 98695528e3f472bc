// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/feature_text.h"

#include <QStringList>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/text/figures.h"
#include "app/text/seam_fit.h"
#include "app/views/sewn_run.h"
#include "core/project/piece_settings.h"

namespace toile::app {

namespace {

QString seamText(const Document& document, int index) {
    const Garment& garment = *document.garment();
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(index)];
    const QString name = seamName(document, index);
    const auto measure = measured(garment, document.results(), index);
    if (seam.kind == SeamKind::Free) {
        return tr("%1 · %2").arg(
            name, lengthWithUnit(measure ? measure->length2dLeft : seam.length3d[0]));
    }
    if (!measure) {
        return tr("%1 · %2 / %3 in 3D")
            .arg(name, lengthNumber(seam.length3d[0]), lengthWithUnit(seam.length3d[1]));
    }
    return tr("%1 · %2 / %3, Δ %4")
        .arg(name, lengthNumber(measure->length2dLeft), lengthWithUnit(measure->length2dRight),
             signedFineLength(measure->deltaMm));
}

/// "front"; if it is sewn to other pieces, "front / sleeve_left, back".
QString nameOfRun(const Document& document, const Feature& run) {
    QStringList partners;
    for (const SewnPart& part : sewnParts(*document.garment(), run)) {
        partners << pieceName(document, part.there.piece);
    }
    partners.removeDuplicates();
    const QString name = pieceName(document, run.piece);
    return partners.isEmpty() ? name : name + " / " + partners.join(", ");
}

QString runText(const Document& document, const Feature& run) {
    const Garment& garment = *document.garment();
    const RunLengths lengths = runLengths(garment, document.results(), run);
    const QString name = nameOfRun(document, run);
    if (lengths.sewn == 0) {
        return tr("%1 · %2 of free edge").arg(name, lengthWithUnit(lengths.free));
    }
    const QString sewn =
        lengths.flat ? tr("%1, from corner to corner · %2 / %3, Δ %4")
                           .arg(name, lengthNumber(lengths.sewn), lengthWithUnit(lengths.partner),
                                signedFineLength(lengths.sewn - lengths.partner))
                     : tr("%1, from corner to corner · %2 / %3 in 3D")
                           .arg(name, lengthNumber(lengths.sewn), lengthWithUnit(lengths.partner));
    constexpr double kWorthTelling = 0.05;  // mm
    return lengths.free < kWorthTelling
               ? sewn
               : tr("%1 · %2 not sewn").arg(sewn, lengthWithUnit(lengths.free));
}

/// "Strain along warp +1.8 % (limit +2 %)"; empty if the overlay has no value there.
QString valueText(const Document& document, const std::optional<SurfaceHit>& place) {
    const auto value = place ? shownValueAt(document, *place) : std::nullopt;
    if (!value) {
        return {};
    }
    const Overlay overlay = document.view().overlay;
    const OverlayWords words = overlayWords(overlay);
    QString text = words.title + ' ' + overlayValueText(overlay, *value);
    const auto limits = fabricLimits(overlay, document.fabricOf(place->piece));
    if (!limits) {
        return text;
    }
    return tr("%1 (limit %2)")
        .arg(text, overlayNumber(overlay, *value < 0 ? limits->least : limits->most) +
                       QChar(0x202F) + words.unit);
}

/// Largest edge strain (by magnitude) around a vertex, in percent; nullopt if it is not flat.
std::optional<double> strainAtVertex(const Document& document, const Feature& feature) {
    const Scene* scene = document.scene().get();
    const auto at = static_cast<std::size_t>(feature.piece);
    if (!scene || at >= scene->pieces.size() || !scene->pieces[at].flat) {
        return std::nullopt;
    }
    const Piece& piece = *document.garment()->pieces[at];
    const std::size_t face =
        scene->pieces[at].garmentRun.first + static_cast<std::size_t>(feature.face);
    for (int k = 0; k < 3; ++k) {
        if (piece.mesh.F(feature.face, k) == feature.vertex) {
            const auto index = scene->garment.triangles[3 * face + static_cast<std::size_t>(k)];
            const auto& values = scene->vertices[index].values;
            const auto most = static_cast<double>(values[2]),
                       least = static_cast<double>(values[3]);
            return most >= -least ? most : least;
        }
    }
    return std::nullopt;
}

QString vertexText(const Document& document, const Piece& piece, const Feature& feature,
                   const QString& value) {
    const auto vertex = static_cast<std::size_t>(feature.vertex);
    // Numbers count from 1, as in files.
    const int source = vertex < piece.sourceVertex.size() ? piece.sourceVertex[vertex] : -1;
    const QString name = tr("Vertex %1").arg((source >= 0 ? source : feature.vertex) + 1);
    if (!value.isEmpty()) {
        return tr("%1 · %2").arg(name, value);
    }
    const auto strain = strainAtVertex(document, feature);
    return strain ? tr("%1 · strain %2 %").arg(name, signedNumber(*strain, 1)) : name;
}

}  // namespace

std::optional<double> shownValueAt(const Document& document, const SurfaceHit& place) {
    if (!document.scene()) {
        return std::nullopt;
    }
    const Scene& scene = *document.scene();
    const ViewState& view = document.view();
    const auto sewn = isOfProof(view.overlay) ? sewnOf(document) : nullptr;
    return valueAt(scene, placesOf(document.settings(), {}, document.state().materials), place,
                   view.overlay, overlayScale(scene, view.overlay, document.fabric(), sewn.get()),
                   view.valuesPerTriangle, sewn.get());
}

QString featureText(const Document& document, const Feature& feature,
                    const std::optional<SurfaceHit>& place) {
    if (!document.garment()) {
        return {};
    }
    if (feature.kind == Feature::Kind::Seam) {
        return feature.seam < document.seamCount() ? seamText(document, feature.seam) : QString();
    }
    if (feature.piece >= document.pieceCount()) {
        return {};
    }
    const Piece& piece = *document.garment()->pieces[static_cast<std::size_t>(feature.piece)];
    const QString name = pieceName(document, feature.piece);
    if (feature.kind == Feature::Kind::Run) {
        return runText(document, feature);
    }
    const QString value = valueText(document, place);
    if (feature.kind == Feature::Kind::Vertex) {
        return vertexText(document, piece, feature, value);
    }
    if (!value.isEmpty()) {
        return tr("%1 · %2").arg(name, value);
    }
    const PieceResult* result = document.result(feature.piece);
    const double area = result && result->quality ? result->quality->area2d : wornArea(piece);
    return tr("%1 · %2").arg(name, areaWithUnit(area));
}

QString markedText(const Document& document) {
    const auto& mark = document.mark();
    if (!document.garment() || !mark || mark->kind != Feature::Kind::Run) {
        return {};
    }
    return !document.seam() || document.seam() == seamOfRun(*document.garment(), *mark)
               ? featureText(document, *mark)
               : QString();
}

}  // namespace toile::app
