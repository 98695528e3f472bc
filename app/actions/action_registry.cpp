// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/action_registry.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QKeySequence>

#include "app/text/method_text.h"
#include "app/widgets/icon.h"

namespace toile {

namespace {

/// Actions of one group exclude each other; those of Toggle stand alone.
enum class Group { None, Toggle, Tool, Overlay, Method, Quality, Solver, Unit, UpAxis, Split };

struct ActionSpec {
    ActionId id;
    const char* name;  ///< object name, for tests and settings
    const char* text;
    const char* shortcut;
    const char* tip;
    const char* icon = "";
    const char* shortText = "";  ///< for the toolbar
    Group group = Group::None;
};

// lupdate is told of this name, and takes the namespace for the context.
#define TR(text) text

constexpr ActionSpec kActions[] = {
    {ActionId::Open, "open", TR("&Open…"), "Ctrl+O",
     TR("Open a project or a garment: one file, or several that belong together"), "open",
     TR("Open")},
    {ActionId::Save, "save", TR("&Save"), "Ctrl+S",
     TR("Save everything done with this garment in its project file"), "save", TR("Save")},
    {ActionId::SaveAs, "saveAs", TR("Save &as…"), "Ctrl+Shift+S",
     TR("Save everything done with this garment in another project file")},
    {ActionId::ExportSvg, "exportSvg", TR("As &SVG drawing…"), "Ctrl+E",
     TR("Write the pattern at true scale for printing and drawing programs")},
    {ActionId::ExportDxf, "exportDxf", TR("As &DXF drawing…"), "",
     TR("Write the pattern at true scale for pattern and cutting programs")},
    {ActionId::ExportObj, "exportObj", TR("As &OBJ with UV map…"), "",
     TR("Write the garment again with the pattern as its UV map")},
    {ActionId::ExportReport, "exportReport", TR("&Report (JSON)…"), "",
     TR("Write every figure of every piece for other programs")},
    {ActionId::ReadyToCut, "readyToCut", TR("Read&y to cut?"), "F8",
     TR("Show whether the pattern can be cut as it is, and every fault with its place")},
    {ActionId::Quit, "quit", TR("&Quit"), "Ctrl+Q", TR("Close the window")},
    {ActionId::Undo, "undo", TR("&Undo"), "Ctrl+Z", TR("Take the last step back"), "undo",
     TR("Undo")},
    {ActionId::Redo, "redo", TR("&Redo"), "Ctrl+Shift+Z", TR("Do again what was taken back"),
     "redo", TR("Redo")},
    {ActionId::SelectAll, "selectAll", TR("Select &all"), "Ctrl+A", TR("Select every piece")},
    {ActionId::SelectNone, "selectNone", TR("Select &none"), "Ctrl+Shift+A",
     TR("Clear the selection of pieces and seams")},
    {ActionId::Frame, "frame", TR("&Frame"), "F",
     TR("Show the selected pieces or seam, or everything where none is selected"), "frame",
     TR("Frame")},
    {ActionId::OverlayNone, "overlayNone", TR("Piece &colours"), "1",
     TR("Every piece in its own colour"), "overlay-none", TR("Plain"), Group::Overlay},
    {ActionId::OverlayChecker, "overlayChecker", TR("Check&erboard"), "2",
     TR("True-scale squares of 1 cm on the cloth"), "overlay-checker", TR("Checker"),
     Group::Overlay},
    {ActionId::OverlayArea, "overlayArea", TR("&Area change"), "3",
     TR("How much area the cloth must gain by stretching, or has too much"), "overlay-area",
     TR("Area"), Group::Overlay},
    {ActionId::OverlayAngle, "overlayAngle", TR("An&gle change"), "4",
     TR("How much the corners of the cloth have turned"), "overlay-angle", TR("Angle"),
     Group::Overlay},
    {ActionId::OverlayStrain, "overlayStrain", TR("Edge &strain"), "5",
     TR("How far the cloth must stretch or gather to take its shape"), "overlay-strain",
     TR("Strain"), Group::Overlay},
    {ActionId::OverlayWarp, "overlayWarp", TR("Strain along war&p"), "6",
     TR("How far the cloth must stretch or gather along the grain"), "overlay-warp", TR("Warp"),
     Group::Overlay},
    {ActionId::OverlayWeft, "overlayWeft", TR("Strain along we&ft"), "7",
     TR("How far the cloth must stretch or gather across the grain"), "overlay-weft", TR("Weft"),
     Group::Overlay},
    {ActionId::OverlayBias, "overlayBias", TR("Strain on the &bias"), "8",
     TR("How far the cloth must stretch or gather at 45° to the grain, the worse of both "
        "diagonals"),
     "overlay-bias", TR("Bias"), Group::Overlay},
    {ActionId::OverlayPrincipal, "overlayPrincipal", TR("Principal s&train"), "9",
     TR("Crosses show in which directions the cloth stretches and gathers most, and how far"),
     "overlay-principal", TR("Principal"), Group::Overlay},
    {ActionId::OverlayDirichlet, "overlayDirichlet", TR("&Distortion energy"), "0",
     TR("Symmetric Dirichlet energy: one number for stretch and surplus in all directions"),
     "overlay-dirichlet", TR("Energy"), Group::Overlay},
    {ActionId::ValuesPerTriangle, "valuesPerTriangle", TR("&Values per triangle"), "Shift+V",
     TR("Paint every triangle in the colour of its own value, without smoothing"),
     "values-per-triangle", TR("Per triangle"), Group::Toggle},
    {ActionId::WorstSpots, "worstSpots", TR("Flag the w&orst spots"), "Shift+W",
     TR("Mark the places with the worst values with a number"), "worst-spots", TR("Worst spots"),
     Group::Toggle},
    {ActionId::Wireframe, "wireframe", TR("Show &wireframe"), "W",
     TR("Draw the triangles of the cloth"), "wireframe", TR("Wireframe"), Group::Toggle},
    {ActionId::DesignerOutline, "designerOutline", TR("&Designer's outline"), "D",
     TR("Draw the designer's own panels over the flat pieces, where the file carries them"), "", "",
     Group::Toggle},
    {ActionId::ShowSeams, "showSeams", TR("Show &seams"), "Shift+S",
     TR("Draw the seam lines, both sides of a seam in one colour"), "", "", Group::Toggle},
    {ActionId::Xray, "xray", TR("&X-ray"), "X",
     TR("See through the cloth of the garment to what lies behind it"), "", "", Group::Toggle},
    {ActionId::Shaded, "shaded", TR("Light and s&hade"), "Shift+L",
     TR("Let light fall on the garment; without it colours are as flat as in the pattern"), "", "",
     Group::Toggle},
    {ActionId::PieceColours, "pieceColours", TR("Pieces &in colour"), "Shift+C",
     TR("Give every piece a colour of its own; else all cloth is plain cotton"), "", "",
     Group::Toggle},
    {ActionId::LookFront, "lookFront", TR("From the &front"), "",
     TR("Look at the garment's front (1 on the number pad)")},
    {ActionId::LookBack, "lookBack", TR("From the &back"), "",
     TR("Look at the garment's back (Ctrl+1 on the number pad)")},
    {ActionId::LookRight, "lookRight", TR("From the &right"), "",
     TR("Look at the garment from the right of the picture (3 on the number pad)")},
    {ActionId::LookLeft, "lookLeft", TR("From the &left"), "",
     TR("Look at the garment from the left of the picture (Ctrl+3 on the number pad)")},
    {ActionId::LookTop, "lookTop", TR("From &above"), "",
     TR("Look down at the garment (7 on the number pad)")},
    {ActionId::LookBottom, "lookBottom", TR("From b&elow"), "",
     TR("Look up at the garment (Ctrl+7 on the number pad)")},
    {ActionId::Orthographic, "orthographic", TR("Without &perspective"), "",
     TR("Draw the garment so that parallel lines stay parallel (5 on the number pad)"), "", "",
     Group::Toggle},
    {ActionId::PlayMorph, "playMorph", TR("Play from garment to pa&ttern"), "Shift+M",
     TR("Watch the garment flatten, or the pattern close to the garment again")},
    {ActionId::MethodIsometric, "methodIsometric", methodText(Method::Isometric), "",
     TR("Seam lines keep their exact length; the cloth between them stretches as little as that "
        "allows, and no triangle is turned over"),
     "", "", Group::Method},
    {ActionId::MethodCurvature, "methodCurvature", methodText(Method::Curvature), "",
     TR("Seam lines keep their exact length; the outline turns where the garment is curved"), "",
     "", Group::Method},
    {ActionId::MethodWang2005, "methodWang2005", methodText(Method::Wang2005), "",
     TR("Seam lines keep their exact length; the outline gives way alike all around"), "", "",
     Group::Method},
    {ActionId::MethodStretch, "methodStretch", methodText(Method::Stretch), "",
     TR("Seam lines keep their exact length on a round outline; the cloth inside is moved until it "
        "stretches least"),
     "", "", Group::Method},
    {ActionId::MethodConvex, "methodConvex", methodText(Method::Convex), "",
     TR("Seam lines keep their exact length on a round outline: no triangle is ever turned over, "
        "but it is no pattern"),
     "", "", Group::Method},
    {ActionId::MethodNatural, "methodNatural", methodText(Method::Natural), "",
     TR("The cloth keeps its angles as well as it can; seam lines change their length"), "", "",
     Group::Method},
    {ActionId::MethodLscm, "methodLscm", methodText(Method::Lscm), "",
     TR("Nearly the same by another way; seam lines change their length"), "", "", Group::Method},
    {ActionId::MethodAbf, "methodAbf", methodText(Method::Abf), "",
     TR("Every triangle keeps its angles as well as it can; seam lines change their length"), "",
     "", Group::Method},
    {ActionId::QualityDraft, "qualityDraft", TR("&Draft"), "",
     TR("Quick: within some percent of the least distortion"), "", "", Group::Quality},
    {ActionId::QualityStandard, "qualityStandard", TR("&Standard"), "",
     TR("Within about a thousandth of the least distortion"), "", "", Group::Quality},
    {ActionId::QualityFine, "qualityFine", TR("&Fine"), "",
     TR("To the last digits: takes its time"), "", "", Group::Quality},
    {ActionId::SolverNewton, "solverNewton", TR("Outline by &Newton steps"), "",
     TR("The fast way to the outline"), "", "", Group::Solver},
    {ActionId::SolverSlcp, "solverSlcp", TR("Outline by &linearly constrained steps"), "",
     TR("The published way to the same outline"), "", "", Group::Solver},
    {ActionId::CompareMethods, "compareMethods", TR("C&ompare methods…"), "Ctrl+M",
     TR("See one piece flattened by up to four methods side by side, with a table of figures")},
    {ActionId::ToolSelect, "toolSelect", TR("&Select"), "V",
     TR("Select pieces, seams and vertices; move pieces in the pattern"), "tool-select",
     TR("Select"), Group::Tool},
    {ActionId::ToolCut, "toolCut", TR("&Cut"), "C",
     TR("Cut a piece along the shortest way through points on it"), "tool-cut", TR("Cut"),
     Group::Tool},
    {ActionId::ToolLoop, "toolLoop", TR("Closed &loop"), "L",
     TR("Cut a part out along a closed line through points on it"), "tool-loop", TR("Loop"),
     Group::Tool},
    {ActionId::ToolDart, "toolDart", TR("&Dart"), "T",
     TR("Cut from an edge to a tip inside the cloth"), "tool-dart", TR("Dart"), Group::Tool},
    {ActionId::ToolJoin, "toolJoin", TR("&Join"), "J",
     TR("Join the cloth on both sides of a seam, so that it becomes one"), "tool-join", TR("Join"),
     Group::Tool},
    {ActionId::ToolMeasure, "toolMeasure", TR("&Measure"), "M",
     TR("Measure on the garment and in the pattern, straight and along edges"), "tool-measure",
     TR("Measure"), Group::Tool},
    {ActionId::FlattenAgain, "flattenAgain", TR("Flatten &again"), "Ctrl+F5",
     TR("Flatten every piece again"), "flatten", TR("Flatten")},
    {ActionId::AutoFlatten, "autoFlatten", TR("Flatten after every ed&it"), "",
     TR("Flatten what an edit has changed at once; switch it off for heavy meshes"), "", "",
     Group::Toggle},
    {ActionId::Cancel, "cancel", TR("&Cancel"), "Esc", TR("Stop what is running"), "cancel"},
    {ActionId::Reload, "reload", TR("&Reload"), "F5",
     TR("Read the garment's files again as they are now")},
    {ActionId::UnitAuto, "unitAuto", TR("&Automatic"), "",
     TR("Choose the unit that gives a garment of human size"), "", "", Group::Unit},
    {ActionId::UnitMillimetre, "unitMillimetre", TR("&Millimetres"), "",
     TR("Read the file's numbers as millimetres"), "", "", Group::Unit},
    {ActionId::UnitCentimetre, "unitCentimetre", TR("&Centimetres"), "",
     TR("Read the file's numbers as centimetres"), "", "", Group::Unit},
    {ActionId::UnitMetre, "unitMetre", TR("M&etres"), "", TR("Read the file's numbers as metres"),
     "", "", Group::Unit},
    {ActionId::UnitInch, "unitInch", TR("&Inches"), "", TR("Read the file's numbers as inches"), "",
     "", Group::Unit},
    {ActionId::UpAuto, "upAuto", TR("&Automatic"), "",
     TR("Choose the axis along which a garment would stand upright"), "", "", Group::UpAxis},
    {ActionId::UpY, "upY", TR("&Y points up"), "", TR("The garment stands along the file's y axis"),
     "", "", Group::UpAxis},
    {ActionId::UpZ, "upZ", TR("&Z points up"), "", TR("The garment stands along the file's z axis"),
     "", "", Group::UpAxis},
    {ActionId::SplitAuto, "splitAuto", TR("&Automatic"), "",
     TR("Divide the garment into pieces by what the file has"), "", "", Group::Split},
    {ActionId::SplitComponents, "splitComponents", TR("&Parts"), "",
     TR("Whatever hangs together is one piece"), "", "", Group::Split},
    {ActionId::SplitObjects, "splitObjects", TR("&Objects"), "",
     TR("Each object of the file is one piece"), "", "", Group::Split},
    {ActionId::SplitGroups, "splitGroups", TR("&Groups"), "",
     TR("Each group of the file is one piece"), "", "", Group::Split},
    {ActionId::SplitMaterials, "splitMaterials", TR("&Materials"), "",
     TR("Each material of the file is one piece"), "", "", Group::Split},
    {ActionId::SplitUv, "splitUv", TR("&UV islands"), "",
     TR("Each island of the file's UV map is one piece"), "", "", Group::Split},
    {ActionId::SplitSeams, "splitSeams", TR("&Cuts only"), "",
     TR("One piece until a cut of the seams file parts it"), "", "", Group::Split},
    {ActionId::AutoCut, "autoCut", TR("&Cut open automatically"), "",
     TR("Cut open every piece that cannot lie flat as it is"), "", "", Group::Toggle},
    {ActionId::Weld, "weld", TR("&Weld vertices"), "",
     TR("Join vertices of an object that lie on each other"), "", "", Group::Toggle},
    {ActionId::SeamsFromFile, "seamsFromFile", TR("&Seams from file…"), "",
     TR("Take cuts and ease from a seams file (JSON)")},
    {ActionId::SeamsToFile, "seamsToFile", TR("Save sea&ms file…"), "",
     TR("Write the cuts and the ease that were stated to a seams file (JSON)")},
    {ActionId::StateEase, "stateEase", TR("State the &ease…"), "F2",
     TR("Say how much longer the left edge of the selected seam is meant to be")},
    {ActionId::ForgetEase, "forgetEase", TR("Ease &from the garment"), "Del",
     TR("Take the ease of the selected seam from its 3D lengths again")},
    {ActionId::ToolGrain, "toolGrain", TR("&Grain"), "G",
     TR("Turn the grain of a piece by its arrow in the pattern view"), "tool-grain", TR("Grain"),
     Group::Tool},
    {ActionId::TurnLeft, "turnLeft", TR("Turn &left"), "[",
     TR("Turn the selected pieces anti-clockwise by a right angle")},
    {ActionId::TurnRight, "turnRight", TR("Turn &right"), "]",
     TR("Turn the selected pieces clockwise by a right angle")},
    {ActionId::MirrorLeftRight, "mirrorLeftRight", TR("&Mirror left to right"), "H",
     TR("Turn the selected pieces over from left to right: their wrong side faces you then")},
    {ActionId::MirrorUpsideDown, "mirrorUpsideDown", TR("Mirror &upside down"), "Shift+H",
     TR("Turn the selected pieces over from top to bottom: their wrong side faces you then")},
    {ActionId::AlignLeft, "alignLeft", TR("&Left edges"), "",
     TR("Line the selected pieces up along their left edges")},
    {ActionId::AlignRight, "alignRight", TR("&Right edges"), "",
     TR("Line the selected pieces up along their right edges")},
    {ActionId::AlignTop, "alignTop", TR("&Upper edges"), "",
     TR("Line the selected pieces up along their upper edges")},
    {ActionId::AlignBottom, "alignBottom", TR("Lo&wer edges"), "",
     TR("Line the selected pieces up along their lower edges")},
    {ActionId::AlignCentre, "alignCentre", TR("&Middles, one above the other"), "",
     TR("Centre the selected pieces on one upright line")},
    {ActionId::AlignMiddle, "alignMiddle", TR("Middles, si&de by side"), "",
     TR("Centre the selected pieces on one level line")},
    {ActionId::DistributeAcross, "distributeAcross", TR("Same gaps &across"), "",
     TR("Move the selected pieces between the leftmost and the rightmost until their gaps are the "
        "same")},
    {ActionId::DistributeUpwards, "distributeUpwards", TR("Same gaps u&pwards"), "",
     TR("Move the selected pieces between the lowest and the highest until their gaps are the "
        "same")},
    {ActionId::LayOutAgain, "layOutAgain", TR("Lay &out again"), "Ctrl+L",
     TR("Put the selected pieces, or all where none is selected, in rows side by side")},
    {ActionId::GrainUpwards, "grainUpwards", TR("Turn &grain upwards"), "Shift+G",
     TR("Turn the selected pieces, or all where none is selected, so that their grain runs "
        "upwards")},
    {ActionId::BestGrain, "bestGrain", TR("&Best grain"), "",
     TR("Let the grain of the selected pieces, or of all, run where it strains the fabric least"),
     "", TR("Best")},
    {ActionId::ForgetGrain, "forgetGrain", TR("&Forget the grain"), "",
     TR("Leave it open how the grain of the selected pieces, or of all, runs"), "", TR("Forget")},
    {ActionId::Rulers, "rulers", TR("&Rulers"), "Ctrl+R",
     TR("Show rulers along the edges of the pattern view"), "", "", Group::Toggle},
    {ActionId::Grid, "grid", TR("Gri&d"), "Ctrl+G", TR("Show a grid on the sheet of the pattern"),
     "", "", Group::Toggle},
    {ActionId::Snapping, "snapping", TR("Sna&pping"), "S",
     TR("Let pieces catch at the grid and at each other while they are moved; Alt turns it the "
        "other way round"),
     "", "", Group::Toggle},
    {ActionId::GoToPosition, "goToPosition", TR("&Place…"), "P",
     TR("Type where the selected pieces lie, how far they are turned and how the grain runs")},
    {ActionId::GoToFabric, "goToFabric", TR("Fa&bric…"), "Shift+F",
     TR("Choose what the garment is cut from, and type how far it gives way")},
    {ActionId::GoToPieces, "goToPieces", TR("Go to &pieces"), "Ctrl+1",
     TR("Show the list of pieces and move the keyboard there")},
    {ActionId::GoToSeams, "goToSeams", TR("Go &to seams"), "Ctrl+2",
     TR("Show the list of seams and move the keyboard there")},
    {ActionId::GoToProblems, "goToProblems", TR("Go to proble&ms"), "Ctrl+3",
     TR("Show what stands against cutting and move the keyboard there")},
    {ActionId::GoToHistory, "goToHistory", TR("Go to &history"), "Ctrl+4",
     TR("Show the steps done so far and move the keyboard there")},
    {ActionId::ResetLayout, "resetLayout", TR("Reset &window layout"), "",
     TR("Put every list back below the views and every panel beside them, as at the first "
        "start")},
    {ActionId::EditPreferences, "editPreferences", TR("&Preferences…"), "Ctrl+,",
     TR("Choose units, colours, language and how the mouse moves the view")},
    {ActionId::CommandPalette, "commandPalette", TR("&Find a command…"), "Ctrl+K",
     TR("Type a few letters to run a command or to find a piece or a seam")},
    {ActionId::Shortcuts, "shortcuts", TR("&Keyboard and mouse"), "F1",
     TR("What every key and every movement of the mouse does")},
    {ActionId::About, "about", TR("&About Toile"), "", TR("Version, licence, and what Toile does")},
};

#undef TR

QString translated(const char* text) {
    return *text ? QCoreApplication::translate("toile", text) : QString();
}

}  // namespace

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

QString withoutMnemonic(const QString& text) {
    QString plain;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] == u'&' && ++i == text.size()) {
            break;
        }
        plain += text[i];
    }
    return plain;
}

ActionRegistry::ActionRegistry(QObject* parent) : QObject(parent) {
    std::map<Group, QActionGroup*> groups;
    for (const ActionSpec& spec : kActions) {
        auto* action = new QAction(translated(spec.text), this);
        action->setObjectName(spec.name);
        const QKeySequence shortcut(QString::fromLatin1(spec.shortcut));
        action->setShortcut(shortcut);
        const QString tip = translated(spec.tip);
        action->setStatusTip(tip);
        action->setToolTip(
            shortcut.isEmpty()
                ? tip
                : QString("%1 (%2)").arg(tip, shortcut.toString(QKeySequence::NativeText)));
        if (*spec.icon) {
            action->setIcon(themedIcon(spec.icon));
        }
        if (*spec.shortText) {
            action->setIconText(translated(spec.shortText));
        }
        action->setCheckable(spec.group != Group::None);
        if (spec.group > Group::Toggle) {
            QActionGroup*& group = groups[spec.group];
            if (!group) {
                group = new QActionGroup(this);
            }
            group->addAction(action);
        }
        actions_.emplace(spec.id, action);
        titles_.emplace(spec.id, withoutMnemonic(action->text()));
        ids_.push_back(spec.id);
    }
    actions_.at(ActionId::ForgetEase)->setShortcuts({Qt::Key_Delete, Qt::Key_Backspace});
    actions_.at(ActionId::Redo)
        ->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    actions_.at(ActionId::Quit)->setMenuRole(QAction::QuitRole);
    actions_.at(ActionId::About)->setMenuRole(QAction::AboutRole);
    actions_.at(ActionId::EditPreferences)->setMenuRole(QAction::PreferencesRole);
}

std::vector<QAction*> ActionRegistry::all() const {
    std::vector<QAction*> list;
    for (const ActionId id : ids_) {
        list.push_back(actions_.at(id));
    }
    return list;
}

}  // namespace toile
