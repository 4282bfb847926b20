# isogloss_add_plugin(<name> [LANGUAGE C] [SOURCES <file>...] [LIBRARIES <target>...])
#
# A plugin <name>.so that exports ig_plugin_v1 alone, from the sources given or from every *.cpp beside the CMakeLists
# and below it, except tests (*_test.cpp) and whatever lies in a build tree. Every *.md there is embedded, to be found by
# ig::embedded_page("file_name_stem"). The plugin goes to plugins/ in the build tree and to lib/isogloss/plugins when
# installed.
#
# LANGUAGE C: the sources are *.c, no C++ compiler is needed, each page is an array <file_name_stem>_page, and libm is
# linked, which <isogloss/c/canned_cycle.h> needs.
#
# The objects are a target of their own, <name>_objects, so that unit tests can link them.

# The files of a list that lie in no build tree: `cmake -B build` beside the sources puts generated ones below them.
function(isogloss_without_build_trees variable)
  set(trees ${CMAKE_BINARY_DIR})
  file(GLOB_RECURSE caches ${CMAKE_CURRENT_SOURCE_DIR}/CMakeCache.txt)
  foreach(cache IN LISTS caches)
    cmake_path(GET cache PARENT_PATH tree)
    list(APPEND trees ${tree})
  endforeach()
  set(kept "")
  foreach(file IN LISTS ${variable})
    set(is_built FALSE)
    foreach(tree IN LISTS trees)
      cmake_path(IS_PREFIX tree "${file}" NORMALIZE is_in_tree)
      if(is_in_tree)
        set(is_built TRUE)
      endif()
    endforeach()
    if(NOT is_built)
      list(APPEND kept ${file})
    endif()
  endforeach()
  set(${variable} ${kept} PARENT_SCOPE)
endfunction()

function(isogloss_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LANGUAGE" "SOURCES;LIBRARIES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "isogloss_add_plugin(${name}): what is ${arg_UNPARSED_ARGUMENTS}?")
  endif()
  set(tools ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  set(language CXX)
  set(extension cpp)
  set(embed EmbedPages.cmake)
  set(sdk isogloss::sdk)
  if(arg_LANGUAGE STREQUAL "C")
    set(language C)
    set(extension c)
    set(embed EmbedPagesInC.cmake)
    set(sdk m)  # isogloss::sdk asks for C++20
  elseif(arg_LANGUAGE AND NOT arg_LANGUAGE STREQUAL "CXX")
    message(FATAL_ERROR "isogloss_add_plugin(${name}): LANGUAGE is C or CXX, not ${arg_LANGUAGE}")
  endif()
  set_property(GLOBAL PROPERTY ISOGLOSS_BUILDS_PLUGINS TRUE)
  set_property(GLOBAL APPEND PROPERTY ISOGLOSS_PLUGINS ${name})
  if(NOT arg_SOURCES)
    file(GLOB_RECURSE arg_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.${extension})
    list(FILTER arg_SOURCES EXCLUDE REGEX "_test\\.${extension}$")
    isogloss_without_build_trees(arg_SOURCES)
  endif()
  file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.md)
  isogloss_without_build_trees(pages)

  set(embedded ${CMAKE_CURRENT_BINARY_DIR}/${name}_pages.${extension})
  add_custom_command(
    OUTPUT ${embedded}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${embedded} -D ROOT=${CMAKE_CURRENT_SOURCE_DIR} -D "PAGES=${pages}" -P ${tools}/${embed}
    DEPENDS ${pages} ${tools}/${embed}
    COMMENT "Embedding the pages of ${name}"
    VERBATIM)

  # A page that was edited costs no syntax another compilation.
  set_source_files_properties(${embedded} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

  add_library(${name}_objects OBJECT ${arg_SOURCES} ${embedded})
  target_link_libraries(${name}_objects PUBLIC ${sdk} ${arg_LIBRARIES})
  target_include_directories(
    ${name}_objects PUBLIC ${CMAKE_CURRENT_SOURCE_DIR} $<TARGET_PROPERTY:isogloss::sdk,INTERFACE_INCLUDE_DIRECTORIES>)
  set_target_properties(
    ${name}_objects PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden
                               VISIBILITY_INLINES_HIDDEN ON)
  # A unique symbol would be shared by all plugins of a process and would keep a library from being unloaded.
  target_compile_options(${name}_objects PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)

  # Hidden visibility still lets templates of libstdc++ out; the version script does not.
  add_library(${name} MODULE)
  target_link_libraries(${name} PRIVATE ${name}_objects)
  target_link_options(${name} PRIVATE -Wl,-z,now -Wl,--version-script=${tools}/plugin.map)
  # What the sanitizers of clang call is in the executable alone.
  if(NOT ISOGLOSS_SANITIZE OR NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_link_options(${name} PRIVATE -Wl,-z,defs)
  endif()
  set_target_properties(
    ${name} PROPERTIES PREFIX "" SUFFIX ".so" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plugins
                       LINKER_LANGUAGE ${language} LINK_DEPENDS ${tools}/plugin.map)
  add_custom_command(
    TARGET ${name}
    POST_BUILD
    COMMAND ${CMAKE_COMMAND} -D NM=${CMAKE_NM} -D PLUGIN=$<TARGET_FILE:${name}> -P
            ${tools}/CheckExports.cmake
    VERBATIM)

  install(TARGETS ${name} LIBRARY DESTINATION lib/isogloss/plugins)
endfunction()
