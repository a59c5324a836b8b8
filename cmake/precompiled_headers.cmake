# The standard library's headers are half of what a file costs to compile. GCC reads them once for the product and once,
# with Catch2's, for the test programs. Off for clang, so that the presets tidy and fuzz show a header that is missing.
#
# Each is made by a target of its own, without any definition that only some targets have: GCC takes none of another's.

set(standard_headers <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <cstdio> <filesystem> <fstream> <functional>
    <limits> <map> <memory> <mutex> <numbers> <numeric> <optional> <set> <span> <sstream> <string> <string_view> <thread>
    <tuple> <unordered_map> <utility> <variant> <vector>)

# A target that holds the standard headers and those named.
function(add_precompiled_headers name)
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE croquis_flags)
  target_precompile_headers(${name} PRIVATE ${ARGN} ${standard_headers})
endfunction()

# Libraries and programs of a folder and of those below it read those of `from`, except those that have others.
function(use_precompiled_headers from folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(others ${target} PRECOMPILE_HEADERS_REUSE_FROM)
    if(type MATCHES "STATIC_LIBRARY|EXECUTABLE" AND NOT others)
      target_precompile_headers(${target} REUSE_FROM ${from})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below ${folders})
    use_precompiled_headers(${from} ${below})
  endforeach()
endfunction()
