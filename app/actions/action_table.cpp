// SPDX-License-Identifier: GPL-3.0-or-later
// This file is long because it is one table, preceded by the few helpers that its entries share.
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

/// True if one of these has changed.
template <auto... Keys>
bool touched(const DocumentChange& change) {
    return change.touches(Keys...);
}
constexpr When::Reads kOpens = touched<&Derived::garment>;
constexpr When::Reads kDraws = touched<&Derived::scene>;

const When isOpen([](Workspace& on) { return on.document().garment() != nullptr; }, kOpens);

bool canRedo(Workspace& on) {
    return on.document().history().canRedo();
}

const When showsFigures(
    [](Workspace& on) { return isOpen(on) && isMeasured(on.document().view().overlay); },
    touched<&Derived::garment, DocumentChange::View>);

const When hasReference(
    [](Workspace& on) {
        const auto& scene = on.document().scene();
        return on.document().state().reference.file ||
               (scene && !scene->patternLines.reference.empty());
    },
    touched<&Derived::scene, &DocumentState::reference>);

bool namesReference(Workspace& on) {
    return isOpen(on) && !on.document().state().reference.path.empty();
}

const When hasExactOutline(
    [](Workspace& on) {
        const auto& scene = on.document().scene();
        return scene && !scene->patternLines.exact.empty();
    },
    kDraws);

const When hasCuttingLine(
    [](Workspace& on) {
        const auto& scene = on.document().scene();
        return scene && !scene->patternLines.cutting.empty();
    },
    kDraws);

const When hasNotches(
    [](Workspace& on) {
        const auto& scene = on.document().scene();
        return scene && !scene->patternLines.notches.empty();
    },
    kDraws);

const When hasInternalLines(
    [](Workspace& on) {
        const auto& scene = on.document().scene();
        return scene &&
               !(scene->patternLines.internal.empty() && scene->garmentLines.internal.empty());
    },
    kDraws);

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

const When isSewnSeam(
    [](Workspace& on) {
        const Seam* seam = selectedSeam(on);
        return seam && seam->kind != SeamKind::Free;
    },
    touched<&Derived::garment, DocumentChange::Selection>);

const When isOnePiece([](Workspace& on) { return on.document().selection().size() == 1; },
                      touched<&Derived::garment, DocumentChange::Selection>);

const When isAnyPiece([](Workspace& on) { return !on.document().selection().empty(); },
                      touched<&Derived::garment, DocumentChange::Selection>);

bool isAnyPieceOut(Workspace& on, bool leftOut) {
    return std::ranges::any_of(on.document().selection(), [&on, leftOut](int piece) {
        return isLeftOut(on.document(), piece) == leftOut;
    });
}

bool isOneFlatPiece(Workspace& on) {
    return isOnePiece(on) && !selectedFlat(on.document()).empty();
}

/// The selected pieces that cuts can open.
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

/// F2 renames the selected piece, or else sets the ease of the selected seam.
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

/// For actions that other code connects.
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

/// Without a current proof, an overlay of the proof also brings the proof panel to the front.
ActionWork shows(Overlay overlay) {
    return {[overlay](GarmentActions& on, bool) {
                Workspace& workspace = on.workspace();
                workspace.document().setOverlay(overlay);
                if (isOfProof(overlay) && !workspace.document().isProofCurrent()) {
                    workspace.proof().want();
                }
            },
            isOpen, [overlay](Workspace& on) { return on.document().view().overlay == overlay; },
            ActionGroup::Overlay};
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

/// Disabled for free-boundary methods, which solve no boundary problem.
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

/// Keeps the other settings of the file.
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

/// Applies `change` to the selected flat pieces; needs at least `least` of them.
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

/// Applies `change` to the selected pieces, flat or not.
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

/// Applies `change` to the selected flat pieces, or to all without a selection.
ActionWork onChosen(void (*change)(Document&, const PieceIndices&)) {
    return {[change](GarmentActions& on, bool) {
                change(on.workspace().document(), selectedOrAllFlat(on.workspace().document()));
            },
            isAnyFlat};
}

std::vector<ActionSpec> makeActions() {
    using Group = ActionGroup;
    return {
        {ActionId::Open, "open", TR("&Open…"), "Ctrl+O",
         TR("Open a project, or one or more files of a garment"), asks(&GarmentActions::askAndOpen),
         "open", TR("Open")},
        {ActionId::Save,
         "save",
         TR("&Save"),
         "Ctrl+S",
         TR("Save all your work on this garment in its project file"),
         {[](GarmentActions& on, bool) { on.project().save(); }, isOpen},
         "save",
         TR("Save")},
        {ActionId::SaveAs,
         "saveAs",
         TR("Save &as…"),
         "Ctrl+Shift+S",
         TR("Save all your work on this garment in another project file"),
         {[](GarmentActions& on, bool) { on.project().saveAs(); }, isOpen}},
        {ActionId::ExportPattern, "exportPattern", TR("&Export pattern…"), "Ctrl+E",
         TR("Write the pattern to a file for printers, cutters, pattern programs or 3D programs"),
         asks(&GarmentActions::askAndExport, &Workspace::canExport), "export", TR("Export")},
        {ActionId::OpenReference, "openReference", TR("Open reference pa&ttern…"), "",
         TR("Show a DXF, SVG or GarmentCode pattern over the flat pieces to compare them"),
         asks(&GarmentActions::askAndOpenReference, isOpen)},
        {ActionId::CloseReference, "closeReference", TR("&Close reference pattern"), "",
         TR("Stop comparing with the reference pattern"),
         asks(&Workspace::closeReference, namesReference)},
        {ActionId::PrintPattern, "printPattern", TR("&Print pattern…"), "Ctrl+P",
         TR("Print the pattern at true scale, on pages to join or on large sheets"),
         asks(&GarmentActions::askAndPrint, &Workspace::canExport)},
        {ActionId::ReadyToCut, "readyToCut", TR("Read&y to cut?"), "F8",
         TR("Check whether the pattern can be cut, and list every problem with its place"),
         whenOpen(), "check", TR("Check")},
        {ActionId::Quit, "quit", TR("&Quit"), "Ctrl+Q", TR("Close the window")},
        {ActionId::Undo, "undo", TR("&Undo"), "Ctrl+Z", TR("Undo the last step"),
         asks(&Workspace::undo, &Workspace::canUndo), "undo", TR("Undo")},
        {ActionId::Redo,
         "redo",
         TR("&Redo"),
         "Ctrl+Shift+Z",
         TR("Redo the step that you undid last"),
         {[](GarmentActions& on, bool) { on.workspace().document().history().redo(); }, canRedo},
         "redo",
         TR("Redo")},
        {ActionId::SelectAll, "selectAll", TR("Select &all"), "Ctrl+A", TR("Select every piece"),
         asks(&GarmentActions::selectAll, isOpen)},
        {ActionId::SelectNone, "selectNone", TR("Select &none"), "Ctrl+Shift+A",
         TR("Clear the selection of pieces and seams"), asks(&GarmentActions::selectNone, isOpen)},
        {ActionId::SelectSameMaterial, "selectSameMaterial", TR("Select &same material"), "",
         TR("Select every piece with the material of the selected pieces"),
         onPieces(selectSameMaterial, isAnyPiece)},
        {ActionId::SelectSameLayer, "selectSameLayer", TR("Select same la&yer"), "",
         TR("Select every piece in the layers of the selected pieces"),
         onPieces(selectSameLayer,
                  [](Workspace& on) { return isAnyPiece(on) && hasLayers(on.document()); })},
        {ActionId::Frame, "frame", TR("&Frame"), "F",
         TR("Fit the selected pieces or seam in the view, or everything without a selection"),
         whenOpen(), "frame", TR("Frame")},
        {ActionId::ValuesPerTriangle, "valuesPerTriangle", TR("&Values per triangle"), "Shift+V",
         TR("Colour every triangle by its own value, without smoothing"),
         switches(&ViewState::valuesPerTriangle, showsFigures), "values-per-triangle",
         TR("Per triangle")},
        {ActionId::WorstSpots, "worstSpots", TR("Mark w&orst spots"), "Shift+W",
         TR("Number the places with the worst values"),
         switches(&ViewState::worstSpots, showsFigures), "worst-spots", TR("Worst spots")},
        {ActionId::Wireframe, "wireframe", TR("Show &wireframe"), "W",
         TR("Show the triangles of the mesh"), switches(&ViewState::wireframe), "wireframe",
         TR("Wireframe")},
        {ActionId::ReferencePanels, "referencePanels", TR("Re&ference panels"), "D",
         TR("Show the file's reference panels or the open reference pattern over the flat pieces"),
         switches(&ViewState::referencePanels, hasReference)},
        {ActionId::ExactOutline, "exactOutline", TR("Exact o&utline"), "Shift+X",
         TR("Show the outline as solved, dashed, if the pattern draws a fair line instead"),
         switches(&ViewState::exactOutline, hasExactOutline)},
        {ActionId::ShowSeams, "showSeams", TR("&Seam lines"), "Shift+S",
         TR("Show the seam lines, with both sides of a seam in one colour"),
         switches(&ViewState::seams)},
        {ActionId::CuttingLine, "cuttingLine", TR("&Cutting line"), "",
         TR("Show the cutting line of pieces with a seam allowance"),
         switches(&ViewState::cuttingLine, hasCuttingLine)},
        {ActionId::Notches, "notches", TR("&Notches"), "", TR("Show the notches of the pattern"),
         switches(&ViewState::notches, hasNotches)},
        {ActionId::InternalLines, "internalLines", TR("&Internal lines"), "",
         TR("Show internal lines, drill points and, in the pattern, dart marks"),
         switches(&ViewState::internalLines, hasInternalLines)},
        {ActionId::GrainArrows, "grainArrows", TR("&Grain"), "",
         TR("Show the grain line of each piece in the pattern view"), switches(&ViewState::grain)},
        {ActionId::Labels, "labels", TR("&Labels"), "",
         TR("Show the names of the pieces in the pattern view"), switches(&ViewState::labels)},
        {ActionId::Xray, "xray", TR("&X-ray"), "X", TR("See through the cloth of the garment"),
         switches(&ViewState::xray)},
        {ActionId::Shaded, "shaded", TR("S&hading"), "Shift+L",
         TR("Light the garment; without shading it has flat colours like the pattern"),
         switches(&ViewState::shaded)},
        {ActionId::PieceColours, "pieceColours", TR("Colour p&ieces"), "Shift+C",
         TR("Give every piece its own colour; otherwise all pieces are plain cotton"),
         switches(&ViewState::pieceColours)},
        {ActionId::LookFront, "lookFront", TR("&Front view"), "",
         TR("Look at the garment's front (number pad 1)"), whenOpen()},
        {ActionId::LookBack, "lookBack", TR("&Back view"), "",
         TR("Look at the garment's back (Ctrl+number pad 1)"), whenOpen()},
        {ActionId::LookRight, "lookRight", TR("&Right view"), "",
         TR("Look at the garment from the right of the view (number pad 3)"), whenOpen()},
        {ActionId::LookLeft, "lookLeft", TR("&Left view"), "",
         TR("Look at the garment from the left of the view (Ctrl+number pad 3)"), whenOpen()},
        {ActionId::LookTop, "lookTop", TR("&Top view"), "",
         TR("Look down at the garment (number pad 7)"), whenOpen()},
        {ActionId::LookBottom, "lookBottom", TR("B&ottom view"), "",
         TR("Look up at the garment (Ctrl+number pad 7)"), whenOpen()},
        {ActionId::Orthographic, "orthographic", TR("&Parallel projection"), "",
         TR("Draw the garment without perspective (number pad 5)"), whenOpen(Group::Toggle)},
        {ActionId::PlayMorph, "playMorph", TR("Play fla&ttening"), "Shift+M",
         TR("Watch the garment turn into the pattern, or the pattern into the garment"),
         whenOpen()},
        {ActionId::PlaySewn,
         "playSewn",
         TR("Play sewi&ng"),
         "",
         TR("Watch the cloth move from the design to the sewn pattern's resting shape"),
         {.enabledWhen = isProved}},
        {ActionId::WalkSeam,
         "walkSeam",
         TR("Walk the s&eam"),
         "Shift+R",
         TR("Roll one piece along the selected seam to see whether lengths and notches match"),
         {.enabledWhen = isFlatSeam}},
        {ActionId::MethodIsometric, "methodIsometric", methodText(Method::Isometric), "",
         TR("Keep exact seam lengths; the cloth between stretches as little as possible, without "
            "flipped triangles"),
         flattens(Method::Isometric)},
        {ActionId::MethodCurvature, "methodCurvature", methodText(Method::Curvature), "",
         TR("Keep exact seam lengths; the outline turns where the garment is curved"),
         flattens(Method::Curvature)},
        {ActionId::MethodWang2005, "methodWang2005", methodText(Method::Wang2005), "",
         TR("Keep exact seam lengths; angle changes spread evenly along the outline (Wang 2005)"),
         flattens(Method::Wang2005)},
        {ActionId::MethodStretch, "methodStretch", methodText(Method::Stretch), "",
         TR("Keep exact seam lengths on a round outline; the inside stretches least (Yoshizawa "
            "2004)"),
         flattens(Method::Stretch)},
        {ActionId::MethodConvex, "methodConvex", methodText(Method::Convex), "",
         TR("Keep exact seam lengths on a round outline; not usable as a pattern (Floater 2003)"),
         flattens(Method::Convex)},
        {ActionId::MethodNatural, "methodNatural", methodText(Method::Natural), "",
         TR("Keep angles as far as possible; seam lines change length (Desbrun 2002)"),
         flattens(Method::Natural)},
        {ActionId::MethodLscm, "methodLscm", methodText(Method::Lscm), "",
         TR("Keep angles by least squares; seam lines change length (Lévy 2002)"),
         flattens(Method::Lscm)},
        {ActionId::MethodAbf, "methodAbf", methodText(Method::Abf), "",
         TR("Keep the angles of every triangle; seam lines change length (Sheffer 2005)"),
         flattens(Method::Abf)},
        {ActionId::QualityDraft, "qualityDraft", TR("&Draft"), "",
         TR("Fast: within a few per cent of the least distortion"), flattens(Quality::Draft)},
        {ActionId::QualityStandard, "qualityStandard", TR("&Standard"), "",
         TR("Within about 0.1 % of the least distortion"), flattens(Quality::Standard)},
        {ActionId::QualityFine, "qualityFine", TR("&Fine"), "",
         TR("Slow: as close to the least distortion as possible"), flattens(Quality::Fine)},
        {ActionId::SolverNewton, "solverNewton", TR("&Newton solver"), "",
         TR("Solve the outline by Newton steps, the fast way"), flattens(BoundarySolver::Newton)},
        {ActionId::SolverSlcp, "solverSlcp", TR("Wang 2005 so&lver"), "",
         TR("Solve the same outline by linearly constrained steps, as in the paper"),
         flattens(BoundarySolver::Slcp)},
        {ActionId::CompareMethods, "compareMethods", TR("C&ompare methods…"), "Ctrl+M",
         TR("Compare one piece flattened by up to four methods, side by side"), whenOpen()},
        {ActionId::LayOnCloth, "layOnCloth", TR("Mar&ker (lay on fabric)…"), "Ctrl+Shift+M",
         TR("Place the pieces on fabric with little waste, and see the length needed"), whenOpen()},
        {ActionId::ProveBySewing,
         "proveBySewing",
         TR("Prove by se&wing"),
         "F9",
         TR("Sew the exported pattern together over the design and measure the difference"),
         {[](GarmentActions& on, bool) {
              on.workspace().proof().want();
              on.workspace().proof().begin();
          },
          [](Workspace& on) { return on.proof().canProve(); }}},
        {ActionId::SaveProof, "saveProof", TR("Save proo&f report…"), "",
         TR("Write the results of the proof to a JSON file"),
         asks(&GarmentActions::askAndSaveProof, isProved)},
        {ActionId::ToolSelect, "toolSelect", TR("&Select"), "V",
         TR("Select pieces, seams and vertices; move pieces in the pattern"), whenOpen(Group::Tool),
         "tool-select", TR("Select")},
        {ActionId::ToolCut, "toolCut", TR("&Cut"), "C",
         TR("Cut a piece along the shortest path through the points you click"),
         whenOpen(Group::Tool), "tool-cut", TR("Cut")},
        {ActionId::ToolLoop, "toolLoop", TR("Closed &loop"), "L",
         TR("Cut out a part along a closed line through the points you click"),
         whenOpen(Group::Tool), "tool-loop", TR("Loop")},
        {ActionId::ToolDart, "toolDart", TR("&Dart"), "T",
         TR("Cut from an edge to a tip inside the cloth"), whenOpen(Group::Tool), "tool-dart",
         TR("Dart")},
        {ActionId::ToolJoin, "toolJoin", TR("&Join"), "J",
         TR("Join the cloth on both sides of a seam"), whenOpen(Group::Tool), "tool-join",
         TR("Join")},
        {ActionId::ToolMeasure, "toolMeasure", TR("&Measure"), "M",
         TR("Measure straight or along edges, on the garment and in the pattern"),
         whenOpen(Group::Tool), "tool-measure", TR("Measure")},
        {ActionId::FlattenAgain, "flattenAgain", TR("Flatten &again"), "Ctrl+F5",
         TR("Flatten every piece again"), asks(&Workspace::flattenAgain, isOpen), "flatten",
         TR("Flatten")},
        {ActionId::AutoFlatten,
         "autoFlatten",
         TR("Flatten after every ed&it"),
         "",
         TR("Flatten changed pieces after every edit; turn it off for large meshes"),
         {[](GarmentActions& on, bool isOn) { on.workspace().setAutoFlatten(isOn); },
          {},
          &Workspace::autoFlatten,
          Group::Toggle}},
        {ActionId::Cancel, "cancel", TR("&Cancel"), "Esc", TR("Stop the running task"),
         asks(&Workspace::cancel, &Workspace::isBusy), "cancel"},
        {ActionId::Reload, "reload", TR("&Reload"), "F5", TR("Read the garment's files again"),
         asks(&Workspace::reload, isOpen)},
        {ActionId::UnitAuto, "unitAuto", TR("&Automatic"), "",
         TR("Choose the unit that makes the garment human-sized"),
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
         TR("Detect the axis along which the garment stands upright"),
         reads(Group::UpAxis, &LoadOptions::up, &Workspace::setUpAxis, {})},
        {ActionId::UpY, "upY", TR("&Y points up"), "",
         TR("Stand the garment along the file's y axis"),
         reads(Group::UpAxis, &LoadOptions::up, &Workspace::setUpAxis, UpAxis::Y)},
        {ActionId::UpZ, "upZ", TR("&Z points up"), "",
         TR("Stand the garment along the file's z axis"),
         reads(Group::UpAxis, &LoadOptions::up, &Workspace::setUpAxis, UpAxis::Z)},
        {ActionId::ReadAuto, "readAuto", TR("&Automatic"), "",
         TR("Detect the kind of file: sheet, thick shell, layers or scan"), readsAs({})},
        {ActionId::ReadSheet, "readSheet", TR("&Plain sheet"), "",
         TR("Use every face of the file unchanged"), readsAs(FileKind::Sheet)},
        {ActionId::ReadOuter, "readOuter", TR("Thick shell, &outer surface"), "",
         TR("Use the outer surface of thick cloth, without its rims"),
         readsAs(FileKind::Shell, ShellSurface::Outer)},
        {ActionId::ReadInner, "readInner", TR("Thick shell, &inner surface"), "",
         TR("Use the inner surface of thick cloth, without its rims"),
         readsAs(FileKind::Shell, ShellSurface::Inner)},
        {ActionId::ReadMiddle, "readMiddle", TR("Thick shell, &middle"), "",
         TR("Use the middle between the surfaces of thick cloth"),
         readsAs(FileKind::Shell, ShellSurface::Middle)},
        {ActionId::ReadLayers, "readLayers", TR("&Layers of cloth, all"), "",
         TR("Use every nested sheet, such as a lining; each layer becomes a material"),
         readsAs(FileKind::Layers)},
        {ActionId::ReadOuterLayer, "readOuterLayer", TR("Layers of cloth, ou&termost only"), "",
         TR("Use only the outermost of nested sheets"),
         readsAs(FileKind::Layers, ShellSurface::Outer, 1)},
        {ActionId::ReadInnerLayer, "readInnerLayer", TR("Layers of cloth, secon&d only"), "",
         TR("Use only the second nested sheet from outside, usually the lining"),
         readsAs(FileKind::Layers, ShellSurface::Outer, 2)},
        {ActionId::ReadScan,
         "readScan",
         TR("&Scan…"),
         "",
         TR("Turn a scan into a sheet: remove debris, close small holes, smooth noise"),
         {.enabledWhen = isOpen,
          .checkedWhen = [](Workspace& on) { return on.loading().preparing.as == FileKind::Scan; },
          .group = Group::ReadAs}},
        {ActionId::SplitAuto, "splitAuto", TR("&Automatic"), "",
         TR("Choose how to split the garment from the contents of the file"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Auto)},
        {ActionId::SplitComponents, "splitComponents", TR("Connected &parts"), "",
         TR("Make each connected part one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Components)},
        {ActionId::SplitObjects, "splitObjects", TR("&Objects"), "",
         TR("Make each object of the file one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Objects)},
        {ActionId::SplitGroups, "splitGroups", TR("&Groups"), "",
         TR("Make each group of the file one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Groups)},
        {ActionId::SplitMaterials, "splitMaterials", TR("&Materials"), "",
         TR("Make each material of the file one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Materials)},
        {ActionId::SplitUv, "splitUv", TR("&UV islands"), "",
         TR("Make each UV island of the file one piece"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Uv)},
        {ActionId::SplitSeams, "splitSeams", TR("&Cuts only"), "",
         TR("Split the garment only along the cuts of the seams file"),
         reads(Group::Split, &LoadOptions::split, &Workspace::setSplit, SplitMode::Seams, hasCuts)},
        {ActionId::AutoCut, "autoCut", TR("&Cut open automatically"), "",
         TR("Cut open every piece that cannot lie flat"),
         reads(&LoadOptions::autoCut, &Workspace::setAutoCut)},
        {ActionId::CompleteHalf, "completeHalf", TR("Complete &half a garment"), "",
         TR("Add the mirror image if the file has only half the garment"),
         prepares(&Preparation::isHalf)},
        {ActionId::TurnOver, "turnOver", TR("Turn i&nside out"), "",
         TR("Flip all faces so that the other side of the cloth is the right side"),
         prepares(&Preparation::isTurned)},
        {ActionId::TailorCuts, "tailorCuts", TR("Cut li&ke a tailor"), "",
         TR("Cut one-piece garments at armholes, sides and shoulders if Toile detects them"),
         cutsAsTailors()},
        {ActionId::ProposeCuts,
         "proposeCuts",
         TR("Propose cu&ts…"),
         "",
         TR("Propose a tailor's cuts for the selected piece, with their length and effect on "
            "strain"),
         {[](GarmentActions& on, bool) { on.workspace().proposals().open(); }, isOpen}},
        {ActionId::Weld, "weld", TR("&Weld vertices"), "",
         TR("Merge vertices of an object that lie at the same point"),
         reads(&LoadOptions::weld, &Workspace::setWeld)},
        {ActionId::CloseSlits, "closeSlits", TR("Close s&lits"), "",
         TR("Close slits inside pieces, common in texture maps"),
         reads(&LoadOptions::closeSlits, &Workspace::setCloseSlits)},
        {ActionId::SeamsFromFile, "seamsFromFile", TR("Load &seams file…"), "",
         TR("Load cuts and ease from a seams file (JSON)"),
         asks(&GarmentActions::askAndReadSeams, isOpen)},
        {ActionId::SeamsToFile, "seamsToFile", TR("Save sea&ms file…"), "",
         TR("Write your cuts and ease values to a seams file (JSON)"),
         asks(&GarmentActions::askAndWriteSeams, saysOfSeams)},
        {ActionId::RenamePiece,
         "renamePiece",
         TR("&Rename…"),
         "F2",
         TR("Change the name of the selected piece, on screen and in files"),
         {.enabledWhen = isOnePiece}},
        {ActionId::SetQuantity,
         "setQuantity",
         TR("&Quantity…"),
         "",
         TR("Set how many of each selected piece to cut"),
         {.enabledWhen = isAnyPiece}},
        {ActionId::NewMaterial, "newMaterial", TR("&New material…"), "",
         TR("Cut the selected pieces from a new material, such as lining or interfacing"),
         asks(&GarmentActions::askForMaterial, isAnyPiece)},
        {ActionId::HidePieces, "hidePieces", TR("&Hide"), "Ctrl+H",
         TR("Hide the selected pieces in both views; files and checks still include them"),
         onPieces(hidePieces, isAnyPiece)},
        {ActionId::ShowOnlyThese, "showOnlyThese", TR("Sho&w only selected"), "Ctrl+Shift+H",
         TR("Hide all other pieces; files and checks still include them"),
         onPieces(showOnlyPieces, isAnyPiece)},
        {ActionId::ShowAllPieces,
         "showAllPieces",
         TR("Show &all"),
         "Ctrl+Alt+H",
         TR("Show the hidden pieces again"),
         {[](GarmentActions& on, bool) { showAllPieces(on.workspace().document()); },
          [](Workspace& on) { return isAnyHidden(on.document()); }}},
        {ActionId::ExportOnlyThese, "exportOnlyThese", TR("&Export selected…"), "",
         TR("Write only the selected pieces to a file"),
         asks(&GarmentActions::askAndExportThese, canExportThese)},
        {ActionId::LeaveOut, "leaveOut", TR("&Leave out"), "",
         TR("Remove the selected pieces from pattern, files and checks, such as buttons and zips"),
         onPieces([](Document& document,
                     const PieceIndices& pieces) { setLeftOut(document, pieces, true); },
                  [](Workspace& on) { return isAnyPieceOut(on, false); })},
        {ActionId::TakeIn, "takeIn", TR("I&nclude again"), "",
         TR("Return the selected left-out pieces to the pattern"),
         onPieces([](Document& document,
                     const PieceIndices& pieces) { setLeftOut(document, pieces, false); },
                  [](Workspace& on) { return isAnyPieceOut(on, true); })},
        {ActionId::LeaveOutSmall, "leaveOutSmall", TR("Leave out &small pieces…"), "",
         TR("Leave out all pieces smaller than an area that you set"), whenOpen()},
        {ActionId::CutOpen,
         "cutOpen",
         TR("Cut o&pen"),
         "",
         TR("Cut open those selected pieces that cannot lie flat"),
         {[](GarmentActions& on, bool) {
              on.workspace().cuts().openPieces(selectedOpenable(on.workspace()));
          },
          [](Workspace& on) { return !selectedOpenable(on).empty(); }}},
        {ActionId::DartHere,
         "dartHere",
         TR("&Dart here…"),
         "",
         TR("Propose a dart to the pointer or ring: Enter cuts it, Esc discards it"),
         {.enabledWhen = isOneFlatPiece}},
        {ActionId::StateEase,
         "stateEase",
         TR("Set &ease…"),
         "F2",
         TR("Set how much longer the left edge of the selected seam is"),
         {.enabledWhen = isSeamMeant}},
        {ActionId::JoinSeam, "joinSeam", TR("&Join at seam"), "",
         TR("Join the cloth at the selected seam; removes your own cut there"),
         asksOfSeam(&CutEditor::joinSeam, isSewnSeam)},
        {ActionId::ResetEase, "resetEase", TR("Rese&t ease"), "Del",
         TR("Use the ease that follows from the 3D lengths of the selected seam"),
         asks(&GarmentActions::resetEase, isEasedSeam)},
        {ActionId::ToolGrain, "toolGrain", TR("&Grain"), "G",
         TR("Turn the grain of a piece in the pattern view"), whenOpen(Group::Tool), "tool-grain",
         TR("Grain")},
        {ActionId::ToolNotch, "toolNotch", TR("&Notch"), "N",
         TR("Add, move and delete notches on both sides of a seam at once"), whenOpen(Group::Tool),
         "tool-notch", TR("Notch")},
        {ActionId::ToolInternalLine, "toolInternalLine", TR("&Internal line"), "I",
         TR("Draw and edit internal lines and drill points"), whenOpen(Group::Tool), "tool-line",
         TR("Internal line")},
        {ActionId::TurnLeft, "turnLeft", TR("Turn &left"), "[",
         TR("Turn the selected pieces 90° anti-clockwise"), turns(kRightAngle)},
        {ActionId::TurnRight, "turnRight", TR("Turn &right"), "]",
         TR("Turn the selected pieces 90° clockwise"), turns(-kRightAngle)},
        {ActionId::MirrorLeftRight, "mirrorLeftRight", TR("&Mirror left to right"), "H",
         TR("Flip the selected pieces left to right, so that the wrong side faces you"),
         mirrors(Mirroring::LeftRight)},
        {ActionId::MirrorUpsideDown, "mirrorUpsideDown", TR("Mirror &upside down"), "Shift+H",
         TR("Flip the selected pieces top to bottom, so that the wrong side faces you"),
         mirrors(Mirroring::UpsideDown)},
        {ActionId::AlignLeft, "alignLeft", TR("&Left edges"), "",
         TR("Align the left edges of the selected pieces"), arranges(align, Alignment::Left, 2)},
        {ActionId::AlignRight, "alignRight", TR("&Right edges"), "",
         TR("Align the right edges of the selected pieces"), arranges(align, Alignment::Right, 2)},
        {ActionId::AlignTop, "alignTop", TR("&Upper edges"), "",
         TR("Align the upper edges of the selected pieces"), arranges(align, Alignment::Top, 2)},
        {ActionId::AlignBottom, "alignBottom", TR("Lo&wer edges"), "",
         TR("Align the lower edges of the selected pieces"), arranges(align, Alignment::Bottom, 2)},
        {ActionId::AlignCentre, "alignCentre", TR("Centre on &vertical line"), "",
         TR("Centre the selected pieces on one vertical line"),
         arranges(align, Alignment::Centre, 2)},
        {ActionId::AlignMiddle, "alignMiddle", TR("Centre on &horizontal line"), "",
         TR("Centre the selected pieces on one horizontal line"),
         arranges(align, Alignment::Middle, 2)},
        {ActionId::DistributeAcross, "distributeAcross", TR("&Distribute horizontally"), "",
         TR("Make the horizontal gaps between the selected pieces equal"),
         arranges(distribute, Direction::Across, 3)},
        {ActionId::DistributeUpwards, "distributeUpwards", TR("Distribute verticall&y"), "",
         TR("Make the vertical gaps between the selected pieces equal"),
         arranges(distribute, Direction::Upwards, 3)},
        {ActionId::LayOutAgain, "layOutAgain", TR("Lay &out again"), "Ctrl+L",
         TR("Arrange the selected pieces in rows; without a selection, all pieces"),
         onChosen(layOutAgain)},
        {ActionId::GrainUpwards, "grainUpwards", TR("Turn &grain upwards"), "Shift+G",
         TR("Turn the selected pieces so that their grain runs upwards; without a selection, all"),
         onChosen(turnGrainUpwards)},
        {ActionId::VerticalGrain, "verticalGrain", TR("Ver&tical grain"), "",
         TR("Run the grain of the selected pieces, or of all, up the garment"),
         asks(&GarmentActions::findVerticalGrain, isAnyFlat), "", TR("Vertical")},
        {ActionId::ReferenceGrain, "referenceGrain", TR("Grain &from reference panels"), "",
         TR("Run the grain up the reference panels; pieces without a panel get vertical grain"),
         asks(&GarmentActions::findReferenceGrain, isAnyFlat)},
        {ActionId::BestGrain, "bestGrain", TR("&Best grain"), "",
         TR("Run the grain upwards, or turn it 45° or 90° if that strains much less"),
         asks(&GarmentActions::findBestGrain, isAnyFlat), "", TR("Best")},
        {ActionId::ResetGrain, "resetGrain", TR("R&eset grain"), "",
         TR("Clear the grain of the selected pieces, or of all"),
         asks(&GarmentActions::resetGrain, isAnyGrainSet), "", TR("Reset")},
        {ActionId::Rulers, "rulers", TR("&Rulers"), "Ctrl+R",
         TR("Show rulers along the edges of the pattern view"), switches(&ViewState::rulers)},
        {ActionId::Grid, "grid", TR("Gri&d"), "Ctrl+G", TR("Show a grid in the pattern view"),
         switches(&ViewState::grid)},
        {ActionId::Snapping, "snapping", TR("S&napping"), "S",
         TR("Snap moving pieces to the grid and to each other; Alt toggles this"),
         switches(&ViewState::snapping)},
        {ActionId::DartToSeam, "dartToSeam", TR("Turn d&art into seam"), "",
         TR("Cut the selected dart from its tip to the edge to make a seam"),
         asksOfSeam(&CutEditor::dartToSeam, isDart)},
        {ActionId::SeamToDart, "seamToDart", TR("Turn seam int&o dart"), "",
         TR("Remove the cut that turned a dart into the selected seam"),
         asksOfSeam(&CutEditor::seamToDart, isSeamOfDart)},
        {ActionId::MirrorEdits, "mirrorEdits", TR("Mirror &edits"), "Y",
         TR("Apply cuts and grain changes to both mirrored pieces if they are drawn equal"),
         mirrorsEditsToo()},
        {ActionId::GoToPosition, "goToPosition", TR("&Position…"), "P",
         TR("Set the position, angle and grain of the selected pieces"), whenOpen()},
        {ActionId::GoToFabric, "goToFabric", TR("Fa&bric…"), "Shift+F",
         TR("Choose the garment's fabric and set how far it stretches"), whenOpen(), "fabric",
         TR("Fabric")},
        {ActionId::GoToPieces, "goToPieces", TR("Go to &pieces"), "Ctrl+1",
         TR("Show the list of pieces and give it the keyboard focus"), whenOpen()},
        {ActionId::GoToSeams, "goToSeams", TR("Go &to seams"), "Ctrl+2",
         TR("Show the list of seams and give it the keyboard focus"), whenOpen()},
        {ActionId::GoToProblems, "goToProblems", TR("Go to proble&ms"), "Ctrl+3",
         TR("Show problems to fix before cutting and give the list the keyboard focus"),
         whenOpen()},
        {ActionId::GoToHistory, "goToHistory", TR("Go to &history"), "Ctrl+4",
         TR("Show the list of your steps and give it the keyboard focus"), whenOpen()},
        {ActionId::GoToLines, "goToLines", TR("Go to &lines"), "Ctrl+5",
         TR("Show the settings of pattern lines and give them the keyboard focus"), whenOpen()},
        {ActionId::GoToSymmetry, "goToSymmetry", TR("Go to s&ymmetry"), "Ctrl+6",
         TR("Show which pieces mirror each other and give the panel the keyboard focus"),
         whenOpen()},
        {ActionId::GoToProof, "goToProof", TR("&Go to proof"), "Ctrl+7",
         TR("Show the results of the proof and give the panel the keyboard focus"), whenOpen()},
        {ActionId::ResetLayout, "resetLayout", TR("Reset &window layout"), "",
         TR("Restore the original arrangement of lists and panels")},
        {ActionId::EditPreferences, "editPreferences", TR("&Preferences…"), "Ctrl+,",
         TR("Choose units, colours, language and mouse controls")},
        {ActionId::CommandPalette, "commandPalette", TR("&Find command…"), "Ctrl+K",
         TR("Type a few letters to find a command, a piece or a seam")},
        {ActionId::FirstSteps, "firstSteps", TR("&First steps"), "",
         TR("Make a pattern from a garment in five minutes")},
        {ActionId::Documentation, "documentation", TR("&Documentation"), "",
         TR("Read the manual of Toile")},
        {ActionId::Shortcuts, "shortcuts", TR("&Keyboard and mouse"), "F1",
         TR("List all keys and mouse gestures")},
        {ActionId::ReportProblem, "reportProblem", TR("&Report a problem…"), "",
         TR("See what to include in a report, with details of this computer")},
        {ActionId::About, "about", TR("&About Toile"), "",
         TR("Show version, licence and purpose of Toile")},
    };
}

}  // namespace

const std::vector<ActionSpec>& actionTable() {
    static const std::vector<ActionSpec> table = [] {
        std::vector<ActionSpec> specs = makeActions();
        auto place = std::ranges::find(specs, ActionId::ValuesPerTriangle, &ActionSpec::id);
        for (const OverlayTraits& known : kOverlays) {
            const OverlayAction& action = known.action;
            place = std::next(
                specs.insert(place, {overlayAction(known.overlay), action.name, action.text,
                                     action.shortcut, action.tip, shows(known.overlay),
                                     "overlay-" + std::string(known.word), action.shortText}));
        }
        return specs;
    }();
    return table;
}

ActionId actionOf(Method method) {
    using enum ActionId;
    using Row = std::pair<Method, ActionId>;
    static constexpr Row kRows[] = {{Method::Isometric, MethodIsometric},
                                    {Method::Curvature, MethodCurvature},
                                    {Method::Wang2005, MethodWang2005},
                                    {Method::Stretch, MethodStretch},
                                    {Method::Natural, MethodNatural},
                                    {Method::Lscm, MethodLscm},
                                    {Method::Abf, MethodAbf},
                                    {Method::Convex, MethodConvex}};
    return std::ranges::find(kRows, method, &Row::first)->second;
}

}  // namespace toile::app
