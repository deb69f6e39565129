#!/usr/bin/env python3
"""Checks the rules of the house over the source tree.

Usage: check_house.py [ROOT]. Prints "FILE:LINE: RULE" for each violation and returns 1 if there is
one; long files are only mentioned.
"""

import pathlib
import re
import shutil
import subprocess
import sys

import house_rules as rules

CXX = (".h", ".cpp")
SCRIPTS = (".py", ".sh", ".cmake", "")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME)\b")
MAIN = re.compile(r"^int main\(", re.MULTILINE)


class Report:
    def __init__(self):
        self.violations = []
        self.warnings = []

    def add(self, path, line, text):
        self.violations.append(f"{path}:{line}: {text}")

    def warn(self, path, line, text):
        self.warnings.append(f"{path}:{line}: warning: {text}")


def source_files(root):
    """Paths below the product's folders, relative to the root, sorted."""
    files = []
    for folder in rules.TOP_FOLDERS:
        for path in (root / folder).rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts:
                files.append(path.relative_to(root))
    return sorted(files)


def unit_of(path):
    """The folder that the rules speak of: sim/STAGE, or the top folder."""
    parts = path.parts
    if parts[0] == "sim" and len(parts) > 2 and "/".join(parts[:2]) in rules.MAY_INCLUDE:
        return "/".join(parts[:2])
    return parts[0]


def without_comments(text):
    """The code with comments and texts blanked, line breaks kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
    return pattern.sub(lambda match: "\n" * match.group(0).count("\n") + " ", text)


def check_include(path, line, kind, header, report):
    for privilege in rules.PRIVILEGES:
        if header == rules.CHANNEL_TABLE or privilege.headers is None:
            continue
        if privilege.headers.match(header) and not privilege.allowed.match(str(path)):
            report.add(path, line, f"{privilege.name}: {header}")
    if kind == "<" or header in rules.KNOWN_TO_ALL:
        return
    target = pathlib.PurePosixPath(header)
    if target.parts[0] == "eod":
        return  # generated from lcmtypes, and judged as LCM above
    if target.parts[0] not in rules.TOP_FOLDERS:
        report.add(path, line, f"includes go from the root of the tree: \"{header}\"")
        return
    unit, seen = unit_of(path), unit_of(target)
    allowed = rules.MAY_INCLUDE.get(unit)
    if allowed is not None and seen != unit and seen not in allowed:
        report.add(path, line, f"{unit} may not include {seen}: \"{header}\"")


def check_cxx(path, text, report):
    for number, line in enumerate(text.splitlines(), 1):
        include = INCLUDE.match(line)
        if include:
            check_include(path, number, include.group(1), include.group(2), report)
    for number, line in enumerate(without_comments(text).splitlines(), 1):
        for privilege in rules.PRIVILEGES:
            name = privilege.code.search(line) if privilege.code else None
            if name and not privilege.allowed.match(str(path)):
                report.add(path, number, f"{privilege.name}: {name.group(1)}")
    if path.parts[0] == "programs" and MAIN.search(text):
        lines = len(text.splitlines())
        if lines > rules.MAX_MAIN_LINES:
            report.add(path, lines, f"a main has at most {rules.MAX_MAIN_LINES} lines, this {lines}")


def check_text(path, text, report):
    lines = text.splitlines()
    if len(lines) > rules.MAX_LINES:
        report.add(path, len(lines),
                   f"a file has at most {rules.MAX_LINES} lines, this {len(lines)}")
    elif len(lines) > rules.MANY_LINES:
        report.warn(path, len(lines), f"{len(lines)} lines")
    for number, line in enumerate(lines, 1):
        unfinished = UNFINISHED.search(line)
        if unfinished:
            report.add(path, number, f"nothing is left for later: {unfinished.group(0)}")


def check_folders(root, report):
    for folder in rules.TOP_FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.is_dir() and path.name in rules.FORBIDDEN_FOLDERS:
                report.add(path.relative_to(root), 1, f"no folder is named {path.name}")
    for name in rules.FORBIDDEN_FOLDERS:
        if (root / name).is_dir():
            report.add(name, 1, f"no folder is named {name}")


def check_format(root, files, report):
    """One violation a file: the first line that clang-format would change."""
    if not files:
        return
    tool = shutil.which("clang-format") or shutil.which("clang-format-14")
    if tool is None:
        report.add("clang-format", 1, "is not installed; apt-get install clang-format")
        return
    run = subprocess.run([tool, "--dry-run", "--style=file", *map(str, files)], cwd=root,
                         capture_output=True, text=True, check=False)
    seen = set()
    for path, line in re.findall(r"^(\S+?):(\d+):\d+: (?:warning|error): code should be",
                                 run.stderr, re.MULTILINE):
        if path not in seen:
            report.add(path, line, "is not as clang-format has it; run clang-format -i")
        seen.add(path)
    if run.returncode != 0 and not seen:
        report.add("clang-format", 1, run.stderr.strip().splitlines()[-1] if run.stderr else "failed")


def check(root):
    report = Report()
    files = source_files(root)
    check_folders(root, report)
    for path in files:
        is_cxx = path.suffix in CXX
        if not is_cxx and path.suffix not in SCRIPTS and path.name != "CMakeLists.txt":
            continue
        try:
            text = (root / path).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            if is_cxx:
                report.add(path, 1, "is not UTF-8")
            continue
        check_text(path, text, report)
        if is_cxx:
            check_cxx(path, text, report)
    check_format(root, [path for path in files if path.suffix in CXX], report)
    return report, len(files)


def main():
    default = pathlib.Path(__file__).resolve().parents[2]
    root = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else default
    report, count = check(root)
    for line in report.warnings + report.violations:
        print(line)
    print(f"{count} files, {len(report.violations)} violations")
    return 1 if report.violations or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
