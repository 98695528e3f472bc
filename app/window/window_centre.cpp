// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_centre.h"

#include <QScrollArea>
#include <QStackedWidget>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/actions/action_registry.h"
#include "app/panels/garment_summary.h"
#include "app/panels/welcome_page.h"
#include "app/settings/length_display.h"
#include "app/settings/preferences.h"
#include "app/views/garment_view.h"
#include "app/views/pattern_view.h"
#include "app/views/tools/tool_box.h"
#include "app/views/view_area.h"
#include "app/views/walk_bar.h"
#include "app/views/way_bars.h"
#include "app/widgets/banner.h"
#include "app/widgets/busy_sheet.h"
#include "app/widgets/garment_card.h"
#include "app/widgets/scrolled.h"
#include "app/window/window_busy.h"

namespace toile::app {

namespace {

constexpr std::pair<ActionId, ToolId> kTools[] = {
    {ActionId::ToolSelect, ToolId::Select},
    {ActionId::ToolCut, ToolId::Cut},
    {ActionId::ToolLoop, ToolId::Loop},
    {ActionId::ToolDart, ToolId::Dart},
    {ActionId::ToolJoin, ToolId::Join},
    {ActionId::ToolMeasure, ToolId::Measure},
    {ActionId::ToolGrain, ToolId::Grain},
    {ActionId::ToolNotch, ToolId::Notch},
    {ActionId::ToolInternalLine, ToolId::InternalLine},
};

constexpr std::pair<ActionId, ViewKey> kLooks[] = {
    {ActionId::LookFront, ViewKey::Front},
    {ActionId::LookBack, ViewKey::Back},
    {ActionId::LookRight, ViewKey::Right},
    {ActionId::LookLeft, ViewKey::Left},
    {ActionId::LookTop, ViewKey::Top},
    {ActionId::LookBottom, ViewKey::Bottom},
    {ActionId::Orthographic, ViewKey::Orthographic},
};

const QString kBetweenHints = QStringLiteral(" \u00b7 ");

/// True if a separator follows the tool in the palette.
bool endsGroup(ToolId tool) {
    return tool == ToolId::Select || tool == ToolId::Join;
}

}  // namespace

WindowCentre::WindowCentre(Workspace& workspace, const ActionRegistry& actions, ToolBox& tools,
                           Preferences& preferences, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      actions_(actions),
      tools_(tools),
      preferences_(preferences),
      banner_(new Banner(this)),
      recoveryCard_(new RecoveryCard(this)),
      card_(new GarmentCard(this)),
      pages_(new QStackedWidget(this)),
      views_(new ViewArea(workspace.document(), tools, pages_)),
      busy_(new WindowBusy(workspace, actions[ActionId::Cancel], *this, views_->patternView())) {
    connect(&workspace_, &Workspace::refused, banner_, &Banner::showSentence);
    for (JobRunner* jobs : workspace_.runners()) {
        connect(jobs, &JobRunner::failed, banner_, [this](const QString&, const QString& sentence) {
            banner_->showSentence(sentence);
        });
    }
    connect(card_, &GarmentCard::kept, this, [this] {
        keptGuesses_ = workspace_.openPaths();
        askedAgain_.clear();
    });
    connect(card_, &GarmentCard::answered, this, [this] { askedAgain_.clear(); });
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, [this] {
        ask();
        views_->repaintViews();  // to update the scale bar
    });
    auto* welcome = new WelcomePage(preferences, pages_);
    connect(welcome, &WelcomePage::openWanted, &actions[ActionId::Open], &QAction::trigger);
    connect(welcome, &WelcomePage::filesWanted, this, &WindowCentre::filesWanted);
    pages_->addWidget(scrolledColumn(*welcome, pages_));
    pages_->addWidget(makeWork(actions));
    pages_->addWidget(&busy_->page());
    connect(busy_, &WindowBusy::changed, this, &WindowCentre::showPage);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(banner_);
    layout->addWidget(recoveryCard_);
    layout->addWidget(card_);
    layout->addWidget(pages_, 1);
}

QWidget* WindowCentre::makeWork(const ActionRegistry& actions) {
    connect(views_, &ViewArea::failed, banner_, &Banner::showSentence);
    connect(views_, &ViewArea::entered, this, &WindowCentre::hintChanged);
    actions.on(ActionId::Frame, views_, &ViewArea::frameSelection);
    connectLooks(actions);
    auto* work = new QWidget(pages_);
    auto* row = new QHBoxLayout(work);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(makeToolPalette(actions));
    row->addWidget(views_, 1);
    connectTools(actions);
    return work;
}

QWidget* WindowCentre::makeToolPalette(const ActionRegistry& actions) {
    auto* bar = new QToolBar(tr("Tools"), this);
    bar->setObjectName("toolPalette");
    bar->setOrientation(Qt::Vertical);
    bar->setMovable(false);
    bar->setIconSize({22, 22});
    bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    for (const auto& [action, tool] : kTools) {
        bar->addAction(&actions[action]);
        if (endsGroup(tool)) {
            bar->addSeparator();
        }
    }
    return bar;
}

void WindowCentre::connectTools(const ActionRegistry& actions) {
    for (const auto& [action, tool] : kTools) {
        actions.on(action, this, [this, tool = tool] {
            tools_.choose(tool);
            views_->takeKeyboard();  // so that Escape and Enter reach the tool
        });
    }
    const auto show = [&actions](ToolId chosen) {
        for (const auto& [action, tool] : kTools) {
            actions[action].setChecked(tool == chosen);
        }
    };
    connect(&tools_, &ToolBox::chosen, this, show);
    connect(&tools_, &ToolBox::changed, this, &WindowCentre::hintChanged);
    show(tools_.current().id());
}

void WindowCentre::connectLooks(const ActionRegistry& actions) {
    GarmentView* view = views_->garmentView();
    if (!view) {
        return;
    }
    for (const auto& [id, key] : kLooks) {
        actions.on(id, view, [view, key = key] { view->look(key); });
    }
    connect(view, &GarmentView::orthographicChanged, &actions[ActionId::Orthographic],
            &QAction::setChecked);
    actions.on(ActionId::PlayMorph, views_->morphBar(), &MorphBar::play);
    actions.on(ActionId::PlaySewn, views_->sewnBar(), &SewnBar::play);
    actions.on(ActionId::WalkSeam, views_->walkBar(), &WalkBar::begin);
}

void WindowCentre::ask() {
    const bool isWanted = !askedAgain_.empty() && askedAgain_ == workspace_.openPaths();
    const auto prepareScan = [this] { actions_[ActionId::ReadScan].trigger(); };
    card_->ask(isWanted           ? garmentQuestions(workspace_, prepareScan, Asked::Always)
               : areGuessesKept() ? GarmentQuestions{}
                                  : garmentQuestions(workspace_, prepareScan));
}

void WindowCentre::askAgain() {
    askedAgain_ = workspace_.openPaths();
    ask();
}

void WindowCentre::showViews(bool shown) {
    hasViews_ = shown;
    showPage();
}

void WindowCentre::showPage() {
    pages_->setCurrentIndex(hasViews_ ? 1 : busy_->isReading() ? 2 : 0);
}

QString WindowCentre::hint() const {
    const ViewKind view = views_->viewInUse();
    QStringList hints = tools_.current().hint(view).split(kBetweenHints);
    const QStringList camera =
        cameraHint(preferences_.choices().navigation, view == ViewKind::Pattern)
            .split(kBetweenHints);
    // The first hints, read at a glance, come from both the tool and the camera.
    hints.insert(std::min<qsizetype>(hints.size(), 2), camera.front());
    return (hints + camera.mid(1)).join(kBetweenHints);
}

}  // namespace toile::app
