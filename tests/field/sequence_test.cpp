// Sequences as text: what stands in them, and what must not.
#include <zonal/field/sequence.hpp>

#include <random>
#include <string>
#include <utility>

#include "../catch.hpp"
#include "../files.hpp"

namespace {

using file_test::Folder;

zonal::ProbeSequence read(const Folder& folder, const std::string& text) {
  file_test::write(folder.path / "sequence.txt", text);
  return zonal::read_sequence(folder.path / "sequence.txt");
}

std::string error_of(const Folder& folder, const std::string& text) {
  try {
    read(folder, text);
  } catch (const zonal::FileError& error) {
    const std::string what = error.what(), name = "sequence.txt: ";
    return what.substr(what.find(name) + name.size());
  }
  return "no error";
}

bool is_same(const glm::quat& a, const glm::quat& b) { return std::abs(glm::dot(a, b)) > 1 - 1e-6F; }

}  // namespace

TEST_CASE("a sequence's items come back, names relative to its folder") {
  const Folder folder;
  const auto sequence = read(folder,
                             "# probes of the hall\n"
                             "mapping mirror sphere\r\n"
                             "  sphere-radius\t0.05  # metres\n"
                             "dead-angle 4.2 missing\n\n"
                             "orientation 0.5 -0.5 -0.5 -0.5\n"
                             "probe a.exr 1 -2 3.5e-1\n"
                             "probe \"b # c.exr\" 0 0 0 0 0 0 1\n"
                             "probe /d.exr 1 2 3");
  REQUIRE(sequence.mapping == zonal::Mapping::mirror_sphere);
  REQUIRE(sequence.sphere_radius == 0.05F);
  REQUIRE(std::abs(sequence.dead_angle - 4.2F * 0.0174532925F) < 1e-8F);
  REQUIRE(sequence.dead_angle_is == zonal::DeadAngle::missing);
  REQUIRE(sequence.probes.size() == 3);
  REQUIRE(sequence.probes[0].picture == folder.path / "a.exr");
  REQUIRE(sequence.probes[0].position == glm::vec3(1, -2, 0.35F));
  REQUIRE(is_same(sequence.orientation_of(sequence.probes[0]), glm::quat(0.5F, -0.5F, -0.5F, -0.5F)));
  REQUIRE(sequence.probes[1].picture == folder.path / "b # c.exr");
  REQUIRE(is_same(sequence.orientation_of(sequence.probes[1]), glm::quat(0, 0, 0, 1)));
  REQUIRE(sequence.probes[2].picture == "/d.exr");

  const auto plain = read(folder, "probe a 0 0 0\n");
  REQUIRE(!plain.mapping);
  REQUIRE(plain.sphere_radius == 0);
  REQUIRE(plain.dead_angle_is == zonal::DeadAngle::black);
}

TEST_CASE("a sequence that cannot be is refused, and its line named") {
  const Folder folder;
  const std::string probe = "probe a.exr 0 0 0\n";
  const std::pair<std::string, std::string> cases[] = {
      {"", "has no probes"},
      {"# nothing\n", "has no probes"},
      {probe + "probe b.exr 1 2\n", "line 2 lacks the probe's picture or position: probe FILE x y z [w x y z]"},
      {"probe b.exr 1 2 nan\n", "line 1 has no number where one should be: nan"},
      {"probe b.exr 1 2 inf\n", "line 1 has no number where one should be: inf"},
      {"probe b.exr 1 2 1e99\n", "line 1 has no number where one should be: 1e99"},
      {"probe b.exr 1 2 3 4\n", "line 1 lacks a number"},
      {"probe b.exr 1 2 3 1 0 0 0 0\n", "line 1 goes on where it should end: 0"},
      {"probe b.exr 1 2 3 0 0 0 0\n", "line 1 has an orientation that is no unit quaternion"},
      {"probe b.exr 1 2 3 2 0 0 0\n", "line 1 has an orientation that is no unit quaternion"},
      {"probe \"b.exr 1 2 3\n", "line 1 has a quote that is not closed"},
      {"probe \"\" 1 2 3\n", "line 1 lacks the probe's picture"},
      {"mapping mirror ball\n" + probe, "line 1 names no mapping: mirror ball"},
      {"mapping octahedral\nmapping octahedral\n" + probe, "line 2 says a second time: mapping"},
      {"mapping octahedral\ndead-angle 4\n" + probe,
       "has a mirror sphere's radius or dead angle, but its mapping is octahedral"},
      {"sphere-radius -1\n" + probe, "line 1 has a radius below 0"},
      {"sphere-radius\n" + probe, "line 1 lacks a number"},
      {"dead-angle 180\n" + probe, "line 1 has a dead angle that is not from 0 to below 180 degrees"},
      {"dead-angle 4 grey\n" + probe, "line 1 has a dead angle neither black nor missing"},
      {"probes a.exr 0 0 0\n", "line 1 is no item of a sequence: probes"},
  };
  for (const auto& [text, error] : cases) {
    INFO(text);
    REQUIRE(error_of(folder, text) == error);
  }
  REQUIRE_THROWS_AS(zonal::read_sequence(folder.path / "none.txt"), zonal::FileError);
  REQUIRE_THROWS_AS(zonal::read_sequence(folder.path), zonal::FileError);
}

TEST_CASE("a sequence is written as it is read") {
  const Folder folder;
  zonal::ProbeSequence sequence;
  sequence.mapping = zonal::Mapping::mirror_sphere;
  sequence.sphere_radius = 0.1F;
  sequence.dead_angle = 0.07F;
  sequence.orientation = {0.5F, 0.5F, 0.5F, 0.5F};
  sequence.probes = {{folder.path / "in" / "a b.exr", {0.1F, 1 / 3.0F, -1e-30F}, {}},
                     {"/elsewhere/b.exr", {1e30F, 0, 3}, glm::quat(0.6F, 0, 0.8F, 0)}};
  zonal::write_sequence(folder.path / "sequence.txt", sequence);
  const auto back = zonal::read_sequence(folder.path / "sequence.txt");
  REQUIRE(back.mapping == sequence.mapping);
  REQUIRE(back.sphere_radius == sequence.sphere_radius);
  REQUIRE(std::abs(back.dead_angle - sequence.dead_angle) < 1e-7F);
  REQUIRE(is_same(back.orientation, sequence.orientation));
  REQUIRE(back.probes.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(back.probes[i].picture == sequence.probes[i].picture);
    REQUIRE(back.probes[i].position == sequence.probes[i].position);
  }
  REQUIRE(!back.probes[0].orientation);
  REQUIRE(is_same(*back.probes[1].orientation, *sequence.probes[1].orientation));

  sequence.probes[0].picture = "a\"b.exr";
  REQUIRE_THROWS_AS(zonal::write_sequence(folder.path / "sequence.txt", sequence), zonal::FileError);
}

TEST_CASE("a damaged sequence is read or refused, whatever stands in it") {
  const Folder folder;
  const std::string good =
      "mapping mirror sphere\nsphere-radius 0.05\ndead-angle 4.2 black\norientation 1 0 0 0\nprobe \"a b\" 1 2 "
      "3\nprobe b "
      "1 2 3 0 1 0 0\n";
  std::mt19937 random(14);
  for (int i = 0; i < 2000; ++i) {
    std::string bad = good;
    for (int n = 0; n < 3; ++n) bad[random() % bad.size()] = static_cast<char>(random());
    bad.resize(bad.size() - random() % 2 * (random() % bad.size()));
    const std::string error = error_of(folder, bad);  // whatever it is, it is no crash, and what is read is finite
    if (error != "no error") continue;
    for (const auto& probe : zonal::read_sequence(folder.path / "sequence.txt").probes) {
      for (int axis = 0; axis < 3; ++axis) REQUIRE(std::isfinite(probe.position[axis]));
    }
  }
}
