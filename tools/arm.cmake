# Toolchain for 64-bit ARM on another machine; the programs run in qemu. For tools/check-arm,
# which makes the folder of libraries that CLOD_ARM_ROOT names.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CLOD_ARM_ROOT)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_SYSROOT ${CLOD_ARM_ROOT})
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${CLOD_ARM_ROOT})
set(CMAKE_FIND_ROOT_PATH ${CLOD_ARM_ROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${CLOD_ARM_ROOT})
set(ENV{PKG_CONFIG_LIBDIR}
  ${CLOD_ARM_ROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${CLOD_ARM_ROOT}/usr/share/pkgconfig)
