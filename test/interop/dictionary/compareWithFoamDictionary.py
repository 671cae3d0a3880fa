#!/usr/bin/env python3
"""Reads every dictionary below a folder, such as OpenFOAM's tutorials, with sphDictionary and with OpenFOAM's foamDictionary.

    compareWithFoamDictionary.py <sphDictionary> [<folder>] [-theirs <cache>] [-report <file>]

What sphDictionary accepts must agree with foamDictionary token by token, numbers to 12 digits; what it refuses it must refuse with a file of the
case and a line. Exit code 1 where a file disagrees or is refused without a place. Without a folder it takes the tutorials of Debian's package
openfoam-examples, whose compressed files it unpacks. With a cache foamDictionary is run once for each file. The etc folder that both look in is
that of $WM_PROJECT_DIR; for tutorials of another OpenFOAM give one that has the caseDicts and thermoData of that beside the installed one's files.
"""
import argparse, collections, gzip, hashlib, math, os, pathlib, re, subprocess, sys, tempfile

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("sphDictionary", type=pathlib.Path)
parser.add_argument("folder", type=pathlib.Path, nargs="?", default="/usr/share/doc/openfoam-examples/examples")
parser.add_argument("-theirs", type=pathlib.Path, help="folder that keeps foamDictionary's answers")
parser.add_argument("-report", type=argparse.FileType("w"), help="one line for each file")
options = parser.parse_args()
environment = os.environ | {"WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}

token = re.compile(r'"(?:\\.|[^"\\])*"|#\{.*?#\}|\[[^\]]*\]|[(){};,]|[^\s(){}\[\];,"]+', re.DOTALL)
comment = re.compile(r'"(?:\\.|[^"\\])*"|/\*.*?\*/|//[^\n]*', re.DOTALL)


def tokens(text):
    """Without comments. Blanks between units mean nothing, nor a ';' behind another, which foamDictionary writes where a macro stood."""
    text = comment.sub(lambda found: found[0] if found[0].startswith('"') else " ", text)
    words = [word if word[0] != "[" else "".join(word.split()) for word in token.findall(text)]
    return [word for at, word in enumerate(words) if not (word == ";" and at > 0 and words[at - 1] == ";")]


def same(ours, theirs):
    if ours == theirs:
        return True
    try:
        return math.isclose(float(ours), float(theirs), rel_tol=1e-12)
    except ValueError:
        return False


def run(command, folder):
    place = environment | {"PWD": str(folder)}
    done = subprocess.run([str(part) for part in command], cwd=folder, env=place, capture_output=True, timeout=60)
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")


def answer(case, name):
    """What foamDictionary makes of a file: its exit code and its text, without the banner and what it warns of before it."""
    cached = options.theirs and options.theirs / hashlib.sha1(f"{case}/{name}".encode()).hexdigest()
    if cached and cached.exists():
        code, text = cached.read_text().split("\n", 1)
    else:
        code, text, _ = run(["foamDictionary", "-expand", "-precision", "17", name], case)
    if cached and not cached.exists():
        cached.parent.mkdir(parents=True, exist_ok=True)
        cached.write_text(f"{code}\n{text}")
    return int(code), text[max(0, text.find('//\n// "')):]


def caseOf(file, top):
    """The nearest folder above a file that is a case."""
    for folder in file.parents:
        if (folder / "system").is_dir() or (folder / "constant").is_dir() or folder == top:
            return folder


def unpacked(folder, place):
    """A copy of a folder's text files, those that Debian has compressed among them."""
    for file in folder.rglob("*"):
        if not file.is_file() or file.stat().st_size > 4_000_000:
            continue
        data = gzip.open(file).read() if file.suffix == ".gz" else file.read_bytes()
        copy = place / (file.relative_to(folder).with_suffix("") if file.suffix == ".gz" else file.relative_to(folder))
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(data)
    return place


def isDictionary(file):
    return file.is_file() and file.stat().st_size < 1_000_000 and b"FoamFile" in file.open("rb").read(3000)


counts = collections.Counter()


def note(kind, file, detail=""):
    counts[kind] += 1
    if kind in ("disagree", "without a place"):
        print(f"{kind}: {file}: {detail}")
    if options.report:
        print(f"{kind}\t{file}\t{detail}", file=options.report)


def difference(ours, theirs):
    """What differs first, with the words around it; empty where nothing does."""
    for at, (mine, their) in enumerate(zip(ours, theirs)):
        if not same(mine, their):
            return f"{' '.join(ours[max(0, at - 6):at + 4])}  ---  {' '.join(theirs[max(0, at - 6):at + 4])}"
    return "" if len(ours) == len(theirs) else f"{len(ours)} tokens --- {len(theirs)} tokens"


with tempfile.TemporaryDirectory() as temporary:
    top = options.folder.resolve()
    if any(top.rglob("*.gz")):
        top = unpacked(top, pathlib.Path(temporary))
    for file in sorted(path for path in top.rglob("*") if isDictionary(path)):
        case = caseOf(file, top)
        name = f"./{file.relative_to(case)}"
        shown = file.relative_to(top)
        code, text, errors = run([options.sphDictionary.resolve(), name], case)
        if code != 0:
            place = re.search(r"^(\S.*?):(\d+): (.*)", errors, re.MULTILINE)
            note("refused" if place else "without a place", shown, place[0] if place else errors.strip().replace("\n", " "))
            continue
        theirCode, theirText = answer(case, name)
        if theirCode != 0:
            note("accepted, OpenFOAM refuses it", shown)
            continue
        found = difference(tokens(text), tokens(theirText))
        note("disagree" if found else "agree", shown, found)

print(", ".join(f"{number} {kind}" for kind, number in counts.most_common()))
sys.exit(counts["disagree"] + counts["without a place"] > 0 or counts["agree"] == 0)
