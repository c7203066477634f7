// Tables of numbers in tests/data, and elsewhere.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

inline std::vector<std::vector<std::string>> read_csv_file(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);  // the names of the columns
  while (std::getline(file, line)) {
    std::vector<std::string> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("no rows in " + path);
  return rows;
}

inline std::vector<std::vector<std::string>> read_csv_text(const std::string& name) {
  return read_csv_file(std::string(ZONAL_TEST_DATA) + "/" + name);
}

inline std::vector<std::vector<double>> read_csv(const std::string& name) {
  std::vector<std::vector<double>> rows;
  for (const auto& text : read_csv_text(name)) {
    std::vector<double> row;
    for (const std::string& cell : text) row.push_back(std::strtod(cell.c_str(), nullptr));
    rows.push_back(row);
  }
  return rows;
}
