"""The generated numeric modules; `rigidsym codegen TARGET --check` proves them current."""
