// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include "app/actions/garment_actions.h"
#include "app/main_window.h"
#include "app/render/gl_support.h"
#include "app/resources.h"
#include "app/settings/preferences.h"
#include "app/views/view_area.h"
#include "tests/app/support/garments.h"

using namespace toile;

/// On a computer without OpenGL 3.3 the window says so and does all its other work.
class NoGlTest : public QObject {
    Q_OBJECT

private slots:
    void windowSaysSoAndWorksOn() {
        loadResources();
        if (glProblem().isEmpty()) {
            QSKIP("this platform offers OpenGL 3.3");
        }
        QTemporaryDir folder;
        test::writeObj(folder.filePath("cap.obj").toStdString(), {{"cap", test::makeCap(0)}});
        Preferences preferences{QString()};
        MainWindow window(preferences);
        window.show();
        window.openFiles({folder.filePath("cap.obj")});
        QTRY_VERIFY_WITH_TIMEOUT(!window.workspace().document().results().empty(), 30000);
        QVERIFY(window.findChild<QLabel*>("glProblem")->text().contains("OpenGL 3.3"));
        QVERIFY(window.views().isUpToDate());
        window.actions()[ActionId::Frame].trigger();
        QCOMPARE(window.findChild<QTreeView*>("pieceTable")->model()->rowCount(), 1);

        FileDialogs dialogs = FileDialogs::native();
        dialogs.save = [&](QWidget*, const QString&, const QString&) {
            return folder.filePath("cap.dxf");
        };
        window.garmentActions().setFileDialogs(dialogs);
        QSignalSpy exported(&window.workspace(), &Workspace::exported);
        window.actions()[ActionId::ExportDxf].trigger();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, 30000);
    }
};

QTEST_MAIN(NoGlTest)
#include "no_gl_test.moc"
