// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "core/base/version.h"
#include "core/formats/json.h"
#include "core/prove/proof.h"

namespace toile {
namespace {

constexpr int kProofVersion = 1;  // grows if a field changes its meaning or is removed

Json provenPieceName(const Garment& garment, int piece) {
    return piece < 0 ? Json(nullptr) : text(garment.pieces[static_cast<std::size_t>(piece)]->name);
}

Json provenSeamName(const Garment& garment, int seam) {
    return seam < 0 ? Json(nullptr)
                    : text(garment.seams.seams[static_cast<std::size_t>(seam)].name);
}

Json spreadJson(const sew::SpreadFigures& figures) {
    return {{"mean", number(figures.mean)},
            {"p95", number(figures.most95)},
            {"max", number(figures.max)}};
}

Json wholeJson(const Garment& garment, const sew::SpreadFigures& figures, int piece) {
    Json json = spreadJson(figures);
    json["piece"] = provenPieceName(garment, piece);
    json["vertex"] = piece < 0 ? Json(nullptr) : Json(figures.place);
    return json;
}

Json provenPieceJson(const Piece& piece, const ProvenPiece& proven, const Fabric* fabric) {
    Json json{{"name", text(piece.name)}, {"sewn", proven.isSewn()}};
    if (proven.isSewn()) {
        json["fabric"] = fabric ? text(fabric->id) : Json(nullptr);
        json["gap_mm"] = spreadJson(proven.gapFigures);
        json["gap_mm"]["vertex"] = proven.gapFigures.place;
        json["pull"] = number(proven.mostPull);
        json["slack"] = number(proven.mostSlack);
        json["free_share"] = number(proven.freeShare);
    }
    return json;
}

Json provenSeamJson(const Garment& garment, const ProvenSeam& seam) {
    return {{"name", provenSeamName(garment, seam.seam)},
            {"left_mm", number(seam.left)},
            {"right_mm", number(seam.right)},
            {"slip_mm", number(seam.slip)},
            {"strain", number(seam.strain)}};
}

Json proofFaultJson(const Garment& garment, const Finding& fault) {
    Json json{{"code", text(name(fault.kind))}, {"subject", text(fault.subject.name)}};
    json["pieces"] = Json::array();
    for (const int piece : fault.pieces) {
        json["pieces"].push_back(provenPieceName(garment, piece));
    }
    json["seam"] = provenSeamName(garment, fault.seam);
    json["amount_mm"] = number(fault.badness);
    json["sentence"] = text(fault.reason);
    return json;
}

Json heldJson(const Proof& proof) {
    const ProofSettings& settings = proof.settings;
    const StatedStiffness& stated = settings.stiffness;
    const auto typed = [](const std::optional<double>& value) -> Json {
        return value ? number(*value) : Json(nullptr);
    };
    return {
        {"on", proof.hasBody ? "body" : "design"},
        {"body", proof.bodyName.empty() ? Json(nullptr) : text(proof.bodyName)},
        {"pressure_pa", number(settings.pressure)},
        {"gravity", settings.hasGravity},
        {"self_contact_mm", settings.touchesItself ? number(settings.thickness) : Json(nullptr)},
        {"scale", number(proof.scale)},
        {"stiffness",
         {{"warp", typed(stated.warp)},
          {"weft", typed(stated.weft)},
          {"shear", typed(stated.shear)},
          {"bending", typed(stated.bending)},
          {"weight", typed(stated.weight)}}}};
}

}  // namespace

std::string writeProof(const Garment& garment, const Proof& proof) {
    Json json{{"version", kProofVersion}, {"toile", text(version())}};
    json["sentence"] = text(sentence(proof, garment));
    json["gap_mm"] = wholeJson(garment, proof.gap, proof.gapPiece);
    json["strain"] = wholeJson(garment, proof.strain, proof.strainPiece);
    json["free_share"] = number(proof.freeShare);
    json["pieces"] = Json::array();
    for (std::size_t p = 0; p < proof.pieces.size(); ++p) {
        json["pieces"].push_back(
            provenPieceJson(*garment.pieces[p], proof.pieces[p],
                            p < proof.fabrics.size() ? &proof.fabrics[p] : nullptr));
    }
    json["seams"] = Json::array();
    for (const ProvenSeam& seam : proof.seams) {
        json["seams"].push_back(provenSeamJson(garment, seam));
    }
    json["faults"] = Json::array();
    for (const Finding& fault : proof.faults) {
        json["faults"].push_back(proofFaultJson(garment, fault));
    }
    json["source"] = text(proof.source);
    json["held"] = heldJson(proof);
    json["edge_mm"] = number(proof.edge);
    json["triangles"] = proof.triangles;
    json["iterations"] = proof.iterations;
    json["rest_force_n"] = number(proof.restForce);
    json["seam_force_n"] = number(proof.seamForce);
    json["share"] = number(restShare(proof));
    json["settled"] = proof.hasSettled;
    json["seconds"] = number(proof.seconds);
    return jsonText(json);
}

}  // namespace toile
