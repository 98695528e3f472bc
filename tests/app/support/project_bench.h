// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>

#include "app/actions/project_actions.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/window_fixture.h"

namespace toile::test {

using namespace app;

/// Two places this close are the same, mm: the anchors that define them are stored rounded.
inline constexpr double kSameShape = 1e-6;

/// True if the user's decisions are the same, every vertex is at the same place of the sheet to
/// within kSameShape, and the grain has the same direction. Both must be flattened.
bool isSame(const Moment& a, const Moment& b);

/// A window with a garment of three pieces, "front", "back" and "cap", and answers to file dialogs
/// that the test sets.
class ProjectBench : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    /// Makes a new folder with "dress.obj", which is open and flat, and resets all answers below.
    void init();
    void cleanup();

protected:
    std::unique_ptr<WindowFixture> fixture_;
    SaveAnswer answer_ = SaveAnswer::Cancel;
    int asked_ = 0;  ///< number of questions whether to save
    OverwriteAnswer overwrite_ = OverwriteAnswer::Cancel;
    int askedAboutOthers_ = 0;  ///< number of questions whether to overwrite other changes
    QString target_;            ///< where to save
    QString foundMesh_;         ///< new path of a missing mesh
    QStringList lookedFor_;     ///< names of missing meshes

    MainWindow& window() { return fixture_->window(); }
    Workspace& workspace() { return fixture_->workspace(); }
    Document& document() { return fixture_->document(); }
    ProjectSession& session() { return window().garmentActions().project().session(); }
    QString path(const QString& name) { return fixture_->path(name); }
    std::filesystem::path file(const QString& name) { return path(name).toStdU16String(); }

    void openWindow();
    void reopenWindow();
    void writeMesh(const QString& name, double width = 300);
    /// Makes one edit of every kind.
    void doThings();
    /// Makes the smallest edit.
    void edit();
    bool waitUntilFlat();
    bool waitForBanner();
    void saveAs(const QString& name);
};

}  // namespace toile::test
