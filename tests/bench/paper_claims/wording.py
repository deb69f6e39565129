"""How docs/paper_claims.md writes numbers, verdicts and paragraphs."""

import re
import textwrap


def number(value, digits=0):
    return f"{value:,.{digits}f}".replace("-", "\N{MINUS SIGN}")


def percent(share, digits=0):
    return f"{100 * share:.{digits}f} %"


def verdict(holds):
    return "holds" if holds else "**does not hold**"


def wrapped(page):
    """The page with its paragraphs and list items filled anew, since numbers change their length."""
    return "\n\n".join(block if block.startswith(("|", "#", "!")) else _filled(block)
                       for block in page.strip().split("\n\n")) + "\n"


def _filled(block):
    # What stands in backticks is a command: not to be broken.
    block = re.sub(r"`[^`]*`", lambda code: code.group().replace(" ", "\0"), block)
    items = ("\n" + block).split("\n- ") if block.startswith("- ") else [block]
    bullet, items = ("- ", items[1:]) if len(items) > 1 else ("", items)
    lines = (textwrap.fill(" ".join(item.split()), 120, initial_indent=bullet,
                           subsequent_indent=" " * len(bullet), break_on_hyphens=False,
                           break_long_words=False) for item in items)
    return "\n".join(lines).replace("\0", " ")
