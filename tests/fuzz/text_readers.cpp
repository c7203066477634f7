// OBJ with MTL, positions and tables: the programs' own readers, in one translation unit, for each alone takes as long
// to compile.
#include "../../examples/field-capture/positions.cpp"
#include "../../examples/shared/input_error.cpp"
#include "../../examples/shared/mtl_file.cpp"
#include "../../examples/shared/named_file.cpp"
#include "../../examples/shared/obj_file.cpp"
#include "../../examples/shared/statements.cpp"
#include "../../examples/shared/triangulate.cpp"
#include "../../tools/zonal-doctor/table.cpp"
