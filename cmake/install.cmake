# Where things go, how another project finds them (find_package(Aeolic)), and the Debian packages.
# The library is shared: a project that uses it needs only its headers, and none of the libraries it is built from.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME aeolic)  # All but the Python module, which is a package of its own.
set(AEOLIC_DOC_DIR ${CMAKE_INSTALL_DATAROOTDIR}/doc/aeolic)
set(AEOLIC_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Aeolic)
file(RELATIVE_PATH AEOLIC_LIB_FROM_BIN ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(aeolic aeolic_bench PROPERTIES INSTALL_RPATH "$ORIGIN/${AEOLIC_LIB_FROM_BIN}")  # The tree can be moved.

install(TARGETS aeolic aeolic_bench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS aeolic_reader aeolic_reader_hdf5 aeolic_reader_vtk RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/aeolic
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/aeolic)
install(FILES ${AEOLIC_PAGES} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${AEOLIC_MANUAL_DIR}/aeolic.bash DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions RENAME aeolic)
install(FILES ${AEOLIC_MANUAL_DIR}/_aeolic DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/zsh/vendor-completions)
install(TARGETS aeolic_lib EXPORT AeolicTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/aeolic DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES README.md CHANGELOG.md NOTICE DESTINATION ${AEOLIC_DOC_DIR})
install(FILES LICENSE DESTINATION ${AEOLIC_DOC_DIR} RENAME copyright)
install(DIRECTORY LICENSES/ DESTINATION ${AEOLIC_DOC_DIR}/licenses)  # The licences that NOTICE names.

if(AEOLIC_PYTHON)
    set(AEOLIC_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where Python looks for modules, below the prefix")
    cmake_path(ABSOLUTE_PATH AEOLIC_PYTHON_DIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE AEOLIC_PYTHON_FULL_DIR)
    file(RELATIVE_PATH AEOLIC_LIB_FROM_PYTHON ${AEOLIC_PYTHON_FULL_DIR}/aeolic ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(aeolic_python PROPERTIES INSTALL_RPATH "$ORIGIN/${AEOLIC_LIB_FROM_PYTHON}")
    install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/python3-aeolic RENAME copyright COMPONENT python)
    install(TARGETS aeolic_python LIBRARY DESTINATION ${AEOLIC_PYTHON_DIR}/aeolic COMPONENT python)
    install(DIRECTORY python/aeolic/ DESTINATION ${AEOLIC_PYTHON_DIR}/aeolic COMPONENT python FILES_MATCHING PATTERN "*.py" PATTERN "py.typed")
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/python/aeolic/__init__.pyi DESTINATION ${AEOLIC_PYTHON_DIR}/aeolic COMPONENT python)
endif()

install(EXPORT AeolicTargets NAMESPACE Aeolic:: DESTINATION ${AEOLIC_CMAKE_DIR})
configure_package_config_file(cmake/AeolicConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/AeolicConfig.cmake
    INSTALL_DESTINATION ${AEOLIC_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/AeolicConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/AeolicConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/AeolicConfigVersion.cmake
    DESTINATION ${AEOLIC_CMAKE_DIR})

# cpack -G DEB, in the build folder.
set(CPACK_PACKAGE_NAME aeolic)
set(CPACK_PACKAGE_CONTACT "The Aeolic authors <aeolic@example.org>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DESCRIPTION "Covers a curved surface with a dense streak texture that follows a vector field (line integral
convolution): wall shear stress on a car body, velocity on a slice, any field on an isosurface.
Reads VTK files and writes PNG. Contains the program, another one that measures it, the C++ library and its headers.")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_CURRENT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL aeolic)
set(CPACK_DEBIAN_AEOLIC_PACKAGE_NAME aeolic)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # Depends on exactly the packages its libraries come from.
if(AEOLIC_GL)
    set(CPACK_DEBIAN_AEOLIC_PACKAGE_RECOMMENDS "libegl1")  # Looked for when the program runs. Without it the processor draws.
endif()
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
if(AEOLIC_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
    math(EXPR AEOLIC_NEXT_PYTHON "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-aeolic)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Flow drawn on surfaces: the Python module
import aeolic draws flow on surfaces from files and from numpy arrays.")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "aeolic (= ${PROJECT_VERSION}), python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${AEOLIC_NEXT_PYTHON}), python3-numpy")
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_CURRENT_BINARY_DIR})  # The library is in the other package.
endif()
include(CPack)
