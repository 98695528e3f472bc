// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/monkey.h"

#include <QAction>
#include <QApplication>
#include <QTest>
#include <QWheelEvent>
#include <set>

#include "app/actions/garment_actions.h"
#include "app/document/layout.h"
#include "app/views/garment_view.h"
#include "app/views/pattern_view.h"
#include "app/views/tools/tool_box.h"
#include "app/views/view_area.h"
#include "app/window/main_window.h"

namespace toile::test {

using namespace app;

namespace {

constexpr std::size_t kRemembered = 30;
constexpr double kPainted = 0.04;  ///< share of actions that are seen

/// Those that end a history, and those that take long however small the garment.
const std::set<ActionId> kLeftAlone = {
    ActionId::Quit,        ActionId::Open,       ActionId::MethodAbf,    ActionId::MethodStretch,
    ActionId::QualityFine, ActionId::SolverSlcp, ActionId::MethodConvex, ActionId::MethodWang2005};

}  // namespace

UserCut randomCut(const Document& document, Generator& random) {
    const Piece& piece =
        *document.garment()->pieces[std::size_t(random.whole(0, document.pieceCount() - 1))];
    constexpr UserCut::Kind kKinds[] = {UserCut::Kind::Path, UserCut::Kind::Path,
                                        UserCut::Kind::Path, UserCut::Kind::Loop,
                                        UserCut::Kind::Dart};
    UserCut cut;
    cut.kind = kKinds[random.whole(0, 4)];
    cut.alongEdges = random.chance(0.4);
    for (int points = random.whole(2, 4); points > 0; --points) {
        const auto vertex = random.whole(0, static_cast<int>(piece.mesh.V.rows()) - 1);
        cut.points.push_back(piece.mesh.V.row(vertex).transpose());
    }
    return cut;
}

Monkey::Monkey(MainWindow& window, Generator& random, QString folder)
    : window_(window), random_(random), folder_(std::move(folder)) {
    habits_ = {
        {14, &Monkey::triggerAction}, {3, &Monkey::flattenOtherwise},
        {14, &Monkey::click},         {4, &Monkey::doubleClick},
        {16, &Monkey::drag},          {5, &Monkey::drawWithTool},
        {14, &Monkey::hover},         {8, &Monkey::wheel},
        {8, &Monkey::pressKey},       {4, &Monkey::typeShortcut},
        {6, &Monkey::typeNumber},     {4, &Monkey::clickInPanel},
        {6, &Monkey::clickInTable},   {3, &Monkey::editInTable},
        {2, &Monkey::clickInHistory}, {14, &Monkey::undoOrRedo},
        {1, &Monkey::searchCommand},  {3, &Monkey::slideMorph},
        {8, &Monkey::select},         {3, &Monkey::cutSomewhere},
        {2, &Monkey::takeOut},        {3, &Monkey::stateEase},
        {6, &Monkey::layOut},         {1, &Monkey::choosePreference},
        {2, &Monkey::touchFrame},     {3, &Monkey::decideOnLines},
        {3, &Monkey::cancel},         {12, &Monkey::pause},
        {2, &Monkey::settle},         {3, &Monkey::decideOnSymmetry},
        {1, &Monkey::exportPattern},
    };
    if (qEnvironmentVariableIsSet("TOILE_MONKEY_SEED")) {  // by night
        habits_.insert(habits_.end(), {{6, &Monkey::openMenu},
                                       {3, &Monkey::typeNameOfPiece},
                                       {4, &Monkey::hideOrLeaveOut},
                                       {2, &Monkey::pressRemedy}});
    }
    for (const ActionSpec& spec : actionTable()) {
        if (!kLeftAlone.contains(spec.id)) {
            ids_.push_back(spec.id);
        }
    }
    window_.actions()[ActionId::Quit].setEnabled(false);  // shortcuts and the palette reach it too
    FileDialogs& dialogs = window_.garmentActions().fileDialogs();
    const auto maybe = [this](const QString& name) -> QString {
        return random_.chance(0.5) ? QString() : folder_ + '/' + name;
    };
    dialogs.open = [](QWidget*, const QString&) -> QStringList { return {}; };
    dialogs.openSeams = [maybe](QWidget*, const QString&) -> QString { return maybe("cuts.json"); };
    dialogs.openPattern = [maybe](QWidget*, const QString&) -> QString { return maybe("out.dxf"); };
    dialogs.openBody = [](QWidget*, const QString&) -> QString { return {}; };
    dialogs.save = [maybe](QWidget*, const QString& suggested, const QString& filter) -> QString {
        return maybe(filter.contains("eams") ? "cuts.json" : "out." + suggested.right(3));
    };
    dialogs.saveReport = dialogs.save;
    dialogs.saveProject = [maybe](QWidget*, const QString&) -> QString {
        return maybe("monkey.toile");
    };
    dialogs.findMesh = [](QWidget*, const QString&, const QString&) -> QString { return {}; };
    dialogs.askToSave = [](QWidget*, const QString&) { return SaveAnswer::Cancel; };
    dialogs.hasPrinter = [this] { return random_.chance(0.5); };
    dialogs.choosePrinter = [](QWidget*, QPrinter&, int) { return false; };
    QObject::connect(&closer_, &QTimer::timeout, &window_, [this] { answerDialogs(); });
    closer_.start(5);
    watchExports();
}

Monkey::~Monkey() {
    closer_.stop();
    answerDialogs();
    window_.setUpdatesEnabled(true);
}

void Monkey::answerDialogs() {
    for (int most = 4; most > 0; --most) {
        if (QWidget* popup = QApplication::activePopupWidget()) {
            popup->close();
        } else if (QWidget* modal = QApplication::activeModalWidget()) {
            modal->close();
        } else {
            break;
        }
    }
}

void Monkey::note(const QString& what) {
    static const QByteArray toFile = qgetenv("TOILE_MONKEY_TRACE");
    trace_.push_back(QString("%1%2").arg(QString(2 * (depth_ - 1), ' '), what));
    if (trace_.size() > kRemembered) {
        trace_.pop_front();
    }
    if (!toFile.isEmpty()) {
        std::fprintf(stderr, "%d %s\n", done_, qPrintable(trace_.back()));
    }
}

bool Monkey::isLeftAlone(const QAction& action) const {
    return std::ranges::any_of(kLeftAlone,
                               [&](ActionId id) { return &window_.actions()[id] == &action; });
}

QStringList Monkey::trace() const {
    return QStringList(trace_.begin(), trace_.end());
}

void Monkey::act() {
    int total = 0;
    for (const Habit& habit : habits_) {
        total += habit.weight;
    }
    int at = random_.whole(0, total - 1);
    ++done_;
    ++depth_;
    for (const Habit& habit : habits_) {
        at -= habit.weight;
        if (at < 0) {
            (this->*habit.does)();
            break;
        }
    }
    --depth_;
    if (depth_ == 0) {
        answerDialogs();
        // By a software renderer painting takes more time than everything else together.
        const bool paint = random_.chance(kPainted);
        window_.setUpdatesEnabled(paint);
        if (paint || random_.chance(0.15)) {
            QApplication::processEvents();
        }
    }
}

void Monkey::interrupt() {
    if (depth_ < 2) {
        act();
    }
}

SceneView& Monkey::someView() {
    ViewArea& views = window_.views();
    return random_.chance(0.5) ? static_cast<SceneView&>(*views.garmentView())
                               : static_cast<SceneView&>(*views.patternView());
}

QPoint Monkey::placeIn(const QWidget& widget) {
    return {random_.whole(0, std::max(0, widget.width() - 1)),
            random_.whole(0, std::max(0, widget.height() - 1))};
}

Qt::KeyboardModifiers Monkey::someModifiers() {
    constexpr Qt::KeyboardModifier kModifiers[] = {Qt::ShiftModifier, Qt::ControlModifier,
                                                   Qt::AltModifier};
    Qt::KeyboardModifiers modifiers;
    for (const Qt::KeyboardModifier modifier : kModifiers) {
        modifiers.setFlag(modifier, random_.chance(0.12));
    }
    return modifiers;
}

Qt::MouseButton Monkey::someButton() {
    return random_.chance(0.75)  ? Qt::LeftButton
           : random_.chance(0.5) ? Qt::MiddleButton
                                 : Qt::RightButton;
}

void Monkey::triggerAction() {
    const ActionId id = ids_[std::size_t(random_.whole(0, static_cast<int>(ids_.size()) - 1))];
    QAction& action = window_.actions()[id];
    note("action " + action.objectName() + (action.isEnabled() ? "" : " (off)"));
    if (action.isEnabled()) {
        action.trigger();
    }
}

void Monkey::flattenOtherwise() {
    constexpr Method kQuick[] = {Method::Curvature, Method::Curvature, Method::Natural,
                                 Method::Lscm, Method::Isometric};
    const Method method = kQuick[random_.whole(0, 4)];
    note(QString("method %1").arg(static_cast<int>(method)));
    window_.workspace().setMethod(method);
}

void Monkey::click() {
    SceneView& view = someView();
    const QPoint at = placeIn(view);
    const Qt::MouseButton button = someButton();
    const Qt::KeyboardModifiers modifiers = someModifiers();
    note(QString("click %1 %2,%3 button %4 modifiers %5")
             .arg(view.objectName())
             .arg(at.x())
             .arg(at.y())
             .arg(button)
             .arg(modifiers.toInt(), 0, 16));
    QTest::mouseClick(&view, button, modifiers, at);
}

void Monkey::doubleClick() {
    SceneView& view = someView();
    const QPoint at = placeIn(view);
    note(QString("double click %1 %2,%3").arg(view.objectName()).arg(at.x()).arg(at.y()));
    QTest::mouseDClick(&view, Qt::LeftButton, someModifiers(), at);
}

void Monkey::drag() {
    SceneView& view = someView();
    QPoint at = placeIn(view);
    const Qt::MouseButton button = someButton();
    const Qt::KeyboardModifiers modifiers = someModifiers();
    note(QString("drag %1 %2,%3 button %4")
             .arg(view.objectName())
             .arg(at.x())
             .arg(at.y())
             .arg(button));
    QTest::mousePress(&view, button, modifiers, at);
    for (int steps = random_.whole(1, 4); steps > 0; --steps) {
        at = placeIn(view);
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button,
                         modifiers);
        QApplication::sendEvent(&view, &move);
        if (random_.chance(0.12)) {
            interrupt();
        }
        if (random_.chance(0.1)) {
            QApplication::processEvents();
        }
    }
    if (random_.chance(0.1)) {
        note("escape");
        QTest::keyClick(&view, Qt::Key_Escape);
    }
    QTest::mouseRelease(&view, button, modifiers, at);
}

void Monkey::drawWithTool() {
    constexpr ToolId kTools[] = {ToolId::Cut,     ToolId::Loop,  ToolId::Dart,
                                 ToolId::Join,    ToolId::Notch, ToolId::InternalLine,
                                 ToolId::Measure, ToolId::Grain, ToolId::Select};
    window_.tools().choose(kTools[random_.whole(0, static_cast<int>(std::size(kTools)) - 1)]);
    SceneView& view = someView();
    // Clicks near the middle are likely to be on the cloth.
    for (int clicks = random_.whole(2, 4); clicks > 0; --clicks) {
        const QPoint at(static_cast<int>(view.width() * random_.between(0.3, 0.7)),
                        static_cast<int>(view.height() * random_.between(0.25, 0.75)));
        note(QString("tool %1 at %2,%3")
                 .arg(static_cast<int>(window_.tools().current().id()))
                 .arg(at.x())
                 .arg(at.y()));
        QTest::mouseMove(&view, at);
        QTest::mouseClick(&view, Qt::LeftButton, {}, at);
        if (random_.chance(0.15)) {
            interrupt();
        }
    }
    if (random_.chance(0.7)) {
        note("enter");
        QTest::keyClick(&view, Qt::Key_Return);
    }
}

void Monkey::hover() {
    SceneView& view = someView();
    for (int moves = random_.whole(1, 3); moves > 0; --moves) {
        const QPoint at = placeIn(view);
        note(QString("hover %1 %2,%3").arg(view.objectName()).arg(at.x()).arg(at.y()));
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                         someModifiers());
        QApplication::sendEvent(&view, &move);
    }
    if (random_.chance(0.2)) {
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&view, &leave);
    }
}

void Monkey::wheel() {
    SceneView& view = someView();
    const QPoint at = placeIn(view);
    const int delta = random_.whole(-4, 4) * 60;
    note(QString("wheel %1 %2").arg(view.objectName()).arg(delta));
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, someModifiers(),
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
}

void Monkey::pressKey() {
    constexpr Qt::Key kKeys[] = {Qt::Key_Escape, Qt::Key_Return, Qt::Key_Backspace, Qt::Key_Delete,
                                 Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,        Qt::Key_Down,
                                 Qt::Key_Space,  Qt::Key_Tab,    Qt::Key_Home,      Qt::Key_End,
                                 Qt::Key_1,      Qt::Key_3,      Qt::Key_5,         Qt::Key_7,
                                 Qt::Key_9,      Qt::Key_4,      Qt::Key_8};
    QWidget* widget = random_.chance(0.7) ? &someView() : QApplication::focusWidget();
    if (!widget) {
        return;
    }
    const Qt::Key key = kKeys[random_.whole(0, static_cast<int>(std::size(kKeys)) - 1)];
    Qt::KeyboardModifiers modifiers = someModifiers();
    modifiers.setFlag(Qt::KeypadModifier, key >= Qt::Key_1 && key <= Qt::Key_9);
    note(QString("key %1 in %2").arg(key, 0, 16).arg(widget->objectName()));
    QTest::keyClick(widget, key, modifiers);
}

void Monkey::typeShortcut() {
    const char letter = static_cast<char>(random_.whole('0', 'Z'));
    Qt::KeyboardModifiers modifiers;
    modifiers.setFlag(Qt::ShiftModifier, random_.chance(0.2));
    modifiers.setFlag(Qt::ControlModifier, random_.chance(0.2));
    if (modifiers.testFlag(Qt::ControlModifier) && (letter == 'Q' || letter == 'O')) {
        return;
    }
    note(QString("shortcut %1 %2").arg(letter).arg(modifiers.toInt(), 0, 16));
    QTest::keyClick(&someView(), letter, modifiers);
}

void Monkey::undoOrRedo() {
    for (int times = random_.whole(1, 3); times > 0; --times) {
        const bool undo = random_.chance(0.55);
        note(undo ? "undo" : "redo");
        window_.actions()[undo ? ActionId::Undo : ActionId::Redo].trigger();
    }
}

void Monkey::select() {
    Document& document = window_.workspace().document();
    const int pieces = document.pieceCount(), seams = document.seamCount();
    note("select");
    // Some of them outside of the garment.
    switch (random_.whole(0, 3)) {
        case 0: {
            Document::Selection chosen;
            for (int count = random_.whole(0, 4); count > 0; --count) {
                chosen.insert(random_.whole(-1, pieces));
            }
            document.setSelection(chosen);
            break;
        }
        case 1:
            document.setSeam(random_.chance(0.2) ? std::nullopt
                                                 : std::optional(random_.whole(-1, seams)));
            break;
        case 2: {
            Feature mark;
            mark.kind = random_.chance(0.5) ? Feature::Kind::Run : Feature::Kind::Vertex;
            mark.piece = random_.whole(-1, pieces);
            mark.first = random_.whole(-1, 300);
            mark.count = random_.whole(0, 50);
            mark.vertex = random_.whole(-1, 500);
            mark.face = random_.whole(-1, 900);
            document.setMark(mark);
            break;
        }
        default:
            document.toggleSelected(random_.whole(-1, pieces));
    }
}

void Monkey::cutSomewhere() {
    Document& document = window_.workspace().document();
    if (document.pieceCount() == 0) {
        return;
    }
    UserCut cut = randomCut(document, random_);
    note(QString("cut with %1 points").arg(cut.points.size()));
    window_.workspace().cuts().add(std::move(cut));
}

void Monkey::takeOut() {
    Workspace& workspace = window_.workspace();
    const auto& cuts = workspace.loading().seams.cuts;
    const auto& joins = workspace.loading().seams.joins;
    if (!cuts.empty() && random_.chance(0.4)) {
        note("remove cut");
        workspace.cuts().remove(
            cuts[std::size_t(random_.whole(0, static_cast<int>(cuts.size()) - 1))].id);
    } else if (!joins.empty() && random_.chance(0.4)) {
        note("remove join");
        const std::string name = joins.front().name;
        workspace.cuts().removeJoin(name);
    } else if (workspace.document().seamCount() > 0) {
        const int seam = random_.whole(0, workspace.document().seamCount() - 1);
        note(QString("join seam %1").arg(seam));
        workspace.cuts().joinSeam(seam);
    }
}

void Monkey::stateEase() {
    Workspace& workspace = window_.workspace();
    if (workspace.document().seamCount() == 0) {
        return;
    }
    const int seam = random_.whole(0, workspace.document().seamCount() - 1);
    note(QString("ease of seam %1").arg(seam));
    workspace.document().setSeamEase(
        seam, random_.chance(0.3) ? std::nullopt : std::optional(random_.between(-0.05, 0.1)));
}

void Monkey::layOut() {
    Document& document = window_.workspace().document();
    const std::vector<int> flat = allFlat(document);
    if (flat.empty()) {
        return;
    }
    const int piece = flat[std::size_t(random_.whole(0, static_cast<int>(flat.size()) - 1))];
    note(QString("lay out piece %1").arg(piece));
    switch (random_.whole(0, 3)) {
        case 0:
            place(document, "Move", {{piece, Placement{{random_.between(-500, 500), 10}}}});
            break;
        case 1:
            setGrain(document, "Grain", {{piece, random_.between(-4, 4)}});
            break;
        case 2:
            turnTogether(document, "Turn", flat, random_.between(-4, 4));
            break;
        default:
            mirrorTogether(document, "Mirror", {piece},
                           random_.chance(0.5) ? Mirroring::LeftRight : Mirroring::UpsideDown);
    }
}

void Monkey::cancel() {
    note("cancel");
    window_.workspace().jobs().cancel();
}

void Monkey::pause() {
    note("pause");
    QTest::qWait(random_.whole(0, 4));
}

void Monkey::settle() {
    note("settle");
    (void)QTest::qWaitFor([this] { return !window_.workspace().jobs().isBusy(); }, 1500);
}

}  // namespace toile::test
