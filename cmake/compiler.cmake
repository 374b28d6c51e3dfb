# How our own code is compiled. Tests, library and programs share one interface target, so their flags cannot differ.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
find_program(CCACHE ccache)
if(CCACHE)
    # Without these ccache refuses files that use a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
endif()

# Highway picks the widest instructions (AVX2, AVX-512) at run time. Processors older than this floor (2010) are not worth a
# code path.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(AEOLIC_BASELINE -march=x86-64-v2 -maes -mpclmul)
endif()

add_library(aeolic_options INTERFACE)
# Any split of the work must give the same bytes. So the compiler contracts nothing on its own, and fast-math is never used
# (docs/decisions).
# Without semantic interposition the compiler may inline the shared library's own functions.
target_compile_options(aeolic_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off -fno-semantic-interposition ${AEOLIC_BASELINE}
    # GCC 12 sees overlapping copies in std::string's own operator+ (GCC bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    # With -O1 it sees the same as reads beyond the array, depending on how long the path of the source is.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds>
    $<$<BOOL:${AEOLIC_WERROR}>:-Werror>)

# Code that runs once in a program's life, or once a message, is compiled with little optimisation in release builds too. That
# takes a third off its time. A later option overrides CMake's own -O3.
set(AEOLIC_QUICK_OPTIONS $<$<CONFIG:Release>:-O1>)

if(AEOLIC_SANITIZE)
    # A finding ends the program, because a test that only prints one would pass. Following variables through instrumented vector
    # code takes GCC half the time of a kernel; line numbers do without. More optimisation than -O1 takes a kernel three times as
    # long, and finds nothing more.
    target_compile_options(aeolic_options INTERFACE -fsanitize=${AEOLIC_SANITIZE} -fno-sanitize-recover=all
        -fno-omit-frame-pointer -O1 -g1 $<$<CXX_COMPILER_ID:GNU>:-fno-var-tracking>)
    target_link_options(aeolic_options INTERFACE -fsanitize=${AEOLIC_SANITIZE})
    # GCC takes minutes a file to instrument the widest vectors. The same source runs here with narrower ones.
    target_compile_definitions(aeolic_options INTERFACE "HWY_DISABLED_TARGETS=(HWY_AVX3|HWY_AVX3_DL)")
    if(AEOLIC_SANITIZE STREQUAL "thread")  # How wide vectors are changes nothing about who touches what.
        target_compile_definitions(aeolic_options INTERFACE HWY_COMPILE_ONLY_STATIC)
    endif()
endif()

# compile_together(TARGET PATTERNS…): those files of TARGET whose names match a pattern are compiled as one file. That saves
# reading the headers again for each of them. clang-tidy reads single files, and wants AEOLIC_TOGETHER off.
option(AEOLIC_TOGETHER "Compile groups of small files as one, which takes less time" ON)
function(compile_together target)
    if(NOT AEOLIC_TOGETHER)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # GCC takes each of the files for a header of the group, where unnamed namespaces would be a mistake.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    get_target_property(sources ${target} SOURCES)
    set(group 0)
    foreach(pattern ${ARGN})
        set(files ${sources})
        list(FILTER files INCLUDE REGEX ${pattern})
        set_source_files_properties(${files} PROPERTIES UNITY_GROUP ${target}${group})
        math(EXPR group "${group} + 1")
    endforeach()
endfunction()
