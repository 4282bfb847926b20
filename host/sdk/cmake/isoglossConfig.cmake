# find_package(isogloss): isogloss::sdk and isogloss_add_plugin() for plugins, isogloss::engine for programs.
include(CMakeFindDependencyMacro)
find_dependency(fmt)
find_dependency(nlohmann_json)
find_dependency(pugixml)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/isoglossTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/IsoglossPlugin.cmake)
