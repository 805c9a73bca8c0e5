// What ThreadSanitizer is not to tell of libusb, which is not compiled under it: a transfer's memory is freed by the
// thread that got it back, which libusb orders by means that the sanitizer does not see.
extern "C" const char* __tsan_default_suppressions() {
  return "race:libusb_free_transfer\n";
}
