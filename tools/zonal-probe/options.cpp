#include "options.hpp"

#include <algorithm>
#include <cctype>

#include "conventions.hpp"
#include "mapping_words.hpp"
#include "shared/command_line.hpp"
#include "shared/input_error.hpp"

namespace zonal_probe {
namespace {

using namespace example;

const Names<Format> format_names{{"text", Format::text},
                                 {"json", Format::json},
                                 {"cpp", Format::cpp},
                                 {"glsl", Format::glsl},
                                 {"hlsl", Format::hlsl}};
const Names<WindowKind> window_kinds{{"none", WindowKind::none},
                                     {"hann", WindowKind::hann},
                                     {"sinc", WindowKind::sinc},
                                     {"laplacian", WindowKind::laplacian},
                                     {"auto", WindowKind::automatic}};
const Names<WindowBy> window_by_names{
    {"all", WindowBy::all}, {"channel", WindowBy::channel}, {"luminance", WindowBy::luminance}};
const Names<TurnAxis> axis_names{{"up", TurnAxis::up}, {"right", TurnAxis::right}, {"ahead", TurnAxis::ahead}};

template <class Value>
bool find_value(const Names<Value>& names, const std::string& word, Value& value) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == word; });
  if (found == names.end()) return false;
  value = found->second;
  return true;
}

bool parse_turns(const std::string& text, std::vector<Turn>& turns) {
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string part = text.substr(start, end - start);
    const std::size_t colon = part.find(':');
    Turn turn{};
    if (colon == std::string::npos || !find_value(axis_names, part.substr(0, colon), turn.axis) ||
        !parse_number(part.substr(colon + 1), turn.degrees) || !(std::abs(turn.degrees) <= 3600)) {
      return false;
    }
    turns.push_back(turn);
    start = end + 1;
  }
  return true;
}

bool parse_window(const std::string& text, WindowChoice& window) {
  const std::size_t colon = text.find(':');
  if (!find_value(window_kinds, text.substr(0, colon), window.kind)) return false;
  if (colon == std::string::npos) return true;
  double width = 0;
  const bool has_width = window.kind != WindowKind::none && window.kind != WindowKind::automatic;
  if (!has_width || !parse_number(text.substr(colon + 1), width) || !(width > 0 && width <= 1000)) return false;
  window.width = width;
  return true;
}

bool is_identifier(const std::string& text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto is_part = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), is_part);
}

/// An option of a text that has a form of its own.
template <class Accept>
CLI::Option* add_form(CLI::App& app, const std::string& name, const std::string& type, const std::string& form,
                      const std::string& help, const Accept& accept) {
  const auto assign = [name, form, accept](const std::string& text) {
    if (!accept(text)) throw CLI::ValidationError(name, "'" + text + "' is not " + form);
  };
  return app.add_option_function<std::string>(name, assign, help)->type_name(type);
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void add_input_options(CLI::App& app, Options& options) {
  const std::string group = "Input";
  const std::string mappings = listed(mapping_words());
  add_form(app, "--mapping", "NAME", "one of " + mappings,
           "How the picture holds all directions: " + mappings + "; auto goes by its shape",
           [&options](const std::string& text) {
             options.mapping = text;
             const std::vector<std::string> words = mapping_words();
             return std::find(words.begin(), words.end(), text) != words.end();
           })
      ->default_str(options.mapping)
      ->group(group);
  app.add_option("--from", options.from, "Whose coefficients a plain list of numbers holds (--list)")
      ->type_name("CONVENTION")
      ->group(group);
  app.add_flag("--planes", options.planes, "That list holds all of red, then all of green, then all of blue")
      ->group(group);
  add_form(app, "--input-frame", "FRAME", "one of " + frame_names() + ", nor axes such as x,y,-z",
           "Which way the input's axes go, where it is neither the convention's own frame nor that of pictures: " +
               frame_names() + ", or axes to the right, up and ahead, such as x,y,-z",
           [&options](const std::string& text) {
             zonal::Frame frame{};
             options.input_frame = text;
             return parse_frame(text, frame);
           })
      ->group(group);
}

void add_light_options(CLI::App& app, Options& options) {
  const std::string group = "Light";
  const std::string range = "1..." + std::to_string(max_bands);
  add_form(app, "--bands", range, "in " + range, "How many; of coefficients, no more than they have [3]",
           [&options](const std::string& text) {
             int bands = 0;
             if (!parse_number(text, bands) || bands < 1 || bands > max_bands) return false;
             options.bands = bands;
             return true;
           })
      ->group(group);
  add_form(app, "--rotate", "AXIS:DEGREES[,...]", "turns such as up:90,right:-20",
           "Turn the light, one turn after the other: up takes what was ahead to the left, right takes it upwards, "
           "ahead takes what was above to the right",
           [&options](const std::string& text) {
             options.turns.clear();
             return parse_turns(text, options.turns);
           })
      ->group(group);
  add_form(app, "--window", "NAME[:W]",
           "one of none, hann, sinc, laplacian, auto, with a width from 0 to 1000 as in hann:4",
           "Against ringing: none, hann, sinc, laplacian, each of width W, the number of bands where it is not given "
           "(hann and sinc are 0 from degree W on); or auto, the weakest laplacian that leaves nothing negative, of "
           "radiance, or of irradiance where that is written",
           [&options](const std::string& text) { return parse_window(text, options.window); })
      ->default_str("none")
      ->group(group);
  add_choice(app, "--window-by", window_by_names, options.window.by,
             "One for all channels, one for each, or one by the luminance alone; of auto")
      ->group(group);
}

void add_output_options(CLI::App& app, Options& options) {
  const std::string group = "Output";
  app.add_option("--convention", options.convention, "Whose coefficients to write (--list)")
      ->type_name("CONVENTION")
      ->capture_default_str()
      ->group(group);
  const auto set_quantity = [&options](const std::string& text) {
    zonal::Quantity quantity{};
    const bool is_known = find_value(quantity_names, text, quantity);
    if (is_known) options.quantity = quantity;
    return is_known;
  };
  add_form(app, "--quantity", "QUANTITY", "one of radiance|irradiance|irradiance-over-pi",
           "Of what they are the coefficients: radiance|irradiance|irradiance-over-pi; otherwise the convention's own",
           set_quantity)
      ->group(group);
  add_form(app, "--frame", "FRAME", "one of " + frame_names() + ", nor axes such as x,y,-z",
           "Which way x, y and z go; otherwise the convention's own: " + frame_names(),
           [&options](const std::string& text) {
             zonal::Frame frame{};
             options.frame = text;
             return parse_frame(text, frame);
           })
      ->group(group);
  add_choice(app, "--format", format_names, options.format, "A table, or a program's text; json can be read again")
      ->group(group);
  add_form(app, "--name", "NAME", "a name such as probe", "What cpp, glsl and hlsl call it",
           [&options](const std::string& text) {
             options.name = text;
             return is_identifier(text);
           })
      ->default_str(options.name)
      ->group(group);
  app.add_option("--out", options.out, "A file; otherwise standard output")
      ->type_name("FILE")
      ->check(not_empty())
      ->group(group);
  app.add_option("--preview", options.preview,
                 "Picture, reconstruction, difference, and a ball lit by it, side by side")
      ->type_name("FILE.png")
      ->check(validator([](const std::string& text) -> std::string {
        const bool is_png = text.size() > 4 && text.substr(text.size() - 4) == ".png";
        return is_png ? "" : "'" + text + "' does not end in .png";
      }))
      ->group(group);
  app.add_flag("--list", options.list, "Print all conventions, and where they are defined")->group(group);
  add_number(app, "--threads", options.threads, 0, 1024, "0...1024", "How many; 0 is all of the machine's")
      ->group(group);
  app.add_flag("--quiet", options.quiet, "No bar of progress, no warnings")->group(group);
}

}  // namespace

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "From a picture of all directions to spherical harmonics coefficients in\n"
      "anybody's convention, or from one convention to another. EXR and HDR are read as\n"
      "linear; PNG, JPEG and their like as 8 bits of sRGB, which are made linear.\n"
      "Coefficients are read from .json, as this program writes it, .txt or .csv.",
      "zonal-probe");
  set_up(app);
  app.add_option("input", line.options.input, "A picture, or coefficients")->type_name("FILE");
  add_input_options(app, line.options);
  add_light_options(app, line.options);
  add_output_options(app, line.options);
  line.exit_status = parse(app, argc, argv);
  if (!line.exit_status && !line.options.list && line.options.input.empty()) {
    throw InputError("which picture, or coefficients? --help says more");
  }
  return line;
}

}  // namespace zonal_probe
