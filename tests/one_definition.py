#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds classes, enumerations and constants of core and app that are defined twice under one name.

    tests/one_definition.py [FOLDER...]     core and app where none is given

Two definitions in one program are undefined behaviour (weak destructors are merged) or, for
constants, two truths: a constant in an anonymous namespace counts too where the same name is visible
elsewhere. Ends with 1 where there is any. A scan of the text, no compiler: macros are not followed.
`tests/nightly.sh odr` asks the linker.
"""
import collections
import pathlib
import re
import sys

BLANK = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#(?:\\\n|[^\n])*',
    re.S | re.M)
SPACE = re.compile(r"(?:inline\s+)?namespace\s*([\w:]*)$")
TYPE = re.compile(r"(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(?:\[\[.*?\]\]\s*)?"
                  r"(\w+(?:::\w+)*(?:<.*>)?)\s*(?:final\s*)?(?::(?!:).*)?$", re.S)
CONSTANT = re.compile(r"\b(?:const|constexpr|constinit)\b[^(=]*?\b(k[A-Z]\w*)\s*(?:\[[^\]]*\]\s*)*$", re.S)


def plain(text):
    """Without comments, literals and directives, in lines as before."""
    return BLANK.sub(lambda m: ('""' if m[0][0] in "R\"'" else "") + "\n" * m[0].count("\n"), text)


def withoutTemplate(head):
    while match := re.match(r"\s*template\s*<", head):
        depth, at = 1, match.end()
        while depth and at < len(head):
            depth += {"<": 1, ">": -1}.get(head[at], 0)
            at += 1
        head = head[at:]
    return head.strip()


def definitions(text):
    """(name, whether in an anonymous namespace, line) of everything defined at namespace scope."""
    scopes, start = [], 0  # of each open brace: its namespace, "" for an anonymous one, None: a body
    for mark in re.finditer(r"[{};]", text):
        head, where = withoutTemplate(text[start:mark.start()]), start
        start = mark.end()
        if mark[0] == "}":
            if scopes:
                scopes.pop()
            continue
        space = SPACE.search(head) if mark[0] == "{" else None
        if None not in scopes and not space and not head.startswith(("extern", "using", "friend")):
            found = TYPE.match(head) if mark[0] == "{" and "" not in scopes else None
            found = found or CONSTANT.search(re.split(r"=(?!=)", head)[0])
            if found:
                line = text.count("\n", 0, where + len(text[where:mark.start()]) - len(head)) + 1
                yield "::".join([s for s in scopes if s] + [found[1]]), "" in scopes, line
        if mark[0] == "{":
            scopes.append(space[1] if space else None)


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    found = collections.defaultdict(list)
    for folder in sys.argv[1:] or ["core", "app"]:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                for name, hidden, line in definitions(plain(path.read_text(encoding="utf-8"))):
                    found[name].append((path.relative_to(root), hidden, line))
    twice = 0
    for name, places in sorted(found.items()):
        files = {path for path, _, _ in places}
        if len(files) > 1 and not all(hidden for _, hidden, _ in places):
            twice += 1
            print(f"{name} is defined more than once:")
            for path, hidden, line in places:
                print(f"  {path}:{line}{' (anonymous namespace)' if hidden else ''}")
    print(f"{len(found)} classes and constants looked at, {twice} defined more than once")
    return 1 if twice else 0


sys.exit(main())
