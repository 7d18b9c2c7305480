"""Output: the result document, and its forms for people, programs, drawings and pictures."""
