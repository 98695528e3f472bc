// SPDX-License-Identifier: GPL-3.0-or-later
// What a crash leaves of a project, and how it is offered and restored.
#include <QDir>
#include <QLockFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "app/session/autosave.h"
#include "app/widgets/banner.h"
#include "core/base/file.h"
#include "core/base/json_fields.h"
#include "core/marker/marker_settings.h"
#include "core/project/project_file.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/project_bench.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class ProjectRecoveryTest : public test::ProjectBench {
    Q_OBJECT

    /// A recovery file, as a crash leaves it.
    /// @param of  the project's file; empty where it was never saved
    QString leaveBehind(const QString& mesh, const std::filesystem::path& of = {},
                        const QString& name = "a") {
        (void)QDir().mkpath(path("recovery"));
        Project project;
        project.files = {{file(mesh)}};
        project.recoveryOf = of;
        const QString left = path("recovery/" + name + ".toile");
        (void)writeProject(left.toStdU16String(), project);
        return left;
    }

    /// Until the recovery file holds the present state.
    void waitUntilKept(Autosave& autosave) {
        QSignalSpy written(&autosave, &Autosave::written);
        // The first may have been on its way since before the last edit, the second not.
        for (int i = 0; i < 2; ++i) {
            written.clear();
            autosave.writeNow();
            QTRY_VERIFY_WITH_TIMEOUT(written.count() > 0, test::kPatience);
        }
    }

private slots:
    void whatACrashLeavesIsRestored() {
        const QString folder = path("recovery");
        const AutosaveTimes soon{10, 10, 10};
        Recovery& recovery = window().keepRecoveryFiles(folder, soon);
        saveAs("dress.toile");
        QSignalSpy written(&recovery.autosave(), &Autosave::written);
        doThings();
        QTRY_VERIFY_WITH_TIMEOUT(written.count() > 0, test::kPatience);
        waitUntilKept(recovery.autosave());
        const test::Moment before = test::momentOf(document());
        // The process dies: its file stays, its lock does not count any more.
        const QString left = recovery.autosave().file();
        QVERIFY(QFile::copy(left, path("left")));
        reopenWindow();
        QVERIFY(!QFile::exists(left));  // that was a clean exit
        QVERIFY(QFile::rename(path("left"), left));
        Recovery& next = window().keepRecoveryFiles(folder, soon);
        auto& card = fixture_->find<RecoveryCard>("recoveryCard");
        QVERIFY(card.isVisible());
        QVERIFY(card.sentence().contains("dress.toile"));
        QTest::mouseClick(&fixture_->find<QPushButton>("restoreRecovery"), Qt::LeftButton);
        QVERIFY(fixture_->waitForResults());
        QVERIFY(waitUntilFlat());
        QVERIFY(card.isHidden());
        QVERIFY(test::isSame(test::momentOf(document()), before));
        QVERIFY(session().isModified());
        QCOMPARE(session().title(), QString("dress.toile"));
        QCOMPARE(next.autosave().file(), left);  // safe until it is saved
        QCOMPARE(askedAboutOthers_, 0);
        QVERIFY(QFile::exists(left));
        QSignalSpy saved(&session(), &ProjectSession::saved);
        fixture_->action(ActionId::Save).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
        // An autosave that was under way writes the file once more, then removes it itself.
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(left), test::kPatience);
        const auto read = readProject(file("dress.toile"));
        QVERIFY(read && !read->project.recoveryOf);
    }

    void everySavedSettingWakesTheAutosave() {
        using Change = std::function<void(DocumentState&)>;
        const auto kept = [this](const QString& from) -> OrderedJson {
            const auto text = readFile(std::filesystem::path(from.toStdU16String()));
            return text ? OrderedJson::parse(*text) : OrderedJson();
        };
        QVERIFY(writeFile(file("other.dxf"), "0\nEOF\n"));
        writeMesh("body.obj");
        const std::map<std::string, Change> changes{
            {"reading", [](DocumentState& to) { to.inputs.loading.strict = true; }},
            {"seams",
             [](DocumentState& to) {
                 UserCut cut{"waist", UserCut::Kind::Path, {{0, 210, 0}, {300, 210, 0}}, false};
                 to.inputs.loading.seams.cuts.push_back(std::move(cut));
             }},
            {"flattening", [](DocumentState& to) { to.options.quality = Quality::Fine; }},
            {"lines", [](DocumentState& to) { to.lines.trueBelow = 0.1; }},
            {"fabric", [](DocumentState& to) { to.fabric = *fabricPreset("jersey"); }},
            {"materials",
             [](DocumentState& to) {
                 to.materials.push_back({"lining", fabricPresets().front()});
             }},
            {"pieces", [](DocumentState& to) { to.settings.begin()->second.quantity = 7; }},
            {"labels", [](DocumentState& to) { to.labels.begin()->second.name = "Other"; }},
            {"markers",
             [](DocumentState& to) {
                 MarkerPlan plan;
                 plan.settings.gap = 7;
                 to.markers = to.markers.with({}, std::move(plan));
             }},
            {"proof", [this](DocumentState& to) { to.proof.body = file("body.obj"); }},
            {"reference", [this](DocumentState& to) {
                 to.reference = {file("other.dxf"), std::make_shared<const PatternFile>()};
             }}};
        Recovery& recovery =
            window().keepRecoveryFiles(path("recovery"), AutosaveTimes{10, 10, 10});
        Autosave& autosave = recovery.autosave();
        const auto isAtRest = [&] {
            return waitUntilFlat() &&
                   QTest::qWaitFor([&] { return !autosave.findChild<QTimer*>()->isActive(); });
        };
        edit();
        QVERIFY(isAtRest());
        waitUntilKept(autosave);
        std::set<std::string> lost;
        const OrderedJson first = kept(autosave.file());
        for (const auto& member : first.items()) {
            lost.insert(member.key());
        }
        // They follow from the files, or say what the file is.
        for (const char* other :
             {"format", "version", "program", "files", "division", "recoveryOf"}) {
            QCOMPARE(lost.erase(other), std::size_t(1));
        }
        const auto expectKept = [&](const std::string& key, const std::function<void()>& change) {
            const OrderedJson before = kept(autosave.file());
            QSignalSpy written(&autosave, &Autosave::written);
            change();
            QVERIFY2(QTest::qWaitFor([&] { return written.count() > 0; }, test::kPatience),
                     key.c_str());
            QVERIFY(isAtRest());
            waitUntilKept(autosave);
            const OrderedJson after = kept(autosave.file());
            QVERIFY2(after.value(key, OrderedJson()) != before.value(key, OrderedJson()),
                     key.c_str());
            const auto read = readProject(std::filesystem::path(autosave.file().toStdU16String()));
            QVERIFY(read);
            const OrderedJson again = OrderedJson::parse(projectText(read->project, {}));
            QVERIFY2(again.at(key) == after.at(key),
                     (again.at(key).dump() + " for " + after.at(key).dump()).c_str());
            lost.erase(key);
        };
        for (const auto& [key, change] : changes) {
            expectKept(key, [&, change = change] {
                DocumentState next = document().state();
                change(next);
                document().edit("Change", std::move(next));
            });
        }
        expectKept("view", [this] { document().setView(&ViewState::wireframe, true); });
        QVERIFY2(lost.empty(), lost.empty() ? "" : lost.begin()->c_str());
    }

    void whatACrashLeavesCanBeDiscarded() {
        const QString folder = path("recovery");
        leaveBehind("dress.obj");
        leaveBehind("dress.obj", {}, "b");
        QCOMPARE(QDir(folder).entryList({"*.toile"}).size(), 2);
        window().keepRecoveryFiles(folder);
        auto& card = fixture_->find<RecoveryCard>("recoveryCard");
        QVERIFY(card.sentence().contains("dress.obj"));
        auto& discard = fixture_->find<QPushButton>("discardRecovery");
        QTest::mouseClick(&discard, Qt::LeftButton);
        QVERIFY(card.isVisible());
        QTest::mouseClick(&discard, Qt::LeftButton);
        QVERIFY(card.isHidden());
        QVERIFY(QDir(folder).entryList({"*.toile"}).isEmpty());
    }

    void whatAnotherLivingProcessKeepsIsNotOffered() {
        const QString left = leaveBehind("dress.obj");
        QVERIFY(QFile::exists(left));
        QLockFile lock(left + ".lock");
        QVERIFY(lock.tryLock(0));
        window().keepRecoveryFiles(path("recovery"));
        QVERIFY(!fixture_->find<RecoveryCard>("recoveryCard").isVisible());
    }

    void recoveryFilesGoWithTheChanges() {
        Recovery& recovery =
            window().keepRecoveryFiles(path("recovery"), AutosaveTimes{10, 10, 10});
        QSignalSpy written(&recovery.autosave(), &Autosave::written);
        edit();
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, test::kPatience);
        QVERIFY(QFile::exists(recovery.autosave().file()));
        document().history().undo();
        QVERIFY(recovery.autosave().file().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(QDir(path("recovery")).entryList({"*.toile"}).isEmpty(),
                                 test::kPatience);
    }

    void recoveryFilesFollowThePreference() {
        QVERIFY(!autosaveTimes(0));
        QCOMPARE(autosaveTimes(7)->apart, 7 * 60 * 1000);
        Preferences& preferences = fixture_->preferences();
        Choices choices = preferences.choices();
        choices.autosaveMinutes = 0;
        preferences.setChoices(choices);
        Recovery& recovery = window().keepRecoveryFiles(path("recovery"));
        QSignalSpy written(&recovery.autosave(), &Autosave::written);
        edit();
        recovery.autosave().writeNow();
        QVERIFY(recovery.autosave().file().isEmpty());  // it would be named at once
        choices.autosaveMinutes = 1;
        preferences.setChoices(choices);
        recovery.autosave().writeNow();
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, test::kPatience);
        const QString file = recovery.autosave().file();
        QVERIFY(QFile::exists(file));
        choices.autosaveMinutes = 0;
        preferences.setChoices(choices);
        QVERIFY(!QFile::exists(file));
    }

    void recoveryFilesAreWrittenSeldom() {
        Recovery& recovery =
            window().keepRecoveryFiles(path("recovery"), AutosaveTimes{10, 3600000, 10});
        QSignalSpy written(&recovery.autosave(), &Autosave::written);
        edit();
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, test::kPatience);
        edit();
        // The next is an hour off.
        const auto* timer = recovery.autosave().findChild<QTimer*>();
        QVERIFY(timer && timer->isActive());
        QVERIFY(timer->interval() > 1800000);
        QCOMPARE(written.count(), 1);
        recovery.autosave().setTimes(AutosaveTimes{10, 10, 10});
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 2, test::kPatience);
    }

    void aRecoveryFileThatCannotBeWrittenIsSaidAndTriedAgain() {
        Recovery& recovery =
            window().keepRecoveryFiles(path("recovery"), AutosaveTimes{10, 10, 10});
        QSignalSpy written(&recovery.autosave(), &Autosave::written);
        QSignalSpy failed(&recovery.autosave(), &Autosave::failed);
        edit();
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, test::kPatience);
        QVERIFY(QDir(path("recovery")).removeRecursively());
        edit();
        QTRY_VERIFY_WITH_TIMEOUT(failed.count() > 1, test::kPatience);
        QVERIFY(QDir(path("")).mkdir("recovery"));
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 2, test::kPatience);
    }

    void restoringAsksBeforeItTakesTheGarmentAway() {
        writeMesh("other.obj");
        leaveBehind("other.obj");
        window().keepRecoveryFiles(path("recovery"));
        edit();
        const test::Moment before = test::momentOf(document());
        auto& restore = fixture_->find<QPushButton>("restoreRecovery");
        QTest::mouseClick(&restore, Qt::LeftButton);
        QCOMPARE(asked_, 1);
        QVERIFY(!workspace().jobs().isBusy());
        QVERIFY(test::momentOf(document()) == before);
        QVERIFY(fixture_->find<RecoveryCard>("recoveryCard").isVisible());
        answer_ = SaveAnswer::Discard;
        QTest::mouseClick(&restore, Qt::LeftButton);
        QVERIFY(!restore.isEnabled());  // nor can it be discarded meanwhile
        QTRY_COMPARE_WITH_TIMEOUT(document().title(), QString("other.obj"), test::kPatience);
    }

    void aRestoringThatFailsCanBeTriedAgain() {
        const QString left = leaveBehind("dress.obj");
        window().keepRecoveryFiles(path("recovery"));
        QVERIFY(writeFile(left.toStdU16String(), "{"));
        auto& restore = fixture_->find<QPushButton>("restoreRecovery");
        QTest::mouseClick(&restore, Qt::LeftButton);
        QVERIFY(waitForBanner());
        QTRY_VERIFY_WITH_TIMEOUT(restore.isEnabled(), test::kPatience);
    }

    void aRecoveryWhoseMeshHasMovedStaysTheRecovery() {
        QVERIFY(QDir(path("")).mkdir("elsewhere"));
        writeMesh("elsewhere/moved.obj");
        const QString left = leaveBehind("moved.obj", file("coat.toile"));
        Recovery& recovery = window().keepRecoveryFiles(path("recovery"));
        foundMesh_ = path("elsewhere/moved.obj");
        QTest::mouseClick(&fixture_->find<QPushButton>("restoreRecovery"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(session().title(), QString("coat.toile"), test::kPatience);
        QCOMPARE(recovery.autosave().file(), left);
        QVERIFY(fixture_->find<RecoveryCard>("recoveryCard").isHidden());
        QVERIFY(session().isModified());
    }

    void aProjectThatNamesAnotherFileGetsNoName() {
        const QString victim = path("victim.toile");
        QVERIFY(writeFile(victim.toStdU16String(), "mine"));
        const QString from = leaveBehind("dress.obj", victim.toStdU16String());
        window().openFiles({from});
        QTRY_VERIFY_WITH_TIMEOUT(session().isModified(), test::kPatience);
        QVERIFY(session().path().empty());
        target_ = path("chosen.toile");
        QSignalSpy saved(&session(), &ProjectSession::saved);
        fixture_->action(ActionId::Save).trigger();
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
        QCOMPARE(*readFile(victim.toStdU16String()), std::string("mine"));
    }
};

TOILE_WINDOW_TEST(ProjectRecoveryTest)
#include "project_recovery_test.moc"
