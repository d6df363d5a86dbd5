#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// The numbered objects of a PDF file.
class PdfFile {
 public:
  /// The number of an object that is set later.
  int reserve();
  void set(int number, std::string object);
  int add(std::string object);
  /// @param entries of the stream's dictionary, besides its length
  int add_stream(std::string_view entries, std::string_view data);

  /// The file; its identifier is made from what it holds. All reserved objects are set.
  std::string bytes(int catalog, int info) const;

 private:
  std::vector<std::string> objects_;
};

/// "7 0 R"
std::string pdf_reference(int number);

}  // namespace planish
