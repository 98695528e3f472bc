// SPDX-License-Identifier: GPL-3.0-or-later
// Projects in the window: files that another program has changed meanwhile.
#include <QAbstractButton>
#include <QFile>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTimer>

#include "core/base/file.h"
#include "core/project/project_file.h"
#include "tests/app/support/project_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class ProjectOverwriteTest : public test::ProjectBench {
    Q_OBJECT

private:
    /// Another program has put its own there.
    std::string changeOnDisk() {
        const std::string theirs = *readFile(file("dress.toile")) + "\n";
        return writeFile(file("dress.toile"), theirs) ? theirs : std::string();
    }

private slots:
    void whatAnotherProgramHasSavedIsNotOverwrittenUnasked() {
        edit();
        saveAs("dress.toile");
        const std::string theirs = changeOnDisk();
        edit();
        fixture_->action(ActionId::Save).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(askedAboutOthers_, 1, test::kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!session().isSaving(), test::kPatience);
        QCOMPARE(*readFile(file("dress.toile")), theirs);
        QVERIFY(session().isModified());

        overwrite_ = OverwriteAnswer::SaveAs;
        QSignalSpy saved(&session(), &ProjectSession::saved);
        target_ = path("mine.toile");
        fixture_->action(ActionId::Save).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
        QCOMPARE(askedAboutOthers_, 2);
        QCOMPARE(session().title(), QString("mine.toile"));
        QCOMPARE(*readFile(file("dress.toile")), theirs);
    }

    void savingAnywayIsAskedAboutOnce() {
        edit();
        saveAs("dress.toile");
        (void)changeOnDisk();
        overwrite_ = OverwriteAnswer::SaveAnyway;
        for (const int quantity : {3, 4}) {  // the second time it is ours
            edit();
            QSignalSpy saved(&session(), &ProjectSession::saved);
            fixture_->action(ActionId::Save).trigger();
            QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
            QCOMPARE(askedAboutOthers_, 1);
            QVERIFY(!session().isModified());
            const auto read = readProject(file("dress.toile"));
            QCOMPARE(read->project.pieces.at(0).settings.quantity, quantity);
        }
    }

    void twoWindowsWithOneProjectDoNotOverwriteEachOther() {
        edit();
        saveAs("dress.toile");
        Workspace other;
        ProjectSession second(other);
        second.open(file("dress.toile"));
        QTRY_VERIFY_WITH_TIMEOUT(!second.path().empty(), test::kPatience);
        edit();  // in the first
        QSignalSpy saved(&session(), &ProjectSession::saved);
        fixture_->action(ActionId::Save).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
        QCOMPARE(askedAboutOthers_, 0);
        const auto first = *readFile(file("dress.toile"));
        QSignalSpy changed(&second, &ProjectSession::changedByOthers);
        second.save(second.path());
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, test::kPatience);
        QVERIFY(second.isModified());
        QCOMPARE(*readFile(file("dress.toile")), first);
    }

    void ownSavesAndMissingFilesAreNotAskedAbout() {
        edit();
        saveAs("dress.toile");
        QSignalSpy saved(&session(), &ProjectSession::saved);
        for (int i = 0; i < 3; ++i) {  // one after the other, none of them heard of yet
            edit();
            session().save(file("dress.toile"));
        }
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 3, test::kPatience);
        QVERIFY(QFile::remove(path("dress.toile")));
        edit();
        fixture_->action(ActionId::Save).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 4, test::kPatience);
        QCOMPARE(askedAboutOthers_, 0);
    }

    void closingAsksAboutOthersToo() {
        edit();
        saveAs("dress.toile");
        const std::string theirs = changeOnDisk();
        edit();
        answer_ = SaveAnswer::Save;
        QVERIFY(!window().close());
        QTRY_COMPARE_WITH_TIMEOUT(askedAboutOthers_, 1, test::kPatience);
        QVERIFY(window().isVisible());
        overwrite_ = OverwriteAnswer::SaveAnyway;
        QVERIFY(!window().close());
        QTRY_VERIFY_WITH_TIMEOUT(window().isHidden(), test::kPatience);
        QVERIFY(*readFile(file("dress.toile")) != theirs);
    }

    void theQuestionAboutOthersHasThreeAnswers_data() {
        QTest::addColumn<int>("key");
        QTest::addColumn<QString>("button");
        QTest::addColumn<int>("answer");
        QTest::newRow("anyway") << 0 << "Save anyway" << int(OverwriteAnswer::SaveAnyway);
        QTest::newRow("as") << 0 << "Save as…" << int(OverwriteAnswer::SaveAs);
        QTest::newRow("Enter") << int(Qt::Key_Return) << "" << int(OverwriteAnswer::SaveAs);
        QTest::newRow("Esc") << int(Qt::Key_Escape) << "" << int(OverwriteAnswer::Cancel);
    }

    void theQuestionAboutOthersHasThreeAnswers() {
        QFETCH(int, key);
        QFETCH(QString, button);
        QFETCH(int, answer);
        QTimer person;
        connect(&person, &QTimer::timeout, this, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) {
                return;
            }
            QVERIFY(box->text().startsWith("Another program has changed dress.toile"));
            if (key != 0) {
                QTest::keyClick(box, Qt::Key(key));
            }
            for (QAbstractButton* choice : box->buttons()) {
                if (choice->text().remove('&') == button) {
                    choice->click();
                }
            }
        });
        person.start(50);
        const auto given = FileDialogs::native().askToOverwrite(&window(), "dress.toile");
        QCOMPARE(int(given), answer);
    }
};

TOILE_WINDOW_TEST(ProjectOverwriteTest)
#include "project_overwrite_test.moc"
