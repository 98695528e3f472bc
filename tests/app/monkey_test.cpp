// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/monkey.h"

#include <QDir>
#include <QElapsedTimer>
#include <csignal>
#include <cstdio>

#include <execinfo.h>
#include <unistd.h>

#include "app/actions/project_actions.h"
#include "app/platform_choice.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"
#include "app/session/autosave.h"
#include "app/views/tools/tool_box.h"
#include "core/pattern/mirrored_edit.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/same_state.h"
#include "tests/app/support/warnings.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

namespace {

constexpr int kActionsPerGarment = 200;  ///< tests/nightly.sh asks for thousands
constexpr int kActionsPerRound = 600;    ///< then back to the start
constexpr int kMaxSteps = 440;           ///< the history forgets its beginning past 500
constexpr int kActionsPerLook = 40;
constexpr unsigned kLongAfterTheEnd = 550;  ///< seconds, a little before the test is cut off

int numberFrom(const char* variable, int otherwise) {
    const QByteArray text = qgetenv(variable);
    return text.isEmpty() ? otherwise : text.toInt();
}

const test::Monkey* theMonkey = nullptr;
int theSeed = 0;

void tellWhatItDid() {
    std::fprintf(stderr, "The monkey with TOILE_MONKEY_SEED=%d, after %d actions:\n", theSeed,
                 theMonkey ? theMonkey->actionsDone() : 0);
    if (theMonkey) {
        for (const QString& line : theMonkey->trace()) {
            std::fprintf(stderr, "  %s\n", qPrintable(line));
        }
    }
}

void onCrash(int number) {
    std::signal(number, SIG_DFL);
    constexpr int kMaxFrames = 60;
    void* frames[kMaxFrames];
    backtrace_symbols_fd(frames, backtrace(frames, kMaxFrames), STDERR_FILENO);
    tellWhatItDid();
    std::raise(number);
}

}  // namespace

/// Ten thousand things done without sense: nothing breaks, and undo leads back to the start, bit by
/// bit. TOILE_MONKEY_SEED and TOILE_MONKEY_ACTIONS choose another run.
class MonkeyTest : public QObject {
    Q_OBJECT

    test::WindowFixture fixture_;

    MainWindow& window() { return fixture_.window(); }
    Document& document() { return fixture_.document(); }
    Workspace& workspace() { return fixture_.workspace(); }

    /// What every state of the document promises; empty where it does.
    QString brokenPromise() {
        const Derived& state = document().derived();
        if (!state.garment) {
            return "the garment is gone";
        }
        const auto pieces = state.garment->pieces.size();
        if (document().settings().size() != pieces) {
            return "settings do not fit the pieces";
        }
        if (!state.results.empty() && state.results.size() != pieces) {
            return "results do not fit the pieces";
        }
        if (state.scene && (state.scene->pieces.size() != pieces ||
                            state.scene->seams.size() != state.garment->seams.seams.size())) {
            return "the scene is of another garment";
        }
        for (std::size_t i = 0; i < state.results.size(); ++i) {
            const PieceResult* result = state.results[i].get();
            if (result && result->flat &&
                (result->flat->Q.rows() != result->piece->mesh.V.rows() ||
                 !result->flat->Q.allFinite())) {
                return "a result does not fit its piece";
            }
        }
        for (const PieceSettings& settings : document().settings()) {
            if (settings.placement && (!settings.placement->offset.allFinite() ||
                                       !std::isfinite(settings.placement->turn))) {
                return "a piece lies nowhere";
            }
        }
        for (const int piece : document().selection()) {
            if (piece < 0 || piece >= document().pieceCount()) {
                return "a selected piece is outside of the garment";
            }
        }
        if (document().seam() && *document().seam() >= document().seamCount()) {
            return "the selected seam is outside of the garment";
        }
        const QUndoStack& history = document().history();
        if (history.index() < 0 || history.index() > history.count()) {
            return "the history does not know where it is";
        }
        return {};
    }

    /// Until no job runs and what can be flat is; the window is to follow. What was cancelled in a
    /// stage that cannot be stopped may keep the cores of a machine with much else to do for more
    /// than a minute: how long things take is no matter here.
    bool settle() {
        return QTest::qWaitFor(
            [this] {
                return !workspace().jobs().isBusy() && !workspace().writing().isBusy() &&
                       !window().garmentActions().project().session().isSaving();
            },
            10 * test::WindowFixture::kPatience);
    }

    void undoEverything() {
        window().tools().current().cancel();
        if (document()
                .history()
                .canUndo()) {  // who cancels at the start itself gets nothing flat there
            workspace().jobs().cancel();
        }
        QVERIFY(settle());
        while (document().history().canUndo()) {
            document().history().undo();
        }
        if (document()
                .history()
                .canRedo()) {  // the monkey may have cancelled here: who comes back has it
            document().history().redo();
            document().history().undo();
        }
        QVERIFY(settle());
    }

    void openSample(const QString& file) {
        const QString mesh = fixture_.path(file);
        QFile::remove(mesh);
        QVERIFY(QFile::copy(QString(TOILE_SOURCE_DIR "/resources/samples/") + file, mesh));
        FlattenOptions options = document().options();
        options.method = Method::Curvature;
        document().setOptions(options);
        QVERIFY(fixture_.openAndWait(mesh));
    }

    void play(std::uint64_t seed, int actions) {
        test::Warnings warnings;
        test::Generator random(seed);
        test::Monkey monkey(window(), random, fixture_.path("."));
        theMonkey = &monkey;
        QElapsedTimer time;
        time.start();
        int rounds = 0;
        while (monkey.actionsDone() < actions) {
            playOneRound(monkey, warnings,
                         std::min(actions - monkey.actionsDone(), kActionsPerRound));
            if (QTest::currentTestFailed()) {
                tellWhatItDid();
                return;
            }
            ++rounds;
        }
        qInfo("%d actions in %d rounds, %.1f s", monkey.actionsDone(), rounds,
              double(time.elapsed()) / 1000);
        theMonkey = nullptr;
    }

    void playOneRound(test::Monkey& monkey, const test::Warnings& warnings, int actions) {
        const test::Moment start = test::momentOf(document());
        const int last = monkey.actionsDone() + actions;
        while (monkey.actionsDone() < last && document().history().count() < kMaxSteps) {
            monkey.act();
            if (monkey.actionsDone() % kActionsPerLook == 0) {
                const QString broken = brokenPromise();
                QVERIFY2(broken.isEmpty(), qPrintable(broken));
            }
            QVERIFY2(warnings.texts().isEmpty(), qPrintable(warnings.texts().join('\n')));
            QVERIFY2(monkey.misread().isEmpty(), qPrintable(monkey.misread()));
        }
        undoEverything();
        const QString other = test::difference(test::momentOf(document()), start);
        QVERIFY2(other.isEmpty(), qPrintable("after undo another: " + other));
        QVERIFY2(brokenPromise().isEmpty(), qPrintable(brokenPromise()));
    }

private slots:
    void initTestCase() {
        if (!glProblem().isEmpty()) {
            QSKIP(qPrintable(glProblem()));
        }
        theSeed = numberFrom("TOILE_MONKEY_SEED", 20240611);
        for (const int number : {SIGSEGV, SIGABRT, SIGFPE, SIGALRM}) {
            std::signal(number, onCrash);
        }
        if (!qEnvironmentVariableIsSet("TOILE_MONKEY_SEED")) {  // by night it takes its time
            alarm(kLongAfterTheEnd);                            // who hangs is to say where
        }
    }

    void init() {
        fixture_.open();
        window().resize(900, 600);
        window().keepRecoveryFiles(fixture_.path("recovery"), AutosaveTimes{30, 200, 100});
    }

    void cleanup() {
        theMonkey = nullptr;
        fixture_.close();
    }

    void undoLeadsBackToTheStart_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("seed");
        QTest::addColumn<int>("megabytes");  // that old states may take
        QTest::newRow("T-shirt") << "tshirt.obj" << 1 << 1024;
        QTest::newRow("bodice") << "bodice.obj" << 2 << 4;
        QTest::newRow("cap, remembering little") << "cap.obj" << 3 << 0;
    }

    void undoLeadsBackToTheStart() {
        QFETCH(QString, file);
        QFETCH(int, seed);
        QFETCH(int, megabytes);
        openSample(file);
        document().cache().setMaxBytes(static_cast<std::size_t>(megabytes) << 20U);
        play(static_cast<std::uint64_t>(theSeed + 1000 * seed),
             numberFrom("TOILE_MONKEY_ACTIONS", 3 * kActionsPerGarment) / 3);
    }

    /// Where edits are mirrored a cut is made with its mirror image, or is its own, or is not made.
    void everyCutHasItsMirrorImage() {
        openSample("tshirt.obj");
        LineSettings lines;
        lines.mirror = Mirror::Mean;
        document().setLines(lines, "Mirror");
        QVERIFY(settle());
        test::Generator random(static_cast<std::uint64_t>(theSeed));
        int images = 0;
        for (int k = 0; k < 25; ++k) {
            const std::vector<UserCut> before = document().loading().seams.cuts;
            const UserCut cut = test::randomCut(document(), random);
            QVERIFY(document().derived().symmetry);
            const bool hasImage = mirroredCut(*document().garment(), document().results(),
                                              *document().derived().symmetry, cut)
                                      .has_value();
            workspace().cuts().add(cut);
            QVERIFY(settle());
            const std::vector<UserCut>& after = document().loading().seams.cuts;
            if (after == before) {
                continue;  // one of the two cannot be
            }
            QCOMPARE(after.size(), before.size() + (hasImage ? 2 : 1));
            const bool isImage = after.back().mirrors == (after.end() - 2)->id;
            QVERIFY(!hasImage || isImage);
            images += hasImage ? 1 : 0;
            if (random.chance(0.7)) {
                document().history().undo();
                QVERIFY(document().loading().seams.cuts == before);
                QVERIFY(settle());
            }
        }
        QVERIFY(images > 0);
        undoEverything();
        QVERIFY(document().loading().seams.cuts.empty());
    }

    /// What was done is in the project, and a project that was opened is as good as the garment.
    void projectsHoldWhatWasDone() {
        const QString project = fixture_.path("kept.toile");
        openSample("cap.obj");
        for (int round = 0; round < 4; ++round) {
            test::Generator random(static_cast<std::uint64_t>(theSeed + round));
            {
                test::Monkey monkey(window(), random, fixture_.path("."));
                theMonkey = &monkey;
                for (int k = 0; k < 60; ++k) {
                    monkey.act();
                }
                theMonkey = nullptr;
            }
            window().tools().current().cancel();
            QVERIFY(settle());
            const test::Moment before = test::momentOf(document());
            FileDialogs& dialogs = window().garmentActions().fileDialogs();
            dialogs.saveProject = [&](QWidget*, const QString&) { return project; };
            dialogs.askToSave = [](QWidget*, const QString&) { return SaveAnswer::Discard; };
            window().actions()[ActionId::SaveAs].trigger();
            QVERIFY(settle());
            QVERIFY(!window().garmentActions().project().session().isModified());
            window().openFiles({project});
            QVERIFY(settle());
            QVERIFY(!document().history().canUndo());
            QVERIFY(document().options() == before.state.options);
            QVERIFY(document().fabric() == before.state.fabric);
            QVERIFY(test::typed(document().loading()) == test::typed(before.state.inputs.loading));
            QCOMPARE(document().settings().size(), before.derived.garment->pieces.size());
            QVERIFY2(brokenPromise().isEmpty(), qPrintable(brokenPromise()));
        }
    }
};

TOILE_WINDOW_TEST(MonkeyTest)
#include "monkey_test.moc"
