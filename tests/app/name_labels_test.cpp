// SPDX-License-Identifier: GPL-3.0-or-later
// Where names and callouts go: legible, told apart and not on each other.
#include <QTest>

#include "app/views/callouts.h"
#include "app/views/pattern_text.h"
#include "app/views/view_text.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

const QFont kFont("Sans Serif", 9);
const QRectF kView(20, 20, 500, 400);
const QChar kGap(0x2026);

NamedPiece pieceAt(const QString& name, const QRectF& box) {
    return {name, {}, box.center(), box};
}

/// Strips side by side, so near that no name may stand out.
std::vector<NamedPiece> strips(const QStringList& names, double width) {
    std::vector<NamedPiece> pieces;
    for (const QString& name : names) {
        const double left = 30 + static_cast<double>(pieces.size()) * (width + 2);
        pieces.push_back(pieceAt(name, {left, 60, width, 300}));
    }
    return pieces;
}

bool anyMeet(const std::vector<QRectF>& boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (boxes[i].intersects(boxes[k])) {
                return true;
            }
        }
    }
    return false;
}

std::vector<QRectF> boxesOf(const std::vector<NameLabel>& names) {
    std::vector<QRectF> boxes;
    for (const NameLabel& name : names) {
        boxes.push_back(name.box);
    }
    return boxes;
}

}  // namespace

class NameLabelsTest : public QObject {
    Q_OBJECT

private slots:
    void aNameIsWrittenOutWhereThereIsRoom() {
        // Narrower than its name, with nothing beside it.
        const auto alone = nameLabels(kFont, {pieceAt("side_front_left", {200, 60, 12, 200})}, {});
        QCOMPARE(alone.size(), std::size_t{1});
        QCOMPARE(alone[0].text, QString("side_front_left"));
        QVERIFY(alone[0].box.width() > 60);
        QCOMPARE(alone[0].box.size(), labelSize(kFont, "side_front_left", false));
        const auto mirrored =
            nameLabels(kFont, {{"cuff", " · wrong side up", {250, 200}, {200, 100, 100, 200}}}, {});
        QCOMPARE(mirrored.at(0).text, QString("cuff · wrong side up"));
    }

    void whatAllNamesBeginWithGoesFirst() {
        const auto names =
            nameLabels(kFont, strips({"panel 5", "panel 15", "panel 25", "panel 115"}, 22), {});
        QStringList texts;
        for (const NameLabel& name : names) {
            texts << name.text;
        }
        texts.sort();
        QCOMPARE(texts, QStringList({"115", "15", "25", "5"}));
    }

    void aShortenedNameCanBeToldFromAllOthers() {
        const QStringList all{"side_front_left", "side_back_left", "collar_undercollar"};
        for (double width = 4; width < 90; width += 1.5) {
            const auto pieces = strips(all, width);
            const auto names = nameLabels(kFont, pieces, {});
            QVERIFY(!anyMeet(boxesOf(names)));
            for (const NameLabel& name : names) {
                QCOMPARE(name.box.size(), labelSize(kFont, name.text, false));
                const qsizetype gap = name.text.indexOf(kGap);
                if (gap < 0) {
                    QVERIFY(all.contains(name.text));
                    continue;
                }
                QVERIFY2(name.text.size() > 4, qPrintable(name.text));
                int like = 0;
                for (const QString& other : all) {
                    like += other.startsWith(name.text.left(gap)) &&
                            other.endsWith(name.text.mid(gap + 1));
                }
                QCOMPARE(like, 1);
            }
        }
    }

    void labelsKeepOffEachOtherAndOffOtherWords() {
        // Both names belong in one place, and something else is written there already.
        const QRectF piece(100, 60, 200, 300);
        const QRectF taken(150, 190, 100, 30);
        const auto names =
            nameLabels(kFont, {pieceAt("back_left", piece), pieceAt("back_right", piece)}, {taken});
        QCOMPARE(names.size(), std::size_t{2});
        std::vector<QRectF> boxes = boxesOf(names);
        for (const QRectF& box : boxes) {
            QVERIFY(piece.contains(box));
        }
        boxes.push_back(taken);
        QVERIFY(!anyMeet(boxes));
    }

    /// The grain line lies where names belong: beside it, above or below; over it only where there
    /// is no other way.
    void namesKeepOffGrainArrows() {
        const QRectF wide(100, 60, 200, 300), narrow(400, 60, 40, 300);
        for (const QRectF& piece : {wide, narrow}) {
            const QLineF arrow(piece.center() - QPointF(0, 15), piece.center() + QPointF(0, 15));
            const auto names = nameLabels(kFont, {pieceAt("sleeve", piece)}, {}, {arrow});
            QCOMPARE(names.size(), std::size_t{1});
            QVERIFY(!names[0].box.intersects(QRectF(arrow.p1(), arrow.p2()).adjusted(-1, 0, 1, 0)));
            const QLineF through(piece.center() - QPointF(0, 150),
                                 piece.center() + QPointF(0, 150));
            const auto over = nameLabels(kFont, {pieceAt("sleeve", piece)}, {}, {through});
            QCOMPARE(over.size(), std::size_t{1});
            QCOMPARE(over[0].box.center() == piece.center(), piece == narrow);
        }
    }

    void theSelectedPieceChoosesFirst() {
        auto pieces = strips({"one_name", "two_name"}, 30);
        for (NamedPiece& piece : pieces) {
            piece.at = {60, 200};
            piece.box = QRectF(30, 190, 60, 20);  // room for one
        }
        pieces[1].selected = true;
        const auto names = nameLabels(kFont, pieces, {});
        QCOMPARE(names.size(), std::size_t{1});
        QCOMPARE(names[0].piece, 1);
    }

    void calloutsKeepWithinTheViewAndOffOtherWords() {
        const QRectF caption = captionBox(kFont, {20, 20}, "Pattern", "seam lines");
        const CalloutRoom room{kView, {caption, QRectF(30, 370, 160, 40)}};
        std::vector<Callout> callouts;
        for (const QPointF& at :
             {QPointF(22, 22), QPointF(24, 200), QPointF(60, 40), QPointF(518, 30),
              QPointF(519, 419), QPointF(25, 415), QPointF(100, 390), QPointF(300, 21)}) {
            callouts.push_back({at, static_cast<int>(callouts.size()) + 1, "−12.5 %"});
        }
        callouts.push_back({{10, 200}, 9, "+1.0 %"});  // under the ruler
        const auto boxes = calloutBoxes(kFont, room, callouts);
        QCOMPARE(boxes.size(), callouts.size());
        QVERIFY(boxes.back().isEmpty());
        std::vector<QRectF> all = room.taken;
        for (std::size_t i = 0; i + 1 < boxes.size(); ++i) {
            QVERIFY2(kView.contains(boxes[i]), qPrintable(QString::number(i + 1)));
            all.push_back(boxes[i]);
        }
        QVERIFY(!anyMeet(all));
    }
};

TOILE_WINDOW_TEST(NameLabelsTest)
#include "name_labels_test.moc"
