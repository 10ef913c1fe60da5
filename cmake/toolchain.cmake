# SPDX-License-Identifier: Apache-2.0
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

add_library(boxlight_options INTERFACE)
target_include_directories(boxlight_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(boxlight_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false in libstdc++'s std::string of GCC 12 (GCC bug 105651)
  -Werror -ffp-contract=off)   # no contraction: the same bytes from every x86-64 build of the same compiler
if(BOXLIGHT_SANITIZE)
  target_compile_options(boxlight_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(boxlight_options INTERFACE -fsanitize=address,undefined)
endif()

# One library per wing: its sources are the .cpp files of one folder.
function(boxlight_wing name folder)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC boxlight_options ${ARGN})
endfunction()
