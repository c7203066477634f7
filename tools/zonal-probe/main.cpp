// zonal-probe: a picture of all directions as coefficients in anybody's convention; or coefficients, from one
// convention to another.
#include "options.hpp"
#include "run.hpp"
#include "shared/run_program.hpp"

int main(int argc, char** argv) {
  using namespace zonal_probe;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
