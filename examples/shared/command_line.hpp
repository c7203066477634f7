#pragma once

// The building blocks of the programs' command lines, on CLI11. The ranges stand in --help as the names of types, so
// the validators themselves say nothing there.

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/glm.hpp>
#include <zonal/file/number_text.hpp>

#include "common_options.hpp"
#include "names.hpp"

namespace example {

/// The whole text as one number.
template <class Number>
bool parse_number(const std::string& text, Number& number) {
  return zonal::parse_number(text, number);
}

/// As many numbers as asked for, and nothing else, with a separator between them.
template <class Number, std::size_t Count>
bool parse_numbers(const std::string& text, char separator, std::array<Number, Count>& numbers) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    const std::size_t end = i + 1 < Count ? text.find(separator, start) : text.size();
    if (end == std::string::npos || !parse_number(text.substr(start, end - start), numbers[i])) return false;
    start = end + 1;
  }
  return true;
}

/// A check that says nothing in --help.
CLI::Validator validator(const std::function<std::string(const std::string&)>& check);

/// A number within bounds; `text` is how they read.
template <class Number>
CLI::Validator between(Number least, Number greatest, const std::string& text) {
  return validator([=](const std::string& given) -> std::string {
    Number number{};
    if (parse_number(given, number) && number >= least && number <= greatest) return {};
    return "'" + given + "' is not in " + text;
  });
}

template <class Number>
std::string shown(const Number& number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

/// An option of one number within bounds, to assign(number); `range` is how they read. CLI11's own conversion would
/// take 010 for eight.
template <class Number, class Assign>
CLI::Option* add_number_function(CLI::App& app, const std::string& name, const Assign& assign, Number least,
                                 Number greatest, const std::string& range, const std::string& help) {
  const auto parse_and_assign = [assign](const std::string& text) {
    Number number{};
    parse_number(text, number);
    assign(number);
  };
  return app.add_option_function<std::string>(name, parse_and_assign, help)
      ->type_name(range)
      ->check(between(least, greatest, range));
}

CLI::Validator not_empty();
CLI::Validator image_name();  // .png or .exr
CLI::Validator one_of(const std::vector<int>& allowed);

/// 1|3|5
std::string joined(const std::vector<int>& numbers);

/// An option whose words stand for the values of an enumeration.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, const Names<Value>& names, Value& chosen,
                        const std::string& help) {
  std::string text;
  for (const auto& [word, value] : names) text += (text.empty() ? "" : "|") + word;
  const auto assign = [&names, &chosen, name, text](const std::string& given) {
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == given; });
    if (found == names.end()) throw CLI::ValidationError(name, "'" + given + "' is not one of " + text);
    chosen = found->second;
  };
  return app.add_option_function<std::string>(name, assign, help)->type_name(text)->default_str(name_of(names, chosen));
}

/// A number with a default, within bounds; `range` is how they read.
template <class Number>
CLI::Option* add_number(CLI::App& app, const std::string& name, Number& number, Number least, Number greatest,
                        const std::string& range, const std::string& help) {
  return add_number_function(
             app, name, [&number](Number given) { number = given; }, least, greatest, range, help)
      ->default_str(shown(number));
}

/// A point x,y,z in metres.
CLI::Option* add_point(CLI::App& app, const std::string& name, std::optional<glm::vec3>& point,
                       const std::string& help);

/// --box, of which `help` goes on to say what is in it: "Low and high corner "
CLI::Option* add_box_option(CLI::App& app, std::optional<Bounds>& box, const std::string& help);

/// --grid: 8, or 8x8x4, each number 2 to `most`.
CLI::Option* add_resolution_option(CLI::App& app, glm::ivec3& resolution, int most, const std::string& help);

/// An angle given in degrees and kept, times `scale`, in radians.
CLI::Option* add_angle(CLI::App& app, const std::string& name, float greatest_degrees, float scale,
                       std::optional<float>& radians, const std::string& help);

/// One of some numbers, with a default.
CLI::Option* add_one_of(CLI::App& app, const std::string& name, int& number, const std::vector<int>& allowed,
                        const std::string& help);

/// --compare; `help` says what it writes.
CLI::Option* add_compare_option(CLI::App& app, CommonOptions& options, const std::string& help);
/// --out
CLI::Option* add_out_option(CLI::App& app, CommonOptions& options);
/// --threads and --quiet
void add_thread_options(CLI::App& app, CommonOptions& options);
/// The same, and --report
void add_run_options(CLI::App& app, CommonOptions& options);
/// --scene, --no-stage, --up and --view
void add_scene_choice(CLI::App& app, CommonOptions& options);
/// The same, and the camera
void add_scene_options(CLI::App& app, CommonOptions& options);
/// --size, --antialias, --exposure and --tone
void add_image_options(CLI::App& app, CommonOptions& options);

inline const std::string run_group = "Run and output";
inline const std::string scene_group = "Scene";

/// Before the options are added: --help's form, --version, and that the last of two equal options counts, so that what
/// is added to a script's options does.
void set_up(CLI::App& app);

/// The exit status where --help or --version has said all. Throws InputError with one line about what is wrong.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

}  // namespace example
