// What ThreadSanitizer is not to tell of libraries that are not compiled under it. libusb frees a transfer's memory in
// the thread that got it back; umockdev's testbed hands names to a thread of its own. Both order it by means that the
// sanitizer does not see.
extern "C" const char* __tsan_default_suppressions() {
  return "race:libusb_free_transfer\nrace:libumockdev.so\n";
}
