#include "text_table.hpp"

#include <algorithm>

namespace example {
namespace {

std::size_t width_of(const std::vector<Row>& rows, std::size_t column) {
  std::size_t width = 0;
  for (const Row& row : rows) width = std::max(width, row[column].size());
  return width;
}

}  // namespace

std::string align(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    text += row[0] + std::string(width_of(rows, 0) - row[0].size(), ' ');
    for (std::size_t column = 1; column < row.size(); ++column) {
      text += std::string(3 + width_of(rows, column) - row[column].size(), ' ') + row[column];
    }
    text += '\n';
  }
  return text;
}

}  // namespace example
