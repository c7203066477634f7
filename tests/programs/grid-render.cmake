# grid-render's cases.
set(program grid-render)
set(small --size 16x12 --antialias 1 --grid 2)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)
