# SPDX-License-Identifier: GPL-3.0-or-later
# Cross-compiling for the ATmega2560 with Debian's avr-gcc.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_C_COMPILER avr-gcc)
set(CMAKE_ASM_COMPILER avr-gcc)
set(CMAKE_CXX_COMPILER avr-g++)
set(CMAKE_AR avr-gcc-ar)  # the plain ar does not understand LTO objects
set(CMAKE_RANLIB avr-gcc-ranlib)
set(CMAKE_OBJCOPY avr-objcopy)
set(CMAKE_OBJDUMP avr-objdump)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_CXX_FLAGS_INIT "-mmcu=atmega2560 -DF_CPU=16000000UL -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections")
# variables by their alignment: what is aligned to 256 bytes leaves one gap in the RAM, not several
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mmcu=atmega2560 -Wl,--gc-sections -Wl,--sort-section=alignment")
