// Memory that libraries keep until the program ends; without this, LeakSanitizer fails every test that draws.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\nleak:libfontconfig\nleak:libgallium\n";
}
