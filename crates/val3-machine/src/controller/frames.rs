//! Placements of frames.

use val3_geometry::{IsometryMatrix3, chain};
use val3_lang::call::FrameRef;
use val3_lang::references;
use val3_lang::types::BaseType;

use super::Controller;

impl Controller {
    /// Current placement of a frame in `world`, by name: `fPallet`, `fPallets[2]`, `library:fPallet`. `None` if the
    /// frame does not exist or has no father.
    #[must_use]
    pub fn frame_in_world(&self, name: &str) -> Option<IsometryMatrix3<f64>> {
        let (place, _) = self.variable(name).filter(|(_, base)| *base == BaseType::Frame)?;
        let way = references::of_frame(&self.vm.space.memory, FrameRef(place)).ok()?;
        Some(chain::resolve(&way))
    }
}
