"""Rows: how a stream of cases is read in blocks, answered one by one or by arrays, and written, to the same bits."""
