"""Rust as a target: a crate without dependencies, and without the standard library."""
