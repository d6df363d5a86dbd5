#pragma once

#include <string>
#include <vector>

namespace planish {

/// A page with a table of many patches. All is plain text.
struct TablePage {
  std::string name;                ///< what the patches are of
  std::string verdict;             ///< its first sentence is large
  std::vector<std::string> facts;  ///< a paragraph each
  std::vector<std::string> heads;  ///< of the columns
  std::vector<std::vector<std::string>> rows;
};
std::string html_table_page(const TablePage& page);

}  // namespace planish
