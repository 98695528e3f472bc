// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/document/document_change.h"
#include "app/document/overlay.h"
#include "core/flatten/base/flat_piece.h"

namespace toile::app {

class GarmentActions;
class Workspace;

/// Every action of the user, by name.
enum class ActionId {
    Open,
    Save,
    SaveAs,
    ExportPattern,
    OpenReference,
    CloseReference,
    PrintPattern,
    ReadyToCut,
    Quit,
    Undo,
    Redo,
    SelectAll,
    SelectNone,
    SelectSameMaterial,
    SelectSameLayer,
    Frame,
    FirstOverlay,  ///< use overlayAction()
    LastOverlay = FirstOverlay + kOverlayCount - 1,
    ValuesPerTriangle,
    WorstSpots,
    Wireframe,
    ReferencePanels,
    ExactOutline,
    ShowSeams,
    CuttingLine,
    Notches,
    InternalLines,
    GrainArrows,
    Labels,
    Xray,
    Shaded,
    PieceColours,
    LookFront,
    LookBack,
    LookRight,
    LookLeft,
    LookTop,
    LookBottom,
    Orthographic,
    PlayMorph,
    PlaySewn,
    WalkSeam,
    MethodIsometric,
    MethodCurvature,
    MethodWang2005,
    MethodStretch,
    MethodConvex,
    MethodNatural,
    MethodLscm,
    MethodAbf,
    QualityDraft,
    QualityStandard,
    QualityFine,
    SolverNewton,
    SolverSlcp,
    CompareMethods,
    LayOnCloth,
    ProveBySewing,
    SaveProof,
    ToolSelect,
    ToolCut,
    ToolLoop,
    ToolDart,
    ToolJoin,
    ToolMeasure,
    FlattenAgain,
    AutoFlatten,
    Cancel,
    Reload,
    UnitAuto,
    UnitMillimetre,
    UnitCentimetre,
    UnitDecimetre,
    UnitMetre,
    UnitInch,
    UpAuto,
    UpY,
    UpZ,
    ReadAuto,
    ReadSheet,
    ReadOuter,
    ReadInner,
    ReadMiddle,
    ReadLayers,
    ReadOuterLayer,
    ReadInnerLayer,
    ReadScan,
    SplitAuto,
    SplitComponents,
    SplitObjects,
    SplitGroups,
    SplitMaterials,
    SplitUv,
    SplitSeams,
    AutoCut,
    TailorCuts,
    ProposeCuts,
    CompleteHalf,
    TurnOver,
    Weld,
    CloseSlits,
    SeamsFromFile,
    SeamsToFile,
    RenamePiece,
    SetQuantity,
    NewMaterial,
    HidePieces,
    ShowOnlyThese,
    ShowAllPieces,
    LeaveOut,
    TakeIn,
    LeaveOutSmall,
    CutOpen,
    DartHere,
    ExportOnlyThese,
    JoinSeam,
    StateEase,
    ResetEase,
    ToolGrain,
    ToolNotch,
    ToolInternalLine,
    TurnLeft,
    TurnRight,
    MirrorLeftRight,
    MirrorUpsideDown,
    AlignLeft,
    AlignRight,
    AlignTop,
    AlignBottom,
    AlignCentre,
    AlignMiddle,
    DistributeAcross,
    DistributeUpwards,
    LayOutAgain,
    GrainUpwards,
    VerticalGrain,
    ReferenceGrain,
    BestGrain,
    ResetGrain,
    Rulers,
    Grid,
    Snapping,
    DartToSeam,
    SeamToDart,
    MirrorEdits,
    GoToPosition,
    GoToFabric,
    GoToPieces,
    GoToSeams,
    GoToProblems,
    GoToHistory,
    GoToLines,
    GoToSymmetry,
    GoToProof,
    ResetLayout,
    EditPreferences,
    CommandPalette,
    FirstSteps,
    Documentation,
    Shortcuts,
    ReportProblem,
    About,
};

/// The action that turns an overlay on.
constexpr ActionId overlayAction(Overlay overlay) {
    return static_cast<ActionId>(static_cast<int>(ActionId::FirstOverlay) +
                                 static_cast<int>(overlay));
}
/// The action that chooses a method.
ActionId actionOf(Method method);

/// Actions of one group exclude each other, except in Toggle.
enum class ActionGroup {
    None,
    Toggle,
    Tool,
    Overlay,
    Method,
    Quality,
    Solver,
    Unit,
    UpAxis,
    ReadAs,
    Split
};

/// Condition under which an action is enabled, and the changes of the document that can alter it.
struct When {
    using Holds = std::function<bool(Workspace&)>;
    using Reads = bool (*)(const DocumentChange&);

    When() = default;
    When(std::nullptr_t) {}
    template <class Function>
    requires std::is_invocable_r_v<bool, Function&, Workspace&> When(Function function,
                                                                     Reads what = nullptr)
        : holds(std::move(function)), reads(what) {}

    bool operator()(Workspace& on) const { return holds(on); }
    explicit operator bool() const { return holds != nullptr; }

    Holds holds{};          ///< none: always true
    Reads reads = nullptr;  ///< null: any change
};

/// What an action does, and when it is enabled. Work of views, panels and the window is connected
/// there (`ActionRegistry::on`).
struct ActionWork {
    /// @param checked  the action's new state
    std::function<void(GarmentActions& on, bool checked)> run{};
    When enabledWhen{};                             ///< none: always enabled
    std::function<bool(Workspace&)> checkedWhen{};  ///< none: set by its owner
    ActionGroup group = ActionGroup::None;
};

struct ActionSpec {
    ActionId id;
    const char* name;      ///< object name, for tests and settings
    const char* text;      ///< translated when used, like tip and shortText
    const char* shortcut;  ///< portable text; empty for none
    const char* tip;
    ActionWork work{};
    std::string icon{};
    const char* shortText = "";  ///< for the toolbar
};

/// Everything about actions except their place in the menus (menu_table.h).
const std::vector<ActionSpec>& actionTable();

}  // namespace toile::app
