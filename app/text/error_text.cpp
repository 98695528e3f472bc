// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/error_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <new>

#include "app/base/text.h"
#include "core/base/characters.h"
#include "core/base/error.h"
#include "core/formats/read_back.h"
#include "core/garment/piece.h"
#include "core/pattern/piece_marks.h"

namespace toile::app {

namespace {

/// Texts of the core are string literals, so they are null-terminated.
QString translated(std::string_view text) {
    return text.empty() ? QString() : tr(text.data());
}

}  // namespace

QString filledIn(const QString& pattern, const std::function<QString(int)>& argument) {
    QString filled;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const bool isPlace =
            pattern[i] == u'%' && i + 1 < pattern.size() && pattern[i + 1].isDigit();
        filled += isPlace ? argument(pattern[++i].digitValue()) : QString(pattern[i]);
    }
    return filled;
}

QString wordingText(const Wording& words) {
    if (words.decimals() >= 0) {
        return QLocale().toString(words.value(), 'f', words.decimals());
    }
    if (!words.pattern()) {
        return QString::fromStdString(shownText(words, kMaxOfDetail));
    }
    return filledIn(translated(words.pattern()), [&words](int number) {
        return wordingText(words.arguments().at(static_cast<std::size_t>(number - 1)));
    });
}

QString errorDescription(const Error& error) {
    QString text = translated(describe(error.code));
    if (!error.detail.empty()) {
        text += " (" + wordingText(error.detail) + ')';
    }
    return text;
}

QString errorAdvice(const Error& error) {
    return translated(advice(error.code));
}

QString errorText(const Error& error) {
    QString text;
    if (!error.subject.name.empty()) {
        text += QString::fromStdString(shownText(error.subject.name, kMaxOfPlace)) + ": ";
    }
    text += errorDescription(error);
    if (const QString advised = errorAdvice(error); !advised.isEmpty()) {
        text += ". " + advised;
    }
    return text + '.';
}

QString troubleText(const Error& trouble, const Piece& piece) {
    switch (trouble.code) {
        case ErrorCode::SeveralLoops:
            return tr("a tube with %1 openings").arg(loopLengths(piece).size());
        case ErrorCode::ClosedSurface:
            return tr("a closed surface");
        default:
            return errorDescription({trouble.code});
    }
}

DrawingWords drawingWords() {
    const auto told = [](const QString& text) { return text.toStdString(); };
    return {
        .noAllowance = told(QCoreApplication::translate("toile", "seam line, no allowance")),
        .mirrored =
            told(QCoreApplication::translate("toile", "mirrored: wrong side of the fabric up")),
        .cut = told(QCoreApplication::translate("toile", "cut %1")),
        .cutPair = told(QCoreApplication::translate("toile", "cut 1 pair")),
        .cutPairs = told(QCoreApplication::translate("toile", "cut %1 pairs")),
        .checkSquare = told(QCoreApplication::translate("toile", "check square 100 mm x 100 mm")),
        .cutOnFold = told(QCoreApplication::translate("toile", "cut %1 on fold")),
        .placeOnFold = told(QCoreApplication::translate("toile", "place on fold")),
        .pieceNumber = told(QCoreApplication::translate("toile", "piece %1 of %2")),
        .size = told(QCoreApplication::translate("toile", "size %1")),
        .allowance = told(QCoreApplication::translate("toile", "seam allowance included")),
        .pages = told(QCoreApplication::translate("toile", "pieces: %1, pages after this one: %2")),
        .page = told(QCoreApplication::translate("toile", "page %1 of %2")),
        .printing = told(QCoreApplication::translate(
            "toile",
            "Print at 100 % (actual size),\nnot fitted to the page.\nMeasure both squares first.")),
        .joining = told(QCoreApplication::translate("toile",
                                                    "Cut along the grey frames where pages\nmeet, "
                                                    "and join them by their marks:\nthe halves "
                                                    "make whole diamonds."))};
}

QString readBackText(const ReadBack& found) {
    if (found.dots[0] > 0) {
        return tr("read back: %1 x %2 dots").arg(found.dots[0]).arg(found.dots[1]);
    }
    const QString pieces =
        found.pieces == 1 ? tr("1 piece") : tr("%n pieces", nullptr, found.pieces);
    return tr("read back: %1, largest difference %2 mm").arg(pieces).arg(found.largest, 0, 'f', 3);
}

QString faultText(const std::exception_ptr& fault) {
    try {
        std::rethrow_exception(fault);
    } catch (const std::bad_alloc&) {
        return errorText({ErrorCode::OutOfMemory});
    } catch (const std::exception& exception) {
        return QCoreApplication::translate(
                   "toile", "Unexpected error (%1). Please report it with the garment file.")
            .arg(QString::fromUtf8(exception.what()));
    }
}

}  // namespace toile::app
