// SPDX-License-Identifier: GPL-3.0-or-later
// Where names and callouts go: legible, told apart and not on each other.
#include "app/views/name_labels.h"

#include <QPolygonF>
#include <QTest>
#include <QTransform>
#include <cmath>

#include "app/views/callouts.h"
#include "app/views/name_cloth.h"
#include "app/views/view_text.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

/// In pixels, as the boxes are.
const QFont kFont = [] {
    QFont font("Sans Serif");
    font.setPixelSize(12);
    return font;
}();
const QRectF kView(20, 20, 500, 400);
const QChar kGap(0x2026);

QPolygonF boxOutline(const QRectF& box) {
    return {{box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()}};
}

NamedPiece pieceAt(const QString& name, const QRectF& box) {
    return {name, {}, box.center(), boxOutline(box), box};
}

/// Strips side by side, so near that no name stands beside one.
std::vector<NamedPiece> strips(const QStringList& names, const QSizeF& size) {
    std::vector<NamedPiece> pieces;
    for (const QString& name : names) {
        const double left = 30 + static_cast<double>(pieces.size()) * (size.width() + 2);
        pieces.push_back(pieceAt(name, {QPointF(left, 24), size}));
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
        boxes.push_back(name.bounds());
    }
    return boxes;
}

/// On its cloth or else beside all of it, with a leader that ends on it.
bool isWhereItBelongs(const NameLabel& name, const NamedPiece& piece) {
    if (!name.leader) {
        return piece.outline.boundingRect().contains(name.bounds());
    }
    return !name.bounds().intersects(piece.box) &&
           piece.outline.containsPoint(name.leader->p2(), Qt::OddEvenFill);
}

}  // namespace

class NameLabelsTest : public QObject {
    Q_OBJECT

private slots:
    void aNameIsWrittenWhereFilesHaveIt() {
        const NamedPiece wide = pieceAt("side_front_left", {100, 60, 200, 200});
        const auto names = nameLabels(kFont, {wide}, {kView});
        QCOMPARE(names.size(), std::size_t{1});
        QCOMPARE(names[0].text, QString("side_front_left"));
        QCOMPARE(names[0].box.center(), wide.at);
        QCOMPARE(names[0].angle, 0.0);
        QCOMPARE(names[0].box.size(), labelSize(kFont, "side_front_left", false));
        NamedPiece mirrored = pieceAt("cuff", {200, 100, 140, 200});
        mirrored.note = " · wrong side up";
        QCOMPARE(nameLabels(kFont, {mirrored}, {kView}).at(0).text,
                 QString("cuff · wrong side up"));
    }

    void alongANarrowPieceItIsTurned() {
        for (const double tilt : {0.0, 25.0, -40.0}) {
            NamedPiece piece = pieceAt("side_front_left", {200, 60, 24, 200});
            QTransform turn;
            turn.translate(212, 160);
            turn.rotate(tilt);
            turn.translate(-212, -160);
            piece.outline = turn.map(piece.outline);
            piece.box = piece.outline.boundingRect();
            const auto names = nameLabels(kFont, {piece}, {kView});
            QCOMPARE(names.size(), std::size_t{1});
            QCOMPARE(names[0].text, QString("side_front_left"));
            QVERIFY(!names[0].leader);
            QVERIFY2(std::abs(names[0].angle) > 0.8, qPrintable(QString::number(names[0].angle)));
            QVERIFY(std::abs(names[0].angle) < 1.58);  // never upside down
            // No corner of it beyond the cloth.
            QTransform label;
            label.translate(names[0].box.center().x(), names[0].box.center().y());
            label.rotateRadians(-names[0].angle);
            const QRectF box = names[0].box.translated(-names[0].box.center());
            for (const QPointF& corner :
                 {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()}) {
                QVERIFY(piece.outline.containsPoint(label.map(corner), Qt::OddEvenFill));
            }
        }
    }

    void besideWhatIsTooNarrowItHasALeader() {
        const NamedPiece piece = pieceAt("side_front_left", {200, 60, 9, 200});
        const auto names = nameLabels(kFont, {piece}, {kView});
        QCOMPARE(names.size(), std::size_t{1});
        QCOMPARE(names[0].text, QString("side_front_left"));
        QVERIFY(names[0].leader);
        QVERIFY(isWhereItBelongs(names[0], piece));
        QVERIFY(names[0].leader->length() < 20);
        // Not where another piece lies.
        const NamedPiece above = pieceAt("yoke", {150, 22, 120, 36});
        const auto both = nameLabels(kFont, {piece, above}, {kView});
        QCOMPARE(both.size(), std::size_t{2});
        for (const NameLabel& name : both) {
            const NamedPiece& own = name.piece == 0 ? piece : above;
            const NamedPiece& other = name.piece == 0 ? above : piece;
            QVERIFY(isWhereItBelongs(name, own));
            QVERIFY(!name.bounds().intersects(other.box));
        }
    }

    void aLeaderCrossesNoNameWhereItCan() {
        // A strip in a hollow of cloth: above it a name that is taken, below it nothing.
        NamedPiece strip = pieceAt("side_front_left", {200, 160, 9, 60});
        strip.box = {150, 120, 109, 130};
        const QRectF name(160, 130, 90, 16), below = name.translated(0, 100);
        for (const QRectF& taken : {name, below}) {
            const auto names = nameLabels(kFont, {strip}, {kView, {taken}});
            QCOMPARE(names.size(), std::size_t{1});
            QVERIFY(names[0].leader);
            QVERIFY(!crosses(*names[0].leader, taken));
        }
    }

    void whatAllNamesBeginWithGoesFirst() {
        // As high as the view, and too narrow for the whole name either way.
        const QSizeF size(labelSize(kFont, "115", false, kSmallName).width() + 6,
                          labelSize(kFont, "panel 5", false, kSmallName).width() - 6);
        auto pieces = strips({"panel 5", "panel 15", "panel 25", "panel 115"}, size);
        const QRectF view(28, 22, 4 * (size.width() + 2) + 6, size.height() + 4);
        QStringList texts;
        for (const NameLabel& name : nameLabels(kFont, pieces, {view})) {
            texts << name.text;
        }
        texts.sort();
        QCOMPARE(texts, QStringList({"115", "15", "25", "5"}));
    }

    void aShortenedNameCanBeToldFromAllOthers() {
        const QStringList all{"side_front_left", "side_back_left", "collar_undercollar"};
        for (double width = 4; width < 90; width += 1.5) {
            const auto pieces = strips(all, {width, 60});
            const auto names = nameLabels(kFont, pieces, {kView});
            QVERIFY(!anyMeet(boxesOf(names)));
            for (const NameLabel& name : names) {
                QVERIFY(isWhereItBelongs(name, pieces[static_cast<std::size_t>(name.piece)]));
                QCOMPARE(name.box.size(), labelSize(kFont, name.text, false, name.size));
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
        const auto names = nameLabels(
            kFont, {pieceAt("back_left", piece), pieceAt("back_right", piece)}, {kView, {taken}});
        QCOMPARE(names.size(), std::size_t{2});
        std::vector<QRectF> boxes = boxesOf(names);
        for (const QRectF& box : boxes) {
            QVERIFY(piece.contains(box));
        }
        boxes.push_back(taken);
        QVERIFY(!anyMeet(boxes));
    }

    /// The grain line lies where names belong: beside it, above or below, or along it.
    void namesKeepOffGrainArrows() {
        for (const QRectF& piece :
             {QRectF(100, 60, 200, 300), QRectF(400, 60, 70, 300), QRectF(400, 60, 20, 300)}) {
            for (const double half : {15.0, 150.0}) {
                const QLineF arrow(piece.center() - QPointF(0, half),
                                   piece.center() + QPointF(0, half));
                NamedPiece named = pieceAt("sleeve", piece);
                named.arrow = arrow;
                const auto names = nameLabels(kFont, {named}, {kView, {}, {arrow}});
                QCOMPARE(names.size(), std::size_t{1});
                QVERIFY(isWhereItBelongs(names[0], named));
                QVERIFY(!names[0].bounds().intersects(
                    QRectF(arrow.p1(), arrow.p2()).adjusted(-1, 0, 1, 0)));
            }
        }
    }

    void wordsRunAlongTheirOwnArrowOnly() {
        const QPolygonF square = boxOutline({100, 100, 80, 80});
        const QLineF own(110, 170, 170, 110), other(90, 90, 120, 150);
        QVERIFY(NameCloth(square, {}, {other}, {}).ways().empty());
        const NameCloth cloth(square, own, {own, other}, {});
        QCOMPARE(cloth.ways().size(), std::size_t{1});
        QVERIFY(std::abs(cloth.ways()[0] - 0.785) < 0.001);
        // Along the grain of what is long is along the cloth.
        const QLineF down(150, 300, 150, 110);
        QCOMPARE(NameCloth(boxOutline({100, 100, 80, 300}), down, {down}, {}).ways().size(),
                 std::size_t{1});
    }

    void keptNamesFollowWhatChanges() {
        KeptNames kept;
        std::vector<NamedPiece> pieces{pieceAt("sleeve", {100, 60, 200, 200})};
        for (const QPointF& by : {QPointF(), QPointF(), QPointF(3, 4)}) {
            pieces[0].at += by;
            const auto anew = nameLabels(kFont, pieces, {kView});
            const auto& names = kept.of(kFont, pieces, {kView});
            QCOMPARE(names.size(), anew.size());
            QCOMPARE(names[0].box, anew[0].box);
        }
        QVERIFY(kept.of(kFont, {}, {kView}).empty());
    }

    void theSelectedPieceChoosesFirst() {
        // Room for one, and none around.
        auto pieces =
            strips({"one_name", "two_name"}, labelSize(kFont, "two_name", true) + QSizeF(12, 2));
        pieces[1].outline = pieces[0].outline;
        pieces[1].box = pieces[0].box;
        pieces[1].at = pieces[0].at;
        pieces[1].selected = true;
        const auto names = nameLabels(kFont, pieces, {pieces[0].box.adjusted(-1, -1, 1, 1)});
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

    void calloutsLieBesideLinesWhereThereIsAChoice() {
        const Callout callout{{250, 200}, 1, "−12.5 %"};
        const QRectF usual = calloutBoxes(kFont, {kView}, {callout})[0];
        const QPointF middle = usual.center();
        const QPolygonF level({{20, middle.y()}, {500, middle.y()}});
        const QPolygonF plumb({{middle.x(), 20}, {middle.x(), 400}});
        for (const std::vector<QPolygonF>& lines :
             {std::vector{level}, std::vector{plumb}, std::vector{level, plumb}}) {
            const QRectF box = calloutBoxes(kFont, {kView, {}, lines}, {callout})[0];
            QVERIFY(kView.contains(box));
            for (const QPolygonF& line : lines) {
                QVERIFY(!crosses({line[0], line[1]}, box));
            }
        }
        // Lines that lie elsewhere change nothing; nor does cloth as large as the view.
        const QPolygonF around({{20, 20}, {500, 20}, {500, 400}, {20, 400}, {20, 20}});
        QCOMPARE(calloutBoxes(kFont, {kView, {}, {around}}, {callout})[0], usual);
        // Nor does a leader cross a name that its label does not lie on.
        const QRectF name(256, 189, 40, 4);
        const QRectF box = calloutBoxes(kFont, {kView, {name}}, {callout})[0];
        QVERIFY(!box.intersects(name));
        QVERIFY(box.right() < callout.at.x() || box.top() > callout.at.y());
    }

    void aLineCrossesABoxWhereAnyOfItLiesInIt() {
        const QRectF box(10, 10, 20, 10);
        QVERIFY(crosses({0, 0, 40, 30}, box));
        QVERIFY(crosses({12, 12, 13, 13}, box));
        QVERIFY(crosses({20, 0, 20, 40}, box));
        QVERIFY(crosses({0, 15, 40, 15}, box));
        QVERIFY(!crosses({0, 0, 9, 15}, box));
        QVERIFY(!crosses({5, 0, 5, 40}, box));
        QVERIFY(!crosses({0, 12, 12, 40}, box));
        QVERIFY(!crosses({35, 0, 40, 30}, box));
    }
};

TOILE_WINDOW_TEST(NameLabelsTest)
#include "name_labels_test.moc"
