# A rank that fails ends the whole job, soon and with a status other than 0. A rank that aborts says so in one line.
# Variables: MPIEXEC (a list: the launcher and its options for three ranks), PROGRAM.
cmake_minimum_required(VERSION 3.25)

function(expectFailure what rank)
    string(TIMESTAMP start "%s")
    execute_process(COMMAND ${MPIEXEC} ${PROGRAM} ${what} ${rank} TIMEOUT 30
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    string(TIMESTAMP end "%s")
    math(EXPR seconds "${end} - ${start}")
    if(result EQUAL 0 OR seconds GREATER 5)
        message(FATAL_ERROR "${what} ${rank}: status ${result} after ${seconds} s; expected another than 0 within 5 s\n${output}")
    endif()
    string(REGEX MATCHALL "aeolic: [^\n]*" lines "${output}")
    set(lines "${lines}" PARENT_SCOPE)
endfunction()

foreach(rank 0 1 2)
    expectFailure(abort ${rank})
    if(NOT lines STREQUAL "aeolic: rank ${rank}: the piece wing.vti is missing")
        message(FATAL_ERROR "abort ${rank} said: ${lines}")
    endif()
    expectFailure(unwind ${rank})
    if(NOT lines STREQUAL "aeolic: out of luck")
        message(FATAL_ERROR "unwind ${rank} said: ${lines}")
    endif()
endforeach()
