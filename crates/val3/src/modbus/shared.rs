//! Values that the run and the connections share.

use std::sync::{Mutex, MutexGuard, PoisonError};

use val3_modbus::ModbusImage;

/// Image of the values. Each lock contains one request, or one exchange of the run, so that neither sees a part of the
/// other.
pub(super) struct SharedImage(Mutex<ModbusImage>);

impl SharedImage {
    pub(super) fn new(image: ModbusImage) -> Self {
        Self(Mutex::new(image))
    }

    /// Locks the image. The lock must be short.
    pub(super) fn lock(&self) -> MutexGuard<'_, ModbusImage> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
