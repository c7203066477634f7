#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "conventions.hpp"

namespace zonal_probe {

/// What says whose numbers a plain list is of.
struct ListOf {
  const zonal::NamedConvention* named = nullptr;  // none: --from was not given
  std::optional<zonal::Quantity> quantity;
  bool planes = false;  // all of red, all of green, all of blue
};

/// Is the file of coefficients, by its name: .json, .txt, .csv? Else it is a picture.
bool is_named_as_coefficients(const std::filesystem::path& path);

/// What json_text() writes; or the numbers alone, N*N of them, or three times as many, with blanks, line ends, commas
/// or brackets between them, and comments from # or // to the end of a line. Throws InputError.
Stored read_coefficients(const std::filesystem::path& path, const ListOf& list);

/// `more`: members that are not read, each a line and a comma, from {.
std::string json_text(const Stored& stored, const std::string& more);
/// Text as a JSON string, in quotes.
std::string json_string(const std::string& text);

}  // namespace zonal_probe
