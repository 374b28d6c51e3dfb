"""Damages small sound data files of every format and gives them to the real program. It must neither crash nor hang, must
exit with 0 or 2, and must say exactly one line about a file that it refuses.

Usage: mutate_files.py PROGRAM FOLDER [--seconds S | --files N] [--seed K] [--formats .vtp,.ply] [--processes P]
PROGRAM is aeolic_files (a target of the build). What fails stays in FOLDER/found: the file, and beside it a text with the
command. The same seed gives the same files. --files is the number for every format, --seconds the time for all together.
Ctrl-C ends it early, with the counts so far. It is fastest with FOLDER in memory (/dev/shm), and under `ulimit -v 2500000`:
a file that lies about its size then fails sooner."""
import argparse
import collections
import gzip
import os
import random
import re
import shutil
import subprocess
import sys
import threading
import time

MOST_MIB = 1024  # A file of a few kB that needs more was believed.
TOKENS = [b"-1", b"0", b"1", b"4294967295", b"99999999999", b"18446744073709551615", b"-9223372036854775808", b"nan",
          b"1e308", b'NumberOfPoints="1"', b'NumberOfComponents="3"', b'NumberOfTuples="7"', b'format="ascii"',
          b'format="appended"', b'offset="8"', b"POINTS", b"CELL_TYPES", b"POINT_DATA 5\n", b"FIELD a 3\n", b"VECTORS v float\n",
          b"LOOKUP_TABLE", b"METADATA\n", b"end_header\n", b"Float64", b"Int64", b"UInt8", b"String", b"Bit",
          b"element vertex 5\n", b"property float nx\n", b"property list uchar int vertex_indices\n", b"offsets",
          b"connectivity", b"faces", b"types", b"\n\n", b"\n", b" ", b"//", b"/", b"data file: LIST\n", b"%d%s%n", b"sizes: 1\n",
          b"</DataArray>", b"<DataArray>", b"=", b"AAAAAAAA", b"part", b"nfaced", b"block uniform", b"coordinates partial", b" undef"]
MAPS = (".json", ".xml", ".csv")
CASES = (".foam", ".case")  # Their data stand in other files of the same folder.
EXODUS = (".e", ".ex2", ".exo", ".exii")
VTKHDF = (".vtkhdf", ".hdf")
NETCDF = (".nc", ".nc4", ".cdf")
ADDRESSED = (".cgns",) + EXODUS + VTKHDF + NETCDF
NUMBERS = [0, 1, 2, 3, 4, 7, 12, 42, 255, 65535, 65536, 2**31 - 1, 2**31, 2**32, 2**40, 10**15, 2**63 - 1, -1, -5]


def place(data, rng):
    """Half of all places are near the front, where headers are."""
    if not data:
        return 0
    return rng.randrange(min(len(data), 1200) if rng.random() < .5 else len(data))


def change_number(data, rng):
    found = list(re.finditer(rb"\d+", bytes(data[:6000])))
    if not found:
        return
    chosen = rng.choice(found)
    was = int(chosen.group()[:18])
    data[chosen.start():chosen.end()] = str(rng.choice(NUMBERS + [was + 1, was - 1, was * 2, was // 2])).encode()


def change_word(data, rng):
    """A word of the file comes in the place of another, or a line again."""
    words = list(re.finditer(rb"[^\s<>\"]+", bytes(data[:6000])))
    if not words:
        return
    a, b = rng.choice(words), rng.choice(words)
    data[a.start():a.end()] = b.group()


def change_line(data, rng):
    lines = bytes(data).split(b"\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    what = rng.randrange(3)
    if what == 0:
        del lines[i]
    elif what == 1:
        lines.insert(i, lines[j])
    else:
        lines[i], lines[j] = lines[j], lines[i]
    data[:] = b"\n".join(lines)


def change_binary_number(data, rng):
    """Counts and offsets in binary parts."""
    width = rng.choice([1, 2, 4, 8])
    if len(data) < width:
        return
    at = rng.randrange(len(data) - width + 1)
    value = rng.choice(NUMBERS) % (1 << (8 * width))
    data[at:at + width] = value.to_bytes(width, rng.choice(["little", "big"]))


def mutate_once(data, rng):
    at, what = place(data, rng), rng.randrange(11)
    if what == 0 and data:
        data[at] = rng.randrange(256)
    elif what == 1:
        data[at:at] = bytes(rng.randrange(256) for _ in range(rng.randrange(1, 9)))
    elif what == 2:
        del data[at:at + rng.randrange(1, 40)]
    elif what == 3:
        data[at:at] = rng.choice(TOKENS)
    elif what == 4 and rng.random() < .3:
        del data[at:]
    elif what == 5:
        begin = place(data, rng)
        data[at:at] = data[begin:begin + rng.randrange(1, 200)]
    elif what in (6, 7):
        change_number(data, rng)
    elif what == 8:
        change_word(data, rng)
    elif what == 9:
        change_line(data, rng)
    elif what == 10:
        change_binary_number(data, rng)


def mutate_in_place(data, rng):
    """In a file of addresses one byte more makes all of it wrong. So most damage leaves its length."""
    what = rng.randrange(3)
    if what == 0:
        data[rng.randrange(len(data))] = rng.randrange(256)
    elif what == 1:
        change_binary_number(data, rng)
    else:
        length = min(len(data), rng.choice([1, 4, 8, 16, 64, 512]))
        to, begin = rng.randrange(len(data) - length + 1), rng.randrange(len(data) - length + 1)
        data[to:to + length] = data[begin:begin + length]


def mutant(sound, rng, in_place=False):
    data = bytearray(sound)
    if in_place:
        for _ in range(rng.choice([1, 1, 1, 2, 4, 16, 200])):
            mutate_in_place(data, rng)
        return bytes(data)
    for _ in range(rng.choice([1, 1, 1, 2, 4, 16])):
        mutate_once(data, rng)
    return bytes(data) or b" "


def damaged(path, rng):
    """The file at `path`, damaged: of a packed file often what is packed."""
    with open(path, "rb") as file:
        sound = file.read()
    if ending(path) in ADDRESSED and rng.random() < .8:
        return mutant(sound, rng, True)
    if not path.endswith(".gz") or rng.random() < .3:
        return mutant(sound, rng)
    return gzip.compress(mutant(gzip.decompress(sound), rng), 6, mtime=0)


def ending(name):
    name = os.path.basename(name)
    return name[name.index("."):] if "." in name else ""


def is_field(name):
    kind = ending(name)
    return re.fullmatch(r"\.p?vt[irsu]|\.nhdr|\.nrrd|\.vti\.series", kind) or (
        kind in (".vtk", ".vtkhdf", ".hdf") and not name.startswith(("sheet", "odd")))


def command(path, name, picture, rng):
    if rng.random() < .4 and ending(name) not in MAPS:
        return ["info", path]
    common = ["render", "-o", picture, "--size", "64x64", "--threads", "1"]
    if ending(name) in MAPS:
        return common + ["--surface", "sphere:8", "--field", "abc:8,8,8", "--color-by", "abc:mag", "--colormap", path]
    if ending(name) == ".foam":
        case = os.path.dirname(path)
        volume = ["--vectors", rng.choice(["U", "wallShear(U)"])] + rng.choice([[], ["--color-by", "p"]])
        return common + rng.choice([["--surface", case, "--vectors", "wallShearStress"],
                                    ["--surface", case + ":floor", "--color-by", "p", "--vectors", "U"],
                                    ["--surface", "boundary", "--field", case] + volume,
                                    ["--surface", case, "--field", case] + volume,
                                    ["--surface", "slice:1,0.2,0.2:0,0,1", "--field", case]])
    if ending(name) == ".case":
        color = rng.choice([[], ["--color-by", "p"], ["--color-by", "q"]])
        return common + ["--vectors", "U"] + color + rng.choice([
            ["--surface", path], ["--surface", path + ":mixed,slab"], ["--surface", path, "--field", path],
            ["--surface", "boundary", "--field", path], ["--surface", "slice:2,2,1.5:0,0.1,1", "--field", path + ":mixed,fluid"],
            ["--surface", path + ":walls", "--time", "1.5"]])
    if ending(name) == ".cgns":
        color = rng.choice([[], ["--color-by", "Pressure"], ["--color-by", "Density"]])
        return common + ["--vectors", rng.choice(["Velocity", "Velocity", "Shear"])] + color + rng.choice([
            ["--surface", path], ["--surface", path + ":floor,inlet"], ["--surface", path + ":box"], ["--surface", path, "--field", path],
            ["--surface", path + ":*Faces"], ["--surface", "boundary", "--field", path], ["--surface", path + ":lid", "--time", "0.5"],
            ["--surface", "slice:2,2,1.5:0,0.1,1", "--field", path + ":box"]])
    if ending(name) in EXODUS:
        color = rng.choice([[], ["--color-by", "pressure"], ["--color-by", "shear"], ["--color-by", "temp"]])
        return common + ["--vectors", "vel"] + color + rng.choice([
            ["--surface", path], ["--surface", path + ":floor,sideset_100"], ["--surface", path + ":low,sheet,block_20"],
            ["--surface", path + ":all"], ["--surface", path, "--field", path], ["--surface", "boundary", "--field", path],
            ["--surface", path + ":lid", "--time", "0.5"], ["--surface", "slice:2,2,1.5:0,0.1,1", "--field", path + ":high"]])
    if ending(name) in NETCDF:
        return common + ["--field", path] + rng.choice([
            ["--surface", "boundary", "--vectors", "uv10"], ["--surface", "boundary", "--vectors", "uvo", "--color-by", "thetao"],
            ["--surface", "slice:5,50,-10:0,0,1", "--vectors", "uvo"], ["--surface", "image", "--vectors", "uv10", "--time", "6"]])
    if ending(name) in (".tec", ".dat"):
        color = rng.choice([[], ["--color-by", "p"], ["--color-by", "T"]])
        return common + ["--vectors", "UVW"] + color + rng.choice([
            ["--surface", path], ["--surface", path + ":sheet"], ["--surface", path + ":box,sheet"], ["--surface", "boundary", "--field", path],
            ["--surface", path, "--time", "0.5"], ["--surface", "slice:2,2,1.5:0,0.1,1", "--field", path + ":box"]])
    if ending(name) in (".cas", ".msh"):
        color = rng.choice([[], ["--color-by", "PRESSURE"]])
        return common + ["--vectors", rng.choice(["VELOCITY", "WALL_SHEAR"])] + color + rng.choice([
            ["--surface", path], ["--surface", path + ":floor,inlet"], ["--surface", path + ":air"], ["--surface", path, "--field", path],
            ["--surface", "boundary", "--field", path], ["--surface", "slice:2,2,1.5:0,0.1,1", "--field", path]])
    if ending(name) in VTKHDF and name.startswith("sheet"):
        return common + ["--vectors", "tau"] + rng.choice([[], ["--color-by", "q"]]) + rng.choice([
            ["--surface", path], ["--surface", path, "--time", "0.5"], ["--surface", path + ":block0,odd"],
            ["--surface", "boundary", "--field", path + ":block2"]])
    if ending(name) in (".vtm", ".vtmb", ".vthb") and rng.random() < .4:
        return common + rng.choice([["--vectors", "tau", "--surface", path + ":" + rng.choice(["0", "1", "*", "inner", "inner/*"])],
                                    ["--field", path, "--vectors", "U", "--surface", "boundary"]])
    if not is_field(name):
        own = ending(name) in (".vtp", ".pvtp", ".vtm", ".vtmb", ".vtk", ".pvd") and rng.random() < .8
        return common + ["--surface", path] + (["--vectors", rng.choice(["tau", "cellTau"])] if own else ["--field", "abc:8,8,8"])
    surface = rng.choice(["slice:0.2,0.2,0.2:0,0,1", "boundary", "sphere:2000", "isosurface:p=90"])
    return common + ["--surface", surface, "--field", path] + (["--field-precision", "half"] if rng.random() < .2 else [])


class Worker(threading.Thread):
    """One process of aeolic_files, and a folder with all seeds, so that pieces and steps are there."""

    def __init__(self, options, number, jobs, report):
        super().__init__()
        self.options, self.number, self.jobs, self.report = options, number, jobs, report
        self.folder = os.path.join(options.folder, "work%d" % number)
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(os.path.join(options.folder, "seeds"), self.folder)
        self.process = subprocess.Popen([options.program, "run", os.path.join(self.folder, "said")], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, errors="replace", start_new_session=True)  # Ctrl-C is not for it.

    def run(self):
        for name, number in self.jobs:
            rng = random.Random("%d %s %d" % (self.options.seed, name, number))
            target = name
            if ending(name) in CASES or (re.search(r"\.pvt|\.vtm", name) and rng.random() < .3):
                target = rng.choice(self.pieces_of(name))  # A piece is damaged instead.
            if ending(name) == ".cas" and rng.random() < .4:
                target = name[:-4] + ".dat"  # The values beside it.
            data = damaged(os.path.join(self.options.folder, "seeds", target), rng)
            path = os.path.join(self.folder, target)
            with open(path, "wb") as file:
                file.write(data)
            words = command(os.path.join(self.folder, name), name, os.path.join(self.folder, "o.png"), rng)
            verdict, status, end = self.verdict_on(words)
            self.report(name, number, target, words, verdict, status, end, path)
            shutil.copyfile(os.path.join(self.options.folder, "seeds", target), path)
        self.process.stdin.close()
        self.process.wait()

    def verdict_on(self, words):
        """What is wrong, or nothing, the exit status, and how the reader ended, if it did. What is wrong is tried again
        by a process that has done nothing else."""
        answer = self.ask("\t".join(words))
        verdict = judge(answer, self.options.most_mib)
        if verdict and len(answer) == 6 and answer[4] != "0":
            alone = judge(self.ask("new\n" + "\t".join(words)), self.options.most_mib)
            verdict = alone or "%s, but only after %s other files in the same process" % (verdict, answer[4])
        return verdict, answer[1] if len(answer) > 1 else "", end_of_reader(answer[-1])

    def ask(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        return self.process.stdout.readline().rstrip("\n").split("\t", 5)

    def pieces_of(self, name):
        if ending(name) in CASES:
            case = os.path.join(self.folder, os.path.dirname(name))
            return sorted(os.path.relpath(os.path.join(at, file), self.folder) for at, _, files in os.walk(case)
                          for file in files if not file.endswith(".foam"))
        with open(os.path.join(self.folder, name), errors="replace") as file:
            return re.findall(r'(?:Source|file)="([^"]*)"', file.read()) or [name]


class Tally:
    def __init__(self, options):
        self.options, self.lock = options, threading.Lock()
        self.counts, self.bad, self.ends = {}, [], collections.Counter()
        self.found = os.path.join(options.folder, "found")
        os.makedirs(self.found, exist_ok=True)

    def of_each(self):
        with self.lock:
            return min((sum(counts.values()) for counts in self.counts.values()), default=0)

    def __call__(self, name, number, target, words, verdict, status, end, path):
        with self.lock:
            if end:
                self.ends[ending(name) + " " + end] += 1
            counts = self.counts.setdefault(ending(name), {"read": 0, "refused": 0, "bad": 0})
            counts["bad" if verdict else "read" if status == "0" else "refused"] += 1
            if not verdict:
                return
            label = "%s-%d-%s" % (self.options.seed, number, os.path.basename(target))
            self.bad.append((verdict, label))
        shutil.copyfile(path, os.path.join(self.found, label))
        with open(os.path.join(self.found, label + ".txt"), "w") as file:
            file.write("%s\naeolic %s\n(%s stood in the place of %s)\n" % (verdict, " ".join(words), label, target))
            if os.path.exists(os.path.join(os.path.dirname(path), "said")):
                with open(os.path.join(os.path.dirname(path), "said"), errors="replace") as said:
                    file.write(said.read(20000))


def end_of_reader(line):
    """"SIGSEGV" where a reader ended by it, "no progress" where it was ended; nothing where it lives."""
    found = re.search(r"the reader (?:ended \(([^)]*)\)|made (no progress))", line)
    return found and (found.group(1) or found.group(2))


def judge(answer, most_mib):
    """What is wrong, or nothing."""
    if len(answer) < 6:
        return "aeolic_files itself ended"
    how, number, lines, mib, _, first = answer
    if how == "signal":
        return "hangs" if number in ("9", "24") else "signal " + number
    if number not in ("0", "2"):
        return "exit %s: %s" % (number, first)
    if number == "2" and lines != "1":
        return "%s lines: %s" % (lines, first)
    if int(mib) > most_mib:
        return "%s MiB of memory" % mib
    return None


def jobs_of(names, options, first, step, end):
    """The formats take turns, and within a format its seeds."""
    by_format = {}
    for name in names:
        by_format.setdefault(ending(name), []).append(name)
    number = first
    while options.files is None or number < options.files:
        for group in by_format.values():
            if options.stopped or (end is not None and time.monotonic() > end):
                return
            yield group[number % len(group)], number
        number += step


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--files", type=int)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--formats", default="")
    parser.add_argument("--processes", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--most-mib", type=int, default=MOST_MIB)
    options = parser.parse_args()
    options.stopped = False
    if options.seconds is None and options.files is None:
        options.seconds = 60
    seeds = os.path.join(options.folder, "seeds")
    shutil.rmtree(seeds, ignore_errors=True)
    os.makedirs(seeds)
    subprocess.run([options.program, "seeds", seeds], check=True)
    wanted = options.formats.split(",") if options.formats else None
    files = sorted(os.path.relpath(os.path.join(at, file), seeds) for at, _, files in os.walk(seeds) for file in files)
    names = [n for n in files if ending(n) in CASES or (os.path.dirname(n) == "" and "." in n and not re.search(
        r"\.raw$|\.txt$|_\d+\.vt[a-z]$", n))]
    names = [n for n in names if not n.endswith(".dat") or n[:-4] + ".cas" not in names]  # Values that are read with their mesh.
    names = [n for n in names if wanted is None or ending(n) in wanted]
    tally = Tally(options)
    end = time.monotonic() + options.seconds if options.seconds is not None else None
    workers = [Worker(options, k, jobs_of(names, options, options.first + k, options.processes, end), tally)
               for k in range(options.processes)]
    for worker in workers:
        worker.start()
    try:
        for worker in workers:
            while worker.is_alive():
                worker.join(10)
                if sys.stderr.isatty():
                    print("%d of each ending, %d bad" % (tally.of_each(), len(tally.bad)), end="\r", file=sys.stderr, flush=True)
    except KeyboardInterrupt:
        options.stopped = True
        for worker in workers:
            worker.join()
    for kind, counts in sorted(tally.counts.items()):
        print("%-12s %6d files: %6d read, %6d refused, %d bad" % (kind, sum(counts.values()), counts["read"], counts["refused"],
                                                                  counts["bad"]))
    ends = ", ".join("%s %d times" % each for each in tally.ends.most_common())
    print("readers that ended, which is no fault: %s" % (ends or "none"))
    for verdict, label in sorted(tally.bad)[:60]:
        print("%s: %s" % (label, verdict))
    return 1 if tally.bad else 0


if __name__ == "__main__":
    sys.exit(main())
