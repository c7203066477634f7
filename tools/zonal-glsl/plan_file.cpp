#include "plan_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include <nlohmann/json.hpp>
#include <zonal/shader/function_table.hpp>

#include "request.hpp"

namespace zonal_glsl {
namespace {

using nlohmann::json;

/// A part of the file, and where it stands: materials[2].receiving.bands.
class Node {
 public:
  Node(const json& value, std::string path, const std::string& file)
      : value_(value), path_(std::move(path)), file_(file) {}

  [[noreturn]] void refuse(const std::string& what) const { throw RequestError(file_ + ": " + path_ + " " + what); }

  Node operator[](const std::string& key) const {
    if (!value_.is_object() || !value_.contains(key)) refuse("has no \"" + key + "\"");
    return {value_[key], path_ == "the plan" ? key : path_ + "." + key, file_};
  }
  std::size_t size() const {
    if (!value_.is_array()) refuse("is no list");
    return value_.size();
  }
  Node operator[](std::size_t i) const { return {value_[i], path_ + "[" + std::to_string(i) + "]", file_}; }

  int whole(int least, int most) const {
    const bool is_whole = value_.is_number_integer() || value_.is_number_unsigned();
    const double number = is_whole ? value_.get<double>() : least - 1.0;
    if (number < least || number > most) {
      refuse("is not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return static_cast<int>(number);
  }

  template <class Value, std::size_t Size>
  Value one_of(const std::array<std::pair<const char*, Value>, Size>& names) const {
    std::string all;
    for (const auto& [name, value] : names) {
      if (value_.is_string() && value_.get<std::string>() == name) return value;
      all += std::string(all.empty() ? "" : ", ") + name;
    }
    refuse("is not one of " + all);
  }

 private:
  const json& value_;
  std::string path_;
  const std::string& file_;
};

zonal::CoefficientPlan coefficients(const Node& node) {
  using zonal::Symmetry;
  const std::array<std::pair<const char*, Symmetry>, 3> names{
      {{"zonal", Symmetry::zonal}, {"mirror", Symmetry::mirror}, {"none", Symmetry::none}}};
  zonal::CoefficientPlan plan;
  plan.symmetry = node["symmetry"].one_of(names);
  if (plan.symmetry == Symmetry::none) node["symmetry"].refuse("is none: shaders do not gather anisotropic materials");
  plan.bands = node["bands"].whole(1, zonal::shader::max_bands);
  plan.kept.assign(static_cast<std::size_t>(plan.bands * plan.bands), false);
  for (int l = 0; l < plan.bands; ++l) {
    for (int m = -l; m <= l; ++m)
      plan.kept[static_cast<std::size_t>(zonal::sh_index(l, m))] = has_order(plan.symmetry, m);
  }
  const Node left_out = node["left_out"];
  for (std::size_t i = 0; i < left_out.size(); ++i) {
    if (left_out[i].size() != 2) left_out[i].refuse("is not a degree and an order");
    const int l = left_out[i][0].whole(0, plan.bands - 1);
    const int m = left_out[i][1].whole(0, plan.symmetry == Symmetry::zonal ? 0 : l);
    plan.kept[static_cast<std::size_t>(zonal::sh_index(l, m))] = false;
  }
  return plan;
}

/// The least number of bands that there are functions for.
int emission_bands(const Node& node) {
  const int bands = node.whole(1, zonal::MaterialTable::max_bands);
  if (bands > 3) node.refuse("is " + std::to_string(bands) + ": shaders have 1 or 3");
  return bands == 1 ? 1 : 3;
}

json parse(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw RequestError(path + ": cannot be read");
  try {
    return json::parse(file);
  } catch (const json::parse_error& error) {
    throw RequestError(path + ": is no JSON at byte " + std::to_string(error.byte));
  } catch (const json::exception&) {
    throw RequestError(path + ": has a number beyond all range");
  }
}

}  // namespace

zonal::shader::PlannedMaterials read_plan(const std::string& path) {
  using zonal::Horizon;
  const json file = parse(path);
  const Node node(file.is_object() && file.contains("plan") ? file["plan"] : file, "the plan", path);
  zonal::shader::PlannedMaterials plan;
  const std::array<std::pair<const char*, Horizon>, 3> horizons{
      {{"none", Horizon::none}, {"smoothstep", Horizon::smoothstep}, {"exact", Horizon::exact}}};
  plan.horizon = node["horizon"].one_of(horizons);
  plan.coefficient_bits = node["coefficient_bits"].whole(16, 32);
  if (plan.coefficient_bits != 16 && plan.coefficient_bits != 32)
    node["coefficient_bits"].refuse("is neither 16 nor 32");
  plan.emission_bands = emission_bands(node["emission_bands"]);
  const Node materials = node["materials"];
  if (materials.size() == 0) materials.refuse("is empty");
  for (std::size_t i = 0; i < materials.size(); ++i) plan.receiving.push_back(coefficients(materials[i]["receiving"]));
  return plan;
}

}  // namespace zonal_glsl
