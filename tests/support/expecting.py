"""What a script expects. It goes on after a failure, so that all of them are printed, and ends with end()."""
import sys

failures = 0


def expect(condition, otherwise):
    global failures
    if not condition:
        failures += 1
        print(otherwise)


def end():
    sys.exit(1 if failures else 0)
