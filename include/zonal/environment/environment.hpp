// A picture of all directions: which texels, and which directions they are.
#pragma once

#include <array>
#include <string>

#include "mapping.hpp"
#include "picture.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A picture and its mapping: radiance from every direction, W / (m^2 sr) or whatever the picture is in. A view: the
/// picture's owner keeps it alive. `Element` is float or Half.
template <class Element>
class Environment {
 public:
  using View = Picture<const Element>;
  static constexpr int max_side = 1 << 29;  // texels

  /// Throws std::invalid_argument where what_is_wrong() is not empty; without exceptions it ends the program
  /// (refuse.hpp), so ask that first. `dead_angle`: MirrorSphere.
  Environment(const View& picture, Mapping mapping, double dead_angle = 0)
      : picture_(picture), mapping_(mapping), dead_angle_(dead_angle) {
    const std::string wrong = what_is_wrong(picture, mapping, dead_angle);
    if (!wrong.empty()) detail::refuse(wrong);
  }
  /// Six pictures, of the faces +x, -x, +y, -y, +z, -z, each as graphics interfaces address it (VerticalFacesLayout).
  /// Then it is as if they stood one under the other.
  explicit Environment(const std::array<View, 6>& faces)
      : picture_(faces[0]), mapping_(Mapping::vertical_faces), has_separate_faces_(true), faces_(faces) {
    const std::string wrong = what_is_wrong(faces);
    if (!wrong.empty()) detail::refuse(wrong);
    picture_.height = 6 * picture_.width;
  }

  /// Why there can be no such environment; empty if there can be one.
  static std::string what_is_wrong(const View& picture, Mapping mapping, double dead_angle = 0) {
    const std::string wrong = picture.what_is_wrong();
    if (!wrong.empty()) return wrong;
    const std::string size = std::to_string(picture.width) + " x " + std::to_string(picture.height);
    if (picture.width > max_side || picture.height > max_side) return "a picture of too many texels: " + size;
    const bool is_mirror = mapping == Mapping::mirror_sphere;
    if (!(dead_angle >= 0 && dead_angle < double(kPi)) || (dead_angle > 0 && !is_mirror)) {
      return "a dead angle of " + std::to_string(dead_angle) + " for a picture of kind " + mapping_name(mapping);
    }
    const std::string unfit = visit_mapping(
        mapping, [&](auto tag) { return decltype(tag)::Type::what_is_wrong(picture.width, picture.height); });
    if (unfit.empty() && is_mirror) {  // the texel in the middle, or one of four
      const int middle = picture.width / 2;
      const bool has_any = MirrorSphere(picture.width, picture.width, dead_angle).has_direction(middle, middle);
      return has_any ? unfit : "a mirror sphere of which the dead angle leaves no texel";
    }
    return unfit.empty() ? unfit : std::string("no ") + mapping_name(mapping) + ", " + size + ": " + unfit;
  }
  static std::string what_is_wrong(const std::array<View, 6>& faces) {
    for (const View& face : faces) {
      const std::string wrong = face.what_is_wrong();
      if (!wrong.empty()) return wrong;
      if (face.width != face.height || face.width != faces[0].width) return "faces of a cube that are not of one size";
      if (face.width > max_side / 6) return "faces of too many texels";
    }
    return {};
  }

  int width() const { return picture_.width; }
  int height() const { return picture_.height; }
  Mapping mapping() const { return mapping_; }

  /// visit(m), m being the mapping itself (mapping.hpp); gives back what it does.
  template <class Visit>
  decltype(auto) visit(Visit&& visit_it) const {
    return visit_mapping(mapping_, [&](auto tag) -> decltype(auto) {
      using M = typename decltype(tag)::Type;
      if constexpr (std::is_same_v<M, MirrorSphere>) {
        return visit_it(M(width(), height(), dead_angle_));
      } else {
        return visit_it(M(width(), height()));
      }
    });
  }

  /// A texel as it stands in the picture: 0 <= column < width(), 0 <= row < height().
  Rgb<float> rgb(int column, int row) const {
    return has_separate_faces_ ? faces_[static_cast<std::size_t>(row / width())].rgb(column, row % width())
                               : picture_.rgb(column, row);
  }
  /// The same with what is no radiance as 0, and counted (PictureFaults).
  Rgb<float> radiance(int column, int row, PictureFaults& faults) const {
    const Rgb<float> c = rgb(column, row);
    if (picture_.channels == 1) {
      const float grey = detail::as_radiance(c.r, faults);
      return {grey, grey, grey};
    }
    return {detail::as_radiance(c.r, faults), detail::as_radiance(c.g, faults), detail::as_radiance(c.b, faults)};
  }

  /// The picture, or of a cube one of its faces, 0 to 5, as its mapping orders them.
  const View& picture() const { return picture_; }
  template <class Layout>
  View face(int i) const {
    if (has_separate_faces_) return faces_[static_cast<std::size_t>(i)];
    View view = picture_;
    view.width = view.height = picture_.width / Layout::columns;
    view.data = picture_.at(Layout::faces[i].column * view.width, Layout::faces[i].row * view.width);
    return view;
  }

 private:
  View picture_;
  Mapping mapping_;
  double dead_angle_ = 0;
  bool has_separate_faces_ = false;
  std::array<View, 6> faces_;
};
template <class Element>
Environment(const Picture<Element>&, Mapping) -> Environment<std::remove_const_t<Element>>;
template <class Element>
Environment(const Picture<Element>&, Mapping, double) -> Environment<std::remove_const_t<Element>>;
template <class Element>
Environment(const std::array<Picture<Element>, 6>&) -> Environment<std::remove_const_t<Element>>;

}  // namespace ZONAL_TARGET
}  // namespace zonal
