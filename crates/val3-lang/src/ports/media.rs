//! Files on the media of the controller (6.6, and the file add-on).

/// The media of the controller.
pub trait Media {}
