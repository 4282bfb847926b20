# cmake -D COMMAND=isogloss -D PROGRAM=part.nc -D DIALECT=acme -D EXPECTED=part.expected [-D SECTION=Acme]
# -D "PLACES=--dialects|DIR" -P RunAndCompare.cmake: what comes of a program against what is expected; with ISOGLOSS_UPDATE in the environment the
# file is written instead.
cmake_minimum_required(VERSION 3.25)

string(REPLACE "|" ";" PLACES "${PLACES}")
set(emit motions --format csv)
if(SECTION)
  set(emit blocks)
endif()
cmake_path(GET PROGRAM PARENT_PATH folder)
cmake_path(GET PROGRAM FILENAME program)
execute_process(
  COMMAND ${COMMAND} run ${program} -d ${DIALECT} ${PLACES} --emit ${emit}
  WORKING_DIRECTORY ${folder}
  RESULT_VARIABLE status
  OUTPUT_VARIABLE seen
  ERROR_VARIABLE diagnostics)
if(NOT status MATCHES "^[01]$")
  message(FATAL_ERROR "${COMMAND} could not run ${program} (${status}):\n${diagnostics}")
endif()

# One line a block: what the section holds, or a hyphen.
if(SECTION)
  string(REPLACE ";" "," seen "${seen}")
  string(REGEX MATCHALL "[^\n]+" blocks "${seen}")
  set(seen "")
  foreach(block IN LISTS blocks)
    set(held "-")
    if(block MATCHES "\"${SECTION}\": *({[^{}]*})")
      set(held "${CMAKE_MATCH_1}")
    endif()
    string(APPEND seen "${held}\n")
  endforeach()
endif()
string(APPEND seen "${diagnostics}")

if(DEFINED ENV{ISOGLOSS_UPDATE})
  file(WRITE ${EXPECTED} "${seen}")
  message(STATUS "written: ${EXPECTED}")
  return()
endif()
file(READ ${EXPECTED} expected)
if(NOT seen STREQUAL expected)
  message(FATAL_ERROR "${program} gives something else than ${EXPECTED}\n--- expected\n${expected}--- seen\n${seen}")
endif()
