"""Entry point of `python -m rigidsym`, which runs the `rigidsym` command."""

from rigidsym._cli import main

raise SystemExit(main())
