"""The SHA-256 of every file a document rests on, of the very bytes that were read."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


def entry_of(name: str, data: bytes) -> "dict[str, str]":
    """A file's entry in the document, from the bytes read."""
    import hashlib

    return {"name": printable(name), "sha256": hashlib.sha256(data).hexdigest()}


def entry_of_file(name: str) -> "dict[str, str]":
    """A file's entry in the document, read here in blocks: for files that a family reads itself."""
    import hashlib

    with open(name, "rb") as file:
        return {"name": printable(name), "sha256": hashlib.file_digest(file, "sha256").hexdigest()}


def printable(name: str) -> str:
    """A file's name as a document can hold it: bytes that are not UTF-8 are escaped."""
    return name.encode(errors="surrogateescape").decode(errors="backslashreplace")


def once(entries: "Iterable[dict[str, str]]") -> "list[dict[str, str]]":
    """Each file once, in the order first read."""
    return [dict(pairs) for pairs in dict.fromkeys(tuple(entry.items()) for entry in entries)]
