# Every library is a Debian 12 package; scripts/packages.txt lists them.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED CONFIG)
find_package(fmt REQUIRED CONFIG)
find_package(spdlog REQUIRED CONFIG)
find_package(CLI11 REQUIRED CONFIG)
find_package(tomlplusplus REQUIRED CONFIG)
find_package(nlohmann_json REQUIRED CONFIG)
find_package(sdformat12 REQUIRED CONFIG)
find_package(GTest REQUIRED CONFIG)
find_package(benchmark REQUIRED CONFIG)
find_package(Boost 1.74 REQUIRED)
find_package(PNG REQUIRED)
find_package(Freetype REQUIRED)
pkg_check_modules(lcm REQUIRED IMPORTED_TARGET lcm)
pkg_check_modules(turbojpeg REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(osmesa REQUIRED IMPORTED_TARGET osmesa)
pkg_check_modules(gmp REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(bullet_float64 REQUIRED IMPORTED_TARGET bullet-float64)
find_path(MSGPACK_INCLUDE_DIR msgpack.hpp REQUIRED)
find_program(LCM_GEN lcm-gen REQUIRED)

# Header-only; without Boost, as the package can be built.
add_library(msgpack_cxx INTERFACE)
target_include_directories(msgpack_cxx SYSTEM INTERFACE ${MSGPACK_INCLUDE_DIR})
target_compile_definitions(msgpack_cxx INTERFACE MSGPACK_NO_BOOST)

# Bullet in double: its flags say BT_USE_DOUBLE_PRECISION to whoever links it. The float libraries
# have the same symbols, so this is the only way in.
add_library(bullet_double ALIAS PkgConfig::bullet_float64)
