// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/guide.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextStream>
#include <algorithm>
#include <limits>

#include "app/actions/menu_table.h"
#include "app/export/export_dialog.h"
#include "tests/app/support/mouse.h"

namespace toile::test {

using namespace app;

namespace {

QRegularExpressionMatch match(const char* pattern, const QString& sentence) {
    return QRegularExpression(QRegularExpression::anchoredPattern(QString::fromUtf8(pattern)))
        .match(sentence);
}

int pieceNamed(const Document& document, const QString& name) {
    for (int piece = 0; piece < document.pieceCount(); ++piece) {
        const auto& pieces = document.garment()->pieces;
        if (QString::fromStdString(pieces[static_cast<std::size_t>(piece)]->name) == name) {
            return piece;
        }
    }
    return -1;
}

/// Where the middle of a piece is in a view: well inside, near where its name is written.
std::optional<QPointF> middleOf(const Document& document, const SceneView& view, int piece) {
    const PieceResult* result = document.result(piece);
    if (!result || !result->flat || !document.scene()) {
        return std::nullopt;
    }
    const Triangles& F = result->piece->mesh.F;
    const Points2& Q = result->flat->Q;
    const Eigen::Vector2d label = document.scene()->pieces[static_cast<std::size_t>(piece)].label;
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < F.rows(); ++f) {
        const Eigen::RowVector2d centre = (Q.row(F(f, 0)) + Q.row(F(f, 1)) + Q.row(F(f, 2))) / 3;
        if (const double distance = (centre.transpose() - label).norm(); distance < least) {
            least = distance;
            nearest = f;
        }
    }
    return view.onScreen(piece, nearest, Eigen::Vector3d::Constant(1.0 / 3));
}

/// The point of the outline straight below the middle, in a view.
std::optional<QPointF> lowerEdgeOf(const Document& document, const SceneView& view, int piece) {
    const std::optional<QPointF> middle = middleOf(document, view, piece);
    if (!middle) {
        return std::nullopt;
    }
    const Piece& cloth = *document.result(piece)->piece;
    std::vector<QPointF> outline;
    for (int f = 0; f < cloth.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int vertex = cloth.mesh.F(f, k);
            if (std::find(cloth.boundary.begin(), cloth.boundary.end(), vertex) ==
                cloth.boundary.end()) {
                continue;
            }
            Eigen::Vector3d corner = Eigen::Vector3d::Zero();
            corner[k] = 1;
            if (const auto at = view.onScreen(piece, f, corner); at && at->y() > middle->y()) {
                outline.push_back(*at);
            }
        }
    }
    const auto nearest = std::min_element(
        outline.begin(), outline.end(), [&middle](const QPointF& a, const QPointF& b) {
            return std::abs(a.x() - middle->x()) < std::abs(b.x() - middle->x());
        });
    return nearest == outline.end() ? std::nullopt : std::optional<QPointF>(*nearest);
}

/// What can be read in a widget, cells of lists included.
QStringList textsOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        return {label->text()};
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        return {withoutMnemonic(button->text())};
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
        return {combo->currentText()};
    }
    QStringList texts{widget.accessibleName(), widget.accessibleDescription()};
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget); view && view->model()) {
        const QAbstractItemModel& model = *view->model();
        for (int row = 0; row < model.rowCount(); ++row) {
            for (int column = 0; column < model.columnCount(); ++column) {
                texts << model.index(row, column).data().toString();
            }
        }
    }
    return texts;
}

}  // namespace

std::vector<GuideStep> readGuide(const QString& path) {
    std::vector<GuideStep> steps;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return steps;
    }
    QTextStream lines(&file);
    for (int number = 1; !lines.atEnd(); ++number) {
        const QString line = lines.readLine().trimmed();
        if (const auto picture = match("Picture (.+)", line); picture.hasMatch()) {
            steps.push_back({GuideStep::Kind::Picture, number, picture.captured(1)});
        } else if (!line.isEmpty() && !line.startsWith('#')) {
            steps.push_back({GuideStep::Kind::Do, number, line});
        }
    }
    return steps;
}

QString GuideWalker::follow(const QString& sentence) {
    using Words = QStringList;  // what the pattern's groups have caught, from 1
    struct Phrase {
        const char* pattern;
        std::function<QString(const Words&)> act;
    };
    const Phrase phrases[] = {
        {"Press \\*\\*(.+)\\*\\* and open `(.+)`\\.",
         [this](const Words& words) -> QString {
             answerWith(source_ + '/' + words[2], {});
             return press(words[1]);
         }},
        {"Press \\*\\*(.+)\\*\\* and save as `(.+)`\\.",
         [this](const Words& words) -> QString {
             return saving(words[2], [&] { return press(words[1]); });
         }},
        {"Press \\*\\*([^*]+)\\*\\*\\.",
         [this](const Words& words) -> QString { return press(words[1]); }},
        {"Choose \\*\\*([^*]+)\\*\\* and save as `(.+)`\\.",
         [this](const Words& words) -> QString {
             return saving(words[2], [&] { return choose(words[1]); });
         }},
        {"Choose \\*\\*([^*]+)\\*\\* for \\*\\*([^*]+)\\*\\*\\.",
         [this](const Words& words) -> QString { return chooseFor(words[1], words[2]); }},
        {"Choose \\*\\*([^*]+)\\*\\*\\.",
         [this](const Words& words) -> QString { return choose(words[1]); }},
        {"Click \\*\\*([^*]+)\\*\\* in the (pattern|garment|list|window)\\.",
         [this](const Words& words) -> QString { return click(words[1], words[2]); }},
        {"Drag \\*\\*([^*]+)\\*\\* in the pattern (\\d+) mm to the (right|left)\\.",
         [this](const Words& words) -> QString {
             return dragPiece(words[1], words[2].toDouble() * (words[3] == "right" ? 1 : -1));
         }},
        {"Drag from the lower edge of \\*\\*([^*]+)\\*\\* to its middle in the pattern\\.",
         [this](const Words& words) -> QString { return dragFromEdge(words[1]); }},
        {"You see “(.+)” in the list\\.",
         [this](const Words& words) -> QString { return see(words[1], true); }},
        {"You see “(.+)”\\.",
         [this](const Words& words) -> QString { return see(words[1], false); }},
    };
    for (const Phrase& phrase : phrases) {
        const QRegularExpressionMatch found = match(phrase.pattern, sentence);
        if (found.hasMatch()) {
            const QString wrong = phrase.act(found.capturedTexts());
            settle();
            return wrong;
        }
    }
    return "no such step is known";
}

QString GuideWalker::saving(const QString& name, const std::function<QString()>& act) {
    const QString file = fixture_.path(name);
    answerWith({}, file);
    const QString wrong = act();
    if (auto* dialog = fixture_.window().findChild<ExportDialog*>()) {
        dialog->findChild<QLineEdit*>("exportPath")->setText(file);
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportNow"), Qt::LeftButton);
    }
    settle();
    return wrong.isEmpty() && !QFile::exists(file) ? "nothing is saved" : wrong;
}

QString GuideWalker::press(const QString& keys) {
    const QKeySequence sequence = QKeySequence::fromString(keys);
    if (sequence.isEmpty() || sequence[0].key() == Qt::Key_unknown) {
        return "there is no such key";
    }
    QWidget* at = QApplication::focusWidget() ? QApplication::focusWidget() : &fixture_.window();
    QTest::keyClick(at, sequence[0].key(), sequence[0].keyboardModifiers());
    return {};
}

QString GuideWalker::choose(const QString& path) {
    const QStringList wanted = path.split(" ▸ ");
    for (const PlacedAction& placed : placedActions()) {
        if (placed.menus + QStringList{withoutMnemonic(fixture_.action(placed.id).text())} ==
            wanted) {
            QAction& action = fixture_.action(placed.id);
            if (!action.isEnabled()) {
                return "the menu's item is grey";
            }
            action.trigger();
            return {};
        }
    }
    return "there is no such item in the menus";
}

QString GuideWalker::chooseFor(const QString& choice, const QString& label) {
    for (QComboBox* combo : fixture_.window().findChildren<QComboBox*>()) {
        if (!combo->isVisible() || combo->accessibleName() != label) {
            continue;
        }
        const int index = combo->findText(choice);
        if (index < 0) {
            return "there is no such choice";
        }
        combo->setFocus();
        combo->setCurrentIndex(index);
        emit combo->activated(index);
        return {};
    }
    return "there is no such field";
}

QString GuideWalker::click(const QString& what, const QString& where) {
    if (where == "pattern" || where == "garment") {
        SceneView& view = where == "pattern"
                              ? static_cast<SceneView&>(*fixture_.window().views().patternView())
                              : *fixture_.window().views().garmentView();
        const auto at = middleOf(fixture_.document(), view, pieceNamed(fixture_.document(), what));
        if (!at) {
            return "there is no such piece";
        }
        test::click(view, *at);
        return {};
    }
    if (where == "window") {
        for (QAbstractButton* button : fixture_.window().findChildren<QAbstractButton*>()) {
            if (button->isVisible() && withoutMnemonic(button->text()) == what) {
                QTest::mouseClick(button, Qt::LeftButton);
                return {};
            }
        }
        return "there is no such button";
    }
    for (QAbstractItemView* view : fixture_.window().findChildren<QAbstractItemView*>()) {
        if (!view->isVisible() || !view->model()) {
            continue;
        }
        for (int row = 0; row < view->model()->rowCount(); ++row) {
            for (int column = 0; column < view->model()->columnCount(); ++column) {
                const QModelIndex index = view->model()->index(row, column);
                if (index.data().toString().contains(what)) {
                    view->scrollTo(index);
                    QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                                      view->visualRect(index).center());
                    return {};
                }
            }
        }
    }
    return "it is in no list";
}

QString GuideWalker::dragPiece(const QString& piece, double right) {
    PatternView& view = *fixture_.window().views().patternView();
    const auto from = middleOf(fixture_.document(), view, pieceNamed(fixture_.document(), piece));
    if (!from) {
        return "there is no such piece";
    }
    test::drag(view, *from, *from + QPointF(right * view.pixelsPerMillimetre(), 0));
    return {};
}

QString GuideWalker::dragFromEdge(const QString& piece) {
    PatternView& view = *fixture_.window().views().patternView();
    const int index = pieceNamed(fixture_.document(), piece);
    const auto from = lowerEdgeOf(fixture_.document(), view, index);
    const auto to = middleOf(fixture_.document(), view, index);
    if (!from || !to) {
        return "there is no such piece";
    }
    test::drag(view, *from, *to);
    return {};
}

QString GuideWalker::see(const QString& text, bool inList) {
    const bool seen = QTest::qWaitFor(
        [this, &text, inList] {
            for (const QWidget* widget : fixture_.window().findChildren<QWidget*>()) {
                if (widget->isVisible() &&
                    (!inList || qobject_cast<const QAbstractItemView*>(widget)) &&
                    textsOf(*widget).join('\n').contains(text)) {
                    return true;
                }
            }
            return false;
        },
        kPatience);
    return seen ? QString() : QString("it is nowhere to be read");
}

void GuideWalker::answerWith(const QString& opened, const QString& saved) {
    FileDialogs& dialogs = fixture_.window().garmentActions().fileDialogs();
    dialogs.open = [opened](QWidget*, const QString&) -> QStringList { return {opened}; };
    dialogs.openBody = [opened](QWidget*, const QString&) { return opened; };
    dialogs.save = [saved](QWidget*, const QString&, const QString&) { return saved; };
    dialogs.saveReport = dialogs.save;
    dialogs.saveProject = [saved](QWidget*, const QString&) { return saved; };
}

void GuideWalker::settle() {
    QApplication::processEvents();
    if (!fixture_.document().garment()) {
        (void)fixture_.waitUntilIdle();
    }
    if (fixture_.document().garment()) {
        (void)fixture_.waitForResults();
    }
    (void)fixture_.waitUntilIdle();  // files are written beside everything else
    QApplication::processEvents();
}

}  // namespace toile::test
