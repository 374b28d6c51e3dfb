# All third-party libraries (docs/decisions says why these). Only what is used is linked, because a VTK reader costs start-up time.
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(glm REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Freetype REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Boost 1.74 REQUIRED)  # Only headers: Asio and Beast.
find_package(OpenSSL REQUIRED)
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel IOXML IOLegacy IOGeometry IOPLY
    IOImage IOEnSight IOParallelXML IOXMLParser FiltersCore FiltersGeometry FiltersGeneral)
find_package(PkgConfig REQUIRED)
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)
pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET libwebp libwebpmux)
# The serial one, which Debian's VTK and netCDF are built with. The names keep out of the way of VTK's own search for it.
pkg_check_modules(HDF5_SERIAL REQUIRED IMPORTED_TARGET hdf5-serial)
pkg_check_modules(NETCDF_C REQUIRED IMPORTED_TARGET netcdf)
find_path(CGNS_IO_INCLUDE_DIR cgns_io.h REQUIRED)
find_library(CGNS_LIBRARY cgns REQUIRED)

# Headers alone: what reads files and the tests include them.
add_library(aeolic_hdf5_headers INTERFACE)
target_include_directories(aeolic_hdf5_headers SYSTEM INTERFACE ${HDF5_SERIAL_INCLUDE_DIRS})
add_library(aeolic_dependencies INTERFACE)
target_link_libraries(aeolic_dependencies INTERFACE Threads::Threads TBB::tbb PkgConfig::HWY spdlog::spdlog
    nlohmann_json::nlohmann_json CLI11::CLI11 Freetype::Freetype PkgConfig::TURBOJPEG PkgConfig::LZ4 PkgConfig::WEBP aeolic_hdf5_headers PNG::PNG ZLIB::ZLIB
    Boost::headers OpenSSL::SSL OpenSSL::Crypto
    VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::FiltersCore VTK::FiltersGeometry VTK::FiltersGeneral)
# What opens files of data needs more. Only aeolic-reader is linked with it.
add_library(aeolic_reading_dependencies INTERFACE)
target_link_libraries(aeolic_reading_dependencies INTERFACE PkgConfig::NETCDF_C PkgConfig::HDF5_SERIAL ${CGNS_LIBRARY} ${VTK_LIBRARIES})
# src/stream/beast.cpp compiles once what is not a template in Asio and Beast.
target_compile_definitions(aeolic_dependencies INTERFACE BOOST_ASIO_SEPARATE_COMPILATION BOOST_BEAST_SEPARATE_COMPILATION)

# LZO is under the GPL, and a program built with it is, too (docs/decisions/0010-lzo.md). So it is never on by default.
option(AEOLIC_LZO "Tiles by LZO too, as in the paper: the built program is then under the GNU General Public License" OFF)
if(AEOLIC_LZO)
    pkg_check_modules(LZO REQUIRED IMPORTED_TARGET lzo2)
    target_link_libraries(aeolic_dependencies INTERFACE PkgConfig::LZO)
endif()

# Only src/cluster/comm/mpi_communicator.cpp includes MPI, and it uses the C interface alone.
if(NOT DEFINED AEOLIC_MPI OR AEOLIC_MPI)
    find_package(MPI COMPONENTS C)
endif()
option(AEOLIC_MPI "Run on many ranks, with MPI (default: ON where MPI is found)" ${MPI_C_FOUND})
if(AEOLIC_MPI AND NOT MPI_C_FOUND)
    message(FATAL_ERROR "AEOLIC_MPI is ON, but no MPI was found: install libopenmpi-dev or libmpich-dev, or set -DAEOLIC_MPI=OFF")
endif()

# Only src/render/gl includes OpenGL. libepoxy finds libGL and libEGL when the program runs, so neither is linked.
if(NOT DEFINED AEOLIC_GL OR AEOLIC_GL)
    pkg_check_modules(EPOXY IMPORTED_TARGET epoxy egl)
endif()
option(AEOLIC_GL "Draw on GPUs, with OpenGL through EGL (default: ON where libepoxy and EGL are found)" ${EPOXY_FOUND})
if(AEOLIC_GL AND NOT EPOXY_FOUND)
    message(FATAL_ERROR "AEOLIC_GL is ON, but no libepoxy with EGL was found: install libepoxy-dev and libegl-dev, or set -DAEOLIC_GL=OFF")
endif()

# Only python/ uses pybind11. The interpreter is the first with numpy: Debian's own may stand behind another on the path.
# With the address sanitizer its runtime has to be in the interpreter before all else, and the C++ library with it: the
# sanitizer looks for its functions when it starts. The thread sanitizer would need an interpreter of its own.
if((NOT DEFINED AEOLIC_PYTHON OR AEOLIC_PYTHON) AND NOT AEOLIC_SANITIZE MATCHES "thread")
    foreach(program ${AEOLIC_PYTHON_PROGRAM} python3 /usr/bin/python3)
        execute_process(COMMAND ${program} -c "import numpy, sys; print(sys.executable)" OUTPUT_VARIABLE executable
            OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE result ERROR_QUIET)
        if(result EQUAL 0)
            set(Python_EXECUTABLE ${executable})
            find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
            find_package(pybind11 2.10 CONFIG QUIET)
            break()
        endif()
    endforeach()
    if(Python_FOUND AND pybind11_FOUND)
        set(AEOLIC_PYTHON_FOUND ON)
    endif()
    if(AEOLIC_SANITIZE)
        foreach(library asan stdc++)
            execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=lib${library}.so OUTPUT_VARIABLE file
                OUTPUT_STRIP_TRAILING_WHITESPACE)
            list(APPEND AEOLIC_PYTHON_PRELOADED ${file})
        endforeach()
        list(JOIN AEOLIC_PYTHON_PRELOADED ":" AEOLIC_PYTHON_PRELOADED)
        # What Python keeps to its end would look like leaks.
        set(AEOLIC_PYTHON_ENVIRONMENT LD_PRELOAD=${AEOLIC_PYTHON_PRELOADED} ASAN_OPTIONS=detect_leaks=0:quarantine_size_mb=32
            AEOLIC_SANITIZED=1)
    endif()
endif()
option(AEOLIC_PYTHON "The Python module (default: ON where Python's headers, numpy and pybind11 are found, and without the thread sanitizer)" ${AEOLIC_PYTHON_FOUND})
if(AEOLIC_PYTHON AND NOT AEOLIC_PYTHON_FOUND)
    message(FATAL_ERROR "AEOLIC_PYTHON is ON, but Python 3.9 with headers, numpy or pybind11 is missing, or there is the thread sanitizer: install python3-dev, python3-numpy and pybind11-dev, or set -DAEOLIC_PYTHON=OFF")
elseif(NOT AEOLIC_PYTHON)
    message(STATUS "The Python module is left out: AEOLIC_PYTHON is OFF, Python's headers, numpy or pybind11 are missing, or there is the thread sanitizer")
endif()
