#!/usr/bin/env python3
"""draw_sentences.py sentences|comments [--seed N] [--count N] [DOCUMENT...]: a random sample of what people read, to be judged
by somebody who marks what needs a second reading.

`sentences` are those of the documents by hand (scripts/document_words.py says which), or of the DOCUMENTs; `comments` those of
lib, apps and tests, whole ones, trailing ones too. Prints `FILE:LINE: TEXT`, in the order drawn. The same tree and seed
give the same sample.
"""

import argparse
import pathlib
import random
import re
import sys

from document_words import by_hand, documents, prose

TOP = pathlib.Path(__file__).resolve().parent.parent
_SENTENCE_END = re.compile(r"(?<=[.?!])[\])\"*`]*\s+(?=[A-Z`*\"(\[])")


def sentences(path):
    """Pairs of line and sentence of a document, of four words or more."""
    text = by_hand(path.read_text(encoding="utf-8"))
    found = []
    for line, paragraph in prose(text):
        found += [(line, sentence.strip()) for sentence in _SENTENCE_END.split(paragraph) if len(sentence.split()) > 3]
    return found


def comments(path):
    """Pairs of line and comment of a source of C++. Own-line comments that follow one another are one; a trailing comment goes on
    in the lines below that have nothing but a comment in the same column."""
    found, open_at, words, trails_in = [], 0, [], None  # the column of a trailing comment
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n") + [""], 1):
        whole = re.match(r"\s*(//[/!]?<?)\s?(.*)", line)
        trailing = re.match(r"[^\"]*?\S[^\"]*?\s(///?<?)\s(.*)", line)
        if whole and (trails_in is None or whole.start(1) == trails_in):
            open_at = open_at or number
            words.append(whole[2])
            continue
        if words:
            found.append((open_at, " ".join(words).strip()))
        open_at, words, trails_in = 0, [], None
        if whole:
            open_at, words = number, [whole[2]]
        elif trailing and not trailing[2].startswith("namespace "):
            open_at, words, trails_in = number, [trailing[2]], trailing.start(1)
    return [(line, text) for line, text in found if len(text.split()) > 1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=["sentences", "comments"])
    parser.add_argument("documents", nargs="*", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=60)
    chosen = parser.parse_intermixed_args()
    if chosen.kind == "sentences":
        files, read = [path.resolve() for path in chosen.documents] or documents(TOP), sentences
    else:
        files, read = sorted(path for folder in ("lib", "apps", "tests") for path in (TOP / folder).rglob("*.[ch]pp")), comments
    everything = [(path, line, text) for path in files for line, text in read(path)]
    for path, line, text in random.Random(chosen.seed).sample(everything, min(chosen.count, len(everything))):
        print(f"{path.relative_to(TOP) if path.is_relative_to(TOP) else path}:{line}: {text}")
    print(f"{len(everything)} {chosen.kind} in {len(files)} files", file=sys.stderr)


if __name__ == "__main__":
    main()
