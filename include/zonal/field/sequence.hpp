// Sequences of light probes: which pictures, taken where, turned how.
//
// A sequence is a text file, one item a line, words apart by blanks; names with blanks in double quotes:
//
//   # what follows is no part of it
//   mapping mirror sphere         as mapping.hpp names them; without it, a mirror sphere where one of the next two
//   items
//                                 is there, else what the pictures' shape says (guess.hpp)
//   sphere-radius 0.05            of the mirror sphere, in the positions' unit; without it 0: one viewpoint
//   dead-angle 4.2 black          degrees about forward that a mirror sphere does not show; they are black (so too
//                                 without the word), or missing
//   orientation 1 0 0 0           of all pictures: w x y z, the unit quaternion that turns a picture's axes (x forward,
//                                 y left, z up) into those of the positions; without it, they are the same
//   probe hall/0001.exr 0.25 1.5 -2
//   probe "hall/0002 b.exr" 0.30 1.5 -2  0.7071068 0 0.7071068 0
//
// with a probe's position, and its own orientation where it has one. Relative names are relative to the file's folder.
//
// [1] The system whose dead angle is black: Loew, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for
// realtime
//     incident light field rendering, SCCG 2009.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "../environment/mapping.hpp"
#include "../file/checked_file.hpp"
#include "../file/number_text.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A light probe: the picture's file, and where it was taken.
struct SequenceProbe {
  std::filesystem::path picture;
  glm::vec3 position{0};
  std::optional<glm::quat> orientation;  // its own, from the picture's axes to the positions'
};

/// What a dead angle counts as: black [1], or as not seen.
enum class DeadAngle { black, missing };

struct ProbeSequence {
  std::optional<Mapping> mapping;
  float sphere_radius = 0;  // of the mirror sphere, in the positions' unit; 0 is one viewpoint
  float dead_angle = 0;     // radians
  DeadAngle dead_angle_is = DeadAngle::black;
  glm::quat orientation{1, 0, 0, 0};  // w, x, y, z
  std::vector<SequenceProbe> probes;

  glm::quat orientation_of(const SequenceProbe& probe) const { return probe.orientation.value_or(orientation); }
};

namespace detail {

// A line's words, without quotes and comments. False where a quote is not closed.
inline bool split_words(std::string_view line, std::vector<std::string>& words) {
  words.clear();
  constexpr std::string_view blanks = " \t\r\v\f";
  for (std::size_t at = line.find_first_not_of(blanks); at < line.size(); at = line.find_first_not_of(blanks, at)) {
    if (line[at] == '#') break;
    const bool is_quoted = line[at] == '"';
    const std::size_t begin = is_quoted ? at + 1 : at;
    std::size_t end = is_quoted ? line.find('"', begin) : line.find_first_of(blanks, begin);
    if (is_quoted && end == std::string_view::npos) return false;
    if (end == std::string_view::npos) end = line.size();
    words.emplace_back(line.substr(begin, end - begin));
    at = is_quoted ? end + 1 : end;
  }
  return true;
}

// One line after the other; what is wrong is said with the line's number.
class SequenceReader {
 public:
  explicit SequenceReader(const std::filesystem::path& path) : path_(path) {
    InputFile file(path);
    if (file.size() > greatest_size) file.fail("is too large for a sequence");
    std::string text(static_cast<std::size_t>(file.size()), '\0');
    file.read(reinterpret_cast<unsigned char*>(text.data()), text.size());
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = (std::min)(text.find('\n', begin), text.size());
      ++line_;
      add(std::string_view(text).substr(begin, end - begin));
      begin = end + 1;
    }
    line_ = 0;
    if (sequence_.probes.empty()) fail("has no probes");
    settle_mirror();
  }

  ProbeSequence take() { return std::move(sequence_); }

 private:
  static constexpr std::uint64_t greatest_size = std::uint64_t{1} << 30U;

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(path_, line_ == 0 ? what : "line " + std::to_string(line_) + " " + what);
  }

  void add(std::string_view line) {
    if (!split_words(line, words_)) fail("has a quote that is not closed");
    if (words_.empty()) return;
    const std::string& item = words_[0];
    if (item == "probe") return add_probe();
    if (item != "mapping" && item != "sphere-radius" && item != "dead-angle" && item != "orientation") {
      fail("is no item of a sequence: " + item);
    }
    for (const std::string& earlier : items_) {
      if (earlier == item) fail("says a second time: " + item);
    }
    items_.push_back(item);
    if (item == "mapping") set_mapping();
    if (item == "sphere-radius") set_radius();
    if (item == "dead-angle") set_dead_angle();
    if (item == "orientation") sequence_.orientation = orientation(1);
  }

  void set_mapping() {
    std::string name;
    for (std::size_t i = 1; i < words_.size(); ++i) name += (i > 1 ? " " : "") + words_[i];
    Mapping mapping{};
    if (!find_mapping(name.c_str(), mapping)) fail("names no mapping: " + name);
    sequence_.mapping = mapping;
  }
  void set_radius() {
    expect(2, 2);
    sequence_.sphere_radius = number(1);
    if (!(sequence_.sphere_radius >= 0)) fail("has a radius below 0");
  }
  void set_dead_angle() {
    expect(2, 3);
    const float degrees = number(1);
    if (!(degrees >= 0 && degrees < 180)) fail("has a dead angle that is not from 0 to below 180 degrees");
    sequence_.dead_angle = degrees * float(kPi / 180);
    if (words_.size() == 2) return;
    if (words_[2] != "black" && words_[2] != "missing") fail("has a dead angle neither black nor missing");
    if (words_[2] == "missing") sequence_.dead_angle_is = DeadAngle::missing;
  }
  void add_probe() {
    if (words_.size() < 5) fail("lacks the probe's picture or position: probe FILE x y z [w x y z]");
    if (words_.size() != 5) expect(9, 9);
    SequenceProbe probe;
    probe.picture = words_[1];
    if (probe.picture.empty()) fail("lacks the probe's picture");
    if (probe.picture.is_relative()) probe.picture = path_.parent_path() / probe.picture;
    for (int axis = 0; axis < 3; ++axis) probe.position[axis] = number(2 + static_cast<std::size_t>(axis));
    if (words_.size() == 9) probe.orientation = orientation(5);
    sequence_.probes.push_back(std::move(probe));
  }

  void expect(std::size_t least, std::size_t most) const {
    if (words_.size() < least) fail("lacks a number");
    if (words_.size() > most) fail("goes on where it should end: " + words_[most]);
  }
  float number(std::size_t word) const {
    float value = 0;
    if (!parse_number(words_[word], value) || !std::isfinite(value))
      fail("has no number where one should be: " + words_[word]);
    return value;
  }
  glm::quat orientation(std::size_t first) const {
    expect(first + 4, first + 4);
    const glm::quat turn(number(first), number(first + 1), number(first + 2), number(first + 3));
    const float length = std::sqrt(glm::dot(turn, turn));
    if (!(std::abs(length - 1) < 1e-3F)) fail("has an orientation that is no unit quaternion");
    return glm::quat(turn.w / length, turn.x / length, turn.y / length, turn.z / length);
  }
  // A mirror's radius or dead angle names the mapping.
  void settle_mirror() {
    if (!(sequence_.sphere_radius > 0 || sequence_.dead_angle > 0)) return;
    if (!sequence_.mapping) sequence_.mapping = Mapping::mirror_sphere;
    if (*sequence_.mapping != Mapping::mirror_sphere) {
      fail(std::string("has a mirror sphere's radius or dead angle, but its mapping is ") +
           mapping_name(*sequence_.mapping));
    }
  }

  std::filesystem::path path_;
  std::size_t line_ = 0;
  std::vector<std::string> words_, items_;
  ProbeSequence sequence_;
};

}  // namespace detail

/// Reads a sequence, pictures' names made relative to where the program runs. Whether the pictures are there is not
/// looked at. Throws FileError, which names the line.
inline ProbeSequence read_sequence(const std::filesystem::path& path) { return detail::SequenceReader(path).take(); }

/// Writes a sequence that read_sequence reads back as the same, numbers to the last bit (the dead angle and turns to
/// some 1e-7), with names relative to the file's folder where they are below it. Throws FileError, also where a name
/// has a quote or a new line in it.
inline void write_sequence(const std::filesystem::path& path, const ProbeSequence& sequence) {
  std::string text;
  const auto add = [&](std::initializer_list<float> numbers) {
    for (const float number : numbers) text.append(1, ' ').append(shortest_text(number));
  };
  const auto add_turn = [&](const glm::quat& q) { add({q.w, q.x, q.y, q.z}); };
  if (sequence.mapping) text += std::string("mapping ") + mapping_name(*sequence.mapping) + "\n";
  if (sequence.sphere_radius > 0) {
    text += "sphere-radius";
    add({sequence.sphere_radius});
    text += "\n";
  }
  if (sequence.dead_angle > 0) {
    text += "dead-angle";
    add({sequence.dead_angle / float(kPi / 180)});
    text += sequence.dead_angle_is == DeadAngle::black ? " black\n" : " missing\n";
  }
  text += "orientation";
  add_turn(sequence.orientation);
  text += "\n";
  for (const SequenceProbe& probe : sequence.probes) {
    std::filesystem::path picture = probe.picture.lexically_proximate(path.parent_path());
    if (*picture.begin() == "..") picture = std::filesystem::absolute(probe.picture);
    const std::string name = picture.generic_string();
    if (name.find_first_of("\"\n") != std::string::npos) {
      throw FileError(path, "cannot hold the picture's name: " + name);
    }
    text.append("probe \"").append(name).append("\"");
    add({probe.position.x, probe.position.y, probe.position.z});
    if (probe.orientation) add_turn(*probe.orientation);
    text += "\n";
  }
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.move_into_place();
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
