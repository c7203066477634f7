#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace example {

/// A picture of a material, and where it lies: at scale * texture coordinates + offset.
struct MtlMap {
  std::string name;                           // as it stands there
  std::optional<std::filesystem::path> file;  // none where there is no such file
  glm::vec2 scale{1.0f}, offset{0.0f};        // -s, -o
  bool clamped = false;                       // -clamp
  float strength = 1.0f;                      // -bm
};

/// What a material file says of a material, as far as the programs follow it.
struct MtlMaterial {
  std::string name;                  // as it stands there
  std::optional<glm::vec3> diffuse;  // Kd
  glm::vec3 specular{0.0f};          // Ks
  glm::vec3 emission{0.0f};          // Ke
  std::optional<float> exponent;     // Ns
  std::optional<float> roughness;    // Pr: perceptual, the square root of GGX's alpha
  std::optional<float> metallic;     // Pm
  int illumination = 2;              // illum
  std::optional<MtlMap> colour;      // map_Kd
  std::optional<MtlMap> normals;     // norm
  std::optional<MtlMap> bump;        // map_Bump, map_bump, bump
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
