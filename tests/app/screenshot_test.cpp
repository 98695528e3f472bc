// SPDX-License-Identifier: GPL-3.0-or-later
#include <QGuiApplication>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "app/render/gl_support.h"
#include "core/project/project_file.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

/// `toile FILE --screenshot`, the built program on the display of the test.
class ScreenshotTest : public QObject {
    Q_OBJECT

private:
    struct Run {
        int status = -1;
        QString said;
        QImage picture;
    };

    QTemporaryDir folder_;

    std::filesystem::path path(const char* name) const {
        return folder_.filePath(name).toStdString();
    }

    Run photograph(const QStringList& arguments, const QString& platform = {}) {
        const QString file = folder_.filePath("window.png");
        QFile::remove(file);
        QProcess program;
        if (!platform.isEmpty()) {
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("QT_QPA_PLATFORM", platform);
            program.setProcessEnvironment(environment);
        }
        program.start(TOILE_PROGRAM, QStringList(arguments) << "--screenshot" << file);
        if (!program.waitForFinished(60000) || program.exitStatus() != QProcess::NormalExit) {
            return {};
        }
        return {program.exitCode(), QString::fromUtf8(program.readAllStandardError()),
                QImage(file)};
    }

    /// A cap, and a project of it that shows its strain.
    void writeProjectOfACap() {
        test::writeObj(path("cap.obj"), {{"cap", test::makeCap(0)}});
        Project project;
        project.files = {FileReference{.path = path("cap.obj"), .hash = 1}};  // of another file
        project.loading.unit = LengthUnit::Millimetre;
        project.view.overlay = "strain";
        QVERIFY(writeProject(path("cap.toile"), project));
    }

private slots:
    void initTestCase() {
        if (!glProblem().isEmpty()) {
            QSKIP(qPrintable(glProblem()));
        }
    }

    void aProjectWhoseMeshHasChangedIsShownWithASentence() {
        writeProjectOfACap();
        const Run run = photograph({folder_.filePath("cap.toile")});
        QVERIFY2(run.status == 0, qPrintable(run.said));
        QVERIFY(!run.picture.isNull());
        QVERIFY2(run.said.contains("cap.obj"), qPrintable(run.said));
    }

    void theOverlayThatIsTypedGoesBeforeTheProjects() {
        writeProjectOfACap();
        const Run own = photograph({folder_.filePath("cap.toile")});
        const Run typed = photograph({folder_.filePath("cap.toile"), "--overlay", "none"});
        const Run strain = photograph({folder_.filePath("cap.toile"), "--overlay", "strain"});
        QCOMPARE(typed.status, 0);
        QVERIFY(own.picture != typed.picture);
        QCOMPARE(own.picture, strain.picture);
    }

    /// Qt's offscreen platform makes contexts on the display of the test, and ended with a signal.
    void aPlatformWithoutAScreenHasAWindowWithoutGl() {
        writeProjectOfACap();
        const Run run = photograph({folder_.filePath("cap.obj"), "--unit", "mm"}, "offscreen");
        QVERIFY2(run.status == 0, qPrintable(run.said));
        QVERIFY(!run.picture.isNull());
    }

    void whatCannotBeReadIsStatusThree() {
        const Run run = photograph({folder_.filePath("missing.obj")});
        QCOMPARE(run.status, 3);
        QVERIFY2(run.said.contains("toile: "), qPrintable(run.said));
        QVERIFY(run.picture.isNull());
    }

    void whatCannotBeWrittenIsStatusThree() {
        writeProjectOfACap();
        QProcess program;
        program.start(TOILE_PROGRAM, {folder_.filePath("cap.toile"), "--screenshot",
                                      folder_.filePath("missing/window.png")});
        QVERIFY(program.waitForFinished(60000));
        QCOMPARE(program.exitCode(), 3);
    }

    void aDisplayThatDoesNotAnswerIsASentence() {
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("DISPLAY", ":4711");
        environment.remove("WAYLAND_DISPLAY");
        program.setProcessEnvironment(environment);
        program.start(TOILE_PROGRAM, QStringList());
        QVERIFY(program.waitForFinished(60000));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 3);
        const QString said = QString::fromUtf8(program.readAllStandardError());
        QVERIFY2(said.contains("xvfb-run"), qPrintable(said));
    }
};

TOILE_WINDOW_TEST(ScreenshotTest)
#include "screenshot_test.moc"
