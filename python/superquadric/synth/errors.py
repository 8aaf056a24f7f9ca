"""What can go wrong when a suite is made."""


class SynthError(Exception):
    """A suite that cannot be made; the message says what to do about it."""


class SuiteError(SynthError):
    """A suite file that says what it must not, or does not say what it must."""


class MissingExtraError(SynthError, ImportError):
    """A package of the extra `synth` that cannot be imported."""
