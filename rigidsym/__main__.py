"""`python -m rigidsym` is the `rigidsym` command."""

from rigidsym.cli import main

raise SystemExit(main())
