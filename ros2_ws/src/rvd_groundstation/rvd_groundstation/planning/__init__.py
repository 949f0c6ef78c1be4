"""
Planners of the ground: optimal trajectories that are computed before, or between, flights.

`problem` says what is to be planned, `transcription` makes a nonlinear programme of it by the Gauss
pseudospectral method and solves it, `plan` is what comes out, `report` checks it. casadi, which
takes a quarter of a second to import, is loaded by `transcription` alone when a solver is built.
"""
