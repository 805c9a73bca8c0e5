# What every target of the project is compiled with. Link haptiv_options; nothing is set globally.
add_library(haptiv_options INTERFACE)
target_compile_features(haptiv_options INTERFACE cxx_std_20)
target_include_directories(haptiv_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(haptiv_options INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>  # what another file declares is no shadow
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 sees overlaps in std::string that are none (PR 105651)
  -ffp-contract=off  # the same bits from every build: a log must re-simulate
  -fno-math-errno)  # nobody asks errno about a square root
if(HAPTIV_WARNINGS_AS_ERRORS)
  target_compile_options(haptiv_options INTERFACE -Werror)
endif()
if(HAPTIV_SANITIZE)
  target_compile_options(haptiv_options INTERFACE
    -fsanitize=${HAPTIV_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(haptiv_options INTERFACE -fsanitize=${HAPTIV_SANITIZE})
endif()

# haptiv_unity(TARGET): its sources are compiled some folders at a time, as most of a compiler's time goes to the headers and
# templates they share; a folder stays in one piece. What stands in an anonymous namespace is then seen by all of the target.
function(haptiv_unity target)
  set(most_sources 16)  # more take more memory than time is saved
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(folders "")
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "in_${folder}" folder)
    list(APPEND folders ${folder})
    list(APPEND ${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  list(SORT folders)
  set(group 1)
  set(taken 0)
  foreach(folder IN LISTS folders)
    list(LENGTH ${folder} count)
    math(EXPR taken "${taken} + ${count}")
    if(taken GREATER most_sources AND taken GREATER count)
      math(EXPR group "${group} + 1")
      set(taken ${count})
    endif()
    set_source_files_properties(${${folder}} PROPERTIES UNITY_GROUP part_${group})
  endforeach()
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# haptiv_library(NAME SOURCES ... LINK ...): one static library per folder.
function(haptiv_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  if(HAPTIV_UNITY)
    haptiv_unity(${name})
  endif()
  target_link_libraries(${name} PUBLIC haptiv_options ${ARG_LINK})
endfunction()
