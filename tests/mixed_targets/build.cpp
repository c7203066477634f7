#include "scene.hpp"

void build(Scene& scene) { build_here(scene); }
