# isogloss_add_unit_tests(<component> LIBRARIES <target>...)
#
# One program, <component>_tests, from every *_test.cpp below the current folder; one ctest of the same name. The tests
# see the source and build trees as ISOGLOSS_SOURCE_DIR and ISOGLOSS_BUILD_DIR.
function(isogloss_add_unit_tests component)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *_test.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${component}_tests EXCLUDE_FROM_ALL ${sources})
  add_dependencies(isogloss_test_programs ${component}_tests)
  target_link_libraries(${component}_tests PRIVATE isogloss_test_main ${arg_LIBRARIES})
  # What is tested is compiled as it ships; the tests themselves need lines, not speed. Sanitizers and -O1 together cost
  # g++ almost three times as long as -O0.
  target_compile_options(${component}_tests PRIVATE $<IF:$<BOOL:${ISOGLOSS_SANITIZE}>,-O0,-O1> -g1
                                                        ${ISOGLOSS_FEWER_CHECKS})
  target_include_directories(${component}_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_definitions(${component}_tests PRIVATE ISOGLOSS_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                        ISOGLOSS_BUILD_DIR="${PROJECT_BINARY_DIR}")
  add_test(NAME ${component}_tests COMMAND ${component}_tests WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
endfunction()
