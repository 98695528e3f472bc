// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/error_text.h"

#include <QCoreApplication>
#include <new>

#include "core/base/characters.h"
#include "core/base/error.h"

namespace toile {

namespace {

/// Texts of the core are string literals, so they end with a zero.
QString translated(std::string_view text) {
    return text.empty() ? QString() : QCoreApplication::translate("toile", text.data());
}

}  // namespace

QString errorText(const Error& error) {
    QString text;
    if (!error.where.empty()) {
        text += QString::fromStdString(shownText(error.where, kMostOfPlace)) + ": ";
    }
    text += translated(describe(error.code));
    if (!error.detail.empty()) {
        text += " (" + QString::fromStdString(shownText(error.detail, kMostOfDetail)) + ')';
    }
    if (QString advised = translated(advice(error.code)); !advised.isEmpty()) {
        advised[0] = advised[0].toLower();
        text += "; " + advised;
    }
    return text + '.';
}

QString faultText(const std::exception_ptr& fault) {
    try {
        std::rethrow_exception(fault);
    } catch (const std::bad_alloc&) {
        return errorText({ErrorCode::OutOfMemory, {}, {}});
    } catch (const std::exception& exception) {
        return QCoreApplication::translate("toile",
                                           "The program met an unexpected fault (%1). Please "
                                           "report it with the garment file.")
            .arg(QString::fromUtf8(exception.what()));
    }
}

}  // namespace toile
