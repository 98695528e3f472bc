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

/// The core's words in the person's language, figures too.
QString wordingText(const Wording& words);

/// What stands for %0 to %9 is put in all at once: an argument may hold a percent sign.
QString filledIn(const QString& pattern, const std::function<QString(int)>& argument);

/// `sentence` of core/base/error.h in the person's language: what happened, where, what to try.
QString errorText(const Error& error);
/// What happened alone, with the particulars, and what to try alone; the latter may be empty.
QString errorDescription(const Error& error);
QString errorAdvice(const Error& error);

/// What the matter is with a piece, in few words: "a tube with 3 openings".
QString troubleText(const Error& trouble, const Piece& piece);

/// What exported drawings say, in the person's language.
DrawingWords drawingWords();

/// `readBackSentence` in the person's language.
QString readBackText(const ReadBack& found);

/// What a piece of work that ended with an exception says: that memory ran out and what to try, or
/// that the program met a fault. Not null.
QString faultText(const std::exception_ptr& fault);

}  // namespace toile::app
