"""How the tests of this folder run: suite.main() in place of unittest.main(), or several files by `suite.py FILE …`.

Half of what these tests take is waiting: for a limit of the server's to pass, for pauses between starts. Those are marked with @waits and
run beside the others, each in a process of its own, by the command that a person types: FILE CLASS.TEST. All others run
one after the other. A test that takes far too long is ended with the line that it stands at.
"""
import concurrent.futures
import importlib
import os
import signal
import subprocess
import sys
import time
import unittest

from server import SLOW

MOST_SECONDS = 120  # Four times what the longest takes.
BESIDE = 8 if SLOW == 1 else 2  # So many wait at once. Sanitizers leave little time to others.


def waits(seconds):
    """Marks a test that waits for about so long and takes next to no processor. The longest start first."""
    def mark(test):
        test.waits = seconds
        return test
    return mark


class Result(unittest.TextTestResult):
    """Says at the end of each test how long it took, and ends one that takes too long."""

    def startTest(self, test):
        super().startTest(test)
        self.started = time.monotonic()
        signal.setitimer(signal.ITIMER_REAL, MOST_SECONDS * SLOW)

    def stopTest(self, test):
        signal.setitimer(signal.ITIMER_REAL, 0)
        self.stream.writeln(f"  {time.monotonic() - self.started:.1f} s")
        super().stopTest(test)


def late(*_):
    raise TimeoutError(f"the test took more than {MOST_SECONDS * SLOW:g} s")


def cases(tests):
    for test in tests:
        if isinstance(test, unittest.TestSuite):
            yield from cases(test)
        else:
            yield test


def words_of(test):
    """The file and the name to run it by."""
    return [os.path.abspath(sys.modules[type(test).__module__].__file__), f"{type(test).__name__}.{test._testMethodName}"]


def wait_of(test):
    return getattr(getattr(test, test._testMethodName), "waits", 0)


def alone(test):
    """The test in a process of its own: whether it passed, and what it said."""
    flags = [word for option in sys.warnoptions for word in ("-W", option)]
    result = subprocess.run([sys.executable, *flags, *words_of(test)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            stdin=subprocess.DEVNULL, text=True, errors="replace")
    return result.returncode == 0, result.stdout


def run(modules):
    """All tests of these modules. Returns whether they passed."""
    tests = [test for module in modules for test in cases(unittest.defaultTestLoader.loadTestsFromModule(module))]
    waiting = sorted(filter(wait_of, tests), key=wait_of, reverse=True)
    others = [test for test in tests if not wait_of(test)]
    with concurrent.futures.ThreadPoolExecutor(BESIDE) as pool:
        beside = [pool.submit(alone, test) for test in waiting]
        passed = RUNNER.run(unittest.TestSuite(others)).wasSuccessful()
        for test, done in zip(waiting, beside):
            fine, said = done.result()
            failed = "" if fine else "FAILED: " + " ".join(words_of(test))
            print(said.split("\n---", 1)[0].rstrip() if fine else said + failed, file=sys.stderr, flush=True)
            passed = passed and fine
    print(f"{len(tests)} tests, {len(waiting)} of them beside others: {'OK' if passed else 'FAILED'}", file=sys.stderr)
    return passed


RUNNER = unittest.TextTestRunner(resultclass=Result, verbosity=2)


def main():
    """For a file of tests. Words name single tests, which then run in order."""
    signal.signal(signal.SIGALRM, late)
    if len(sys.argv) > 1:
        unittest.main(testRunner=RUNNER)
    sys.exit(0 if run([sys.modules["__main__"]]) else 1)


if __name__ == "__main__":
    signal.signal(signal.SIGALRM, late)
    sys.exit(0 if run([importlib.import_module(name) for name in sys.argv[1:]]) else 1)
