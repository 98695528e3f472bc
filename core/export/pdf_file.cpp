// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/pdf_file.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

#include <zlib.h>

#include "core/base/characters.h"
#include "core/base/content_hash.h"
#include "core/base/text.h"

namespace toile {
namespace {

constexpr int kLevel = 2;  // of nine: twice as fast as the default, for files a tenth larger
constexpr double kPointsPerMillimetre = 72 / 25.4;
constexpr std::size_t kOffsetDigits = 10;

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<Bytef> packed(size);
    const std::vector<Bytef> plain(bytes.begin(), bytes.end());
    const int done =
        compress2(packed.data(), &size, plain.data(), static_cast<uLong>(plain.size()), kLevel);
    assert(done == Z_OK);  // the buffer is large enough
    static_cast<void>(done);
    return {packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(size)};
}

void appendHex(std::string& out, std::uint64_t value, int digits) {
    for (int k = digits - 1; k >= 0; --k) {
        out += "0123456789ABCDEF"[(value >> (4 * k)) & 15];
    }
}

/// UTF-16 with its byte order mark, in hexadecimal.
std::string utf16Hex(std::string_view text) {
    std::string hex = "<FEFF";
    for (const char32_t c : codePoints(text)) {
        if (c > 0xFFFF) {
            appendHex(hex, 0xD800 + ((c - 0x10000) >> 10), 4);
            appendHex(hex, 0xDC00 + ((c - 0x10000) & 0x3FF), 4);
        } else {
            appendHex(hex, c, 4);
        }
    }
    return hex + ">";
}

}  // namespace

int PdfFile::reserve() {
    bodies_.emplace_back();
    return static_cast<int>(bodies_.size());
}

void PdfFile::set(int number, std::string body) {
    bodies_.at(static_cast<std::size_t>(number) - 1) = std::move(body);
}

void PdfFile::setStream(int number, std::string_view entries, std::string_view bytes) {
    const std::string packed = deflated(bytes);
    std::string body = "<< ";
    body.append(entries).append(" /Filter /FlateDecode /Length ");
    body += std::to_string(packed.size()) + " >>\nstream\n";
    set(number, body + packed + "\nendstream");
}

int PdfFile::add(std::string body) {
    const int number = reserve();
    set(number, std::move(body));
    return number;
}

int PdfFile::addStream(std::string_view entries, std::string_view bytes) {
    const int number = reserve();
    setStream(number, entries, bytes);
    return number;
}

std::string PdfFile::finished(int catalog, int info) const {
    // Four non-text bytes mark the file as binary for transfer programs.
    std::string out = "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n";
    std::vector<std::size_t> offsets;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        assert(!bodies_[k].empty());
        offsets.push_back(out.size());
        out += std::to_string(k + 1) + " 0 obj\n" + bodies_[k] + "\nendobj\n";
    }
    std::string id = "<";
    appendHex(id, contentHash(out), 16);
    appendHex(id, contentHash(id), 16);
    id += ">";
    const std::size_t table = out.size();
    const std::string count = std::to_string(bodies_.size() + 1);
    // Each entry is twenty bytes long, including two for the line end.
    out += "xref\n0 " + count + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets) {
        const std::string digits = std::to_string(offset);
        out.append(kOffsetDigits - std::min(kOffsetDigits, digits.size()), '0').append(digits);
        out += " 00000 n \n";
    }
    out += "trailer\n<< /Size " + count + " /Root " + pdfReference(catalog) + " /Info " +
           pdfReference(info) + " /ID [" + id + " " + id + "] >>\nstartxref\n" +
           std::to_string(table) + "\n%%EOF\n";
    return out;
}

std::string pdfReference(int number) {
    return std::to_string(number) + " 0 R";
}

std::string pdfText(std::string_view text) {
    const std::string clean = cleanText(text);
    if (!std::ranges::all_of(clean, [](char c) -> bool { return c >= ' ' && c <= '~'; })) {
        return utf16Hex(clean);
    }
    std::string literal = "(";
    for (const char c : clean) {
        if (c == '(' || c == ')' || c == '\\') {
            literal += '\\';
        }
        literal += c;
    }
    return literal + ")";
}

std::string pdfPoints(double millimetres) {
    return pdfNumber(millimetres * kPointsPerMillimetre);
}

std::string pdfNumber(double value) {
    std::string text;
    appendPdfNumber(text, value);
    return text;
}

void appendPdfNumber(std::string& out, double value, int decimals) {
    const std::size_t start = out.size();
    appendFixed(out, value, decimals);
    if (out.find('.', start) != std::string::npos) {
        while (out.back() == '0') {
            out.pop_back();
        }
        if (out.back() == '.') {
            out.pop_back();
        }
    }
}

}  // namespace toile
