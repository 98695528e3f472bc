// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// The objects of a PDF file (ISO 32000-1, version 1.7), numbered from 1: dictionaries as written,
/// and streams compressed by Flate. No dates, and an identifier derived from the content: the same
/// objects give the same bytes.
class PdfFile {
public:
    /// Reserves a number for an object that is set later.
    int reserve();
    /// @param body  without "obj" and "endobj"
    void set(int number, std::string body);
    /// @param entries  of its dictionary, except /Length and /Filter
    void setStream(int number, std::string_view entries, std::string_view bytes);

    int add(std::string body);
    int addStream(std::string_view entries, std::string_view bytes);

    /// The whole file. Precondition: every reserved number is set. Cost: linear.
    std::string finished(int catalog, int info) const;

private:
    std::vector<std::string> bodies_;
};

/// "12 0 R".
std::string pdfReference(int number);
/// A name, a text for people or a key as a string: in parentheses if it is printable ASCII, else as
/// UTF-16. @param text  UTF-8; control characters become blanks
std::string pdfText(std::string_view text);
/// A length of pages in points, from mm.
std::string pdfPoints(double millimetres);
/// With limited decimals, no zeros at the end and never an exponent.
std::string pdfNumber(double value);
void appendPdfNumber(std::string& out, double value, int decimals = 4);

}  // namespace toile
