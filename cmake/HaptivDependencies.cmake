# Where the libraries come from: Debian 12's packages, listed in packages.txt.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(LIBUSB REQUIRED IMPORTED_TARGET libusb-1.0>=1.0.26)

if(HAPTIV_SESSION)
  # A plain file name in a list of its own: HDF5's CMake package is not in Debian's libhdf5-dev.
  pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial)
endif()

if(HAPTIV_SCENEGRAPH)
  find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
  find_package(Coin CONFIG REQUIRED)
endif()

if(HAPTIV_APPLICATION)
  find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets OpenGL)
  find_package(SoQt CONFIG REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_path(QWT_INCLUDE_DIR qwt_plot.h PATH_SUFFIXES qwt REQUIRED)
  find_library(QWT_LIBRARY qwt-qt5 REQUIRED)
  add_library(Qwt::Qwt INTERFACE IMPORTED)
  target_include_directories(Qwt::Qwt SYSTEM INTERFACE ${QWT_INCLUDE_DIR})
  target_link_libraries(Qwt::Qwt INTERFACE ${QWT_LIBRARY} Qt5::Widgets)
endif()
