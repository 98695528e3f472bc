// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <exception>
#include <functional>

namespace toile {
struct DrawingWords;
struct Error;
struct Piece;
struct ReadBack;
class Wording;
}  // namespace toile

namespace toile::app {

/// Translates the core's text, including its figures.
QString wordingText(const Wording& words);

/// Replaces %0 to %9 in one pass, because an argument may contain a percent sign.
QString filledIn(const QString& pattern, const std::function<QString(int)>& argument);

/// Translation of `sentence` of core/base/error.h: what happened, where, and what to try.
QString errorText(const Error& error);
/// Only what happened, with details, and only what to try; the latter may be empty.
QString errorDescription(const Error& error);
QString errorAdvice(const Error& error);

/// A short description of a piece's problem: "a tube with 3 openings".
QString troubleText(const Error& trouble, const Piece& piece);

/// Translated texts of exported drawings.
DrawingWords drawingWords();

/// Translation of `readBackSentence`.
QString readBackText(const ReadBack& found);

/// Message for work that ended with an exception: out of memory and what to try, or a program
/// fault. Precondition: not null.
QString faultText(const std::exception_ptr& fault);

}  // namespace toile::app
