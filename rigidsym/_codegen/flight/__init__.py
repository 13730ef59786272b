"""Flight profile of C: code in short functions for flight software, with unit tests and checks.

* `program`, `printer`, `module`.  Input: the formulas of a derivation.  Output: a C source and its
  interface, by the rules of MISRA C:2012.
* `read_back`.  Input: the source.  Output: the number of functions that equal their routines.
* `vectors`, `driver`.  Output: reference vectors, correctly rounded, and the C program of tests.
* `trace`, `records`.  Output: requirements with theorems, functions and tests; deviations.
* `profile`.  Output: the texts of all files.
* `report`, which is one of these files, runs the checks.
"""
