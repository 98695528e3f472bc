// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/menu_table.h"

#include <QCoreApplication>
#include <algorithm>
#include <string_view>

#include "app/base/text.h"

namespace toile::app {

namespace {

constexpr MenuSeparator kLine{};
constexpr MenuPlace kBelow = MenuPlace::Submenu, kContext = MenuPlace::Context;

/// Flattening methods from their own table, grouped by whether they keep seam lengths.
std::vector<MenuItem> flattenItems() {
    std::vector<MenuItem> items;
    for (const bool keepsLengths : {true, false}) {
        items.emplace_back(MenuHeading{keepsLengths ? TR("Seam lines keep their length")
                                                    : TR("Seam lines may change length")});
        for (const MethodTraits& method : allMethods()) {
            if (method.keepsLengths == keepsLengths) {
                items.emplace_back(actionOf(method.method));
            }
        }
    }
    const MenuItem others[] = {kLine,
                               ActionId::CompareMethods,
                               kLine,
                               Submenu{"qualityMenu"},
                               kLine,
                               ActionId::SolverNewton,
                               ActionId::SolverSlcp,
                               kLine,
                               ActionId::AutoFlatten,
                               ActionId::FlattenAgain,
                               ActionId::Cancel};
    items.insert(items.end(), std::begin(others), std::end(others));
    return items;
}

/// Overlays from their own table, with lines between the kinds.
std::vector<MenuItem> overlayItems() {
    std::vector<MenuItem> items;
    for (const OverlayKind kind :
         {OverlayKind::Plain, OverlayKind::Flat, OverlayKind::Sewn, OverlayKind::Surface}) {
        if (!items.empty()) {
            items.emplace_back(kLine);
        }
        for (const OverlayTraits& known : kOverlays) {
            if (known.kind == kind) {
                items.emplace_back(overlayAction(known.overlay));
            }
        }
    }
    return items;
}

// clang-format off
std::vector<MenuSpec> makeTable() {
    using enum ActionId;
    return {
        {"fileMenu", TR("&File"),
         {Open, Submenu{"recentMenu"}, kLine,
          Save, SaveAs, kLine,
          OpenReference, CloseReference, kLine,
          ReadyToCut, ProveBySewing, SaveProof, ExportPattern, PrintPattern, kLine,
          Quit}},
        {"recentMenu", TR("Open &recent"), {RecentPlace{}}, kBelow},
        {"editMenu", TR("&Edit"),
         {Undo, Redo, kLine,
          SelectAll, SelectNone, SelectSameMaterial, SelectSameLayer, kLine,
          StateEase, ResetEase, JoinSeam, kLine,
          CommandPalette, EditPreferences}},
        {"viewMenu", TR("&View"),
         {Submenu{"overlayMenu"}, ValuesPerTriangle, WorstSpots, kLine,
          Submenu{"layersMenu"}, Wireframe, Xray, Shaded, PieceColours, kLine,
          Rulers, Grid, kLine,
          Frame, Submenu{"lookMenu"}, PlayMorph, PlaySewn, WalkSeam, kLine,
          GoToPieces, GoToSeams, GoToProblems, GoToHistory, GoToLines, GoToSymmetry,
          GoToProof,
          Submenu{"listsMenu"}, ResetLayout}},
        {"overlayMenu", TR("&Overlay"), overlayItems(), kBelow},
        {"layersMenu", TR("La&yers"),
         {CuttingLine, ShowSeams, ExactOutline, ReferencePanels, kLine,
          Notches, InternalLines, GrainArrows, Labels}, kBelow},
        {"lookMenu", TR("Loo&k from"),
         {LookFront, LookBack, LookRight, LookLeft, LookTop, LookBottom, kLine,
          Orthographic}, kBelow},
        {"listsMenu", TR("P&anels"), {ListsPlace{}}, kBelow},
        {"pieceMenu", TR("&Piece"),
         {RenamePiece, SetQuantity, Submenu{"materialMenu"}, kLine,
          HidePieces, ShowOnlyThese, ShowAllPieces, kLine,
          LeaveOut, TakeIn, LeaveOutSmall, kLine,
          CutOpen, DartHere, kLine,
          ExportOnlyThese}},
        {"pieceContext", "",
         {RenamePiece, SetQuantity, Submenu{"materialMenu"}, kLine,
          SelectSameMaterial, SelectSameLayer, kLine,
          HidePieces, ShowOnlyThese, ShowAllPieces, Frame, kLine,
          Submenu{"mirrorMenu"}, Submenu{"grainMenu"}, kLine,
          CutOpen, ProposeCuts, DartHere, kLine,
          FlattenAgain, CompareMethods, kLine,
          ExportOnlyThese, kLine,
          LeaveOut, TakeIn}, kContext},
        {"materialMenu", TR("Mater&ial"), {MaterialsPlace{}, kLine, NewMaterial}, kBelow},
        {"mirrorMenu", TR("&Mirror"), {MirrorLeftRight, MirrorUpsideDown}, kBelow},
        {"grainMenu", TR("&Grain"),
         {GrainUpwards, kLine, VerticalGrain, ReferenceGrain, BestGrain, ResetGrain}, kBelow},
        {"seamContext", "",
         {Frame, WalkSeam, kLine, StateEase, ResetEase, kLine,
          JoinSeam, DartToSeam, SeamToDart}, kContext},
        {"groundContext", "",
         {Frame, ShowAllPieces, kLine, LayOutAgain, kLine, Submenu{"overlayMenu"}}, kContext},
        {"toolsMenu", TR("&Tools"),
         {ToolSelect, kLine,
          ToolCut, ToolLoop, ToolDart, ToolJoin, kLine,
          ToolMeasure, ToolGrain, ToolNotch, ToolInternalLine, kLine,
          DartToSeam, SeamToDart, kLine,
          MirrorEdits}},
        {"layoutMenu", TR("La&yout"),
         {TurnLeft, TurnRight, MirrorLeftRight, MirrorUpsideDown, GoToPosition, kLine,
          Submenu{"lineUpMenu"}, LayOutAgain, LayOnCloth, kLine,
          GrainUpwards, kLine,
          VerticalGrain, ReferenceGrain, BestGrain, ResetGrain, kLine,
          Snapping}},
        {"lineUpMenu", TR("&Align"),
         {AlignLeft, AlignCentre, AlignRight, AlignTop, AlignMiddle, AlignBottom, kLine,
          DistributeAcross, DistributeUpwards}, kBelow},
        {"garmentMenu", TR("&Garment"),
         {Reload, kLine,
          GoToFabric, kLine,
          Submenu{"unitMenu"}, Submenu{"upMenu"}, Submenu{"readAsMenu"}, Submenu{"divideMenu"}, kLine,
          ProposeCuts, AutoCut, TailorCuts, CompleteHalf, TurnOver, Weld, CloseSlits, kLine,
          SeamsFromFile, SeamsToFile}},
        {"unitMenu", TR("&Unit"),
         {UnitAuto, UnitMillimetre, UnitCentimetre, UnitDecimetre, UnitMetre, UnitInch}, kBelow},
        {"upMenu", TR("Up &axis"), {UpAuto, UpY, UpZ}, kBelow},
        {"readAsMenu", TR("Tr&eat file as"),
         {ReadAuto, ReadSheet, kLine, ReadOuter, ReadInner, ReadMiddle, kLine,
          ReadLayers, ReadOuterLayer, ReadInnerLayer, kLine, ReadScan}, kBelow},
        {"divideMenu", TR("S&plit pieces by"),
         {SplitAuto, SplitComponents, SplitObjects, SplitGroups, SplitMaterials, SplitUv,
          SplitSeams}, kBelow},
        {"flattenMenu", TR("F&latten"), flattenItems()},
        {"qualityMenu", TR("&Quality"), {QualityDraft, QualityStandard, QualityFine}, kBelow},
        {"helpMenu", TR("&Help"), {FirstSteps, Documentation, Shortcuts, kLine, ReportProblem, About}},
    };
}
// clang-format on

void collect(const MenuSpec& menu, QStringList path, std::vector<PlacedAction>& found) {
    path << withoutMnemonic(menuText(menu.title));
    for (const MenuItem& item : menu.items) {
        if (const auto* id = std::get_if<ActionId>(&item)) {
            found.push_back({*id, path});
        } else if (const auto* submenu = std::get_if<Submenu>(&item)) {
            const auto& table = menuTable();
            const auto below = std::find_if(table.begin(), table.end(), [&](const auto& other) {
                return std::string_view(other.name) == submenu->name;
            });
            if (below != table.end()) {
                collect(*below, path, found);
            }
        }
    }
}

}  // namespace

const std::vector<MenuSpec>& menuTable() {
    static const std::vector<MenuSpec> table = makeTable();
    return table;
}

QString menuText(const char* text) {
    return tr(text);
}

bool isForSpecialists(ActionId id) {
    using enum ActionId;
    static constexpr ActionId kSome[] = {
        ValuesPerTriangle, Wireframe,      ExactOutline, MethodWang2005, MethodStretch,
        MethodConvex,      MethodNatural,  MethodLscm,   MethodAbf,      SolverNewton,
        SolverSlcp,        CompareMethods, Weld,         Orthographic};
    const auto isThis = [id](const OverlayTraits& known) {
        return known.isForSpecialists && overlayAction(known.overlay) == id;
    };
    return std::ranges::find(kSome, id) != std::end(kSome) ||
           std::ranges::any_of(kOverlays, isThis);
}

std::vector<PlacedAction> placedActions() {
    std::vector<PlacedAction> found;
    for (const MenuSpec& menu : menuTable()) {
        if (menu.place == MenuPlace::Bar) {
            collect(menu, {}, found);
        }
    }
    return found;
}

}  // namespace toile::app
