"""`python -m rigidsym` is the `rigidsym` command."""

from rigidsym._cli import main

raise SystemExit(main())
