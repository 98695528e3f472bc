// SPDX-License-Identifier: GPL-3.0-or-later
// Which cuts belong together, and what is said of pieces by half.
#include "app/document/mirrored_edits.h"

#include <QTest>

#include "app/document/document.h"
#include "app/document/piece_edits.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class MirroredEditsTest : public QObject {
    Q_OBJECT

    static UserCut cut(const std::string& name, double x) {
        return {name, UserCut::Kind::Path, {{x, 0, 0}, {x, 10, 0}}};
    }

private slots:
    void anImageKnowsWhatItMirrors() {
        std::vector<UserCut> cuts{cut("a", 1)};
        addMirroredCuts(cuts, cut("b", 2), cut("c", -2));
        QCOMPARE(cuts.size(), std::size_t(3));
        QCOMPARE(cuts[1].name, std::string("b"));
        QVERIFY(cuts[1].id && cuts[2].id && !(cuts[1].id == cuts[2].id));
        QVERIFY(cuts[2].mirrors == cuts[1].id);
        QVERIFY(!cuts[0].mirrors && !cuts[1].mirrors);
    }

    void imagesAndWhatTheyMirrorGoTogether() {
        std::vector<UserCut> cuts{cut("a", 1)};
        addMirroredCuts(cuts, cut("b", 2), cut("c", -2));
        addMirroredCuts(cuts, cut("d", 3), cut("e", -3));
        const std::vector<CutId> b{cuts[1].id}, c{cuts[2].id};
        QVERIFY(withMirrorImages(cuts, b) == (std::vector{cuts[1].id, cuts[2].id}));
        QVERIFY(withMirrorImages(cuts, c) == (std::vector{cuts[2].id, cuts[1].id}));
        const std::vector<CutId> alone{cuts[0].id}, both{cuts[1].id, cuts[2].id};
        QVERIFY(withMirrorImages(cuts, alone) == alone);
        QVERIFY(withMirrorImages(cuts, both) == both);
        QVERIFY(withMirrorImages(cuts, {}).empty());
    }

    void piecesCutByHalfAreDrawnEqual() {
        Document document;
        Derived derived;
        derived.garment = test::makeGarment(
            {{"left", test::makeSheet(100, 80, 2, 2)}, {"right", test::makeSheet(100, 80, 2, 2)}});
        DocumentState state;
        for (const auto& piece : derived.garment->pieces) {
            state.settings[piece->id] = {};
        }
        document.open(state, derived);
        setByHalf(document, {0, 1, 7}, true);
        QCOMPARE(document.history().count(), 1);
        QVERIFY(document.settings()[0].byHalf && document.settings()[1].byHalf);
        QCOMPARE(document.state().lines.mirror, Mirror::Close);
        setByHalf(document, {0, 1}, true);
        setByHalf(document, {-1}, true);
        QCOMPARE(document.history().count(), 1);
        setByHalf(document, {0, 1}, false);
        QVERIFY(!document.settings()[0].byHalf);
        QCOMPARE(document.state().lines.mirror, Mirror::Close);
        document.history().undo();
        document.history().undo();
        QVERIFY(!document.settings()[1].byHalf);
        QCOMPARE(document.state().lines.mirror, Mirror::None);
        // Of a garment of which no plane is known nothing is mirrored.
        QVERIFY(!mirrorsEdits(document) && !editSymmetry(document));
        QCOMPARE(withCounterparts(document, {1}), std::vector{1});
        QCOMPARE(withMirroredGrains(document, {{0, 0.5}}).size(), std::size_t(1));
    }
};

TOILE_WINDOW_TEST(MirroredEditsTest)
#include "mirrored_edits_test.moc"
