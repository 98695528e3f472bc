// SPDX-License-Identifier: GPL-3.0-or-later
// This file is long because it is one table, read from top to bottom, after the few helpers for
// work and conditions that its entries share.
#include "app/actions/action_table.h"

#include <QCoreApplication>
#include <QUndoStack>
#include <algorithm>
#include <numbers>
#include <utility>

#include "app/actions/garment_actions.h"
#include "app/actions/project_actions.h"
#include "app/document/layout.h"
#include "app/document/mirrored_edits.h"
#include "app/document/piece_edits.h"
#include "app/render/scene.h"
#include "app/session/cut_proposals.h"
#include "app/session/pattern_proof.h"
#include "app/session/workspace.h"
#include "app/text/figures.h"
#include "core/assemble/cut_pieces.h"

namespace toile::app {

namespace {

using PieceIndices = std::vector<int>;

constexpr double kRightAngle = std::numbers::pi / 2;

bool isOpen(Workspace& on) {
    return on.document().garment() != nullptr;
}

bool canRedo(Workspace& on) {
    return on.document().history().canRedo();
}

bool showsFigures(Workspace& on) {
    return isOpen(on) && isMeasured(on.document().view().overlay);
}

bool hasReference(Workspace& on) {
    const auto& scene = on.document().scene();
    return on.document().state().reference.file ||
           (scene && !scene->patternLines.reference.empty());
}

bool namesReference(Workspace& on) {
    return isOpen(on) && !on.document().state().reference.path.empty();
}

bool hasExactOutline(Workspace& on) {
    const auto& scene = on.document().scene();
    return scene && !scene->patternLines.exact.empty();
}

bool hasCuttingLine(Workspace& on) {
    const auto& scene = on.document().scene();
    return scene && !scene->patternLines.cutting.empty();
}

bool hasNotches(Workspace& on) {
    const auto& scene = on.document().scene();
    return scene && !scene->patternLines.notches.empty();
}

bool hasInternalLines(Workspace& on) {
    const auto& scene = on.document().scene();
    return scene && !(scene->patternLines.internal.empty() && scene->garmentLines.internal.empty());
}

bool drawsMirrored(Workspace& on) {
    return isOpen(on) && on.document().state().lines.mirror != Mirror::None;
}

bool hasCuts(Workspace& on) {
    return !on.loading().seams.cuts.empty();
}

bool saysOfSeams(Workspace& on) {
    return isOpen(on) && !on.loading().seams.empty();
}

const Seam* selectedSeam(Workspace& on) {
    const std::optional<int> seam = on.document().seam();
    return seam ? &on.document().garment()->seams.seams[static_cast<std::size_t>(*seam)] : nullptr;
}

bool isSewnSeam(Workspace& on) {
    const Seam* seam = selectedSeam(on);
    return seam && seam->kind != SeamKind::Free;
}

bool isOnePiece(Workspace& on) {
    return on.document().selection().size() == 1;
}

bool isAnyPiece(Workspace& on) {
    return !on.document().selection().empty();
}

bool isAnyPieceOut(Workspace& on, bool leftOut) {
    return std::ranges::any_of(on.document().selection(), [&on, leftOut](int piece) {
        return isLeftOut(on.document(), piece) == leftOut;
    });
}

bool isOneFlatPiece(Workspace& on) {
    return isOnePiece(on) && !selectedFlat(on.document()).empty();
}

/// Of the selected pieces those that cuts may open.
PieceIndices selectedOpenable(Workspace& on) {
    PieceIndices found;
    for (const int piece : on.document().selection()) {
        if (isOpenable(*on.document().garment()->pieces[static_cast<std::size_t>(piece)])) {
            found.push_back(piece);
        }
    }
    return found;
}

bool canExportThese(Workspace& on) {
    return on.canExport() && !selectedFlat(on.document()).empty();
}

/// The key that renames the selected piece states the ease of the selected seam.
bool isSeamMeant(Workspace& on) {
    return isSewnSeam(on) && !isOnePiece(on);
}

bool isFlatSeam(Workspace& on) {
    const auto isFlat = [&on](int piece) { return on.document().patternPiece(piece) != nullptr; };
    const Seam* seam = isSewnSeam(on) ? selectedSeam(on) : nullptr;
    return seam && isFlat(seam->left.piece) && isFlat(seam->right.piece);
}

bool isEasedSeam(Workspace& on) {
    const Seam* seam = selectedSeam(on);
    return seam && seam->ease;
}

bool isDart(Workspace& on) {
    const Seam* seam = selectedSeam(on);
    return seam && seam->kind == SeamKind::Dart && on.document().isCurrent();
}

bool isSeamOfDart(Workspace& on) {
    const Seam* seam = selectedSeam(on);
    return seam && seam->kind == SeamKind::Seam && on.cuts().isSeamOfDart(*on.document().seam());
}

bool isAnyFlat(Workspace& on) {
    return !allFlat(on.document()).empty();
}

bool isAnyGrainSet(Workspace& on) {
    return std::ranges::any_of(selectedOrAllFlat(on.document()), [&on](int piece) {
        return on.document().settings()[static_cast<std::size_t>(piece)].grain.has_value();
    });
}

/// Its doing is connected where it is done.
ActionWork whenOpen(ActionGroup group = ActionGroup::None) {
    return {.enabledWhen = isOpen, .group = group};
}

ActionWork asks(void (GarmentActions::*request)(), When when = nullptr) {
    return {[request](GarmentActions& on, bool) { (on.*request)(); }, std::move(when)};
}

ActionWork asks(void (Workspace::*request)(), When when) {
    return {[request](GarmentActions& on, bool) { (on.workspace().*request)(); }, std::move(when)};
}

ActionWork asksOfSeam(void (CutEditor::*request)(int), When when) {
    return {[request](GarmentActions& on, bool) {
                if (const auto seam = on.workspace().document().seam()) {
                    (on.workspace().cuts().*request)(*seam);
                }
            },
            std::move(when)};
}

ActionWork overlays(Overlay overlay) {
    return {[overlay](GarmentActions& on, bool) { on.workspace().document().setOverlay(overlay); },
            isOpen, [overlay](Workspace& on) { return on.document().view().overlay == overlay; },
            ActionGroup::Overlay};
}

/// Of sewn cloth: where none is, what sews it comes to the front.
ActionWork overlaysOfProof(Overlay overlay) {
    ActionWork work = overlays(overlay);
    work.run = [overlay](GarmentActions& on, bool) {
        Workspace& workspace = on.workspace();
        workspace.document().setOverlay(overlay);
        if (!workspace.document().isProofCurrent()) {
            workspace.proof().want();
        }
    };
    return work;
}

bool isProved(Workspace& on) {
    return on.document().isProofCurrent();
}

ActionWork switches(bool ViewState::*field, When when = isOpen) {
    return {
        [field](GarmentActions& on, bool isOn) { on.workspace().document().setView(field, isOn); },
        std::move(when), [field](Workspace& on) { return on.document().view().*field; },
        ActionGroup::Toggle};
}

ActionWork mirrorsEditsToo() {
    return {[](GarmentActions& on, bool isOn) { setMirrorsEdits(on.workspace().document(), isOn); },
            drawsMirrored, [](Workspace& on) { return mirrorsEdits(on.document()); },
            ActionGroup::Toggle};
}

ActionWork flattens(Method method) {
    return {[method](GarmentActions& on, bool) { on.workspace().setMethod(method); },
            {},
            [method](Workspace& on) { return on.document().options().method == method; },
            ActionGroup::Method};
}

ActionWork flattens(Quality quality) {
    return {[quality](GarmentActions& on, bool) { on.workspace().setQuality(quality); },
            [](Workspace& on) { return on.document().options().method == Method::Isometric; },
            [quality](Workspace& on) { return on.document().options().quality == quality; },
            ActionGroup::Quality};
}

/// A free outline has no boundary problem to solve.
ActionWork flattens(BoundarySolver solver) {
    return {[solver](GarmentActions& on, bool) { on.workspace().setBoundarySolver(solver); },
            [](Workspace& on) { return traits(on.document().options().method).solvesBoundary; },
            [solver](Workspace& on) { return on.document().options().boundarySolver == solver; },
            ActionGroup::Solver};
}

template <class Value>
ActionWork reads(ActionGroup group, Value LoadOptions::*field, void (Workspace::*set)(Value),
                 std::type_identity_t<Value> value, When when = nullptr) {
    return {[=](GarmentActions& on, bool) { (on.workspace().*set)(value); }, when,
            [=](Workspace& on) { return on.loading().*field == value; }, group};
}

/// Other settings of the file stay.
ActionWork readsAs(std::optional<FileKind> kind, ShellSurface surface = ShellSurface::Outer,
                   int onlyLayer = 0) {
    return {[=](GarmentActions& on, bool) {
                Preparation preparing = on.workspace().loading().preparing;
                preparing.as = kind;
                preparing.surface = surface;
                preparing.onlyLayer = onlyLayer;
                on.workspace().setPreparing(preparing);
            },
            {},
            [=](Workspace& on) {
                const Preparation& said = on.loading().preparing;
                return said.as == kind && (kind != FileKind::Shell || said.surface == surface) &&
                       said.onlyLayer == onlyLayer;
            },
            ActionGroup::ReadAs};
}

ActionWork cutsAsTailors() {
    return {[](GarmentActions& on, bool isOn) {
                on.workspace().setCutStyle(isOn ? CutStyle::Tailor : CutStyle::Topology);
            },
            {},
            [](Workspace& on) {
                return on.loading().autoCut && on.loading().cutStyle != CutStyle::Topology;
            },
            ActionGroup::Toggle};
}

ActionWork prepares(bool Preparation::*field) {
    return {[field](GarmentActions& on, bool isOn) {
                Preparation preparing = on.workspace().loading().preparing;
                preparing.*field = isOn;
                on.workspace().setPreparing(preparing);
            },
            {},
            [field](Workspace& on) { return on.loading().preparing.*field; },
            ActionGroup::Toggle};
}

ActionWork reads(bool LoadOptions::*field, void (Workspace::*set)(bool)) {
    return {[set](GarmentActions& on, bool isOn) { (on.workspace().*set)(isOn); },
            {},
            [field](Workspace& on) { return on.loading().*field; },
            ActionGroup::Toggle};
}

/// Does something to the selected pieces that are flat, of which there have to be so many.
ActionWork onSelected(std::size_t least,
                      std::function<void(Document&, const PieceIndices&)> change) {
    return {[change = std::move(change)](GarmentActions& on, bool) {
                Document& document = on.workspace().document();
                if (const PieceIndices pieces = selectedFlat(document); !pieces.empty()) {
                    change(document, pieces);
                }
            },
            [least](Workspace& on) { return selectedFlat(on.document()).size() >= least; }};
}

/// Does something to the selected pieces, flat or not.
ActionWork onPieces(std::function<void(Document&, const PieceIndices&)> change, When when) {
    return {[change = std::move(change)](GarmentActions& on, bool) {
                Document& document = on.workspace().document();
                const Document::Selection pieces = document.selection();
                change(document, {pieces.begin(), pieces.end()});
            },
            std::move(when)};
}

ActionWork turns(double angle) {
    return onSelected(1, [angle](Document& document, const PieceIndices& pieces) {
        turnTogether(document, GarmentActions::tr("Turn %1"), pieces, angle);
    });
}

ActionWork mirrors(Mirroring mirroring) {
    return onSelected(1, [mirroring](Document& document, const PieceIndices& pieces) {
        mirrorTogether(document, GarmentActions::tr("Mirror %1"), pieces, mirroring);
    });
}

template <class Where>
ActionWork arranges(void (*arrange)(Document&, const PieceIndices&, Where), Where where,
                    std::size_t least) {
    return onSelected(least, [=](Document& document, const PieceIndices& pieces) {
        arrange(document, pieces, where);
    });
}

/// To the selected pieces, or to all where none is.
ActionWork onChosen(void (*change)(Document&, const PieceIndices&)) {
    return {[change](GarmentActions& on, bool) {
                change(on.workspace().document(), selectedOrAllFlat(on.workspace().document()));
            },
            isAnyFlat};
}

// lupdate knows this name, and takes the namespace for the context.
#define TR(text) text

std::vector<ActionSpec> makeActions() {
    using Group = ActionGroup;
    return {
        {ActionId::Open, "open", TR("&Open…"), "Ctrl+O",
         TR("Open a project or a garment: one file, or several that belong together"),
         asks(&GarmentActions::askAndOpen), "open", TR("Open")},
        {ActionId::Save,
         "save",
         TR("&Save"),
         "Ctrl+S",
         TR("Save everything done with this garment in its project file"),
         {[](GarmentActions& on, bool) { on.project().save(); }, isOpen},
         "save",
         TR("Save")},
        {ActionId::SaveAs,
         "saveAs",
         TR("Save &as…"),
         "Ctrl+Shift+S",
         TR("Save everything done with this garment in another project file"),
         {[](GarmentActions& on, bool) { on.project().saveAs(); }, isOpen}},
        {ActionId::ExportPattern, "exportPattern", TR("&Export pattern…"), "Ctrl+E",
         TR("Write the pattern to a file: for printing, cutting, pattern and 3D programs"),
         asks(&GarmentActions::askAndExport, &Workspace::canExport), "export", TR("Export")},
        {ActionId::OpenReference, "openReference", TR("Open reference &pattern…"), "",
         TR("Lay a pattern over the flat pieces, to compare: DXF, SVG or GarmentCode"),
         asks(&GarmentActions::askAndOpenReference, isOpen)},
        {ActionId::CloseReference, "closeReference", TR("&Close reference pattern"), "",
         TR("Compare with no pattern any more"), asks(&Workspace::closeReference, namesReference)},
        {ActionId::PrintPattern, "printPattern", TR("&Print pattern…"), "Ctrl+P",
         TR("Print the pattern at true scale, on pages to join or on large sheets"),
         asks(&GarmentActions::askAndPrint, &Workspace::canExport)},
        {ActionId::ReadyToCut, "readyToCut", TR("Read&y to cut?"), "F8",
         TR("Show whether the pattern can be cut as it is, and every fault with its place"),
         whenOpen(), "check", TR("Check")},
        {ActionId::Quit, "quit", TR("&Quit"), "Ctrl+Q", TR("Close the window")},
        {ActionId::Undo, "undo", TR("&Undo"), "Ctrl+Z", TR("Take the last step back"),
         asks(&Workspace::undo, &Workspace::canUndo), "undo", TR("Undo")},
        {ActionId::Redo,
         "redo",
         TR("&Redo"),
         "Ctrl+Shift+Z",
         TR("Do again what was taken back"),
         {[](GarmentActions& on, bool) { on.workspace().document().history().redo(); }, canRedo},
         "redo",
         TR("Redo")},
        {ActionId::SelectAll, "selectAll", TR("Select &all"), "Ctrl+A", TR("Select every piece"),
         asks(&GarmentActions::selectAll, isOpen)},
        {ActionId::SelectNone, "selectNone", TR("Select &none"), "Ctrl+Shift+A",
         TR("Clear the selection of pieces and seams"), asks(&GarmentActions::selectNone, isOpen)},
        {ActionId::SelectSameMaterial, "selectSameMaterial", TR("Select &same material"), "",
         TR("Select every piece that is cut from what the selected pieces are cut from"),
         onPieces(selectSameMaterial, isAnyPiece)},
        {ActionId::SelectSameLayer, "selectSameLayer", TR("Select same la&yer"), "",
         TR("Select every piece of the layers of cloth that the selected pieces are of"),
         onPieces(selectSameLayer,
                  [](Workspace& on) { return isAnyPiece(on) && hasLayers(on.document()); })},
        {ActionId::Frame, "frame", TR("&Frame"), "F",
         TR("Show the selected pieces or seam, or everything where none is selected"), whenOpen(),
         "frame", TR("Frame")},
        {ActionId::OverlayNone, "overlayNone", TR("Piece &colours"), "1",
         TR("Every piece in its own colour"), overlays(Overlay::None), "overlay-none",
         TR("Colours")},
        {ActionId::OverlayChecker, "overlayChecker", TR("Check&erboard"), "2",
         TR("True-scale squares on the cloth"), overlays(Overlay::Checker), "overlay-checker",
         TR("Checker")},
        {ActionId::OverlayArea, "overlayArea", TR("&Area change"), "3",
         TR("How much area the cloth must gain by stretching, or has too much"),
         overlays(Overlay::Area), "overlay-area", TR("Area")},
        {ActionId::OverlayAngle, "overlayAngle", TR("An&gle change"), "4",
         TR("How much the corners of the cloth have turned"), overlays(Overlay::Angle),
         "overlay-angle", TR("Angle")},
        {ActionId::OverlayStrain, "overlayStrain", TR("Edge &strain"), "5",
         TR("How far the cloth must stretch or gather to take its shape"),
         overlays(Overlay::Strain), "overlay-strain", TR("Strain")},
        {ActionId::OverlayWarp, "overlayWarp", TR("Strain along war&p"), "6",
         TR("How far the cloth must stretch or gather along the grain"), overlays(Overlay::Warp),
         "overlay-warp", TR("Warp")},
        {ActionId::OverlayWeft, "overlayWeft", TR("Strain along we&ft"), "7",
         TR("How far the cloth must stretch or gather across the grain"), overlays(Overlay::Weft),
         "overlay-weft", TR("Weft")},
        {ActionId::OverlayBias, "overlayBias", TR("Strain on the &bias"), "8",
         TR("How far the cloth must stretch or gather at 45° to the grain, the worse of both "
            "diagonals"),
         overlays(Overlay::Bias), "overlay-bias", TR("Bias")},
        {ActionId::OverlayPrincipal, "overlayPrincipal", TR("Principal s&train"), "9",
         TR("Crosses show in which directions the cloth stretches and gathers most, and how far"),
         overlays(Overlay::Principal), "overlay-principal", TR("Principal")},
        {ActionId::OverlayDirichlet, "overlayDirichlet", TR("&Distortion energy"), "0",
         TR("Symmetric Dirichlet energy: one number for stretch and surplus in all directions"),
         overlays(Overlay::Dirichlet), "overlay-dirichlet", TR("Energy")},
        {ActionId::OverlayNormal, "overlayNormal", TR("Surface &normals"), "",
         TR("Where the worn cloth faces, one colour for each direction"), overlays(Overlay::Normal),
         "overlay-normal", TR("Normals")},
        {ActionId::OverlayGap, "overlayGap", TR("Gap of the sewn c&loth"), "",
         TR("How far the pattern, sewn back together, lies outside or inside of the design"),
         overlaysOfProof(Overlay::Gap), "overlay-gap", TR("Gap")},
        {ActionId::OverlayWornStrain, "overlayWornStrain", TR("&Worn strain of the sewn cloth"), "",
         TR("How far the cloth is strained where the pattern is sewn back together"),
         overlaysOfProof(Overlay::WornStrain), "overlay-worn-strain", TR("Worn strain")},
        {ActionId::ValuesPerTriangle, "valuesPerTriangle", TR("&Values per triangle"), "Shift+V",
         TR("Paint every triangle in the colour of its own value, without smoothing"),
         switches(&ViewState::valuesPerTriangle, showsFigures), "values-per-triangle",
         TR("Per triangle")},
        {ActionId::WorstSpots, "worstSpots", TR("Mark the w&orst spots"), "Shift+W",
         TR("Mark the places with the worst values with a number"),
         switches(&ViewState::worstSpots, showsFigures), "worst-spots", TR("Worst spots")},
        {ActionId::Wireframe, "wireframe", TR("Show &wireframe"), "W",
         TR("Draw the triangles of the cloth"), switches(&ViewState::wireframe), "wireframe",
         TR("Wireframe")},
        {ActionId::ReferencePanels, "referencePanels", TR("Referen&ce panels"), "D",
         TR("Draw the reference panels, the designer's own, over the flat pieces, where the file "
            "has them, or the reference pattern that is open"),
         switches(&ViewState::referencePanels, hasReference)},
        {ActionId::ExactOutline, "exactOutline", TR("Exact o&utline"), "Shift+X",
         TR("Draw the outline as it was solved, dashed, where a fair line is drawn in its place"),
         switches(&ViewState::exactOutline, hasExactOutline)},
        {ActionId::ShowSeams, "showSeams", TR("&Seam lines"), "Shift+S",
         TR("Draw the seam lines, both sides of a seam in one colour"),
         switches(&ViewState::seams)},
        {ActionId::CuttingLine, "cuttingLine", TR("&Cutting line"), "",
         TR("Draw the line that pieces with a seam allowance are cut along"),
         switches(&ViewState::cuttingLine, hasCuttingLine)},
        {ActionId::Notches, "notches", TR("&Notches"), "",
         TR("Draw the notches of the pattern, where it has some"),
         switches(&ViewState::notches, hasNotches)},
        {ActionId::InternalLines, "internalLines", TR("&Internal lines"), "",
         TR("Draw internal lines and drill points, and in the pattern the marks of darts"),
         switches(&ViewState::internalLines, hasInternalLines)},
        {ActionId::GrainArrows, "grainArrows", TR("&Grain"), "",
         TR("Draw the grain of each piece in the pattern view"), switches(&ViewState::grain)},
        {ActionId::Labels, "labels", TR("&Labels"), "",
         TR("Write the names of the pieces in the pattern view"), switches(&ViewState::labels)},
        {ActionId::Xray, "xray", TR("&X-ray"), "X",
         TR("See through the cloth of the garment to what lies behind it"),
         switches(&ViewState::xray)},
        {ActionId::Shaded, "shaded", TR("Light and s&hade"), "Shift+L",
         TR("Let light fall on the garment; without it colours are as flat as in the pattern"),
         switches(&ViewState::shaded)},
        {ActionId::PieceColours, "pieceColours", TR("Pieces &in colour"), "Shift+C",
         TR("Give every piece a colour of its own; else all cloth is plain cotton"),
         switches(&ViewState::pieceColours)},
        {ActionId::LookFront, "lookFront", TR("From the &front"), "",
         TR("Look at the garment's front (1 on the number pad)"), whenOpen()},
        {ActionId::LookBack, "lookBack", TR("From the &back"), "",
         TR("Look at the garment's back (Ctrl+1 on the number pad)"), whenOpen()},
        {ActionId::LookRight, "lookRight", TR("From the &right"), "",
         TR("Look at the garment from the right of the picture (3 on the number pad)"), whenOpen()},
        {ActionId::LookLeft, "lookLeft", TR("From the &left"), "",
         TR("Look at the garment from the left of the picture (Ctrl+3 on the number pad)"),
         whenOpen()},
        {ActionId::LookTop, "lookTop", TR("From &above"), "",
         TR("Look down at the garment (7 on the number pad)"), whenOpen()},
        {ActionId::LookBottom, "lookBottom", TR("From b&elow"), "",
         TR("Look up at the garment (Ctrl+7 on the number pad)"), whenOpen()},
        {ActionId::Orthographic, "orthographic", TR("Without &perspective"), "",
         TR("Draw the garment so that parallel lines stay parallel (5 on the number pad)"),
         whenOpen(Group::Toggle)},
        {ActionId::PlayMorph, "playMorph", TR("Play from garment to pa&ttern"), "Shift+M",
         TR("Watch the garment flatten, or the pattern close to the garment again"), whenOpen()},
        {ActionId::PlaySewn,
         "playSewn",
         TR("Play from design to sew&n"),
         "",
         TR("Watch the cloth go from the design to where the sewn pattern comes to rest"),
         {.enabledWhen = isProved}},
        {ActionId::WalkSeam,
         "walkSeam",
         TR("Walk the s&eam"),
         "Shift+R",
         TR("Roll one piece along the selected seam of the other, and see whether both sides and "
            "their notches meet"),
         {.enabledWhen = isFlatSeam}},
        {ActionId::MethodIsometric, "methodIsometric", methodText(Method::Isometric), "",
         TR("Seam lines keep their exact length; the cloth between them stretches as little as "
            "that "
            "allows, and no triangle is flipped"),
         flattens(Method::Isometric)},
        {ActionId::MethodCurvature, "methodCurvature", methodText(Method::Curvature), "",
         TR("Seam lines keep their exact length; the outline turns where the garment is curved"),
         flattens(Method::Curvature)},
        {ActionId::MethodWang2005, "methodWang2005", methodText(Method::Wang2005), "",
         TR("Seam lines keep their exact length; the outline gives way alike all around (Wang "
            "2005)"),
         flattens(Method::Wang2005)},
        {ActionId::MethodStretch, "methodStretch", methodText(Method::Stretch), "",
         TR("Seam lines keep their exact length on a round outline; the cloth inside is moved "
            "until it stretches least (Yoshizawa 2004)"),
         flattens(Method::Stretch)},
        {ActionId::MethodConvex, "methodConvex", methodText(Method::Convex), "",
         TR("Seam lines keep their exact length on a round outline: no triangle is ever "
            "flipped, but it is no pattern (Floater 2003)"),
         flattens(Method::Convex)},
        {ActionId::MethodNatural, "methodNatural", methodText(Method::Natural), "",
         TR("The cloth keeps its angles as well as it can; seam lines change their length (Desbrun "
            "2002)"),
         flattens(Method::Natural)},
        {ActionId::MethodLscm, "methodLscm", methodText(Method::Lscm), "",
         TR("Nearly the same by another way; seam lines change their length (Lévy 2002)"),
         flattens(Method::Lscm)},
        {ActionId::MethodAbf, "methodAbf", methodText(Method::Abf), "",
         TR("Every triangle keeps its angles as well as it can; seam lines change their length "
            "(Sheffer "
            "2005)"),
         flattens(Method::Abf)},
        {ActionId::QualityDraft, "qualityDraft", TR("&Draft"), "",
         TR("Quick: within some percent of the least distortion"), flattens(Quality::Draft)},
        {ActionId::QualityStandard, "qualityStandard", TR("&Standard"), "",
         TR("Within about a thousandth of the least distortion"), flattens(Quality::Standard)},
        {ActionId::QualityFine, "qualityFine", TR("&Fine"), "",
         TR("To the last digits: takes its time"), flattens(Quality::Fine)},
        {ActionId::SolverNewton, "solverNewton", TR("Outli&ne the fast way"), "",
         TR("The outline by Newton steps"), flattens(BoundarySolver::Newton)},
        {ActionId::SolverSlcp, "solverSlcp", TR("Out&line the published way"), "",
         TR("The same outline by linearly constrained steps, as in the paper of 2005"),
         flattens(BoundarySolver::Slcp)},
        {ActionId::CompareMethods, "compareMethods", TR("C&ompare methods…"), "Ctrl+M",
         TR("See one piece flattened by up to four methods side by side, with a table of figures"),
         whenOpen()},
        {ActionId::LayOnCloth, "layOnCloth", TR("Lay on clot&h…"), "Ctrl+Shift+M",
         TR("Lay the pieces on their cloth so that little of it is left over: the marker, with its "
            "length"),
         whenOpen()},
        {ActionId::ProveBySewing,
         "proveBySewing",
         TR("Prove by se&wing"),
         "F9",
         TR("Sew the pattern back together over the design, as its lines are written, and measure "
            "how far from the design it comes to rest"),
         {[](GarmentActions& on, bool) {
              on.workspace().proof().want();
              on.workspace().proof().begin();
          },
          [](Workspace& on) { return on.proof().canProve(); }}},
        {ActionId::SaveProof, "saveProof", TR("Save report o&f the proof…"), "",
         TR("Write what sewing the pattern has shown to a JSON file"),
         asks(&GarmentActions::askAndSaveProof, isProved)},
        {ActionId::ToolSelect, "toolSelect", TR("&Select"), "V",
         TR("Select pieces, seams and vertices; move pieces in the pattern"), whenOpen(Group::Tool),
         "tool-select", TR("Select")},
        {ActionId::ToolCut, "toolCut", TR("&Cut"), "C",
         TR("Cut a piece along the shortest path through points on it"), whenOpen(Group::Tool),
         "tool-cut", TR("Cut")},
        {ActionId::ToolLoop, "toolLoop", TR("Closed &loop"), "L",
         TR("Cut a part out along a closed line through points on it"), whenOpen(Group::Tool),
         "tool-loop", TR("Loop")},
        {ActionId::ToolDart, "toolDart", TR("&Dart"), "T",
         TR("Cut from an edge to a tip inside the cloth"), whenOpen(Group::Tool), "tool-dart",
         TR("Dart")},
        {ActionId::ToolJoin, "toolJoin", TR("&Join"), "J",
         TR("Join the cloth on both sides of a seam, so that it becomes one"),
         whenOpen(Group::Tool), "tool-join", TR("Join")},
        {ActionId::ToolMeasure, "toolMeasure", TR("&Measure"), "M",
         TR("Measure on the garment and in the pattern, straight and along edges"),
         whenOpen(Group::Tool), "tool-measure", TR("Measure")},
        {ActionId::FlattenAgain, "flattenAgain", TR("Flatten &again"), "Ctrl+F5",
         TR("Flatten every piece again"), asks(&Workspace::flattenAgain, isOpen), "flatten",
         TR("Flatten")},
        {ActionId::AutoFlatten,
         "autoFlatten",
         TR("Flatten after every ed&it"),
         "",
         TR("Flatten what an edit has changed at once; switch it off for heavy meshes"),
         {[](GarmentActions& on, bool isOn) { on.workspace().setAutoFlatten(isOn); },
          {},
          &Workspace::autoFlatten,
          Group::Toggle}},
        {ActionId::Cancel, "cancel", TR("&Cancel"), "Esc", TR("Stop what is running"),
         asks(&Workspace::cancel, &Workspace::isBusy), "cancel"},
        {ActionId::Reload, "reload", TR("&Reload"), "F5",
         TR("Read the garment's files again as they are now"), asks(&Workspace::reload, isOpen)},
        {ActionId::UnitAuto, "unitAuto", TR("&Automatic"), "",
         TR("Choose the unit that gives a garment of human size"),
         reads(Group::Unit, &LoadOptions::unit, &Workspace::setUnit, {})},
        {ActionId::UnitMillimetre, "unitMillimetre", TR("&Millimetres"), "",
         TR("Read the file's numbers as millimetres"),
         reads(Group::Unit, &LoadOptions::unit, &Workspace::setUnit, LengthUnit::Millimetre)},
        {ActionId::UnitCentimetre, "unitCentimetre", TR("&Centimetres"), "",
         TR("Read the file's numbers as centimetres"),
         reads(Group::Unit, &LoadOptions::unit, &Workspace::setUnit, LengthUnit::Centimetre)},
        {ActionId::UnitDecimetre, "unitDecimetre", TR("&Decimetres"), "",
         TR("Read the file's numbers as decimetres, as MakeHuman writes them"),
         reads(Group::Unit, &LoadOptions::unit, &Workspace::setUnit, LengthUnit::Decimetre)},
        {ActionId::UnitMetre, "unitMetre", TR("M&etres"), "",
         TR("Read the file's numbers as metres"),
         reads(Group::Unit, &LoadOptions::unit, &Workspace::setUnit, LengthUnit::Metre)},
        {ActionId::UnitInch, "unitInch", TR("&Inches"), "", TR("Read the file's numbers as inches"),
         reads(Group::Unit, &LoadOptions::unit, &Workspace::setUnit, LengthUnit::Inch)},
        {ActionId::UpAuto, "upAuto", TR("&Automatic"), "",
         TR("Choose the axis along which a garment would stand upright"),
         reads(Group::UpAxis, &LoadOptions::up, &Workspace::setUpAxis, {})},
        {ActionId::UpY, "upY", TR("&Y points up"), "",
         TR("The garment stands along the file's y axis"),
         reads(Group::UpAxis, &LoadOptions::up, &Workspace::setUpAxis, UpAxis::Y)},
        {ActionId::UpZ, "upZ", TR("&Z points up"), "",
         TR("The garment stands along the file's z axis"),
         reads(Group::UpAxis, &LoadOptions::up, &Workspace::setUpAxis, UpAxis::Z)},
        {ActionId::ReadAuto, "readAuto", TR("&Automatic"), "",
         TR("Recognise what the file holds: a sheet, a thick shell, layers, a scan"), readsAs({})},
        {ActionId::ReadSheet, "readSheet", TR("&Plain sheet"), "",
         TR("Take every face of the file, as it is"), readsAs(FileKind::Sheet)},
        {ActionId::ReadOuter, "readOuter", TR("Thick shell, &outer surface"), "",
         TR("Of cloth with a thickness take the outer surface, without its rims"),
         readsAs(FileKind::Shell, ShellSurface::Outer)},
        {ActionId::ReadInner, "readInner", TR("Thick shell, &inner surface"), "",
         TR("Of cloth with a thickness take the inner surface, without its rims"),
         readsAs(FileKind::Shell, ShellSurface::Inner)},
        {ActionId::ReadMiddle, "readMiddle", TR("Thick shell, &middle"), "",
         TR("Of cloth with a thickness take what runs midway between its surfaces"),
         readsAs(FileKind::Shell, ShellSurface::Middle)},
        {ActionId::ReadLayers, "readLayers", TR("&Layers of cloth, all"), "",
         TR("Take every sheet of a file in which one lies inside the other, as a lining does: each "
            "layer is a material"),
         readsAs(FileKind::Layers)},
        {ActionId::ReadOuterLayer, "readOuterLayer", TR("Layers of cloth, ou&termost alone"), "",
         TR("Of sheets that lie inside each other take the outermost"),
         readsAs(FileKind::Layers, ShellSurface::Outer, 1)},
        {ActionId::ReadInnerLayer, "readInnerLayer", TR("Layers of cloth, secon&d alone"), "",
         TR("Of sheets that lie inside each other take the second from outside: the lining"),
         readsAs(FileKind::Layers, ShellSurface::Outer, 2)},
        {ActionId::ReadScan,
         "readScan",
         TR("&Scan…"),
         "",
         TR("Make a sheet of a scan: drop debris, close small holes, smooth noise"),
         {.enabledWhen = isOpen,
          .checkedWhen = [](Workspace& on) { return on.loading().preparing.as == FileKind::Scan; },
          .group = Group::ReadAs}},
        {ActionId::SplitAuto, "splitAuto", TR("&Automatic"), "",
         TR("Divide the garment into pieces by what the file has"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Auto)},
        {ActionId::SplitComponents, "splitComponents", TR("Connected &parts"), "",
         TR("Whatever hangs together is one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Components)},
        {ActionId::SplitObjects, "splitObjects", TR("&Objects"), "",
         TR("Each object of the file is one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Objects)},
        {ActionId::SplitGroups, "splitGroups", TR("&Groups"), "",
         TR("Each group of the file is one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Groups)},
        {ActionId::SplitMaterials, "splitMaterials", TR("&Materials"), "",
         TR("Each material of the file is one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Materials)},
        {ActionId::SplitUv, "splitUv", TR("&UV islands"), "",
         TR("Each island of the file's UV map is one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Uv)},
        {ActionId::SplitSeams, "splitSeams", TR("&Cuts only"), "",
         TR("One piece until a cut of the seams file parts it"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Seams, hasCuts)},
        {ActionId::AutoCut, "autoCut", TR("&Cut open automatically"), "",
         TR("Cut open every piece that cannot lie flat as it is"),
         reads(&LoadOptions::autoCut, &Workspace::setAutoCut)},
        {ActionId::CompleteHalf, "completeHalf", TR("Complete &half a garment"), "",
         TR("Add the mirror image of a garment of which the file has one half"),
         prepares(&Preparation::isHalf)},
        {ActionId::TurnOver, "turnOver", TR("Turn i&nside out"), "",
         TR("Turn all faces of the garment over: the other side of the cloth is the right one"),
         prepares(&Preparation::isTurned)},
        {ActionId::TailorCuts, "tailorCuts", TR("Cut as &tailors do"), "",
         TR("Cut a garment of one skin open along armholes, sides and shoulders, where it is seen "
            "how it is worn"),
         cutsAsTailors()},
        {ActionId::ProposeCuts,
         "proposeCuts",
         TR("Pr&opose cuts…"),
         "",
         TR("Show cuts that a tailor would make in the selected piece, with their length and what "
            "they do to strain: to be made all, one by one, moved by hand, or not at all"),
         {[](GarmentActions& on, bool) { on.workspace().proposals().open(); }, isOpen}},
        {ActionId::Weld, "weld", TR("&Weld vertices"), "",
         TR("Join vertices of an object that lie on each other"),
         reads(&LoadOptions::weld, &Workspace::setWeld)},
        {ActionId::CloseSlits, "closeSlits", TR("Close s&lits"), "",
         TR("Sew shut the slits inside pieces, as texture maps have them"),
         reads(&LoadOptions::closeSlits, &Workspace::setCloseSlits)},
        {ActionId::SeamsFromFile, "seamsFromFile", TR("&Seams from file…"), "",
         TR("Take cuts and ease from a seams file (JSON)"),
         asks(&GarmentActions::askAndReadSeams, isOpen)},
        {ActionId::SeamsToFile, "seamsToFile", TR("Save sea&ms file…"), "",
         TR("Write the cuts and the ease that were stated to a seams file (JSON)"),
         asks(&GarmentActions::askAndWriteSeams, saysOfSeams)},
        {ActionId::RenamePiece,
         "renamePiece",
         TR("&Rename…"),
         "F2",
         TR("Type what the selected piece is called, on the screen and in files"),
         {.enabledWhen = isOnePiece}},
        {ActionId::SetQuantity,
         "setQuantity",
         TR("&Quantity…"),
         "",
         TR("Type how many of the selected pieces are cut"),
         {.enabledWhen = isAnyPiece}},
        {ActionId::NewMaterial, "newMaterial", TR("&New material…"), "",
         TR("Type what the selected pieces are cut from: a lining, an interfacing"),
         asks(&GarmentActions::askForMaterial, isAnyPiece)},
        {ActionId::HidePieces, "hidePieces", TR("&Hide"), "Ctrl+H",
         TR("Draw the selected pieces in neither view; files and checks have them nevertheless"),
         onPieces(hidePieces, isAnyPiece)},
        {ActionId::ShowOnlyThese, "showOnlyThese", TR("Show &only these"), "Ctrl+Shift+H",
         TR("Hide all pieces but the selected ones; files and checks have them nevertheless"),
         onPieces(showOnlyPieces, isAnyPiece)},
        {ActionId::ShowAllPieces,
         "showAllPieces",
         TR("Show &all"),
         "Ctrl+Alt+H",
         TR("Draw the hidden pieces again"),
         {[](GarmentActions& on, bool) { showAllPieces(on.workspace().document()); },
          [](Workspace& on) { return isAnyHidden(on.document()); }}},
        {ActionId::ExportOnlyThese, "exportOnlyThese", TR("&Export only these…"), "",
         TR("Write the selected pieces alone to a file"),
         asks(&GarmentActions::askAndExportThese, canExportThese)},
        {ActionId::LeaveOut, "leaveOut", TR("&Leave out"), "",
         TR("Take the selected pieces out of the pattern, as buttons and zips are: they are not "
            "flattened, and in no file, check or figure"),
         onPieces([](Document& document,
                     const PieceIndices& pieces) { setLeftOut(document, pieces, true); },
                  [](Workspace& on) { return isAnyPieceOut(on, false); })},
        {ActionId::TakeIn, "takeIn", TR("&Take in"), "",
         TR("Put the selected pieces that are left out back into the pattern"),
         onPieces([](Document& document,
                     const PieceIndices& pieces) { setLeftOut(document, pieces, false); },
                  [](Workspace& on) { return isAnyPieceOut(on, true); })},
        {ActionId::LeaveOutSmall, "leaveOutSmall", TR("Leave out &small pieces…"), "",
         TR("Leave out all pieces below an area that you type"), whenOpen()},
        {ActionId::CutOpen,
         "cutOpen",
         TR("Cut o&pen"),
         "",
         TR("Cut the selected pieces open that cannot lie flat as they are; the others stay"),
         {[](GarmentActions& on, bool) {
              on.workspace().cuts().openPieces(selectedOpenable(on.workspace()));
          },
          [](Workspace& on) { return !selectedOpenable(on).empty(); }}},
        {ActionId::DartHere,
         "dartHere",
         TR("&Dart here…"),
         "",
         TR("Propose a dart from the nearest edge to the place that is pointed at, or has a ring: "
            "Enter cuts it, Escape throws it away"),
         {.enabledWhen = isOneFlatPiece}},
        {ActionId::StateEase,
         "stateEase",
         TR("State the &ease…"),
         "F2",
         TR("Say how much longer the left edge of the selected seam is meant to be"),
         {.enabledWhen = isSeamMeant}},
        {ActionId::JoinSeam, "joinSeam", TR("&Join at this seam"), "",
         TR("Join the cloth on both sides of the selected seam; a cut of yours is taken back"),
         asksOfSeam(&CutEditor::joinSeam, isSewnSeam)},
        {ActionId::ResetEase, "resetEase", TR("Ease fro&m the garment"), "Del",
         TR("Take the ease of the selected seam from its 3D lengths again"),
         asks(&GarmentActions::resetEase, isEasedSeam)},
        {ActionId::ToolGrain, "toolGrain", TR("&Grain"), "G",
         TR("Turn the grain of a piece by its arrow in the pattern view"), whenOpen(Group::Tool),
         "tool-grain", TR("Grain")},
        {ActionId::ToolNotch, "toolNotch", TR("&Notch"), "N",
         TR("Add notches to seams, on both sides at once, move them and take them away"),
         whenOpen(Group::Tool), "tool-notch", TR("Notch")},
        {ActionId::ToolInternalLine, "toolInternalLine", TR("&Internal line"), "I",
         TR("Draw lines and drill points within the cloth, and change them"), whenOpen(Group::Tool),
         "tool-line", TR("Internal line")},
        {ActionId::TurnLeft, "turnLeft", TR("Turn &left"), "[",
         TR("Turn the selected pieces anti-clockwise by a right angle"), turns(kRightAngle)},
        {ActionId::TurnRight, "turnRight", TR("Turn &right"), "]",
         TR("Turn the selected pieces clockwise by a right angle"), turns(-kRightAngle)},
        {ActionId::MirrorLeftRight, "mirrorLeftRight", TR("&Mirror left to right"), "H",
         TR("Turn the selected pieces over from left to right: their wrong side faces you then"),
         mirrors(Mirroring::LeftRight)},
        {ActionId::MirrorUpsideDown, "mirrorUpsideDown", TR("Mirror &upside down"), "Shift+H",
         TR("Turn the selected pieces over from top to bottom: their wrong side faces you then"),
         mirrors(Mirroring::UpsideDown)},
        {ActionId::AlignLeft, "alignLeft", TR("&Left edges"), "",
         TR("Line the selected pieces up along their left edges"),
         arranges(align, Alignment::Left, 2)},
        {ActionId::AlignRight, "alignRight", TR("&Right edges"), "",
         TR("Line the selected pieces up along their right edges"),
         arranges(align, Alignment::Right, 2)},
        {ActionId::AlignTop, "alignTop", TR("&Upper edges"), "",
         TR("Line the selected pieces up along their upper edges"),
         arranges(align, Alignment::Top, 2)},
        {ActionId::AlignBottom, "alignBottom", TR("Lo&wer edges"), "",
         TR("Line the selected pieces up along their lower edges"),
         arranges(align, Alignment::Bottom, 2)},
        {ActionId::AlignCentre, "alignCentre", TR("&Middles, one above the other"), "",
         TR("Centre the selected pieces on one upright line"),
         arranges(align, Alignment::Centre, 2)},
        {ActionId::AlignMiddle, "alignMiddle", TR("Middles, si&de by side"), "",
         TR("Centre the selected pieces on one level line"), arranges(align, Alignment::Middle, 2)},
        {ActionId::DistributeAcross, "distributeAcross", TR("Same gaps &across"), "",
         TR("Move the selected pieces between the leftmost and the rightmost until their gaps are "
            "the "
            "same"),
         arranges(distribute, Direction::Across, 3)},
        {ActionId::DistributeUpwards, "distributeUpwards", TR("Same gaps u&pwards"), "",
         TR("Move the selected pieces between the lowest and the highest until their gaps are the "
            "same"),
         arranges(distribute, Direction::Upwards, 3)},
        {ActionId::LayOutAgain, "layOutAgain", TR("Lay &out again"), "Ctrl+L",
         TR("Put the selected pieces, or all where none is selected, in rows side by side"),
         onChosen(layOutAgain)},
        {ActionId::GrainUpwards, "grainUpwards", TR("Turn &grain upwards"), "Shift+G",
         TR("Turn the selected pieces, or all where none is selected, so that their grain runs "
            "upwards"),
         onChosen(turnGrainUpwards)},
        {ActionId::VerticalGrain, "verticalGrain", TR("Grain as it &hangs"), "",
         TR("Let the grain of the selected pieces, or of all, run up the garment"),
         asks(&GarmentActions::findVerticalGrain, isAnyFlat), "", TR("Hanging")},
        {ActionId::ReferenceGrain, "referenceGrain", TR("Grain of the reference &panels"), "",
         TR("Let the grain of the selected pieces, or of all, run up the designer's panels; as it "
            "hangs where a piece has none"),
         asks(&GarmentActions::findReferenceGrain, isAnyFlat)},
        {ActionId::BestGrain, "bestGrain", TR("&Best grain"), "",
         TR("Let the grain of the selected pieces, or of all, run up the garment, or at 90 or 45 "
            "degrees to that where the fabric is strained much less"),
         asks(&GarmentActions::findBestGrain, isAnyFlat), "", TR("Best")},
        {ActionId::ResetGrain, "resetGrain", TR("R&eset the grain"), "",
         TR("Leave it open how the grain of the selected pieces, or of all, runs"),
         asks(&GarmentActions::resetGrain, isAnyGrainSet), "", TR("Reset")},
        {ActionId::Rulers, "rulers", TR("&Rulers"), "Ctrl+R",
         TR("Show rulers along the edges of the pattern view"), switches(&ViewState::rulers)},
        {ActionId::Grid, "grid", TR("Gri&d"), "Ctrl+G",
         TR("Show a grid on the sheet of the pattern"), switches(&ViewState::grid)},
        {ActionId::Snapping, "snapping", TR("Sna&pping"), "S",
         TR("Let pieces catch at the grid and at each other while they are moved; Alt turns it the "
            "other way round"),
         switches(&ViewState::snapping)},
        {ActionId::DartToSeam, "dartToSeam", TR("D&art to seam"), "",
         TR("Let the selected dart go on from its tip to the edge, so that it becomes a seam"),
         asksOfSeam(&CutEditor::dartToSeam, isDart)},
        {ActionId::SeamToDart, "seamToDart", TR("Seam t&o dart"), "",
         TR("Take back the cut by which the selected seam was made of a dart"),
         asksOfSeam(&CutEditor::seamToDart, isSeamOfDart)},
        {ActionId::MirrorEdits, "mirrorEdits", TR("Mirror &edits"), "Y",
         TR("Cut on both sides of the garment at once, and turn the grain on both, where mirrored "
            "pieces are drawn equal"),
         mirrorsEditsToo()},
        {ActionId::GoToPosition, "goToPosition", TR("&Place…"), "P",
         TR("Type where the selected pieces lie, how far they are turned and how the grain runs"),
         whenOpen()},
        {ActionId::GoToFabric, "goToFabric", TR("Fa&bric…"), "Shift+F",
         TR("Choose what the garment is cut from, and type how far it gives way"), whenOpen(),
         "fabric", TR("Fabric")},
        {ActionId::GoToPieces, "goToPieces", TR("Go to &pieces"), "Ctrl+1",
         TR("Show the list of pieces and move the keyboard there"), whenOpen()},
        {ActionId::GoToSeams, "goToSeams", TR("Go &to seams"), "Ctrl+2",
         TR("Show the list of seams and move the keyboard there"), whenOpen()},
        {ActionId::GoToProblems, "goToProblems", TR("Go to proble&ms"), "Ctrl+3",
         TR("Show what stands against cutting and move the keyboard there"), whenOpen()},
        {ActionId::GoToHistory, "goToHistory", TR("Go to &history"), "Ctrl+4",
         TR("Show the steps done so far and move the keyboard there"), whenOpen()},
        {ActionId::GoToLines, "goToLines", TR("Go to &lines"), "Ctrl+5",
         TR("Show how the lines of the pattern are drawn and move the keyboard there"), whenOpen()},
        {ActionId::GoToSymmetry, "goToSymmetry", TR("Go to s&ymmetry"), "Ctrl+6",
         TR("Show which pieces mirror each other and move the keyboard there"), whenOpen()},
        {ActionId::GoToProof, "goToProof", TR("&Go to proof"), "Ctrl+7",
         TR("Show what sewing the pattern back together has shown and move the keyboard there"),
         whenOpen()},
        {ActionId::ResetLayout, "resetLayout", TR("Reset &window layout"), "",
         TR("Put every list back below the views and every panel beside them, as at the first "
            "start")},
        {ActionId::EditPreferences, "editPreferences", TR("&Preferences…"), "Ctrl+,",
         TR("Choose units, colours, language and how the mouse moves the view")},
        {ActionId::CommandPalette, "commandPalette", TR("&Find a command…"), "Ctrl+K",
         TR("Type a few letters to run a command or to find a piece or a seam")},
        {ActionId::FirstSteps, "firstSteps", TR("&First steps"), "",
         TR("From a garment to a pattern on the table, in five minutes")},
        {ActionId::Documentation, "documentation", TR("&Documentation"), "",
         TR("All that is written about Toile")},
        {ActionId::Shortcuts, "shortcuts", TR("&Keyboard and mouse"), "F1",
         TR("What every key and every movement of the mouse does")},
        {ActionId::ReportProblem, "reportProblem", TR("&Report a problem…"), "",
         TR("What to say when something goes wrong, with what is known of this computer")},
        {ActionId::About, "about", TR("&About Toile"), "",
         TR("Version, licence, and what Toile does")},
    };
}

#undef TR

}  // namespace

const std::vector<ActionSpec>& actionTable() {
    static const std::vector<ActionSpec> table = makeActions();
    return table;
}

ActionId actionOf(Method method) {
    switch (method) {
        case Method::Isometric:
            return ActionId::MethodIsometric;
        case Method::Curvature:
            return ActionId::MethodCurvature;
        case Method::Wang2005:
            return ActionId::MethodWang2005;
        case Method::Stretch:
            return ActionId::MethodStretch;
        case Method::Natural:
            return ActionId::MethodNatural;
        case Method::Lscm:
            return ActionId::MethodLscm;
        case Method::Abf:
            return ActionId::MethodAbf;
        case Method::Convex:
            return ActionId::MethodConvex;
    }
    return ActionId::MethodIsometric;
}

}  // namespace toile::app
