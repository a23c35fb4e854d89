//! Files as text: the project's own JSON, and foreign formats.
