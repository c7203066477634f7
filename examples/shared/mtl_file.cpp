#include "mtl_file.hpp"

#include <algorithm>
#include <string_view>

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

/// Reads one material's statements.
class MaterialReader {
 public:
  MaterialReader(std::string_view name, std::set<std::string>& left_out) : left_out_(left_out) {
    material_.name = name;
  }

  void read(const Statement& statement) {
    const std::string_view keyword = statement.keyword;
    const std::optional<float> number = number_of(statement.rest);
    if (keyword == "Kd") {
      has_diffuse_ = set(material_.diffuse, statement);
    } else if (keyword == "Ks") {
      set(material_.specular, statement);
    } else if (keyword == "Ke") {
      set(material_.emission, statement);
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
      has_picture_ = true;
      left_out_.insert("map_Kd");
    } else if (keyword != "Ka" && keyword != "Ni" && number != 0.0f) {
      // Nothing here is lit from everywhere, nor refracts, and 0 of whatever it may be is nothing.
      left_out_.insert(std::string(keyword.substr(0, 20)));
    }
  }

  MtlMaterial finish() {
    // With d there, Tr says the same again, or its opposite: programs differ.
    if (dissolve_ ? *dissolve_ < 1.0f : transparency_ > 0.0f) left_out_.insert(dissolve_ ? "d" : "Tr");
    // Black times the picture is what some programs write for the picture.
    if (has_picture_ && has_diffuse_ && material_.diffuse == glm::vec3(0.0f)) {
      material_.diffuse = MtlMaterial().diffuse;
    }
    return material_;
  }

 private:
  bool set(glm::vec3& colour, const Statement& statement) {
    const std::optional<glm::vec3> given = colour_in(statement.rest);
    // A spectrum's file, or another colour space.
    if (!given) left_out_.insert(std::string(statement.keyword) + " that is not RGB");
    colour = given.value_or(colour);
    return given.has_value();
  }

  void set_illumination(int model) {
    material_.illumination = model;
    // No shading at all, and glass.
    for (const int unknown : {0, 4, 6, 7, 9, 10}) {
      if (model == unknown) left_out_.insert("illum " + std::to_string(model));
    }
  }

  MtlMaterial material_;
  std::set<std::string>& left_out_;
  bool has_diffuse_ = false, has_picture_ = false;
  std::optional<float> dissolve_;
  float transparency_ = 0.0f;
};

}  // namespace

void MtlLibrary::read(const std::filesystem::path& path) {
  Statements statements(path);
  std::optional<MaterialReader> reader;
  const auto finish = [&] {
    if (reader) materials_.push_back(reader->finish());
  };
  while (const std::optional<Statement> statement = statements.next()) {
    if (statement->keyword == "newmtl") {
      finish();
      reader.emplace(statement->rest, left_out_);
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
