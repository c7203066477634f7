#include "mtl_file.hpp"

#include <algorithm>
#include <string_view>

#include "named_file.hpp"
#include "statements.hpp"

namespace example {
namespace {

/// One number is a grey; none where it is no colour.
std::optional<glm::vec3> colour_in(std::string_view text) {
  text = without_comment(text);
  const std::optional<double> red = number_in(next_word(text));
  if (!red) return std::nullopt;
  if (text.empty()) return glm::vec3(static_cast<float>(*red));
  const std::optional<double> green = number_in(next_word(text)), blue = number_in(next_word(text));
  if (!green || !blue) return std::nullopt;
  return glm::vec3(glm::dvec3(*red, *green, *blue));
}

/// The last word as a number: options may stand before it.
std::optional<float> number_of(std::string_view text) {
  text = without_comment(text);
  std::string_view last;
  while (!text.empty()) last = next_word(text);
  const std::optional<double> number = number_in(last);
  return number ? std::optional(static_cast<float>(*number)) : std::nullopt;
}

/// Reads a picture's statement: options, then a name that may hold blanks.
class MapReader {
 public:
  MapReader(const std::filesystem::path& folder, std::set<std::string>& left_out)
      : folder_(folder), left_out_(left_out) {}

  MtlMap read(std::string_view rest) {
    map_ = {};
    while (rest.starts_with('-') && read_option(rest)) {
    }
    const std::string_view without_comment = name_without_comment(rest);
    map_.file = named_file(folder_, rest);
    if (!map_.file) map_.file = named_file(folder_, without_comment, true);
    map_.name = map_.file ? rest : without_comment;
    return map_;
  }

 private:
  /// Takes an option with its values off the text; not what only looks like one.
  bool read_option(std::string_view& rest) {
    std::string_view words = rest;
    const std::string option(next_word(words));
    if (option == "-s") {
      map_.scale = up_to_three(words, 1.0f);
    } else if (option == "-o") {
      map_.offset = up_to_three(words, 0.0f);
    } else if (option == "-clamp") {
      map_.clamped = next_word(words) == "on";
    } else if (option == "-bm") {
      map_.strength = number(words).value_or(1.0f);
    } else if (option == "-t") {
      up_to_three(words, 0.0f);
      left_out_.insert(option);
    } else if (option == "-mm") {
      const std::optional<float> base = number(words), gain = number(words);
      if (base != 0.0f || gain != 1.0f) left_out_.insert(option);
    } else if (option == "-blendu" || option == "-blendv" || option == "-boost" || option == "-texres") {
      next_word(words);  // how programs filter
    } else if (option == "-cc" || option == "-imfchan" || option == "-type") {
      next_word(words);
      left_out_.insert(option);
    } else {
      return false;
    }
    rest = without_blanks(words);
    return true;
  }

  static std::optional<float> number(std::string_view& words) {
    constexpr double greatest = 1e6;
    std::string_view after = words;
    const std::optional<double> value = number_in(next_word(after));
    if (!value) return std::nullopt;
    words = after;
    return static_cast<float>(std::clamp(*value, -greatest, greatest));
  }

  /// The third is of pictures with a depth.
  static glm::vec2 up_to_three(std::string_view& words, float otherwise) {
    glm::vec2 values(otherwise);
    for (int i = 0; i < 3; ++i) {
      const std::optional<float> value = number(words);
      if (!value) break;
      if (i < 2) values[i] = *value;
    }
    return values;
  }

  const std::filesystem::path& folder_;
  std::set<std::string>& left_out_;
  MtlMap map_;
};

/// Reads one material's statements.
class MaterialReader {
 public:
  MaterialReader(std::string_view name, const std::filesystem::path& folder, std::set<std::string>& left_out)
      : folder_(folder), left_out_(left_out) {
    material_.name = name;
  }

  void read(const Statement& statement) {
    const std::string_view keyword = statement.keyword;
    const std::optional<float> number = number_of(statement.rest);
    if (keyword == "Kd") {
      if (const std::optional<glm::vec3> colour = colour_of(statement)) material_.diffuse = colour;
    } else if (keyword == "Ks") {
      material_.specular = colour_of(statement).value_or(material_.specular);
    } else if (keyword == "Ke") {
      material_.emission = colour_of(statement).value_or(material_.emission);
    } else if (keyword == "Ns") {
      material_.exponent = number;
    } else if (keyword == "Pr") {
      material_.roughness = number;
    } else if (keyword == "Pm") {
      material_.metallic = number;
    } else if (keyword == "illum") {
      set_illumination(static_cast<int>(std::clamp(number.value_or(2.0f), 0.0f, 100.0f)));
    } else if (keyword == "d") {
      dissolve_ = number.value_or(1.0f);
    } else if (keyword == "Tr") {
      transparency_ = number.value_or(0.0f);
    } else if (keyword == "Tf") {
      if (colour_in(statement.rest) != glm::vec3(1.0f)) left_out_.insert("Tf");
    } else if (keyword == "map_Kd") {
      material_.colour = map_of(statement);
    } else if (keyword == "norm") {
      material_.normals = map_of(statement);
    } else if (keyword == "map_Bump" || keyword == "map_bump" || keyword == "bump") {
      material_.bump = map_of(statement);
    } else if (keyword != "Ka" && keyword != "Ni" && number != 0.0f) {
      // Nothing here is lit from everywhere, nor refracts, and 0 of whatever it may be is nothing.
      left_out_.insert(std::string(keyword.substr(0, 20)));
    }
  }

  MtlMaterial finish() {
    // With d there, Tr says the same again, or its opposite: programs differ.
    if (dissolve_ ? *dissolve_ < 1.0f : transparency_ > 0.0f) left_out_.insert(dissolve_ ? "d" : "Tr");
    return material_;
  }

 private:
  std::optional<glm::vec3> colour_of(const Statement& statement) {
    const std::optional<glm::vec3> given = colour_in(statement.rest);
    // A spectrum's file, or another colour space.
    if (!given) left_out_.insert(std::string(statement.keyword) + " that is not RGB");
    return given;
  }

  MtlMap map_of(const Statement& statement) { return MapReader(folder_, left_out_).read(statement.rest); }

  void set_illumination(int model) {
    material_.illumination = model;
    // No shading at all, and glass.
    for (const int unknown : {0, 4, 6, 7, 9, 10}) {
      if (model == unknown) left_out_.insert("illum " + std::to_string(model));
    }
  }

  MtlMaterial material_;
  const std::filesystem::path& folder_;
  std::set<std::string>& left_out_;
  std::optional<float> dissolve_;
  float transparency_ = 0.0f;
};

}  // namespace

void MtlLibrary::read(const std::filesystem::path& path) {
  Statements statements(path);
  const std::filesystem::path folder = path.parent_path();
  std::optional<MaterialReader> reader;
  const auto finish = [&] {
    if (reader) materials_.push_back(reader->finish());
  };
  while (const std::optional<Statement> statement = statements.next()) {
    if (statement->keyword == "newmtl") {
      finish();
      reader.emplace(statement->rest, folder, left_out_);
    } else if (reader) {
      reader->read(*statement);
    }
  }
  finish();
}

std::optional<std::size_t> MtlLibrary::find(const std::string& name) const {
  const auto find_if = [&](const auto& matches) -> std::optional<std::size_t> {
    const auto found = std::find_if(materials_.begin(), materials_.end(), matches);
    if (found == materials_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - materials_.begin());
  };
  if (const auto whole = find_if([&](const MtlMaterial& material) { return material.name == name; })) return whole;
  const std::string_view bare = name_without_comment(name);
  return find_if([&](const MtlMaterial& material) { return name_without_comment(material.name) == bare; });
}

}  // namespace example
