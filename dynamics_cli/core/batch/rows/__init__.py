"""Rows: a stream of cases read in blocks, answered singly or by arrays to the same bits, and written."""
