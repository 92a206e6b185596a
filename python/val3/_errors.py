"""Errors of this package."""

import builtins
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._answers import Finding


class Error(Exception):
    """The command has not done what was asked."""


class UsageError(Error):
    """The arguments are wrong, or a file cannot be read. The text is that of the command, with its help."""


class RefusedError(Error):
    """The application has errors, so that no controller starts it."""

    def __init__(self, text: str, findings: "Sequence[Finding]") -> None:
        super().__init__(text)
        self.findings = tuple(findings)
        """The errors."""


class RunError(Error):
    """A run has failed. The text is that of the command."""


class TimeoutError(Error, builtins.TimeoutError):
    """The command has taken longer than permitted, and was ended."""
