#include "coefficients_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string_view>

#include <nlohmann/json.hpp>
#include <zonal/file/number_text.hpp>

#include "shared/input_error.hpp"

namespace zonal_probe {
namespace {

using example::InputError;
using nlohmann::json;
namespace fs = std::filesystem;

constexpr double greatest = 1e30;  // and sums, squares of what floats hold
constexpr std::size_t most_bytes = 1 << 24;

std::string read_text(const fs::path& path) {
  example::check_is_file(path);
  std::error_code error;
  if (fs::file_size(path, error) > most_bytes) throw InputError(path.string() + ": is too large for coefficients");
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw InputError(path.string() + ": cannot be read");
  return text;
}

/// What is quoted of a file may be anything.
[[noreturn]] void fail(const fs::path& path, std::string what) {
  std::replace_if(
      what.begin(), what.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }, '?');
  throw InputError(path.string() + ": " + what);
}

double checked(const fs::path& path, double number, const std::string& text) {
  if (!std::isfinite(number)) fail(path, "'" + text + "' is no finite number");
  if (std::abs(number) > greatest) fail(path, "'" + text + "' is beyond 1e30");
  return number;
}

// ---- A list ---------------------------------------------------------------------------------------------------------

bool is_between_numbers(char c) { return std::string_view(" \t\r\n,;[](){}\f\v").find(c) != std::string_view::npos; }

/// With a plus in front, or an f behind, as in a program's text.
bool parse_pasted(std::string_view word, double& number) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  if (!word.empty() && (word.back() == 'f' || word.back() == 'F') && word.find_first_of("iInN") == word.npos) {
    word.remove_suffix(1);
  }
  return zonal::parse_number(word, number);
}

std::vector<double> numbers_of(const fs::path& path, std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    if (is_between_numbers(text[at])) {
      ++at;
    } else if (text[at] == '#' || text.substr(at, 2) == "//") {
      at = std::min(text.find('\n', at), text.size());
    } else {
      std::size_t end = at;
      while (end < text.size() && !is_between_numbers(text[end]) && text[end] != '#') ++end;
      const std::string word(text.substr(at, std::min<std::size_t>(end - at, 40)));
      double number = 0;
      if (!parse_pasted(text.substr(at, end - at), number)) fail(path, "'" + word + "' is no number");
      numbers.push_back(checked(path, number, word));
      at = end;
    }
  }
  return numbers;
}

Stored read_list(const fs::path& path, std::string_view text, const ListOf& list) {
  if (list.named == nullptr) fail(path, "whose numbers are these? --from NAME (--list names all)");
  const std::vector<double> numbers = numbers_of(path, text);
  Stored stored;
  std::size_t channels = 0;
  for (int bands = 1; bands <= max_bands; ++bands) {
    const auto count = static_cast<std::size_t>(bands * bands);
    // No square is three times another.
    if (numbers.size() == count || numbers.size() == 3 * count) {
      stored.bands = bands;
      channels = numbers.size() / count;
    }
  }
  if (channels == 0) {
    fail(path, "holds " + std::to_string(numbers.size()) + " numbers, which is neither N*N nor 3*N*N for N from 1 to " +
                   std::to_string(max_bands) + " bands");
  }
  if (list.planes && channels == 1) fail(path, "--planes: there is one channel only");
  stored.named = list.named;
  stored.quantity = quantity_of(*list.named, list.quantity ? &*list.quantity : nullptr);
  stored.frame = list.named->frame;
  const std::size_t count = numbers.size() / channels;
  const std::size_t next = channels == 1 ? 0 : list.planes ? count : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double* first = &numbers[list.planes ? i : channels * i];
    stored.numbers.push_back({first[0], first[next], first[2 * next]});
  }
  return stored;
}

// ---- JSON -----------------------------------------------------------------------------------------------------------

const json& member(const fs::path& path, const json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) fail(path, std::string("has no \"") + name + "\"");
  return *found;
}

std::string text_in(const fs::path& path, const json& object, const char* name) {
  const json& text = member(path, object, name);
  if (!text.is_string()) fail(path, std::string("\"") + name + "\" is no text");
  return text.get<std::string>();
}

double number_in(const fs::path& path, const json& number) {
  if (!number.is_number()) fail(path, "'" + number.dump().substr(0, 40) + "' among the coefficients is no number");
  return checked(path, number.get<double>(), number.dump());
}

Colour colour_in(const fs::path& path, const json& numbers) {
  if (numbers.is_number()) {
    const double grey = number_in(path, numbers);
    return {grey, grey, grey};
  }
  if (!numbers.is_array() || numbers.size() != 3) fail(path, "a coefficient that is neither a number nor three");
  return {number_in(path, numbers[0]), number_in(path, numbers[1]), number_in(path, numbers[2])};
}

zonal::Frame frame_in(const fs::path& path, const json& frame) {
  zonal::Frame parsed{};
  if (!frame.is_object()) fail(path, "\"frame\" is not right, up and ahead");
  const std::string axes =
      text_in(path, frame, "right") + "," + text_in(path, frame, "up") + "," + text_in(path, frame, "ahead");
  if (!parse_frame(axes, parsed)) fail(path, "\"frame\": '" + axes + "' are not three axes such as x,y,-z");
  return parsed;
}

Stored read_object(const fs::path& path, const json& object) {
  Stored stored;
  stored.named = &convention_of(path.string(), text_in(path, object, "convention"));
  stored.quantity = stored.named->convention.quantity;
  if (object.contains("quantity")) {
    const std::string text = text_in(path, object, "quantity");
    bool is_known = false;
    for (const auto& [name, quantity] : quantity_names) {
      if (text != name && text != quantity_text(quantity)) continue;
      stored.quantity = quantity;
      is_known = true;
    }
    if (!is_known) fail(path, "\"quantity\": '" + text + "' is none");
  }
  stored.frame = object.contains("frame") ? frame_in(path, object["frame"]) : stored.named->frame;
  const json& numbers = member(path, object, "coefficients");
  if (!numbers.is_array()) fail(path, "\"coefficients\" is no array");
  for (int bands = 1; bands <= max_bands; ++bands) {
    if (numbers.size() == static_cast<std::size_t>(bands * bands)) stored.bands = bands;
  }
  if (stored.bands == 0) {
    fail(path, "holds " + std::to_string(numbers.size()) + " coefficients, which is not N*N for N from 1 to " +
                   std::to_string(max_bands) + " bands");
  }
  if (object.contains("bands") && object["bands"] != stored.bands) {
    fail(path,
         "says " + object["bands"].dump() + " bands, and holds " + std::to_string(numbers.size()) + " coefficients");
  }
  for (const json& number : numbers) stored.numbers.push_back(colour_in(path, number));
  return stored;
}

}  // namespace

bool is_named_as_coefficients(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".json" || extension == ".txt" || extension == ".csv";
}

Stored read_coefficients(const fs::path& path, const ListOf& list) {
  const std::string text = read_text(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) fail(path, "is empty");
  Stored stored;
  const bool is_object = text[first] == '{' && text.find('"') != std::string::npos;
  if (is_object) {
    json object;
    try {
      object = json::parse(text);
    } catch (const json::exception& error) {
      fail(path, std::string("cannot be read as JSON (") + error.what() + ")");
    }
    stored = read_object(path, object);
    if (list.named != nullptr && list.named != stored.named) {
      fail(path, "says that its numbers are of " + std::string(stored.named->name) + ", not of " +
                     std::string(list.named->name));
    }
  } else {
    stored = read_list(path, text, list);
  }
  if (stored.named->bands != 0 && stored.bands > stored.named->bands) {
    fail(path, std::to_string(stored.bands) + " bands; " + std::string(stored.named->name) + " stores at most " +
                   std::to_string(stored.named->bands));
  }
  return stored;
}

std::string json_string(const std::string& text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string json_text(const Stored& stored, const std::string& more) {
  std::string text = "{\n  \"convention\": " + json_string(std::string(stored.named->name)) +
                     ",\n  \"quantity\": " + json_string(quantity_text(stored.quantity)) +
                     ",\n  \"bands\": " + std::to_string(stored.bands) + ",\n  \"frame\": {\"right\": \"" +
                     axis_text(stored.frame.right) + "\", \"up\": \"" + axis_text(stored.frame.up) +
                     "\", \"ahead\": \"" + axis_text(stored.frame.forward) + "\"},\n" + more + "  \"coefficients\": [";
  for (std::size_t i = 0; i < stored.numbers.size(); ++i) {
    const Colour& c = stored.numbers[i];
    text += (i == 0 ? "\n    " : ",\n    ") + json{c.r, c.g, c.b}.dump();
  }
  return text + "\n  ]\n}\n";
}

}  // namespace zonal_probe
