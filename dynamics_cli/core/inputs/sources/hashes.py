"""The SHA-256 of every file a document depends on, of the very bytes that were read."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

# A file larger than this is hashed in its own thread.
LARGE = 1 << 24


def entry_of(name: str, data: bytes) -> "dict[str, str]":
    """A file's entry in the document, from the bytes read."""
    import hashlib

    return {"name": printable(name), "sha256": hashlib.sha256(data).hexdigest()}


def entry_of_file(name: str) -> "dict[str, Any]":
    """A file's entry in the document, read here in blocks: for files that a family reads itself.

    A large file is hashed in parallel with the calculation, which reads it too: `once` waits for its hash.
    """
    import os

    if os.path.getsize(name) < LARGE:
        return {"name": printable(name), "sha256": _digest(name)}
    import hashlib  # noqa: F401  (loaded before the thread starts: meshes fork beside it)
    from concurrent.futures import ThreadPoolExecutor

    with_one = ThreadPoolExecutor(1, "hash")
    digest = with_one.submit(_digest, name)
    with_one.shutdown(wait=False)
    return {"name": printable(name), "sha256": digest}


def _digest(name: str) -> str:
    import hashlib

    with open(name, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def printable(name: str) -> str:
    """A file's name as a document can hold it: bytes that are not UTF-8 are escaped."""
    return name.encode(errors="surrogateescape").decode(errors="backslashreplace")


def once(entries: "Iterable[dict[str, Any]]") -> "list[dict[str, str]]":
    """Each file once, in the order first read, its hash known."""
    hashed = [{key: value if isinstance(value, str) else value.result() for key, value in e.items()} for e in entries]
    return [dict(pairs) for pairs in dict.fromkeys(tuple(entry.items()) for entry in hashed)]
