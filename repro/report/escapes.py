"""What a text of a paper, search or file must not do in a file that others open, one function each.

In HTML the templates escape by themselves; for a terminal, `repro.commands.streams` does.
"""

_FORMULAS = ("=", "+", "-", "@", "\t", "\n", "\0")  # OWASP ASVS 5.0, 1.2.10, and CWE-1236


def markdown_text(text: str) -> str:
    """Return a text that opens no tag and makes no link, image or target of one in Markdown."""
    return text.replace("<", "&lt;").replace("](", "]\\(").replace("]:", "]\\:")


def csv_value(value: object) -> object:
    """Return a value that no spreadsheet computes: a text that begins as a formula is quoted.

    A number stays one, its sign too.
    """
    if not isinstance(value, str):
        return value
    text = value.replace("\r", "\n")  # a lone one would end the row
    return f"'{text}" if text.startswith(_FORMULAS) and not _is_number(text) else text


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return text in {"+", "-"}
    return True
