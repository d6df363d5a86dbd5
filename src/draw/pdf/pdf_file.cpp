#include "draw/pdf/pdf_file.h"

#include <cassert>
#include <cstdint>
#include <utility>

#include "draw/hex.h"

namespace planish {

namespace {

// FNV-1a: tells files apart, protects nothing.
std::uint64_t hash_of(std::string_view bytes, std::uint64_t hash) {
  for (const char c : bytes)
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

// A line of the cross-reference table: always 20 bytes.
std::string table_line(std::size_t offset, bool used) {
  std::string digits = std::to_string(offset);
  digits.insert(0, 10 - digits.size(), '0');
  return digits + (used ? " 00000 n \n" : " 65535 f \n");
}

}  // namespace

std::string pdf_reference(int number) {
  return std::to_string(number) + " 0 R";
}

int PdfFile::reserve() {
  objects_.emplace_back();
  return static_cast<int>(objects_.size());
}

void PdfFile::set(int number, std::string object) {
  objects_[static_cast<std::size_t>(number) - 1] = std::move(object);
}

int PdfFile::add(std::string object) {
  objects_.push_back(std::move(object));
  return static_cast<int>(objects_.size());
}

int PdfFile::add_stream(std::string_view entries, std::string_view data) {
  std::string object = "<< /Length " + std::to_string(data.size());
  if (!entries.empty()) object += ' ';
  object += entries;
  object += " >>\nstream\n";
  object += data;
  object += "\nendstream";
  return add(std::move(object));
}

std::string PdfFile::bytes(int catalog, int info) const {
  std::string pdf = "%PDF-1.6\n%\xE2\xE3\xCF\xD3\n";  // bytes that tell it from text
  std::string table = table_line(0, false);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    assert(!objects_[i].empty());
    table += table_line(pdf.size(), true);
    pdf += std::to_string(i + 1) + " 0 obj\n";
    pdf += objects_[i];
    pdf += "\nendobj\n";
  }
  constexpr std::uint64_t start = 0xCBF29CE484222325U;
  const std::uint64_t first = hash_of(pdf, start);
  std::string id = "<";
  append_hex(id, first, 16);
  append_hex(id, hash_of(pdf, first), 16);
  id += '>';
  const std::string size = std::to_string(objects_.size() + 1);
  const std::string table_place = std::to_string(pdf.size());
  pdf += "xref\n0 " + size + "\n" + table + "trailer\n<< /Size " + size + " /Root " +
         pdf_reference(catalog) + " /Info " + pdf_reference(info) + " /ID [" + id + " " + id +
         "] >>\nstartxref\n" + table_place + "\n%%EOF\n";
  return pdf;
}

}  // namespace planish
