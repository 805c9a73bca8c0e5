// What ThreadSanitizer is not to tell of libraries that are not compiled under it: the order that they keep, it does
// not see. libusb frees a transfer's memory in the thread that got it back; umockdev's testbed, with glib, hands names
// to a thread of its own; both it and libusb ask udev, which draws random numbers once for the program.
extern "C" const char* __tsan_default_suppressions() {
  return "race:libusb_free_transfer\n"
         "race:libumockdev.so\n"
         "race:libglib-2.0.so\n"
         "race:libudev.so\n";
}
