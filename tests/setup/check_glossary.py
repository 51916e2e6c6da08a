"""The table of words in app/README.md is true: the code has each word, and the table has the code's commonest words."""
import collections
import pathlib
import re
import sys

COMMONEST = 40

# Words of C++ and its libraries, and English words that mean in the code what they mean anywhere.
LANGUAGE = """abs alignas and app array assert at auto back begin bool break case catch char class const constexpr continue
count data default delete do double else emplace empty end enum explicit false find first float fmt for format friend
front function get glm hn hwy if inline insert int int32 json long make max min move mutable namespace new noexcept not
nullopt nullptr operator optional or pair path print private ptr public push ranges requires resize return second short
sim size sizeof span static std string struct sub switch taut template text this throw to true try typename uint8 uint32
uint64 unsigned using vec vec2 vec3 vec4 vector view virtual void while with""".split()
ENGLISH = """a add all along are area as axis be bound box by bytes can cast centre changed colour current depth direction distance
draw each error file for force friction from has height high in is it json kind last length level line list load look low
lower made mean middle name near next no normal number of off on one options order other out over own per point previous
program put radius range rate read reach render right same scale set settings show side source speed start step store
style take than that the time two unit until up update upper use value width window world write x y z""".split()


def words_of_code(root):
    """Counts the words of the identifiers, each in the singular."""
    counts = collections.Counter()
    for folder in ("sim", "app", "renderer"):
        for file in (root / folder).rglob("*.[ch]pp"):
            code = re.sub(r'//[^\n]*|"(?:\\.|[^"\\\n])*"|#include[^\n]*', "", file.read_text())
            for name in re.findall(r"[A-Za-z_]\w*", code):
                counts.update(map(singular, re.findall(r"[A-Z]?[a-z]+[0-9]*|[A-Z]+(?![a-z])", name)))
    return counts


def singular(word):
    word = word.lower()
    for plural, one in (("vertices", "vertex"), ("indices", "index"), ("bodies", "body"), ("meshes", "mesh"),
                        ("axes", "axis"), ("boxes", "box"), ("matrices", "matrix"), ("masses", "mass")):
        if word == plural:
            return one
    return word[:-1] if len(word) > 3 and word.endswith("s") and not word.endswith(("ss", "us", "is")) else word


def words_of_table(page):
    table = page.read_text().split("## Words")[1].split("\n## ")[0]
    rows = re.findall(r"^\| ([^|]+) \|", table, re.MULTILINE)[1:]  # without the head
    return [word for row in rows for word in re.findall(r"[A-Za-z]+", row)]


def main(root):
    counts = words_of_code(root)
    table = list(map(singular, words_of_table(root / "app" / "README.md")))
    errors = [f"app/README.md: no identifier has the word '{word}'" for word in table if counts[word] == 0]
    known = set(table) | {singular(word) for word in LANGUAGE + ENGLISH}
    commonest = [word for word, _ in counts.most_common() if len(word) > 2 and word not in LANGUAGE and word not in ENGLISH]
    errors += [f"app/README.md: the common word '{word}' ({counts[word]} times) is not in the table of words"
               for word in commonest[:COMMONEST] if word not in known]
    if len(table) < COMMONEST:
        errors.append(f"app/README.md: found {len(table)} words in the table, expected at least {COMMONEST}")
    print("\n".join(errors))
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
