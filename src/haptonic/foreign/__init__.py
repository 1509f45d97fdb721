"""Readers of other programs' files in a separate process, so that a damaged file cannot crash this one.

`haptonic.foreign.process.ask` sends one request to that process; `child` answers it with a function of
`hdf5`, `matlab` or `tdms`. These import little, because the process starts with every command that reads.
"""
