"""Texts as they stand packed in a page, for a script to unpack."""

import gzip
from base64 import b64encode


def packed(text: str) -> str:
    """Return a text as gzip in base 64, a third of its size or less: `unpack.js` unpacks it."""
    return b64encode(gzip.compress(text.encode(), 9, mtime=0)).decode()
