#include "obj_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <zonal/file/number_text.hpp>

#include "input_error.hpp"
#include "named_file.hpp"
#include "statements.hpp"
#include "triangulate.hpp"

namespace example {
namespace {

namespace fs = std::filesystem;

constexpr double greatest_coordinate = 1e8;

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string quoted(std::string_view word) {
  std::string text = "'";
  return text.append(word).append("'");
}

/// Where the files of a statement mtllib are.
class MaterialFiles {
 public:
  explicit MaterialFiles(const fs::path& obj) : folder_(obj.parent_path()) {}

  /// Names that may hold blanks, one or several: as many words as make the longest name of a file that is there.
  void find(std::string_view rest) {
    std::vector<std::string_view> words;
    const auto split = [&](std::string_view text) {
      words.clear();
      while (!without_blanks(text).empty()) words.push_back(next_word(text));
    };
    split(rest);
    // A name may hold a '#', too.
    if (!file_of(rest)) split(name_without_comment(rest));
    for (std::size_t first = 0; first < words.size();) {
      std::size_t last = words.size();
      std::optional<fs::path> file;
      for (; last > first && !file; --last) file = file_of(between(words[first], words[last - 1]));
      if (file) {
        if (seen_.insert(*file).second) files.push_back(*file);
        first = last + 1;
      } else {
        last = first;
        while (last + 1 < words.size() && !words[last].ends_with(".mtl")) ++last;
        const std::string_view name = between(words[first], words[last]);
        file = file_of(name, true);
        if (file && seen_.insert(*file).second) files.push_back(*file);
        if (!file) missing.insert(std::string(name));
        first = last + 1;
      }
    }
  }

  std::vector<fs::path> files;
  std::set<std::string> missing;

 private:
  static std::string_view between(std::string_view first, std::string_view last) {
    return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
  }

  std::optional<fs::path> file_of(std::string_view name, bool by_last_part = false) const {
    return named_file(folder_, name, by_last_part);
  }

  fs::path folder_;
  std::set<fs::path> seen_;
};

/// Faces of any number of corners, one after the other.
struct Faces {
  struct Face {
    std::size_t first, count;  // of the corners
    std::uint32_t material;    // of the names
    std::int32_t smoothing;
    std::uint32_t mesh;
  };
  std::vector<ObjFile::Corner> corners;
  std::vector<Face> faces;
};

class ObjReader {
 public:
  explicit ObjReader(const std::string& path) : path_(path), material_files_(path) {}

  ObjFile read() {
    Statements statements(path_);
    while (const std::optional<Statement> statement = statements.next()) read(*statement);
    if (greatest_vertex_ > file_.positions.size()) {
      fail(greatest_vertex_line_,
           "a face names vertex " + std::to_string(greatest_vertex_) + " of " + std::to_string(file_.positions.size()));
    }
    if (const std::size_t count = file_.texture_coordinates.size(); greatest_coordinates_ > count) {
      note_no_coordinates(std::to_string(greatest_coordinates_) + " of " + std::to_string(count),
                          greatest_coordinates_line_);
    }
    add_triangles();
    add_materials();
    if (!no_coordinates_.empty()) file_.warnings.push_back(no_coordinates_ + "; there they are 0");
    if (!left_out_.empty()) file_.warnings.push_back(path_ + ": left out: " + listed(left_out_));
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& what) const {
    throw InputError(path_ + ":" + std::to_string(line) + ": " + what);
  }

  void read(const Statement& statement) {
    const std::string_view keyword = statement.keyword;
    if (keyword == "v") {
      add_vertex(statement);
    } else if (keyword == "vn") {
      add_normal(statement);
    } else if (keyword == "vt") {
      add_texture_coordinates(statement);
    } else if (keyword == "f" || keyword == "fo") {
      add_face(statement);
    } else if (keyword == "usemtl") {
      const auto [entry, added] =
          material_names_.try_emplace(std::string(statement.rest), static_cast<std::uint32_t>(material_names_.size()));
      material_ = statement.rest.empty() ? ObjFile::none : entry->second;
    } else if (keyword == "mtllib") {
      material_files_.find(statement.rest);
    } else if (keyword == "o" || keyword == "g") {
      (keyword == "o" ? object_ : group_) = statement.rest;
      mesh_ = meshes_.try_emplace({object_, group_}, static_cast<std::uint32_t>(meshes_.size())).first->second;
    } else if (keyword == "s") {
      std::string_view words = without_comment(statement.rest);
      smoothing_ = static_cast<std::int32_t>(std::clamp(number_in(next_word(words)).value_or(0.0), 0.0, 1e9));
    } else if (keyword == "l") {
      left_out_.insert("lines");
    } else if (keyword == "p") {
      left_out_.insert("points");
    } else if (is_one_of(keyword, {"cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole",
                                   "scrv",   "sp",  "end",  "con",  "vp",   "bsp",   "bzp",  "cdc",  "cdp",  "res"})) {
      left_out_.insert("free-form curves and surfaces");
    } else if (!is_one_of(keyword, {"mg", "maplib", "usemap", "bevel", "c_interp", "d_interp", "lod", "shadow_obj",
                                    "trace_obj", "ctech", "stech"})) {
      // None of those changes a picture.
      left_out_.insert(quoted(keyword.substr(0, 20)));
    }
  }

  void add_vertex(const Statement& statement) {
    std::string_view words = without_comment(statement.rest);
    glm::dvec3 position;
    for (int axis = 0; axis < 3; ++axis) {
      const std::optional<double> coordinate = number_in(next_word(words));
      if (!coordinate || !(std::abs(*coordinate) <= greatest_coordinate)) {
        fail(statement.line, "not three finite coordinates up to 1e8");
      }
      position[axis] = *coordinate;
    }
    int more = 0;
    while (!next_word(words).empty()) ++more;
    if (more >= 3) left_out_.insert("vertex colours");
    file_.positions.push_back(position);
  }

  void add_normal(const Statement& statement) {
    std::string_view words = without_comment(statement.rest);
    glm::dvec3 normal;
    for (int axis = 0; axis < 3; ++axis) normal[axis] = number_in(next_word(words)).value_or(0.0);
    file_.normals.emplace_back(normal);
  }

  /// One coordinate or two, of three; what is no number is 0.
  void add_texture_coordinates(const Statement& statement) {
    std::string_view words = without_comment(statement.rest);
    glm::dvec2 coordinates;
    for (int axis = 0; axis < 2; ++axis) coordinates[axis] = number_in(next_word(words)).value_or(0.0);
    file_.texture_coordinates.emplace_back(glm::clamp(coordinates, -greatest_coordinate, greatest_coordinate));
  }

  void add_face(const Statement& statement) {
    const std::size_t first = faces_.corners.size();
    std::string_view words = without_comment(statement.rest);
    for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
      faces_.corners.push_back(corner(word, statement.line));
    }
    const std::size_t count = faces_.corners.size() - first;
    if (count >= 3) {
      faces_.faces.push_back({first, count, material_, smoothing_, mesh_});
    } else {
      left_out_.insert("faces of fewer than three corners");
      faces_.corners.resize(first);
    }
  }

  /// v, v/vt, v//vn or v/vt/vn; from 1, or backwards from the last so far.
  ObjFile::Corner corner(std::string_view word, int line) {
    const std::size_t slash = word.find('/'), second = word.find('/', std::min(slash, word.size() - 1) + 1);
    const auto number = [](std::string_view text) {
      std::int64_t value = 0;
      return zonal::parse_number(text, value) ? value : 0;
    };
    const auto place = [](std::int64_t index, std::size_t count) {
      return index < 0 ? index + static_cast<std::int64_t>(count) : index - 1;
    };
    const std::int64_t vertex = place(number(word.substr(0, slash)), file_.positions.size());
    if (vertex < 0 || vertex >= ObjFile::none) {
      fail(line, quoted(word) + " names no vertex");
    }
    if (static_cast<std::size_t>(vertex) >= greatest_vertex_) {
      greatest_vertex_ = static_cast<std::size_t>(vertex) + 1;
      greatest_vertex_line_ = line;
    }
    const auto index_in = [&](std::string_view text, std::size_t count) {
      const std::int64_t index = place(number(text), count);
      return index < 0 || index >= ObjFile::none ? ObjFile::none : static_cast<std::uint32_t>(index);
    };
    const std::string_view middle = slash == std::string_view::npos ? "" : word.substr(slash + 1, second - slash - 1);
    const std::string_view last = second == std::string_view::npos ? "" : word.substr(second + 1);
    const std::uint32_t coordinates = index_in(middle, file_.texture_coordinates.size());
    if (coordinates == ObjFile::none && !middle.empty()) note_no_coordinates(word, line);
    if (coordinates != ObjFile::none && coordinates >= greatest_coordinates_) {
      greatest_coordinates_ = std::size_t{coordinates} + 1;
      greatest_coordinates_line_ = line;
    }
    return {static_cast<std::uint32_t>(vertex), coordinates, index_in(last, file_.normals.size())};
  }

  /// Of the first that is wrong: careless files have many.
  void note_no_coordinates(std::string_view word, int line) {
    if (!no_coordinates_.empty()) return;
    no_coordinates_ = path_ + ":" + std::to_string(line) + ": " + quoted(word) + " names no texture coordinates";
  }

  void add_triangles() {
    std::vector<glm::dvec3> polygon;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t crossing = 0;
    for (const Faces::Face& face : faces_.faces) {
      const ObjFile::Corner* corners = &faces_.corners[face.first];
      polygon.clear();
      triangles.clear();
      for (std::size_t i = 0; i < face.count; ++i) polygon.push_back(file_.positions[corners[i].vertex]);
      if (!triangulate(polygon, triangles)) ++crossing;
      for (const auto& [a, b, c] : triangles) {
        file_.triangles.push_back({{corners[a], corners[b], corners[c]}, face.material, face.smoothing, face.mesh});
        for (ObjFile::Corner& corner : file_.triangles.back().corners) {
          if (corner.normal >= file_.normals.size()) corner.normal = ObjFile::none;
          if (corner.coordinates >= file_.texture_coordinates.size()) corner.coordinates = ObjFile::none;
        }
      }
    }
    if (crossing > 0) {
      const std::string faces = crossing == 1 ? " face crosses itself" : " faces cross themselves";
      file_.warnings.push_back(path_ + ": " + std::to_string(crossing) + faces + ", and may be filled wrongly");
    }
  }

  void add_materials() {
    MtlLibrary library;
    for (const fs::path& file : material_files_.files) library.read(file);
    file_.material_files = material_files_.files;
    left_out_.insert(library.left_out().begin(), library.left_out().end());
    file_.materials = library.materials();

    std::vector<std::uint32_t> numbers(material_names_.size(), ObjFile::none);
    std::set<std::string> unknown;
    for (const auto& [name, at] : material_names_) {
      if (const auto found = library.find(name)) {
        numbers[at] = static_cast<std::uint32_t>(*found);
      } else if (!name.empty()) {
        unknown.insert(name);
      }
    }
    if (!material_files_.missing.empty()) {
      file_.warnings.push_back(path_ + ": no material file " + listed(material_files_.missing) +
                               "; what it had is grey");
    } else if (!unknown.empty()) {
      file_.warnings.push_back(path_ + ": no material " + listed(unknown) + "; what had it is grey");
    }
    for (ObjFile::Triangle& triangle : file_.triangles) {
      if (triangle.material != ObjFile::none) triangle.material = numbers[triangle.material];
    }
  }

  std::string path_;
  ObjFile file_;
  Faces faces_;
  MaterialFiles material_files_;
  std::map<std::string, std::uint32_t> material_names_;
  std::uint32_t material_ = ObjFile::none;
  std::int32_t smoothing_ = -1;
  std::map<std::pair<std::string, std::string>, std::uint32_t> meshes_{{{}, 0u}};
  std::string object_, group_;
  std::uint32_t mesh_ = 0;
  std::size_t greatest_vertex_ = 0;
  int greatest_vertex_line_ = 0;
  std::size_t greatest_coordinates_ = 0;
  int greatest_coordinates_line_ = 0;
  std::string no_coordinates_;
  std::set<std::string> left_out_;
};

}  // namespace

ObjFile read_obj(const std::string& path) {
  check_is_file(path);
  return ObjReader(path).read();
}

}  // namespace example
