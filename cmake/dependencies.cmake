# SPDX-License-Identifier: Apache-2.0
# scripts/setup installs these; the header-only ones are taken from the system include path.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(embree 3 REQUIRED)
find_package(glm REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Vulkan REQUIRED)
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
# By pkg-config: the CMake files of Debian 12's OpenImageIO name folders and Python modules that it does not depend on.
pkg_check_modules(OPENIMAGEIO REQUIRED IMPORTED_TARGET OpenImageIO)
# Of Dear ImGui, Debian packages its back-ends in the same library.
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
find_package(glfw3 3.3 REQUIRED)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
find_library(TINYGLTF_LIBRARY tinygltf REQUIRED)
find_path(TINYGLTF_INCLUDE tiny_gltf.h REQUIRED)
