// SPDX-License-Identifier: GPL-3.0-or-later
// Printing, by mouse and keyboard. The printer is a file.
#include "app/export/print_dialog.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTimer>

#include "app/export/export_dialog.h"
#include "app/export/sheet_preview.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

class PrintDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        test::writeObj(fixture_.path("cap.obj").toStdString(), test::sewnCapParts());
    }

    void init() {
        QFile::remove(fixture_.path("out.pdf"));
        asked_ = 0;
        pages_ = 0;
        fixture_.open();
        QVERIFY(fixture_.openAndWait(fixture_.path("cap.obj")));
        dialogs().hasPrinter = [] { return true; };
        dialogs().choosePrinter = [this](QWidget*, QPrinter& printer, int pages) {
            ++asked_;
            pages_ = pages;
            printer.setOutputFormat(QPrinter::PdfFormat);
            printer.setOutputFileName(fixture_.path("out.pdf"));
            return true;
        };
    }

    void cleanup() { fixture_.close(); }

    void printsTheSheetsThatAreShown() {
        QVERIFY(openDialog());
        choosePaper("letter");
        const int count = dialog()->sheets()->count();
        QVERIFY(count > 1);
        QCOMPARE(page().maximum(), count);
        QSignalSpy done(&fixture_.window().garmentActions(), &GarmentActions::done);
        click("printNow");
        QVERIFY(!dialog());
        QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, test::kPatience);
        QCOMPARE(asked_, 1);
        QCOMPARE(pages_, count);
        QCOMPARE(pagesOfFile(), count);
        QCOMPARE(fixture_.preferences().exportOptions().pdf.paper, Paper::Letter);
    }

    void everySheetCanBeSeen() {
        QVERIFY(openDialog());
        auto& preview = *dialog()->findChild<SheetPreview*>("printPreview");
        const QImage first = preview.grab().toImage();
        page().setFocus();
        QTest::keyClick(&page(), Qt::Key_Up);
        QCOMPARE(page().value(), 2);
        const QImage second = preview.grab().toImage();
        QVERIFY(first != second);
        for (const QImage& seen : {first, second}) {
            int dark = 0;
            for (int y = 0; y < seen.height(); ++y) {
                for (int x = 0; x < seen.width(); ++x) {
                    dark += qGray(seen.pixel(x, y)) < 100 ? 1 : 0;
                }
            }
            QVERIFY(dark > 100);
        }
    }

    void whatIsAskedForFewerPagesShowsTheLastOfThem() {
        QVERIFY(openDialog());
        page().setValue(page().maximum());
        choosePaper("a0");
        QCOMPARE(page().maximum(), dialog()->sheets()->count());
        QCOMPARE(dialog()->sheets()->count(), 1);
        QVERIFY(summary().contains("1 page"));
    }

    void aPageThatIsTooSmallIsSaid() {
        dialogs().choosePrinter = [this](QWidget*, QPrinter& printer, int) {
            printer.setOutputFormat(QPrinter::PdfFormat);
            printer.setOutputFileName(fixture_.path("out.pdf"));
            printer.setPageSize(QPageSize(QPageSize::A5));
            return true;
        };
        QVERIFY(openDialog());
        click("printNow");
        QVERIFY(dialog());
        QVERIFY2(note().contains("148 x 210 mm") && note().contains("210 x 297 mm"),
                 qPrintable(note()));
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(!QFile::exists(fixture_.path("out.pdf")));
        choosePaper("letter");
        QVERIFY(note().isEmpty());
    }

    void thinkingBetterOfItPrintsNothing() {
        dialogs().choosePrinter = [](QWidget*, QPrinter&, int) { return false; };
        QVERIFY(openDialog());
        click("printNow");
        QVERIFY(dialog());
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QVERIFY(!dialog());
        QVERIFY(fixture_.waitUntilIdle());
        QVERIFY(!QFile::exists(fixture_.path("out.pdf")));
    }

    void aPrinterThatTakesNothingIsSaid() {
        dialogs().choosePrinter = [this](QWidget*, QPrinter& printer, int) {
            printer.setOutputFormat(QPrinter::PdfFormat);
            printer.setOutputFileName(fixture_.path("no/such/folder/out.pdf"));
            return true;
        };
        QVERIFY(openDialog());
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("QPainter::begin.*"));
        QSignalSpy failed(&fixture_.window().garmentActions(), &GarmentActions::failed);
        click("printNow");
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
        QVERIFY(failed[0][0].toString().contains("does not accept"));
    }

    void theDesktopsDialogOpensAndCanBeLeft() {
        QTimer leaver;
        QString opened;
        connect(&leaver, &QTimer::timeout, this, [&] {
            if (auto* asked = qobject_cast<QPrintDialog*>(QApplication::activeModalWidget())) {
                opened = QString("%1 to %2").arg(asked->minPage()).arg(asked->maxPage());
                asked->reject();
            }
        });
        leaver.start(20);
        QPrinter printer(QPrinter::HighResolution);
        printer.setOutputFormat(QPrinter::PdfFormat);
        QVERIFY(!FileDialogs::native().choosePrinter(&fixture_.window(), printer, 7));
        QCOMPARE(opened, QString("1 to 7"));
    }

    void withoutAPrinterAFileIsOffered() {
        dialogs().hasPrinter = [] { return false; };
        QVERIFY(openDialog());
        QVERIFY(!button("printNow").isEnabled());
        QVERIFY(note().contains("No printer"));
        choosePaper("tile");
        click("printToFile");
        QVERIFY(!dialog());
        auto* exporting = fixture_.window().findChild<ExportDialog*>();
        QVERIFY(exporting && exporting->isVisible());
        QCOMPARE(exporting->choice().format, QString(".pdf"));
        QCOMPARE(exporting->choice().options.pdf.paper, Paper::Shared);
        exporting->reject();
    }

    void theSelectedPiecesArePrintedAlone() {
        QVERIFY(openDialog());
        QVERIFY(!dialog()->findChild<QComboBox*>("printPieces")->isVisible());
        const int whole = sheetsOfA4();
        QTest::keyClick(dialog(), Qt::Key_Escape);
        fixture_.document().setSelection({0});
        QVERIFY(openDialog());
        auto& pieces = *dialog()->findChild<QComboBox*>("printPieces");
        QCOMPARE(sheetsOfA4(), whole);
        pieces.setFocus();
        QTest::keyClick(&pieces, Qt::Key_Down);
        QCOMPARE(pieces.currentText(), QString("Selected pieces (1)"));
        QVERIFY(!button("printNow").isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(dialog()->sheets(), test::kPatience);
        QVERIFY(sheetsOfA4() < whole);
        click("printToFile");
        auto* file = fixture_.window().findChild<ExportDialog*>();
        QVERIFY(file && file->choice().onlySelected);
        file->reject();
    }

    void aProjectorIsNoPaper() {
        ExportOptions options;
        options.pdf.paper = Paper::Projector;
        fixture_.preferences().setExportOptions(options);
        QVERIFY(openDialog());
        QCOMPARE(dialog()->options().pdf.paper, Paper::A4);
        choosePaper("projector");
        QVERIFY(!button("printNow").isEnabled());
        QVERIFY2(summary().contains("projector"), qPrintable(summary()));
        choosePaper("a4");
        QVERIFY(button("printNow").isEnabled());
    }

private:
    FileDialogs& dialogs() { return fixture_.window().garmentActions().fileDialogs(); }

    /// True once its sheets are there.
    bool openDialog() {
        QTest::keyClick(&fixture_.window(), Qt::Key_P, Qt::ControlModifier);
        return dialog() && QTest::qWaitForWindowExposed(dialog(), test::kPatience) &&
               QTest::qWaitFor([this] { return dialog()->sheets() != nullptr; }, test::kPatience);
    }

    PrintDialog* dialog() {
        for (auto* found : fixture_.window().findChildren<PrintDialog*>()) {
            if (found->isVisible()) {
                return found;
            }
        }
        return nullptr;
    }
    QSpinBox& page() { return *dialog()->findChild<QSpinBox*>("printPage"); }
    QPushButton& button(const char* name) { return *dialog()->findChild<QPushButton*>(name); }
    QString note() { return dialog()->findChild<QLabel*>("printNote")->text(); }
    QString summary() { return dialog()->findChild<QLabel*>("printSummary")->text(); }
    void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }

    void choosePaper(std::string_view word) {
        auto& combo = *dialog()->findChild<QComboBox*>("paper");
        for (const FormatOption& row : formatOptions()) {
            for (std::size_t k = 0; row.name == std::string_view("paper") && k < row.words.size();
                 ++k) {
                if (row.words[k] == word) {
                    combo.setCurrentIndex(static_cast<int>(k));
                    emit combo.activated(static_cast<int>(k));
                }
            }
        }
    }

    int sheetsOfA4() {
        choosePaper("a4");
        return dialog()->sheets()->count();
    }

    int pagesOfFile() {
        QFile file(fixture_.path("out.pdf"));
        return file.open(QIODevice::ReadOnly) ? static_cast<int>(file.readAll().count("/MediaBox"))
                                              : 0;
    }

    test::WindowFixture fixture_;
    int asked_ = 0, pages_ = 0;
};

TOILE_WINDOW_TEST(PrintDialogTest)
#include "print_dialog_test.moc"
