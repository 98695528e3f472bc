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

/// To this a place is the same: it is found by anchors of which not every digit is written, mm.
inline constexpr double kSameShape = 1e-6;

/// What a person has done is the same, and every vertex lies at the same place of the sheet to
/// within kSameShape, the grain in the same direction. Both flattened.
bool isSame(const Moment& a, const Moment& b);

/// A window with a garment of three pieces, "front", "back" and "cap", and a person who answers
/// what is asked about files as the test says.
class ProjectBench : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    /// Another folder, "dress.obj" in it, open and flat; and all answers as below.
    void init();
    void cleanup();

protected:
    std::unique_ptr<WindowFixture> fixture_;
    SaveAnswer answer_ = SaveAnswer::Cancel;
    int asked_ = 0;  ///< whether to save
    OverwriteAnswer overwrite_ = OverwriteAnswer::Cancel;
    int askedAboutOthers_ = 0;  ///< whether to save over what another program wrote
    QString target_;            ///< where to save
    QString foundMesh_;         ///< where a mesh is that has gone
    QStringList lookedFor_;     ///< such meshes

    MainWindow& window() { return fixture_->window(); }
    Workspace& workspace() { return fixture_->workspace(); }
    Document& document() { return fixture_->document(); }
    ProjectSession& session() { return window().garmentActions().project().session(); }
    QString path(const QString& name) { return fixture_->path(name); }
    std::filesystem::path file(const QString& name) { return path(name).toStdU16String(); }

    void openWindow();
    void reopenWindow();
    void writeMesh(const QString& name, double width = 300);
    /// A bit of everything.
    void doThings();
    /// The smallest edit.
    void edit();
    bool waitUntilFlat();
    bool waitForBanner();
    void saveAs(const QString& name);
};

}  // namespace toile::test
