# Tests of a plugin or a dialect, which `ctest` runs with the command of the installation. Plugins of the project are
# found where isogloss_add_plugin() builds them, its dialects in the folder dialects.
#
# isogloss_add_page_tests(): the cases of every page (*.md with #AfterBuild:) of this folder and below it.
#
# isogloss_add_dialect_test(<dialect>): the dialect links without an error.
#
# isogloss_add_validate_test(<plugin>): the plugin keeps the contract (isogloss validate --strict: what a plugin must and
# what it should do), with fewer random blocks than by hand. So each syntax needs a page with a case.
#
# isogloss_add_program_test(<name> DIALECT <dialect> [PROGRAM <file>] [SECTION <section>])
#
# Runs the program (by default the only tests/<name>.* beside the expected file) and compares its motions, or one section
# of each block, and its diagnostics with tests/<name>.expected. The target update-<name> writes that file anew.

find_program(ISOGLOSS_COMMAND isogloss HINTS ${CMAKE_CURRENT_LIST_DIR}/../../../bin DOC "The command isogloss")

# The options by which the command finds the plugins and dialects of this project.
function(isogloss_places variable)
  if(NOT ISOGLOSS_COMMAND)
    message(FATAL_ERROR "the command isogloss is not found: set ISOGLOSS_COMMAND to its path")
  endif()
  set(places "")
  get_property(builds_plugins GLOBAL PROPERTY ISOGLOSS_BUILDS_PLUGINS)
  if(builds_plugins)
    list(APPEND places --plugins ${PROJECT_BINARY_DIR}/plugins)
  endif()
  if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/dialects)
    list(APPEND places --dialects ${CMAKE_CURRENT_SOURCE_DIR}/dialects)
  endif()
  set(${variable} ${places} PARENT_SCOPE)
endfunction()

function(isogloss_add_page_tests)
  isogloss_places(places)
  file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.md)
  isogloss_without_build_trees(pages)
  foreach(page IN LISTS pages)
    file(STRINGS ${page} cases REGEX "^#(AfterBuild|Tables):")
    if(cases)
      cmake_path(GET page STEM LAST_ONLY stem)
      add_test(NAME page.${stem} COMMAND ${ISOGLOSS_COMMAND} case ${page} ${places})
    endif()
  endforeach()
endfunction()

function(isogloss_add_dialect_test dialect)
  isogloss_places(places)
  add_test(NAME dialect.${dialect} COMMAND ${ISOGLOSS_COMMAND} lint ${dialect} ${places})
endfunction()

function(isogloss_add_validate_test plugin)
  isogloss_places(places)  # reports a command that is missing
  add_test(NAME validate.${plugin} COMMAND ${ISOGLOSS_COMMAND} validate $<TARGET_FILE:${plugin}> --strict --blocks 5000)
endfunction()

function(isogloss_add_program_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DIALECT;PROGRAM;SECTION" "")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_DIALECT)
    message(FATAL_ERROR "isogloss_add_program_test(${name}): DIALECT is needed, and ${arg_UNPARSED_ARGUMENTS} is not known")
  endif()
  set(expected ${CMAKE_CURRENT_SOURCE_DIR}/tests/${name}.expected)
  if(NOT arg_PROGRAM)
    file(GLOB arg_PROGRAM ${CMAKE_CURRENT_SOURCE_DIR}/tests/${name}.*)
    list(REMOVE_ITEM arg_PROGRAM ${expected})
  endif()
  isogloss_places(places)
  list(JOIN places "|" places)  # a list in a list would fall apart
  set(run ${CMAKE_COMMAND} -D COMMAND=${ISOGLOSS_COMMAND} -D PROGRAM=${arg_PROGRAM} -D DIALECT=${arg_DIALECT}
          -D SECTION=${arg_SECTION} -D EXPECTED=${expected} -D PLACES=${places} -P
          ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/RunAndCompare.cmake)
  add_test(NAME program.${name} COMMAND ${run})
  add_custom_target(update-${name} COMMAND ${CMAKE_COMMAND} -E env ISOGLOSS_UPDATE=1 ${run} VERBATIM)
endfunction()
