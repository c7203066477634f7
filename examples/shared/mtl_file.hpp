#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace example {

/// What a material file says of a material, as far as the programs follow it.
struct MtlMaterial {
  std::string name;                // as it stands there
  glm::vec3 diffuse{0.7f};         // Kd; grey where there is none, or where a picture that is left out has the colour
  glm::vec3 specular{0.0f};        // Ks
  glm::vec3 emission{0.0f};        // Ke
  std::optional<float> exponent;   // Ns
  std::optional<float> roughness;  // Pr: perceptual, the square root of GGX's alpha
  std::optional<float> metallic;   // Pm
  int illumination = 2;            // illum
};

/// The materials of files, by their names, the first of each name.
class MtlLibrary {
 public:
  /// Adds a file's materials. Throws InputError where it cannot be read.
  void read(const std::filesystem::path& path);

  /// For a name as it stands after usemtl; none where there is no such material. What stands after " #" may be a
  /// comment or belong to the name: the whole counts first.
  std::optional<std::size_t> find(const std::string& name) const;

  const std::vector<MtlMaterial>& materials() const { return materials_; }

  /// Keywords of what the materials have and the programs leave out.
  const std::set<std::string>& left_out() const { return left_out_; }

 private:
  std::vector<MtlMaterial> materials_;
  std::set<std::string> left_out_;
};

}  // namespace example
