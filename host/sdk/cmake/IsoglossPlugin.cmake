# isogloss_add_plugin(<name> [SOURCES <file>...] [LIBRARIES <target>...])
#
# A plugin <name>.so that exports ig_plugin_v1 alone, from the sources given or from every *.cpp beside the CMakeLists and below it
# (tests, *_test.cpp, excepted). Every *.md there is embedded, to be found by ig::embedded_page("file_name_stem").
# The plugin goes to plugins/ in the build tree and to lib/isogloss/plugins when installed.
#
# The objects are a target of their own, <name>_objects, so that unit tests can link them.

function(isogloss_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "isogloss_add_plugin(${name}): what is ${arg_UNPARSED_ARGUMENTS}?")
  endif()
  set(tools ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  if(NOT arg_SOURCES)
    file(GLOB_RECURSE arg_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    list(FILTER arg_SOURCES EXCLUDE REGEX "_test\\.cpp$")
  endif()
  file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.md)

  set(embedded ${CMAKE_CURRENT_BINARY_DIR}/${name}_pages.cpp)
  add_custom_command(
    OUTPUT ${embedded}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${embedded} -D ROOT=${CMAKE_CURRENT_SOURCE_DIR} -D "PAGES=${pages}" -P ${tools}/EmbedPages.cmake
    DEPENDS ${pages} ${tools}/EmbedPages.cmake
    COMMENT "Embedding the pages of ${name}"
    VERBATIM)

  # A page that was edited costs no syntax another compilation.
  set_source_files_properties(${embedded} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

  add_library(${name}_objects OBJECT ${arg_SOURCES} ${embedded})
  target_link_libraries(${name}_objects PUBLIC isogloss::sdk ${arg_LIBRARIES})
  target_include_directories(${name}_objects PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  set_target_properties(
    ${name}_objects PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden
                               VISIBILITY_INLINES_HIDDEN ON)
  # A unique symbol would be shared by all plugins of a process and would keep a library from being unloaded.
  target_compile_options(${name}_objects PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)

  # Hidden visibility still lets templates of libstdc++ out; the version script does not.
  add_library(${name} MODULE)
  target_link_libraries(${name} PRIVATE ${name}_objects)
  target_link_options(${name} PRIVATE -Wl,-z,defs -Wl,-z,now -Wl,--version-script=${tools}/plugin.map)
  set_target_properties(
    ${name} PROPERTIES PREFIX "" SUFFIX ".so" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plugins
                       LINKER_LANGUAGE CXX LINK_DEPENDS ${tools}/plugin.map)
  add_custom_command(
    TARGET ${name}
    POST_BUILD
    COMMAND ${CMAKE_COMMAND} -D NM=${CMAKE_NM} -D PLUGIN=$<TARGET_FILE:${name}> -P
            ${tools}/CheckExports.cmake
    VERBATIM)

  install(TARGETS ${name} LIBRARY DESTINATION lib/isogloss/plugins)
endfunction()
