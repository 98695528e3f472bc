// SPDX-License-Identifier: GPL-3.0-or-later
// What a printer gets, measured.
#include "app/export/printed_pattern.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPrinter>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "app/export/paint_drawing.h"
#include "core/formats/pdf/pdf_writer.h"
#include "core/formats/pdf/sheets.h"
#include "core/toile/pipeline.h"
#include "tests/app/support/run_test.h"
#include "tests/core/support/laid_rows.h"

using namespace toile;
using namespace toile::app;

namespace {

bool isDark(const QImage& picture, int x, int y) {
    return picture.rect().contains(x, y) && qGray(picture.pixel(x, y)) < 200;
}

/// Whether a picture is dark near a place, of which the rounding of two programs may differ.
bool isDarkNear(const QImage& picture, int x, int y) {
    constexpr int kNear = 2;
    for (int dy = -kNear; dy <= kNear; ++dy) {
        for (int dx = -kNear; dx <= kNear; ++dx) {
            if (isDark(picture, x + dx, y + dy)) {
                return true;
            }
        }
    }
    return false;
}

/// How many dark dots of one picture the other has nothing near.
int missing(const QImage& picture, const QImage& other) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const bool isSure = picture.rect().contains(x, y) && qGray(picture.pixel(x, y)) < 100;
            count += isSure && !isDarkNear(other, x, y) ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

class PrintedPatternTest : public QObject {
    Q_OBJECT

private slots:
    /// With allowances, notches and fair lines.
    void initTestCase() { shirt_ = drawn(withPattern({})); }

    void thereAreAsManySheetsAsPagesOfAFile() {
        for (const Paper paper : {Paper::A4, Paper::Letter, Paper::A0}) {
            const auto plan = planPdf(shirt_->pattern->drawing, {paper, 10});
            QVERIFY(plan);
            const PrintedPattern printed = on(paper);
            QCOMPARE(printed.count(), static_cast<int>(plan->pages.size() + plan->isTiled));
            for (int sheet = 0; sheet < printed.count(); ++sheet) {
                const Eigen::Vector2d size = sheetPaper(*plan, static_cast<std::size_t>(sheet));
                QCOMPARE(printed.paper(sheet), QSizeF(size.x(), size.y()));
            }
        }
    }

    void theSquareIs50MillimetresToADot() {
        const int dpi = 600;
        const QImage cover = picture(on(Paper::A4), 0, dpi);
        // Of all rows, the upper and the lower edge of the square have this run, and nothing else.
        const double wanted = (kMetricSquare + 0.2) * dpi / kMillimetresPerInch;  // and its line
        QList<int> rows;
        for (int y = 0; y < cover.height(); ++y) {
            int run = 0;
            for (int x = 0; x <= cover.width(); ++x) {
                if (isDark(cover, x, y)) {
                    ++run;
                    continue;
                }
                if (run > 0 && std::abs(run - wanted) <= 1) {
                    rows << y;
                }
                run = 0;
            }
        }
        QVERIFY(rows.size() >= 2);
        const int high = rows.back() - rows.front() + 1;
        QVERIFY2(std::abs(high - wanted) <= 1, qPrintable(QString::number(high)));
    }

    /// A line of the drawing lies on its sheet where the plan has it.
    void linesAreWhereThePlanHasThem() {
        const int dpi = 150;
        const auto plan = planPdf(shirt_->pattern->drawing, {Paper::A4, 10});
        const PrintedPattern printed = on(Paper::A4);
        int probed = 0;
        for (std::size_t k = 0; k < plan->pages.size(); ++k) {
            const PdfPage& page = plan->pages[k];
            const QImage sheet = picture(printed, static_cast<int>(k) + 1, dpi);
            for (const DrawnPath& path : shirt_->pattern->drawing.paths) {
                for (Eigen::Index i = 0; path.layer == LayerKind::Cut && i < path.points.rows();
                     ++i) {
                    const Eigen::Vector2d at = onSheet(*plan, path.points.row(i));
                    if (!page.window.contains(at)) {
                        continue;
                    }
                    const Eigen::Vector2d place = at - page.window.min() + plan->origin;
                    const double scale = dpi / kMillimetresPerInch;
                    ++probed;
                    QVERIFY(isDarkNear(sheet, static_cast<int>(place.x() * scale),
                                       static_cast<int>((plan->paper.y() - place.y()) * scale)));
                }
            }
        }
        QVERIFY(probed > 500);
    }

    void sheetsLookLikePagesOfTheFile() {
        if (QStandardPaths::findExecutable("pdftoppm").isEmpty()) {
            QSKIP("needs the program pdftoppm");
        }
        // Programs differ in where dashes end up: seam lines that are cut along have none.
        LineSettings lines = withPattern({});
        lines.allowance.reset();
        const auto shirt = drawn(lines);
        for (const Paper paper : {Paper::A4, Paper::ArchE}) {
            const int dpi = paper == Paper::A4 ? 100 : 60;
            QTemporaryDir folder;
            const auto bytes =
                writePdf(shirt->pattern->drawing, shirt->pattern->pattern, {paper, 10});
            QFile file(folder.filePath("shirt.pdf"));
            QVERIFY(bytes && file.open(QIODevice::WriteOnly));
            file.write(QByteArray::fromStdString(*bytes));
            file.close();
            QCOMPARE(QProcess::execute("pdftoppm", {"-r", QString::number(dpi), "-gray",
                                                    file.fileName(), folder.filePath("page")}),
                     0);
            const PrintedPattern printed = *PrintedPattern::on(shirt, {paper, 10});
            const QStringList pages =
                QDir(folder.path()).entryList({"page*"}, QDir::Files, QDir::Name);
            QCOMPARE(pages.size(), printed.count());
            for (int sheet = 0; sheet < printed.count(); ++sheet) {
                const QImage page(folder.filePath(pages[sheet]));
                const QImage painted = picture(printed, sheet, dpi);
                QVERIFY(!page.isNull());
                QCOMPARE(missing(page, painted), 0);
                QCOMPARE(missing(painted, page), 0);
            }
        }
    }

    void everyPageIsPrintedOnItsPaper() {
        for (const Paper paper : {Paper::A4, Paper::Letter, Paper::A0}) {
            const PrintedPattern printed = on(paper);
            QTemporaryDir folder;
            QPrinter printer(QPrinter::HighResolution);
            printer.setOutputFormat(QPrinter::PdfFormat);
            printer.setOutputFileName(folder.filePath("out.pdf"));
            choosePaper(printer, printed.paper(printed.count() - 1));
            QVERIFY(!roomLacking(printer, printed));
            Progress progress;
            const auto taken = print(printer, printed, progress);
            QVERIFY(taken && *taken);
            const QList<QSizeF> pages = pagesOf(folder.filePath("out.pdf"));
            QCOMPARE(pages.size(), printed.count());
            for (const QSizeF& page : pages) {
                QVERIFY(std::abs(page.width() - printed.paper(printed.count() - 1).width()) < 0.5);
                QVERIFY(std::abs(page.height() - printed.paper(printed.count() - 1).height()) <
                        0.5);
            }
        }
    }

    void aRangeOfPagesIsPrinted() {
        QTemporaryDir folder;
        QPrinter printer(QPrinter::HighResolution);
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(folder.filePath("out.pdf"));
        printer.setPrintRange(QPrinter::PageRange);
        printer.setFromTo(2, 4);
        Progress progress;
        const auto taken = print(printer, on(Paper::A4), progress);
        QVERIFY(taken && *taken);
        QCOMPARE(pagesOf(folder.filePath("out.pdf")).size(), 3);
    }

    void aPageThatIsTooSmallIsFound() {
        QTemporaryDir folder;
        QPrinter printer(QPrinter::HighResolution);
        printer.setOutputFormat(QPrinter::PdfFormat);
        choosePaper(printer, QSizeF(210, 297));
        QVERIFY(!roomLacking(printer, on(Paper::A4)));
        QVERIFY(!roomLacking(printer, on(Paper::Shared)));
        const auto large = roomLacking(printer, on(Paper::A0));
        QVERIFY(large && !large->isMargin);
        QVERIFY(roomLacking(printer, on(Paper::Letter)));  // is wider
        choosePaper(printer, QSizeF(215.9, 279.4));
        QVERIFY(!roomLacking(printer, on(Paper::Letter)));
        QVERIFY(!roomLacking(printer, on(Paper::Shared)));
        QVERIFY(roomLacking(printer, on(Paper::A4)));  // is longer
    }

    void cancelledLeavesNothing() {
        QTemporaryDir folder;
        QPrinter printer(QPrinter::HighResolution);
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(folder.filePath("out.pdf"));
        Progress progress;
        progress.cancel();
        const auto taken = print(printer, on(Paper::A4), progress);
        QVERIFY(!taken);
        QCOMPARE(taken.error().code, ErrorCode::Cancelled);
        QVERIFY(!QFile::exists(folder.filePath("out.pdf")));
    }

    void whatCannotBeWrittenIsNotTaken() {
        QTemporaryDir folder;
        QPrinter printer(QPrinter::HighResolution);
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(folder.filePath("no/such/folder/out.pdf"));
        Progress progress;
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(".*"));
        const auto taken = print(printer, on(Paper::A4), progress);
        QVERIFY(taken && !*taken);
    }

private:
    static std::shared_ptr<const InkedPattern> drawn(const LineSettings& lines) {
        Progress progress;
        const auto garment =
            loadGarment({TOILE_SOURCE_DIR "/resources/samples/tshirt.obj"}, {}, progress);
        const PieceResults results = flattenGarment(*garment, {}, progress, 0, lines);
        const LaidOutPattern laid = inRows(*garment, results, lines);
        return inked(std::make_shared<const DrawnPattern>(
            DrawnPattern{laid.pattern, draw(laid.pattern, laid.marker)}));
    }

    PrintedPattern on(Paper paper) const { return *PrintedPattern::on(shirt_, {paper, 10}); }

    static QImage picture(const PrintedPattern& printed, int sheet, int dpi) {
        const double scale = dpi / kMillimetresPerInch;
        const QSizeF size = scale * printed.paper(sheet);
        QImage picture(qCeil(size.width()), qCeil(size.height()), QImage::Format_Grayscale8);
        picture.fill(Qt::white);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(scale, scale);
        printed.paint(painter, sheet);
        return picture;
    }

    /// Of the pages of a file, mm.
    static QList<QSizeF> pagesOf(const QString& path) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) {
            return {};
        }
        const QString text = QString::fromLatin1(file.readAll());
        static const QRegularExpression box(R"(/MediaBox \[0 0 ([0-9.]+) ([0-9.]+)\])");
        QList<QSizeF> pages;
        for (auto found = box.globalMatch(text); found.hasNext();) {
            const auto match = found.next();
            pages << QSizeF(match.captured(1).toDouble(), match.captured(2).toDouble()) *
                         (kMillimetresPerInch / 72);
        }
        return pages;
    }

    std::shared_ptr<const InkedPattern> shirt_;
};

TOILE_WINDOW_TEST(PrintedPatternTest)
#include "printed_pattern_test.moc"
