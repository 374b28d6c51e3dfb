# aeolic_add_suites(TARGET [PROPERTIES …] [LONG_PROPERTIES …])
#
# A test of CTest for each suite of a GoogleTest program: `HubScene` runs all cases HubScene.*. Most cases take a
# millisecond, and to start the program takes thirty. What fails is still told by its case: the output of the suite names
# each case before it runs. gtest_discover_tests() would make a test for each case.
#
# Suites whose name ends in Long get LONG_PROPERTIES, all others PROPERTIES. A suite that ends with 77 was skipped.
#
# This file is also the script that asks the program for its suites once it is built.
if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(AEOLIC_SUITES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

    function(aeolic_add_suites target)
        cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "PROPERTIES;LONG_PROPERTIES")
        set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
        string(REPLACE ";" "\\;" properties "${arg_PROPERTIES}")
        string(REPLACE ";" "\\;" longProperties "${arg_LONG_PROPERTIES}")
        add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${list} VERBATIM
            COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DLIST=${list} "-DPROPERTIES=${properties}"
                "-DLONG_PROPERTIES=${longProperties}" -P ${AEOLIC_SUITES_SCRIPT})
        # What CTest reads. A program that is not built yet is a test that fails, as with gtest_discover_tests().
        set(include ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
        file(WRITE ${include} "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n"
            "  add_test(${target}_NOT_BUILT ${target}_NOT_BUILT)\nendif()\n")
        set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
    endfunction()
    return()
endif()

execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE output ERROR_VARIABLE error RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests ended with ${result}:\n${output}${error}")
endif()
# A line of a suite is `Name.` or `Name.  # TypeParam = …`. Those of its cases begin with spaces.
string(REGEX MATCHALL "(^|\n)[^ \n]+\\.(  #[^\n]*)?" lines "${output}")
if(NOT lines)
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests lists no suite")
endif()
set(text "")
foreach(line IN LISTS lines)
    string(REGEX REPLACE "\n|\\.(  #.*)?$" "" suite "${line}")
    string(APPEND text "add_test([=[${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])\n")
    set(properties SKIP_RETURN_CODE 77 ${PROPERTIES})
    if(suite MATCHES "Long$")
        set(properties SKIP_RETURN_CODE 77 ${LONG_PROPERTIES})
    endif()
    list(TRANSFORM properties REPLACE "(.+)" "[=[\\1]=]")
    list(JOIN properties " " properties)
    string(APPEND text "set_tests_properties([=[${suite}]=] PROPERTIES ${properties})\n")
endforeach()
file(WRITE ${LIST} "${text}")
