// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "app/actions/garment_actions.h"
#include "app/settings/preferences.h"
#include "app/views/garment_view.h"
#include "app/views/pattern_view.h"
#include "app/views/view_area.h"
#include "app/window/main_window.h"
#include "tests/app/support/own_input.h"
#include "tests/app/support/run_test.h"

namespace toile::test {

using namespace app;

/// A window that stores no preferences, and a folder for its files.
class WindowFixture {
public:
    static constexpr int kPatience = test::kPatience;  ///< milliseconds

    QString path(const QString& name) const { return folder_.filePath(name); }

    /// @param start  most tests need the exact outlines
    void open(QSize size = {1400, 900}, NewGarment start = NewGarment::Exact) {
        preferences_ = std::make_unique<Preferences>(QString());
        Choices choices = preferences_->choices();
        choices.newGarment = start;
        preferences_->setChoices(choices);
        window_ = std::make_unique<MainWindow>(*preferences_);
        // An unanswered question would stop the test.
        window_->garmentActions().fileDialogs().askToSave = [](QWidget*, const QString&) {
            return SaveAnswer::Discard;
        };
        window_->resize(size);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), kPatience));
        QApplication::setActiveWindow(window_.get());
    }

    void close() { window_.reset(); }

    MainWindow& window() { return *window_; }
    Preferences& preferences() { return *preferences_; }
    Workspace& workspace() { return window_->workspace(); }
    Document& document() { return workspace().document(); }
    GarmentView& garmentView() { return *window_->views().garmentView(); }
    PatternView& patternView() { return *window_->views().patternView(); }
    QAction& action(ActionId id) { return window_->actions()[id]; }

    template <class Widget>
    Widget& find(const char* name) {
        return *window_->findChild<Widget*>(name);
    }

    bool openAndWait(const QString& file) {
        window_->openFiles({file});
        return waitForResults();
    }

    /// True once the last job has finished and both views show its results.
    bool waitForResults() {
        return QTest::qWaitFor(
            [this] {
                return !workspace().cuts().searches().isBusy() && !workspace().jobs().isBusy() &&
                       !document().results().empty() && window_->views().isUpToDate();
            },
            kPatience);
    }

    /// True once no job runs.
    bool waitUntilIdle() {
        return QTest::qWaitFor([this] { return !workspace().isBusy(); }, kPatience);
    }

    QImage garmentPicture() { return garmentView().grabFramebuffer(); }
    QImage patternPicture() { return patternView().grabFramebuffer(); }

private:
    OwnInput input_;
    QTemporaryDir folder_;
    std::unique_ptr<Preferences> preferences_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace toile::test
