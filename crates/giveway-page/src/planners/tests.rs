//! Planners on small scenes, by the service itself.
