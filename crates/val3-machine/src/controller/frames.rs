//! Placements of frames, and the unit of their lengths.

use val3_geometry::IsometryMatrix3;
use val3_lang::call::FrameRef;
use val3_lang::references;
use val3_lang::types::{BaseType, LengthUnit};

use super::Controller;

impl Controller {
    /// Current placement of a frame in `world`, in mm, by name: `fPallet`, `fPallets[2]`, `library:fPallet`. `None` if
    /// the frame does not exist or has no father.
    #[must_use]
    pub fn frame_in_world(&self, name: &str) -> Option<IsometryMatrix3<f64>> {
        let (place, _) = self.variable(name).filter(|(_, base)| *base == BaseType::Frame)?;
        let way = references::of_frame(&self.vm.space.memory, FrameRef(place)).ok()?;
        Some(references::in_millimetres(&way, self.length_unit()))
    }

    /// Length unit of the application, in which it uses the data of its libraries, too.
    #[must_use]
    pub fn length_unit(&self) -> LengthUnit {
        let application = self.vm.space.instance(self.application);
        application.map(|application| application.image.unit).unwrap_or_default()
    }
}
