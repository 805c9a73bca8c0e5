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

# haptiv_unity(TARGET): its sources are compiled a folder at a time, as most of a compiler's time goes to the headers they
# share. What stands in an anonymous namespace is then seen by its neighbours in the folder too.
function(haptiv_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${target}/${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# haptiv_library(NAME [SEPARATE] SOURCES ... LINK ...): one static library per folder. SEPARATE: each source is compiled by
# itself, as neighbours use one name for different things.
function(haptiv_library name)
  cmake_parse_arguments(ARG "SEPARATE" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  if(HAPTIV_UNITY AND NOT ARG_SEPARATE)
    haptiv_unity(${name})
  endif()
  target_link_libraries(${name} PUBLIC haptiv_options ${ARG_LINK})
endfunction()
