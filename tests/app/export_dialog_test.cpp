// SPDX-License-Identifier: GPL-3.0-or-later
// The export dialog, by mouse and keyboard.
#include "app/export/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <algorithm>
#include <future>
#include <set>

#include "app/document/layout.h"
#include "app/export/drawing_preview.h"
#include "app/render/offscreen.h"
#include "app/text/error_text.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class ExportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        test::writeObj(fixture_.path("cap.obj").toStdString(), test::sewnCapParts());
    }

    void init() {
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("cap.obj")));
        fixture_.window().garmentActions().fileDialogs().mayReplace = [this](QWidget*,
                                                                             const QString&) {
            ++asked_;
            return replaces_;
        };
        asked_ = 0;
        QTest::keyClick(&fixture_.window(), Qt::Key_E, Qt::ControlModifier);
        QVERIFY(dialog());
        QVERIFY(QTest::qWaitForWindowExposed(dialog(), test::kPatience));
    }

    void cleanup() { fixture_.close(); }

    void offersEveryFormatOfTheTable() {
        QStringList wanted, offered;
        for (const Format& format : formats()) {
            QVERIFY2(format.write, format.name);
            wanted << format.name;
        }
        for (int row = 0; row < formatList().count(); ++row) {
            offered << formatList().item(row)->text();
        }
        QCOMPARE(offered, wanted);
    }

    void everyChoiceOfAFormatHasAFieldThatCanBeNamed() {
        for (const Format& format : formats()) {
            chooseFormat(format.id);
            for (const FormatOption& option : formatOptions()) {
                auto* field = dialog()->findChild<QWidget*>(option.name);
                QCOMPARE(field != nullptr,
                         std::ranges::find(option.formats, format.id) != option.formats.end());
                QVERIFY(!field || !field->accessibleName().isEmpty());
            }
        }
    }

    void endingAndFormatFollowEachOther() {
        QVERIFY(path().text().endsWith("cap-pattern.svg"));
        chooseFormat(FormatId::Dxf);
        QVERIFY(path().text().endsWith("cap-pattern.dxf"));
        typePath("other.JSON");
        QCOMPARE(formatList().currentItem()->text(), QString(formatOf(FormatId::Report).name));
        QVERIFY(path().text().endsWith("other.JSON"));
        typePath("dress.v2");
        QVERIFY(path().text().endsWith("dress.v2.json"));
    }

    void writesWhatIsChosenAndKeepsItForNextTime() {
        chooseFormat(FormatId::Dxf);
        chooseWord("dxf-profile", "plain");
        chooseWord("dxf-unit", "in");
        typePath("out.dxf");
        QCOMPARE(exportNow(), fixture_.path("out.dxf"));
        QTest::keyClick(&fixture_.window(), Qt::Key_E, Qt::ControlModifier);
        QCOMPARE(formatList().currentItem()->text(), QString(formatOf(FormatId::Dxf).name));
        QCOMPARE(dialog()->choice().options.dxf.unit, LengthUnit::Inch);
        QCOMPARE(dialog()->choice().options.dxf.profile, DxfProfile::Plain);
        QVERIFY(path().text().endsWith("cap-pattern.dxf"));
        dialog()->reject();
    }

    void aPresetChoosesTheRest() {
        chooseFormat(FormatId::Dxf);
        chooseWord("dxf-preset", "laser");
        QCOMPARE(dialog()->choice().options.dxf.profile, DxfProfile::Plain);
        QCOMPARE(combo("dxf-profile").currentIndex(), 2);
        chooseWord("dxf-unit", "in");
        QCOMPARE(combo("dxf-preset").currentIndex(), -1);  // it is none of them any more
    }

    void asksBeforeAFileIsReplaced() {
        QFile(fixture_.path("old.svg")).open(QIODevice::WriteOnly);
        typePath("old.svg");
        replaces_ = false;
        QTest::mouseClick(dialog()->findChild<QPushButton*>("exportNow"), Qt::LeftButton);
        QCOMPARE(asked_, 1);
        QVERIFY(dialog()->isVisible());
        replaces_ = true;
        QCOMPARE(exportNow(), fixture_.path("old.svg"));
        QVERIFY(QFileInfo(fixture_.path("old.svg")).size() > 0);
    }

    void browsingAsksOnce() {
        const QString place = fixture_.path("browsed.svg");
        QFile(place).open(QIODevice::WriteOnly);
        fixture_.window().garmentActions().fileDialogs().save =
            [&](QWidget*, const QString& suggestion, const QString& filter) {
                return suggestion.endsWith(".svg") && filter.contains("*.svg") ? place : QString();
            };
        QTest::mouseClick(dialog()->findChild<QPushButton*>("exportBrowse"), Qt::LeftButton);
        QCOMPARE(exportNow(), place);
        QCOMPARE(asked_, 0);  // the dialog of files has asked
    }

    void cancelWritesNothing() {
        QSignalSpy exported(&fixture_.workspace(), &Workspace::exported);
        typePath("never.svg");
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QVERIFY(fixture_.waitUntilIdle());
        QCOMPARE(exported.count(), 0);
        QVERIFY(!QFile::exists(fixture_.path("never.svg")));
    }

    void showsThePageAndItsFolder() {
        auto& preview = *dialog()->findChild<DrawingPreview*>();
        QTRY_VERIFY_WITH_TIMEOUT(
            dialog()->findChild<QLabel*>("exportPage")->text().contains("2 pieces"),
            test::kPatience);
        const QImage picture = preview.grab().toImage();
        int red = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor dot = picture.pixelColor(x, y);
                red += dot.red() > dot.blue() + 60 ? 1 : 0;
            }
        }
        QVERIFY2(red > 300, qPrintable(QString::number(red)));  // cutting lines
        QString shown;
        fixture_.window().garmentActions().fileDialogs().showFolder = [&](const QString& folder) {
            shown = folder;
        };
        typePath("shown.svg");
        QTest::mouseClick(dialog()->findChild<QCheckBox*>("exportShowFolder"), Qt::LeftButton);
        QCOMPARE(exportNow(), fixture_.path("shown.svg"));
        QCOMPARE(shown, QFileInfo(fixture_.path("shown.svg")).absolutePath());
    }

    /// Of the dashed arrows, which no file has, and of pieces laid on each other.
    void saysWhatTheFileWillLack() {
        auto& notes = *dialog()->findChild<QLabel*>("exportNotes");
        QTRY_VERIFY(notes.isVisible());
        QVERIFY(!notes.text().contains("overlap on the sheet"));
        dialog()->reject();
        Document& document = fixture_.document();
        const Placement under = placementOf(document, 0);
        place(document, "Move", {{1, under}});
        PieceGrains grains;
        for (int piece = 0; piece < document.pieceCount(); ++piece) {
            grains[piece] = kGrainUpwards;
        }
        setGrain(document, "Grain", grains);
        QTest::keyClick(&fixture_.window(), Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(dialog());
        QTRY_VERIFY(dialog()->findChild<QLabel*>("exportNotes")->isVisible());
        const QString said = dialog()->findChild<QLabel*>("exportNotes")->text();
        QVERIFY2(said.contains("overlap on the sheet"), qPrintable(said));
        QVERIFY(!said.contains('\n'));  // the grain is stated now
    }

    void saysHowManyPagesThereAre() {
        auto& page = *dialog()->findChild<QLabel*>("exportPage");
        QTRY_VERIFY_WITH_TIMEOUT(page.text().contains("2 pieces"), test::kPatience);
        chooseFormat(FormatId::Pdf);
        QVERIFY(page.text().contains("pages"));
        chooseWord("paper", "projector");
        QVERIFY2(page.text().contains("1 page"), qPrintable(page.text()));
        typePath("wall.pdf");
        QCOMPARE(exportNow(), fixture_.path("wall.pdf"));
    }

    void aPictureHasItsResolution() {
        chooseFormat(FormatId::Png);
        typePath("page.png");
        QCOMPARE(exportNow(), fixture_.path("page.png"));
        const QImage picture(fixture_.path("page.png"));
        QVERIFY(!picture.isNull());
        QCOMPARE(picture.dotsPerMeterX(), 5906);  // 150 dots per inch
        // The side of the check square, 100 mm, along the lowest line of the page.
        int blue = 0;
        const int row = picture.height() - static_cast<int>(std::lround(10 * 150 / 25.4));
        for (int x = 0; x < picture.width(); ++x) {
            const QColor dot = picture.pixelColor(x, row);
            blue += dot.blue() > dot.red() + 100 ? 1 : 0;
        }
        QVERIFY2(std::abs(blue - 100 * 150 / 25.4) < 4, qPrintable(QString::number(blue)));
    }

    void showsTheBeginningOfWhatIsText() {
        auto& text = *dialog()->findChild<QPlainTextEdit*>("exportText");
        auto& page = *dialog()->findChild<DrawingPreview*>("exportPreview");
        QVERIFY(page.isVisible());
        chooseFormat(FormatId::Csv);
        QVERIFY(!page.isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(text.toPlainText().startsWith("piece,"), test::kPatience);
        chooseFormat(FormatId::Obj);
        QTRY_VERIFY_WITH_TIMEOUT(text.toPlainText().contains("\nv "), test::kPatience);
        QVERIFY(text.isReadOnly());
        chooseFormat(FormatId::Dxf);
        QVERIFY(page.isVisible());
        QVERIFY(!text.isVisible());
    }

    void aReportHasPicturesWhereThereIsOpenGl() {
        chooseFormat(FormatId::Html);
        typePath("report.html");
        QCOMPARE(exportNow(), fixture_.path("report.html"));
        QFile file(fixture_.path("report.html"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray page = file.readAll(), mark = "data:image/png;base64,";
        // On this thread the window's own context may be current.
        auto made = std::async(std::launch::async, [] { return makeEglContext() != nullptr; });
        const bool hasPictures = made.get();
        QCOMPARE(page.count(mark), hasPictures ? 2 : 0);
        for (qsizetype at = page.indexOf(mark); at >= 0; at = page.indexOf(mark, at)) {
            at += mark.size();
            const QByteArray png = page.mid(at, page.indexOf('"', at) - at);
            const QImage picture = QImage::fromData(QByteArray::fromBase64(png));
            QCOMPARE(picture.size(), QSize(1400, 700));
            std::set<QRgb> colours;
            for (int x = 0; x < picture.width(); ++x) {
                colours.insert(picture.pixel(x, picture.height() / 2));
            }
            QVERIFY(colours.size() > 20);
        }
    }

private:
    ExportDialog* dialog() {
        for (auto* found : fixture_.window().findChildren<ExportDialog*>()) {
            if (found->isVisible()) {
                return found;
            }
        }
        return nullptr;
    }
    QListWidget& formatList() { return *dialog()->findChild<QListWidget*>("exportFormats"); }
    QLineEdit& path() { return *dialog()->findChild<QLineEdit*>("exportPath"); }
    QComboBox& combo(const char* name) { return *dialog()->findChild<QComboBox*>(name); }

    void chooseFormat(FormatId id) {
        for (int row = 0; row < formatList().count(); ++row) {
            if (formatList().item(row)->text() == formatOf(id).name) {
                QTest::mouseClick(formatList().viewport(), Qt::LeftButton, {},
                                  formatList().visualItemRect(formatList().item(row)).center());
            }
        }
    }

    void chooseWord(const char* option, std::string_view word) {
        for (const FormatOption& row : formatOptions()) {
            for (std::size_t k = 0; row.name == std::string_view(option) && k < row.words.size();
                 ++k) {
                if (row.words[k] == word) {
                    combo(option).setCurrentIndex(static_cast<int>(k));
                    emit combo(option).activated(static_cast<int>(k));
                }
            }
        }
    }

    void typePath(const QString& name) {
        path().setFocus();
        path().selectAll();
        QTest::keyClicks(&path(), fixture_.path(name));
        emit path().editingFinished();
    }

    /// @return what was written
    QString exportNow() {
        QSignalSpy exported(&fixture_.workspace(), &Workspace::exported);
        QTest::mouseClick(dialog()->findChild<QPushButton*>("exportNow"), Qt::LeftButton);
        (void)QTest::qWaitFor([&] { return exported.count() > 0; }, test::kPatience);
        return exported.isEmpty() ? QString() : exported[0][0].toString();
    }

    test::WindowFixture fixture_;
    int asked_ = 0;
    bool replaces_ = true;
};

TOILE_WINDOW_TEST(ExportDialogTest)
#include "export_dialog_test.moc"
