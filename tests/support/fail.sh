# For tests to read: fail WORDS... says why the test fails, and ends it.
fail() {
  echo "$*"
  exit 1
}
