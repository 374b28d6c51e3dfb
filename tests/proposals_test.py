"""Every command that `aeolic info` proposes works and shows something, on sample files of every format.
Usage: proposals_test.py AEOLIC AEOLIC_FILES   (the programs)
"""
import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

AEOLIC, FILES = map(os.path.abspath, sys.argv[1:3])
# What a warning says of a picture on which there is nothing to see.
BLANK = ("nothing of the surface", "has no streaks", "vectors are zero", "has no effect", "have moments from")
MOST_FRAMES = 3


def run(arguments, folder):
    return subprocess.run([AEOLIC, *arguments], cwd=folder, capture_output=True, text=True, timeout=120)


def proposals(folder, name):
    """The commands, and the complaint where the file is not described."""
    done = run(["info", name], folder)
    if done.returncode != 0:
        return [], f"{name}: aeolic info: {done.stderr.strip()}"
    commands = [line.strip() for line in done.stdout.splitlines() if line.startswith("  aeolic render ")]
    if not commands and "Nothing to draw: " not in done.stdout:
        return [], f"{name}: neither commands nor a reason for none"
    return commands, ""


def fault(folder, name, command, number):
    """What is wrong with a proposed command; empty where it draws something."""
    arguments = shlex.split(command)[1:]
    if "--frames" in arguments:
        arguments[arguments.index("--frames") + 1] = str(MOST_FRAMES)
    stem = f"out-{os.path.basename(name)}-{number}"
    arguments[arguments.index("-o") + 1] = f"{stem}.png"
    size = [] if "image" in arguments else ["--size", "64x64"]
    done = run([*arguments, *size, "--steps", "8", "--stats", f"{stem}.json"], folder)
    if done.returncode != 0:
        return f"{command}\n    {done.stderr.strip()}"
    stats = json.loads((folder / f"{stem}.json").read_text())
    for frame in folder.glob(f"{stem}*"):
        frame.unlink()
    if stats["image"]["covered_pixels"] == 0:
        return f"{command}\n    it shows nothing"
    blank = [line for line in done.stderr.splitlines() if any(words in line for words in BLANK)]
    return f"{command}\n    {blank[0]}" if blank else ""


def main():
    faults, count, files = [], 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([FILES, "seeds", str(folder)], check=True)
        # Not colours, nor what belongs to others: Fluent's values, and folders of pieces that are no cases.
        def is_of_others(path):
            return (path.suffix in (".json", ".xml", ".csv", ".raw", ".sh") or path.match("fluent*.dat")
                    or path.is_dir() and not (path / "constant").is_dir() and not (path / "processor0").is_dir())
        seeds = sorted([*(path for path in folder.iterdir() if not is_of_others(path)), *folder.glob("*/*.case")])
        with concurrent.futures.ThreadPoolExecutor(max(2, (os.cpu_count() or 2) // 2)) as pool:
            asked = list(pool.map(lambda path: proposals(folder, str(path.relative_to(folder))), seeds))
            jobs = []
            for path, (commands, complaint) in zip(seeds, asked):
                files += bool(commands)
                if complaint and "unknown extension" not in complaint and "has no extension" not in complaint:
                    faults.append(complaint)
                for number, command in enumerate(commands):
                    jobs.append(pool.submit(fault, folder, str(path.relative_to(folder)), command, number))
            faults += [found for found in (job.result() for job in jobs) if found]
            count = len(jobs)
    print(f"{count} commands for {files} files, {len(faults)} faults")
    for found in faults:
        print(found)
    if count < 50:
        print("too few commands to say anything")
    sys.exit(1 if faults or count < 50 else 0)


main()
